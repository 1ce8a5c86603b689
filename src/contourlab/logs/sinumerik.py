"""Traces of Sinumerik controls in XML: a head that describes the signals, and a record for each time with the values that are new then."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np

from contourlab.errors import LogError
from contourlab.logs.record import Channel, Record

__all__ = ["matches", "read"]

NOTHING = 9.2e18
"""Larger numbers are the bits of a number that is none, written as a whole one."""


def matches(file: Path, head: bytes) -> bool:
    """Tell whether it is XML that holds a trace."""
    text = head[: 1 << 14]
    return text.lstrip(b"\xef\xbb\xbf \r\n\t").startswith(b"<") and (b"<trace" in text or b"<dataFrame" in text)


def read(file: Path) -> Record:
    """Read a trace: ``dataSignal`` elements with id, name, description and interval, ``rec`` elements with a time [s] and values by id.

    Signals without an id are numbered as the records do, f1, f2, ... A signal has a sample at the times at which a record holds its value.

    Raises
    ------
    LogError
        If it is no XML, or holds no trace.
    """
    signals: list[dict[str, str]] = []
    samples: dict[str, tuple[list[float], list[float]]] = {}
    try:
        for _, element in ElementTree.iterparse(file, events=("end",)):
            tag = element.tag.rpartition("}")[2]
            if tag == "dataSignal":
                signals.append(dict(element.attrib))
            elif tag == "rec":
                _keep(element, samples, file)
                element.clear()
            elif tag not in ("dataFrame", "traceData"):
                continue
    except ElementTree.ParseError as error:
        line = error.position[0] if error.position else 0
        raise LogError(f"is no complete XML: {error.msg}", file=file, line=line) from error
    except (LookupError, ValueError) as error:
        raise LogError(f"is XML in an encoding that is not read: {error}", file=file) from error
    except OSError as error:
        raise LogError(f"cannot be read: {error.strerror or error}", file=file) from error
    channels = [_channel(i, signal, samples) for i, signal in enumerate(signals)]
    found = tuple(channel for channel in channels if channel is not None)
    if not found:
        raise LogError("holds no trace: no dataSignal that a rec has values of", file=file)
    return Record(file, "sinumerik", found)


def _keep(element: Any, samples: dict[str, tuple[list[float], list[float]]], file: Path) -> None:
    try:
        time = float(element.attrib["time"])
        for key, text in element.attrib.items():
            if key != "time" and (value := float(text)) < NOTHING:
                times, values = samples.setdefault(key, ([], []))
                times.append(time)
                values.append(value)
    except (KeyError, ValueError) as error:
        raise LogError(f"a rec without a time, or with what is no number: {dict(element.attrib)}", file=file) from error


def _channel(index: int, signal: dict[str, str], samples: dict[str, tuple[list[float], list[float]]]) -> Channel | None:
    keys = [signal[name] for name in ("id", "key") if name in signal] + [f"f{index + 1}"]
    key = next((key for key in keys if key in samples), None)
    if key is None:
        return None
    times, values = samples[key]
    name = signal.get("description") or signal.get("name") or key
    unit = signal.get("units") or signal.get("unit") or ""
    return Channel(name, np.array(values), unit, np.array(times))
