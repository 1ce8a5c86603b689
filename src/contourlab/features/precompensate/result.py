"""The result of a correction, as JSON and as text."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import ClassVar

import numpy as np

from contourlab.app.json_values import HIDDEN
from contourlab.app.session import Answer, Asked
from contourlab.features.precompensate.passes import PassFigures
from contourlab.figures import figure
from contourlab.findings import Finding
from contourlab.rendering.charts import Chart, traces_chart
from contourlab.rendering.table import Column, Table, paragraphs


@dataclass(frozen=True)
class LeftMove:
    """A cutting move that stays as programmed.

    Attributes
    ----------
    line : int
    reason : str
    """

    line: int
    reason: str


@dataclass(frozen=True, eq=False)
class Precompensated(Answer):
    """A corrected program, and what the passes before it showed.

    Attributes
    ----------
    program, out : str
        The given one, and the one written; empty if none was.
    position : str
        What counted as the tool's position: ``"load"``, ``"motor and model"``, ``"motor"`` or ``"model"``.
    axes : tuple of str
    not_repeating : float or None [m]
        Rms of what differs between runs of the last pass; None if one run cannot tell.
    passes : tuple of PassFigures
        All that were run.
    best : int
        The best of them.
    written : int
        The pass that `out` holds; 0 for none.
    status : str
        ``"next pass"``: run it; ``"done"``: no further pass helps, and it is the best one; ``"no gain"``: none is better than `program`.
    bandwidth : dict of str to float [Hz]
        Of the loop of each axis that moves.
    cutoff : float [Hz]
        Of the robustness filter.
    correction : float [m]
        Largest displacement of the path.
    lines : int
        Short lines in the written program.
    shortest_line : float or None [s]
        Shortest time of one at its feed.
    left : tuple of LeftMove
    findings : tuple of Finding
    """

    ROWS = "passes"
    json_derived: ClassVar = ("gain",)

    program: str
    out: str
    position: str
    axes: tuple[str, ...]
    not_repeating: float | None
    passes: tuple[PassFigures, ...]
    best: int
    written: int
    status: str
    bandwidth: dict[str, float]
    cutoff: float
    correction: float
    lines: int
    shortest_line: float | None
    left: tuple[LeftMove, ...]
    findings: tuple[Finding, ...]
    writer: Callable[[Precompensated], None] | None = field(default=None, metadata=HIDDEN, repr=False)

    def _charts(self) -> Iterator[Chart]:
        numbers = np.array([each.number for each in self.passes], dtype=float)
        figures = {name: (numbers, 1e6 * np.array([getattr(each, name) for each in self.passes])) for name in ("largest", "rms")}
        yield traces_chart("passes", self.program, ("pass", "contour error [um]"), figures, level=None)

    def save(self, folder: str | Path = "corrected.ngc") -> Precompensated:
        """Write the program of the next pass, if it helps, and what was learned.

        Parameters
        ----------
        folder : str or Path
            File of the program.

        Returns
        -------
        Precompensated
            With the name of its file.

        Raises
        ------
        OutputError
            If a file cannot be written.
        """
        saved = replace(self, out=str(folder) if self.written else "")
        assert self.writer is not None
        self.writer(saved)
        return saved

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Check the program."""
        return ["check", self.out, "--machine", asked.settings.machine] if self.written else None

    @property
    def gain(self) -> float | None:
        """Rms error of the program itself over that of the best pass."""
        best = self.passes[self.best].rms
        return self.passes[0].rms / best if best else None

    @property
    def passed(self) -> bool:
        """Whether a program was written and no finding is an error."""
        return self.written > 0 and all(one.entry.severity != "error" for one in self.findings)

    @property
    def text(self) -> str:
        """What does not repeat, the passes, and what was written; if nothing was, this first."""
        repeats = "unknown from one run" if self.not_repeating is None else f"{figure(self.not_repeating, 'um')} rms"
        heads = ("pass", "rms [um]", "largest [um]", "cycle time [s]", "change")
        rows = (
            (
                *(str(one.number), f"{1e6 * one.rms:.2f}", f"{1e6 * one.largest:.1f}", f"{one.duration:.3f}"),
                f"{100.0 * (one.duration / self.passes[0].duration - 1.0):+.2f} %",
                "best" if one.number == self.best else "" if one.in_time else "too slow",
            )
            for one in self.passes
        )
        table = Table([*map(Column, heads), Column("", left=True)], rows=rows)
        lines = [f"does not repeat: {repeats}", f"position: {self.position}, axes {', '.join(self.axes)}", "", table.text()]
        if self.written:
            size, cutoff = figure(self.correction, "um"), figure(self.cutoff, "Hz")
            what = f"{self.lines} lines, path displaced by up to {size}, filtered at {cutoff}"
            lines.append(f"\nwritten: {self.out}, pass {self.written}: {what}")
        else:
            lines.insert(0, "No pass is better than the program itself: nothing is written.\n")
        more = paragraphs(map(str, self.findings))
        return "\n".join([*lines, *(["", more] if more else [])])
