"""Read high-frequency captures of Sinumerik controls: JSON with rows of signals at the servo clock, and events of the part program.

The format is unpublished; this reads the files of version 1.0 of the recorder on an 840D sl.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import LogError, refuse
from contourlab.findings import finding
from contourlab.logs.reading import FASTEST, LONGEST, NUMBERS, Blocks, Channel, Record, check_limit, text_of

SIGNALS = {"DES_POS": "reference", "ENC_POS": "position"}
"""Signals that are read by name. CONT_DEV is not among them: it is a deviation of one axis from the control's own model of its loop."""
RAPID = "G0"


def matches(file: Path, head: bytes) -> bool:
    """Tell whether it is JSON with a list of high-frequency signals."""
    return head.lstrip(b"\xef\xbb\xbf \r\n\t").startswith(b"{") and b'"SignalListHFData"' in head


def read(file: Path) -> Record:
    """Read a capture.

    Each row of ``HFData`` has a value for each entry of ``SignalListHFData``; its time is the counter ``CYCLE`` times ``CycleTimeMs``,
    from the first row on. ``ENC_POS`` and ``DES_POS`` are position and reference of the axis that the entry names. The file says neither
    their unit nor which axes turn: they are taken in mm, and a position that turns without end is left out.

    ``HFBlockEvent`` gives the program line (``SeekOffset``) and G0 or G1 (``IpoGC``) from its counter on, ``HFCallEvent`` the program.

    Raises
    ------
    LogError
        If it is not JSON, lacks a part, or a row has values that are not numbers.
    """
    try:
        content = json.loads(text_of(file))
    except json.JSONDecodeError as error:
        raise LogError(f"is not complete and valid JSON: {error.msg}; record it again", file=file, line=error.lineno) from error
    except (ValueError, RecursionError) as error:
        raise LogError(f"is not valid JSON: {error}", file=file) from error
    try:
        header, payload = content["Header"], content["Payload"]
        names = [(str(signal["Name"]), str(signal["Axis"])) for signal in header["SignalListHFData"]]
        period = 1e-3 * float(header["CycleTimeMs"])
        refuse(not 0.0 < period < np.inf, ValueError, f"CycleTimeMs = {1e3 * period:g}")
        rows = [row for part in payload for row in part.get("HFData", ())]
        check_limit(len(rows) * len(names), NUMBERS, "numbers", file)
        values = np.array(rows, dtype=np.float64).reshape(len(rows), len(names))
        cycle = values[:, [name for name, _ in names].index("CYCLE")]
        blocks = _blocks(payload, cycle[0], period) if len(rows) else None
    except (LookupError, TypeError, AttributeError, ValueError, OverflowError) as error:
        wanted = "SignalListHFData with CYCLE, CycleTimeMs, and rows of as many numbers in HFData"
        what = f"no {error}" if isinstance(error, KeyError) else str(error)
        raise LogError(f"is no capture of high-frequency data, which has {wanted}: {what}", file=file) from error
    time = (cycle - cycle[:1]) * period
    signals = [(SIGNALS.get(name.partition("|")[0], ""), axis) for name, axis in names]
    turning = {axis for (signal, axis), column in zip(signals, values.T, strict=True) if signal and _turns(column, time, period)}
    meanings = [(signal, axis) if signal and axis not in turning else None for signal, axis in signals]
    of_names = zip(names, meanings, values.T, strict=True)
    channels = tuple(Channel(name, column, time=time, meaning=meaning) for (name, _), meaning, column in of_names)
    findings = (finding("CL439", axes=sorted(turning)),) if turning else ()
    return Record(file, "sinumerik-capture", channels, findings=findings, blocks=blocks, unit="mm")


def _turns(position: Array, time: Array, period: float) -> bool:
    """Tell whether a position (n,) [mm] goes farther than any feed axis, or jumps, as at the end of a turn."""
    known = np.isfinite(position) & np.isfinite(time)
    position, time = position[known] * 1e-3, time[known]
    jumps = np.abs(np.diff(position)) > FASTEST * np.maximum(np.diff(time), period)
    return bool(position.size and (np.ptp(position) > LONGEST or jumps.any()))


def _blocks(payload: Iterable[Mapping[str, Any]], first: float, period: float) -> Blocks | None:
    """Return the blocks of the part program, in order of the file."""
    events: list[tuple[float, int, bool, str]] = []
    program = ""
    for part in payload:
        if "HFCallEvent" in part:
            program = str(part["HFCallEvent"]["Path"])
        elif "HFBlockEvent" in part:
            event = part["HFBlockEvent"]
            events.append((float(event["HFProbeCounter"]), int(event["SeekOffset"]), event["IpoGC"] == RAPID, program))
    if not events:
        return None
    counter, line, is_rapid, programs = zip(*events, strict=True)
    time = np.maximum.accumulate((np.array(counter) - first) * period)
    return Blocks(time, np.array(line, dtype=np.int64), np.array(is_rapid), programs)
