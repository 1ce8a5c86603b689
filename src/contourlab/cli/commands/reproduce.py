"""``contourlab reproduce``: figures of papers and logs beside ours."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import show, suggest, wants_progress

Plots = Annotated[list[str] | None, typer.Option(help="Also draw the pictures of the paper or log as png, svg or pdf; repeatable.")]
Out = Annotated[Path, typer.Option(help="Folder of the pictures; created if missing.")]
All = Annotated[bool, typer.Option("--all", help="Print every row, not only the table of computed figures.")]
RESULTS = Path("results")
NEXT = {
    "ghaffari": "compare builtin:ghaffari/demo-stage",
    "gecer_ulu": "compare builtin:gecer-ulu/contour",
    "shahin": "backlash builtin:backlash/part",
    "emps": "run builtin:emps/circle",
    "ubc": "run builtin:ubc/pole-placement",
}
"""The command that goes on from each paper."""
Rows = list[Any]
Parts = Callable[[Callable[[str], None]], Sequence[tuple[str, Callable[[], Any]]]]
"""Returns the parts of a reproduction; may use a callable that shows progress."""
Draw = Callable[[Rows, Path, tuple[str, ...]], Any]
"""Draws rows into a folder, in some formats."""
reproduce = typer.Typer(no_args_is_help=True, help="Recompute the figures of a paper or a log, and compare.")


@reproduce.command()
def ghaffari(as_json: shared.Json = False, plots: Plots = None, out: Out = RESULTS, whole: All = False) -> int:
    """Ghaffari and Ulsoy: component swapping modularity for distributed precision contouring; Figs 6 to 9."""
    from contourlab.papers.ghaffari import pictures, study

    return _compared("ghaffari", lambda _: study.PARTS, lambda _, *where: pictures.draw(*where), (as_json, whole), plots, out)


@reproduce.command()
def gecer_ulu(as_json: shared.Json = False, plots: Plots = None, out: Out = RESULTS, whole: All = False) -> int:
    """Gecer Ulu, Ulu and Cakmakci: learning based cross-coupled control for precision positioning; Figs 9 and 10."""
    from contourlab.papers.gecer_ulu import pictures, study

    return _compared("gecer_ulu", lambda _: study.PARTS, lambda _, *where: pictures.draw(*where), (as_json, whole), plots, out)


@reproduce.command()
def shahin(as_json: shared.Json = False, plots: Plots = None, out: Out = RESULTS, whole: All = False) -> int:
    """Shahin, ElMaraghy and ElBeheiry: nonlinearity control of CNC feed drives, backlash and switching controllers; Figs 7 to 13."""
    from contourlab.papers.shahin import pictures, study

    return _compared("shahin", lambda _: study.PARTS, lambda _, *where: pictures.draw(*where), (as_json, whole), plots, out)


@reproduce.command()
def emps(
    log: Annotated[Path | None, typer.Option(help="DATA_EMPS.mat of the benchmark: the log to identify from.")] = None,
    validation: Annotated[Path | None, typer.Option(help="DATA_EMPS_PULSES.mat: a second log, to check the parameters.")] = None,
    as_json: shared.Json = False,
    plots: Plots = None,
    out: Out = RESULTS,
    whole: All = False,
) -> int:
    """Janot, Gautier and Brunot: data set and reference models of the EMPS, a linear axis identified from its log."""
    from contourlab.papers.emps import pictures, study

    def draw(_: Rows, *where: Any) -> Any:
        return pictures.draw(log, *where)

    return _compared("emps", lambda _: study.parts_of(log, validation), draw, (as_json, whole), plots, out)


@reproduce.command()
def ubc(
    log_folder: Annotated[Path | None, typer.Option(help="Folder with line_circle_lli.mat and line_circle_pp.mat.")] = None,
    unseen: Annotated[bool, typer.Option(help="Also fit with parts of the runs left out; takes minutes.")] = True,
    as_json: shared.Json = False,
    plots: Plots = None,
    out: Out = RESULTS,
    whole: All = False,
) -> int:
    """XY table of the UBC course MECH 467: two measured line-circle runs and the machine identified from them."""
    from contourlab.papers.ubc import pictures, study

    def parts(stage: Callable[[str], None]) -> Sequence[Any]:
        return study.parts_of(log_folder, with_unseen=unseen, stage=stage)

    return _compared("ubc", parts, lambda _, *where: pictures.draw(log_folder, *where), (as_json, whole), plots, out)


def _compared(paper: str, parts_of: Parts, draw: Draw, form: tuple[bool, bool], plots: Sequence[str] | None, out: Path) -> int:
    """Compute the rows of a paper, draw and print them, and the following command; return 1 if a row leaves its band."""
    from contourlab.papers.rows import read_bands
    from contourlab.papers.run import check_pictures, run_parts, text_of
    from contourlab.rendering.stages import shown

    as_json, whole = form
    if plots:
        check_pictures(out, tuple(plots))  # before work that takes a minute
    with shown(wants_progress(as_json)) as stages:
        parts = parts_of(stages.begin)
        stages.expect(len(parts) + bool(plots))
        rows = run_parts(parts, read_bands(paper), stages.begin)
        if plots:
            stages.begin("drawing")
            draw(rows, out, tuple(plots))
    show(rows, text_of(rows, whole=whole), as_json)
    suggest(as_json, *NEXT[paper].split())
    return 1 if any(row.passed is False for row in rows) else 0
