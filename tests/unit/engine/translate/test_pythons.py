"""What engineers write in Python: operators, functions of `math` and `numpy`, ways out of loops. Machine code gives Python's own values."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from each import each
from structured_text import FunctionBlock
from translated_group import in_c, in_machine_code

from contourlab.engine.runner import CompiledGroup
from contourlab.engine.step import Node, Port, Schedule, Step
from contourlab.engine.translate import structured_text
from contourlab.engine.translate.control import Field, control_of
from contourlab.engine.translate.maths import EXACT, LANES
from contourlab.engine.translate.step_graph import graph_of
from contourlab.errors import EngineError
from contourlab.primitives import lookup

Function = Callable[[float, float], Any]
SPECIAL = [0.0, -0.0, 0.5, -0.5, 1.0, -1.0, 1.5, -2.5, 3.0, 1e-300, 1e300, math.inf, -math.inf, math.nan]
PORTS: dict[str, Any] = {"inputs": (Port("a"), Port("b")), "outputs": (Port("y"),)}
LEVELS = (1.0, 2.0, 3.0)

EXPRESSIONS: list[Function] = [
    lambda a, b: a**2 + a**3,
    lambda a, b: a**-1,
    lambda a, b: a**0.5,
    lambda a, b: a**b,
    lambda a, b: pow(a, 2),
    lambda a, b: math.pow(a, b),
    lambda a, b: a % b,
    lambda a, b: a // b,
    lambda a, b: divmod(a, b),
    lambda a, b: math.fmod(a, b),
    lambda a, b: max(a, b),
    lambda a, b: min(a, b, 1.0),
    lambda a, b: max((a, b, 2)),
    lambda a, b: max(-1.0, min(1.0, a)),
    lambda a, b: abs(a) + abs(a > b),
    lambda a, b: (math.floor(a), math.ceil(a), math.trunc(a), int(a), round(a)),
    lambda a, b: (-int(a), int(a) * -1, int(a) % 3, int(a) // 3, int(a) % -7, -(int(a) % 5)),
    lambda a, b: (float(bool(a)), float(any((a > 0.0, b > 0.0))), float(all((a, b > 0.0)))),
    lambda a, b: (math.sqrt(a), math.exp(a)),
    lambda a, b: (math.log(a), math.log(a, 2.0), math.fabs(b)),
    lambda a, b: (lookup(LEVELS, a), lookup((a, 1, b), int(b)), LEVELS[1]),
    lambda a, b: (math.sin(a), math.cos(a), math.tan(a)),
    lambda a, b: (math.tanh(a), math.atan(a), math.atan2(a, b)),
    lambda a, b: (math.asin(a), math.acos(a)),
    lambda a, b: (math.degrees(a), math.radians(b), math.copysign(a, 0.0 if b != b else b)),
    lambda a, b: (float(math.isnan(a)), float(math.isinf(a)), float(math.isfinite(a))),
    lambda a, b: (np.sqrt(a), np.sign(a), np.floor(a), np.ceil(a), np.trunc(a), np.rint(a), np.fabs(a), np.abs(b)),
    lambda a, b: (np.copysign(a, 0.0 if b != b else b), float(np.isnan(a))),
    lambda a, b: np.ceil(int(a)) / 3.0,
    lambda a, b: np.clip(a, -1.0, 1.0) if a != 0.0 else a,
    lambda a, b: (np.minimum(a, b), np.maximum(a, b)) if a != b else (a, b),
    lambda a, b: (1.0 if (a > 0.0) & (b > 0.0) else 0.0) + (2.0 if (a > 0.0) | (b > 0.0) else 0.0),
    lambda a, b: 1.0 if (a > 0.0) ^ (b > 0.0) else 0.0,
    lambda a, b: (y := a + b) * y,
]


def returning(a: float, b: float) -> Any:
    for i in range(5):
        y = b - i
        if a > y:
            return y * b
    return a


def returning_from_a_tuple(a: float, b: float) -> Any:
    for level in LEVELS:
        if a > level:
            return level * b, i_of(level)
    return a, 0.0


def i_of(x: float) -> float:
    return x - 1.0


def returning_from_within(a: float, b: float) -> Any:
    total = 0.0
    for i in range(4):
        k = 0.0
        while k < 3.0:
            k += 1.0
            if total > b:
                return total + k
            if k > a:
                break
            total += a
        else:
            total += 100.0
        if i == 2 and total < a:
            return -total
    return total - a


def continuing(a: float, b: float) -> Any:
    total = 0.0
    for i in range(6):
        if a > i:
            continue
        total += b
        if total > 3.0:
            break
    return total * i


def continuing_while(a: float, b: float) -> Any:
    total = i = 0.0
    while i < 5.0:
        i += 1.0
        if a > i:
            continue
        total += b
    return total


def with_else(a: float, b: float) -> Any:
    for i in range(5):
        if a > i:
            break
    else:
        b = 0.5
    while 7.0 < b < 1e9:
        b *= 0.5
    else:
        b += 1.0
    return b * i


def breaking_a_tuple(a: float, b: float) -> Any:
    total = 0.0
    for i, level in enumerate(LEVELS):  # noqa: B007  its last value is used
        if a > level:
            break
        total += level * b
    return total + i


def indexing(a: float, b: float) -> Any:
    for i in range(3):
        if a > LEVELS[i]:
            return LEVELS[i] * b
    return b


def nested(a: float, b: float) -> Any:
    for i in range(3):
        for j in range(4):
            if i * j > a:
                return i - j * b
            if j > b:
                continue
    else:
        return 7.0
    return 8.0


def returning_from_else(a: float, b: float) -> Any:
    for level in LEVELS:
        b += level * a
    else:
        if LEVELS[0] > 0.0:
            if a > 0.0:
                return b
            a += 1.0
        else:
            return a
        return a - b


def breaking_within(a: float, b: float) -> Any:
    for i in range(1, 7, 2):
        for level in LEVELS:
            if LEVELS[0] > 0.0:
                b += i * a
                break
            b += level
    else:
        return b
    return a


def endless(a: float, b: float) -> Any:
    n = 0
    while True:
        n += 1
        while True:
            b += 1.0
            if not -20.0 < b < 3.0:
                break
        if n > 7 or not n < a:
            return n * b


def augmented(a: float, b: float) -> Any:
    a **= 2
    b %= 3.0
    return a // 2.0 - b


BODIES: list[Function] = [
    returning,
    returning_from_a_tuple,
    returning_from_within,
    continuing,
    continuing_while,
    with_else,
    breaking_a_tuple,
    indexing,
    nested,
    returning_from_else,
    breaking_within,
    endless,
    augmented,
]


def values(function: Function, a: float, b: float) -> list[float] | None:
    """Return what Python gives, or None where it raises or leaves the real numbers."""
    with np.errstate(all="ignore"):
        try:
            found = function(a, b)
        except (ArithmeticError, ValueError, OverflowError):
            return None
    each_value = found if isinstance(found, tuple) else (found,)
    return None if any(isinstance(value, complex) for value in each_value) else [float(value) for value in each_value]


def step_of(function: Function) -> Step:
    names = [f"y{i}" for i in range(len(next(found for found in (values(function, a, 0.7) for a in (0.3, 2.0)) if found)))]

    def one(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (function(inp.a, inp.b),)

    def several(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), function(inp.a, inp.b)

    step = several if isinstance(function(0.3, 0.7), tuple) else one
    return Step("made", step, inputs=(Port("a"), Port("b")), outputs=tuple(map(Port, names)))


def compiled(step: Step, primitives: Any = EXACT, make: Any = in_machine_code) -> Callable[[float, float], list[float]]:
    native = make(graph_of(step, primitives=primitives))

    def run(a: float, b: float) -> list[float]:
        inputs, out = np.array([a, b]), np.empty(len(step.outputs))
        native(0, 0, 0, 0, inputs.ctypes.data, 0, 0.0, 0.0, 1e-3, 0, out.ctypes.data)
        return [float(value) for value in out]

    return run


def pairs(seed: int = 1) -> list[tuple[float, float]]:
    draw = random.Random(seed)
    some = [(draw.gauss(0.0, 3.0), draw.gauss(0.0, 3.0)) for _ in range(300)]
    some += [(draw.choice([-1, 1]) * 10.0 ** draw.uniform(-9, 9), 10.0 ** draw.uniform(-6, 6)) for _ in range(200)]
    return [*some, *((float(a), float(b)) for a in range(-8, 9) for b in (-3, 1, 2, 5)), *((a, b) for a in SPECIAL for b in SPECIAL)]


@each("function", [*EXPRESSIONS, *BODIES])
def test_machine_code_gives_the_bits_of_python(function: Function) -> None:
    run, compared = compiled(step_of(function)), 0
    for a, b in pairs():
        wanted = values(function, a, b)
        if wanted is not None and not (max(map(abs, (a, b))) > 2.0**53 and np.isnan(run(a, b)).any()):
            compared += 1
            assert np.array(run(a, b)).view(np.int64).tolist() == np.array(wanted).view(np.int64).tolist() or (
                np.array_equal(run(a, b), wanted, equal_nan=True) and any(map(math.isnan, wanted))
            ), (a, b)
    assert compared > 200


@each("function", [*EXPRESSIONS, *BODIES])
def test_lanes_give_the_values_of_python(function: Function) -> None:
    """Polynomials in place of the library: a power loses as many digits as the logarithm of its result has."""
    run = compiled(step_of(function), LANES)
    for a, b in pairs(2):
        wanted = values(function, a, b)
        if wanted is not None and not any(0.0 < abs(x) < 1e-6 or 1e6 < abs(x) < math.inf for x in (a, b)):
            assert run(a, b) == pytest.approx(wanted, rel=3e-13, abs=1e-15, nan_ok=True), (a, b)


@each(
    "function, said",
    [
        (lambda a, b: math.hypot(a, b), "sqrt(a*a + b*b)"),
        (lambda a, b: np.sin(a), "sin of math"),
        (lambda a, b: np.fix(a), "trunc of math"),
        (lambda a, b: math.gamma(a), "the functions of contourlab.primitives"),
        (lambda a, b: float(str(a)), "the functions of contourlab.primitives"),
        (lambda a, b: np.arctan2(a, b), "atan2 of math"),
        (lambda a, b: sum((a, b)), "+ in a loop"),
        (lambda a, b: np.isfinite(a) * a, "isfinite of math"),
        (lambda a, b: np.max((a, b)), "use max"),
        (lambda a, b: a % (b, 2.0), "mod: a number is needed"),  # type: ignore[operator]
        (lambda a, b: math.ceil((a, b)), "ceil: a number is needed"),  # type: ignore[arg-type]
        (lambda a, b: LEVELS[a], "lookup of contourlab.primitives"),  # type: ignore[call-overload]
        (lambda a, b: {0: a}[0], "named tuple"),
        (lambda a, b: 1.0 if ~(a > 0.0) else 0.0, "not"),
        (lambda a, b: 6 & a, "conditions alone"),
        (lambda a, b: max(a, b, key=abs), "max cannot be called so"),
        (lambda a, b: round(a, 2), "round cannot be called so"),
        (lambda a, b: (y := a) * y if a > b else b, "a := that does not always run"),
    ],
)
def test_what_has_no_value_of_its_own_is_refused_with_what_to_write(function: Function, said: str) -> None:
    with pytest.raises(EngineError, match=r".") as refusal:
        graph_of(Step("made", lambda par, x, inp, clock: ((), (function(inp.a, inp.b),)), **PORTS))
    assert refusal.value.line == function.__code__.co_firstlineno and said in str(refusal.value)


def mixed_kinds(a: float, b: float) -> Any:
    for level in LEVELS:
        if a > level:
            return level, b
        if b > level:
            return level
    return a, b


def test_returns_of_different_kinds_are_refused() -> None:
    with pytest.raises(EngineError, match="different kinds"):
        graph_of(Step("made", lambda par, x, inp, clock: ((), mixed_kinds(inp.a, inp.b)), **PORTS))


def test_c99_gives_the_values_of_python(tmp_path: Path) -> None:
    """A compiler may make x*x of pow(x, 2)."""
    steps = [step_of(function) for function in (*EXPRESSIONS, *BODIES)]
    graphs = [graph_of(step) for step in steps]
    make = in_c(graphs, tmp_path)
    for function, step, graph in zip((*EXPRESSIONS, *BODIES), steps, graphs, strict=True):
        run = compiled(step, make=lambda _, graph=graph: make(graph))
        for a, b in pairs(3)[:400]:
            wanted = values(function, a, b)
            if wanted is not None:
                assert run(a, b) == pytest.approx(wanted, rel=1e-15, abs=0.0, nan_ok=True), (a, b)


IN_STRUCTURED_TEXT: list[Function] = [
    lambda a, b: a**2 - b**-3,
    lambda a, b: math.atan2(a, b) + math.atan(a) * math.tan(b),
    lambda a, b: math.asin(min(1.0, max(-1.0, a))) * abs(b) ** 0.5,
    lambda a, b: math.acos(max(-1, min(a, 1))) - round(b) * int(a) + lookup(LEVELS, b),
    returning,
    continuing_while,
    breaking_a_tuple,
    returning_from_else,
]


@each("function", IN_STRUCTURED_TEXT)
def test_structured_text_gives_the_values_of_python(function: Function, tmp_path: Path) -> None:
    pytest.importorskip("blark")
    made = step_of(function)
    schedule = Schedule((Node("x.s", made, {"a": "in.a", "b": "in.b"}, {}, {}),), made.inputs, 1e-3, 1)
    group = CompiledGroup(schedule, 1, slice(0, 1))
    control = control_of(
        schedule, group.places, group.memory[:, 0].copy(), np.zeros(len(group.memory)), output="x.s.y0", command=Field("command"),
        inputs={"a": Field("a"), "b": Field("b")}, parameters={}, constants={}, name="made", notes=(),
    )  # fmt: skip
    (tmp_path / "made.st").write_text(structured_text.plain(control))
    block = FunctionBlock(tmp_path / "made.st")
    for a, b in [(a, b) for a in (0.0, -0.3, 0.5, 1.0, -2.5, 7.0) for b in (0.0, -1.0, 0.25, 1.5, 6.0)]:
        wanted = values(function, a, b)
        if wanted is not None:
            assert block(enable=True, a=a, b=b) == pytest.approx(wanted[0], rel=1e-14, nan_ok=True), (a, b)


@pytest.mark.parametrize("a", [1e16, 2.0**53 + 2.0, -3e200])
def test_a_whole_number_with_more_digits_than_a_float_is_nan(a: float) -> None:
    """Python's own have as many digits as they need."""
    run = compiled(step_of(lambda a, b: (int(a) + 1 - int(a), int(b) ** 40)))
    assert np.isnan(run(a, 1000.0)).all() and run(3.0, -2.0) == [1.0, 2.0**40]
