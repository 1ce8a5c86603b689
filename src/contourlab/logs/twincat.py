"""Read text exports of TwinCAT Scope (TE13xx, "Export to csv"): channels in columns, with time columns per sample time."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import LogError, refuse
from contourlab.findings import finding
from contourlab.logs.reading import REPEATED, Channel, Record, cell_number, cells_of, lines_of

MARKS = "\t;:, "
TICK = 1e-7
"""Unit of file times [s], which count from 1601."""
FILE_TIME = 1e15
"""Larger times are file times, not milliseconds."""
NAME, PERIOD, UNIT, SYMBOL = "Name", "SampleTime[ms]", "Unit", "SymbolName"
LAST = ("Port", "BitMask", "Unit ScaleFactor", "Unit Offset")
"""Possible last lines of the header."""


def matches(file: Path, head: bytes) -> bool:
    """Tell whether the first line names the scope, and sample times follow."""
    text = head.decode("utf-8", errors="replace")
    return re.match(r'(#\s*)?"?Name"?[\t;:, ]', text) is not None and PERIOD in text


def read(file: Path) -> Record:
    """Read an export with time columns for all channels, per sample time, or none; decimal point or comma.

    Values are not scaled: the scope scales them by default.

    Raises
    ------
    LogError
        If the header or a row is faulty.
    """
    written, findings = lines_of(file)
    refuse(not written, LogError, "contains no samples", file=file)
    mark = written[0][1].lstrip('"# ').removeprefix(NAME).lstrip('"')[:1] or "\t"
    rows = [cells_of(re.sub(r"^#\s*", "", line), mark) for _, line in written]
    if repeated := [line for (line, _), row in zip(written, rows, strict=True) if row[0] == PERIOD][1:]:
        raise LogError(REPEATED, file=file, line=repeated[0])
    heads = {row[0]: row for row in rows[4:40] if row[0] in (NAME, PERIOD, UNIT, SYMBOL, "ScaleFactor")}
    for key in (NAME, PERIOD):
        refuse(key not in heads, LogError, f"has no header line {key}: check that it is an export of TwinCAT Scope", file=file)
    if len({len(heads[key]) for key in (NAME, PERIOD)}) > 1:
        raise LogError("channel names contain the separator: export with tabs or semicolons", file=file)
    start = max(i for i, row in enumerate(rows[:60]) if row[0] in (*heads, *LAST)) + 1
    samples = [(line, row) for (line, _), row in zip(written[start:], rows[start:], strict=True)]
    # An end mark, triggers or markers may follow the samples.
    end = next((k for k, (_, row) in enumerate(samples) if row[0].strip() and not _number(row[0])), len(samples))
    body = samples[:end]
    refuse(not body, LogError, "contains no samples", file=file)
    layout = _layout(heads[NAME], body[0][1], file)
    comma = any("," in cell for cell in heads[PERIOD]) and mark != ","
    values = _values(body, max(max(pair) for pair in layout) + 1, comma, file, {column: heads[NAME][head] for head, column, _ in layout})
    scaled = [name for name, factor in zip(heads[NAME], heads.get("ScaleFactor", []), strict=False) if _number(factor) and factor != "1"]
    findings += (finding("CL420", channels=scaled),) if scaled else ()
    return Record(file, "twincat", tuple(_channel(file, heads, values, *pair) for pair in layout), findings=findings)


def _number(cell: str) -> bool:
    return re.fullmatch(r"[-+]?\d[\d.,eE+-]*", cell.strip()) is not None


def _layout(names: Sequence[str], row: Sequence[str], file: Path) -> list[tuple[int, int, int]]:
    """Return for each channel its column in the header and in the rows, and its time column (-1 for none)."""
    timed = len(row) >= len(names)
    columns, time, column = [], -1, 0
    for j, name in enumerate(names):
        if name == NAME:
            time = column if timed else -1
            column += timed
        else:
            columns.append((j, column, time))
            column += 1
    refuse(not columns, LogError, "names no channel: export it again from TwinCAT Scope", file=file)
    return columns


def _values(body: Sequence[tuple[int, Sequence[str]]], width: int, comma: bool, file: Path, names: Mapping[int, str]) -> Array:
    values = np.full((len(body), width), np.nan)
    for i, (line, cells) in enumerate(body):
        try:
            values[i] = list(map(float, cells[:width]))  # fast path for full rows of plain numbers
        except ValueError:
            for j, cell in enumerate(cells[:width]):
                decimal = comma or ("," in cell and "." not in cell)
                values[i, j] = cell_number(cell, names.get(j, str(j + 1)), file, line, decimal)
    return values


def _channel(file: Path, heads: dict[str, list[str]], values: Array, head: int, column: int, time: int) -> Channel:
    period = cell_number(heads[PERIOD][head], heads[NAME][head], file, 0, True) * 1e-3
    valid = np.isfinite(values[:, column])
    if time >= 0:
        valid &= np.isfinite(values[:, time])
        stamps = values[valid, time]
        seconds = (stamps - stamps[:1]) * TICK if stamps.size and stamps[0] > FILE_TIME else stamps * 1e-3
    else:
        seconds = np.arange(np.count_nonzero(valid)) * period
    # The unit is written with its quantity: "dV (Voltage)".
    unit, symbol = ("".join(heads.get(key, [])[head : head + 1]) for key in (UNIT, SYMBOL))
    return Channel(heads[NAME][head], values[valid, column], unit.partition("(")[0].strip(), seconds, symbol=symbol)
