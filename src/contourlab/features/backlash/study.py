"""Backlash of a machine's axes: its estimated size, its limit cycles, and the best compensation."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from contourlab.analysis.backlash.lure import LimitCycle, axis_backlash_loop, predict_limit_cycles
from contourlab.analysis.backlash.periodic_orbit import PeriodicOrbit, find_orbits
from contourlab.app.json_values import HIDDEN
from contourlab.app.quick import affordable, beginning
from contourlab.arrays import Array
from contourlab.components.contract import Component
from contourlab.components.gap_observer.multiple_model import MultipleModel
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.errors import ComponentError, DivergenceError, ParameterError, ResultError
from contourlab.features.run.causes.remedies import lost_motion_of, offset_of
from contourlab.feed import Reference
from contourlab.findings import Finding, finding
from contourlab.loop import Axis, AxisController, Controller, Machine, simulate
from contourlab.loop.sensing import SURE
from contourlab.metrics import CircleBacklash, backlash_of_runs, circles_of, judge, lost_motion_from_pair, summarise
from contourlab.result import Result
from contourlab.scenario.dump import component_table
from contourlab.scenario.toml_text import toml
from contourlab.threads import in_threads
from contourlab.units import from_si, to_si

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
    known |= {"unmodelled_force": _unmodelled(axis), "uncertainty": UNCERTAINTY}
    known["largest_gap"] = max(MultipleModel.parameters["largest_gap"].default, 5.0 * plant.widest_gap)
    # Hypotheses at most 15 % apart. Only two possible numbers, because each is compiled separately.
    known["hypotheses"] = 32.0 if known["largest_gap"] < 4e-4 else 64.0
    known["load_damping"] += float(axis.friction.values().get("viscous", 0.0)) * (plant.lead / (2.0 * math.pi)) ** 2
    values = plant.constants()
    fast = math.sqrt(values.stiffness_value * (values.motor_mobility + values.load_mobility)) * servo_period
    return MultipleModel(**known, substeps=float(min(max(math.ceil(fast / 0.25), 1), 32)))


def _unmodelled(axis: Axis) -> float:
    friction = axis.friction.values()
    coulomb = float(friction.get("coulomb", 0.0))
    beyond = STRIBECK * max(float(friction.get("breakaway", 0.0)) - coulomb, 0.0)
    return max(1.0, beyond, 0.0 if axis.disturbance is None else _largest_force(axis.disturbance))


def _largest_force(disturbance: Component) -> float:
    """Return the largest force [N] among the parameters of a disturbance."""
    kinds, values = disturbance.parameters, disturbance.values()
    forces = [values[name] for name, kind in kinds.items() if kind.unit == "{force}" and name in values]
    return max((float(np.abs(np.ravel(force)).max(initial=0.0)) for force in forces), default=0.0)


SIGNALS = ("reference", "arc_length", "axis_position", "axis_velocity", "tool_position", "motor_position", "applied_command")
OBSERVED = ("gap_estimate", "gap_deviation", "gap_confidence")
RUNS = 2
"""Runs without a gap observer, one after another: as it is, and two compensations side by side."""
WORTH = 0.02
"""Smallest share of the error that a recommended compensation must remove."""


@dataclass(frozen=True)
class FromPair:
    """Lost motion from the positions of motor and load, its standard deviation, and its free travel [m] (nan if unknown)."""

    lost_motion: float
    deviation: float
    gap: float


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


@dataclass(frozen=True)
class AxisGap:
    """The backlash of one axis.

    Attributes
    ----------
    backlash_gap : float [m]
        Free travel in the machine file, averaged over the reversals of the axis.
    lost_motion : float [m]
        Free travel plus the wind-up by friction in both directions.
    from_motor_and_load : FromPair or None
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
    from_motor_and_load: FromPair | None
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


def backlash_study(
    name: str,
    machine: Machine,
    controller: Controller,
    reference: Reference,
    *,
    seed: int = 0,
    quick: float | None = None,
    stage: Callable[[str], None] | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> BacklashStudy:
    """Estimate the gap of each axis from a simulated run, predict its limit cycles, and try compensations.

    Parameters
    ----------
    name : str
        Name of the case.
    machine, controller, reference
        See `contourlab.loop.simulate`.
    seed : int
        Seed of all noise.
    quick : float, optional
        Share of the time of a quick answer. The gap observers, and if need be all runs, then follow only the beginning of the motion, and
        limit cycles come from the describing function alone.
    stage : callable, optional
        Called with the name of each stage.
    progress : callable, optional
        Called with the number of samples done and in all.

    Raises
    ------
    ComponentError
        If no axis with a two-inertia plant has backlash.
    DivergenceError
        If the run without a compensation diverges.
    """
    begin = stage or (lambda title: None)

    def run(tried: Controller, motion: Reference, extra: tuple[str, ...] = ()) -> Result:
        report = None if progress is None else lambda done: progress(done, motion.n_sample)
        return simulate(machine, tried, motion, seed=seed, signals=(*SIGNALS, *extra), progress=report)

    loose = loose_axes(machine)
    chains = [axis for axis in machine.axes if axis.plant.two_sided and not isinstance(axis.plant, TwoInertia)]
    if not loose:
        others = sorted({axis.plant.kind for axis in chains})
        why = f": this study supports two-inertia drives only, not {', '.join(others)}" if others else ""
        raise ComponentError(f"{machine.name} has no axis with backlash{why}")
    begin(f"simulating {name} with gap observers")
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
        begin(f"finding limit cycles of axis {axis.name}")
        alone = seen_alone if observed and axis.name not in refused else None
        axes[axis.name] = _axis_gap(machine, controller, axis, result, alone, findings, exact=quick is None)
    judged = judge(result, reference)
    first = summarise(judged, reference).part_error
    begin(f"simulating {name} with compensations")
    tried = in_threads(lambda one: _tried(*one, lambda: run(_with(controller, one[1]), reference), reference), _candidates(machine, axes))
    trials = [Trial("as it is", first.rms, first.max), *tried]
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


def _tried(name: str, parts: Mapping[str, Component], run: Callable[[], Result], reference: Reference) -> Trial:
    try:
        error = summarise(judge(run(), reference), reference).part_error
    except DivergenceError:
        return Trial(name, None, None, parts)
    return Trial(name, error.rms, error.max, parts)


def _watched(machine: Machine, controller: Controller, loose: list[Axis]) -> tuple[Controller, list[str]]:
    """Add a gap observer to each axis with backlash that has none; skip and return the axes where it would change the run."""
    changed = dict(controller.axes)
    refused = []
    for axis in loose:
        loop = controller.axes[axis.name]
        if loop.gap_observer is not None:
            continue
        if loop.feedback == "motor" and _uses_load(loop):
            refused.append(axis.name)
        else:
            observer = observer_of(axis, machine.servo_period, machine.carried_mass(axis.name))
            changed[axis.name] = replace(loop, gap_observer=observer)
    return (controller if changed == dict(controller.axes) else replace(controller, axes=changed)), refused


def _uses_load(loop: AxisController) -> bool:
    """Return whether a part of the loop reads the load or the gap, which an observer would replace."""
    parts = [*loop.controllers.values(), loop.supervisor, loop.compensation]
    ports = {port.name for part in parts if part is not None for port in part.inputs}
    return bool(ports & {"load_position", "load_velocity", "gap_estimate"})


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
        seen = lost_motion_from_pair(motor, load, friction=friction, stiffness=stiffness)
        pair = FromPair(seen.lost_motion, seen.lost_motion_deviation, seen.gap)
    except ResultError as error:
        findings.append(finding("CL381", place=place, reason=str(error)))
    if observed is not None and "gap_estimate" in observed.signals:
        alone = FromMotor(*(float(observed[name][-1, j]) for name in OBSERVED))
        if alone.confidence >= SURE and abs(alone.gap - gap) > max(3.0 * alone.deviation, 0.25 * gap):
            findings.append(finding("CL382", place=place, seen=alone.gap, gap=gap))
    try:
        model = axis_backlash_loop(axis, loop, machine.servo_period, machine.carried_mass(axis.name))
        prediction = predict_limit_cycles(model) if model.contact_a is None else None
        predicted = None if prediction is None else tuple(_cycle(cycle, cycle.validity) for cycle in prediction)
        if exact:
            orbits = tuple(_cycle(orbit) for orbit in find_orbits(model, prediction=prediction))
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


def _cycle(cycle: LimitCycle | PeriodicOrbit, validity: str = "") -> Cycle:
    return Cycle(cycle.frequency / (2.0 * math.pi), cycle.amplitude, cycle.stable, validity)


def _candidates(machine: Machine, axes: Mapping[str, AxisGap]) -> Iterator[tuple[str, dict[str, Component]]]:
    """Yield compensations for the axes with motor feedback of the position loop."""
    loose = {axis: gap for axis, gap in axes.items() if gap.feedback == "motor" and gap.estimate > 0.0}
    if loose:
        parts = {axis: offset_of(machine.axis(axis), gap.estimate) for axis, gap in loose.items()}
        yield "backlash-offset", {axis: offset for axis, (offset, _) in parts.items()}
        yield "backlash-inverse", {axis: inverse for axis, (_, inverse) in parts.items()}


def _with(controller: Controller, parts: Mapping[str, Component]) -> Controller:
    changed = {axis: replace(loop, compensation=parts.get(axis, loop.compensation)) for axis, loop in controller.axes.items()}
    return replace(controller, axes=changed)


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

    def units(name: str) -> tuple[str, str]:
        plant = machine.axis(name).plant
        return plant.command_unit, plant.force_unit

    axes = {name: {"compensation": component_table(_rounded(part, units(name)), units(name))} for name, part in parts.items()}
    return toml({"controller": {"axes": axes}})


def _rounded(part: Component, units: tuple[str, str]) -> Component:
    """Return a component with values rounded to three digits in display units."""
    rounded = {}
    for name, parameter in ((name, known.for_plant(*units)) for name, known in type(part).parameters.items()):
        value = getattr(part, name)
        if isinstance(value, float) and math.isfinite(value) and not parameter.whole:
            shown = parameter.display or parameter.unit
            rounded[name] = to_si(f"{from_si(value, shown):.3g} {shown}", parameter.unit) if shown else float(f"{value:.3g}")
    made: Component = part.replace(**rounded)
    return made
