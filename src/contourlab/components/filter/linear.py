"""Filters given by matrices or by a transfer function."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param
from contourlab.components.linear_part import (
    MATRICES,
    METHOD,
    PERIOD,
    POLYNOMIALS,
    System,
    checked,
    flat,
    from_matrices,
    from_polynomials,
    prepare,
    sampled,
)
from contourlab.components.mechanics.matrix_step import matrix_step
from contourlab.engine.step import Step


class LinearFilter(Component):
    """Base of filters y = C x + D u, x' = A x + B u, from command to command, with all poles inside the edge of stability.

    Its states are turned and scaled so that all equal the command at rest.
    """

    family = "filter"
    without_effect = ("period",)  # the example is continuous
    system: System

    def __init__(self, **values: Any) -> None:
        super().__init__(**flat(values))

    def matrices(self) -> System:
        """Return the matrices as given."""
        raise NotImplementedError

    def check_values(self) -> None:
        part: Any = self
        a, b, c, d = checked(part, self.matrices(), -1e-12)
        n = len(a)
        if n:
            resting = np.linalg.solve(np.eye(n) - a if part.period > 0.0 else -a, b)[:, 0]
            size = float(np.linalg.norm(resting))
            aside = np.full(n, n**-0.5) - resting / size
            mirror = np.eye(n) - 2.0 * np.outer(aside, aside) / max(float(aside @ aside), 1e-300)
            turn = mirror * size / n**0.5
            back = mirror * n**0.5 / size
            a, b, c = back @ a @ turn, back @ b, c @ turn
        prepare(self, (a, b, c, d), n + 1, n + 1)

    @property
    def rest_gain(self) -> float:
        """Command out over command in, at rest."""
        _, _, c, d = self.system
        return float(c.sum() + d[0, 0])

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        a, b, c, d = sampled(self, self.system, dt)
        return tuple(np.block([[a, b], [c, d]]).ravel().tolist())

    def make_step(self, n_axis: int = 1) -> Step:
        function = matrix_step(self.states, self.inputs, self.outputs, 0)
        return Step(f"filter/{self.kind}", function, self.derived, (), "", self.states, self.inputs, self.outputs)

    def linearize(self) -> LinearModel | None:
        """Return the model; None if it is discrete."""
        part: Any = self
        return None if part.period > 0.0 else LinearModel(*self.system, ("command",), ("command",))


class StateSpaceFilter(LinearFilter):
    """Filter y = C x + D u, x' = A x + B u, in continuous time, or x(k + 1) = A x + B u with a `period`.

    Matrices are lists of numbers, row by row. In continuous time A is in 1/s. The gain at rest may differ from 1, but not for positions.
    """

    kind = "state-space"
    reference = "Franklin, Powell & Workman, Digital Control of Dynamic Systems, chapters 4 and 6"
    example = {"a": (0.0, 1.0, -9e4, -300.0), "b": (0.0, 9e4), "c": (1.0, 1e-3), "d": (0.3,)}
    unbounded = ("a", "b", "c", "d")

    a, b, c = MATRICES
    d: tuple[float, ...] = param(default=(0.0,), vector=True, doc="D, one number")
    method: str = METHOD
    period: float = PERIOD

    def matrices(self) -> System:
        return from_matrices(self, 1)


class TransferFunctionFilter(LinearFilter):
    """Filter numerator/denominator in s, or in z with a `period`; its gain at rest may differ from 1, except for positions."""

    kind = "transfer-function"
    reference = "Franklin, Powell & Workman, Digital Control of Dynamic Systems, chapters 4 and 6"
    example = {"numerator": (1e-3, 1.0), "denominator": (1e-5, 4e-3, 1.0)}
    unbounded = ("numerator", "denominator")

    numerator, denominator = POLYNOMIALS
    method: str = METHOD
    period: float = PERIOD

    def matrices(self) -> System:
        return from_polynomials(self)
