"""Controllers given by matrices or by a transfer function."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from contourlab.components.contract import LinearModel, param
from contourlab.components.controller.law import ControlLaw
from contourlab.components.linear_part import EDGE, MATRICES, METHOD, PERIOD, POLYNOMIALS, LinearPart, System, checked
from contourlab.engine.step import ports
from contourlab.errors import ParameterError, refuse
from contourlab.primitives import dot

SIGNALS = ("reference", "position", "reference_velocity", "velocity")
"""Inputs of a controller with several; one with a single input gets the position error."""


class LinearLaw(LinearPart, ControlLaw):
    """Base of controllers y = C x + D w, x' = A x + B w: command = y + feedforward - disturbance estimate.

    w is the position error r - p (one input), (r, p) or (r, p, r', v), as the number of numbers in D says. Its poles lie on or inside the
    edge of stability. It has no limit and no anti-windup: states that integrate wind up while the drive saturates.
    """

    inputs = ports("reference", "position", "disturbance_estimate", "feedforward")

    def check_values(self) -> None:
        system = checked(self, self.given(), EDGE)
        n, m = system[1].shape
        self.prepare(system, n + 1, n + m)
        object.__setattr__(self, "inputs", ports(*SIGNALS[: max(m, 2)], "disturbance_estimate", "feedforward"))

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        """Return the states that hold with reference and position there, if there are any; else zero."""
        a, b, _, _ = self.system
        n, m = b.shape
        change = a - np.eye(n) * self.discrete
        wanted = -b[:, :2].sum(axis=1) * (m > 1)
        place = np.linalg.lstsq(change, wanted)[0]
        met = np.allclose(change @ place, wanted, rtol=1e-9, atol=1e-9 * float(np.abs(wanted).max(initial=0.0)))
        return {port.name: position * (float(one) if met else 0.0) for port, one in zip(self.states, place, strict=True)}, {}

    def step_function(self) -> Any:
        return _law(*self.system[1].shape)

    def linearize(self) -> LinearModel | None:
        """Return the model; None if it is discrete."""
        a, b, c, d = self.system
        if self.discrete:
            return None
        if b.shape[1] == 1:
            b, d = (np.hstack([matrix, -matrix]) for matrix in (b, d))
        b = np.pad(b, ((0, 0), (0, 2)))
        return LinearModel(a, b, c, np.hstack([d, [[-1.0, 1.0]]]), tuple(port.name for port in self.inputs), ("command",))


@cache
def _law(n: int, m: int) -> Any:
    width = n + m

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        u = (*x, inp.reference - inp.position) if m == 1 else (*x, *inp[:m])
        y = tuple(dot(par[i * width : (i + 1) * width], u) for i in range(n + 1))
        return y[:n], (y[n] + inp.feedforward - inp.disturbance_estimate,)

    return step


class StateSpaceController(LinearLaw):
    """Controller y = C x + D w, x' = A x + B w, or x(k + 1) = A x + B w with a `period`; command = y + feedforward - estimate.

    w is the position error r - p if D has one number, (r, p) with two, and (r, p, r', v) with four. Without A, B and C it is a static gain,
    such as that of a linear-quadratic regulator, D = (k_1, -k_1, k_2, -k_2). Matrices are lists of numbers, row by row; positions are in m,
    velocities in m/s, A in continuous time in 1/s. It has no limit and no anti-windup: states that integrate wind up at a limit of the
    drive.
    """

    kind = "state-space"
    example = {"a": (-40.0,), "b": (3e4, -3e4, 10.0, -20.0), "c": (1e-3,), "d": (9.0, -9.0, 0.3, -0.2)}
    unbounded = ("a", "b", "c", "d")

    a, b, c = MATRICES
    d: tuple[float, ...] = param(vector=True, doc="D; one, two or four numbers, one for each input")
    method: str = METHOD
    period: float = PERIOD

    def given(self, n_input: int = 1) -> System:
        m = len(self.d)
        refuse(m not in (1, 2, 4), ParameterError, f"{self.kind}.d", f"{m} numbers", "1 (error), 2 (r, p) or 4 (r, p, r', v)")
        return super().given(m)


class TransferFunctionController(LinearLaw):
    """Controller numerator/denominator of the position error [command/m], in s, or in z with a `period`.

    It has no limit and no anti-windup: an integral winds up at a limit of the drive.
    """

    kind = "transfer-function"
    example = {"numerator": (20.0, 900.0, 2000.0), "denominator": (1e-3, 1.0, 0.5)}
    unbounded = ("numerator", "denominator")

    numerator, denominator = POLYNOMIALS
    method: str = METHOD
    period: float = PERIOD
