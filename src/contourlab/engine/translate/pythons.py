"""Python's own functions and operators on numbers, and those of `math` and `numpy`, as operations of a graph.

Each gives the value that Python gives. Where Python raises, as for the root of -1 or a remainder of 0, it gives NaN, or infinity. What has
another last digit on another processor or in another version of Python, such as `numpy.sin`, `math.hypot` or `sum`, is not among them.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping
from functools import partial, reduce
from typing import Any

import numpy as np

from contourlab import primitives
from contourlab.engine.translate.graph import MismatchError, Op, is_whole
from contourlab.errors import refuse

Primitive = Callable[..., Any]


def operation(name: str) -> Primitive:
    """Return a function that makes an operation."""
    return lambda run, *values: run.graph.op(name, [run.graph.number(value) for value in values])


def written(function: Callable[..., Any]) -> Primitive:
    """Return a function that is evaluated as written."""
    return lambda run, *values: run.call(function, values)


def _whole(made: Primitive) -> Primitive:
    """Return a function whose result is a whole number of Python."""
    return lambda run, x: run.graph.whole(run.graph.exact(made(run, x)))


def known(function: Callable[..., Any], made: Primitive) -> Primitive:
    """Return a function that Python itself computes where all arguments are known."""

    def called(run: Any, *values: Any) -> Any:
        return made(run, *values) if any(map(_is_unknown, values)) else function(*values)

    return called


def _is_unknown(value: Any) -> bool:
    return any(map(_is_unknown, value)) if isinstance(value, tuple) else isinstance(value, Op)


def _abs(run: Any, x: Any) -> Any:
    return run.graph.whole(run.graph.arithmetic("fabs", x), x, zero=False)


def _first(sign: str) -> Primitive:
    """Return `min` or `max`: the first of those that no other one is below or above, so that a NaN stays only where it stands first."""

    def chosen(run: Any, *values: Any) -> Any:
        items = values[0] if len(values) == 1 else values
        return reduce(lambda best, x: run.graph.select(run.graph.compare(sign, x, best), x, best), items)

    return chosen


def _all_of(kind: str, start: bool) -> Primitive:
    return lambda run, values: reduce(lambda a, b: run.graph.logic(kind, a, b), map(run.graph.condition, values), start)


def _power(run: Any, a: Any, b: Any) -> Any:
    made = run.call(math.pow, (a, b))
    where = is_whole(a) if isinstance(b, int) and b >= 0 else False
    return run.graph.whole(run.graph.select(where, run.graph.exact(made), made), a) if where is not False else made


def _mod(a: float, b: float) -> float:
    r = math.fmod(a, b)
    turned = r + b if (r < 0.0) != (b < 0.0) else r
    return primitives.select(r == 0.0, primitives.copysign(0.0, b), turned)


def _floordiv(a: float, b: float) -> float:
    r = math.fmod(a, b)
    quotient = (a - r) / b - (1.0 if r != 0.0 and (r < 0.0) != (b < 0.0) else 0.0)
    whole = primitives.floor(quotient)
    nearest = whole + 1.0 if quotient - whole > 0.5 else whole
    return primitives.select(quotient == 0.0, primitives.copysign(0.0, a / b), nearest)


def _of_whole(function: Callable[[float, float], float]) -> Primitive:
    return lambda run, a, b: run.graph.whole(run.call(function, (a, b)), a, b)


def _trunc(x: float) -> float:
    return primitives.copysign(primitives.floor(primitives.fabs(x)), x)


def _ceil(x: float) -> float:
    return -primitives.floor(-float(x))  # of a whole 0 too


def _sign(x: float) -> float:
    return 1.0 if x > 0.0 else -1.0 if x < 0.0 else 0.0 if x == 0.0 else x


def _clip(x: float, low: float, high: float) -> float:
    return primitives.minimum(primitives.maximum(x, low), high)


def _bitwise(run: Any, kind: str, a: Any, b: Any) -> Any:
    graph = run.graph
    for value in (a, b):
        refuse(graph.condition(value) is not value, MismatchError, "& | ^ join conditions alone here: use and, or, or arithmetic")
    if kind != "xor":
        return graph.logic(kind, a, b)
    return graph.logic("or", graph.logic("and", a, graph.logic("not", b)), graph.logic("and", graph.logic("not", a), b))


_NUMBERS: Mapping[Any, Primitive] = {
    **{getattr(math, name): operation(name) for name in ("tan", "asin", "acos", "atan", "atan2", "pow", "fmod", "exp")},
    **{getattr(math, name): written(getattr(primitives, name)) for name in ("sqrt", "sin", "cos", "tanh", "fabs")},
    math.log: lambda run, *x: reduce(partial(run.graph.arithmetic, "fdiv"), [run.call(primitives.log, (one,)) for one in x]),
    math.floor: _whole(written(primitives.floor)),
    math.ceil: _whole(written(_ceil)),
    round: _whole(written(primitives.rint)),
    math.trunc: _whole(written(_trunc)),
    int: _whole(written(_trunc)),
    **dict.fromkeys((math.copysign, np.copysign), written(primitives.copysign)),  # the sign of a NaN depends on the processor
    **dict.fromkeys((math.isnan, np.isnan), lambda run, x: run.graph.compare("!=", x, x)),
    math.isinf: lambda run, x: run.graph.compare("==", run.graph.arithmetic("fabs", x), math.inf),
    math.isfinite: lambda run, x: run.graph.compare("<", run.graph.arithmetic("fabs", x), math.inf),
    math.degrees: lambda run, x: run.graph.arithmetic("fmul", x, 180.0 / math.pi),
    math.radians: lambda run, x: run.graph.arithmetic("fmul", x, math.pi / 180.0),
    abs: _abs,
    min: _first("<"),
    max: _first(">"),
    bool: lambda run, x: run.graph.condition(x),
    any: _all_of("or", False),
    all: _all_of("and", True),
    pow: _power,
    divmod: lambda run, a, b: (_of_whole(_floordiv)(run, a, b), _of_whole(_mod)(run, a, b)),
    operator.pow: _power,
    operator.mod: _of_whole(_mod),
    operator.floordiv: _of_whole(_floordiv),
    operator.and_: lambda run, a, b: _bitwise(run, "and", a, b),
    operator.or_: lambda run, a, b: _bitwise(run, "or", a, b),
    operator.xor: lambda run, a, b: _bitwise(run, "xor", a, b),
    **{getattr(np, name): written(getattr(primitives, name)) for name in ("sqrt", "fabs", "floor", "rint")},
    np.absolute: written(primitives.fabs),
    np.minimum: written(primitives.minimum),
    np.maximum: written(primitives.maximum),
    np.sign: written(_sign),
    np.ceil: written(_ceil),
    np.trunc: written(_trunc),
    np.clip: written(_clip),
}
PYTHONS: Mapping[Any, Primitive] = {function: known(function, made) for function, made in _NUMBERS.items()}
"""Functions and operators of Python, `math` and `numpy`."""
