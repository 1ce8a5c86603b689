"""``contourlab interpolate``: constants, errors and counts from a file of quadrature signals."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from contourlab.analysis.encoder import interpolation_order
from contourlab.app.json_values import json_text
from contourlab.app.results import spared
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.features.interpolate.options import Interpolate
from contourlab.features.interpolate.study import Interpolated, Interpolation, read_quadrature
from contourlab.features.interpolate.text import counts_csv, lissajous_png, text
from contourlab.logs.load import about

FILES = {"counts": "interpolated.csv", "picture": "interpolation.png", "summary": "interpolation.json"}
"""Files written into the folder."""


@dataclass(frozen=True, eq=False)
class Counts(Answer):
    """Interpolated signals of an encoder.

    Attributes
    ----------
    result : Interpolated
    interpolation : Interpolation
    """

    result: Interpolated
    interpolation: Interpolation = field(repr=False)

    @property
    def passed(self) -> bool:
        """Whether no period was missed."""
        return not self.result.missed["n_sample"]

    @property
    def json(self) -> Any:
        """The result."""
        return self.result

    @property
    def text(self) -> str:
        """The result for the terminal."""
        return text(self.result)

    def save(self, folder: str | Path | None = "interpolated") -> Counts:
        """Write interpolated.csv, interpolation.json and interpolation.png into a folder; all or none.

        Parameters
        ----------
        folder : str or Path, optional
            None writes nothing.

        Returns
        -------
        Counts
            With the names of its files.

        Raises
        ------
        OutputError
            If a result cannot be written; then nothing is written.
        """
        return self if folder is None else replace(self, result=_written(Path(folder), self.interpolation, self.result))

    def _next(self, asked: Asked) -> Sequence[object]:
        """Save the counts, or use the encoder."""
        return ["components", "quadrature-encoder"] if self.result.files else asked.again("--out", "interpolated")


@question(Interpolate)
def interpolate(file: str | Path, *, settings: Interpolate, session: Session = QUIET) -> Counts:
    """Correct, interpolate and count quadrature signals, and measure their errors.

    Parameters
    ----------
    file : str or Path
        A table of numbers; see `contourlab.logs.delimited.read`.

    Returns
    -------
    Counts

    Raises
    ------
    LogError, ResultError
        If the file has no quadrature signals, or they do not form an ellipse; with the line if known.
    ParameterError, UnitError
        If pitch, resolution or forgetting are out of range.
    """
    period = settings.si("pitch")
    order = interpolation_order(period, settings.si("resolution"))
    if session.saving.get("out") is not None:
        for name in FILES.values():
            spared(session.folder / name, [file])
    record = read_quadrature(file, settings.columns, settings.reference)
    with about(record.source.file, options=("forgetting",)):
        interpolation = Interpolation(record, period, order, settings.forgetting)
    return Counts(interpolation.result(), interpolation)


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
