"""What a scenario is once it has been read: frozen values, from which the cases of a comparison follow."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path as File
from typing import Literal, TypeAlias

import numpy as np

from contourlab.errors import FeedError, ProgramError, ScenarioError
from contourlab.feed import AxisLimits, Reference, Route, plan, route_from_path, route_from_program, uniform
from contourlab.geometry import Path, contour
from contourlab.loop import Controller, Machine
from contourlab.program import Program
from contourlab.scenario.motion_check import check_motion

__all__ = ["Case", "Contour", "FeedSettings", "Motion", "Overrides", "PartProgram", "RunSettings", "Scenario"]

Overrides: TypeAlias = Mapping[str, object]
"""What a scheme changes: dotted key -> value as written."""


@dataclass(frozen=True)
class Contour:
    """A test contour by name.

    Attributes
    ----------
    name : str
        One of `contourlab.geometry.contour_names`.
    parameters : mapping of str to float
        In m and rad; those that were given.
    """

    name: str
    parameters: Mapping[str, float] = field(default_factory=dict)

    @cached_property
    def path(self) -> Path:
        """The contour as a path."""
        return contour(self.name, **self.parameters)

    @property
    def n_axis(self) -> int:
        """Number of coordinates."""
        return self.path.n_axis


@dataclass(frozen=True)
class PartProgram:
    """A part program.

    Attributes
    ----------
    file : Path
    program : Program
    letters : tuple of str
        The address (x, y, z) that each axis of the machine obeys, in the order of the machine's axes.
    require_end : bool
        Whether the program has to say where it ends.
    """

    file: File
    program: Program
    letters: tuple[str, ...]
    require_end: bool = True

    @cached_property
    def route(self) -> Route:
        """The path of the program with its feedrates."""
        return route_from_program(self.program, self.letters)

    @property
    def n_axis(self) -> int:
        """Number of coordinates."""
        return len(self.letters)


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
    """

    law: Literal["planned", "uniform"] = "planned"
    feedrate: float | None = None
    frequency: float | None = None
    laps: int = 1
    override: float = 1.0


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
    def lines(self) -> tuple[str, ...]:
        """Source text of the program; empty for a contour."""
        return self.motion.program.lines if isinstance(self.motion, PartProgram) else ()

    @property
    def limits(self) -> AxisLimits:
        """Limits of the axes, for the planner.

        Raises
        ------
        FeedError
            If an axis has no velocity limit.
        """
        free = [axis.name for axis in self.machine.axes if not np.isfinite(axis.limits.velocity)]
        if free:
            raise FeedError(f"axis {free[0]} of {self.machine.name} has no velocity limit to plan with: give it limits.velocity")
        found = [axis.limits for axis in self.machine.axes]
        return AxisLimits([x.velocity for x in found], [x.acceleration for x in found], [x.jerk for x in found])

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
        check_motion(found, self.machine, self._fault, bounded=self.feed.law != "uniform")
        return replace(found, laps=()) if self.run.evaluate == "whole" else found

    def _fault(self, message: str, line: int) -> FeedError | ProgramError:
        if isinstance(self.motion, PartProgram):
            return ProgramError(message, file=self.motion.file, line=line)
        return FeedError(f"{self.motion.name}: {message}")

    def _sampled(self, factor: float) -> Reference:
        period = self.machine.servo_period
        if self.feed.law == "uniform":
            assert isinstance(self.motion, Contour) and self.feed.frequency is not None  # said by the reader
            return uniform(self.motion.path, self.feed.frequency * factor, self.feed.laps, period)
        return plan(self._route(factor), self.limits, period, laps=self.feed.laps)

    def _route(self, factor: float) -> Route:
        if isinstance(self.motion, Contour):
            assert self.feed.feedrate is not None  # said by the reader
            return route_from_path(self.motion.path, self.feed.feedrate * factor)
        route = self.motion.route
        if factor == 1.0:
            return route
        feedrate = np.where(route.rapid, route.feedrate, route.feedrate * factor)
        return Route(route.path, feedrate, route.rapid, route.dwell, route.source_line, route.programmed, route.dwell_before)


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
        """The scenario as TOML that stands for itself: every file joined in, part programs and schemes included."""
        from contourlab.scenario.dump import dump

        return dump(self)
