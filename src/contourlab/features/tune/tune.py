"""Calibration from end to end: start, sequential procedure, global search, and the answer checked on its own."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from contourlab.design import DesignVariable, Evaluator, Space, calibration_order
from contourlab.design.guards import Bounds, Guards
from contourlab.design.values import with_values
from contourlab.errors import ParameterError
from contourlab.features.tune.checked import Checked, checked
from contourlab.features.tune.drive_terms import DriveTerms, drive_terms
from contourlab.features.tune.globally import Searched, globally
from contourlab.features.tune.line import LineRule, Step
from contourlab.features.tune.objective import Goal, Objective
from contourlab.features.tune.placed import fastest, placed_gains
from contourlab.features.tune.repair import repaired
from contourlab.features.tune.sequential import Path, sequential
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine, parameter_names

METHODS = ("sequential", "global", "both")
STARTS = ("scenario", "placed")
FRACTIONS = np.geomspace(0.1, 1.0, 32)
"""Parts of the fastest poles that are tried for a placed start."""


@dataclass(frozen=True)
class TuneSettings:
    """How a controller is calibrated.

    Attributes
    ----------
    goal : Goal
    bounds : Bounds
    rule : LineRule
    method : str
        Of `METHODS`.
    start : str
        Of `STARTS`: the gains of the scenario, or placed poles.
    parameters : tuple of str
        Numbers and bounds as of `contourlab.design.Space.chosen`; none for all that is calibrated.
    width : float, > 1
        Factor either side of a start without bounds of its own.
    passes : int, >= 1
        Of the sequential procedure.
    budget : int, > 0
        Runs of the global search.
    starts : int, >= 1
        Of the global search.
    seed : int
        Of the global search.
    threads : int, optional
    """

    goal: Goal = field(default_factory=Goal)
    bounds: Bounds = field(default_factory=Bounds)
    rule: LineRule = field(default_factory=LineRule)
    method: str = "sequential"
    start: str = "scenario"
    parameters: tuple[str, ...] = ()
    width: float = 4.0
    passes: int = 1
    budget: int = 6000
    starts: int = 5
    seed: int = 0
    threads: int | None = None

    def __post_init__(self) -> None:
        for name, value, known in (("method", self.method, METHODS), ("start", self.start, STARTS)):
            if value not in known:
                raise ParameterError(name, repr(value), f"one of {', '.join(known)}")
        if not 1.0 < self.width <= 1000.0:
            raise ParameterError("width", f"{self.width:g}", "> 1 and <= 1000")
        for name, low, high in (("passes", 1, 100), ("budget", 32, 10_000_000), ("starts", 1, 100), ("seed", 0, 2**63 - 1)):
            if not low <= getattr(self, name) <= high:
                raise ParameterError(name, f"{getattr(self, name)}", f"{low} to {high}")
        if self.threads is not None and self.threads < 1:
            raise ParameterError("threads", f"{self.threads}", "1 or more")


@dataclass(frozen=True, eq=False)
class Tuned:
    """A calibrated controller.

    Attributes
    ----------
    controller : Controller
    space : Space
        Numbers that were moved; `value` is what each started from.
    values : dict of str to float [SI]
        Their values in the end.
    method : str
        "sequential", "global", or "none" where nothing better was found that keeps the bounds.
    before, after : Checked
        By single runs and exact judge, before any change and in the end.
    start : float
        The objective of where the search began: of the placed start if there is one.
    path : Path
        Steps of repair and of the sequential procedure.
    searched : Searched or None
    terms : tuple of DriveTerms
    runs : int
        Runs in all.
    notes : tuple of str
    """

    controller: Controller
    space: Space
    values: dict[str, float]
    method: str
    before: Checked
    after: Checked
    start: float
    path: Path
    searched: Searched | None
    terms: tuple[DriveTerms, ...]
    runs: int
    notes: tuple[str, ...]

    @property
    def steps(self) -> tuple[Step, ...]:
        """Steps of repair and of the sequential procedure."""
        return self.path.steps

    @property
    def gain(self) -> float:
        """Integral of the contour error before over that in the end."""
        after = self.after.figures["contour_error_integral"]
        return self.before.figures["contour_error_integral"] / after if after else math.inf


def tune(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    settings: TuneSettings | None = None,
    *,
    moving: bool = False,
    seed: int = 0,
    begin: Callable[[str], None] | None = None,
    tell: Callable[[int, int], None] | None = None,
) -> Tuned:
    """Calibrate a controller.

    Parameters
    ----------
    machine, controller, reference
        As of `contourlab.loop.simulate`.
    settings : TuneSettings, optional
    moving : bool
        Whether the axes start with the velocity of the reference.
    seed : int
        Of all noise.
    begin, tell : callable, optional
        Told in words what is begun, and how much of it is done of how much.

    Raises
    ------
    ParameterError
        If a number is unknown or the machine's, nothing can be calibrated, or a start cannot be placed.

    Notes
    -----
    A number that the scenario has beyond the bounds that are given starts from the nearer one.
    """
    settings = settings or TuneSettings()
    begin = begin or (lambda words: None)
    _known(machine, controller, settings)
    begin("running what there is")
    before = checked(machine, controller, reference, Guards([(machine, controller)], settings.bounds), seed=seed, moving=moving)
    from_here, placed = controller, 0
    if settings.start == "placed":
        begin("placing poles")
        from_here, placed = _placed(machine, controller, reference, settings, moving, seed), len(FRACTIONS)
    space = Space.chosen(machine, from_here, settings.parameters, settings.width)
    evaluator = Evaluator(machine, from_here, reference, seed=seed, threads=settings.threads, moving=moving)
    values = {number.name: number.nearest for number in space.numbers}
    objective = Objective([evaluator], settings.goal, values)
    guards = Guards([(machine, from_here)], settings.bounds)
    found = _Search(objective, guards, space, settings, begin, tell).run(values)
    begin("checking the answer")
    answer = {number.name: float(number.written(found.values[number.name])) for number in space.numbers}
    made = with_values(machine, from_here, answer)[1]
    after = checked(machine, made, reference, guards, seed=seed, moving=moving)
    notes = [f"axis {axis} has no linear model, so its margins are not known: {why}" for axis, why in guards.unknown.items()]
    notes += [_beyond(number) for number in space.numbers if number.nearest != number.value]
    notes += _cramped(space, answer)
    return Tuned(
        made,
        space,
        answer,
        found.method,
        before,
        after,
        found.start,
        found.path,
        found.searched,
        drive_terms(machine, made, after.run),
        evaluator.runs + placed + 2,
        (*notes, *found.notes),
    )


def _beyond(number: DesignVariable) -> str:
    """Say that a number was begun at a bound."""
    value = f"{number.display_value(number.value):.6g} {number.display_unit}"
    return f"{number.short} = {value} lies beyond its {number.bounds}: begun at the nearer one"


def _cramped(space: Space, answer: Mapping[str, float]) -> list[str]:
    """Say which numbers ended on an end of their ranges, whoever put them there."""
    ended = [number.short for number in space.numbers if number.cramped(answer[number.name])]
    if not ended:
        return []
    stand = "stands on an end of its range" if len(ended) == 1 else "stand on an end of their ranges"
    return [f"{', '.join(ended)} {stand}: a wider --width, or --parameter NAME=LOW..HIGH, may come to more"]


def _known(machine: Machine, controller: Controller, settings: TuneSettings) -> None:
    """Refuse at once what names no number of the controller, and a controller of which nothing is calibrated."""
    if not settings.parameters:
        known = parameter_names(machine, controller)
        order = calibration_order(machine, controller)
        if not any(getattr(*known[name]) not in (0.0, math.inf) for name in order):
            kinds = ", ".join(sorted({part.controller.kind for part in controller.axes.values()}))
            raise ParameterError("parameters", f"none: {kinds} names nothing to calibrate that is not zero", "given, each with its bounds")
    space = Space.chosen(machine, controller, settings.parameters, settings.width)
    of_machine = [number.short for number in space.numbers if number.name.startswith("axes.")]
    if of_machine:
        raise ParameterError("parameter", of_machine[0], "a number of the controller: those of the machine are what they are")


def _placed(machine: Machine, controller: Controller, reference: Reference, settings: TuneSettings, moving: bool, seed: int) -> Controller:
    """Return the controller with poles placed at that part of the fastest speed at which the objective is least."""
    speeds = fastest(machine, controller, settings.bounds)
    made = [one for part in FRACTIONS.tolist() if (one := _slowed(machine, controller, speeds, part)) is not None]
    if not made:
        raise ParameterError("start", "placed", "scenario: the slowest axis that keeps the margins leaves the others no gains")
    known = [parameter_names(machine, one) for one in made]
    columns: dict[str, np.ndarray] = {}
    for name in known[-1]:
        if ".controller." in name:
            values = np.array([getattr(*names[name]) for names in known], dtype=float)
            if np.isfinite(values).all():
                columns[name] = values
    evaluator = Evaluator(machine, made[-1], reference, seed=seed, threads=settings.threads, moving=moving)
    start = {name: float(values[-1]) for name, values in columns.items()}
    judged = Objective([evaluator], Goal(settings.goal.weights[:1]), start)(columns)
    good = (judged.limited <= settings.bounds.limited) & (judged.largest <= settings.bounds.command)
    ranked = np.where(good, judged.value, np.inf)
    if not np.isfinite(ranked).any():
        raise ParameterError("start", "placed", "scenario: at no speed of its poles does a run keep the limits of the drives")
    return made[int(np.argmin(ranked))]


def _slowed(machine: Machine, controller: Controller, speeds: Mapping[str, float], part: float) -> Controller | None:
    """Return the controller with poles at a part of the speeds; None where a plant's own damping is too much for so slow a pole."""
    try:
        return placed_gains(machine, controller, {name: part * speed for name, speed in speeds.items()})
    except ParameterError:
        return None


@dataclass(frozen=True)
class _Answer:
    values: dict[str, float]
    method: str
    start: float
    path: Path
    searched: Searched | None
    notes: tuple[str, ...]


@dataclass
class _Search:
    """The methods that were chosen, one after the other, and the better answer of those that keep the bounds."""

    objective: Objective
    guards: Guards
    space: Space
    settings: TuneSettings
    begin: Callable[[str], None]
    tell: Callable[[int, int], None] | None

    def run(self, values: Mapping[str, float]) -> _Answer:
        start = self._value(values)
        candidates: list[tuple[float, str, dict[str, float]]] = []
        self.begin("restoring the margins")
        mended, repairs = repaired(self.objective, self.guards, self.space, values)
        path = Path(mended, repairs)
        if self.settings.method != "global":
            self.begin("one number at a time")
            walked = sequential(
                self.objective, self.guards, self.space, mended, self.settings.rule, passes=self.settings.passes, tell=self.tell
            )
            path = Path(walked.values, (*repairs, *walked.steps))
            candidates.append((self._value(walked.values), "sequential", walked.values))
        searched = self._globally([mended, *(values for _, _, values in candidates)])
        if searched is not None and searched.values is not None:
            candidates.append((searched.value, "global", searched.values))
        return self._chosen(values, candidates, start, path, searched)

    def _globally(self, given: Sequence[Mapping[str, float]]) -> Searched | None:
        if self.settings.method == "sequential":
            return None
        self.begin("all numbers at once")
        s = self.settings
        return globally(self.objective, self.guards, self.space, given, starts=s.starts, budget=s.budget, seed=s.seed, tell=self.tell)

    def _value(self, values: Mapping[str, float]) -> float:
        return float(self.objective({name: np.array([value]) for name, value in values.items()}).value[0])

    def _kept(self, values: Mapping[str, float]) -> tuple[str, ...]:
        judged = self.objective({name: np.array([value]) for name, value in values.items()})
        return self.guards.broken(values, float(judged.limited[0]), float(judged.largest[0]))

    def _chosen(
        self,
        values: Mapping[str, float],
        candidates: Sequence[tuple[float, str, dict[str, float]]],
        start: float,
        path: Path,
        searched: Searched | None,
    ) -> _Answer:
        notes: list[str] = []
        if searched is not None and searched.values is None:
            notes.append("no start of the global search came to gains that keep all bounds")
        for _, method, found in sorted(candidates, key=lambda one: one[0]):
            broken = self._kept(found)
            if not broken:
                return _Answer(found, method, start, path, searched, tuple(notes))
            notes.append(f"the answer of the {method} search does not keep: {'; '.join(broken)}")
        if candidates:
            # Nothing keeps all bounds: what was found is shown for what it is, and the check says what it breaks.
            _, method, found = min(candidates, key=lambda one: one[0])
            return _Answer(found, method, start, path, searched, tuple(notes))
        return _Answer(dict(values), "none", start, path, searched, tuple(notes))
