"""Trace NumPy code over numbers that are not known yet: each function of NumPy becomes an operation of a graph.

So the code that computes the constants of a loop from its parameters becomes a function of a module. What code asks of a number beside
NumPy, such as ``float(x)``, cannot become an operation: `KnownError` names the parameters that must stay as they are. What it asks in an
``if`` is a condition under which the trace holds.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce
from typing import Any

import numpy as np

from contourlab import primitives
from contourlab.engine.translate import maths, polynomials
from contourlab.engine.translate.evaluate import Evaluator
from contourlab.engine.translate.graph import COMPARED, FOLDED, Graph, Op


class KnownError(Exception):
    """Code needs the value of a number; `names` are the parameters that it depends on."""

    def __init__(self, names: frozenset[str], asked: str) -> None:
        super().__init__(asked)
        self.names, self.asked = names, asked


class Trace:
    """A graph under construction.

    Attributes
    ----------
    graph : Graph
        Its leaves are ``parameter``; ``extra`` is the place in memory.
    conditions : list of Op
        What must hold, or else the code would have taken another way.
    """

    def __init__(self) -> None:
        self.graph = Graph()
        self.run = Evaluator(self.graph, maths.LANES)
        self.conditions: list[Op] = []

    def leaf(self, place: int, value: float, name: str = "") -> Traced:
        """Return the number at a place in memory; `value` is what it is now."""
        return Traced(self, self.graph.op("parameter", extra=place), value, frozenset({name} if name else ()))


class Traced(np.lib.mixins.NDArrayOperatorsMixin):
    """A number or a condition that is not known yet, with the value that it has now."""

    def __init__(self, trace: Trace, op: Op, value: Any, names: frozenset[str]) -> None:
        self.trace, self.op, self.value, self.names = trace, op, value, names

    def __array_ufunc__(self, ufunc: Any, method: str, *values: Any, **named: Any) -> Any:
        if method != "__call__" or named or ufunc not in _UFUNCS:
            raise KnownError(self.names, f"numpy.{ufunc.__name__}")
        return self._made(_UFUNCS[ufunc], ufunc, values)

    def __array_function__(self, function: Any, types: Any, args: Any, named: Any) -> Any:
        if named or function not in (np.where, np.max, np.any):
            raise KnownError(self.names, f"numpy.{function.__name__}")
        if function is not np.where:
            return args[0]  # of one variant
        return self._made(lambda run, test, a, b: run.graph.select(run.graph.condition(test), a, b), np.where, args)

    def _made(self, make: Callable[..., Any], function: Any, values: Sequence[Any]) -> Any:
        names: frozenset[str] = frozenset().union(*(value.names for value in values if isinstance(value, Traced)))
        if any(np.ndim(value) for value in values if not isinstance(value, Traced)):
            raise KnownError(names, "an array")
        ops = [value.op if isinstance(value, Traced) else np.asarray(value).item() for value in values]
        with np.errstate(all="ignore"):
            now = function(*(value.value if isinstance(value, Traced) else value for value in values))
        try:
            op = make(self.trace.run, *ops)
        except NotImplementedError as error:
            raise KnownError(names, str(error)) from error
        return Traced(self.trace, op, now, names) if isinstance(op, Op) else op

    def __bool__(self) -> bool:
        graph, now = self.trace.graph, bool(self.value)
        condition: Any = graph.condition(self.op)
        self.trace.conditions.append(condition if now else graph.logic("not", condition))
        return now

    def __ceil__(self) -> Any:
        return np.ceil(self)

    def __abs__(self) -> Any:
        return np.abs(self)

    def __format__(self, spec: str) -> str:
        return format(self.value, spec)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__array"):
            raise AttributeError(name)
        raise KnownError(self.names, name)

    def _asked(self, *args: Any, **named: Any) -> Any:
        raise KnownError(self.names, "its value")

    __float__ = __int__ = __index__ = __round__ = __hash__ = __array__ = __iter__ = __len__ = _asked


def _arithmetic(kind: str) -> Callable[..., Any]:
    return lambda run, *values: run.graph.arithmetic(kind, *values)


def _compared(sign: str) -> Callable[..., Any]:
    return lambda run, a, b: run.graph.compare(sign, a, b)


def _called(function: Any) -> Callable[..., Any]:
    return lambda run, *values: run.call(function, values)


def _logic(kind: str) -> Callable[..., Any]:
    return lambda run, *values: run.graph.logic(kind, *map(run.graph.condition, values))


def _power(run: Evaluator, base: Any, exponent: Any) -> Any:
    if isinstance(exponent, Op) or exponent not in range(17):
        raise NotImplementedError("a power")
    return reduce(lambda a, b: run.graph.arithmetic("fmul", a, b), [base] * int(exponent), 1.0)


_ALIKE = ("exp", "log", "sin", "cos", "floor", "rint", "maximum", "minimum")
_UFUNCS: dict[Any, Callable[..., Any]] = {
    **{getattr(np, name): _called(getattr(primitives, name)) for name in _ALIKE},
    **{ufunc: _arithmetic(kind) for ufunc, kind in zip((np.add, np.subtract, np.multiply, np.divide), FOLDED, strict=False)},
    np.negative: _arithmetic("fneg"),
    np.absolute: _arithmetic("fabs"),
    np.sqrt: _arithmetic("sqrt"),
    np.positive: lambda run, x: x,
    np.power: _power,
    np.ceil: lambda run, x: run.graph.arithmetic("fneg", run.call(primitives.floor, [run.graph.arithmetic("fneg", x)])),
    np.expm1: _called(polynomials.expm1),
    np.tan: _called(polynomials.tan),
    np.isfinite: lambda run, x: run.graph.compare("==", run.graph.arithmetic("fsub", x, x), 0.0),
    **{
        ufunc: _compared(sign)
        for ufunc, sign in zip((np.less, np.greater, np.less_equal, np.greater_equal, np.equal, np.not_equal), COMPARED, strict=True)
    },
    np.logical_and: _logic("and"),
    np.bitwise_and: _logic("and"),
    np.logical_or: _logic("or"),
    np.bitwise_or: _logic("or"),
    np.logical_not: _logic("not"),
    np.invert: _logic("not"),
}
"""The functions of NumPy that become operations."""
