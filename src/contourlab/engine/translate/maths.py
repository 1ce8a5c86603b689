"""The primitives of a step as operations of a graph."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from contourlab import primitives
from contourlab.engine.translate import polynomials
from contourlab.engine.translate.graph import CONDITION, Op

Primitive = Callable[..., Any]


def _operation(name: str) -> Primitive:
    return lambda run, *values: run.graph.op(name, [run.graph.number(value) for value in values])


def _arithmetic(name: str) -> Primitive:
    return lambda run, *values: run.graph.arithmetic(name, *values)


def _exp(run: Any, x: Any) -> Any:
    graph = run.graph
    if not isinstance(x, Op):
        return primitives.exp(x)
    below = graph.select(graph.compare("<", 709.0, x), 709.0, x)
    return graph.branch(graph.compare(">", x, -700.0), lambda: graph.op("exp", [graph.number(below)]), lambda: 0.0)


def _lookup(run: Any, table: Op, index: Any) -> Any:
    return run.graph.op("lookup", [table, run.graph.number(index)])


def _delayed(run: Any, ring: Op, clock: Any, ticks: Any) -> Any:
    return run.graph.op("delayed", [run.graph.arithmetic("fsub", clock[0], ticks)], extra=ring.extra)


def _select(run: Any, condition: Any, a: Any, b: Any) -> Any:
    return run.graph.select(run.graph.condition(condition), a, b)


EXACT: Mapping[Any, Primitive] = {
    primitives.sqrt: _arithmetic("sqrt"),
    primitives.fabs: _arithmetic("fabs"),
    primitives.copysign: _arithmetic("copysign"),
    **{getattr(primitives, name): _operation(name) for name in ("floor", "rint", "log", "tanh", "sin", "cos", "uniform")},
    primitives.exp: _exp,
    primitives.select: _select,
    primitives.lookup: _lookup,
    primitives.delayed: _delayed,
}
"""Each primitive by the C function that Python's own `math` calls; those that are missing are evaluated as written."""


def _polynomial(function: Primitive) -> Primitive:
    return lambda run, x: run.call(function, [x])


def _saturated_exp(run: Any, x: Any) -> Any:
    """Return the polynomial of exp where it is not 0: friction laws ask mostly for exp of very negative numbers."""
    graph = run.graph
    if not isinstance(x, Op):
        return primitives.exp(x)
    return graph.branch(graph.compare(">", x, -700.0), lambda: run.call(polynomials.exp, [x]), lambda: 0.0)


def _saturated(function: Primitive) -> Primitive:
    """Return tanh that calls the function only where tanh is not 1 to all digits; friction laws ask mostly for it elsewhere."""

    def tanh(run: Any, x: Any) -> Any:
        graph = run.graph
        beyond = graph.compare(">=", graph.arithmetic("fabs", x), 20.0)
        return graph.branch(beyond, lambda: graph.arithmetic("copysign", 1.0, x), lambda: function(run, x))

    return tanh


def _bit(mask: int) -> Primitive:
    return lambda run, n: run.graph.op("bit", [run.graph.number(n)], CONDITION, mask)


_BITS: Mapping[Any, Primitive] = {
    polynomials.fma: _operation("fma"),
    polynomials.pow2: _operation("pow2"),
    polynomials.exponent: _operation("exponent"),
    polynomials.odd: _bit(1),
    polynomials.twos: _bit(2),
}
_TURNS = {primitives.sin: _polynomial(polynomials.sin), primitives.cos: _polynomial(polynomials.cos)}
SINGLE: Mapping[Any, Primitive] = {**EXACT, **_BITS, **_TURNS, primitives.tanh: _saturated(_operation("tanh"))}
"""For one variant: sine and cosine together are faster as polynomials than from the library."""
LANES: Mapping[Any, Primitive] = {
    **SINGLE,
    primitives.exp: _saturated_exp,
    primitives.tanh: _saturated(_polynomial(polynomials.tanh)),
    primitives.log: _polynomial(polynomials.log),
}
"""For lanes: polynomials in place of all calls."""
