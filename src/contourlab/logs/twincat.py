"""TwinCAT Scope's text export: channels side by side, each group of one sample time with a column of times (TE13xx, "Export to csv")."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import LogError
from contourlab.logs.reading import cell_number, cells_of, lines_of, number
from contourlab.logs.record import Channel, Record

Array = NDArray[np.float64]
MARKS = "\t;:, "
TICK = 1e-7
"""Seconds of a file time, which counts from 1601."""
FILE_TIME = 1e15
"""A time above this is a file time, not one in milliseconds."""
NAME, PERIOD, UNIT, SYMBOL = "Name", "SampleTime[ms]", "Unit", "SymbolName"
LAST = ("Port", "BitMask", "Unit ScaleFactor", "Unit Offset")
"""Lines that the head of the channels may end with."""


def matches(file: Path, head: bytes) -> bool:
    """Tell whether the first line names the scope, and channels with their sample times follow."""
    text = head.decode("utf-8-sig", errors="replace")
    return re.match(r'"?Name"?[\t;:, ]', text) is not None and PERIOD in text


def read(file: Path) -> Record:
    """Read an export with timelines for all channels, for each sample time, or for none; decimal point or comma.

    Values are taken as they are: the scope has scaled them, unless its export was set not to.

    Raises
    ------
    LogError
        If the header or a row is faulty; says the line.
    """
    written, notes = lines_of(file)
    if not written:
        raise LogError("holds no samples", file=file)
    mark = written[0][1].lstrip('"').removeprefix(NAME).lstrip('"')[:1] or "\t"
    rows = [cells_of(line, mark) for _, line in written]
    heads = {row[0]: row for row in rows[4:40] if row[0] in (NAME, PERIOD, UNIT, SYMBOL, "ScaleFactor")}
    for key in (NAME, PERIOD):
        if key not in heads:
            raise LogError(f"has no line {key} of its channels: is it an export of TwinCAT Scope?", file=file)
    if len({len(heads[key]) for key in (NAME, PERIOD)}) > 1:
        raise LogError("names of channels hold what parts the columns: export with tabs or semicolons", file=file)
    start = max(i for i, row in enumerate(rows[:60]) if row[0] in (*heads, *LAST)) + 1
    body = _until_end([(line, row) for (line, _), row in zip(written[start:], rows[start:], strict=True)])
    if not body:
        raise LogError("holds no samples", file=file)
    layout = _layout(heads[NAME], body[0][1], file)
    comma = any("," in cell for cell in heads[PERIOD]) and mark != ","
    values = _values(body, max(max(pair) for pair in layout) + 1, comma, file, {column: heads[NAME][head] for head, column, _ in layout})
    return Record(file, "twincat", tuple(_channel(heads, values, *pair) for pair in layout), notes=(*notes, *_notes(heads)))


def _until_end(body: list[tuple[int, list[str]]]) -> list[tuple[int, list[str]]]:
    """Return the rows of samples: up to the mark of the end, triggers or tables of markers."""
    for k, (_, row) in enumerate(body):
        if row[0].strip() and not _number(row[0]):
            return body[:k]
    return body


def _number(cell: str) -> bool:
    return re.fullmatch(r"[-+]?\d[\d.,eE+-]*", cell.strip()) is not None


def _layout(names: Sequence[str], row: Sequence[str], file: Path) -> list[tuple[int, int, int]]:
    """Return for each channel its column in the header, in the rows, and that of its times (-1 for none)."""
    timed = len(row) >= len(names)
    found, time, column = [], -1, 0
    for j, name in enumerate(names):
        if name == NAME:
            time = column if timed else -1
            column += timed
        else:
            found.append((j, column, time))
            column += 1
    if not found:
        raise LogError("names no channel", file=file)
    return found


def _values(body: Sequence[tuple[int, Sequence[str]]], width: int, comma: bool, file: Path, names: Mapping[int, str]) -> Array:
    found = np.full((len(body), width), np.nan)
    for i, (line, cells) in enumerate(body):
        try:
            found[i] = list(map(float, cells[:width]))  # a full row of plain numbers, the quicker way
        except ValueError:
            for j, cell in enumerate(cells[:width]):
                decimal = comma or ("," in cell and "." not in cell)
                found[i, j] = cell_number(cell, names.get(j, str(j + 1)), file, line, decimal)
    return found


def _channel(heads: dict[str, list[str]], values: Array, head: int, column: int, time: int) -> Channel:
    period = number(heads[PERIOD][head], comma=True) * 1e-3
    there = np.isfinite(values[:, column])
    if time >= 0:
        there &= np.isfinite(values[:, time])
        stamps = values[there, time]
        seconds = (stamps - stamps[:1]) * TICK if stamps.size and stamps[0] > FILE_TIME else stamps * 1e-3
    else:
        seconds = np.arange(np.count_nonzero(there)) * period
    # "dV (Voltage)": the unit, and what it measures.
    unit = _said(heads, UNIT, head).partition("(")[0].strip()
    return Channel(heads[NAME][head], values[there, column], unit, seconds, symbol=_said(heads, SYMBOL, head))


def _said(heads: Mapping[str, Sequence[str]], key: str, head: int) -> str:
    """Return what a line of the head says of a channel, nothing where it is not there."""
    cells = heads.get(key, ())
    return cells[head] if head < len(cells) else ""


def _notes(heads: dict[str, list[str]]) -> tuple[str, ...]:
    scaled = [name for name, factor in zip(heads[NAME], heads.get("ScaleFactor", []), strict=False) if _number(factor) and factor != "1"]
    return (f"scaled by the scope, as its export is set by default: {', '.join(scaled)}",) if scaled else ()
