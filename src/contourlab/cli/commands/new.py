"""``contourlab new``: files to start from."""

from __future__ import annotations

import typer

__all__ = ["new"]

new = typer.Typer(no_args_is_help=True, help="Make files to start from.")


@new.callback()
def _things() -> None:
    """Keep `machine` a name of its own."""
