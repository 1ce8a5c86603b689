"""What the backlash of a machine's axes is, as it can be measured; what it does to the loops; and what best takes it off the part."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.backlash.limit_cycle_prediction import LimitCycle, predict_limit_cycles
from contourlab.analysis.backlash.lure import BacklashLoop, axis_backlash_loop
from contourlab.analysis.backlash.periodic_orbit import OrbitSearch, find_orbits
from contourlab.components.contract import Component
from contourlab.components.gap_observer.multiple_model import MultipleModel
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.errors import ComponentError, DivergenceError, ParameterError, ResultError
from contourlab.features.run.compensate import lost_motion_of, offset_of
from contourlab.feed import Reference
from contourlab.loop import Axis, AxisController, Controller, Machine, simulate
from contourlab.loop.sensing import SURE
from contourlab.metrics import CircleBacklash, LostMotion, Metrics, backlash_of_runs, circles_of, judge, lost_motion_from_pair, summarise
from contourlab.result import Result

SIGNALS = ("reference", "arc_length", "axis_position", "axis_velocity", "tool_position", "motor_position", "applied_command")
OBSERVED = ("gap_estimate", "gap_deviation", "gap_confidence")


@dataclass(frozen=True)
class AxisGap:
    """The backlash of one axis.

    Attributes
    ----------
    axis : str
    gap : float [m]
        Free travel of the machine file where the axis turns round, on average.
    lost_motion : float [m]
        That, and what friction winds the shaft up by on either side.
    pair : LostMotion or None
        Estimated from the positions of motor and load in the run; None where it could not be.
    motor_side : (float, float, float) or None
        Gap [m], its standard deviation [m] and confidence at the end of the run, from the motor alone.
    prediction : tuple of LimitCycle or None
        Limit cycles of the describing function; None for a loop that switches its controller, or has no linear model.
    orbits : OrbitSearch or None
        Exact limit cycles, without friction.
    remarks : tuple of str
        Why something is missing.
    """

    axis: str
    gap: float
    lost_motion: float
    pair: LostMotion | None = None
    motor_side: tuple[float, float, float] | None = None
    prediction: tuple[LimitCycle, ...] | None = None
    orbits: OrbitSearch | None = None
    remarks: tuple[str, ...] = ()

    @property
    def estimate(self) -> float:
        """Lost motion to compensate [m]: as measured on motor and load, else the machine file's."""
        return self.lost_motion if self.pair is None else max(self.pair.lost_motion, 0.0)


@dataclass(frozen=True)
class Trial:
    """A compensation that was tried: its components by axis, none as the scenario has it, and the figures; None if it ran away."""

    name: str
    parts: Mapping[str, Component]
    metrics: Metrics | None


@dataclass(frozen=True)
class BacklashStudy:
    """What was found of a case: each axis with backlash, what was tried, the number of what is recommended; and the circles of the path."""

    name: str
    axes: tuple[AxisGap, ...]
    trials: tuple[Trial, ...]
    best: int
    remarks: tuple[str, ...] = field(default_factory=tuple)
    circle: CircleBacklash | None = None

    @property
    def recommended(self) -> Trial:
        """The trial with the smallest rms of the part error; as the scenario has it where nothing is better by `WORTH`."""
        return self.trials[self.best]


STRIBECK = 0.2
"""Part of what breakaway is above Coulomb friction that acts as unmodelled force."""
UNSURE = 0.1
"""Of what the observer is told of torque, inertia and friction: no machine file is better."""
WORTH = 0.02
"""Part of the error that a compensation has to take off to be recommended."""


def observer_of(axis: Axis, servo_period: float, carried_mass: float = 0.0) -> MultipleModel:
    """Return the observer of an axis' gap that knows its drive as the machine file does.

    What its model has no place for, a breakaway above Coulomb friction and a disturbance, it is told to reckon with as a force.

    Parameters
    ----------
    axis : Axis
        With a two-inertia plant.
    servo_period : float [s], > 0
    carried_mass : float [kg]
    """
    plant = axis.plant.loaded(carried_mass)
    known = {name: value for name, value in plant.values().items() if name in MultipleModel.parameters}
    known["mass"] = plant.mass + plant.carried_mass
    friction = {"coulomb": axis.friction, "motor_coulomb": axis.motor_friction}
    known |= {name: part.values()["coulomb"] for name, part in friction.items() if "coulomb" in part.parameters}
    if "resolution" in axis.motor_sensor.parameters:
        known["resolution"] = axis.motor_sensor.values()["resolution"]
    known |= {"unmodelled_force": _unmodelled(axis), "uncertainty": UNSURE}
    known["largest_gap"] = max(MultipleModel.parameters["largest_gap"].default, 5.0 * plant.widest_gap)
    # Guesses 15 % apart at most, in one of two numbers: each takes machine code of its own.
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
    """Return the largest of the forces [N] that a disturbance is described by."""
    kinds, values = disturbance.parameters, disturbance.values()
    forces = [values[name] for name, kind in kinds.items() if kind.unit == "{force}" and name in values]
    return max((float(np.abs(np.ravel(force)).max(initial=0.0)) for force in forces), default=0.0)


def backlash_study(
    name: str,
    machine: Machine,
    controller: Controller,
    reference: Reference,
    *,
    seed: int = 0,
    stage: Callable[[str], None] | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> BacklashStudy:
    """Estimate the gap of each axis from a simulated run, predict its limit cycles, and try compensations.

    Parameters
    ----------
    name : str
        Of the case.
    machine, controller, reference
        As of `contourlab.loop.simulate`.
    seed : int
        Of all noise.
    stage : callable, optional
        Told in words what is begun.
    progress : callable, optional
        Told samples done and samples in all.

    Raises
    ------
    ComponentError
        If no axis has backlash.
    DivergenceError
        If the run without a change runs away.
    """
    begin = stage or (lambda words: None)

    def run(machine_controller: Controller, extra: tuple[str, ...] = ()) -> Result:
        told = None if progress is None else lambda done: progress(done, reference.n_sample)
        return simulate(machine, machine_controller, reference, seed=seed, signals=(*SIGNALS, *extra), progress=told)

    loose = [axis for axis in machine.axes if isinstance(axis.plant, TwoInertia) and axis.plant.widest_gap > 0.0]
    chains = [axis for axis in machine.axes if axis.plant.two_sided and not isinstance(axis.plant, TwoInertia)]
    if not loose:
        others = sorted({axis.plant.kind for axis in chains})
        why = f": of drives with backlash this study knows two-inertia, not {', '.join(others)}" if others else ""
        raise ComponentError(f"{machine.name} has no axis with backlash{why}")
    begin(f"simulating {name} with observers of its gaps")
    watched, refusals = _watched(machine, controller, loose)
    observed = any(mine.gap_observer is not None for mine in watched.axes.values())
    result = run(watched, OBSERVED if observed else ())
    axes = []
    for axis in loose:
        begin(f"looking for limit cycles of axis {axis.name}")
        axes.append(_axis_gap(machine, controller, axis, result, refusals.get(axis.name, ())))
    judged = judge(result, reference)
    trials = [Trial("as it is", {}, summarise(judged, reference))]
    for label, parts in _candidates(machine, controller, axes):
        begin(f"simulating {name} with {label}")
        trials.append(Trial(label, parts, _figures(run, _having(controller, parts), reference)))
    left = (
        (f"of axes {', '.join(axis.name for axis in chains)} nothing is told: this study knows two-inertia drives alone",) if chains else ()
    )
    remarks = (*_remarks(controller, axes), *left)
    return BacklashStudy(name, tuple(axes), tuple(trials), _best(trials), remarks, _on_circles(judged, reference, machine))


def _on_circles(judged: Result, reference: Reference, machine: Machine) -> CircleBacklash | None:
    """Return the backlash that the first circle of the path shows, in both senses where it is run in both; None without a circle."""
    runs = circles_of(judged, reference)
    alike = [run for run in runs if abs(run.radius - runs[0].radius) < 1e-9] if runs else []
    senses = {run.clockwise: run for run in reversed(alike)}
    if not senses or len(machine.axes) < 2:
        return None
    try:
        return backlash_of_runs(tuple(senses.values()), axes=machine.axis_names[:2])  # type: ignore[arg-type]
    except (ResultError, ParameterError):
        return None


def _figures(run: Callable[[Controller], Result], controller: Controller, reference: Reference) -> Metrics | None:
    try:
        return summarise(judge(run(controller), reference), reference)
    except DivergenceError:
        return None


def _watched(machine: Machine, controller: Controller, loose: list[Axis]) -> tuple[Controller, dict[str, tuple[str, ...]]]:
    """Return the controller with an observer on each loose axis that has none, which leaves the run as it is, and why one is missing."""
    changed = dict(controller.axes)
    refusals: dict[str, tuple[str, ...]] = {}
    for axis in loose:
        mine = controller.axes[axis.name]
        if mine.gap_observer is None and mine.feedback == "motor" and _uses_load(mine):
            refusals[axis.name] = (
                "not estimated from the motor alone: an observer would take the place of the scale that its controllers use",
            )
        elif mine.gap_observer is None:
            observer = observer_of(axis, machine.servo_period, machine.carried_mass(axis.name))
            changed[axis.name] = replace(mine, gap_observer=observer)
    return (controller if changed == dict(controller.axes) else replace(controller, axes=changed)), refusals


def _uses_load(mine: AxisController) -> bool:
    """Tell whether a controller, supervisor or compensation of an axis reads the load, or the gap, which an observer would speak for."""
    parts = [*mine.controllers.values(), mine.supervisor, mine.compensation]
    ports = {port.name for part in parts if part is not None for port in part.inputs}
    return bool(ports & {"load_position", "load_velocity", "gap_estimate"})


def _axis_gap(machine: Machine, controller: Controller, axis: Axis, result: Result, remarks: tuple[str, ...]) -> AxisGap:
    j, plant = machine.axis_names.index(axis.name), machine.loaded_plant(axis.name)
    assert isinstance(plant, TwoInertia)  # only such an axis is asked about
    values = plant.constants()
    stiffness = float(values.stiffness_value)
    moving = np.abs(result["axis_velocity"][:, j])
    speed = float(moving[moving > 0.1 * moving.max()].mean()) if moving.any() else 0.0
    viscous = float(values.load_decay / values.load_mobility) + float(axis.friction.values().get("viscous", 0.0))
    friction = float(axis.friction.values().get("coulomb", 0.0)) + viscous * speed
    gap, said = _gap_where_it_turns(plant, result["axis_velocity"][:, j], result["axis_position"][:, j]), list(remarks)
    pair = motor_side = prediction = orbits = None
    try:
        pair = lost_motion_from_pair(result["motor_position"][:, j], result["axis_position"][:, j], friction=friction, stiffness=stiffness)
    except ResultError as error:
        said.append(f"not estimated from motor and load: {error}")
    if "gap_estimate" in result.signals and not remarks:
        gap_seen, deviation, confidence = (float(result[name][-1, j]) for name in OBSERVED)
        motor_side = (gap_seen, deviation, confidence)
        if confidence >= SURE and abs(gap_seen - gap) > max(3.0 * deviation, 0.25 * gap):
            said.append("the observer is sure and wrong here, by the machine file: no supervisor or compensation is to be built on it")
    try:
        loop = axis_backlash_loop(axis, controller.axes[axis.name], machine.servo_period, machine.carried_mass(axis.name))
        prediction, orbits = _cycles(loop)
    except ComponentError as error:
        said.append(f"limit cycles not looked for: {error}")
    return AxisGap(axis.name, gap, lost_motion_of(axis), pair, motor_side, prediction, orbits, tuple(said))


def _gap_where_it_turns(plant: TwoInertia, velocity: NDArray[np.float64], position: NDArray[np.float64]) -> float:
    """Return the mean free travel [m] of the machine file where the axis turns round; the widest where it never does."""
    forward = velocity[velocity != 0.0] > 0.0
    turns = position[velocity != 0.0][1:][forward[1:] != forward[:-1]]
    return float(np.mean([plant.gap_at(float(place)) for place in turns])) if turns.size else plant.widest_gap


def _cycles(loop: BacklashLoop) -> tuple[tuple[LimitCycle, ...] | None, OrbitSearch]:
    prediction = predict_limit_cycles(loop) if loop.contact_a is None else None
    return prediction, find_orbits(loop, prediction=prediction)


def _candidates(machine: Machine, controller: Controller, axes: list[AxisGap]) -> Iterator[tuple[str, dict[str, Component]]]:
    """Yield compensations to try on the axes whose position loop is closed over the motor: that over the load sees the gap itself."""
    open_to = [one for one in axes if controller.axes[one.axis].feedback == "motor" and one.estimate > 0.0]
    if not open_to:
        return
    made = {one.axis: offset_of(machine.axis(one.axis), one.estimate) for one in open_to}
    yield "backlash-offset", {name: parts[0] for name, parts in made.items()}
    yield "backlash-inverse", {name: parts[1] for name, parts in made.items()}


def _having(controller: Controller, parts: Mapping[str, Component]) -> Controller:
    changed = {name: replace(mine, compensation=parts.get(name, mine.compensation)) for name, mine in controller.axes.items()}
    return replace(controller, axes=changed)


def _best(trials: list[Trial]) -> int:
    errors = [math.inf if trial.metrics is None else trial.metrics.part_error.rms for trial in trials]
    best = min(range(len(trials)), key=errors.__getitem__)
    return best if errors[best] <= (1.0 - WORTH) * errors[0] else 0


def _remarks(controller: Controller, axes: list[AxisGap]) -> Iterator[str]:
    over_load = [one.axis for one in axes if controller.axes[one.axis].feedback == "load"]
    if over_load:
        yield (
            f"the position loop of {', '.join(over_load)} is closed over the load: it takes the gap up itself, and a compensation of the "
            "reference would count it twice; what it asks for is freedom from limit cycles"
        )
    hunting = [one.axis for one in axes if one.orbits is not None and one.orbits.stable]
    if hunting:
        yield (
            f"axis {', '.join(hunting)} has a stable limit cycle where friction does not hold it: lower its gains, add damping between "
            "motor and load (load-side-cascade), or see with `contourlab run` whether friction suffices"
        )
