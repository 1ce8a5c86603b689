"""What a question is asked about: a file with the options that say how to read it, or objects."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

from contourlab.contours import ContourReading
from contourlab.errors import ParameterError
from contourlab.features.run.inputs import loaded, scenario_of
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine
from contourlab.scenario import Case, Scenario
from contourlab.scenario.values import Contour, FeedSettings, RunSettings

Source: TypeAlias = "str | Path | Scenario | Case | Machine | Controller | Reference"
"""A scenario or part program, as a file or read; or a machine, its controller and the reference, one after the other."""


@dataclass(frozen=True, eq=False, repr=False)
class GivenCase(Case):
    """A machine under a controller along a reference that is already planned."""

    given: Reference | None = None

    def reference(self, feed_scale: float = 1.0) -> Reference:
        """Return the reference."""
        assert self.given is not None
        return self.given


def scenario_asked(inputs: Sequence[Source], settings: Any) -> Scenario:
    """Return the scenario that a question is asked about.

    Parameters
    ----------
    inputs : sequence
        See `Source`.
    settings : Options
        Those of `contourlab.app.shared_options.Motion` or `Schemes`; options that the class lacks have no effect.

    Raises
    ------
    ScenarioError, ProgramError, ParameterError
        If the file cannot be read, or an option does not fit it.
    """
    match inputs:
        case [str() | Path() as file] if hasattr(settings, "program"):
            parts = {name: getattr(settings, name) for name in ("machine", "controller", "tolerance", "program")}
            scenario = scenario_of(file, **parts, plugins=settings.plugin)
        case [str() | Path() as file]:
            scenario = loaded(file, getattr(settings, "schemes", ()), settings.plugin)
        case [Scenario() as scenario]:
            pass
        case [Case() as case]:
            scenario = Scenario(case.name, Path(), case)
        case [Machine() as machine, Controller() as controller, Reference() as reference]:
            motion = Contour("reference", axes=machine.axis_names)
            vars(motion)["reading"] = ContourReading(reference.path)  # that of a name would be drawn
            made = GivenCase("base", machine, controller, motion, FeedSettings("uniform"), RunSettings(), given=reference)
            scenario = Scenario(machine.name, Path(), made)
        case _:
            kinds = ", ".join(type(each).__name__ for each in inputs)
            raise ParameterError("inputs", kinds or "none", "a scenario or part program; or a machine, its controller and a reference")
    return scenario.judging(getattr(settings, "judge", None))


def case_asked(inputs: Sequence[Source], settings: Any) -> tuple[Scenario, Case]:
    """Return the scenario that a question is asked about, and its case: that of the option ``scheme``, or its base."""
    scenario = scenario_asked(inputs, settings)
    return scenario, scenario.base if not settings.scheme else scenario.case(settings.scheme)
