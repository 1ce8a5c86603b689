"""The runs of a report as WebAssembly modules, so that its page can change their parameters and run them again."""

from __future__ import annotations

import math
import re
import shlex
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from contourlab.app.command_line import as_typed, without_options
from contourlab.arrays import Array
from contourlab.errors import ContourlabError, EngineError, refuse
from contourlab.features.run.outcome import Outcome
from contourlab.feed import Reference
from contourlab.geometry import Path
from contourlab.geometry.view import view_of
from contourlab.loop import Controller, Machine
from contourlab.loop.feeding import AHEAD, SOURCE_LINE
from contourlab.loop.judging import PLACE
from contourlab.loop.portable import PortableLoop, portable
from contourlab.loop.simulate import ToolPosition
from contourlab.rendering.charts import LiveLoop, LiveMotion, LiveParameter, LivePath, LiveRun
from contourlab.rendering.message import message
from contourlab.scenario.dump import controller_table
from contourlab.scenario.toml_text import Noted, toml
from contourlab.scenario.tree import STATED
from contourlab.units import from_si

MOST_TICKS, MOST_CURVES, MOST_RUNS, MOST_BYTES = 400_000, 1300, 4, 300_000
"""Samples and curves of a motion (a run of 65,000 samples takes a browser some 40 ms), runs, and compressed bytes of all runs together."""
BEFORE, SHORT = 0.5, 1.0
"""Time from the start of a short run to the worst place, and its duration [s]."""
ABOUT = (
    "The loop runs in this page: the second around the worst place, then the whole part. "
    "Figures agree with contourlab run to a fraction of an encoder count; where an axis leaves stiction, to some um."
)
FINE = 0.01
"""Share of a view's tolerance for arcs, as in the judge."""
_GAINS = r"\.controller\.(?!model_)\w*(gain|integral_\w+)$|coupling\.\w*(gain|weight)$"
_FIRST = re.compile(_GAINS + r"|observer\.bandwidth$|friction\.(coulomb|breakaway|viscous)$|backlash")


def live_loop(outcomes: Sequence[Outcome], command: str) -> LiveLoop:
    """Return the runs of a report as modules; for each that has none the reason. `command` is that of the report, as typed."""
    words = shlex.split(command)
    live = LiveLoop("live", "Try other values", "", (), as_typed(without_options(words, "--out")) if words[1:2] == ["run"] else "")
    refused = []
    for outcome in outcomes:
        try:
            refuse(len(live.runs) >= MOST_RUNS, EngineError, f"a page runs {MOST_RUNS} at most")
            longer = replace(live, runs=(*live.runs, _run(outcome)))
            refuse(len(message([longer])) > MOST_BYTES, EngineError, "its data would make the page too large")
            live = longer
        except ContourlabError as error:
            refused.append(f"{outcome.name} cannot be changed here: {error}.")
    return replace(live, caption=" ".join([ABOUT] * bool(live.runs) + refused))


def _run(outcome: Outcome) -> LiveRun:
    case, reference = outcome.case, outcome.reference
    refuse(case.learning is not None, EngineError, "it learns from trial to trial")
    refuse(case.changes, EngineError, "its controller changes on the way")
    refuse(reference.profile is None, EngineError, "its motion was recorded, not planned")
    too_long = reference.n_sample > MOST_TICKS or len(reference.path.breaks) > MOST_CURVES
    refuse(too_long, EngineError, f"{reference.n_sample} samples along {len(reference.path.breaks) - 1} curves are too many for a page")
    refuse(not ToolPosition(case.machine, 0).exact, EngineError, "the errors of the machine's geometry move the tool")
    loop = portable(case.machine, case.controller, reference, signals=("axis_position",), seed=case.run.seed, moving=case.moving)
    judged, size = outcome.metrics.judged, np.abs(outcome.result["part_error"])
    worst, per_second = int(judged.samples[size[judged.samples].argmax()]), 1.0 / reference.servo_period
    start = max(worst - round(BEFORE * per_second), 0)
    return LiveRun(
        outcome.name, np.frombuffer(loop.code, dtype=np.uint8), loop.n_word, tuple(_words(loop)), _motion(reference),
        loop.inputs["reference"][0], loop.feed.ahead if AHEAD in loop.inputs else (), loop.log, len(loop.rows),
        loop.signals["axis_position"], loop.signals["part_error"][0], loop.signals["foot"][0], loop.signals["doubt"][-1],
        *_place(outcome, loop), _path(reference.programmed), judged.ranges, tuple(loop.figures.items()), loop.failed_at, loop.state,
        tuple(_parameter(loop, name) for name in loop.parameters),
        (start, min(start + round(SHORT * per_second), reference.n_sample)), _controller_file(case.machine, case.controller, loop),
    )  # fmt: skip


def _words(loop: PortableLoop) -> list[tuple[int, Array]]:
    """Return what memory holds before the first tick: the rows, then each table by itself, as runs share tables."""
    begin, rows = loop.first, min(at for at, _ in loop.tables.values()) - loop.first
    words = [(begin, loop.start[:rows])]
    for name, (at, size) in loop.tables.items():
        values = loop.start[at - begin : at - begin + size]
        if name.endswith("cell_clearance"):  # one that is too small only makes more ticks doubtful
            mantissa, power = np.frexp(values)
            values = np.ldexp(np.floor(64.0 * mantissa) / 64.0, power)
        if name == f"{PLACE}.place":  # where a search begins
            values = values.astype(np.float32).astype(np.float64)
        words.append((at, values))
    first, n = loop.inputs["reference"][0], loop.feed.reference.n_sample
    return words + [(at, loop.fed()[(at - first) // n]) for at in loop.inputs.get(SOURCE_LINE, ())]


def _place(outcome: Outcome, loop: PortableLoop) -> tuple[int, float]:
    """Return the word of the place of the reference on the programmed path, and how far the reference is from it."""
    place = loop.tables.get(f"{PLACE}.place", loop.inputs["arc_length"])[0]
    return place, float(np.abs(outcome.result["planning_deviation"]).max())


def _motion(reference: Reference) -> LiveMotion:
    profile = reference.profile
    assert profile is not None
    at = np.arange(reference.n_sample) * reference.servo_period
    used = np.unique(np.searchsorted(profile.t0, at, side="right") - 1)  # without a jerk limit, many fall between samples
    spans = np.array([profile.t0, profile.s0, profile.v0, profile.a0, profile.j])[:, used]
    return LiveMotion(reference.servo_period, reference.n_sample, spans, profile.duration, profile.length, _path(reference.path))


def _path(path: Path) -> LivePath:
    tables = view_of(path, arcs=FINE).tables or view_of(path, arcs=FINE, analytic=False).tables
    return LivePath(tables["path_start"], tables["path_coefficients"], path.closed)


def _parameter(loop: PortableLoop, name: str) -> LiveParameter:
    word, about = loop.parameters[name]

    def finite(value: float) -> float | None:
        return float(value) if math.isfinite(value) else None

    value, bounds = loop.start[word - loop.first], (finite(about.minimum), finite(about.maximum))
    shown = about.unit, about.display, float(from_si(1.0, about.display))
    return LiveParameter(name, word, finite(value), *shown, *bounds, about.exclusive, about.whole, bool(_FIRST.search(name)))


def _controller_file(machine: Machine, controller: Controller, loop: PortableLoop) -> str:
    """Return the file of a controller with ``"@NAME@"`` for each value that can change."""
    content: dict[str, Any] = {"controller": controller_table(controller, machine)}
    for name in loop.parameters:
        table: Any = content
        *places, last = name.split(".")
        if places[0] == "controller":
            for place in places:
                table = table[place]
            held = table.get(last, "")
            value = held.value if isinstance(held, Noted) else held
            table[last] = Noted({**value, STATED: f"@{name}@"} if isinstance(value, dict) else f"@{name}@")
    return toml(content)
