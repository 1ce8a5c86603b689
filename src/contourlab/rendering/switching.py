"""Switches between controllers: lines of text, tables, and strips over time and along the path."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby
from operator import attrgetter

import numpy as np

from contourlab.arrays import Array
from contourlab.figures import figure
from contourlab.loop.switches import Switches
from contourlab.rendering.charts import Chart, Curve, Panel
from contourlab.rendering.data import JudgedRun, ReportData
from contourlab.rendering.samples import signal
from contourlab.rendering.style import REFERENCE, scheme_style

LISTED = 100
"""Most switches that a report lists."""
KINDS = 6
"""Most kinds of switches in a line of text."""
NARROWEST = 1.0 / 1500.0
"""Least visible share of the picture's width."""
LANE, BAR = 0.2, 6.0


@dataclass(frozen=True)
class SwitchTable:
    """The switches of one scheme.

    Parameters
    ----------
    rows : tuple
        Axis, change, reason, number, share of time of the new controller, first time, its line.
    listed : tuple
        The first `LISTED` of them: time, sample, axis, change, reason, arc length, line.
    """

    name: str
    count: int
    rows: tuple[tuple[str, ...], ...]
    listed: tuple[tuple[str, ...], ...]

    @property
    def left_out(self) -> int:
        """Number of switches that are not listed."""
        return self.count - len(self.listed)


def switch_lines(data: ReportData) -> list[str]:
    """Return an ASCII line for each axis with several controllers: number of switches and reasons."""
    known = ((scheme.name, scheme.switches) for scheme in data.schemes if scheme.switches is not None)
    return [f"{name}: {axis}: {_in_words(switches, axis)}" for name, switches in known for axis in switches.axes]


def _in_words(switches: Switches, axis: str) -> str:
    counts, first = {kind: count for kind, count in switches.counts().items() if kind.axis == axis}, switches.first[axis]
    total = sum(counts.values())
    if not total:
        return f"no switch, {first} is always active"
    change = attrgetter("before", "after")
    shown = sorted(list(counts)[:KINDS], key=change)
    parts = [
        f"{before} -> {after} " + ", ".join(f"{counts[kind]} ({kind.reason})" for kind in group)
        for (before, after), group in groupby(shown, key=change)
    ]
    rest = total - sum(counts[kind] for kind in shown)
    return f"{total} switch{'es' if total > 1 else ''}: {'; '.join(parts)}" + (f"; others {rest}" if rest else "")


def switch_tables(data: ReportData) -> tuple[SwitchTable, ...]:
    """Return one table for each scheme with a supervisor."""
    return tuple(_table(scheme.name, scheme.switches) for scheme in data.schemes if scheme.switches is not None)


def _table(name: str, switches: Switches) -> SwitchTable:
    first = {switches.kinds[k]: int(i) for k, i in zip(*np.unique(switches.kind, return_index=True), strict=True)}
    rows = []
    for kind, count in sorted(switches.counts().items(), key=lambda item: (switches.axes.index(item[0].axis), -item[1])):
        held = switches.active[kind.axis]
        share = f"{100.0 * held.get(kind.after, 0) / max(sum(held.values()), 1):.1f} %"
        time, line = figure(float(switches.time[first[kind]]), "s", 6), int(switches.line[first[kind]])
        rows.append((kind.axis, f"{kind.before} → {kind.after}", kind.reason, str(count), share, time, str(line or "")))
    rows += [(axis, f"{switches.first[axis]} always", "", "0", "100.0 %", "", "") for axis in switches.axes if not switches.of(axis).size]
    listed = []
    for row in switches.rows(LISTED):
        place = figure(row.arc_length, "mm", 6) if np.isfinite(row.arc_length) else ""
        change = f"{row.before} → {row.after}"
        listed.append((figure(row.time, "s", 6), str(row.sample), row.axis, change, row.reason, place, str(row.line or "")))
    return SwitchTable(name, len(switches), tuple(rows), tuple(listed))


def strip_charts(data: ReportData) -> tuple[Chart, ...]:
    """Return the active controllers of every scheme with a supervisor, over time and along the path."""
    led = [scheme for scheme in data.schemes if scheme.switches is not None]
    if not led:
        return ()
    names = list(dict.fromkeys(name for scheme in led for name in _names(scheme)))
    looks = {name: scheme_style(i, len(names))[0] for i, name in enumerate(names[1:])} | {names[0]: REFERENCE}
    height = 46 + max(40 * len(scheme.switches.axes) for scheme in led if scheme.switches is not None)
    how = "Very short segments are drawn longer to remain visible."
    over_time = tuple(_panel(scheme, looks, "time [s]") for scheme in led)
    charts = [Chart("active-time", "Active controller over time", how, over_time, panel_height=height)]
    if all("arc_length" in scheme.result for scheme in led):
        along = tuple(_panel(scheme, looks, "arc length [mm]") for scheme in led)
        charts.append(Chart("active-arc", "Active controller along the path", how, along, panel_height=height))
    return tuple(charts)


def _names(scheme: JudgedRun) -> list[str]:
    """Return the names of a scheme's controllers, the initially active one first."""
    assert scheme.switches is not None
    held = [name for axis in scheme.switches.axes for name in scheme.switches.active[axis]]
    return list(dict.fromkeys([*scheme.switches.first.values(), *held, *(kind.after for kind in scheme.switches.kinds)]))


def _panel(scheme: JudgedRun, looks: dict[str, str], label: str) -> Panel:
    """Return the strip of one scheme: a row for each axis with a lane for each controller."""
    switches, result = scheme.switches, scheme.result
    assert switches is not None
    if label.startswith("time"):
        at, ends = switches.time, (result.start * result.servo_period, (result.start + result.n_sample) * result.servo_period)
    else:
        along = signal(result, "arc_length")
        at, ends = switches.arc_length * 1e3, (float(along[0]) * 1e3, float(along[-1]) * 1e3)
    lanes = _names(scheme)
    lane_of = np.array([lanes.index(kind.after) for kind in switches.kinds], dtype=np.int64)
    curves = []
    for row, axis in enumerate(switches.axes):
        own = switches.of(axis)
        after = lane_of[switches.kind[own]]
        active = np.append(lanes.index(switches.first[axis]), after)
        edges = np.concatenate([[ends[0]], at[own], [ends[1]]])
        for lane, name in enumerate(lanes):
            x = _bars(edges[:-1][active == lane], edges[1:][active == lane], NARROWEST * (ends[1] - ends[0]))
            height = -float(row) + LANE * (lane - 0.5 * (len(lanes) - 1))
            if x.size:
                curves.append(Curve(x, np.where(np.isfinite(x), height, np.nan), name, looks[name], "solid", BAR))
    ticks = tuple((-float(row), axis) for row, axis in enumerate(switches.axes))
    reach = 0.5 + 0.5 * LANE * (len(lanes) - 1)
    return Panel(label, scheme.name, tuple(curves), y_range=(-float(len(ticks) - 1) - reach, reach), y_ticks=ticks)


def _bars(starts: Array, ends: Array, narrowest: float) -> Array:
    """Return bars as a line with gaps: start, end, nan, start ...; indistinguishable bars are merged."""
    if not starts.size:
        return starts
    ends = np.maximum.accumulate(np.maximum(ends, starts + narrowest))
    apart = np.append(True, starts[1:] - ends[:-1] > narrowest)
    last = np.append(np.flatnonzero(apart)[1:] - 1, starts.size - 1)
    return np.column_stack([starts[apart], ends[last], np.full(last.size, np.nan)]).ravel()[:-1]
