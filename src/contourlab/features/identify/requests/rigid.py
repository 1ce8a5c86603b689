"""Models ``rigid`` and ``rigid-by-direction``: inverse dynamics by least squares."""

from __future__ import annotations

from contourlab.analysis.identification.inverse_dynamics import InverseDynamicsSettings
from contourlab.errors import ParameterError
from contourlab.features.identify.finding import Finding
from contourlab.features.identify.requests.request import Request
from contourlab.features.identify.rigid import identify_rigid
from contourlab.features.measure.log_choice import positive

FRICTION = {"rigid": "symmetric", "rigid-by-direction": "asymmetric"}


def study(request: Request) -> Finding:
    """Identify mass, friction and offset of an axis."""
    cutoff = positive("--cutoff", request.cutoff, "Hz", 'a frequency, such as "100 Hz"')
    slowest = 0.0 if request.slowest is None else positive("--slowest", request.slowest, "m/s", 'a speed, such as "1 mm/s"')
    if request.full_scale is not None:
        raise ParameterError("--full-scale", request.full_scale, f"left out: model {request.model} takes forces, by --gain")
    if len(request.choices) > 1:
        raise ParameterError("LOG", f"{len(request.choices)} logs", f"one: model {request.model} takes a single run and --validation")
    # Settings have the names of their options: where one was typed, the command line calls it so.
    settings = InverseDynamicsSettings(FRICTION[request.model], cutoff=cutoff, decimation=request.decimation, slowest=slowest)
    return identify_rigid(request.record(), settings, request.second())
