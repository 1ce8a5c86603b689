"""Filters given by matrices or by a transfer function."""

from __future__ import annotations

import numpy as np

from contourlab.components.contract import LinearModel, param
from contourlab.components.linear_part import MATRICES, METHOD, PERIOD, POLYNOMIALS, LinearPart, checked


class LinearFilter(LinearPart):
    """Base of filters y = C x + D u, x' = A x + B u, from command to command, with all poles inside the edge of stability.

    Its states are turned and scaled so that all equal the command at rest.
    """

    family = "filter"

    def check_values(self) -> None:
        a, b, c, d = checked(self, self.given(), -1e-12)
        n = len(a)
        if n:
            resting = np.linalg.solve(np.eye(n) - a if self.discrete else -a, b)[:, 0]
            size = float(np.linalg.norm(resting)) / n**0.5
            aside = n**-0.5 * (1.0 - resting / size)
            mirror = np.eye(n) - 2.0 * np.outer(aside, aside) / max(float(aside @ aside), 1e-300)
            a, b, c = mirror @ a @ mirror, mirror @ b / size, c @ mirror * size
        self.prepare((a, b, c, d), n + 1, n + 1)

    @property
    def rest_gain(self) -> float:
        """Command out over command in, at rest."""
        _, _, c, d = self.system
        return float(c.sum() + d[0, 0])

    def linearize(self) -> LinearModel | None:
        """Return the model; None if it is discrete."""
        return None if self.discrete else LinearModel(*self.system, ("command",), ("command",))


class StateSpaceFilter(LinearFilter):
    """Filter y = C x + D u, x' = A x + B u, in continuous time, or x(k + 1) = A x + B u with a `period`.

    Matrices are lists of numbers, row by row. In continuous time A is in 1/s. The gain at rest may differ from 1, but not for positions.
    """

    kind = "state-space"
    example = {"a": (0.0, 1.0, -9e4, -300.0), "b": (0.0, 9e4), "c": (1.0, 1e-3), "d": (0.3,)}
    unbounded = ("a", "b", "c", "d")

    a, b, c = MATRICES
    d: tuple[float, ...] = param(default=(0.0,), vector=True, doc="D, one number")
    method: str = METHOD
    period: float = PERIOD


class TransferFunctionFilter(LinearFilter):
    """Filter numerator/denominator in s, or in z with a `period`; its gain at rest may differ from 1, except for positions."""

    kind = "transfer-function"
    example = {"numerator": (1e-3, 1.0), "denominator": (1e-5, 4e-3, 1.0)}
    unbounded = ("numerator", "denominator")

    numerator, denominator = POLYNOMIALS
    method: str = METHOD
    period: float = PERIOD
