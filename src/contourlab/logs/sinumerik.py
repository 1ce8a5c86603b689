"""Read XML traces of Sinumerik controls: a header of signals, then a record of changed values per time.

The format is unpublished; this reads the output of SINUMERIK Solution Line Trace (``traceSession``, version 01.00).
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from xml.parsers import expat

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import LogError, refuse
from contourlab.findings import finding
from contourlab.logs.reading import COLUMNS, NUMBERS, Channel, Record, check_limit, is_unit, number, readable, shown

NOTHING = 9.2e18
"""Larger numbers are the bits of NaN, written as an integer."""
ON_GRID = 0.02
"""Tolerance of sample times, as a share of the interval: times are rounded when written."""
MOST_HELD = 1000
"""Most samples per written value; more mean a wrong time rather than constant values."""
UNITS = {"current": "A"}
"""Units implied by the type of a signal; a position (posn) may be in mm, inch or degrees."""
_AXIS = re.compile(r"\[\s*u\d+\s*[,;]\s*(\d+)\s*\]")


def matches(file: Path, head: bytes) -> bool:
    """Tell whether it is XML with a trace."""
    text = head[: 1 << 14]
    return text.lstrip(b"\xef\xbb\xbf \r\n\t").startswith(b"<") and (b"<trace" in text or b"<dataFrame" in text)


def read(file: Path) -> Record:
    """Read a trace.

    Signals are ``dataSignal`` elements, named there or in the ``signal`` of the same key in ``traceDisplaySetup``; equal names get the
    axis number, ``AX1``. A ``rec`` has a time [s] and the changed values by signal id. A signal with an interval has a sample at each
    interval, held where none is written; others have the written samples. Bits are 1 and 0.

    Raises
    ------
    LogError
        If it is not XML, a value is not a number, or there is not exactly one trace.
    """
    trace = _Trace(file)
    trace.parse()
    signals = [_described(signal, trace.shown.get(signal.get("key", ""), {})) for signal in trace.signals]
    # The key of a signal's values in the records is its id, else its key, else its number.
    written = (signal.get("key", "") if signal.get("key", "") in trace.samples else f"f{i}" for i, signal in enumerate(signals, 1))
    keys = [signal.get("id") or key for signal, key in zip(signals, written, strict=True)]
    described = list(zip(keys, signals, _names(signals), strict=True))
    channels = tuple(_channel(key, signal, name, trace) for key, signal, name in described if key in trace.samples)
    refuse(not channels, LogError, "contains no trace: no rec element has values of a dataSignal", file=file)
    silent = [name or key for key, _, name in described if key not in trace.samples]
    lost = _positive(trace.header.get("dropOuts"))
    findings = [finding("CL423", drop_outs=int(lost))] if lost else []
    findings += [finding("CL424", signals=silent)] if silent else []
    return Record(file, "sinumerik", channels, findings=tuple(findings))


@dataclass
class _Trace:
    """The elements of the file."""

    file: Path
    shown: dict[str, dict[str, str]] = field(default_factory=dict)
    """Signals of the display, by key."""
    signals: list[dict[str, str]] = field(default_factory=list)
    header: dict[str, str] = field(default_factory=dict)
    samples: dict[str, tuple[list[float], list[float]]] = field(default_factory=dict)
    """Written times and values by signal id."""
    last: float = -np.inf
    """Time of the last record [s]."""
    count: int = 0
    """Times and values of all samples so far."""

    def parse(self) -> None:
        parser = expat.ParserCreate()
        above: list[str] = []

        def start(name: str, attributes: dict[str, str]) -> None:
            tag = name.rpartition(":")[2]
            self._take(tag, attributes, above, parser.CurrentLineNumber)
            above.append(tag)

        def refuse(*_: object) -> None:
            # Entities may grow without limit, or name other files.
            raise LogError("declares a document type (DOCTYPE), which no trace has: delete the declaration", file=self.file)

        parser.StartElementHandler = start
        parser.StartDoctypeDeclHandler = refuse
        parser.EndElementHandler = lambda _: above.pop()
        try:
            with readable(self.file):
                data = self.file.read_bytes()
            parser.Parse(data, True)  # in parts, older versions of expat scan a long element again and again
        except expat.ExpatError as error:
            raise LogError(f"is not valid or complete XML: {expat.ErrorString(error.code)}", file=self.file, line=error.lineno) from error
        except (LookupError, ValueError) as error:
            raise LogError(f"is XML in an unknown encoding: {error}", file=self.file) from error

    def _take(self, tag: str, attributes: dict[str, str], above: list[str], line: int) -> None:
        check_limit(max(len(attributes), len(self.signals)), COLUMNS, "columns", self.file, line)
        if tag == "signal" and any(name.startswith("traceDisplaySetup") for name in above):
            self.shown.setdefault(attributes.get("key", ""), attributes)
        elif tag == "dataFrame" and self.samples:
            raise LogError("a second dataFrame begins here: split the file", file=self.file, line=line)
        elif tag == "frameHeader":
            self.header = attributes
        elif tag == "dataSignal":
            self.signals.append(attributes)
        elif tag == "rec":
            self._keep(attributes, line)

    def _keep(self, attributes: Mapping[str, str], line: int) -> None:
        values = {}
        for key, text in attributes.items():
            try:
                values[key] = number(text)
            except ValueError:
                raise LogError(f"a value of a rec element is not a number: {key} = {shown(text)}", file=self.file, line=line) from None
        time = values.pop("time", np.nan)
        refuse(not np.isfinite(time), LogError, "a rec element has no time", file=self.file, line=line)
        self.last = time
        for key, value in values.items():
            times, written = self.samples.setdefault(key, ([], []))
            times.append(time)
            written.append(value if abs(value) < NOTHING else np.nan)


def _described(signal: Mapping[str, str], shown: Mapping[str, str]) -> dict[str, str]:
    """Complete a signal from the display; the description there has priority, because people edit it there."""
    own = {key: text for key, text in signal.items() if text.strip()}
    named = {"description": shown["description"]} if shown.get("description", "").strip() else {}
    return {**shown, **own, **named}


def _names(signals: Sequence[Mapping[str, str]]) -> list[str]:
    """Return the names of signals; equal names get the axis number."""
    called = [(signal.get("description") or signal.get("name") or "").strip() for signal in signals]
    count = Counter(called)
    axes = [_AXIS.search(signal.get("name", "")) if count[name] > 1 else None for signal, name in zip(signals, called, strict=True)]
    return [f"{name} AX{axis[1]}" if axis else name for name, axis in zip(called, axes, strict=True)]


def _channel(key: str, signal: Mapping[str, str], name: str, trace: _Trace) -> Channel:
    written, values = (np.array(numbers) for numbers in trace.samples[key])
    every, count, n = _positive(signal.get("interval")), _positive(signal.get("datapointCount")), 0.0
    if every and not 0.0 < count <= written.size:
        # Unchanged values are not written. Records end with the last change; the count includes all samples.
        n = max((trace.last - written[0]) / every + ON_GRID + 1.0, count)
        n = n if n <= MOST_HELD * written.size else 0.0
    trace.count += 2 * max(int(n), written.size)
    check_limit(trace.count, NUMBERS, "times and values", trace.file)
    time, values = _held(written, values, every, int(n)) if n else (written, values)
    valid = ~np.isnan(values)
    kind = signal.get("unitsType", "")
    unit = signal.get("units") or signal.get("unit") or UNITS.get(kind) or (kind if is_unit(kind) else "")
    return Channel(name or key, values[valid], unit, time[valid])


def _held(written: Array, values: Array, every: float, n: int) -> tuple[Array, Array]:
    """Return times and values of `n` samples, each value held until the next; those written if they are off this grid."""
    exact = (written - written[0]) / every
    place = np.rint(exact)
    if (np.abs(exact - place) > ON_GRID).any() or (np.diff(place) < 1.0).any():
        return written, values
    lengths = np.diff(np.append(place, n)).astype(np.int64)
    return written[0] + every * np.arange(n), np.repeat(values, lengths)


def _positive(text: str | None) -> float:
    """Return a number above 0, or 0."""
    try:
        value = float(text or 0.0)
    except ValueError:
        return 0.0
    return value if 0.0 < value < np.inf else 0.0
