"""What a scenario is once it has been read: frozen values, from which the cases of a comparison follow."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path as File
from typing import Any, Literal, TypeAlias

import numpy as np

from contourlab.contours import ContourReading, study_contour
from contourlab.errors import FeedError, ProgramError, ScenarioError
from contourlab.feed import AxisLimits, Reference, Route, blended, plan, route_from_path, route_from_program, uniform
from contourlab.feed.path_control import PathControl, controlled
from contourlab.geometry import Path, contour
from contourlab.loop import Controller, Machine
from contourlab.program import Program, Reading
from contourlab.scenario.motion_check import check_motion
from contourlab.scenario.placing import placed

__all__ = ["DEFAULT_CORNER_TOLERANCE", "Case", "Contour", "FeedSettings", "Motion", "Overrides", "PartProgram", "RunSettings", "Scenario"]

DEFAULT_CORNER_TOLERANCE = 1e-5
"""How far a blend may leave its corner under G64 without P [m]."""

MOST_NOTICES = 5
"""So many places are named where the reader of a program was lenient."""

Overrides: TypeAlias = Mapping[str, object]
"""What a scheme changes: dotted key -> value as written."""


@dataclass(frozen=True)
class Contour:
    """A contour: a test contour by name, or one from a file.

    Attributes
    ----------
    name : str
        One of `contourlab.geometry.contour_names`; the name of the file where there is one.
    parameters : mapping of str to float
        Of a test contour, in m and rad; those that were given.
    file : Path or None
        Drawing or points.
    options : mapping of str to object
        What was said of the file: arguments of `contourlab.contours.read_contour`.
    offset : tuple of float [m]
        How far it is moved along each of the machine's first axes.
    axes : tuple of str
        The machine's axes, where it may have more of them than the contour: the others hold still.
    """

    name: str
    parameters: Mapping[str, float] = field(default_factory=dict)
    file: File | None = None
    options: Mapping[str, Any] = field(default_factory=dict)
    offset: tuple[float, ...] = ()
    axes: tuple[str, ...] = ()

    @cached_property
    def reading(self) -> ContourReading:
        """The contour, and what there is to say about how it came about."""
        if self.file is None:
            return ContourReading(contour(self.name, **self.parameters))
        return study_contour(self.file, **self.options)

    @cached_property
    def path(self) -> Path:
        """The contour as a path of all the machine's axes."""
        found = self.reading.path
        missing = max(len(self.axes), found.n_axis) - len(self.offset)
        return placed(found, (*self.offset, *[0.0] * missing))

    @property
    def n_axis(self) -> int:
        """Number of coordinates."""
        return self.path.n_axis

    @property
    def notes(self) -> tuple[str, ...]:
        """What there is to say about how the contour came about."""
        said = () if self.file is None else tuple(self.reading.notes)
        n = self.reading.path.n_axis
        if n >= len(self.axes):
            return said
        places = dict.fromkeys(self.axes[n:], 0.0) | dict(zip(self.axes, self.offset, strict=False))
        still = ", ".join(f"{name} at {places[name] * 1e3:g} mm" for name in self.axes[n:])
        return (*said, f"the contour moves {' and '.join(self.axes[:n])}; held still: {still}")


@dataclass(frozen=True)
class PartProgram:
    """A part program.

    Attributes
    ----------
    file : Path
    program : Program
    letters : tuple of str
        The address (x, y, z) that each axis of the machine obeys, in the order of the machine's axes.
    reading : Reading
        How it was read.
    fit : bool
        Whether it was to be brought into the machine's travel.
    note : str
        What was done to it for that.
    """

    file: File
    program: Program
    letters: tuple[str, ...]
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
        """Where the reader was lenient, and what was done to the program."""
        lenient = [f"line {notice.line}: {notice.message}" for notice in self.program.notices[:MOST_NOTICES]]
        more = len(self.program.notices) - len(lenient)
        return (*lenient, *([f"{more} more such lines"] if more > 0 else []), *([self.note] if self.note else []))


Motion: TypeAlias = Contour | PartProgram


@dataclass(frozen=True)
class FeedSettings:
    """How the path is driven along.

    Attributes
    ----------
    law : {"planned", "uniform"}
        From rest to rest within the limits of the axes, or laps at constant frequency.
    feedrate : float [m/s] or None
        Of a planned contour; a program has its own.
    frequency : float [Hz] or None
        Laps per second of the uniform law.
    laps : int, >= 1
    override : float, > 0
        Factor on feedrate or frequency.
    path_control : {"program", "exact_path", "exact_stop", "blend"}
        How corners are met: as the program says, or one way throughout. A contour says nothing: its corners are met exactly.
    corner_tolerance : float [m], > 0, or None
        How far a blend may leave its corner, where G64 has no P or ``path_control`` is ``"blend"``; by default 10 um.
    merge_tolerance : float [m], >= 0, or None
        How far points of lines that are merged may lie off, where ``path_control`` is ``"blend"``; by default as `corner_tolerance`.
    curvature_step : float, 0 to 1
        By how much of its limit the acceleration of an axis may step where the curvature jumps, as from a line into an arc; 0 stops there.
    """

    law: Literal["planned", "uniform"] = "planned"
    feedrate: float | None = None
    frequency: float | None = None
    laps: int = 1
    override: float = 1.0
    path_control: PathControl = "program"
    corner_tolerance: float | None = None
    merge_tolerance: float | None = None
    curvature_step: float = 1.0


@dataclass(frozen=True)
class RunSettings:
    """What is kept of a run and what it is held against.

    Attributes
    ----------
    tolerance : float [m] or None
        Largest part error that passes; None for no verdict.
    signals : tuple of str or None
        Signals to write; None for all.
    seed : int
        Of all noise.
    evaluate : {"last-lap", "whole"}
        Samples that the figures are over.
    """

    tolerance: float | None = None
    signals: tuple[str, ...] | None = None
    seed: int = 0
    evaluate: Literal["last-lap", "whole"] = "last-lap"


@dataclass(frozen=True, eq=False)
class Case:
    """One machine under one controller along one motion."""

    name: str
    machine: Machine
    controller: Controller
    motion: Motion
    feed: FeedSettings
    run: RunSettings

    @property
    def tolerance(self) -> float | None:
        """Largest part error that passes [m]; None for no verdict."""
        return self.run.tolerance

    @property
    def signals(self) -> tuple[str, ...]:
        """Signals to write; empty for all."""
        return self.run.signals or ()

    @property
    def seed(self) -> int:
        """Of all noise."""
        return self.run.seed

    @property
    def notes(self) -> tuple[str, ...]:
        """What is to be known of the motion."""
        return self.motion.notes

    @property
    def lines(self) -> tuple[str, ...]:
        """Source text of the program; empty for a contour."""
        return self.motion.program.lines if isinstance(self.motion, PartProgram) else ()

    @property
    def curvature_step(self) -> float:
        """By how much of its limit the acceleration of an axis may step where the curvature jumps."""
        return self.feed.curvature_step

    @property
    def limits(self) -> AxisLimits:
        """Limits of the axes, for the planner.

        Raises
        ------
        FeedError
            If an axis has no velocity limit.
        """
        return self.machine.planner_limits()

    def reference(self, feed_scale: float = 1.0) -> Reference:
        """Return the sampled reference; without laps to count where ``run.evaluate`` asks for the whole motion.

        Parameters
        ----------
        feed_scale : float, > 0
            Factor on the programmed feed, on top of the scenario's own.

        Raises
        ------
        FeedError
            If the motion cannot be planned within the limits of the axes, leaves their travel, or takes too many samples.
        ProgramError
            If the program moves an axis that the machine lacks, or beyond its travel.
        """
        found = self._sampled(self.feed.override * feed_scale)
        check_motion(found, self.machine, self._fault, bounded=self.feed.law != "uniform", cure=self._cure)
        return replace(found, laps=()) if self.run.evaluate == "whole" else found

    @property
    def _cure(self) -> str:
        if isinstance(self.motion, Contour):
            example = ", ".join('"10 mm"' for _ in self.machine.axes)
            return f"move it with offset = [{example}] under [contour]"
        return "move the part" if self.motion.fit else "move the part, have it fitted (--fit, or fit = true under [program])"

    def closer(self, tolerance: float) -> dict[str, Callable[[], Reference]]:
        """Return ways, in words, of planning closer to the programmed path, and what makes the reference of each.

        Parameters
        ----------
        tolerance : float [m], > 0
            Within which corners would be blended.
        """
        if self.feed.law == "uniform":
            return {}
        microns = f"{tolerance * 1e6:.3g}"
        is_program = isinstance(self.motion, PartProgram)
        g64, g61 = (f"G64 P{tolerance * 1e3:.3g} in mm, or ", "G61, or ") if is_program else ("", "")
        near = {"path_control": "blend", "corner_tolerance": tolerance, "merge_tolerance": None}
        changes: dict[str, dict[str, Any]] = {
            f'blending within {microns} um ({g64}path_control = "blend", corner_tolerance = "{microns} um" under [feed])': near,
            f'meeting every corner exactly ({g61}path_control = "exact_path" under [feed])': {"path_control": "exact_path"},
        }
        return {words: replace(self, feed=replace(self.feed, **change)).reference for words, change in changes.items()}

    def _fault(self, message: str, line: int) -> FeedError | ProgramError:
        if isinstance(self.motion, PartProgram):
            return ProgramError(message, file=self.motion.file, line=line)
        return FeedError(f"{self.motion.name}: {message}")

    def _sampled(self, factor: float) -> Reference:
        period = self.machine.servo_period
        if self.feed.law == "uniform":
            assert isinstance(self.motion, Contour) and self.feed.frequency is not None  # said by the reader
            return uniform(self.motion.path, self.feed.frequency * factor, self.feed.laps, period)
        return plan(
            self._own_route if factor == self.feed.override else self._route(factor),
            self.limits,
            period,
            laps=self.feed.laps,
            curvature_step=self.feed.curvature_step,
        )

    def route(self) -> Route | None:
        """Return the path with its feedrates as it is planned along; None under the uniform law, which plans nothing."""
        return None if self.feed.law == "uniform" else self._own_route

    @cached_property
    def _own_route(self) -> Route:
        """The route at the case's own feed: it is planned, verified and drawn, but blended once."""
        return self._route(self.feed.override)

    def _route(self, factor: float) -> Route:
        tolerance = DEFAULT_CORNER_TOLERANCE if self.feed.corner_tolerance is None else self.feed.corner_tolerance
        if isinstance(self.motion, Contour):
            assert self.feed.feedrate is not None  # said by the reader
            route = route_from_path(self.motion.path, self.feed.feedrate)
        else:
            route = self.motion.route(tolerance)
        if factor != 1.0:
            route = replace(route, feedrate=np.where(route.rapid, route.feedrate, route.feedrate * factor))
        return blended(controlled(route, self.feed.path_control, tolerance, self.feed.merge_tolerance), self.limits)


@dataclass(frozen=True, eq=False)
class Scenario:
    """A scenario: the base, and schemes that change something of it.

    Attributes
    ----------
    name : str
    file : Path
    base : Case
        Machine, controller, motion, feed and run settings without any scheme.
    schemes : mapping of str to Overrides
        What each scheme changes.
    all_cases : tuple of Case
        One for each scheme; the base alone where there is none.
    files : tuple of Path
        Every file that was read.
    """

    name: str
    file: File
    base: Case
    schemes: Mapping[str, Overrides] = field(default_factory=dict)
    all_cases: tuple[Case, ...] = ()
    files: tuple[File, ...] = ()

    @property
    def machine(self) -> Machine:
        """The base's machine."""
        return self.base.machine

    @property
    def controller(self) -> Controller:
        """The base's controller."""
        return self.base.controller

    @property
    def motion(self) -> Motion:
        """What is driven along."""
        return self.base.motion

    @property
    def feed(self) -> FeedSettings:
        """The base's feed settings."""
        return self.base.feed

    @property
    def run(self) -> RunSettings:
        """The base's run settings."""
        return self.base.run

    def cases(self) -> list[Case]:
        """Return one case for each scheme, in the order of the file; the base alone where there is none."""
        return list(self.all_cases or (self.base,))

    def case(self, name: str) -> Case:
        """Return a case by the name of its scheme.

        Raises
        ------
        ScenarioError
            If there is none.
        """
        for case in self.cases():
            if case.name == name:
                return case
        raise ScenarioError(f"no scheme {name!r}: there are {', '.join(c.name for c in self.cases())}", file=self.file)

    @property
    def text(self) -> str:
        """The scenario as TOML: machine, controller and schemes joined in; a part program or a drawing is named by its path."""
        from contourlab.scenario.dump import dump

        return dump(self)
