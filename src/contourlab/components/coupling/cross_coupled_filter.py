"""Cross-coupled control by the contour-error vector, with any linear controller."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param
from contourlab.components.coupling.cross_coupled import carried, turning
from contourlab.engine.step import Port, Step
from contourlab.errors import ParameterError
from contourlab.native.generated import generated
from contourlab.primitives import add, lincomb, scale

HIGHEST_ORDER = 4
LEAN = 1e-6
"""Largest real part of a pole over the largest magnitude: rounding of a repeated pole on the imaginary axis."""


class CrossCoupledFilter(Component):
    """Any proper linear control of the contour-error vector, C_cc(s) = K num(s)/den(s) up to fourth order, added to the axes' commands.

    The controller is a chain of nested integrators, each sampled by the trapezoidal rule (Tustin). Its coefficients are those of num and
    den, so that a short period loses no digits, as powers of 1/z would. The states are vectors in the normal plane, carried along the path
    as in `cross-coupled`; in the plane this is u = n C_cc(eps).

    With C_cc = kappa C_fb and identical axes, the coupling divides the contour error by 1 + kappa T.

    References
    ----------
    Gecer Ulu, Ulu & Cakmakci, section 3.2 and eqs (13)-(22).
    """

    family = "coupling"
    kind = "cross-coupled-filter"
    example = {"gain": 2.0, "numerator": (2e-3, 0.5, 4.0), "denominator": (1e-3, 0.3, 2.0)}
    reference = "Gecer Ulu, Ulu & Cakmakci, eqs 13-22"
    unbounded = ("numerator", "denominator")
    states = (Port("tangent", -1), *(Port(f"state_{i}", -1) for i in range(1, HIGHEST_ORDER + 1)))
    inputs = (Port("error_vector", -1), Port("tangent", -1))
    outputs = (Port("correction", -1),)
    derived = ("half", "direct", *(f"{name}_{i}" for name in ("share", "inflow", "back") for i in range(1, HIGHEST_ORDER + 1)))

    gain: float = param(default=1.0, unit="{command}/m", minimum=0.0, display="{command}/mm", doc="K, factor of num/den")
    numerator: tuple[float, ...] = param(vector=True, doc="num(s) in falling powers of s, s in rad/s")
    denominator: tuple[float, ...] = param(vector=True, doc="den(s) in falling powers of s, s in rad/s; no root in the right half plane")

    def check_values(self) -> None:
        num, den = _stripped(self.numerator), _stripped(self.denominator)
        if not den:
            raise ParameterError(f"{self.kind}.denominator", list(self.denominator), "a list with a number other than 0")
        if len(num) > len(den):
            bound = f"of at most the order of the denominator, {len(den) - 1}: an improper controller looks ahead"
            raise ParameterError(f"{self.kind}.numerator", list(self.numerator), bound)
        if len(den) - 1 > HIGHEST_ORDER:
            raise ParameterError(f"{self.kind}.denominator", list(self.denominator), f"of at most order {HIGHEST_ORDER}")
        b, a = self._monic()
        if not np.isfinite([*b, *a]).all():
            raise ParameterError(f"{self.kind}.denominator", list(self.denominator), "a list whose first number is not nearly 0")
        roots = np.roots(a)
        if min(a) < 0.0 or (roots.size and roots.real.max() > LEAN * np.abs(roots).max()):
            raise ParameterError(f"{self.kind}.denominator", list(self.denominator), "without roots right of the imaginary axis")

    def _monic(self) -> tuple[list[float], list[float]]:
        """Return num, padded to the order of den, and den, both over the leading coefficient of den."""
        num, den = _stripped(self.numerator), _stripped(self.denominator)
        filled = [0.0] * (len(den) - len(num)) + num
        with np.errstate(over="ignore"):
            return (np.array(filled) / den[0]).tolist(), (np.array(den) / den[0]).tolist()

    @property
    def order(self) -> int:
        """Order of the controller."""
        return len(_stripped(self.denominator)) - 1

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        b, a = self._monic()
        h, n = 0.5 * dt, self.order
        # The trapezoidal rule makes an algebraic loop of the output: solved here, once.
        inverse = 1.0 / math.fsum(h**i * a[i] for i in range(n + 1))
        direct = inverse * math.fsum(h**i * b[i] for i in range(n + 1))
        unused = [0.0] * (HIGHEST_ORDER - n)
        shares = [inverse * h ** (i - 1) for i in range(1, n + 1)] + unused
        return h, direct, *shares, *b[1:], *unused, *a[1:], *unused

    def make_step(self, n_axis: int = 1) -> Step:
        states, inputs, outputs = self.ports(n_axis)
        parameters = (*self.numeric(), *self.derived)
        return Step(f"coupling/{self.kind}", _make(self.order), parameters, (), "", states[: self.order + 1], inputs, outputs)

    def linear_controller(self) -> LinearModel:
        """Return C_cc in continuous time.

        Returns
        -------
        LinearModel
            From ``contour_error`` [m], along the normal from the tool to the path, to ``correction`` [command] along the same normal.

        >>> CrossCoupledFilter(gain=3.0, numerator=[1.0], denominator=[0.5, 1.0]).linear_controller().a
        array([[-2.]])
        """
        b, a = np.array(self._monic()[0]), np.array(self._monic()[1])
        n = self.order
        # Chain of integrators with output feedback: the form of the step.
        matrix = np.diag(np.ones(max(n - 1, 0)), 1)[:n, :n]
        matrix[:, :1] -= a[1:, None]
        c = self.gain * np.eye(1, n)
        return LinearModel(matrix, (b[1:] - a[1:] * b[0])[:, None], c, np.array([[self.gain * b[0]]]), ("contour_error",), ("correction",))


def _stripped(numbers: tuple[float, ...]) -> list[float]:
    """Return the coefficients from the first that is not zero."""
    first = next((i for i, number in enumerate(numbers) if number != 0.0), len(numbers))
    return list(numbers[first:])


@cache
def _make(order: int) -> Any:
    """Return the step of an order, written out: y = direct e + sum share w; each integrator x = w + h f, w' = x + h f."""
    names = range(1, order + 1)
    lines = ["e, tangent = inp.error_vector, inp.tangent", "turn = turning(x.tangent, tangent)", "y = scale(par.direct, e)"]
    for i in names:
        lines += [f"w{i} = carried(x.state_{i}, tangent, turn)", f"y = lincomb(1.0, y, par.share_{i}, w{i})"]
    for i in reversed(names):
        lines.append(f"f{i} = lincomb(par.inflow_{i}, e, -par.back_{i}, y)")
        if i < order:
            lines.append(f"f{i} = add(f{i}, x{i + 1})")
        lines += [f"x{i} = lincomb(1.0, w{i}, par.half, f{i})", f"n{i} = lincomb(1.0, x{i}, par.half, f{i})"]
    after = ", ".join(["tangent", *(f"n{i}" for i in names)])
    lines.append(f"return ({after},), (scale(par.gain, y),)")
    scope: dict[str, Any] = {"__name__": __name__, "turning": turning, "carried": carried, "add": add, "lincomb": lincomb, "scale": scale}
    return generated("def step(par, x, inp, clock):\n" + "".join(f"    {line}\n" for line in lines), scope, "step")
