"""``contourlab reproduce``: a paper's figures beside ours."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Annotated, Any

import typer

from contourlab.cli.output import emit_json, show

__all__ = ["reproduce"]

reproduce = typer.Typer(no_args_is_help=True, help="Compute a paper's figures again and compare.")


@reproduce.command()
def ghaffari(as_json: Annotated[bool, typer.Option("--json", help="Print JSON alone on standard output.")] = False) -> int:
    """Ghaffari and Ulsoy: component swapping modularity for distributed precision contouring."""
    from contourlab.studies.reproduce.ghaffari import reproduce as rows_of

    rows = rows_of()
    if as_json:
        emit_json(rows)
    else:
        _print_rows(rows)
    return 1 if any(row["pass"] is False for row in rows) else 0


@reproduce.callback()
def _papers() -> None:
    """Keep `ghaffari` a name of its own while it is the only paper."""


def _print_rows(rows: Sequence[Mapping[str, Any]]) -> None:
    """Print the figures by name, one line a case, and how many agree."""
    from rich.padding import Padding
    from rich.text import Text

    groups: dict[tuple[str, str], list[Mapping[str, Any]]] = {}
    for row in rows:
        groups.setdefault((row["name"], row["unit"]), []).append(row)
    parts: list[Any] = []
    for (name, unit), members in groups.items():
        parts.append(Text.assemble((name, "bold"), f" [{unit}]" if unit else ""))
        notes = dict.fromkeys(row["note"] for row in members if row["note"])
        shared = len(notes) == 1
        if shared:
            parts.append(Padding(Text(next(iter(notes)), "dim"), (0, 0, 0, 2)))
        parts.append(Padding(_group_table(members, with_notes=not shared and bool(notes)), (0, 0, 1, 2)))
    compared = [row["pass"] for row in rows if row["pass"] is not None]
    words = f"{sum(compared)} of {len(compared)} figures agree; {len(rows) - len(compared)} are shown without a claim."
    show(*parts, words)


def _group_table(rows: Sequence[Mapping[str, Any]], *, with_notes: bool) -> Any:
    from rich.table import Table

    table = Table(box=None, pad_edge=False, header_style="dim")
    table.add_column("case", min_width=40)
    for title in ("paper", "here", "difference"):
        table.add_column(title, min_width=11, justify="right")
    table.add_column("agrees", min_width=6)
    if with_notes:
        table.add_column("")
    for row in rows:
        paper, here = row["paper"], row["here"]
        apart = "" if paper is None or here is None else f"{here - paper:+.3g}"
        verdict = {True: "yes", False: "[red]no[/red]", None: ""}[row["pass"]]
        cells = [row["case"], "" if paper is None else f"{paper:.6g}", "" if here is None else f"{here:.6g}", apart, verdict]
        table.add_row(*cells, *([row["note"]] if with_notes else []))
    return table
