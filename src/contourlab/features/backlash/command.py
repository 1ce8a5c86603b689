"""``contourlab backlash``: the gap of each axis, its limit cycles, and the best compensation."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from time import process_time
from typing import Any

import numpy as np

from contourlab.analysis.backlash.lure import LimitCycle, axis_backlash_loop, predict_limit_cycles
from contourlab.analysis.backlash.periodic_orbit import PeriodicOrbit, find_orbits
from contourlab.app.json_values import HIDDEN
from contourlab.app.quick import PLANNED, affordable, beginning
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.arrays import Array
from contourlab.components.contract import Component
from contourlab.components.gap_observer.multiple_model import MultipleModel
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.errors import ComponentError, DivergenceError, ParameterError, ResultError
from contourlab.features.backlash.options import Backlash
from contourlab.features.run.remedies import lost_motion_of, offset_of
from contourlab.features.run.source import Source, scenario_asked
from contourlab.feed import Reference
from contourlab.figures import NONE, figure, number
from contourlab.findings import Finding, finding
from contourlab.loop import Axis, Controller, Machine, simulate
from contourlab.loop.builder import SURE
from contourlab.metrics.circles import CircleBacklash, backlash_of_runs, circles_of
from contourlab.metrics.figures import summarise
from contourlab.metrics.judge import judge
from contourlab.metrics.lost_motion import LostMotion, lost_motion_from_pair
from contourlab.rendering.stages import Stages
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result import Result
from contourlab.scenario import Case
from contourlab.scenario.dump import component_table
from contourlab.scenario.toml_text import toml
from contourlab.study.checkpoint import said_if_interrupted
from contourlab.threads import in_threads
from contourlab.units import from_si, to_si

FEW = 0.05
"""Largest ratio of servo period to limit-cycle period at which a continuous loop approximates the sampled one."""


@dataclass(frozen=True)
class BacklashOutcome(Answer):
    """The study of the backlash of each scheme."""

    name: str
    schemes: Mapping[str, BacklashStudy]
    servo_period: float = field(metadata=HIDDEN)

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The gaps of the axes, one a row [SI]."""
        return [
            {"scheme": name, "axis": axis, "estimate": gap.estimate, "lost_motion": gap.lost_motion, "recommended": study.recommended}
            for name, study in self.schemes.items()
            for axis, gap in study.axes.items()
        ]

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The findings of all schemes."""
        return tuple(each for study in self.schemes.values() for each in study.findings)

    def _next(self, asked: Asked) -> Sequence[object]:
        """Compare the schemes."""
        return ["compare", *asked.given]

    @property
    def text(self) -> str:
        """The result for the terminal."""
        return "\n\n".join(text for name, study in self.schemes.items() for text in _texts(name, study, self.servo_period))


@question(Backlash)
def backlash(*source: Source, settings: Backlash, session: Session = QUIET) -> BacklashOutcome:
    """Study the backlash of the schemes of a scenario whose machine has axes with backlash.

    Parameters
    ----------
    *source : str, Path, Scenario, Case, or a Machine, its Controller and a Reference
        A scenario, as a file or read; or what it consists of.

    Returns
    -------
    BacklashOutcome

    Raises
    ------
    ComponentError
        If no axis has backlash.
    DivergenceError
        If a run of an unchanged scheme diverges.
    """
    scenario = scenario_asked(source, settings)
    cases = scenario.cases()
    studies: dict[str, BacklashStudy] = {}
    outcome = BacklashOutcome(scenario.name, studies, cases[0].machine.servo_period)
    stages = session.stages()
    with said_if_interrupted(lambda: outcome.text):
        stages.expect(sum(3 + len(loose_axes(case.machine)) for case in cases))
        began = process_time()
        for i, case in enumerate(cases):
            stages.begin(f"planning {case.name}")
            reference = case.reference()
            left = max((1.0 - (process_time() - began) / PLANNED) / (len(cases) - i), 0.5 / len(cases))
            studies[case.name] = backlash_study(case, reference, stages, left if settings.quick else None)
    return outcome


def _texts(name: str, study: BacklashStudy, period: float) -> Iterator[str]:
    """Yield the conclusions of a study, its tables and the recommended compensation."""
    yield paragraphs([_sentence(name, study), *map(str, study.findings)])
    heads = ["gap in file [um]", "lost motion [um]", "motor and load: lost motion [um]", "motor alone: gap [um]", "confidence"]
    heads += [] if study.on_circle is None else ["on the circle, controlled [um]"]
    on_circle = {} if study.on_circle is None else dict(zip(study.on_circle.axes, study.on_circle.backlash, strict=True))
    gaps, cycles = [], []
    for axis, gap in study.axes.items():
        pair, alone = gap.from_motor_and_load, gap.from_motor_alone
        seen = NONE if pair is None else _plus_minus(pair.lost_motion, pair.lost_motion_deviation)
        cells = [NONE, NONE] if alone is None else [_plus_minus(alone.gap, alone.deviation), f"{alone.confidence:.2f}"]
        left = [] if study.on_circle is None else [number(1e6 * on_circle[axis]) if axis in on_circle else NONE]
        gaps.append((axis, number(1e6 * gap.backlash_gap), number(1e6 * gap.lost_motion), seen, *cells, *left))
        for kind, predicted in (("describing function", gap.describing_function), ("exact, without friction", gap.limit_cycles)):
            cycles += [
                (axis, _kind(kind, cycle, period), number(cycle.frequency, 4), number(1e6 * cycle.amplitude)) for cycle in predicted or ()
            ]
            cycles += [(axis, f"{kind}: none", NONE, NONE)] if predicted == () else []
    yield Table([Column("axis", left=True), *map(Column, heads)], rows=gaps).text()
    if cycles:
        columns = [Column("axis", left=True), Column("limit cycle", left=True), Column("frequency [Hz]"), Column("amplitude [um]")]
        yield Table(columns, rows=cycles).text()
    trials = (
        (
            trial.name,
            *(NONE if error is None else number(1e6 * error) for error in (trial.part_error_rms, trial.part_error_max)),
            "recommended" if trial.name == study.recommended else "",
        )
        for trial in study.trials
    )
    columns = [Column("compensation", left=True), Column("part error rms [um]"), Column("largest [um]"), Column("", left=True)]
    yield Table(columns, rows=trials).text()
    if study.toml:
        yield f"Add to the scenario:\n\n{study.toml.rstrip()}"


def _sentence(name: str, study: BacklashStudy) -> str:
    """Say how large the lost motion is, and what the recommended compensation gains."""
    lost = ", ".join(f"{axis} {number(1e6 * gap.estimate)} um" for axis, gap in study.axes.items())
    before, best = study.trials[0], next(trial for trial in study.trials if trial.name == study.recommended)
    if best is before or before.part_error_rms is None or best.part_error_rms is None:
        gain = "no compensation that was tried lowers the part error"
    else:
        gain = f"{best.name} lowers the part error from {number(1e6 * before.part_error_rms)} to {number(1e6 * best.part_error_rms)} um rms"
    return f"{name}: lost motion {lost}; {gain}."


def _plus_minus(value: float, deviation: float) -> str:
    """Return a value [m] in um with twice its standard deviation."""
    return f"{number(1e6 * value)} +- {number(2e6 * deviation)}"


def _kind(kind: str, cycle: Cycle, period: float) -> str:
    """Name a limit cycle; add the reasons for a limited accuracy of the prediction."""
    notes = [cycle.validity.partition(":")[0]] if cycle.validity else []
    if cycle.frequency * period > FEW:
        notes.append(f"period {figure(1.0 / (cycle.frequency * period), digits=2)} servo periods")
    return f"{kind}: {'stable' if cycle.stable else 'unstable'}" + (f" ({', '.join(notes)})" if notes else "")


# --- the study: estimated size, limit cycles, and the best compensation ---


STRIBECK = 0.2
"""Share of breakaway minus Coulomb friction that acts as unmodelled force."""
UNCERTAINTY = 0.1
"""Relative uncertainty of torque, inertia and friction that the observer assumes: no machine file is more accurate."""


def observer_of(axis: Axis, servo_period: float, carried_mass: float = 0.0) -> MultipleModel:
    """Return the gap observer of an axis with a two-inertia plant; the drive's values come from the machine file.

    The observer's model has no breakaway friction above Coulomb friction and no disturbance: both count as unmodelled force.
    """
    plant = axis.plant.loaded(carried_mass)
    known = {name: value for name, value in plant.values().items() if name in MultipleModel.parameters}
    known["mass"] = plant.mass + plant.carried_mass
    friction = {"coulomb": axis.friction, "motor_coulomb": axis.motor_friction}
    known |= {name: part.values()["coulomb"] for name, part in friction.items() if "coulomb" in part.parameters}
    if "resolution" in axis.motor_sensor.parameters:
        known["resolution"] = axis.motor_sensor.values()["resolution"]
    friction_of_load, forces = axis.friction.values(), [1.0]
    forces.append(STRIBECK * (float(friction_of_load.get("breakaway", 0.0)) - float(friction_of_load.get("coulomb", 0.0))))
    if axis.disturbance is not None:
        kinds = axis.disturbance.parameters
        given = (value for name, value in axis.disturbance.values().items() if kinds[name].unit == "{force}")
        forces += [float(np.abs(np.ravel(force)).max(initial=0.0)) for force in given]
    known |= {"unmodelled_force": max(forces), "uncertainty": UNCERTAINTY}
    known["largest_gap"] = max(MultipleModel.parameters["largest_gap"].default, 5.0 * plant.widest_gap)
    # Hypotheses at most 15 % apart. Only two possible numbers, because each is compiled separately.
    known["hypotheses"] = 32.0 if known["largest_gap"] < 4e-4 else 64.0
    known["load_damping"] += float(friction_of_load.get("viscous", 0.0)) * (plant.lead / (2.0 * math.pi)) ** 2
    values = plant.constants()
    fast = math.sqrt(values.stiffness_value * (values.motor_mobility + values.load_mobility)) * servo_period
    return MultipleModel(**known, substeps=float(min(max(math.ceil(fast / 0.25), 1), 32)))


SIGNALS = ("reference", "arc_length", "axis_position", "axis_velocity", "tool_position", "motor_position", "applied_command")
OBSERVED = ("gap_estimate", "gap_deviation", "gap_confidence")
RUNS = 2
"""Runs without a gap observer, one after another: as it is, and two compensations side by side."""
WORTH = 0.02
"""Smallest share of the error that a recommended compensation must remove."""


@dataclass(frozen=True)
class FromMotor:
    """Gap from the motor alone, its standard deviation [m], and the observer's confidence at the end of the run."""

    gap: float
    deviation: float
    confidence: float


@dataclass(frozen=True)
class Cycle:
    """A limit cycle: frequency [Hz], amplitude [m], stability, and validity of the describing function (empty for an exact cycle)."""

    frequency: float
    amplitude: float
    stable: bool
    validity: str = ""

    @classmethod
    def of(cls, cycle: LimitCycle | PeriodicOrbit) -> Cycle:
        """Return the figures of a cycle."""
        return cls(cycle.frequency / (2.0 * math.pi), cycle.amplitude, cycle.stable, getattr(cycle, "validity", ""))


@dataclass(frozen=True)
class AxisGap:
    """The backlash of one axis.

    Attributes
    ----------
    backlash_gap : float [m]
        Free travel in the machine file, averaged over the reversals of the axis.
    lost_motion : float [m]
        Free travel plus the wind-up by friction in both directions.
    from_motor_and_load : LostMotion or None
    from_motor_alone : FromMotor or None
    describing_function : tuple of Cycle or None
        None for a loop that switches its controller or has no linear model.
    limit_cycles : tuple of Cycle or None
        Exact, without friction; None also in a quick study.
    feedback : str
        Feedback of the position loop.
    """

    backlash_gap: float
    lost_motion: float
    from_motor_and_load: LostMotion | None
    from_motor_alone: FromMotor | None
    describing_function: tuple[Cycle, ...] | None
    limit_cycles: tuple[Cycle, ...] | None
    feedback: str

    @property
    def estimate(self) -> float:
        """Lost motion to compensate [m]: measured on motor and load if possible, else from the machine file."""
        return self.lost_motion if self.from_motor_and_load is None else max(self.from_motor_and_load.lost_motion, 0.0)


@dataclass(frozen=True)
class Trial:
    """A compensation tried, by axis, and its part error [m] (None if the loop diverged). The first trial has no compensation."""

    name: str
    part_error_rms: float | None
    part_error_max: float | None
    parts: Mapping[str, Component] = field(default_factory=dict, metadata=HIDDEN)


@dataclass(frozen=True)
class BacklashStudy:
    """The result for one case.

    Attributes
    ----------
    axes : mapping of str to AxisGap
    on_circle : CircleBacklash or None
        Remaining backlash on the first circle of the path, under control.
    trials : tuple of Trial
    recommended : str
        Trial with the smallest rms part error; the first trial unless another is better by `WORTH`.
    toml : str or None
        The recommended compensation for the scenario.
    findings : tuple of Finding
    """

    axes: Mapping[str, AxisGap]
    on_circle: CircleBacklash | None
    trials: tuple[Trial, ...]
    recommended: str
    toml: str | None
    findings: tuple[Finding, ...]


def backlash_study(case: Case, reference: Reference, stages: Stages, quick: float | None = None) -> BacklashStudy:
    """Estimate the gap of each axis from a simulated run, predict its limit cycles, and try compensations.

    Parameters
    ----------
    case : Case
    reference : Reference
        Of the case.
    stages : Stages
        Where to show the work.
    quick : float, optional
        Share of the time of a quick answer. The gap observers, and if need be all runs, then follow only the beginning of the motion, and
        limit cycles come from the describing function alone.

    Raises
    ------
    ComponentError
        If no axis with a two-inertia plant has backlash.
    DivergenceError
        If the run without a compensation diverges.
    """
    machine, controller = case.machine, case.controller

    def run(tried: Controller, motion: Reference, extra: tuple[str, ...] = ()) -> Result:
        signals = (*SIGNALS, *extra)
        return simulate(
            machine, tried, motion, seed=case.run.seed, signals=signals, progress=lambda done: stages.advance(done, motion.n_sample)
        )

    loose = loose_axes(machine)
    chains = [axis for axis in machine.axes if axis.plant.two_sided and not isinstance(axis.plant, TwoInertia)]
    if not loose:
        others = sorted({axis.plant.kind for axis in chains})
        why = f": this study supports two-inertia drives only, not {', '.join(others)}" if others else ""
        raise ComponentError(f"{machine.name} has no axis with backlash{why}")
    stages.begin(f"simulating {case.name} with gap observers")
    watched, refused = _watched(machine, controller, loose)
    observed = any(loop.gap_observer is not None for loop in watched.axes.values())
    findings = [finding("CL380", place=f"axis {axis}") for axis in refused]
    part = reference
    if quick is not None:
        alike = watched is controller
        part = _fitting(watched, reference, run, quick / RUNS if alike else 0.5 * quick)
        reference = part if alike else _fitting(controller, reference, run, 0.5 * quick / RUNS)
        findings.append(finding("CL387", observed=part.n_sample * part.servo_period, run=reference.n_sample * reference.servo_period))
    seen_alone = run(watched, part, OBSERVED if observed else ())
    result = seen_alone if part.n_sample == reference.n_sample else run(controller, reference)
    axes = {}
    for axis in loose:
        stages.begin(f"finding limit cycles of axis {axis.name}")
        alone = seen_alone if observed and axis.name not in refused else None
        axes[axis.name] = _axis_gap(machine, controller, axis, result, alone, findings, exact=quick is None)
    judged = judge(result, reference)
    first = summarise(judged, reference).part_error
    stages.begin(f"simulating {case.name} with compensations")

    def tried(name: str, parts: Mapping[str, Component]) -> Trial:
        changed = {axis: replace(loop, compensation=parts.get(axis, loop.compensation)) for axis, loop in controller.axes.items()}
        try:
            error = summarise(judge(run(replace(controller, axes=changed), reference), reference), reference).part_error
        except DivergenceError:
            return Trial(name, None, None, parts)
        return Trial(name, error.rms, error.max, parts)

    trials = [Trial("as it is", first.rms, first.max), *in_threads(lambda candidate: tried(*candidate), _candidates(machine, axes))]
    best = min(trials, key=lambda trial: math.inf if trial.part_error_rms is None else trial.part_error_rms)
    if best.part_error_rms is None or best.part_error_rms > (1.0 - WORTH) * first.rms:
        best = trials[0]
    findings += _conclusions(axes, [axis.name for axis in chains])
    snippet = _toml(best.parts, machine) if best.parts else None
    return BacklashStudy(axes, _on_circles(judged, reference, machine), tuple(trials), best.name, snippet, tuple(findings))


def _fitting(controller: Controller, reference: Reference, run: Callable[[Controller, Reference], Result], share: float) -> Reference:
    """Return the beginning of a motion that a run follows within a share of the time of a quick answer, or all of it."""
    fits = share * affordable(lambda motion: run(controller, motion), reference, threads=1)
    return beginning(reference, max(int(fits * reference.n_sample), 2))


def loose_axes(machine: Machine) -> list[Axis]:
    """Return the two-inertia axes with backlash."""
    return [axis for axis in machine.axes if isinstance(axis.plant, TwoInertia) and axis.plant.widest_gap > 0.0]


def _on_circles(judged: Result, reference: Reference, machine: Machine) -> CircleBacklash | None:
    """Return the backlash on the first circle of the path, from both directions if it is run in both; None without a circle."""
    runs = circles_of(judged, reference)
    alike = [run for run in runs if abs(run.radius - runs[0].radius) < 1e-9] if runs else []
    senses = {run.clockwise: run for run in reversed(alike)}
    if not senses or len(machine.axes) < 2:
        return None
    try:
        return backlash_of_runs(tuple(senses.values()), axes=machine.axis_names[:2])  # type: ignore[arg-type]
    except (ResultError, ParameterError):
        return None


def _watched(machine: Machine, controller: Controller, loose: list[Axis]) -> tuple[Controller, list[str]]:
    """Add a gap observer to each axis with backlash that has none; skip and return the axes where it would change the run."""
    changed = dict(controller.axes)
    refused = []
    for axis in loose:
        loop = controller.axes[axis.name]
        if loop.gap_observer is not None:
            continue
        parts = [*loop.controllers.values(), loop.supervisor, loop.compensation]
        read = {port.name for part in parts if part is not None for port in part.inputs}
        # An observer would replace the load or the gap that a part reads.
        if loop.feedback == "motor" and read & {"load_position", "load_velocity", "gap_estimate"}:
            refused.append(axis.name)
        else:
            observer = observer_of(axis, machine.servo_period, machine.carried_mass(axis.name))
            changed[axis.name] = replace(loop, gap_observer=observer)
    return (controller if changed == dict(controller.axes) else replace(controller, axes=changed)), refused


def _axis_gap(
    machine: Machine, controller: Controller, axis: Axis, result: Result, observed: Result | None, findings: list[Finding], *, exact: bool
) -> AxisGap:
    place, j, plant = f"axis {axis.name}", machine.axis_names.index(axis.name), machine.loaded_plant(axis.name)
    assert isinstance(plant, TwoInertia)
    loop = controller.axes[axis.name]
    motor, load, velocity = (result[name][:, j] for name in ("motor_position", "axis_position", "axis_velocity"))
    gap = _gap_where_it_turns(plant, velocity, load)
    pair = alone = predicted = orbits = None
    try:
        friction, stiffness = _friction_of(axis, plant, velocity)
        pair = lost_motion_from_pair(motor, load, friction=friction, stiffness=stiffness)
    except ResultError as error:
        findings.append(finding("CL381", place=place, reason=str(error)))
    if observed is not None and OBSERVED[0] in observed.signals:
        alone = FromMotor(*(float(observed[name][-1, j]) for name in OBSERVED))
        if alone.confidence >= SURE and abs(alone.gap - gap) > max(3.0 * alone.deviation, 0.25 * gap):
            findings.append(finding("CL382", place=place, seen=alone.gap, gap=gap))
    try:
        model = axis_backlash_loop(axis, loop, machine.servo_period, machine.carried_mass(axis.name))
        prediction = predict_limit_cycles(model) if model.contact_a is None else None
        predicted = None if prediction is None else tuple(map(Cycle.of, prediction))
        if exact:
            orbits = tuple(map(Cycle.of, find_orbits(model, prediction=prediction)))
    except ComponentError as error:
        findings.append(finding("CL383", place=place, reason=str(error)))
    return AxisGap(gap, lost_motion_of(axis), pair, alone, predicted, orbits, loop.feedback)


def _friction_of(axis: Axis, plant: TwoInertia, velocity: Array) -> tuple[float, float]:
    """Return the friction [N] at the mean speed of the axis, and the stiffness [N/m] of its drive."""
    values, friction = plant.constants(), axis.friction.values()
    moving = np.abs(velocity)
    speed = float(moving[moving > 0.1 * moving.max()].mean()) if moving.any() else 0.0
    viscous = float(values.load_decay / values.load_mobility) + float(friction.get("viscous", 0.0))
    return float(friction.get("coulomb", 0.0)) + viscous * speed, float(values.stiffness_value)


def _gap_where_it_turns(plant: TwoInertia, velocity: Array, position: Array) -> float:
    """Return the free travel [m] in the machine file, averaged over the reversals; the widest gap if the axis never reverses."""
    forward = velocity[velocity != 0.0] > 0.0
    turns = position[velocity != 0.0][1:][forward[1:] != forward[:-1]]
    return float(np.mean([plant.gap_at(float(place)) for place in turns])) if turns.size else plant.widest_gap


def _candidates(machine: Machine, axes: Mapping[str, AxisGap]) -> Iterator[tuple[str, dict[str, Component]]]:
    """Yield compensations for the axes with motor feedback of the position loop."""
    loose = {axis: gap for axis, gap in axes.items() if gap.feedback == "motor" and gap.estimate > 0.0}
    if loose:
        parts = {axis: offset_of(machine.axis(axis), gap.estimate) for axis, gap in loose.items()}
        yield "backlash-offset", {axis: offset for axis, (offset, _) in parts.items()}
        yield "backlash-inverse", {axis: inverse for axis, (_, inverse) in parts.items()}


def _conclusions(axes: Mapping[str, AxisGap], others: list[str]) -> Iterator[Finding]:
    over_load = [axis for axis, gap in axes.items() if gap.feedback == "load"]
    if over_load:
        yield finding("CL385", axes=over_load)
    cycles = {axis: gap.describing_function if gap.limit_cycles is None else gap.limit_cycles for axis, gap in axes.items()}
    hunting = [axis for axis, known in cycles.items() if any(cycle.stable for cycle in known or ())]
    if hunting:
        yield finding("CL386", axes=hunting)
    if others:
        yield finding("CL384", axes=others)


def _toml(parts: Mapping[str, Component], machine: Machine) -> str:
    """Return the compensation of each axis for a scenario, its values rounded to three digits in display units."""
    axes = {}
    for name, part in parts.items():
        plant = machine.axis(name).plant
        units = plant.command_unit, plant.force_unit
        rounded = {}
        for key, parameter in ((key, known.for_plant(*units)) for key, known in type(part).parameters.items()):
            value, shown = getattr(part, key), parameter.display or parameter.unit
            if isinstance(value, float) and math.isfinite(value) and not parameter.whole:
                rounded[key] = to_si(f"{from_si(value, shown):.3g} {shown}", parameter.unit) if shown else float(f"{value:.3g}")
        axes[name] = {"compensation": component_table(part.replace(**rounded), units)}
    return toml({"controller": {"axes": axes}})
