"""Add the file of a log to errors about its samples."""

from __future__ import annotations

import re
from collections.abc import Container, Iterator
from contextlib import contextmanager
from pathlib import Path

from contourlab.errors import FeedError, GeometryError, LogError, ParameterError, ResultError


@contextmanager
def about(*files: str | Path, options: Container[str] = ()) -> Iterator[None]:
    """Raise errors about samples as `LogError` with the names of their logs.

    Errors that name one of the logs already, or concern an option, pass unchanged.

    Parameters
    ----------
    *files : str or Path
        Names of the logs.
    options : container of str
        Names of parameters that the user sets, with underscores.

    Raises
    ------
    LogError
        In place of the error, with the names.
    """
    try:
        yield
    except (FeedError, GeometryError, ParameterError, ResultError) as error:
        is_an_option = isinstance(error, ParameterError) and (error.name.startswith("--") or error.name == "LOG" or error.name in options)
        if is_an_option or any(re.search(rf"(?<!\w){re.escape(Path(file).name)}(?!\w)", str(error)) for file in files):
            raise
        more = f" and {len(files) - 2} more" if len(files) > 3 else ""
        named = ", ".join(str(file) for file in (files[:2] if more else files))
        raise LogError(str(error), file=f"{named}{more}") from error
