"""A scenario and its cases once they have been read: frozen values."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path as File
from typing import Any, TypeAlias

import numpy as np

from contourlab.errors import FeedError, ProgramError, ScenarioError
from contourlab.feed import AxisLimits, Reference, Route, blended, plan, route_from_path, uniform
from contourlab.feed.route import controlled
from contourlab.loop import Change, Controller, Machine
from contourlab.scenario.learning import LearningSettings
from contourlab.scenario.motion_check import check_motion
from contourlab.scenario.values import DEFAULT_CORNER_TOLERANCE, Contour, FeedSettings, Motion, PartProgram, RunSettings

Overrides: TypeAlias = Mapping[str, object]
"""What a scheme changes: dotted key -> value as written."""


@dataclass(frozen=True, eq=False)
class Case:
    """One machine under one controller along one motion, what is learned from repeating it, and what takes over on the way."""

    name: str
    machine: Machine
    controller: Controller
    motion: Motion
    feed: FeedSettings
    run: RunSettings
    learning: LearningSettings | None = None
    changes: tuple[Change, ...] = ()

    @property
    def tolerance(self) -> float | None:
        """Largest part error that passes [m]; None for no verdict."""
        return self.run.tolerance

    @property
    def moving(self) -> bool:
        """Whether the axes have the velocity of the reference at the first sample."""
        return self.run.start == "moving"

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
        The scenario's own, and every one of a machine, an axis or a controller that was read for it.
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

    @property
    def inputs(self) -> tuple[File, ...]:
        """All that is read: `files`, the drawing or the part program with its tools, learned tables."""
        motion = self.motion
        tools = motion.reading.tools if isinstance(motion, PartProgram) else None
        tables = [case.learning.table for case in self.cases() if case.learning is not None]
        return (*self.files, *(File(file) for file in (motion.file, tools, *tables) if file is not None))

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
        raise ScenarioError(f"no scheme {name!r}: there are {', '.join(repr(c.name) for c in self.cases())}", file=self.file)

    @property
    def text(self) -> str:
        """The scenario as TOML: machine, controller and schemes joined in; a part program or a drawing is named by its path."""
        from contourlab.scenario.dump import dump

        return dump(self)
