"""The formats of logs, and their recognition."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from contourlab.errors import LogError, ParameterError, ResultError
from contourlab.logs import delimited, linuxcnc, matlab, parquet, sinumerik, twincat
from contourlab.logs.reading import head_of
from contourlab.logs.record import Channel, Record
from contourlab.result import Result


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


def _is_result(file: Path, head: bytes) -> bool:
    return head.startswith(b"\x89HDF\r\n\x1a\n") and file.suffix.lower() == ".nc"


def _read_result(file: Path) -> Record:
    """Read a result of contourlab; channels are ``position.x``, or ``arc_length`` for all axes."""
    try:
        result = Result.load(file)
    except ResultError as error:
        raise LogError(str(error).removeprefix(f"{file}: "), file=file) from error
    channels = []
    for name, signal in result.signals.items():
        if signal.data.ndim == 1:
            channels.append(Channel(name, signal.data, signal.unit, result.time))
        else:
            columns = zip(result.axes, signal.data.T, strict=True)
            channels += [Channel(f"{name}.{axis}", column, signal.unit, result.time) for axis, column in columns]
    # A log may be judged along another path.
    attributes = {name: value for name, value in result.attributes.items() if name != "reference_digest"}
    return Record(file, "contourlab", tuple(channels), result.servo_period, attributes=attributes)


# From the most specific to any table of numbers.
FORMATS = {
    kind.name: kind
    for kind in (
        Format("contourlab", _is_result, _read_result),
        Format("matlab", matlab.matches, matlab.read),
        Format("parquet", parquet.matches, parquet.read),
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
    if path.is_dir():
        raise LogError("is a folder: name a file in it", file=path)
    head = head_of(path)
    for kind in FORMATS.values():
        if kind.matches(path, head):
            return kind
    raise LogError(f"has no known format: name it with --format, one of {', '.join(FORMATS)}", file=path)


def read_record(file: str | Path, format: str | None = None) -> Record:  # noqa: A002
    """Read a log without interpretation.

    Parameters
    ----------
    file : str or Path
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
