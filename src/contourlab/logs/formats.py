"""The formats of logs, and their recognition."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from contourlab.errors import LogError, ParameterError
from contourlab.file_kinds import mistaken
from contourlab.logs import delimited, linuxcnc, matlab, parquet, results, sinumerik, twincat
from contourlab.logs.apart import read_apart
from contourlab.logs.reading import head_of
from contourlab.logs.record import Record


@dataclass(frozen=True)
class Format:
    """A format of logs.

    Attributes
    ----------
    name : str
        Value of ``--format``.
    matches : callable
        ``matches(file, head) -> bool``, from the name and the first bytes.
    read : callable
        ``read(file) -> Record``.
    """

    name: str
    matches: Callable[[Path, bytes], bool]
    read: Callable[[Path], Record]


# From the most specific to any table of numbers.
FORMATS = {
    kind.name: kind
    for kind in (
        Format("contourlab", results.matches, partial(read_apart, "contourlab")),
        Format("matlab", matlab.matches, partial(read_apart, "matlab")),
        Format("parquet", parquet.matches, partial(read_apart, "parquet")),
        Format("sinumerik", sinumerik.matches, sinumerik.read),
        Format("twincat", twincat.matches, twincat.read),
        Format("halscope", linuxcnc.matches_scope, linuxcnc.read_scope),
        Format("halsampler", linuxcnc.matches_sampler, linuxcnc.read_sampler),
        Format("csv", delimited.matches, delimited.read),
    )
}


def format_of(file: str | Path) -> Format:
    """Recognise the format of a file.

    Raises
    ------
    LogError
        If the file cannot be read, is empty, or has no known format.
    """
    path = Path(file)
    head = head_of(path)
    for kind in FORMATS.values():
        if kind.matches(path, head):
            return kind
    raise LogError(mistaken(path, "a log") or f"has no known format: name it with --format, one of {', '.join(FORMATS)}", file=path)


def read_record(file: str | Path, format: str | None = None) -> Record:  # noqa: A002
    """Read a log without interpretation.

    Parameters
    ----------
    format : str, optional
        One of `FORMATS`; by default recognised.

    Raises
    ------
    LogError
        If it cannot be read.
    ParameterError
        If the format is unknown.
    """
    path = Path(file)
    if format is None:
        return format_of(path).read(path)
    if format not in FORMATS:
        raise ParameterError("format", repr(format), f"one of {', '.join(FORMATS)}")
    head_of(path)
    return FORMATS[format].read(path)
