"""The formats of logs: which there are, and which of them a file is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from contourlab.errors import LogError, ParameterError
from contourlab.logs import delimited, halsampler, halscope, matlab, parquet, sinumerik, stored, twincat
from contourlab.logs.reading import head_of
from contourlab.logs.record import Record


@dataclass(frozen=True)
class Format:
    """A format of logs.

    Attributes
    ----------
    name : str
        As ``--format`` takes it.
    doc : str
        One line for people.
    matches : callable
        ``matches(file, head) -> bool``, from the name and the first bytes.
    read : callable
        ``read(file) -> Record``.
    """

    name: str
    doc: str
    matches: Callable[[Path, bytes], bool]
    read: Callable[[Path], Record]


# From the most particular to the one that takes any table of numbers.
FORMATS = {
    kind.name: kind
    for kind in (
        Format("contourlab", "a result that contourlab wrote (.nc)", stored.matches, stored.read),
        Format("matlab", "MATLAB .mat, version 4 to 7.3: flat, structures, captures of ControlDesk", matlab.matches, matlab.read),
        Format("parquet", "Apache Parquet", parquet.matches, parquet.read),
        Format("sinumerik", "trace of a Sinumerik control (.xml)", sinumerik.matches, sinumerik.read),
        Format("twincat", "text export of TwinCAT Scope", twincat.matches, twincat.read),
        Format("halscope", "LinuxCNC halscope, new (.csv) and old", halscope.matches, halscope.read),
        Format("halsampler", "LinuxCNC halsampler", halsampler.matches, halsampler.read),
        Format("csv", "table of numbers parted by commas, semicolons, tabs or blanks", delimited.matches, delimited.read),
    )
}


def format_of(file: str | Path) -> Format:
    """Return the format that a file is in.

    Raises
    ------
    LogError
        If the file cannot be read, is empty, or looks like none of them.
    """
    path = Path(file)
    if path.is_dir():
        raise LogError("is a folder: name the file in it", file=path)
    head = head_of(path)
    for kind in FORMATS.values():
        if kind.matches(path, head):
            return kind
    raise LogError(f"looks like none of the formats that are read: {', '.join(FORMATS)}; say which with --format", file=path)


def read_record(file: str | Path, format: str | None = None) -> Record:  # noqa: A002
    """Read a log as it stands.

    Parameters
    ----------
    file : str or Path
    format : str, optional
        One of `FORMATS`; by default what the file looks like.

    Raises
    ------
    LogError
        If it cannot be read; says file and line.
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
