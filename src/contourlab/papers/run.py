"""The command behind ``contourlab reproduce``: run the parts of a reproduction."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

from contourlab.papers.rows import Part


def run_parts(parts: Iterable[Part], stage: Callable[[str], object] | None = None) -> list[dict[str, Any]]:
    """Compute the rows of all parts, with the keys of `contourlab.papers.rows.Row.as_dict`.

    Parameters
    ----------
    parts : iterable of Part
    stage : callable, optional
        Receives the name of each part that begins.
    """
    rows = []
    for name, rows_of in parts:
        if stage is not None:
            stage(name)
        rows += [row.as_dict() for row in rows_of()]
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
    from contourlab.app.folder import staged
    from contourlab.report.plots import write_charts

    write_charts((), folder, formats)
    with staged(folder):
        pass
