"""Trace NumPy code over numbers that are not known yet: each function of NumPy becomes an operation of a graph.

So the code that computes the constants of a loop from its parameters becomes a function of a module. What code asks of a number beside
NumPy, such as ``float(x)``, cannot become an operation: `KnownError` names the parameters that must stay as they are. What it asks in an
``if`` is a condition under which the trace holds.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from typing import Any, NoReturn

import numpy as np

from contourlab import primitives
from contourlab.engine.translate import maths, polynomials
from contourlab.engine.translate.evaluate import Evaluator
from contourlab.engine.translate.graph import COMPARED, FOLDED, Graph, Op


class KnownError(Exception):
    """Code needs the value of a number; its second argument names the parameters that the number depends on."""


class Trace:
    """A graph under construction, and the conditions under which code would take the same way again.

    The leaves of the graph are ``parameter``; ``extra`` is the place in memory.
    """

    def __init__(self) -> None:
        self.graph, self.conditions = Graph(), list[Any]()
        self.run = Evaluator(self.graph, maths.LANES)

    def leaf(self, place: int, value: float, name: str = "") -> Traced:
        """Return the number at a place in memory; `value` is what it is now."""
        return Traced(self, self.graph.op("parameter", extra=place), value, {name})


class Traced(np.lib.mixins.NDArrayOperatorsMixin):
    """A number or a condition that is not known yet, with the value that it has now."""

    def __init__(self, trace: Trace, op: Op, value: Any, names: set[str]) -> None:
        self.trace, self.op, self.value, self.names = trace, op, value, names

    def __array_ufunc__(self, ufunc: Any, method: str, *values: Any, **named: Any) -> Any:
        return self._made(ufunc, values, plain=method == "__call__" and not named)

    def __array_function__(self, function: Any, types: Any, args: Any, named: Any) -> Any:
        # A check of the numbers of all lanes at once: a trace has one lane, whose largest and any is the number itself.
        return args[0] if function in (np.max, np.any) else self._made(function, args, plain=not named)

    def _made(self, function: Any, values: Any, *, plain: bool) -> Any:
        names = self.names.union(*(value.names for value in values if isinstance(value, Traced)))
        if not plain or function not in _OPERATIONS or any(np.ndim(value) for value in values if not isinstance(value, Traced)):
            raise KnownError(f"its value in numpy.{function.__name__}", names)
        ops = [value.op if isinstance(value, Traced) else np.asarray(value).item() for value in values]
        with np.errstate(all="ignore"):
            now = function(*(value.value if isinstance(value, Traced) else value for value in values))
        made = _OPERATIONS[function](self.trace.run, *ops)
        return Traced(self.trace, made, now, names) if isinstance(made, Op) else made

    def __pow__(self, n: Any) -> Any:
        return reduce(lambda a, b: a * b, [self] * int(n), 1.0) if n in range(65) else self._asked()

    def __bool__(self) -> bool:
        now, condition = bool(self.value), self.trace.graph.condition(self.op)
        self.trace.conditions.append(condition if now else self.trace.graph.logic("not", condition))
        return now

    def __ceil__(self) -> Any:
        return np.ceil(self)

    def __format__(self, spec: str) -> str:
        return format(self.value, spec)

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(name) if name.startswith("__") else KnownError(f"its {name}", self.names)

    def _asked(self, *asked: Any, **named: Any) -> NoReturn:
        raise KnownError("its value", self.names)

    __float__ = __int__ = __index__ = __round__ = __hash__ = __array__ = __iter__ = __len__ = _asked


def _graph(way: str, *first: str) -> Callable[..., Any]:
    return lambda run, *values: getattr(run.graph, way)(*first, *values)


def _logic(kind: str) -> Callable[..., Any]:
    return lambda run, *values: run.graph.logic(kind, *map(run.graph.condition, values))


def _called(function: Any) -> Callable[..., Any]:
    return lambda run, *values: run.call(function, values)


_ARITHMETIC = (np.add, np.subtract, np.multiply, np.divide, np.negative, np.absolute, np.sqrt)
_COMPARISONS = (np.less, np.greater, np.less_equal, np.greater_equal, np.equal, np.not_equal)
_OPERATIONS: dict[Any, Callable[..., Any]] = {
    **{ufunc: _graph("arithmetic", kind) for ufunc, kind in zip(_ARITHMETIC, FOLDED, strict=False)},
    **{ufunc: _graph("compare", sign) for ufunc, sign in zip(_COMPARISONS, COMPARED, strict=True)},
    **{
        getattr(np, name): _called(getattr(primitives, name))
        for name in ("exp", "log", "sin", "cos", "floor", "rint", "maximum", "minimum")
    },
    np.expm1: _called(polynomials.expm1),
    np.tan: _called(lambda x: primitives.sin(x) / primitives.cos(x)),
    np.ceil: _called(lambda x: -primitives.floor(-x)),
    np.isfinite: _called(lambda x: x - x == 0.0),
    **dict.fromkeys((np.logical_and, np.bitwise_and), _logic("and")),
    **dict.fromkeys((np.logical_or, np.bitwise_or), _logic("or")),
    np.logical_not: _logic("not"),
    np.where: _called(primitives.select),
}
"""The functions of NumPy that become operations."""
