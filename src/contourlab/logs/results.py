"""Read a result of contourlab (``.nc``) as a log."""

from __future__ import annotations

from pathlib import Path

from contourlab.errors import LogError, ResultError
from contourlab.logs.reading import Channel, Record
from contourlab.result import Result


def matches(file: Path, head: bytes) -> bool:
    """Tell by the first bytes and the suffix."""
    return head.startswith(b"\x89HDF\r\n\x1a\n") and file.suffix.lower() == ".nc"


def read(file: Path) -> Record:
    """Read a result; channels are ``position.x``, or ``arc_length`` for all axes.

    Raises
    ------
    LogError
        If it cannot be read.
    """
    try:
        result = Result.load(file)
    except ResultError as error:
        raise LogError(str(error).removeprefix(f"{file}: "), file=file) from error
    time = result.time
    channels = []
    for name, signal in result.signals.items():
        if signal.data.ndim == 1:
            channels.append(Channel(name, signal.data, signal.unit, time))
        else:
            columns = zip(result.axes, signal.data.T, strict=True)
            channels += [Channel(f"{name}.{axis}", column, signal.unit, time) for axis, column in columns]
    # A log may be judged along another path.
    attributes = {name: value for name, value in result.attributes.items() if name != "reference_digest"}
    return Record(file, "contourlab", tuple(channels), result.servo_period, attributes=attributes)
