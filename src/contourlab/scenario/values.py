"""Values of a scenario besides machine and controller: motion, feed, run and learning."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path as File
from typing import Any, Literal, TypeAlias

from contourlab.components.learning.law import LearningLaw
from contourlab.contours import ContourReading, study_contour
from contourlab.errors import hint
from contourlab.feed import Route, route_from_program
from contourlab.feed.route import PathControl
from contourlab.geometry import Path, contour
from contourlab.loop.simulate import UNITS
from contourlab.program import Program, Reading
from contourlab.scenario.placing import placed
from contourlab.units import setting

DISTANCE = setting("m", "um", minimum=0.0, maximum=1.0, exclusive=True)
"""A tolerance."""

DEFAULT_CORNER_TOLERANCE = 1e-5
"""Corner tolerance of G64 without P [m]."""

MOST_NOTICES = 5
"""Most reader notices that are listed."""


@dataclass(frozen=True)
class Contour:
    """A contour: a test contour by name, or one from a file.

    Attributes
    ----------
    name : str
        One of `contourlab.geometry.contour_names`, or the file name.
    parameters : mapping of str to float
        Given parameters of a test contour [m, rad].
    file : Path or None
        Drawing or points.
    options : mapping of str to object
        Arguments of `contourlab.contours.read_contour`.
    offset : tuple of float [m]
        Shift along each of the machine's first axes.
    axes : tuple of str
        The machine's axes; those beyond the contour's coordinates hold still.
    """

    name: str
    parameters: Mapping[str, float] = field(default_factory=dict)
    file: File | None = field(default=None, metadata=setting())
    options: Mapping[str, Any] = field(default_factory=dict)
    offset: tuple[float, ...] = field(default=(), metadata=setting("m", "mm"))
    axes: tuple[str, ...] = ()

    @cached_property
    def reading(self) -> ContourReading:
        """The contour, and notes on how it was read."""
        if self.file is None:
            return ContourReading(contour(self.name, **self.parameters))
        return study_contour(self.file, **self.options)

    @cached_property
    def path(self) -> Path:
        """The path in all axes of the machine."""
        path = self.reading.path
        missing = max(len(self.axes), path.n_axis) - len(self.offset)
        return placed(path, (*self.offset, *[0.0] * missing))

    @property
    def n_axis(self) -> int:
        """Number of coordinates."""
        return self.path.n_axis

    @property
    def notes(self) -> tuple[str, ...]:
        """Notes on the reading of the contour, and on axes that hold still."""
        notes = () if self.file is None else tuple(self.reading.notes)
        n = self.reading.path.n_axis
        if n >= len(self.axes):
            return notes
        places = dict.fromkeys(self.axes[n:], 0.0) | dict(zip(self.axes, self.offset, strict=False))
        still = ", ".join(f"{name} at {places[name] * 1e3:g} mm" for name in self.axes[n:])
        return (*notes, f"the contour moves {' and '.join(self.axes[:n])}; held still: {still}")


@dataclass(frozen=True)
class PartProgram:
    """A part program.

    Attributes
    ----------
    file : Path
    program : Program
    letters : tuple of str
        Program letter (x, y, z) of each axis of the machine.
    reading : Reading
        Options of the reader.
    fit : bool
        Whether it was fitted into the machine's travel.
    note : str
        How it was fitted.
    """

    file: File = field(metadata=setting())
    program: Program
    letters: tuple[str, ...] = field(metadata=setting(choices=("x", "y", "z")))
    reading: Reading = field(default_factory=Reading)
    fit: bool = False
    note: str = ""
    _routes: dict[float, Route] = field(default_factory=dict, init=False, repr=False, compare=False)

    def route(self, corner_tolerance: float) -> Route:
        """Return the path of the program with its feedrates; `corner_tolerance` [m] is that of G64 without P."""
        if corner_tolerance not in self._routes:
            self._routes[corner_tolerance] = route_from_program(self.program, self.letters, default_tolerance=corner_tolerance)
        return self._routes[corner_tolerance]

    @property
    def n_axis(self) -> int:
        """Number of coordinates."""
        return len(self.letters)

    @property
    def notes(self) -> tuple[str, ...]:
        """Notices of the reader, and how the program was fitted."""
        lenient = [f"line {notice.line}: {notice.message}" for notice in self.program.notices[:MOST_NOTICES]]
        more = len(self.program.notices) - len(lenient)
        return (*lenient, *([f"{more} more such lines"] if more > 0 else []), *([self.note] if self.note else []))


Motion: TypeAlias = Contour | PartProgram


@dataclass(frozen=True)
class FeedSettings:
    """Feed along the path.

    Attributes
    ----------
    law : {"planned", "uniform"}
        Rest to rest within the limits of the axes, or laps at constant frequency.
    feedrate : float [m/s] or None
        Feedrate of a planned contour; a program has its own.
    frequency : float [Hz] or None
        Laps per second of the uniform law.
    laps : int, >= 1
    override : float, > 0
        Factor on feedrate or frequency.
    path_control : {"program", "exact_path", "exact_stop", "blend"}
        How corners are met; a contour under ``"program"`` is followed exactly.
    corner_tolerance : float [m], > 0, or None
        Corner tolerance for G64 without P and ``path_control = "blend"``; by default 10 um.
    merge_tolerance : float [m], >= 0, or None
        Deviation of merged lines with ``path_control = "blend"``; by default `corner_tolerance`.
    curvature_step : float, 0 to 1
        Allowed step of an axis acceleration, as a share of its limit, where the curvature jumps; 0 stops there.
    """

    law: Literal["planned", "uniform"] = "planned"
    feedrate: float | None = field(default=None, metadata=setting("m/s", "mm/min", minimum=0.0, exclusive=True))
    frequency: float | None = field(default=None, metadata=setting("Hz", minimum=0.0, exclusive=True))
    laps: int = field(default=1, metadata=setting(minimum=1, maximum=100_000))
    override: float = field(default=1.0, metadata=setting(minimum=0.0, maximum=2.0, exclusive=True))
    path_control: PathControl = "program"
    corner_tolerance: float | None = field(default=None, metadata=DISTANCE)
    merge_tolerance: float | None = field(default=None, metadata=setting("m", "um", minimum=0.0))
    curvature_step: float = field(default=1.0, metadata=setting(minimum=0.0, maximum=1.0))


JUDGED_LINES = re.compile(r"lines ([1-9]\d{0,8})(?:-([1-9]\d{0,8}))?")


def checked_judge(choice: str) -> str:
    """Return a choice of the moves to judge, as in `RunSettings`.

    Raises
    ------
    ValueError
        If it is none.
    """
    lines = JUDGED_LINES.fullmatch(choice)
    if choice not in ("cutting", "all") and (lines is None or int(lines[1]) > int(lines[2] or lines[1])):
        raise ValueError(f'{choice!r}: write "cutting", "all" or "lines 10-40"')
    return choice


JUDGED = ("contour_error", "part_error", "planning_deviation", "foot_arc_length", "tracking_error")
"""Signals that the judge adds to those of a run."""


def _checked_signal(name: str) -> str:
    known = (*UNITS, *JUDGED)
    if name not in known:
        raise ValueError(f"no signal {name!r}: {hint(name, known)}")
    return name


@dataclass(frozen=True)
class RunSettings:
    """Signals, seed and verdict of a run.

    Attributes
    ----------
    tolerance : float [m] or None
        Largest part error that passes; None for no verdict.
    signals : tuple of str or None
        Signals to write; None for all.
    seed : int
        Seed of all noise.
    judge : str
        ``"cutting"``: the cutting moves, or the last lap of a contour; ``"all"``; ``"lines 10-40"``: the cutting moves of these lines.
    start : {"rest", "moving"}
        Whether the axes have the velocity of the reference at the first sample.
    """

    tolerance: float | None = field(default=None, metadata=DISTANCE)
    signals: tuple[str, ...] | None = field(default=None, metadata=setting(check=_checked_signal))
    seed: int = field(default=0, metadata=setting(minimum=0, maximum=2**63 - 1))
    judge: str = field(default="cutting", metadata=setting(check=checked_judge))
    start: Literal["rest", "moving"] = "rest"


@dataclass(frozen=True)
class LearningSettings:
    """Learning settings of a case.

    Attributes
    ----------
    law : LearningLaw
    trials : int
        Most trials after the first.
    improvement : float, 0 to 1
        Learning has converged once `patience` trials improve the contour error by no more than this share.
    patience : int
    table : path or None
        Initial learned table.
    """

    law: LearningLaw
    trials: int = field(default=30, metadata=setting(minimum=1, maximum=100_000))
    improvement: float = field(default=0.01, metadata=setting(minimum=0.0, maximum=1.0))
    patience: int = field(default=10, metadata=setting(minimum=2, maximum=100_000))
    table: File | None = field(default=None, metadata=setting())
