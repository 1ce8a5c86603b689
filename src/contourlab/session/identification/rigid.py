"""Models ``rigid`` and ``rigid-by-direction``: inverse dynamics by least squares."""

from __future__ import annotations

from contourlab.analysis.inverse_dynamics import InverseDynamicsSettings
from contourlab.errors import ParameterError
from contourlab.session.identification.request import Request
from contourlab.session.log_choice import positive
from contourlab.studies.identification.finding import Finding
from contourlab.studies.identification.rigid import identify_rigid

__all__ = ["study"]

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
