"""Whose fault it is: what is wrong with the samples of a log is told with its file."""

from __future__ import annotations

import re
from collections.abc import Container, Iterator
from contextlib import contextmanager
from pathlib import Path

from contourlab.errors import FeedError, GeometryError, LogError, ParameterError, ResultError


@contextmanager
def about(*files: str | Path, options: Container[str] = ()) -> Iterator[None]:
    """Give errors about what logs hold the names of the logs.

    What is computed from samples knows no file. Errors that name one of the logs stay as they are, and so do those about an option.

    Parameters
    ----------
    *files : str or Path
        What the logs are called, one or several.
    options : container of str
        Names of parameters that are a user's to give, with low lines.

    Raises
    ------
    LogError
        In place of what was raised, with the names.
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
