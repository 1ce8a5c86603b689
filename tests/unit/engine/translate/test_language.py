"""The scalar language: what a step may use, what is refused with its line, and what the graph looks like."""

from __future__ import annotations

import enum
import importlib.util
import math
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from each import each
from hypothesis import example, given
from hypothesis import strategies as st
from translated_group import in_machine_code

from contourlab.engine.step import Port, Step
from contourlab.engine.translate import graph
from contourlab.engine.translate.step_graph import graph_of
from contourlab.errors import EngineError
from contourlab.primitives import clip, copysign, dot, exp, fabs, floor, lookup, maximum, minimum, rint, select, sqrt

FLOATS = st.floats(allow_nan=True, allow_infinity=True, width=64)


def step_of(function: Callable[[float, float], float]) -> Step:
    """Return a step that computes one number of two inputs."""
    return Step("made", lambda par, x, inp, clock: ((), (function(inp.a, inp.b),)), inputs=(Port("a"), Port("b")), outputs=(Port("y"),))


def compiled(function: Callable[[float, float], float]) -> Callable[[float, float], float]:
    native = in_machine_code(graph_of(step_of(function)))

    def run(a: float, b: float) -> float:
        inputs, out = np.array([a, b]), np.empty(1)
        native(None, None, None, None, inputs.ctypes.data, 0, 0.0, 0.0, 1e-3, None, out.ctypes.data)
        return float(out[0])

    return run


def bits(value: float) -> bytes:
    return b"nan" if math.isnan(value) else struct.pack("<d", value)


def early(a: float, b: float) -> float:
    if a > b:
        return a - b
    if a == b:
        return 0.0
    difference = b - a
    return difference * difference


def counted(a: float, b: float) -> float:
    total, i = 0.0, 0.0
    while i < 5.0 and total < b:
        total += fabs(a)
        i += 1.0
    return total - i


def bisected(a: float, b: float) -> float:
    low, high = 0.0, 1.0 + fabs(a)
    for _ in range(60):
        middle = 0.5 * (low + high)
        if middle * middle > fabs(a):
            high = middle
        else:
            low = middle
        if high - low <= 1e-9:
            break
    return high


def indexed(a: float, b: float) -> float:
    total = 0.0
    for i in range(2, 40, 3):
        if total > b:
            break
        total += i * a
    return total


def tuples(a: float, b: float) -> float:
    pair, third = ((a, b), 1.0) if a < b else ((b, a), 2.0)
    (low, high), *rest = pair, third
    one, other = tuple(v for v in (a, b) if True)
    return high - low + rest[0] + (one + other)


def rounding(a: float, b: float) -> float:
    return floor(a) + rint(b) + copysign(0.0, rint(a)) + minimum(a, b) - maximum(a, b) + clip(a, -1.0, 1.0)


def mixed(a: float, b: float) -> float:
    return select((a > 0.0 and not b > 0.0) or a == b, sqrt(fabs(a)), exp(-fabs(b))) if -1.0 < a <= 8.0 else -(a * 1.0 - 0.0)


def operands(a: float, b: float) -> float:
    return (a or 3.0) + (b and 2.0) + ((a > b and a) or b) + (floor(a) in (0.0, 1.0, b)) + floor(x=b)


def late(a: float, b: float) -> float:
    k, y = 1.0, 0.0

    def scaled(v: float) -> float:
        return k * v

    if a > 0.0:
        k = 2.0
        y = scaled(b)
    for _ in range(6):
        k = k + 1.0
        y = y + scaled(a)
    for i in range(10):  # noqa: B007  its last value is used
        y = 0.5 * y
    return y + scaled(b) + i


FACTOR = {"factor": 3.5}


def averaged(a: float, b: float) -> float:
    pair, steps = (a, b), 0.0
    for _ in range(9):
        pair, steps = (0.5 * (pair[0] + pair[1]), pair[0]), steps + 1.0
    return pair[0] + pair[1] + steps


def growing(a: float, b: float) -> float:
    every: tuple[float, ...] = (a,)
    for _ in range(9):
        every = (*every, 0.5 * every[-1] + b)
    return dot(every, every)


def weighted(a: float, b: float = 2.0, *more: float, factor: float = 3.0) -> float:
    total = factor * (a + b)
    for one in more:
        total += one
    return total


def called(a: float, b: float) -> float:
    def inner(x: float, y: float = a, *, z: float = 4.0) -> float:
        return x - y * z

    return weighted(a) + weighted(a, b, a, b) + weighted(b=a, a=b, factor=0.5) + weighted(a, **FACTOR) + inner(b) + inner(a, z=b)


SAME = [early, counted, bisected, indexed, tuples, rounding, mixed, averaged, growing, called, operands, late]


@each("function", SAME)
def test_a_function_computes_the_same_bits(function: Callable[[float, float], float]) -> None:
    native = compiled(function)

    @given(FLOATS, FLOATS)
    @example(0.0, -0.0)
    @example(-0.3, 0.5)
    @example(2.0, 1.0)
    def agrees(a: float, b: float) -> None:
        assert bits(native(a, b)) == bits(function(a, b))

    agrees()


def test_a_division_by_zero_is_the_only_difference() -> None:
    """Python raises; machine code returns infinity, as every number of a loop that diverges."""
    assert compiled(lambda a, b: a / b)(1.0, 0.0) == math.inf


def endless(a: float, b: float) -> float:
    return endless(a - 1.0, b)


def half_set(a: float, b: float) -> float:
    if a > 0.0:
        c = a
    return c


def refusing(a: float, b: float) -> float:
    raise ValueError(a)


def doubling(a: float, b: float, depth: int = 30) -> float:
    if a > b:
        return doubling(a + b, b, depth - 1) if depth else a
    return doubling(a - b, b, depth - 1) if depth else b


KEPT = [0.0]


def talking(a: float, b: float) -> float:
    print(a)  # noqa: T201
    return b


def hoarding(a: float, b: float) -> float:
    KEPT[0] = a
    return b


def collecting(a: float, b: float) -> float:
    KEPT[0] += a
    return b


@pytest.mark.parametrize(
    ("function", "line", "reason"),
    [
        (lambda a, b: (1.0, 2.0)[int(a)], 0, "use lookup"),
        (lambda a, b: math.gamma(a), 0, "gamma"),
        (lambda a, b: (a, b) if a > b else a, 0, "different kinds"),
        (endless, 0, "calls itself"),
        (half_set, 3, "c may have no value"),
        (refusing, 1, "cannot use raise"),
        (lambda a, b: [a, b][0], 0, "a list: use a tuple"),
        (lambda a, b: tuple([v for v in (a, b)])[0], 0, "a list: use a tuple"),  # noqa: C416, RUF015
        (lambda a, b: float(f"{a}"), 0, "an f-string"),
        (lambda a, b: nowhere, 0, "no name 'nowhere'"),  # type: ignore[name-defined]  # noqa: F821
        (talking, 1, "print(a)"),
        (hoarding, 1, "KEPT[0]"),
        (collecting, 1, "KEPT[0]"),
        (lambda a, b: float(len(range(a))), 0, "a fixed range"),  # type: ignore[arg-type]
        (lambda a, b: a + "b", 0, "a number is needed"),
        (lambda a, b: weighted(a, b, width=1.0), 0, "width"),
        (lambda a, b: half_set(a), 0, "'b'"),
        (lambda a, b: half_set(a, b, a), 0, "too many"),
        (lambda a, b: floor(a, b), 0, "too many"),
        (lambda a, b: 1.0 if (a > b) is True else a, 0, "is of"),
        (lambda a, b: 1.0 if (a, b) == (1.0, b) else a, 0, "eq of"),
        (lambda a, b: a << 2, 0, "l shift"),  # type: ignore[operator]
        (doubling, 2, "more than"),
    ],
)
def test_what_cannot_be_translated_is_refused_with_its_line(function: Any, line: int, reason: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(graph, "LARGEST", 1000)
    with pytest.raises(EngineError) as refusal:
        graph_of(step_of(function))
    where, _, message = str(refusal.value).partition(": ")
    assert where == f"{__file__}:{function.__code__.co_firstlineno + line}"
    assert reason in message


@pytest.mark.parametrize(
    ("returned", "reason"),
    [
        (None, "nothing"),
        (1.0, "a number: end with"),
        ("full", "'full'"),
        ((1.0,), "a tuple of 1"),
        ((1.0, (1.0,)), "a number as its states"),
        (((1.0,), 1.0), "a number as its outputs"),
        (((), (1.0,)), "0 states, but declares 1: kept"),
        (((1.0,), (1.0, 2.0)), "2 outputs, but declares 1: y"),
        (((1.0,), ((1.0, 2.0),)), "a tuple of 2 for output y"),
        (((1.0,), ("full",)), "not 'full'"),
    ],
)
def test_a_result_that_does_not_fit_the_ports_is_refused(returned: Any, reason: str) -> None:
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return returned

    with pytest.raises(EngineError) as refusal:
        graph_of(Step("made", step, states=(Port("kept"),), outputs=(Port("y"),)))
    assert (refusal.value.file, refusal.value.line) == (__file__, step.__code__.co_firstlineno)
    assert reason in str(refusal.value)


def test_what_decides_is_computed_first() -> None:
    """An index outside of a table must not be read where Python does not read it."""

    def found(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        i = 1e15 if inp.a > 0.0 else 1.0
        inside = i < 4.0 and lookup(par.table, i) > 0.5
        while i < 4.0 and lookup(par.table, i) < 2.5:
            i = i + 1.0
        return (), (i if inside else -i,)

    step = Step("made", found, tables=("table",), inputs=(Port("a"),), outputs=(Port("y"),))
    native, table = in_machine_code(graph_of(step)), np.arange(4.0)
    for a, wanted in ((1.0, -1e15), (-1.0, 3.0)):
        tables, inputs, out = np.array([table.ctypes.data, 4]), np.array([a]), np.empty(1)
        native(None, tables.ctypes.data, None, None, inputs.ctypes.data, 0, 0.0, 0.0, 1e-3, None, out.ctypes.data)
        assert out[0] == wanted


def test_two_lambdas_in_one_line_are_told_apart() -> None:
    first, second = (lambda a, b: a - b), (lambda a, b: b - a)
    assert (compiled(first)(3.0, 1.0), compiled(second)(3.0, 1.0)) == (2.0, -2.0)


def kinds(function: Callable[[float, float], float], contract: bool) -> list[str]:
    return [op.kind for op in graph_of(step_of(function), contract=contract).graph.top.every()]


def test_products_are_contracted_on_request_only() -> None:
    def product_sum(a: float, b: float) -> float:
        return a * b + a - b * b

    assert kinds(product_sum, False).count("fma") == 0
    assert kinds(product_sum, True).count("fma") == 2


def test_a_long_loop_is_not_written_out() -> None:
    def counted_to(n: int) -> Callable[[float, float], float]:
        def repeated(a: float, b: float) -> float:
            for _ in range(n):
                a = a * b + 1.0
            return a

        return repeated

    assert kinds(counted_to(20), False) == kinds(counted_to(2000), False)
    assert kinds(counted_to(3), False).count("fmul") == 3


def test_what_is_known_is_computed_now() -> None:
    def known(a: float, b: float) -> float:
        weights = tuple(1.0 / (1.0 + i) for i in range(4))
        return dot(weights, weights) * a if len(weights) == 4 else b

    assert sorted(set(kinds(known, False))) == ["constant", "fmul", "input"]


def test_a_long_loop_stays_a_loop() -> None:
    assert len(kinds(bisected, False)) < 60
    assert kinds(bisected, False).count("loop") == 1


def test_a_file_that_changed_since_its_import_is_refused(tmp_path: Path) -> None:
    """Else machine code of the new text would be filed under the key of the old function."""
    file = tmp_path / "edited.py"
    file.write_text("def value(a, b):\n    return a * 3.0\n")
    spec: Any = importlib.util.spec_from_file_location("edited", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    file.write_text("def value(a, b):\n    return a * 71.0\n")
    with pytest.raises(EngineError, match=r"edited\.py:1: value has changed"):
        graph_of(step_of(module.value))


class Gear(enum.IntEnum):
    LOW = 2


class Ratio(float):
    pass


SINGLE_PRECISION, COUNTED, RATIO = np.float32(2.5), np.int64(3), Ratio(2.0)
CURED = [
    (lambda a, b: a * SINGLE_PRECISION, lambda a, b: a * float(SINGLE_PRECISION), "float(...)"),
    (lambda a, b: minimum(a, COUNTED), lambda a, b: minimum(a, float(COUNTED)), "float(...)"),
    (lambda a, b: a * Gear.LOW, lambda a, b: a * Gear.LOW.value, ".value"),
    (lambda a, b: a if a > Gear.LOW else 2.0 * Gear.LOW, lambda a, b: a if a > Gear.LOW.value else 2.0 * Gear.LOW.value, ".value"),
    (lambda a, b: 2.0 * Gear.LOW, lambda a, b: 2.0 * Gear.LOW.value, ".value"),
    (lambda a, b: a * RATIO, lambda a, b: a * 2.0, "plain float"),
]


@pytest.mark.parametrize(("refused", "cure", "words"), CURED)
def test_an_outer_number_of_another_kind_is_refused_with_its_cure(refused: Any, cure: Any, words: str) -> None:
    with pytest.raises(EngineError) as refusal:
        graph_of(step_of(refused))
    assert (refusal.value.file, refusal.value.line) == (__file__, refused.__code__.co_firstlineno)
    assert words in str(refusal.value)
    assert compiled(cure)(3.0, 1.0) == refused(3.0, 1.0)
