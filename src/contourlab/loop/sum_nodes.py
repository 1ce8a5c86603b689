"""Nodes that add signals up."""

from __future__ import annotations

from functools import cache
from typing import Any

from contourlab.engine.schedule import Node
from contourlab.engine.step import Port, Step


@cache
def sum_step(n: int) -> Step:
    """Return the step that adds `n` signals, two or more."""
    return Step("sum", _total, (), (), "", (), (Port("terms", n),), (Port("total"),))


def _total(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    total = inp.terms[0]
    for i in range(1, len(inp.terms)):
        total = total + inp.terms[i]
    return (), (total,)


def constant_node(name: str) -> Node:
    """Return a node whose one output ``value`` is zero."""
    return Node(name, _ZERO, {})


def _nothing(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    return (), (0.0,)


_ZERO = Step("zero", _nothing, (), (), "", (), (), (Port("value"),))
