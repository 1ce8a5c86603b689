"""Breakaway levels of an axis out of slow ramps of its command."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from contourlab.analysis.identification.stiction import Breakaway, breakaways
from contourlab.errors import ParameterError
from contourlab.features.identify.finding import Drawn, Figure, Finding, Graph, Picture, Row, Tables, assumed, fitted, of_command
from contourlab.features.identify.signals import AxisRecord, fits_a_plant, no_plant, one_unit, source_of, sources_of

EXPLAINED = 60.0
"""Fit [percent] of the first motion below which it is remarked on; below half of it levels cannot be used."""
SPREAD = 0.1
"""Spread over repeats, relative, from which it is remarked on."""


def identify_stiction(records: Sequence[AxisRecord]) -> Finding:
    """Find what an axis at rest has to be given before it moves, each way, with the spread over repeats.

    Parameters
    ----------
    records : sequence of AxisRecord
        With slow ramps of the command from about zero.

    Raises
    ------
    ResultError
        If a log has no command, or the commands are in different units.
    ParameterError
        As of `contourlab.analysis.identification.stiction.breakaways`; of several records, if none tells a breakaway.
    """
    unit = one_unit(records, "one axis")
    found, remarks = [], []
    for record in records:
        try:
            here, said = breakaways(record.time, record.driven(), record.position)
        except ParameterError as error:
            if len(records) == 1:
                raise
            here, said = [], [str(error)]
        found += [replace(one, time=one.time + record.start) for one in here]
        remarks += [f"{record.source}: {words}" for words in said]
    if not found:
        raise ParameterError("LOG", f"{len(records)} records", f"one in which the axis leaves on a ramp; {'; '.join(remarks)}")
    by_way = {name: [one for one in found if one.direction == way] for name, way in (("breakaway+", 1), ("breakaway-", -1))}
    figures = tuple(_figure(name, ones, unit) for name, ones in by_way.items() if ones)
    remarks += _remarks(by_way)
    fit = float(np.mean([one.fit for one in found]))
    if fit < EXPLAINED:
        remarks.append(f"the first motion is explained by {fit:.3g} % only: it is no breakaway from rest, or lost in noise")
    written = fits_a_plant(unit)
    remarks += [] if written else [no_plant(unit)]
    return Finding(
        "stiction",
        records[0].axis,
        sources_of(records),
        figures,
        fit,
        fit > 0.5 * EXPLAINED,
        tuple(remarks),
        _tables(by_way, unit, records) if written and fit > 0.5 * EXPLAINED else {},
        _pictures(by_way, unit, records),
        _lines(found, unit),
        {"ramps": [{"time": b.time, "level": b.level, "deviation": b.deviation, "rate": b.rate, "fit_percent": b.fit} for b in found]},
    )


def _levels(ones: Sequence[Breakaway]) -> np.ndarray:
    return np.abs([one.level for one in ones])


def _spread(ones: Sequence[Breakaway]) -> float:
    """Return the deviation over repeats; of a single ramp that of its instant."""
    return float(_levels(ones).std(ddof=1)) if len(ones) > 1 else ones[0].deviation


def _figure(name: str, ones: Sequence[Breakaway], unit: str) -> Figure:
    levels, spread = _levels(ones), _spread(ones)
    own = math.sqrt(sum(one.deviation**2 for one in ones)) / len(ones)
    return Figure(name, float(levels.mean()), unit, own, max(own, spread / math.sqrt(len(ones))))


def _remarks(by_way: dict[str, list[Breakaway]]) -> list[str]:
    said = []
    for name, ones in by_way.items():
        word = "forwards" if name.endswith("+") else "backwards"
        if not ones:
            said.append(f"no ramp {word}: that breakaway is not told, nor an offset from it")
            continue
        if len(ones) == 1:
            said.append(f"one ramp {word}: how much breakaway differs from place to place and time to time is not told")
        elif _spread(ones) > SPREAD * float(_levels(ones).mean()):
            said.append(f"breakaway {word} differs by {100.0 * _spread(ones) / float(_levels(ones).mean()):.2g} % over {len(ones)} ramps")
    said.append("a ramp tells the friction at rest alone; sliding friction takes runs at constant speed")
    return said


def _lines(found: Sequence[Breakaway], unit: str) -> tuple[str, ...]:
    rows = [f"time [s]  breakaway [{unit}]  deviation  rate [{unit}/s]  fit [%]"]
    rows += [f"{b.time:8.4g}  {b.level:12.5g}  {b.deviation:9.2g}  {b.rate:9.3g}  {b.fit:7.4g}" for b in found]
    return tuple(rows)


def _tables(by_way: dict[str, list[Breakaway]], unit: str, records: Sequence[AxisRecord]) -> Tables:
    ways = [ones for ones in by_way.values() if ones]
    level = float(np.mean([_levels(ones).mean() for ones in ways]))
    spread = float(np.hypot.reduce([_spread(ones) for ones in ways])) / len(ways)
    shown, count = unit or "full_scale", sum(len(ones) for ones in ways)
    told = fitted(source_of(records), spread, f"spread over {count} slow ramps")
    friction: dict[str, Row] = {
        "kind": ("coulomb", "", None),
        "coulomb": (level, shown, assumed("as at rest")),
        "breakaway": (level, shown, told),
    }
    tables: dict[str, dict[str, Row]] = {"friction": friction}
    if len(ways) == 2:
        forward, backward = (float(_levels(ones).mean()) for ones in by_way.values())
        half = fitted(source_of(records), spread, "half the difference of the two directions")
        tables["disturbance"] = {"kind": ("constant", "", None), "force": (0.5 * (backward - forward), shown, half)}
    return tables


def _pictures(by_way: dict[str, list[Breakaway]], unit: str, records: Sequence[AxisRecord]) -> tuple[Picture, ...]:
    axis, first = records[0].axis, records[0]
    points: dict[str, Drawn] = {}
    for name, ones in by_way.items():
        if ones:
            half = np.array([2.0 * one.deviation for one in ones])
            points[name] = np.array([one.time for one in ones]), _levels(ones), half
    level = Graph("time [s]", of_command(unit).replace("command", "breakaway"), points)
    command = Graph("time [s]", of_command(unit), {"command": (first.time, first.driven())})
    moved = Graph("time [s]", "position [mm]", {"position": (first.time, 1e3 * (first.position - first.position[0]))})
    title = f"Breakaway of axis {axis}, two deviations"
    return (Picture("breakaway", title, (level,)), Picture("ramps", f"Ramps of {first.source}", (command, moved)))
