"""``contourlab interpolate``: constants, errors and counts from a file of quadrature signals."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import Any

from contourlab.analysis.encoder.interpolation import interpolation_order
from contourlab.app.json_values import json_text
from contourlab.app.results import spared
from contourlab.errors import ParameterError, UnitError
from contourlab.features.interpolate.study import Interpolated, Interpolation, read_quadrature
from contourlab.features.interpolate.text import counts_csv, lissajous_png
from contourlab.logs.load import about
from contourlab.units import to_si

FILES = {"counts": "interpolated.csv", "picture": "interpolation.png", "summary": "interpolation.json"}
"""Files written into the folder."""


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
    """Correct, interpolate and count quadrature signals, and measure their errors.

    Parameters
    ----------
    file : str or Path
        A table of numbers; see `contourlab.logs.delimited.read`.
    out : str or Path, optional
        Folder for interpolated.csv, interpolation.json and interpolation.png; without it nothing is written.
    pitch, resolution : str
        Travel per period of the signals, and per count. The resolution must be the pitch over four times a whole number.
    columns : str, optional
        Names or numbers of the two signals, cosine first: ``"u1,u2"``.
    reference : str, optional
        Name or number of the column of the true position; by default "reference", if present.
    forgetting : float, optional
        0.9 to 1: correct sample by sample with recursive least squares. By default one ellipse is fitted to all samples.

    Raises
    ------
    LogError, ResultError
        If the file has no quadrature signals, or they do not form an ellipse; with the line if known.
    ParameterError, UnitError
        If pitch, resolution or forgetting are out of range.
    OutputError
        If a result cannot be written; then nothing is written.
    """
    period, count = _length("--pitch", pitch, "20 um"), _length("--resolution", resolution, "25 nm")
    order = interpolation_order(period, count)
    if out is not None:
        for name in FILES.values():
            spared(Path(out) / name, [file])
    record = read_quadrature(file, columns, reference)
    with about(record.source.file, options=("forgetting",)):
        interpolation = Interpolation(record, period, order, forgetting)
    result = interpolation.result()
    return result if out is None else _written(Path(out), interpolation, result)


def _length(option: str, text: str, example: str) -> float:
    try:
        return to_si(text, "m")
    except UnitError as error:
        raise ParameterError(option, repr(text), f'a length with its unit, such as "{example}"') from error


def _written(folder: Path, interpolation: Interpolation, result: Interpolated) -> Interpolated:
    """Write all files or none; return the result with their names."""
    from contourlab.result.atomic import replacing

    result = replace(result, files={key: str(folder / name) for key, name in FILES.items()})
    title, after = interpolation.record.source.file.name, interpolation.after[:, interpolation.settled :].T
    phase, *errors = interpolation.over_phase()
    names = _legend(result.subdivisional_error)
    contents = {
        "counts": counts_csv(result, interpolation.record.time, interpolation.counted.counts, interpolation.position()),
        "picture": lissajous_png(title, (interpolation.before.T, after), phase, errors, names),
        "summary": (json_text(result) + "\n").encode(),
    }
    # Put the files in place only after all of them are written.
    with ExitStack() as stack:
        for key, content in contents.items():
            stack.enter_context(replacing(result.files[key])).write_bytes(content)
    return result


def _legend(errors: dict[str, Any]) -> tuple[str, str]:
    known = errors["against"] == "reference"
    labels = ("before", "after") if known else ("before, by the fitted constants", "after, off the circle")
    before, after = (
        f"{label}: {1e9 * errors[key]['peak']:.3g} nm peak" if errors[key] else label
        for key, label in zip(("before", "after"), labels, strict=True)
    )
    return before, after
