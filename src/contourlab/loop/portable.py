"""A machine under its controller along a reference as a WebAssembly module: loop, judge, and the parameters that can be changed in it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import accumulate
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import Parameter
from contourlab.engine.fused import tick_loop_of
from contourlab.engine.runner import CompiledGroup, memory_rows
from contourlab.engine.step import Schedule, rows
from contourlab.engine.translate.graph import Op
from contourlab.engine.translate.maths import LANES
from contourlab.engine.translate.tracing import KnownError, Trace, Traced
from contourlab.engine.translate.wasm import ROWS, Target, function_source, module_of
from contourlab.errors import EngineError, ParameterError, refuse
from contourlab.feed import Reference
from contourlab.geometry.view import view_of
from contourlab.loop.batch import blends, check_steps, check_substeps, check_together, judged_loop
from contourlab.loop.feeding import Feed
from contourlab.loop.judging import JUDGE, PART, WATCH, all_judged, traced_figures
from contourlab.loop.machine import Controller, Machine
from contourlab.loop.parameters import declared, parameters_of
from contourlab.loop.simulate import check_kinds, sampler
from contourlab.loop.template import Wiring

SIGNALS = ("axis_position", "command")
MOST = 1 << 31
"""Bytes of memory that a module can address."""


@dataclass(frozen=True, eq=False, repr=False)
class PortableLoop:
    """A WebAssembly module that runs a machine under its controller, and what lies where in its memory.

    Places are words of 8 bytes from the beginning of memory. The module imports the memory as ``env.memory`` and exports

    * ``run(first, count)``: run ticks from `first` on, which writes their rows of the log. It does not check that the motion has them;
    * ``prepare()``: compute all constants from the parameters, and the state of rest. It returns 0 if the parameters are beyond their
      bounds or do not fit together;
    * ``judge()``: compute the figures of the ticks so far.

    To run: copy `start` to the word `first`, and the inputs to theirs. After a parameter was changed, call ``prepare``. To begin in the
    middle, then copy the words of `state` of another run.

    Attributes
    ----------
    code : bytes
    first : int
    start : ndarray (n,)
        States, parameters and tables before the first tick.
    n_word : int
        Size of the memory.
    inputs : mapping of str to tuple of int
        For each axis the first of as many words as there are ticks; also of ``arc_length`` and ``feedrate``.
    log : int
        The first word of the log; each tick has a row of it.
    rows : tuple of int
        The signal of `schedule` in each column of the log.
    signals : mapping of str to tuple of int
        Columns of the log for each axis; also of ``contour_error``, ``part_error``, ``foot``, the arc length of the foot point on the
        programmed path [m], and ``doubt``, for each judge: 1 where it is not sure.
    figures : mapping of str to int
        Word of each figure of `contourlab.simulate_batch`, and of ``unsure``, the count of ticks in doubt.
    failed_at : int
        Word of the sample at which the loop ran away, or -1: the figures then mean nothing.
    parameters : mapping of str to tuple of (int, Parameter)
        Word of each value [SI], and its declaration.
    fixed : mapping of str to str
        Parameters that cannot be changed: why.
    tables : mapping of str to tuple of (int, int)
        Word and size of each table.
    state : tuple of (int, int)
        Begin and end of the words that change while ticks run, besides the log.
    """

    code: bytes
    start: Array
    n_word: int
    inputs: Mapping[str, tuple[int, ...]]
    log: int
    rows: tuple[int, ...]
    signals: Mapping[str, tuple[int, ...]]
    figures: Mapping[str, int]
    failed_at: int
    parameters: Mapping[str, tuple[int, Parameter]]
    fixed: Mapping[str, str]
    tables: Mapping[str, tuple[int, int]]
    state: tuple[tuple[int, int], ...]
    schedule: Schedule
    feed: Feed
    first: int = field(default=ROWS, init=False)

    def fed(self) -> Array:
        """Return the inputs (n_input, n_tick), in the order of their words."""
        return np.concatenate([self.feed.block(*samples)[1] for samples in self.feed.reference.blocks()]).T


def portable(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    *,
    signals: Sequence[str] = SIGNALS,
    seed: int = 0,
    moving: bool = False,
) -> PortableLoop:
    """Return a machine under its controller along a reference as a WebAssembly module.

    Parameters
    ----------
    machine : Machine
    controller : Controller
    reference : Reference
    signals : sequence of str
        Signals to log, besides those of the judge.
    seed : int
        Of all noise.
    moving : bool
        Whether the axes start with the velocity of the reference.

    Raises
    ------
    ParameterError
        If there is no such signal.
    EngineError
        If a step uses what cannot be translated, or the motion is too long for the memory of a module.

    Notes
    -----
    It computes what a variant of `contourlab.simulate_batch` computes, but rounds each product before it is added. As there, the judge sees
    true positions of the axes; here it decides ticks in doubt itself.
    """
    check_kinds(machine, controller, reference)
    feed, view = Feed(machine, controller, reference, None, sampler(True)), view_of(reference.path)

    def judged(columns: Mapping[str, Any]) -> Wiring:
        loop = judged_loop(machine, controller, feed, columns, view, seed, moving=moving)
        return replace(loop, schedule=all_judged(loop.schedule))

    loop = judged({})
    schedule, n = loop.schedule, reference.n_sample
    for name in signals:
        refuse(name not in loop.signals, ParameterError, "signals", repr(name), "one of " + ", ".join(loop.signals))
    part = PART if blends(reference) else JUDGE
    kept = {name: loop.signals[name] for name in signals} | {"contour_error": (f"{JUDGE}.contour_error",), "foot": (f"{part}.foot",)}
    kept |= {"part_error": (f"{part}.contour_error",), "doubt": tuple(dict.fromkeys((f"{JUDGE}.doubt", f"{part}.doubt")))}
    columns = list(dict.fromkeys(schedule.row(signal) for wanted in kept.values() for signal in wanted))
    group = CompiledGroup(schedule, 1, slice(0, 1), like_lanes=True)
    prepare, constants, values, fixed = _prepared(machine, controller, judged, len(group.memory))
    states = {node.name: row for node, row in zip(schedule.nodes, group.places.states, strict=True)}
    judge, figures = traced_figures(states, machine.servo_period)
    # What lies one after another: rows, parameters, figures, words that say where tables are, tables, inputs, log.
    sizes, words = [table.size for table in group.tables], np.vstack([group.tables_at, np.zeros((2, 2), dtype=np.int64)])
    n_row, of_figures = len(group.memory), len(group.memory) + len(values)
    of_words = ROWS + of_figures + len(figures)
    *of_tables, of_inputs = accumulate(sizes, initial=of_words + words.size)
    of_log = of_inputs + rows(schedule.externals) * n
    n_word = of_log + len(columns) * n
    refuse(8 * n_word >= MOST, EngineError, f"the motion has {n} samples: too many for the memory of a module")
    words[: len(sizes), 0] = 8 * np.array(of_tables, dtype=np.int64)
    words[-2:] = (8 * of_inputs, n), (8 * of_log, 0)
    start = [group.memory, np.array([*values.values()]), np.zeros(len(figures)), words.view(float), *group.tables]
    target = Target(of_words, len(words) - 2, machine.servo_period)
    functions = {
        "run": tick_loop_of(schedule, group.places, tuple(columns), 1, LANES, target),
        "prepare": target.compiled(function_source("prepare", prepare, constants)),
        "judge": target.compiled(function_source("judge", judge, dict(enumerate(figures.values(), of_figures)))),
    }
    known, edges = parameters_of(machine, controller), list(accumulate(memory_rows(schedule), initial=ROWS))
    named = (f"{node.name}.{name}" for node in schedule.nodes for name in node.step.tables)
    fed = {port.name: range(schedule.row(f"in.{port.name}"), schedule.row(f"in.{port.name}") + port.rows) for port in schedule.externals}
    return PortableLoop(
        code=module_of(functions),
        start=np.concatenate([part.ravel() for part in start]),
        n_word=n_word,
        inputs={name: tuple(of_inputs + n * row for row in range_) for name, range_ in fed.items()},
        log=of_log,
        rows=tuple(columns),
        signals={name: tuple(columns.index(schedule.row(signal)) for signal in wanted) for name, wanted in kept.items()},
        figures={name: ROWS + of_figures + i for i, name in enumerate(figures)},
        failed_at=ROWS + states[WATCH],
        parameters={name: (ROWS + n_row + i, declared(machine, name, *known[name])) for i, name in enumerate(values)},
        fixed=fixed,
        tables=dict(zip(named, zip(of_tables, sizes, strict=True), strict=True)),
        state=((ROWS, edges[len(schedule.nodes) + 1]), (edges[2 * len(schedule.nodes) + 1], edges[-1])),
        schedule=schedule,
        feed=feed,
    )


def _prepared(
    machine: Machine, controller: Controller, judged: Callable[[Mapping[str, Any]], Wiring], first: int
) -> tuple[Trace, dict[int, Op], dict[str, float], dict[str, str]]:
    """Return how the constants of a loop follow from its parameters, by row; the parameters that may change, and why others may not.

    The code that gives a batch its variants runs with numbers that are not known. What needs the value of a parameter keeps it as it is.
    """
    known, fixed = parameters_of(machine, controller), dict[str, str]()
    for name, (part, word) in known.items():
        value = getattr(part, word)
        try:
            check_steps(known, {name: np.array([value, np.nextafter(value, 0.0)])}, len(machine.axes))
        except ParameterError:
            fixed[name] = "it changes the step itself"
    while True:
        values = {name: float(getattr(*known[name])) for name in known if name not in fixed}
        trace = Trace()
        columns: dict[str, Any] = {name: trace.leaf(first + i, value, name) for i, (name, value) in enumerate(values.items())}
        try:
            check_together(known, columns)
            check_substeps(machine, columns)
            begin: dict[int, Any] = judged(columns).schedule.begin[1]
        except KnownError as error:
            fixed |= dict.fromkeys(error.args[1], f"a constant, a check or a length needs {error.args[0]}")
        else:
            for name, column in columns.items():
                _within(known[name][0].parameters[known[name][1]], column)
            return trace, {row: value.op for row, value in begin.items() if isinstance(value, Traced)}, values, fixed


def _within(declared: Parameter, value: Traced) -> None:
    """Make it a condition of the trace that a parameter would take the value."""
    conditions = [value > declared.minimum if declared.exclusive else value >= declared.minimum]
    conditions += [value <= declared.maximum] if declared.maximum < np.inf else []
    conditions += [np.isfinite(value)] if declared.default != np.inf else []
    conditions += [np.rint(value) == value] if declared.whole else []
    for condition in conditions:
        bool(condition)
