"""Models ``frequency-response``, ``linear-motor`` and ``two-inertia``: what an axis does over frequency."""

from __future__ import annotations

from contourlab.features.identify.drives import identify_linear_motor, identify_two_inertia
from contourlab.features.identify.finding import Finding
from contourlab.features.identify.frequency import identify_response
from contourlab.features.identify.requests.request import Request
from contourlab.features.measure.log_choice import positive


def study(request: Request) -> Finding:
    """Measure the frequency response of an axis from one or several logs, and fit the model that was asked for to it."""
    lead = request.travel()
    inertia = None
    if request.motor_inertia is not None:
        inertia = positive("--motor-inertia", request.motor_inertia, "kg*m^2", 'of motor and screw, such as "2 kg*cm^2"')
    records = request.records()
    if request.model == "frequency-response":
        return identify_response(records)
    return identify_linear_motor(records) if request.model == "linear-motor" else identify_two_inertia(records, request.side, lead, inertia)
