"""``contourlab reproduce``: figures of papers and logs beside ours."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from contourlab.cli.output import emit_json, show, wants_progress

Json = Annotated[bool, typer.Option("--json", help="Print JSON alone on standard output.")]
Rows = list[dict[str, Any]]
Part = tuple[str, Callable[[], Any]]
Parts = Callable[[Callable[[str], None]], Sequence[Part]]
"""Returns the parts of a reproduction; may use a callable that shows progress."""
Draw = Callable[[Rows, Path, tuple[str, ...]], Any]
"""Draws rows into a folder, in some formats."""
reproduce = typer.Typer(no_args_is_help=True, help="Compute the figures of a paper or a log again and compare.")


@reproduce.command()
def ghaffari(
    as_json: Json = False,
    plots: Annotated[list[str] | None, typer.Option(help="Also draw Figs 6 and 7 as png, svg or pdf; may be given again.")] = None,
    out: Annotated[Path, typer.Option(help="Folder of the pictures; made if it is not there.")] = Path("results"),
) -> int:
    """Ghaffari and Ulsoy: component swapping modularity for distributed precision contouring."""
    from contourlab.papers.ghaffari import pictures, study

    return _compared(lambda _: study.PARTS, lambda _, *where: pictures.draw(*where), as_json, plots, out)


@reproduce.command()
def gecer_ulu(
    as_json: Json = False,
    plots: Annotated[list[str] | None, typer.Option(help="Also draw Figs 9 and 10 as png, svg or pdf; may be given again.")] = None,
    out: Annotated[Path, typer.Option(help="Folder of the pictures; made if it is not there.")] = Path("results"),
) -> int:
    """Gecer Ulu, Ulu and Cakmakci: modular learning based cross-coupled control for multi-axis precision positioning systems."""
    from contourlab.papers.gecer_ulu import pictures, study

    return _compared(lambda _: study.PARTS, pictures.draw, as_json, plots, out)


@reproduce.command()
def shahin(
    as_json: Json = False,
    plots: Annotated[list[str] | None, typer.Option(help="Also draw Figs 7 to 13 as png, svg or pdf; may be given again.")] = None,
    out: Annotated[Path, typer.Option(help="Folder of the pictures; made if it is not there.")] = Path("results"),
) -> int:
    """Shahin, ElMaraghy and ElBeheiry: nonlinearity control of CNC feed drives, backlash and switching controllers."""
    from contourlab.papers.shahin import pictures, study

    return _compared(lambda _: study.PARTS, lambda _, *where: pictures.draw(*where), as_json, plots, out)


@reproduce.command()
def emps(
    log: Annotated[Path | None, typer.Option(help="DATA_EMPS.mat of the benchmark: the record to identify from.")] = None,
    validation: Annotated[Path | None, typer.Option(help="DATA_EMPS_PULSES.mat: a second record, to hold the parameters against.")] = None,
    as_json: Json = False,
    plots: Annotated[list[str] | None, typer.Option(help="Also draw force, friction and position error as png, svg or pdf.")] = None,
    out: Annotated[Path, typer.Option(help="Folder of the pictures; made if it is not there.")] = Path("results"),
) -> int:
    """Janot, Gautier and Brunot: data set and reference models of the EMPS, a linear axis identified from its log."""
    from contourlab.papers.emps import pictures, study

    return _compared(lambda _: study.parts_of(log, validation), lambda _, *where: pictures.draw(log, *where), as_json, plots, out)


@reproduce.command()
def ubc(
    log_folder: Annotated[Path | None, typer.Option(help="Folder with line_circle_lli.mat and line_circle_pp.mat.")] = None,
    unseen: Annotated[bool, typer.Option(help="Also fit with parts of the runs left out, which takes minutes.")] = True,
    as_json: Json = False,
    plots: Annotated[list[str] | None, typer.Option(help="Also draw measured and simulated errors as png, svg or pdf.")] = None,
    out: Annotated[Path, typer.Option(help="Folder of the pictures; made if it is not there.")] = Path("results"),
) -> int:
    """The XY table of the UBC course MECH 467: two measured line-circle runs, and the machine found from them."""
    from contourlab.papers.ubc import pictures, study

    def parts(stage: Callable[[str], None]) -> Sequence[Part]:
        return study.parts_of(log_folder, with_unseen=unseen, stage=stage)

    return _compared(parts, lambda _, *where: pictures.draw(log_folder, *where), as_json, plots, out)


def _compared(parts_of: Parts, draw: Draw, as_json: bool, plots: Sequence[str] | None, out: Path) -> int:
    """Compute the rows, draw them where that is asked for, and print them; return 1 where one fails."""
    from contourlab.app.stages import shown
    from contourlab.papers.run import check_pictures, run_parts

    if plots:
        check_pictures(out, tuple(plots))  # ahead of what takes a minute
    with shown(wants_progress(as_json)) as stages:
        rows = run_parts(parts_of(stages.begin), stages.begin)
        if plots:
            stages.begin("drawing")
            draw(rows, out, tuple(plots))
    return _told(rows, as_json)


def _told(rows: Sequence[Mapping[str, Any]], as_json: bool) -> int:
    """Print the rows; return 1 where one fails."""
    if as_json:
        emit_json(rows)
    else:
        _print_rows(rows)
    return 1 if any(row["pass"] is False for row in rows) else 0


def _print_rows(rows: Sequence[Mapping[str, Any]]) -> None:
    """Print the figures by name, one line a case, and how many agree."""
    from rich.padding import Padding
    from rich.text import Text

    from contourlab.papers.rows import tally

    groups: dict[tuple[str, str], list[Mapping[str, Any]]] = {}
    for row in rows:
        groups.setdefault((row["name"], row["unit"]), []).append(row)
    parts: list[Any] = []
    for (name, unit), members in groups.items():
        parts.append(Text.assemble((name, "bold"), f" [{unit}]" if unit else ""))
        notes = {row["note"] for row in members}
        shared = len(notes) == 1
        if shared and members[0]["note"]:
            parts.append(Padding(Text(members[0]["note"], "dim"), (0, 0, 0, 2)))
        parts.append(Padding(_group_table(members, with_notes=not shared), (0, 0, 1, 2)))
    show(*parts, tally(rows))


def _group_table(rows: Sequence[Mapping[str, Any]], *, with_notes: bool) -> Any:
    from rich.table import Table

    from contourlab.papers.rows import KINDS

    compared = any(row["paper"] is not None for row in rows)
    table = Table(box=None, pad_edge=False, header_style="dim")
    table.add_column("case", min_width=40)
    beside = " or ".join(dict.fromkeys(KINDS[row["source"]][0] for row in rows if row["source"] in KINDS and row["paper"] is not None))
    titles = (beside, "here", "difference") if compared else ("here",)
    for title in titles:
        table.add_column(title, min_width=11, justify="right")
    if compared:
        table.add_column("its source", min_width=10)
        table.add_column("verdict", min_width=8)
    if with_notes:
        table.add_column("")
    for row in rows:
        table.add_row(row["case"], *_figures(row, compared=compared), *([row["note"]] if with_notes else []))
    return table


def _figures(row: Mapping[str, Any], *, compared: bool) -> list[str]:
    """Return the cells of a row between its case and its note."""
    paper, here = row["paper"], row["here"]
    ours = "" if here is None else f"{here:.6g}"
    if not compared:
        return [ours]
    apart = "" if paper is None or here is None else f"{here - paper:+.3g}"
    colour = {"differs": "yellow", "fails": "red"}.get(row["verdict"])
    verdict = f"[{colour}]{row['verdict']}[/]" if colour else row["verdict"]
    return ["" if paper is None else f"{paper:.6g}", ours, apart, row["source"], verdict]
