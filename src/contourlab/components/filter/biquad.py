"""Notch and low-pass filters of a command.

All are rational functions of second order in s/w, sampled by the bilinear rule with w prewarped: the response is exact at w, and 1 at rest.
The states are the last commands in and out. At rest all of them equal the command, so that a filter can start at any command.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param
from contourlab.engine.step import ports
from contourlab.errors import ParameterError


class Biquad(Component):
    """Base of filters (n_2 q^2 + n_1 q + n_0)/(d_2 q^2 + d_1 q + d_0), q = s/w, w = 2 pi `frequency`, or of first order likewise."""

    family = "filter"
    states = ports("input_1", "input_2", "output_1", "output_2")
    derived = ("b0", "b1", "b2", "a1", "a2")

    frequency: float = param(unit="Hz", minimum=0.0, exclusive=True, doc="below half of the servo frequency, f")

    def polynomials(self, par: Any) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
        """Return n and d in rising powers of q: numbers or arrays (n_variant,)."""
        raise NotImplementedError

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        fastest = np.max(par.frequency)
        if fastest * dt >= 0.5:
            raise ParameterError(f"{self.kind}.frequency", f"{fastest:g}", f"below half of the servo frequency, {0.5 / dt:g}", "Hz")
        warped = np.tan(math.pi * par.frequency * dt)
        upper, lower = (_bilinear(polynomial, warped) for polynomial in self.polynomials(par))
        return (*(b / lower[0] for b in upper), *(a / lower[0] for a in lower[1:]))

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        u = inp.command
        y = par.b0 * u + par.b1 * x.input_1 + par.b2 * x.input_2 - par.a1 * x.output_1 - par.a2 * x.output_2
        return (u, x.input_1, y, x.output_1), (y,)

    def linearize(self) -> LinearModel:
        above, below = (np.array(polynomial, dtype=float) for polynomial in self.polynomials(self))
        n = below.size - 1
        size = (2.0 * math.pi * self.frequency) ** np.arange(n, -1, -1)
        above, below = above * size / below[-1], below * size / below[-1]
        a = np.eye(n, k=1)
        a[-1] = -below[:-1]
        c = above[:-1] - above[-1] * below[:-1]
        return LinearModel(a, np.eye(n)[:, -1:], c[None, :], above[-1:, None], ("command",), ("command",))


def _bilinear(polynomial: tuple[Any, ...], warped: Any) -> tuple[Any, Any, Any]:
    """Return a polynomial of q = (z - 1)/(z + 1)/K, times (K (z + 1))^n, in falling powers of z; K = tan(w dt/2)."""
    if len(polynomial) == 2:
        p0, p1 = polynomial
        return p0 * warped + p1, p0 * warped - p1, 0.0 * warped
    p0, p1, p2 = polynomial
    return p2 + p1 * warped + p0 * warped**2, 2.0 * (p0 * warped**2 - p2), p2 - p1 * warped + p0 * warped**2


class Notch(Biquad):
    """Band-stop filter (s^2 + 2 D_n w s + w^2)/(s^2 + 2 D w s + w^2): its gain at w is D_n/D.

    Its zeros cancel the poles of a resonance at w with the damping ratio D_n. A larger D tolerates a resonance that moves; at frequencies
    f well below w the filter lags by 2 (D - D_n) f/w.

    References
    ----------
    Gross, Hamann & Wiegartner, "Electrical Feed Drives in Automation", 2001 (current set-point filters); Ellis, "Control System Design
    Guide", 4th ed., 2012, chapters 9 (filters) and 16 (compliance and resonance); Schmidt & Rehm, "Notch filter tuning for resonant
    frequency reduction in dual inertia systems", IEEE Industry Applications Conference 1999.
    """

    kind = "notch"
    reference = "Schmidt & Rehm 1999"
    example = {"frequency": 60.0, "damping_ratio": 0.5, "numerator_damping_ratio": 0.05}

    damping_ratio: float = param(default=0.5, minimum=0.0, maximum=10.0, exclusive=True, doc="of the poles, D: the width")
    numerator_damping_ratio: float = param(default=0.0, minimum=0.0, maximum=10.0, doc="of the zeros, D_n: D_n/D is the gain at w")

    def polynomials(self, par: Any) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
        return (1.0, 2.0 * par.numerator_damping_ratio, 1.0), (1.0, 2.0 * par.damping_ratio, 1.0)


class LowPass(Biquad):
    """Low-pass w^2/(s^2 + 2 D w s + w^2).

    References
    ----------
    Gross, Hamann & Wiegartner, "Electrical Feed Drives in Automation", 2001 (current set-point filters of second order).
    """

    kind = "low-pass"
    reference = "Gross, Hamann & Wiegartner 2001"
    example = {"frequency": 60.0, "damping_ratio": 0.5}

    damping_ratio: float = param(default=math.sqrt(0.5), minimum=0.0, maximum=10.0, exclusive=True, doc="of the poles, D")

    def polynomials(self, par: Any) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
        return (1.0, 0.0, 0.0), (1.0, 2.0 * par.damping_ratio, 1.0)


class FirstOrderLowPass(Biquad):
    """Low-pass w/(s + w)."""

    kind = "first-order-low-pass"
    reference = "Ellis 2012, chapter 9"
    example = {"frequency": 60.0}

    def polynomials(self, par: Any) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
        return (1.0, 0.0), (1.0, 1.0)
