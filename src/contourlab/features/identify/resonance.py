"""A resonance of an axis from an accelerometer."""

from __future__ import annotations

from collections.abc import Sequence

from contourlab.analysis.identification.resonance import identify_resonance
from contourlab.features.identify.options import Identify
from contourlab.features.identify.records import AxisRecord
from contourlab.features.identify.result import Identification, figures
from contourlab.figures import figure
from contourlab.rendering.charts import traces_chart

UNITS = {"frequency": "Hz", "damping_ratio": "1"}


def identify_ringing(records: Sequence[AxisRecord], options: Identify) -> Identification:
    """Identify the largest resonance in the acceleration of an axis.

    Raises
    ------
    ParameterError
        See `contourlab.analysis.identification.resonance.identify_resonance`.
    """
    (record,) = records
    fit, title = identify_resonance(record.position, record.period), f"Acceleration of axis {record.axis}, {record.source}"
    band, largest = fit.spectrum_frequency, float(fit.predicted.max())
    spectra = {"measured": (band, fit.spectrum / largest), "model": (band, fit.predicted / largest)}
    chart = traces_chart("spectrum", title, ("frequency [Hz]", "power over the model's largest"), spectra, level=None, log_y=True)
    said = f"fitted from {figure(float(band[0]), 'Hz', 4)} to {figure(float(band[-1]), 'Hz', 4)}, {band.size} lines of the spectrum"
    head = "resonance", record.axis, (record.source,), figures(fit, UNITS), None, fit.usable
    return Identification(*head, fit.findings, lines=(said,), charts=(chart,))
