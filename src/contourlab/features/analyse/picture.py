"""The coupling in the frequency domain: its loop gain in every direction of the path, and what it makes of the contour error."""

from __future__ import annotations

import numpy as np

from contourlab.analysis.linear.contour_transfer import ContourTransfer
from contourlab.arrays import Array, Complex
from contourlab.report.charts import Chart, Curve, Level, Panel
from contourlab.report.style import scheme_style

FAR = 3.0  # beyond this a loop gain is told by its direction, not its size


def contour_transfer_charts(transfer: ContourTransfer, points: int = 600) -> tuple[Chart, ...]:
    """Return three charts: the loop gain (Nyquist), its distance from -1, and the contour error transfer function over frequency.

    Parameters
    ----------
    transfer : ContourTransfer
    points : int
        Frequencies of a curve.
    """
    w = transfer.loop.frequencies(points)
    margins, names = transfer.margins(), transfer.loop.names
    directions = [(f"along {name}", np.eye(len(names))[i]) for i, name in enumerate(names)]
    if len(names) > 1:
        directions.append(("along the diagonal", np.ones(len(names))))
    if margins.stable and len(names) > 1:
        directions.append(("worst direction", np.array(margins.modulus_direction)))
    looks = [(name, *scheme_style(i, max(2, len(directions)))) for i, (name, _) in enumerate(directions)]
    gains = [transfer.loop_gain(w, direction) for _, direction in directions]
    nyquist = tuple(Curve(*_near(gain), *look) for gain, look in zip(gains, looks, strict=True))
    marked = Curve(np.array([-1.05, -0.95, np.nan, -1.0, -1.0]), np.array([0.0, 0.0, np.nan, -0.05, 0.05]), "−1", "#1d2733")
    said = f"smallest distance from −1: {margins.modulus:.3g}" if margins.stable else "unstable"
    hertz = w / (2.0 * np.pi)
    magnitude = tuple(Curve(hertz, 20.0 * np.log10(np.abs(1.0 / (1.0 + gain))), *look) for gain, look in zip(gains, looks, strict=True))
    distance = Curve(hertz, np.minimum(transfer.distance(w), FAR), "worst of all directions", "#1d2733")
    levels = (Level(margins.modulus, f"modulus margin {margins.modulus:.3g}"),) if margins.stable else ()
    kind = "tangent" if transfer.along else "normal"
    return (
        Chart(
            "coupling-nyquist",
            "Loop gain of the coupling",
            f"Each curve has the {kind} at rest in one direction; {said}.",
            (Panel("real part", "imaginary part", (*nyquist, marked)),),
        ),
        Chart(
            "coupling-modulus",
            "Distance of the loop gain from −1",
            f"The least over all directions of the {kind}, drawn up to {FAR:g}.",
            (Panel("frequency [Hz]", "distance from −1", (distance,), levels, log_x=True),),
        ),
        Chart(
            "coupling-error",
            "Error with coupling over error without",
            "Below 0 dB the coupling makes the contour error smaller.",
            (Panel("frequency [Hz]", "magnitude [dB]", magnitude, (Level(0.0, "no gain"),), log_x=True),),
        ),
    )


def _near(gain: Complex) -> tuple[Array, Array]:
    """Return real and imaginary part, with a gap where the curve is far off."""
    far = np.abs(gain) > FAR
    return np.where(far, np.nan, gain.real), np.where(far, np.nan, gain.imag)
