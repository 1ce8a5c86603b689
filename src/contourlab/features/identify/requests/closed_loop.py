"""Model ``closed-loop``: a' and b' of an axis behind its disturbance observer."""

from __future__ import annotations

from contourlab.errors import ParameterError, UnitError
from contourlab.features.identify.finding import Finding
from contourlab.features.identify.first_order import identify_behind_observer
from contourlab.features.identify.requests.request import Request
from contourlab.units import split, to_si


def study(request: Request) -> Finding:
    """Identify a' and b' of an axis, by eq (18) where the gains of its loop are given."""
    return identify_behind_observer(request.record(), _gains(request))


def _gains(request: Request) -> tuple[float, float, str] | None:
    """Return K_P and K_V in SI and the unit of the command, which that of K_P names."""
    position, velocity = request.position_gain, request.velocity_gain
    if position is None and velocity is None:
        return None
    if position is None or velocity is None:
        option = "--position-gain" if position is None else "--velocity-gain"
        raise ParameterError(option, "missing", "given with the other one: eq 18 takes both K_P and K_V")
    option, text, wanted = "--position-gain", position, 'command per way, such as "4 full_scale/mm"'
    try:
        unit = split(position)[1].partition("/")[0].strip()
        proportional = to_si(position, f"{unit}/m")
        option, text, wanted = "--velocity-gain", velocity, f'command per speed, such as "0.1 {unit}*s/mm"'
        damping = to_si(velocity, f"{unit}*s/m")
    except UnitError as error:
        raise ParameterError(option, repr(text), wanted) from error
    return proportional, damping, unit
