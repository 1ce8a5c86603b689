"""Machine code as users run it, contracted, for one variant and in lanes, where plain Python decides, counts or jumps."""

from __future__ import annotations

import math
import shutil
import subprocess
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from each import each
from translated_group import TranslatedGroup

from contourlab.arrays import Array
from contourlab.components.conformance import PERIOD, subject
from contourlab.components.registry import component
from contourlab.engine.runner import CompiledGroup, InterpretedGroup
from contourlab.engine.step import Node, Port, Schedule, Step
from contourlab.engine.translate import c99
from contourlab.engine.translate.maths import LANES, SINGLE
from contourlab.engine.translate.step_graph import graph_of
from contourlab.primitives import copysign, delayed, exp, fabs, floor, lookup, minimum, rint, select, tanh

WIDTHS = (1, 32)
TABLE = np.arange(16.0)


def schedule_of(function: Callable[..., Any], *, repeat: int = 1, **values: Any) -> Schedule:
    """Return a schedule of a step that computes one number of its inputs a and b and of parameters, a table and the past of a."""

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (function(inp.a, inp.b, par, clock),)

    made = Step("made", step, tuple(values), ("table",), "a", inputs=(Port("a"), Port("b")), outputs=(Port("y"),))
    node = Node("s", made, {"a": "in.a", "b": "in.b"}, values, {"table": TABLE}, ring_length=8, repeat=repeat)
    return Schedule((node,), made.inputs, PERIOD, 1)


def run(schedule: Schedule, fed: Any, width: int, group: type[Any] = CompiledGroup) -> Array:
    """Return the logged output (n_tick, width)."""
    found: Array = group(schedule, width, slice(0, width)).run(np.asarray(fed, dtype=float), [schedule.n_row - 1])[:, 0]
    return found


def bits(values: Any) -> list[str]:
    return [float(value).hex() for value in np.ravel(values)]


def assert_as_in_python(schedule: Schedule, fed: Any) -> None:
    plain = bits(run(schedule, fed, 1, InterpretedGroup))
    for width in WIDTHS:
        assert bits(run(schedule, fed, width)[:, width - 1]) == plain


# --- a quotient stays a quotient


def test_the_rest_of_a_division_of_ticks_is_exact() -> None:
    schedules = [
        schedule_of(lambda a, b, par, clock: clock.k - par.n * floor(clock.k / par.n), n=np.arange(first, first + 32.0))
        for first in range(1, 257, 32)
    ]
    k, n = np.arange(2000)[:, None], np.arange(1, 257)
    found = np.hstack([run(schedule, np.zeros((2000, 2)), 32) for schedule in schedules])
    np.testing.assert_array_equal(found, k % n)


@pytest.mark.parametrize("width", WIDTHS)
def test_an_event_comes_every_49th_tick(width: int) -> None:
    by_parameter = schedule_of(lambda a, b, par, clock: clock.k - par.n * floor(clock.k / par.n) == 0.0, n=49.0)
    by_constant = schedule_of(lambda a, b, par, clock: clock.k - 49.0 * floor(clock.k / 49.0) == 0.0)
    for schedule in (by_parameter, by_constant):
        found = run(schedule, np.zeros((5000, 2)), width)
        np.testing.assert_array_equal(np.flatnonzero(found[:, -1]), np.arange(0, 5000, 49))


@pytest.mark.parametrize("divisor", [0.003, 0.007, 0.01, 0.1])
def test_time_wraps_at_the_ticks_of_plain_python(divisor: float) -> None:
    schedule = schedule_of(lambda a, b, par, clock: floor(clock.t / par.d), d=divisor)
    assert_as_in_python(schedule, np.zeros((3000, 2)))


@pytest.mark.parametrize("width", WIDTHS)
def test_a_table_that_repeats_does_so_at_exact_multiples(width: int) -> None:
    part = component("disturbance", "table")(over="position", beyond="repeat", position_step=0.01, forces=tuple(map(float, range(50))))
    step, values, tables = subject(part)
    schedule = Schedule((Node("part", step, {"position": "in.position"}, values, tables),), step.inputs, PERIOD, 1)
    fed = 0.49 * np.arange(2000.0)[:, None]
    plain = run(schedule, fed, 1, InterpretedGroup)[:, 0]
    np.testing.assert_allclose(run(schedule, fed, width)[:, 0], plain, atol=1e-9)


# --- what decides is rounded as in Python

DECIDING = [
    lambda a, b, par, clock: a * b == par.product,
    lambda a, b, par, clock: a * b - par.product == 0.0,
    lambda a, b, par, clock: 1.0 if minimum(a * b - par.product, 1.0) > 0.0 else 2.0,
    lambda a, b, par, clock: floor(a * b - par.product),
    lambda a, b, par, clock: rint((a * b - par.product) * 1e17),
    lambda a, b, par, clock: lookup(par.table, fabs(floor(a * b - par.product))),
    lambda a, b, par, clock: delayed(par.ring, clock, 2.0 + floor(a * b - par.product)),
    lambda a, b, par, clock: exp(a) if a * b - par.product > 0.0 else lookup(par.table, 1.0),
]


@pytest.mark.parametrize("function", DECIDING)
def test_a_product_that_only_decides_is_rounded_as_in_python(function: Callable[..., Any]) -> None:
    """0.1 * 3.0 rounds to 0.30000000000000004; rounded once with the sum, its distance from there is not 0."""
    schedule = schedule_of(function, product=0.1 * 3.0)
    assert_as_in_python(schedule, [(0.1, 3.0), (3.0, 0.1), (0.2, 1.5)])
    assert not any(op.kind == "fma" for op in graph_of(schedule.nodes[0].step, contract=True).graph.top.every())


def test_a_product_that_is_also_used_is_fused() -> None:
    schedule = schedule_of(lambda a, b, par, clock: (a * b - par.product) * (2.0 if a * b - par.product > 1.0 else 1.0), product=1.0)
    assert any(op.kind == "fma" for op in graph_of(schedule.nodes[0].step, contract=True).graph.top.every())


# --- whole numbers and truth values


def _counted(a: float, b: float, par: Any, clock: Any) -> float:
    n = 0
    while n < 3 and a > n:
        n += 1
    return copysign(1.0, -n)


def _mixed(a: float, b: float, par: Any, clock: Any) -> float:
    y: float = 0
    for _ in range(9):
        y = y * -1 if a > 0.0 else b * y
    return copysign(1.0, -y)


def _from_a_range(a: float, b: float, par: Any, clock: Any) -> float:
    y = 0.0
    for i in range(3, -4, -1):
        if i < a:
            break
        y += copysign(1.0, -i) + copysign(0.5, i * -1)
    return y


def _in_a_branch(a: float, b: float, par: Any, clock: Any) -> float:
    if a > 0.0:
        y: float = exp(b) - exp(b)
    else:
        y = 0
    return copysign(1.0, -y) + copysign(0.25, y * -2)


WHOLE = [
    lambda a, b, par, clock: copysign(1.0, -(a > b)),
    lambda a, b, par, clock: -(a > b),
    lambda a, b, par, clock: copysign(1.0, (a > b) * -1),
    lambda a, b, par, clock: copysign(1.0, -((a > b) - (b > a))),
    lambda a, b, par, clock: copysign(1.0, -(1 if a > b else 0)),
    lambda a, b, par, clock: copysign(1.0, -(a if a > b else 0)),
    lambda a, b, par, clock: copysign(1.0, -select(a > b, 0, 0.0)),
    lambda a, b, par, clock: copysign(1.0, (a > b) * (-1 if b > a else 1)),
    lambda a, b, par, clock: copysign(1.0, -((a > b) * 1.0)),
    lambda a, b, par, clock: copysign(1.0, (a > b) / -1) + copysign(0.25, -float(a > b)),
    _counted,
    _mixed,
    _from_a_range,
    _in_a_branch,
]
SIGNS = [(a, b) for a in (0.0, -0.0, 1.0, -1.0, 2.5) for b in (0.0, -0.0, 1.0, -2.0)]


@each("function", WHOLE)
def test_whole_numbers_have_no_negative_zero(function: Callable[..., Any]) -> None:
    assert_as_in_python(schedule_of(function), SIGNS)


def test_a_whole_number_that_crosses_a_border_is_a_float() -> None:
    def given(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (0,), ((inp.u > 1.0) * 1, -x.n)

    def taken(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (copysign(1.0, -inp.u),)

    first = Node("a", Step("given", given, states=(Port("n"),), inputs=(Port("u"),), outputs=(Port("y"), Port("n"))), {"u": "in.u"})
    second = Node("b", Step("taken", taken, inputs=(Port("u"),), outputs=(Port("y"),)), {"u": "a.y"})
    schedule = Schedule((first, second), (Port("u"),), PERIOD, 2)
    assert_as_in_python(schedule, [(0.0,), (2.0,), (0.0,)])
    assert run(schedule, [(0.0,), (2.0,)], 1)[:, 0].tolist() == [-1.0, -1.0]


# --- a number on one side, a truth value that is computed there on the other


def _assigned(a: float, b: float, par: Any, clock: Any) -> float:
    if a > 0.0:  # noqa: SIM108
        y = exp(b)
    else:
        y = b > 0.5
    return y


def _returned(a: float, b: float, par: Any, clock: Any) -> float:
    if a > 0.0:
        return exp(b)
    return b > 0.5


SIDES = [
    lambda a, b, par, clock: exp(a) if a < -1.0 else a < -0.5,
    lambda a, b, par, clock: lookup(par.table, 1.0) if a > 0.0 else b > 0.5,
    lambda a, b, par, clock: b > 0.5 if a > 0.0 else delayed(par.ring, clock, 1.0),
    _assigned,
    _returned,
]


@pytest.mark.parametrize("function", SIDES)
def test_the_sides_of_a_branch_may_be_a_number_and_a_truth_value(function: Callable[..., Any]) -> None:
    schedule = schedule_of(function)
    fed = [(-2.0, 0.0), (-0.7, 1.0), (0.0, 0.5), (1.0, 2.0)]
    np.testing.assert_allclose(run(schedule, fed, 32)[:, 3], run(schedule, fed, 1, InterpretedGroup)[:, 0], rtol=1e-15)
    assert bits(run(schedule, fed, 1)) == bits(run(schedule, fed, 1, InterpretedGroup))
    assert c99.source_of(graph_of(schedule.nodes[0].step))


# --- the other forms of a step


@pytest.mark.parametrize("repeat", [1, 2, 3])
def test_nodes_one_by_one_give_the_same_bits_with_substeps(repeat: int) -> None:
    """A product that all sub-steps share, and one that crosses from one to the next."""

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        y = x.c + par.g * inp.u
        return (0.3 * y,), (y + clock.t,)

    made = Step("made", step, ("g",), states=(Port("c"),), inputs=(Port("u"),), outputs=(Port("y"),))
    schedule = Schedule((Node("s", made, {"u": "in.u"}, {"g": 0.7}, repeat=repeat),), (Port("u"),), PERIOD, 1)
    fed = np.random.default_rng(1).normal(size=(200, 1))
    for width, primitives in ((1, SINGLE), (32, LANES)):
        apart = TranslatedGroup(schedule, graph=partial(graph_of, contract=True, primitives=primitives))
        found = run(schedule, fed, width)
        np.testing.assert_array_equal(found[:, :1], apart.run(fed, [schedule.row("s.y")])[:, 0])
    assert (found[:, 0] != run(schedule, fed, 1, InterpretedGroup)[:, 0]).any()  # else nothing is fused


def test_past_values_are_numbers_of_python() -> None:
    def counted(a: float, b: float, par: Any, clock: Any) -> float:
        high = delayed(par.ring, clock, 1.0) > 0.5
        return (high + high) * 1.0 + -high

    assert run(schedule_of(counted), [(1.0, 0.0), (0.0, 0.0), (0.0, 0.0)], 1, InterpretedGroup)[:, 0].tolist() == [0.0, 1.0, 0.0]


@pytest.mark.parametrize("width", WIDTHS)
def test_tanh_keeps_nan(width: int) -> None:
    assert np.isnan(run(schedule_of(lambda a, b, par, clock: tanh(a)), [(math.nan, 0.0)], width)).all()


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
def test_a_step_in_c_has_no_unused_argument(tmp_path: Path) -> None:
    source = tmp_path / "step.c"
    source.write_text(c99.source_of(graph_of(schedule_of(lambda a, b, par, clock: 1.0, unused=2.0).nodes[0].step)))
    subprocess.run(
        ["gcc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-c", "-o", "step.o", source.name], cwd=tmp_path, check=True
    )
