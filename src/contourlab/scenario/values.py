"""A scenario and its cases. Schemes are named by parts joined with +: ``fb``, ``ccc``, ``mr``, ``me``, ``ilc``."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path as File
from typing import Any, Literal, TypeAlias

import numpy as np

from contourlab.components.learning.law import LearningLaw
from contourlab.components.registry import component
from contourlab.contours import ContourReading, study_contour
from contourlab.errors import FeedError, ParameterError, ProgramError, ScenarioError, hint, refuse
from contourlab.feed import AxisLimits, Reference, Route, blended, plan, route_from_path, route_from_program, uniform
from contourlab.feed.bounds import Grbl, LinuxCNC
from contourlab.feed.reference import WHOLE, Judged
from contourlab.feed.route import PathControl, controlled
from contourlab.geometry import Path, contour
from contourlab.loop import Change, Controller, Machine
from contourlab.loop.machine import Planner
from contourlab.loop.simulate import UNITS
from contourlab.notebook import facts_line
from contourlab.program import Mode, Program, Reading
from contourlab.result.signals import JUDGED
from contourlab.scenario.placing import beyond_travel, check_motion, check_route, placed
from contourlab.units import setting

DISTANCE = setting("m", "um", minimum=0.0, maximum=1.0, exclusive=True)
"""A tolerance."""

DEFAULT_CORNER_TOLERANCE = 1e-5
"""Corner tolerance of G64 without P [m]."""


def free_tolerance(planner: Grbl | LinuxCNC | None) -> float:
    """Return how far a control rounds corners under G64 without P [m]: inf for no bound."""
    return math.inf if isinstance(planner, LinuxCNC) else DEFAULT_CORNER_TOLERANCE


def program_route(
    program: Program,
    axes: Sequence[str],
    tolerance: float | None = None,
    planner: Grbl | LinuxCNC | None = None,
    mode: Mode | None = None,
) -> Route:
    """Return the path of a program with its feedrates.

    `tolerance` [m] is that of G64 without P, by default the one of the planner; `mode` stands in place of the program's own.
    """
    own, allowed = isinstance(planner, LinuxCNC), free_tolerance(planner) if tolerance is None else tolerance
    return route_from_program(program, axes, default_tolerance=allowed, default_control="blend" if own else "exact_path", mode=mode)


def program_motion(program: Program, axes: Sequence[str], limits: AxisLimits, servo_period: float) -> Reference:
    """Return the motion of a program, planned within limits.

    Raises
    ------
    ProgramError, FeedError
        If it cannot be planned.
    """
    return plan(blended(program_route(program, axes, planner=limits.planner), limits), limits, servo_period)


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
        places = dict(zip(self.axes, self.offset, strict=False))
        still = ", ".join(f"{name} at {places.get(name, 0.0) * 1e3:g} mm" for name in self.axes[n:])
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
    _routes: dict[Any, Route] = field(default_factory=dict, init=False, repr=False, compare=False)

    def route(self, corner_tolerance: float | None, planner: Grbl | LinuxCNC | None = None, mode: Mode | None = None) -> Route:
        """Return the path of the program with its feedrates, as `program_route`."""
        if (key := (corner_tolerance, planner, mode)) not in self._routes:
            self._routes[key] = program_route(self.program, self.letters, *key)
        return self._routes[key]

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
        Deviation of merged lines and fitted curves with ``path_control = "blend"``; by default `corner_tolerance`.
    curvature_step : float, 0 to 1
        Allowed step of an axis acceleration, as a share of its limit, where the curvature jumps; 0 stops there.
    path_velocity : float [m/s], > 0, or None
        Largest velocity along a planned path, rapids included; by default that of the machine.
    planner : {"jerk", "grbl", "linuxcnc"} or None
        How the control plans, in place of the machine's key.
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
    path_velocity: float | None = field(default=None, metadata=setting("m/s", "mm/min", minimum=0.0, exclusive=True))
    planner: Planner | None = None

    def default_tolerance(self, planner: Grbl | LinuxCNC | None) -> float:
        """Return the corner tolerance of G64 without P [m]."""
        return free_tolerance(planner) if self.corner_tolerance is None else self.corner_tolerance


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


@dataclass(frozen=True, eq=False)
class Case:
    """A machine under a controller along a motion, with learning and controller changes.

    Attributes
    ----------
    name : str
    machine : Machine
    controller : Controller
    motion : Motion
        Contour or part program.
    feed : FeedSettings
    run : RunSettings
    learning : LearningSettings or None
    changes : tuple of Change
        Controllers that take over during the run.
    """

    name: str
    machine: Machine
    controller: Controller
    motion: Motion
    feed: FeedSettings
    run: RunSettings
    learning: LearningSettings | None = None
    changes: tuple[Change, ...] = ()

    def __repr__(self) -> str:
        motion = self.motion.name if isinstance(self.motion, Contour) else self.motion.program.name
        return facts_line("Case", {"name": self.name, "machine": self.machine.name, "motion": motion, "controller": self.controller})

    @property
    def tolerance(self) -> float | None:
        """Largest part error that passes [m]; None for no verdict."""
        return self.run.tolerance

    @property
    def moving(self) -> bool:
        """Whether the axes have the velocity of the reference at the first sample."""
        return self.run.start == "moving"

    @property
    def lines(self) -> tuple[str, ...]:
        """Source text of the program; empty for a contour."""
        return self.motion.program.lines if isinstance(self.motion, PartProgram) else ()

    def reference(self, feed_scale: float = 1.0) -> Reference:
        """Return the sampled reference, with the samples that ``run.judge`` chooses.

        Parameters
        ----------
        feed_scale : float, > 0
            Factor on the programmed feed, besides the scenario's override.

        Raises
        ------
        FeedError
            If the motion cannot be planned within the limits of the axes, leaves their travel, or takes too many samples; or if
            ``run.judge`` names lines without a cutting move.
        ProgramError
            If the program moves an axis that the machine lacks, or beyond its travel.
        """
        if isinstance(self.motion, PartProgram):
            for name, (line, at) in beyond_travel(self.motion.program.machine_points, self.motion.letters, self.machine).items():
                raise self._fault(f"CL989 G53 leads axis {name} to {1e3 * at:.6g} mm, outside of its travel", line)
        reference = self._sampled(self.feed.override * feed_scale)
        check_motion(reference, self.machine, self._fault, bounded=self.feed.law != "uniform", cure=self._cure)
        return replace(reference, chosen=self._chosen(reference))

    def _chosen(self, reference: Reference) -> Judged | None:
        """Return the samples that ``run.judge`` chooses; None for the default."""
        choice = self.run.judge
        if choice == "cutting":
            return None
        if choice == "all":
            return Judged(((0, reference.n_sample),), WHOLE)
        named = JUDGED_LINES.fullmatch(choice)
        assert named is not None  # checked by the reader
        first, last = int(named[1]), int(named[2] or named[1])
        breaks, lines = reference.line_breaks, reference.source_lines
        chosen = (lines >= first) & (lines <= last)
        if reference.rapid is not None:
            chosen &= ~reference.rapid[reference.path.curve_index(0.5 * (breaks[1:] + breaks[:-1]))]
        refuse(not chosen.any(), self._fault, f'judge = "{choice}": no cutting move is on these lines; write other lines, or "all"', 0)
        return Judged(reference.between(breaks, chosen), f"cutting moves of {choice}")

    @property
    def _cure(self) -> str:
        if isinstance(self.motion, Contour):
            example = ", ".join('"10 mm"' for _ in self.machine.axes)
            return f"move it with offset = [{example}] under [contour]"
        return "move the part" if self.motion.fit else "move the part, have it fitted (--fit, or fit = true under [program])"

    def closer(self, tolerance: float) -> dict[str, Callable[[], Reference]]:
        """Return ways to plan closer to the programmed path: a description, and a function that plans.

        Parameters
        ----------
        tolerance : float [m], > 0
            Corner tolerance of a blend.
        """
        if self.feed.law == "uniform" or isinstance(self.machine.own_planner, Grbl):
            return {}
        microns = f"{tolerance * 1e6:.3g}"
        is_program = isinstance(self.motion, PartProgram)
        g64, g61 = (f"G64 P{tolerance * 1e3:.3g} in mm, or ", "G61, or ") if is_program else ("", "")
        near = {"path_control": "blend", "corner_tolerance": tolerance, "merge_tolerance": None}
        changes: dict[str, dict[str, Any]] = {
            f'blending within {microns} um ({g64}path_control = "blend", corner_tolerance = "{microns} um" under [feed])': near,
            f'meeting every corner exactly ({g61}path_control = "exact_path" under [feed])': {"path_control": "exact_path"},
        }
        return {way: replace(self, feed=replace(self.feed, **change)).reference for way, change in changes.items()}

    def _fault(self, message: str, line: int) -> FeedError | ProgramError:
        if isinstance(self.motion, PartProgram):
            return ProgramError(message, file=self.motion.file, line=line)
        return FeedError(message, self.motion.name)

    def _sampled(self, factor: float) -> Reference:
        period = self.machine.servo_period
        if self.feed.law == "uniform":
            assert isinstance(self.motion, Contour) and self.feed.frequency is not None  # checked by the reader
            return uniform(self.motion.path, self.feed.frequency * factor, self.feed.laps, period)
        route = self._own_route if factor == self.feed.override else self._route(factor)
        return plan(route, self.limits, period, laps=self.feed.laps, curvature_step=self.feed.curvature_step)

    @property
    def limits(self) -> AxisLimits:
        """Limits that the plan keeps."""
        limits, own = self.machine.planner_limits(), self.feed.path_velocity
        return limits if own is None else replace(limits, path_velocity=own)

    def route(self) -> Route | None:
        """Return the path to plan along, with feedrates; None under the uniform law."""
        return None if self.feed.law == "uniform" else self._own_route

    @cached_property
    def _own_route(self) -> Route:
        """The route at the case's own feed, blended once for planning, verifying and drawing."""
        return self._route(self.feed.override)

    def _route(self, factor: float) -> Route:
        planner = self.machine.own_planner
        tolerance = self.feed.default_tolerance(planner)
        control, merge = self.feed.path_control, self.feed.merge_tolerance
        if isinstance(self.motion, Contour):
            assert self.feed.feedrate is not None  # checked by the reader
            route = controlled(route_from_path(self.motion.path, self.feed.feedrate), control, tolerance, merge)
        else:
            merge = (tolerance if tolerance < math.inf else 0.0) if merge is None else merge
            route = self.motion.route(tolerance, planner, None if control == "program" else Mode(control, tolerance, merge))
        if factor != 1.0:
            route = replace(route, feedrate=np.where(route.rapid, route.feedrate, route.feedrate * factor))
        check_route(route, self.machine, self._fault, self._cure)
        return blended(route, self.limits)


@dataclass(frozen=True, eq=False)
class Scenario:
    """A base case, and schemes that change parts of it.

    Attributes
    ----------
    name : str
    file : Path
    base : Case
        The case without any scheme.
    all_cases : tuple of Case
        One for each scheme; the base alone without schemes.
    files : tuple of Path
        The scenario's file and all files it includes.
    """

    name: str = field(metadata=setting(maximum=200))
    file: File
    base: Case
    all_cases: tuple[Case, ...] = ()
    files: tuple[File, ...] = ()

    def __repr__(self) -> str:
        return facts_line("Scenario", {"name": self.name, "file": self.file, "cases": ", ".join(case.name for case in self.cases())})

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
        """The base's motion."""
        return self.base.motion

    @property
    def inputs(self) -> tuple[File, ...]:
        """All input files: `files`, drawing or part program, tool table, learned tables."""
        motion = self.motion
        tools = motion.reading.tools if isinstance(motion, PartProgram) else None
        tables = [case.learning.table for case in self.cases() if case.learning is not None]
        return (*self.files, *(File(file) for file in (motion.file, tools, *tables) if file is not None))

    def judging(self, choice: str | None) -> Scenario:
        """Return the scenario with another choice of the moves to judge in all its cases; itself for None.

        Raises
        ------
        ParameterError
            If there is no such choice.
        """
        if choice is None:
            return self
        try:
            checked_judge(choice)
        except ValueError:
            raise ParameterError("--judge", repr(choice), 'cutting, all, or lines such as "lines 10-40"') from None
        base, *others = (replace(case, run=replace(case.run, judge=choice)) for case in (self.base, *self.all_cases))
        return replace(self, base=base, all_cases=tuple(others))

    def cases(self) -> list[Case]:
        """Return one case for each scheme, in the order of the file; the base alone without schemes."""
        return list(self.all_cases or (self.base,))

    def case(self, name: str) -> Case:
        """Return a case by the name of its scheme.

        Raises
        ------
        ScenarioError
            If the scenario has no such scheme.
        """
        known = {case.name: case for case in self.cases()}
        if name not in known:
            raise ScenarioError(f"no scheme {name!r}: {hint(name, known)}", file=self.file)
        return known[name]


FEATURES = {
    "fb": "the axes' own controllers alone",
    "ccc": "cross-coupled control",
    "mr": "modified reference",
    "me": "modified error",
    "ilc": "learning from trial to trial",
}
"""Parts of a scheme name and their meaning."""

_KINDS = {"ccc": ("cross-coupled", "cross-coupled-filter"), "mr": ("modified-reference",), "me": ("modified-error",)}
_WANTED = {
    "ccc": '[controller]\nestimator = "tangent"\ncoupling = {kind = "cross-coupled", gain = ...}',
    "ilc": '[learning]\nlaw = {kind = "zero-phase", gain = 0.2, half_width = 11}',
}


def chosen(scenario: Scenario, names: Iterable[str]) -> Scenario:
    """Return the scenario with these schemes only.

    Parameters
    ----------
    names : iterable of str
        Schemes of the scenario, or `FEATURES` joined by +. The scenario's schemes have priority. A scheme name with commas may be split
        at them.

    Raises
    ------
    ScenarioError
        If a name is unknown or given twice, or the scenario lacks a part of it.
    """
    own = {case.name: case for case in scenario.all_cases}
    wanted = _whole([name.strip() for name in names], own)
    if twice := [name for name in wanted if wanted.count(name) > 1]:
        raise ScenarioError(f"scheme {twice[0]!r} is given twice: delete one", file=scenario.file)
    cases = tuple(own[name] if name in own else _composed(scenario, name) for name in wanted)
    refuse(not cases, ScenarioError, "no scheme is given: write names such as fb,ccc,ilc,ccc+ilc", file=scenario.file)
    return replace(scenario, all_cases=cases)


def _whole(parts: list[str], own: Iterable[str]) -> list[str]:
    """Rejoin scheme names that were split at commas; the longest match wins."""
    pieces = {tuple(part.strip() for part in name.split(",")): name for name in own}
    names = []
    while parts:
        n = next((n for n in range(len(parts), 1, -1) if tuple(parts[:n]) in pieces), 1)
        names.append(pieces[tuple(parts[:n])] if n > 1 else parts[0])
        parts = parts[n:]
    return names


def _composed(scenario: Scenario, name: str) -> Case:
    parts = name.split("+")
    if not set(parts) <= set(FEATURES):
        known = ", ".join([*(repr(case.name) for case in scenario.all_cases), *FEATURES])
        raise ScenarioError(f"no scheme {name!r}: use one of {known}, or join parts by +, such as ccc+ilc", file=scenario.file)
    couplings = [part for part in parts if part in _KINDS]
    if len(couplings) > 1 or len(set(parts)) < len(parts):
        raise ScenarioError(f"scheme {name!r}: name at most one coupling, and each part once, as in ccc+ilc", file=scenario.file)
    controller = _coupled(scenario, couplings[0]) if couplings else replace(scenario.base.controller, estimator=None, coupling=None)
    learning = next((case.learning for case in (scenario.base, *scenario.all_cases) if case.learning is not None), None)
    if "ilc" in parts and learning is None:
        raise _missing(scenario, "ilc")
    return replace(scenario.base, name=name, controller=controller, learning=learning if "ilc" in parts else None)


def _coupled(scenario: Scenario, part: str) -> Controller:
    """Return the base's controller with a coupling: the first of its kind in the base or a scheme, else the default one."""
    base, kinds = scenario.base.controller, _KINDS[part]
    for controller in (base, *(case.controller for case in scenario.all_cases)):
        if controller.coupling and controller.coupling.kind in kinds:
            return replace(base, estimator=controller.estimator, coupling=controller.coupling)
    refuse(part in _WANTED, _missing, scenario, part)
    estimator: Any = base.estimator or component("estimator", "newton")()
    return replace(base, estimator=estimator, coupling=component("coupling", kinds[0])())


def _missing(scenario: Scenario, part: str) -> ScenarioError:
    what = f"neither the base nor a scheme has {FEATURES[part]}"
    return ScenarioError(f"{part}: {what}; write, for example:\n\n{_WANTED[part]}\n", file=scenario.file)
