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
    """Print one line a figure, and how many agree."""
    from rich.table import Table

    table = Table("figure", "case", "paper", "here", "unit", "tolerance", "agrees", "note")
    for row in rows:
        numbers = ["" if row[key] is None else f"{row[key]:.6g}" for key in ("paper", "here", "tolerance")]
        verdict = {True: "yes", False: "[red]no[/red]", None: ""}[row["pass"]]
        table.add_row(row["name"], row["case"], numbers[0], numbers[1], row["unit"], numbers[2], verdict, row["note"])
    compared = [row["pass"] for row in rows if row["pass"] is not None]
    show(table, f"{sum(compared)} of {len(compared)} figures agree; {len(rows) - len(compared)} are shown without a claim.")
