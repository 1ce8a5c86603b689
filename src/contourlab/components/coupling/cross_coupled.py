"""Cross-coupled control by the contour-error vector, with a PID controller."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param
from contourlab.engine.step import Port
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
    reference = "Gecer Ulu, Ulu & Cakmakci, eqs 13-14; Yeh & Hsu 2002"
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
        push = dot(raw, error)
        keep = select(size > par.limit, select(push > 0.0, 0.0, 1.0), 1.0)
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
