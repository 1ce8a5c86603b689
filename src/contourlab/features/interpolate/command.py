"""``contourlab interpolate``: from a file of quadrature signals to constants, errors and counts."""

from __future__ import annotations

import re
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from contourlab.analysis.encoder.interpolation import interpolation_order
from contourlab.analysis.encoder.quadrature import QuadratureConstants, fit_ellipse, track_ellipse
from contourlab.app.folder import spared
from contourlab.errors import ParameterError, UnitError
from contourlab.features.interpolate.record import InterpolatedRecord
from contourlab.features.interpolate.signals import read_quadrature
from contourlab.features.interpolate.text import counts_csv, summary_json, summary_text
from contourlab.logs.error_context import about
from contourlab.units import to_si

PLACES = {"counts": "interpolated.csv", "picture": "interpolation.png", "summary": "interpolation.json"}
"""What is written, in the folder."""
MICRO, MU = "\u00b5", "\u03bc"


@dataclass(frozen=True)
class Interpolated:
    """What was found.

    Parameters
    ----------
    sound : bool
        Whether no whole period can have been missed, as far as can be told.
    summary : dict
        For ``--json``, in SI.
    text : str
        For people.
    """

    sound: bool
    summary: dict[str, Any]
    text: str


def interpolate_file(
    file: str | Path,
    out: str | Path | None = None,
    *,
    pitch: str = "20 um",
    resolution: str = "25 nm",
    columns: str | None = None,
    reference: str | None = None,
    forgetting: float | None = None,
) -> Interpolated:
    """Correct and interpolate quadrature signals, count them, and say what can be said of their errors.

    Parameters
    ----------
    file : str or Path
        See `contourlab.features.interpolate.signal_file.open_signals`.
    out : str or Path, optional
        Folder for interpolated.csv, interpolation.json and interpolation.png; nothing is written without it.
    pitch, resolution : str
        Travel of one period of the signals, and of one count: the pitch over four times a whole number.
    columns : str, optional
        Names or numbers of the two signals, cosine first: ``"u1,u2"``.
    reference : str, optional
        Name or number of a column with the true position; one called "reference" is taken without being named.
    forgetting : float, optional
        0.9 to 1: correct sample by sample with recursive least squares. By default one ellipse is fitted to all samples.

    Raises
    ------
    ResultError
        If the file is no record of quadrature signals, with its line where there is one.
    LogError
        If its signals tell no ellipse.
    ParameterError, UnitError
        If pitch, resolution or forgetting make no sense.
    OutputError
        If the results cannot be written; then none is.
    """
    period, count = _length("--pitch", pitch, "20 um"), _length("--resolution", resolution, "25 nm")
    order = interpolation_order(period, count)
    if out is not None:
        for name in PLACES.values():
            spared(Path(out) / name, [file])
    record = read_quadrature(file, columns, reference)
    with about(record.source.file, options=("forgetting",)):
        fit = fit_ellipse(record.u1, record.u2)
        circle = QuadratureConstants(amplitude=fit.constants.amplitude)
        tracked = None if forgetting is None else track_ellipse(record.u1, record.u2, circle, forgetting=forgetting)
        constants = fit.constants if tracked is None else tracked.constants()
    judged = InterpolatedRecord(record, period, order, fit, tracked, forgetting, constants)
    summary = judged.summary()
    if out is not None:
        summary["files"] = _write(Path(out), judged, summary)
    return Interpolated(summary["missed"]["n_sample"] == 0, summary, summary_text(summary))


def _length(option: str, text: str, example: str) -> float:
    """Read a length, also one in micrometres by their sign, such as ``20µm``."""
    parted = re.fullmatch(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(\D.*)", text)
    try:
        return to_si(f"{parted[1]} {parted[2].replace(MICRO, 'u').replace(MU, 'u')}" if parted else text, "m")
    except UnitError as error:
        raise ParameterError(option, repr(text), f'a length with its unit, such as "{example}"') from error


def _write(folder: Path, judged: InterpolatedRecord, summary: dict[str, Any]) -> dict[str, str]:
    """Write the files: all of them, or none."""
    from contourlab.features.interpolate.lissajous import LissajousData, lissajous_png
    from contourlab.result.atomic import replacing

    files = {key: str(folder / name) for key, name in PLACES.items()}
    title, after = judged.record.source.file.name, judged.after[:, judged.settled :].T
    names = _legend(summary["subdivisional_error"])
    picture = lissajous_png(LissajousData(title, judged.before.T, after, *judged.over_phase(), names))
    contents = {
        "counts": counts_csv(summary, judged.record.time, judged.counted.counts, judged.position()),
        "picture": picture,
        "summary": summary_json({**summary, "files": files}),
    }
    # The files take their places only when all of them are written.
    with ExitStack() as stack:
        for key, content in contents.items():
            stack.enter_context(replacing(files[key])).write_bytes(content)
    return files


def _legend(errors: dict[str, Any]) -> tuple[str, str]:
    known = errors["against"] == "reference"
    words = ("before", "after") if known else ("before, by the fitted constants", "after, off the circle")
    before, after = (
        f"{word}: {1e9 * errors[key]['peak']:.3g} nm peak" if errors[key] else word
        for key, word in zip(("before", "after"), words, strict=True)
    )
    return before, after
