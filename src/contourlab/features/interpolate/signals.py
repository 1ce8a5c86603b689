"""A record of quadrature signals out of a file: which columns are what."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ResultError
from contourlab.features.interpolate.signal_file import Column, SignalFile, open_signals

Array = NDArray[np.float64]
PAIRS = (("u1", "u2"), ("cos", "sin"), ("a", "b"))
"""Names of signals that are known without being told, the cosine first."""
TIMES = ("t", "time")
REFERENCE = "reference"


@dataclass(frozen=True, eq=False)
class QuadratureRecord:
    """The signals of a file.

    Parameters
    ----------
    source : SignalFile
    names : (str, str)
        Of the signals, the cosine first.
    unit : str
        Of the signals, as the file says it.
    u1, u2 : ndarray (n,)
        In that unit.
    time : ndarray (n,) [s] or None
    reference : ndarray (n,) [m] or None
        True position.
    reference_name : str
    """

    source: SignalFile
    names: tuple[str, str]
    unit: str
    u1: Array
    u2: Array
    time: Array | None
    reference: Array | None
    reference_name: str


def read_quadrature(file: str | Path, columns: str | None = None, reference: str | None = None) -> QuadratureRecord:
    """Find the columns of a record of quadrature signals, and read them.

    Parameters
    ----------
    file : str or Path
        See `contourlab.features.interpolate.signal_file.open_signals`.
    columns : str, optional
        The signals by name or number, ``"u1,u2"``; by default u1 and u2, cos and sin, a and b, or the only two columns.
    reference : str, optional
        The column of the true position; by default one called "reference", if there is one.

    Raises
    ------
    ResultError
        If a column is not there or cannot be read, with its line.
    """
    source = open_signals(file)
    first, second = _signal_columns(source, columns)
    if first.index == second.index:
        raise ResultError(f"{source.file}: column {first.name} is named twice: the two signals of an encoder are wanted")
    if first.unit != second.unit:
        raise ResultError(f"{source.file}: {first.name} is in {first.unit or 'no unit'}, {second.name} in {second.unit or 'no unit'}")
    known = {column.name.lower(): column for column in source.columns}
    true = source.find(reference) if reference is not None else known.get(REFERENCE)
    clock = next((known[name] for name in TIMES if name in known), None)
    chosen = [first, second, *(column for column in (clock, true) if column is not None)]
    length = 1.0 if true is None else true.factor("m", source.file)
    second_size = 1.0 if clock is None or not clock.unit else clock.factor("s", source.file)
    numbers = np.ascontiguousarray(source.read(tuple(chosen)).T)
    return QuadratureRecord(
        source,
        (first.name, second.name),
        first.unit,
        numbers[0],
        numbers[1],
        None if clock is None else numbers[2] * second_size,
        None if true is None else numbers[-1] * length,
        "" if true is None else true.name,
    )


def _signal_columns(source: SignalFile, columns: str | None) -> tuple[Column, Column]:
    if columns is not None:
        names = columns.split(",")
        if len(names) != 2:
            raise ResultError(f"--columns {columns}: two names with a comma in between are wanted, the cosine first, such as u1,u2")
        return source.find(names[0]), source.find(names[1])
    known = {column.name.lower(): column for column in source.columns}
    for one, other in PAIRS:
        if one in known and other in known:
            return known[one], known[other]
    if len(source.columns) == 2:
        return source.columns[0], source.columns[1]
    there = ", ".join(column.name for column in source.columns)
    raise ResultError(f"{source.file}: which columns are the signals? say --columns u1,u2; there are: {there}")
