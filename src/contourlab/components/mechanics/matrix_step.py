"""The step of a linear part: one product with a matrix."""

from __future__ import annotations

from functools import cache
from typing import Any

from contourlab.engine.step import Port, rows
from contourlab.primitives import dot


@cache
def matrix_step(states: tuple[Port, ...], inputs: tuple[Port, ...], outputs: tuple[Port, ...], first: int) -> Any:
    """Return the step (x_next, out) = M (x, inp); M is a part of `par` from the place `first` on, row by row."""
    height, width = rows(states) + rows(outputs), rows(states) + rows(inputs)
    taken = tuple(port.size for port in (*states, *inputs))
    places, row = [], 0
    for port in (*states, *outputs):
        places.append((row, row + port.size))
        row += port.rows
    given, split = tuple(places), len(states)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        values = (*x, *inp)
        u = tuple(number for value, size in zip(values, taken, strict=True) for number in (value if size else (value,)))
        y = tuple(dot(par[first + i * width : first + (i + 1) * width], u) for i in range(height))
        shaped = tuple(y[start:end] if end > start else y[start] for start, end in given)
        return shaped[:split], shaped[split:]

    return step
