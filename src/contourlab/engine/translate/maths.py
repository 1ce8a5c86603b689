"""The primitives of a step as operations of a graph."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import reduce
from typing import Any

from contourlab import primitives
from contourlab.engine.translate import polynomials
from contourlab.engine.translate.graph import CONDITION, Op
from contourlab.engine.translate.pythons import PYTHONS, Primitive, known, operation, written


def _exp(function: Primitive) -> Primitive:
    """Return exp that calls the function only where exp is not 0: friction laws ask mostly for exp of very negative numbers."""

    def exp(run: Any, x: Any) -> Any:
        if not isinstance(x, Op):
            return primitives.exp(x)
        return run.graph.branch(run.graph.compare("<=", x, -700.0), lambda: 0.0, lambda: function(run, x))

    return exp


def _inside(graph: Any, index: Any, sign: str, end: Any, read: Callable[[Any], Any]) -> Any:
    """Return ``read(index)``, and NaN where the index is not above -1 or not below the end."""
    inside = graph.logic("and", graph.compare(">", index, -1.0), graph.compare(sign, index, end))
    return graph.select(inside, read(graph.select(inside, index, 0.0)), math.nan)


def _lookup(run: Any, table: Any, index: Any) -> Any:
    graph = run.graph
    if not isinstance(table, Op):  # a tuple

        def entry(at: Any) -> Any:
            inner = range(len(table) - 1, 0, -1)
            return reduce(lambda found, i: graph.select(graph.compare("<", at, i), table[i - 1], found), inner, table[-1])

        return _inside(graph, index, "<", len(table), entry)
    size = graph.op("size", extra=("table", table.extra))
    return _inside(graph, index, "<", size, lambda at: graph.op("lookup", [table, graph.number(at)]))


def _delayed(run: Any, ring: Op, clock: Any, ticks: Any) -> Any:
    graph = run.graph
    size = float(ring.extra[1]) if isinstance(ring.extra, tuple) else graph.op("size", extra=("ring", ring.extra))
    oldest = graph.arithmetic("fsub", size, 1.0)
    return _inside(graph, ticks, "<=", oldest, lambda n: graph.op("delayed", [graph.arithmetic("fsub", clock[0], n)], extra=ring.extra))


def _copysign(run: Any, x: Any, y: Any) -> Any:
    return run.graph.select(run.graph.compare("==", y, y), run.graph.arithmetic("copysign", x, y), y)


def _uniform(run: Any, *values: Any) -> Any:
    graph = run.graph
    sizes = (graph.arithmetic("fabs", value) for value in values)
    whole = graph.compare("<", reduce(lambda a, b: graph.arithmetic("fadd", a, b), sizes), 2.0**63)
    return graph.select(whole, graph.op("uniform", [graph.number(value) for value in values]), math.nan)


def _select(run: Any, condition: Any, a: Any, b: Any) -> Any:
    return run.graph.select(run.graph.condition(condition), a, b)


EXACT: Mapping[Any, Primitive] = {
    **PYTHONS,
    primitives.sqrt: lambda run, x: run.graph.arithmetic("sqrt", run.graph.number(x)),
    primitives.fabs: lambda run, x: run.graph.arithmetic("fabs", x),
    primitives.copysign: _copysign,
    **{getattr(primitives, name): operation(name) for name in ("floor", "rint", "log", "tanh", "sin", "cos")},
    primitives.uniform: _uniform,
    primitives.exp: _exp(lambda run, x: operation("exp")(run, run.graph.select(run.graph.compare("<", 709.0, x), 709.0, x))),
    primitives.select: _select,
    primitives.lookup: _lookup,
    primitives.delayed: _delayed,
}
"""Each primitive by the C function that Python's own `math` calls; those that are missing are evaluated as written."""


def _saturated(function: Primitive) -> Primitive:
    """Return tanh that calls the function only where tanh is not 1 to all digits; friction laws ask mostly for it elsewhere."""

    def tanh(run: Any, x: Any) -> Any:
        graph = run.graph
        beyond = graph.compare(">=", graph.arithmetic("fabs", x), 20.0)
        return graph.branch(beyond, lambda: graph.arithmetic("copysign", 1.0, x), lambda: function(run, x))

    return tanh


def _power(run: Any, a: Any, b: Any) -> Any:
    """Return a power: of a known small whole exponent as a product."""
    if not isinstance(b, (int, float)) or b != int(b) or abs(b) > 64.0:
        return run.call(polynomials.power, (a, b))
    made, square, n = 1.0, a, abs(int(b))
    while n:
        made = run.graph.arithmetic("fmul", made, square) if n & 1 else made
        square, n = run.graph.arithmetic("fmul", square, square), n >> 1
    return run.graph.arithmetic("fdiv", 1.0, made) if b < 0 else made


def _bit(mask: int) -> Primitive:
    return lambda run, n: run.graph.op("bit", [run.graph.number(n)], CONDITION, mask)


_BITS: Mapping[Any, Primitive] = {
    polynomials.fma: operation("fma"),
    polynomials.pow2: operation("pow2"),
    polynomials.exponent: operation("exponent"),
    polynomials.odd: _bit(1),
    polynomials.twos: _bit(2),
}
_TURNS = {primitives.sin: written(polynomials.sin), primitives.cos: written(polynomials.cos)}
SINGLE: Mapping[Any, Primitive] = {**EXACT, **_BITS, **_TURNS, primitives.tanh: _saturated(operation("tanh"))}
"""For one variant: sine and cosine together are faster as polynomials than from the library."""
LANES: Mapping[Any, Primitive] = {
    **SINGLE,
    primitives.exp: _exp(written(polynomials.exp)),
    primitives.tanh: _saturated(written(polynomials.tanh)),
    primitives.log: written(polynomials.log),
    math.exp: written(polynomials.unbounded_exp),
    math.pow: known(math.pow, _power),
    **{
        getattr(math, name): known(getattr(math, name), written(getattr(polynomials, name)))
        for name in ("tan", "asin", "acos", "atan", "atan2", "fmod")
    },
}
"""For lanes: polynomials in place of all calls."""
