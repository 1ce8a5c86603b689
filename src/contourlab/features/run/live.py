"""The runs of a report as WebAssembly modules, so that its page can change their parameters and run them again."""

from __future__ import annotations

import math
import re
import shlex
import zlib
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from contourlab.app.command_line import as_typed, without_options
from contourlab.errors import ContourlabError, EngineError, refuse
from contourlab.features.run.outcome import Outcome
from contourlab.feed import Reference
from contourlab.geometry import Path
from contourlab.geometry.view import view_of
from contourlab.loop import Controller, Machine
from contourlab.loop.feeding import SOURCE_LINE
from contourlab.loop.portable import PortableLoop, portable
from contourlab.loop.simulate import ToolPosition
from contourlab.rendering.charts import LiveLoop, LiveMotion, LiveParameter, LivePath, LiveRun, Words
from contourlab.scenario.dump import controller_table
from contourlab.scenario.toml_text import Noted, toml
from contourlab.units import from_si

MOST_TICKS, MOST_CURVES, MOST_RUNS, MOST_BYTES = 400_000, 5000, 4, 300_000
"""Samples and curves of a motion (a run of 65,000 samples takes a browser some 40 ms), runs, and compressed bytes of all runs together."""
BEFORE, SHORT = 0.5, 1.0
"""Time before the worst place at which a short run begins, and its duration [s]."""
FINE = 0.01
"""Share of a view's tolerance for arcs, as in the judge."""
_GAINS = r"\.controller\.(?!model_)\w*(gain|integral_\w+)$|coupling\.\w*(gain|weight)$"
_FIRST = re.compile(_GAINS + r"|observer\.bandwidth$|friction\.(coulomb|breakaway|viscous)$|backlash")


def live_loop(outcomes: Sequence[Outcome], command: str) -> LiveLoop:
    """Return the runs of a report as modules; for each that has none the reason. `command` is that of the report, as typed."""
    runs, refused, left = list[LiveRun](), list[tuple[str, str]](), float(MOST_BYTES)
    seen = set[bytes]()
    for outcome in outcomes:
        try:
            refuse(len(runs) >= MOST_RUNS, EngineError, f"a page runs {MOST_RUNS} at most")
            run = _run(outcome)
            arrays = {array.tobytes() for array in _arrays(run)} - seen
            needed = sum(len(zlib.compress(array, 1)) for array in arrays)
            refuse(needed > left, EngineError, "its data would make the page too large")
        except ContourlabError as error:
            refused.append((outcome.name, str(error)))
            continue
        runs.append(run)
        left -= needed
        seen |= arrays
    _, verb, *words = shlex.split(command) if command else ("", "")
    again = as_typed(["contourlab", verb, *without_options(words, "--out")]) if verb == "run" else ""
    return LiveLoop("live", "Try other values", _caption(runs, refused), tuple(runs), again, tuple(refused))


def _caption(runs: Sequence[LiveRun], refused: Sequence[tuple[str, str]]) -> str:
    """Return what a page can run, from where the short runs begin, and what it cannot run."""
    begins = "; ".join(f"{run.name} {run.short[0] * run.motion.period:.3f} s" for run in runs)
    about = f"The loop runs in this page. A short run begins {BEFORE} s before the worst place: {begins}. Then the whole part follows. "
    about += "Its largest error is within 0.1 um of that of contourlab run; by some um where it depends on when an axis leaves stiction. "
    return (about if runs else "") + " ".join(f"{name} cannot be changed here: {why}." for name, why in refused)


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
    position, (contour,), (part,), (foot,) = (loop.signals[name] for name in ("axis_position", "contour_error", "part_error", "foot"))
    return LiveRun(
        outcome.name,
        np.frombuffer(loop.code, dtype=np.uint8),
        loop.n_word,
        tuple(_words(loop)),
        _motion(reference),
        loop.inputs["reference"][0],
        loop.feed.ahead if "reference_ahead" in loop.inputs else (),
        loop.log,
        len(loop.rows),
        position,
        contour,
        part,
        foot,
        loop.signals["doubt"],
        _path(reference.programmed),
        judged.ranges,
        tuple(loop.figures.items()),
        loop.failed_at,
        loop.state,
        tuple(_parameter(loop, name) for name in loop.parameters),
        tuple(loop.fixed.items()),
        (start, min(start + round(SHORT * per_second), reference.n_sample)),
        _controller_file(case.machine, case.controller, loop),
    )


def _words(loop: PortableLoop) -> list[Words]:
    """Return what memory holds before the first tick: the rows, then each table by itself, as runs share tables."""
    edges = sorted({loop.first, *(begin for begin, _ in loop.tables.values()), loop.first + loop.start.size})
    words = [Words(begin, loop.start[begin - loop.first : end - loop.first]) for begin, end in pairwise(edges)]
    lines = loop.inputs.get(SOURCE_LINE, ())
    return words + ([Words(at, loop.fed()[(at - loop.inputs["reference"][0]) // loop.feed.reference.n_sample]) for at in lines])


def _motion(reference: Reference) -> LiveMotion:
    profile = reference.profile
    assert profile is not None
    spans = np.array([profile.t0, profile.s0, profile.v0, profile.a0, profile.j])
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
            table[last] = Noted({**value, "value": f"@{name}@"} if isinstance(value, dict) else f"@{name}@")
    return toml(content)


def _arrays(run: LiveRun) -> list[Any]:
    paths = (run.motion.path, run.asked)
    return [
        run.code,
        run.motion.spans,
        *(part.values for part in run.words),
        *(a for path in paths for a in (path.start, path.coefficients)),
    ]
