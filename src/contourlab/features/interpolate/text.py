"""Text, count table and picture of ``contourlab interpolate``."""

from __future__ import annotations

import io
import math
from collections.abc import Iterator, Sequence

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.features.interpolate.study import Interpolated
from contourlab.rendering.style import scheme_style
from contourlab.rendering.table import paragraphs


def text(result: Interpolated) -> str:
    """Return the result for the terminal."""
    return "\n".join(paragraphs([f"  {name:<22}{value}"], indent=" " * 24) if name else value for name, value in _rows(result))


def _rows(r: Interpolated) -> Iterator[tuple[str, str]]:
    constants, errors, counts = r.constants, r.subdivisional_error, r.counts
    unit = f" {constants['unit']}".rstrip()
    yield "", f"{r.file}: {r.n_sample} samples of {' and '.join(r.columns)}"
    yield "pitch", f"{1e6 * r.pitch:.6g} um; travel {r.travel / r.pitch:.5g} pitches ({1e3 * r.travel:.6g} mm)"
    yield "resolution", f"{1e9 * r.resolution:.6g} nm: {r.order} sine periods per pitch, counted fourfold"
    if r.method == "recursive":
        yield "fit", f"recursive, forgetting {r.forgetting:g}, {r.updates} updates; final constants:"
    else:
        yield "fit", "one ellipse through all samples:"
    yield "  offsets", f"{constants['offset_1']:.5g} and {constants['offset_2']:.5g}{unit}"
    yield "  amplitude", f"{constants['amplitude']:.5g}{unit}, {constants['ratio']:.6g} times that of the second signal"
    yield "  phase error", f"{math.degrees(constants['phase_error']):.4g} deg"
    yield "  scatter", f"{100.0 * r.scatter:.3g} % of the radius, rms around the ellipse through all samples"
    for name in ("before", "after"):
        if (error := errors[name]) is not None:
            orders = ", ".join(f"{1e9 * value:.3g}" for value in error["orders"][:4])
            yield f"error {name}", f"{1e9 * error['peak']:.4g} nm peak within a pitch; orders 1 to 4 of a pitch: {orders} nm"
    yield "counts", f"from {counts['first']} to {counts['last']}, smallest {counts['least']}, largest {counts['greatest']}"
    yield "fastest", f"{r.fastest:.3g} pitches per sample; counting works up to 0.5"
    for file in r.files.values():
        yield "written", file
    if r.findings:
        yield "", paragraphs(map(str, r.findings))


def counts_csv(r: Interpolated, time: Array | None, counts: Index, position: Array) -> bytes:
    """Return the table of counts and positions, with pitch and constants in its head."""
    constants = ", ".join(f"{name} {value!r}" for name, value in r.constants.items() if name != "unit")
    unit = f" ({r.constants['unit']})" if r.constants["unit"] else ""
    head = [f"# pitch {r.pitch:.12g} m, resolution {r.resolution:.12g} m, fit: {r.method}", f"# {constants}{unit}"]
    rows = [f"{n},{x:.12g}" for n, x in zip(counts.tolist(), position.tolist(), strict=True)]
    if time is not None:
        rows = [f"{t:.12g},{row}" for t, row in zip(time.tolist(), rows, strict=True)]
    return ("\n".join([*head, "count,position [m]" if time is None else "t [s],count,position [m]", *rows]) + "\n").encode()


# --- the two signals against each other before and after correction, and the error over a period ------------------------------------

POINTS = 6000


def lissajous_png(title: str, signals: Sequence[Array], phase: Array, errors: Sequence[Array], names: Sequence[str]) -> bytes:
    """Return the picture as a PNG of 200 dpi; equal data give equal bytes.

    Parameters
    ----------
    title : str
    signals : sequence of ndarray (n, 2)
        As measured, and corrected; both divided by the amplitude.
    phase : ndarray (m,) [deg]
    errors : sequence of ndarray (m,) [nm]
        Over the phase, before and after correction.
    names : sequence of str
        Of the two errors, for the legend.
    """
    import matplotlib
    from matplotlib.figure import Figure

    from contourlab.rendering.matplotlib_view import LOOKS, WIDTH

    with matplotlib.rc_context(fname=LOOKS):
        figure = Figure(figsize=(WIDTH, 3.6), layout="constrained")
        left, right = figure.subplots(1, 2, width_ratios=(1.0, 1.25))
        every = max(1, len(signals[0]) // POINTS)
        turn = np.linspace(0.0, 2.0 * np.pi, 361)
        left.plot(np.cos(turn), np.sin(turn), color="#8a949e", linewidth=0.8)
        for i, points in enumerate(signals):
            style = {"linestyle": "none", "marker": ".", "markersize": 1.6, "color": scheme_style(i, 2)[0]}
            left.plot(points[::every, 0], points[::every, 1], **style)
        left.set_aspect("equal", adjustable="datalim")
        left.set(xlabel="u1 / amplitude", ylabel="u2 / amplitude", title=title.replace("$", "\\$"))
        for i, (name, error) in enumerate(zip(names, errors, strict=True)):
            right.plot(phase, error, color=scheme_style(i, 2)[0], linewidth=1.1, label=name)
        right.set(xlabel="phase [deg]", ylabel="error within a pitch [nm]", xlim=(0.0, 360.0), xticks=range(0, 361, 90))
        figure.legend(*right.get_legend_handles_labels(), loc="outside lower left", ncols=2)
        buffer = io.BytesIO()
        figure.savefig(buffer, format="png")
    return buffer.getvalue()
