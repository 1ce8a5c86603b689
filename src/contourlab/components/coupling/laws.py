"""Couplings: cross-coupled control by the contour-error vector, and references modified by the contour error."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param
from contourlab.engine.step import Port, Step, ports
from contourlab.errors import ParameterError
from contourlab.native.generated import generated
from contourlab.primitives import add, dot, lincomb, maximum, minimum, scale, select, sqrt, sub

REVERSAL = 1e-6
"""1 + t0.t1 below which the path turns back on itself: the least rotation is undefined."""


def turning(last: Any, tangent: Any) -> Any:
    """Return h of the least rotation from unit tangent t0 to t1: v -> v - (t1.v) h for a vector v normal to t0.

    h = (t0 + t1)/(1 + t0.t1). Where the path turns back on itself, and without a last tangent (a vector of zeros), h = t1: vectors normal
    to t1 stay unchanged.

    References
    ----------
    Bishop, "There is more than one way to frame a curve", American Mathematical Monthly 82 (1975).
    """
    sum_one = 1.0 + dot(last, tangent)
    back = sum_one < REVERSAL
    share = 1.0 / select(back, 1.0, sum_one)
    return lincomb(select(back, 0.0, share), last, share, tangent)


def carried(vector: Any, tangent: Any, turn: Any) -> Any:
    """Return a vector normal to the last tangent, rotated by `turn` of `turning`: it is normal to the new tangent."""
    return lincomb(1.0, vector, -dot(tangent, vector), turn)


class CrossCoupled(Component):
    """PID control of the contour-error vector, C_cc(s) = K (1 + k_i/s + T_d s/(1 + T_f s)), added to the axes' commands.

    In the plane it is u = n C_cc(eps), eps the error along the normal n. In space the normal plane has more than one direction, so the
    states are vectors in it. Parallel transport (the least rotation from each tangent to the next) carries them along the path; in the
    plane this is the scalar form. Where the path turns back on itself, within 1.4 mrad, the vectors keep their direction in space. Any
    number of axes. Zero gains give P and PI control.

    With an estimator whose error vector is eps times the gain vector C (koren-lo), K alone gives C K eps.

    The integral stops if the error would drive it further while the output is at its limit, or while drives have not accepted the last
    commands in full. All axes must have the same command unit.

    References
    ----------
    Gecer Ulu, Ulu & Cakmakci, section 3.2 and eqs (13)-(14); Yeh & Hsu, IEEE/ASME Trans. Mechatronics 7 (2002); Koren 1980 and Koren & Lo
    1991 by their estimators.
    """

    family = "coupling"
    kind = "cross-coupled"
    calibrated = ("gain", "integral_rate", "derivative_time")
    example = {"gain": 3.0, "integral_rate": 20.0, "derivative_time": 5e-3, "derivative_filter": 2e-3, "limit": 2.0}
    reference = "Gecer Ulu, Ulu & Cakmakci 2016, eqs 13-14; Yeh & Hsu 2002; Bishop 1975"
    states = (Port("integral", -1), Port("filtered", -1), Port("tangent", -1))
    inputs = (Port("error_vector", -1), Port("tangent", -1), Port("command", -1), Port("accepted", -1))
    outputs = (Port("correction", -1),)
    derived = ("integral_step", "filter_weight", "derivative_rate")

    gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="correction per contour error, K")
    integral_rate: float = param(default=0.0, unit="1/s", minimum=0.0, doc="one over the integral time, k_i; 0: no integral")
    derivative_time: float = param(default=0.0, unit="s", minimum=0.0, display="ms", doc="derivative time, T_d; 0: no derivative")
    derivative_filter: float = param(default=1e-3, unit="s", minimum=0.0, exclusive=True, display="ms", doc="derivative's low-pass, T_f")
    limit: float = param(default=math.inf, unit="{command}", minimum=0.0, exclusive=True, doc="largest length of the correction")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        # Backward Euler: exact for the slope of a ramp.
        window = par.derivative_filter + dt
        return par.integral_rate * dt, dt / window, par.derivative_time / window

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        error, tangent = inp.error_vector, inp.tangent
        turn = turning(x.tangent, tangent)
        before = carried(x.integral, tangent, turn)
        filtered = carried(x.filtered, tangent, turn)
        news = sub(error, filtered)
        integral = lincomb(1.0, before, par.integral_step, error)
        raw = scale(par.gain, add(error, lincomb(1.0, integral, par.derivative_rate, news)))
        size = sqrt(dot(raw, raw))
        keep = select(size > par.limit, select(dot(raw, error) > 0.0, 0.0, 1.0), 1.0)
        keep = select(dot(sub(inp.command, inp.accepted), error) > 0.0, 0.0, keep)
        integral = lincomb(1.0, before, keep * par.integral_step, error)
        correction = scale(minimum(1.0, par.limit / maximum(size, 1e-300)), raw)
        return (integral, lincomb(1.0, filtered, par.filter_weight, news), tangent), (correction,)

    def linear_controller(self) -> LinearModel:
        """Return C_cc in continuous time, within its limit.

        Returns
        -------
        LinearModel
            From ``contour_error`` [m], along the normal from the tool to the path, to ``correction`` [command] along the same normal;
            without unused states.

        >>> CrossCoupled(gain=2.0).linear_controller().d
        array([[2.]])
        """
        rates, inflow, gains, direct = [], [], [], self.gain
        if self.integral_rate > 0.0:
            rates, inflow, gains = [0.0], [1.0], [self.gain * self.integral_rate]
        if self.derivative_time > 0.0:
            pole, share = 1.0 / self.derivative_filter, self.gain * self.derivative_time / self.derivative_filter
            rates, inflow, gains = [*rates, -pole], [*inflow, pole], [*gains, -share]
            direct += share
        b, c = np.array(inflow).reshape(-1, 1), np.array(gains).reshape(1, -1)
        return LinearModel(np.diag(rates), b, c, np.array([[direct]]), ("contour_error",), ("correction",))


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
    reference = "Gecer Ulu, Ulu & Cakmakci 2016, eqs 13-22"
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


class _Modified(Component):
    family = "coupling"
    calibrated = ("weight",)
    example = {"weight": 0.75}
    inputs = ports("reference", "position", "foot_position", "error_vector", size=-1)
    outputs = (Port("modified_reference", -1),)

    weight: float = param(default=0.75, minimum=0.0, maximum=0.99, doc="lambda: weight of the contour error against the tracking error")


class ModifiedReference(_Modified):
    """r' = (1 - lambda) r(theta) + lambda r(theta_hat): the axes follow a point between reference and foot point.

    Since r' - p = (1 - lambda)(r - p) + lambda (r(theta_hat) - p), the error across the path keeps its gain and the error along it is
    weighted by 1 - lambda: contouring has priority over progress. Raise lambda together with the gains; alone it makes the tool lag.

    References
    ----------
    Ghaffari & Ulsoy, "Component swapping modularity for distributed precision contouring", section II and Fig 3.
    """

    kind = "modified-reference"
    reference = "Ghaffari & Ulsoy 2017, section II"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (lincomb(1.0 - par.weight, inp.reference, par.weight, inp.foot_position),)


class ModifiedError(_Modified):
    """e' = (1 - lambda)(r - p) + lambda e_n, with e_n the contour-error vector, in place of each axis' own error.

    It is the modified reference with the projection on the normal in place of the vector to the foot point: the two are equal once the
    estimator has converged. The axes receive it as the reference p + e'.

    References
    ----------
    Ghaffari & Ulsoy, "Dynamic contour error estimation and feedback modification for high-precision contouring", IEEE/ASME Transactions on
    Mechatronics 21 (2016).
    """

    kind = "modified-error"
    reference = "Ghaffari & Ulsoy 2016"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (add(inp.position, lincomb(1.0 - par.weight, sub(inp.reference, inp.position), par.weight, inp.error_vector)),)
