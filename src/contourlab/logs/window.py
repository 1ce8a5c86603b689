"""A part of a log, as it is typed: times, samples, or lines of the part program."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import LogError, ParameterError, refuse, refused
from contourlab.logs.reading import Blocks, Record, quoted
from contourlab.units import to_si

WANTED = 'two times, as "10.706 s..14 s", samples, as "0..1493", or lines, as "line 20..line 40"; either end may be left out'
CLOSE = 0.01
"""How close to an end of a window, in sample periods, a sample is in it: times are rounded when written."""
FEW = 3
"""Most gaps at all of which a log is divided; with more, at the longest alone."""


@dataclass(frozen=True)
class Window:
    """A part of a log; both ends are in it.

    Attributes
    ----------
    kind : str
        ``"time"`` and ``"sample"`` count from the first sample of the log; ``"line"`` is a line of the part program.
    first, last : float [s, or 1]
        -inf and inf where an end is left out.
    """

    kind: str
    first: float
    last: float

    def __str__(self) -> str:
        form = {"time": "{:.9g} s", "sample": "{:.0f}", "line": "line {:.0f}"}[self.kind]
        return "..".join(form.format(end) if math.isfinite(end) else "" for end in (self.first, self.last))


def parse_window(text: str) -> Window:
    """Read a window.

    Raises
    ------
    ParameterError
        If it is none.

    >>> parse_window("10.706 s..14 s"), str(parse_window("1494.."))
    (Window(kind='time', first=10.706, last=14.0), '1494..')
    """
    first, dots, last = text.partition("..")
    with refused("--window", text, WANTED):
        (kind, start), (other, stop) = _end(first), _end(last)
        kinds = {kind, other} - {""}
        if not dots or len(kinds) != 1:
            raise ValueError
        window = Window(kinds.pop(), start if kind else -math.inf, stop if other else math.inf)
    refuse(not window.first <= window.last, ParameterError, "--window", repr(text), "the earlier one first")
    return window


def _end(text: str) -> tuple[str, float]:
    """Return kind and value of an end; empty and 0 for none."""
    line = re.fullmatch(r"(line\s+|)(\d+)", text.strip())
    if line is not None:
        return ("line" if line[1] else "sample"), float(line[2])
    return ("time", to_si(text.strip(), "s")) if text.strip() else ("", 0.0)


def inside(window: Window | None, times: Mapping[str, Array], blocks: Blocks | None, record: Record) -> dict[str, Flags]:
    """Return for each column which of its samples are in a window, from their times [s], nan where unknown.

    Raises
    ------
    LogError
        If none is, or the log does not say.
    """
    if window is None:
        return {name: np.ones(time.size, dtype=bool) for name, time in times.items()}
    if window.kind == "sample":
        if not share_rows(times.values()):
            raise LogError(f"--window {window}: its columns have sample times of their own: give the window in times", file=record.file)
        chosen = {name: _between(np.arange(time.size), window.first, window.last) for name, time in times.items()}
    elif window.kind == "line":
        start, stop = _span_of_lines(window, blocks, record.file)
        chosen = {name: _between(time, start - CLOSE * _step(time), stop - CLOSE * _step(time)) for name, time in times.items()}
    else:
        begin = start_of(times.values())
        near = {name: CLOSE * _step(time) for name, time in times.items()}
        chosen = {name: _between(time - begin, window.first - near[name], window.last + near[name]) for name, time in times.items()}
    if not all(one.any() for one in chosen.values()):
        last = max(float(np.nanmax(time)) for time in times.values()) - start_of(times.values())
        samples = max(time.size for time in times.values())
        raise LogError(f"has no sample in --window {window}: it has samples 0..{samples - 1}, times 0 s..{last:.9g} s", file=record.file)
    return chosen


def _between(values: Array | Index, first: float, last: float) -> Flags:
    return np.asarray((values >= first) & (values <= last))


def _step(time: Array) -> float:
    """Return the usual step [s] of times (n,)."""
    known = time[np.isfinite(time)]
    return float(np.median(np.abs(np.diff(known)))) if known.size > 1 else 0.0


def start_of(times: Iterable[Array]) -> float:
    """Return the first time [s] that all columns cover."""
    return max((float(time[np.isfinite(time)][0]) for time in times if np.isfinite(time).any()), default=0.0)


def share_rows(times: Iterable[Array]) -> bool:
    """Return whether all columns have the same sample times, so that a number of a sample means a row of the file."""
    first, *others = times
    return all(np.array_equal(first, other, equal_nan=True) for other in others)


def _span_of_lines(window: Window, blocks: Blocks | None, file: Path) -> tuple[float, float]:
    """Return the times [s] from the begin of the first block of the lines to the end of the last."""
    if blocks is None:
        raise LogError(f"--window {window}: it has no program lines; name their column, as --column line=NAME", file=file)
    among = np.flatnonzero(_between(blocks.line, max(window.first, 1.0), window.last))
    if not among.size:
        known = blocks.line[blocks.line > 0]
        lines = f"lines {known.min()} to {known.max()}" if known.size else "none"
        raise LogError(f"has no program line in --window {window}: it has {lines}", file=file)
    programs = list(dict.fromkeys(blocks.program[k] for k in among)) if blocks.program else []
    if len(programs) > 1:
        raise LogError(f"--window {window}: several programs have such lines, {quoted(programs, 4)}: give times or samples", file=file)
    begin, after = float(blocks.time[among[0]]), int(among[-1]) + 1
    end = float(blocks.time[after]) if after < blocks.time.size else math.inf
    return begin if math.isfinite(window.first) else -math.inf, end if math.isfinite(window.last) else math.inf


def between_gaps(gaps: Sequence[tuple[int, int]], time: Array, rows: Index | None, start: float) -> tuple[str, ...]:
    """Return the windows, as typed, of the parts of a log between its gaps.

    Parameters
    ----------
    gaps : sequence of (int, int)
        Index of the sample before each gap, and its length in samples.
    time : ndarray (n,) [s]
    rows : ndarray (n,) of int, or None
        Numbers of the samples in the file; None for windows in times.
    start : float [s]
        Time from which windows count.
    """
    cuts = sorted(k + 1 for k, _ in gaps) if len(gaps) <= FEW else [max(gaps, key=lambda gap: gap[1])[0] + 1]
    edges = [0, *cuts, time.size]
    parts = [(a, b - 1) for a, b in pairwise(edges) if b - a >= 3]
    ends = [("time", time[a] - start, time[b] - start) if rows is None else ("sample", rows[a], rows[b]) for a, b in parts]
    return tuple(f'--window "{Window(kind, float(first), float(last))}"' for kind, first, last in ends)
