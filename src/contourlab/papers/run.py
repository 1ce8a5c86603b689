"""``contourlab reproduce``: run the parts of a reproduction and print its rows."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any

from contourlab.app.options import Options
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.errors import ParameterError
from contourlab.figures import grouped
from contourlab.papers.options import Reproduce
from contourlab.papers.rows import CLOSE, COMPUTED, DERIVED, HEADS, IDENTITY, INPUT, OURS, OUTSIDE, Bands, Part, Row, banded
from contourlab.rendering.stages import begin_stage
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.study.checkpoint import said_if_interrupted

FAR = CLOSE[-1]
KINDS = {INPUT: "inputs", DERIVED: "derived", IDENTITY: "identities"}


NEXT = {
    "ghaffari": "compare builtin:ghaffari/demo-stage",
    "gecer_ulu": "compare builtin:gecer-ulu/contour",
    "shahin": "backlash builtin:backlash/part",
    "emps": "run builtin:emps/circle",
    "ubc": "run builtin:ubc/pole-placement",
}
"""The command that goes on from each paper."""


@dataclass(frozen=True, eq=False)
class Reproduction(Answer):
    """The figures of a paper or a log, beside ours.

    Attributes
    ----------
    paper : str
    figures : tuple of Row
    whole : bool
        Whether the text has every row, not only the computed figures.
    """

    ROWS = "figures"

    paper: str
    figures: tuple[Row, ...]
    draw: Callable[[Path, tuple[str, ...]], Any] = field(repr=False)
    whole: bool = False

    @property
    def passed(self) -> bool:
        """Whether every figure stays in its band."""
        return all(row.passed is not False for row in self.figures)

    @property
    def json(self) -> tuple[Row, ...]:
        """The rows."""
        return self.figures

    @property
    def text(self) -> str:
        """The figures as a table."""
        return text_of(self.figures, whole=self.whole)

    def save(self, folder: str | Path = "results", *, plots: Sequence[str] = (), whole: bool = False) -> Reproduction:
        """Draw the pictures of the paper or log into a folder.

        Parameters
        ----------
        folder : str or Path
        plots : sequence of str
            Formats: png, svg or pdf; none by default.
        whole : bool
            Whether the text has every row.

        Returns
        -------
        Reproduction

        Raises
        ------
        OutputError
            If the folder is not writable.
        """
        if plots:
            begin_stage("drawing")
            self.draw(Path(folder), tuple(plots))
        return replace(self, whole=whole)

    def _next(self, asked: Asked) -> Sequence[object]:
        """Use the machine of the paper."""
        return NEXT[self.paper].split()


@question(Reproduce)
def reproduce(paper: str, *, settings: Options, session: Session = QUIET) -> Reproduction:
    """Recompute the figures of a paper or a log, and compare.

    Parameters
    ----------
    paper : str
        ghaffari, gecer_ulu, shahin, emps or ubc.

    Returns
    -------
    Reproduction

    Raises
    ------
    ParameterError
        If there is no such paper.
    LogError
        If a log cannot be read.
    """
    from contourlab.papers.rows import read_bands

    if paper not in NEXT:
        raise ParameterError("paper", repr(paper), f"one of {', '.join(NEXT)}")
    plots = session.saving.get("plots")
    if plots:
        check_pictures(session.folder, plots)  # before work that takes a minute
    study, pictures = (import_module(f"contourlab.papers.{paper}.{part}") for part in ("study", "pictures"))
    stages = session.stages()
    draw: Callable[[Path, tuple[str, ...]], Any] = pictures.draw
    if paper == "emps":
        log = getattr(settings, "log", None)
        parts, draw = study.parts_of(log, getattr(settings, "validation", None)), partial(pictures.draw, log)
    elif paper == "ubc":
        folder = getattr(settings, "log_folder", None)
        parts = study.parts_of(folder, with_unseen=getattr(settings, "unseen", True), stage=stages.begin)
        draw = partial(pictures.draw, folder)
    else:
        parts = study.PARTS
    stages.expect(len(parts) + bool(plots))
    return Reproduction(paper, tuple(run_parts(parts, read_bands(paper), stages.begin)), draw)


ghaffari, gecer_ulu, shahin, emps, ubc = (partial(reproduce.ask, paper) for paper in NEXT)  # type: ignore[attr-defined]


def run_parts(parts: Iterable[Part], bands: Bands, stage: Callable[[str], object] | None = None) -> list[Row]:
    """Compute the rows of all parts.

    Parameters
    ----------
    bands : mapping of (name, case) to (low, high)
        Where each figure has to stay, see `contourlab.papers.rows.read_bands`.
    stage : callable, optional
        Called with the name of each part before it runs.
    """
    rows: list[Row] = []
    with said_if_interrupted(lambda: text_of(rows) if rows else ""):
        for name, rows_of in parts:
            if stage is not None:
                stage(name)
            rows += banded(rows_of(), bands)
    return rows


def check_pictures(folder: str | Path, formats: Sequence[str]) -> None:
    """Check that pictures can be written.

    Raises
    ------
    ParameterError
        If a format is unknown.
    OutputError
        If the folder is not writable.
    """
    from contourlab.app.results import staged
    from contourlab.rendering.plots import write_charts

    write_charts((), folder, formats)
    with staged(folder):
        pass


def text_of(rows: Sequence[Row], *, whole: bool = False) -> str:
    """Return one table of the figures that can be compared, and why some differ; with `whole` all rows instead. Then what they assume."""
    blocks = list(_all(rows)) if whole else [_overview(rows), *_why(rows)]
    blocks += _assumed(rows)
    return "\n\n".join([*blocks, *_missing(rows), *_outside(rows), paragraphs([conclusion(rows)])])


def conclusion(rows: Sequence[Row]) -> str:
    """Return in one sentence how many of the computed figures are close, and how many rows left their bands."""
    evidence = [row for row in rows if _is_evidence(row)]
    counts = [sum(abs(row.off) <= limit for row in evidence) for limit in CLOSE]
    near = ", ".join(f"{count} within {100 * limit:g} %" for limit, count in zip(CLOSE, counts, strict=True))
    outside = sum(row.verdict == OUTSIDE for row in rows)
    n = sum(not row.missing for row in rows)
    held = f"All {n} rows lie in their bands." if not outside else f"{outside} of {n} rows lie outside their bands."
    return f"{len(evidence)} figures computed: {near}, {len(evidence) - counts[-1]} not reached. {held}"


def _is_evidence(row: Row) -> bool:
    """Tell whether a row counts as evidence: a computed figure, under the stated reading, beside another one. A limit kept is none."""
    return _is_compared(row) and not row.limit


def _is_compared(row: Row) -> bool:
    return row.kind == COMPUTED and row.main and row.paper is not None


def _groups(rows: Iterable[Row]) -> list[tuple[str, list[Row]]]:
    """Return rows of equal name and unit together, in the order of the first of them."""
    known = grouped(((row.name, row.unit), row) for row in rows)
    return [(f"{name} [{unit}]" if unit else name, group) for (name, unit), group in known.items()]


def _overview(rows: Sequence[Row]) -> str:
    """Return the table of computed figures by closeness, one line per name, and the counts of all other kinds."""
    steps = zip((0.0, *CLOSE), CLOSE, strict=False)
    heads = [*(f"{100 * low:g}-{100 * high:g} %" for low, high in steps), "beyond", "worst [%]"]
    title = "Computed figures, counted by their distance from the printed or measured one"
    groups, cells = _groups(filter(_is_evidence, rows)), []
    for name, group in groups:
        counts = [sum(low < abs(row.off) <= high for row in group) for low, high in zip((-1.0, *CLOSE), CLOSE, strict=False)]
        worst = max(group, key=lambda row: abs(row.off))
        off = _percent(worst.off) if worst.paper else f"{worst.here:.3g}, not 0"
        cells.append((name, *(str(count or "") for count in (*counts, len(group) - sum(counts))), off))
    others = [f"{count} {words}" for kind, words in KINDS.items() if (count := sum(row.kind == kind for row in rows))]
    readings = sum(row.kind == COMPUTED and not row.main for row in rows)
    others += [f"{readings} under other readings"] if readings else []
    alone = sum(row.kind == COMPUTED and row.main and row.source == OURS for row in rows)
    others += [f"{alone} with nothing to compare with"] if alone else []
    limits = [row for row in rows if row.limit and _is_compared(row)]
    others += [f"{sum(row.agrees for row in limits)} of {len(limits)} limits kept"] if limits else []
    shown = [Table([Column("figure", left=True, prose=True), *map(Column, heads)], title, rows=cells).text()] if groups else []
    return "\n".join([*shown, *([paragraphs([f"Not counted: {', '.join(others)}; --all shows them."])] if others else [])])


def _percent(part: float) -> str:
    return f"{100.0 * part:+.2g}" if abs(part) < 1.0 else f"{100.0 * part:+.0f}"


def _why(rows: Sequence[Row]) -> list[str]:
    """Return the reasons of the computed figures that are not reached, each once."""
    reasons = grouped((row.note, row) for row in rows if _is_compared(row) and (not row.agrees if row.limit else abs(row.off) > FAR))
    lines = [f"{', '.join(dict.fromkeys(row.name for row in group))}: {note or 'no reason known'}." for note, group in reasons.items()]
    return ["\n".join(["Not reached, and why:", paragraphs(lines)])] if lines else []


def _assumed(rows: Sequence[Row]) -> list[str]:
    """Return the readings under which figures are counted."""
    readings = dict.fromkeys(row.reading for row in rows if _is_evidence(row) and row.reading)
    return [paragraphs(f"Stated reading: {reading}." for reading in readings)] if readings else []


def _missing(rows: Sequence[Row]) -> list[str]:
    """Return what is not computed for want of a package."""
    needs = grouped((row.missing, f"{row.name} ({row.case})") for row in rows if row.missing)
    return ["\n".join(["Not computed:", paragraphs(f"{', '.join(names)}: {why}." for why, names in needs.items())])] if needs else []


def _outside(rows: Sequence[Row]) -> list[str]:
    """Return a table of the rows outside their bands."""
    words = (Column(name, left=True, prose=True) for name in ("figure", "case"))
    cells = [
        (row.name, row.case, f"{row.here:.6g}", *(("none", "none") if row.band is None else (f"{limit:.6g}" for limit in row.band)))
        for row in rows
        if row.verdict == OUTSIDE
    ]
    table = Table([*words, *map(Column, ("here", "low", "high"))], rows=cells)
    return [f"Outside their bands:\n{table.text()}"] if cells else []


def _all(rows: Sequence[Row]) -> Iterable[str]:
    """Yield a table of all rows of each name."""
    for title, group in _groups(rows):
        notes = dict.fromkeys(row.note for row in group)
        if len(notes) == 1:
            yield "\n".join([paragraphs([title, *filter(None, notes)]), _table(group).text()])
        else:
            yield "\n".join([title, _table(group, with_notes=True).text()])


def _table(rows: Sequence[Row], *, with_notes: bool = False) -> Table:
    compared = any(row.paper is not None for row in rows)
    origins = dict.fromkeys(HEADS[row.source] for row in rows if row.paper is not None)
    columns = [Column("case", left=True, prose=True), *([Column(" or ".join(origins))] if compared else []), Column("here")]
    columns += [Column("difference"), Column("kind", left=True), Column("verdict", left=True)] if compared else []
    cells = ((row.case, *_figures(row, compared=compared), *([row.note] if with_notes else [])) for row in rows)
    return Table([*columns, *([Column("note", prose=True)] if with_notes else [])], rows=cells)


def _figures(row: Row, *, compared: bool) -> list[str]:
    """Return the cells of a row between its case and its note."""
    here = f"{row.here:.6g}"
    if not compared:
        return [here]
    if row.paper is None:
        return ["", here, "", row.kind, row.verdict]
    return [f"{row.paper:.6g}", here, f"{row.here - row.paper:+.3g}", row.kind, row.verdict]
