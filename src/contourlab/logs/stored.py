"""Results that contourlab itself wrote, read as a log, so that a simulated run goes through the same door as a measured one."""

from __future__ import annotations

from pathlib import Path

from contourlab.errors import LogError, ResultError
from contourlab.logs.record import Channel, Record
from contourlab.result import Result


def matches(file: Path, head: bytes) -> bool:
    """Tell whether it is an HDF5 file whose name ends in .nc."""
    return head.startswith(b"\x89HDF\r\n\x1a\n") and file.suffix.lower() == ".nc"


def read(file: Path) -> Record:
    """Read a result; its channels are named ``position.x``, and ``arc_length`` where there is one for all axes.

    Raises
    ------
    LogError
        If it is no result of contourlab.
    """
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
    return Record(file, "contourlab", tuple(channels), result.servo_period, attributes=dict(result.attributes))
