"""Plants given by matrices or by a transfer function."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.components.contract import LinearModel, param
from contourlab.components.linear_part import MATRICES, PERIOD, POLYNOMIALS, LinearPart, System, checked, sampled
from contourlab.components.plant.plant import Plant
from contourlab.errors import ParameterError


class LinearPlant(LinearPart, Plant):
    """Base of plants p = C x, x' = A x + B u, u in V. A load acts as a command does, in V, unless a column of its own is given.

    The velocity is p' in continuous time, and the last difference in discrete time. It rests at any position if it has an integrator, else
    at 0 only. Friction acts where a load pushes the velocity at once.
    """

    command_unit = "V"
    force_unit = "V"
    resting: Any

    def given(self, n_input: int = 1) -> System:
        """Return the matrices as given; B has columns for command and load."""
        a, b, c, d = super().given()
        return a, np.hstack([b, b]), c, np.hstack([d, d])

    def check_values(self) -> None:
        a, b, c, d = self.given()
        if d.any() or not len(a):
            raise ParameterError(f"{self.kind}.d", f"{d[0, 0]:g}", "0: a position cannot jump with the command; a plant has states")
        a, b, c, d = checked(self, (a, b, c, d))
        n, discrete = len(a), self.discrete
        _, sizes, rows = np.linalg.svd(a - np.eye(n) * discrete)
        free = sizes[-1] <= 1e-9 * sizes[0] and abs(c @ rows[-1])[0] > 0.0
        resting: Any = rows[-1] / float((c @ rows[-1])[0]) if free else None
        if discrete:  # one state more: the last position
            a, b, c = np.block([[a, np.zeros((n, 1))], [c, np.zeros((1, 1))]]), np.pad(b, ((0, 1), (0, 0))), np.pad(c, ((0, 0), (0, 1)))
            resting = np.append(resting, 1.0) if free else None
        self.prepare((a, b, c, d), len(a) + 3, len(a) + 2)
        object.__setattr__(self, "resting", resting)

    def at_rest(self, position: float) -> tuple[dict[str, Any], dict[str, Any]]:
        if position and self.resting is None:
            raise ParameterError(
                f"{self.kind}", f"at rest at {1e3 * position:g}", "at 0: it has no integrator, so it rests only there", "mm"
            )
        place = np.zeros(len(self.states)) if self.resting is None else position * self.resting
        return dict(zip((port.name for port in self.states), place.tolist(), strict=True)), {"position": position}

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        a, b, c, _ = self.system
        ad, bd, _, _ = sampled(self, self.system, dt)
        after = np.hstack([ad, bd])
        place = c @ after
        if self.discrete:
            before, last = np.hstack([c, np.zeros((1, 2))]), np.eye(1, len(a) + 2, len(a) - 1)
            speed, change = (place - before) / dt, (place - 2.0 * before + last) / dt**2
        else:
            speed = c @ a @ after + np.hstack([0.0 * c, c @ b])
            change = (speed - np.hstack([c @ a, c @ b])) / dt
        return tuple(np.vstack([after, place, speed, change]).ravel().tolist())

    def mobilities(self) -> tuple[float, ...]:
        a, b, c, _ = self.system
        pushed, largest = (float((row @ b[:, 1])[0]) for row, b in ((c @ a, b), (np.abs(c @ a), np.abs(b))))
        return (pushed,) if not self.discrete and pushed > 1e-9 * largest else ()

    def linear(self) -> Any:
        return self

    def linearize(self) -> LinearModel | None:
        """Return the model; None if it is discrete."""
        a, b, c, _ = self.system
        if self.discrete:
            return None
        return LinearModel(a, b, np.vstack([c, c @ a]), np.vstack([0.0 * c @ b, c @ b]), ("command", "load"), ("position", "velocity"))


class StateSpacePlant(LinearPlant):
    """Plant p = C x [m], x' = A x + B u [V], with the command held exactly, or x(k + 1) = A x + B u with a `period`.

    Matrices are lists of numbers, row by row. `load_input` is the column of a load in N; without it a load acts as a command does, in V.
    The velocity is p', in discrete time the last difference. Without an integrator it rests only at 0. Friction needs C A times the column
    of the load above zero: the load pushes the velocity at once.
    """

    kind = "state-space"
    example = {"a": (0.0, 1.0, 0.0, -5.0), "b": (0.0, 2.0), "c": (1.0, 0.0), "load_input": (0.0, 0.1)}
    unbounded = ("a", "b", "c", "load_input")

    a, b, c = MATRICES
    load_input: tuple[float, ...] = param(default=(), vector=True, doc="column of a load in N; without it a load acts as a command, in V")
    period: float = PERIOD

    def given(self, n_input: int = 1) -> System:
        a, b, c, d = super().given()
        if self.load_input:
            object.__setattr__(self, "force_unit", "N")
            if len(self.load_input) != len(a):
                raise ParameterError(
                    f"{self.kind}.load_input", f"{len(self.load_input)} numbers", f"{len(a)}, as A is {len(a)} by {len(a)}"
                )
            b = np.column_stack([b[:, 0], np.array(self.load_input)])
        return a, b, c, d


class TransferFunctionPlant(LinearPlant):
    """Plant numerator/denominator, position over command [m/V], in s with the command held exactly, or in z with a `period`.

    A load acts as a command does, in V. Without an integrator it rests only at 0. Friction needs a degree of the denominator two above that
    of the numerator.
    """

    kind = "transfer-function"
    example = {"numerator": (2.0,), "denominator": (1.0, 5.0, 0.0)}
    unbounded = ("numerator", "denominator")

    numerator, denominator = POLYNOMIALS
    period: float = PERIOD
