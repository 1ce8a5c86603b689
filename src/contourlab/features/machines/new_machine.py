"""The files of ``contourlab new machine``: a machine, a controller that fits it and a first scenario, from answers.

Nothing here reads input or prints.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from contourlab.app.results import proposed, spared
from contourlab.components.origin import Origin
from contourlab.controls.contract import ControlFile, position_drive
from contourlab.errors import OutputError, ParameterError, refuse
from contourlab.features.machines.answers import QUESTIONS, answers_text, axis_names, check_keys, fault, machine_values, mounting, sized
from contourlab.features.machines.command import refuse_existing
from contourlab.features.machines.sizing import DAMPING, FASTEST, SizedAxis, rounded
from contourlab.rendering.table import paragraphs
from contourlab.result import write_text_atomic
from contourlab.scenario.provenance import origin_table
from contourlab.scenario.toml_text import Noted, toml
from contourlab.units import from_si, show


def _written(value: float, unit: str) -> str | float:
    """Write an SI value in a unit; a bare number without one."""
    number = f"{from_si(value, unit):.12g}"
    return f"{number} {unit}" if unit else float(number)


def _number(axis: SizedAxis, key: str, unit: str | None = None, of: Callable[[SizedAxis], float] | None = None, note: str = "") -> Noted:
    """Return a number that follows from the answer `key`, as given, or guessed within a range; by default in the unit of the question."""
    value = of or (lambda sized: float(sized.values[key]))
    question = QUESTIONS[key]
    unit = question.unit if unit is None else unit
    if key not in axis.guesses:
        return _noted(value(axis), unit, Origin("datasheet", reference="as given", note=note))
    span = axis.span(key, value, question.spread) if question.spread else None
    why = f"guess: {question.rule or question.guess()}" + (f"; {note}" if note else "")
    return _noted(rounded(value(axis)), unit, Origin("assumed", span=span, note=why))


def _noted(value: float, unit: str, origin: Origin) -> Noted:
    return Noted(origin_table(_written(value, unit), origin, lambda end: _written(rounded(end), unit)))


def _guessed(value: float, unit: str, low: float, high: float, why: str) -> Noted:
    return _noted(value, unit, Origin("assumed", span=(low, high), note=f"guess: {why}"))


def _plant(axis: SizedAxis) -> dict[str, Any]:
    if axis.drive == "stepper":
        given: dict[str, Any] = {key: _number(axis, key) for key in ("holding_torque", "corner_speed", "damping")}
        given["damping_ratio"] = _guessed(0.1, "", 0.05, 0.15, "steppers on usual drives")
        if axis.pulse:
            how = Origin("computed", note="travel of a full step over that of a pulse")
            given["microsteps"] = _noted(round(axis.microsteps), "", how)
        return {"kind": "stepper", "mass": _number(axis, "moved_mass"), **_screw(axis), **given}
    noted = {
        "mass": _number(axis, "moved_mass"),
        **({"force_constant": _number(axis, "force_constant")} if axis.linear else _screw(axis)),
        "damping": _number(axis, "damping"),
        **({"resonance": _number(axis, "resonance", of=lambda sized: sized.own_resonance)} if axis.resonance else {}),
    }
    return {"kind": axis.plant.kind, **noted}


def _screw(axis: SizedAxis) -> dict[str, Noted]:
    inertia = _number(axis, "screw_inertia", of=lambda sized: sized.inertia, note="rotor, coupling and screw")
    keys = [key for key in ("lead", "torque_constant", "efficiency") if axis.values[key]]
    given = {key: _number(axis, key, "" if key == "efficiency" else None) for key in keys}
    return {"inertia": inertia, **given}


def _friction(axis: SizedAxis) -> dict[str, Any]:
    return {
        "kind": "coulomb",
        "coulomb": _number(axis, "friction", note="measure it"),
        "breakaway": _guessed(rounded(1.25 * axis.friction), "N", axis.friction, 1.5 * axis.friction, "a quarter above sliding"),
        "stribeck_velocity": _guessed(2e-3, "mm/s", 1e-3, 3e-3, "typical of rail guides"),
    }


def axis_tables(axis: SizedAxis) -> dict[str, Any]:
    """Return the axis file."""
    peak = "peak_force" if axis.linear else "peak_torque"
    sensor = "motor_sensor" if axis.resonance else "sensor"
    pulse = _number(axis, "pulse") if axis.pulse else None
    tables = position_drive(axis.period, pulse) if axis.drive == "step-drive" else {"plant": _plant(axis)}
    tables |= {
        **({"substeps": axis.substeps} if axis.resonance or axis.drive == "stepper" else {}),
        **({"friction": _friction(axis)} if axis.friction else {}),
        "limits": {key: _number(axis, key) for key in ("velocity", "acceleration", "jerk", "travel") if axis.values[key]},
    }
    if not axis.stepping:
        limit = _number(axis, peak, "A", lambda sized: rounded(sized.current), f"{axis.peak:.4g} N")
        encoder = {"kind": "encoder", "resolution": _number(axis, "encoder_resolution")}
        tables |= {"drive": {"kind": "saturation", "limit": limit}, sensor: encoder}
    if axis.backlash:
        tables["error"] = {"backlash": _number(axis, "backlash")}
    if axis.weight:
        note = "weight of the unbalanced mass; the positive direction is up"
        tables["disturbance"] = {"kind": "constant", "force": _number(axis, "unbalanced_mass", "N", lambda sized: -sized.weight, note)}
    return tables


def machine_tables(name: str, period: float, axes: Sequence[SizedAxis], below: Mapping[str, str]) -> dict[str, Any]:
    """Return the machine file."""

    def placed(axis: SizedAxis) -> dict[str, Any]:
        table: dict[str, Any] = {"file": f"axis-{axis.name}.toml"}
        if axis.name in below:
            table |= {"mounted_on": below[axis.name], "alignment": 0.0, "stage_mass": _written(axis.stage_mass, "kg")}
        return table

    head = {"name": name, "servo_period": _written(period, "ms"), "axes": [axis.name for axis in axes]}
    return {"machine": head, "axes": {axis.name: placed(axis) for axis in axes}}


def controller_tables(axes: Sequence[SizedAxis]) -> dict[str, Any]:
    """Return the controller file."""

    def of_axis(axis: SizedAxis) -> dict[str, Any]:
        if axis.stepping:
            return {"controller": "steps"}
        rate = axis.bandwidth_rate
        gains = {
            "bandwidth": Noted(_written(rate, "rad/s"), show(axis.bandwidth, "Hz", 4)),
            "damping": DAMPING,
            "position_gain": Noted(_written(axis.kv, "1/s"), f"Kv, {show(axis.kv, '(m/min)/mm', 4)}"),
        }
        late = _written(axis.filter_rate, "rad/s")
        table: dict[str, Any] = {
            "velocity": {"kind": "filtered-difference", "bandwidth": late},
            "controller": {"kind": "cascade", "gains": gains, "balance_bandwidth": late},
        }
        if axis.resonance:
            shapes = {name: {"kind": part.kind, **part.values()} for name, part in axis.controller.filters}
            table |= {"feedback": "motor", "filters": {name: _rounded(shape) for name, shape in shapes.items()}}
        return table

    return {"controller": {"axes": {axis.name: of_axis(axis) for axis in axes}}}


def _rounded(shape: dict[str, Any]) -> dict[str, Any]:
    """Return the numbers of a filter with four digits; its frequency has a unit."""
    numbers = {key: rounded(value) for key, value in shape.items() if isinstance(value, float)}
    return {"kind": shape["kind"], **numbers, "frequency": _written(numbers["frequency"], "Hz")}


def scenario_tables(name: str, axes: Sequence[SizedAxis], tolerance: float) -> dict[str, Any] | None:
    """Return a first scenario: the shipped test part for x, y and z, a circle for two axes; None for other machines."""
    names = [axis.name for axis in axes]
    parts: dict[str, Any] = {"name": f"{name}: first run", "machine": "machine.toml", "controller": "controller.toml"}
    run = {"run": {"tolerance": _written(tolerance, "um")}}
    if [n.lower() for n in names] == ["x", "y", "z"]:
        return {**parts, "program": "builtin:programs/circle_diamond_square.ngc", **run}
    if len(names) != 2:
        return None
    feed = 0.25 * min(axis.velocity for axis in axes)
    return {
        **parts,
        "contour": {"name": "circle", "radius": "20 mm"},
        "feed": {"law": "planned", "feedrate": _written(feed, "m/min"), "laps": 2},
        **run,
    }


ENOUGH = 10.0 ** (6.0 / 20.0), math.radians(30.0)
"""Gain and phase margin [rad] of a sound loop."""
ANSWERS = "answers.toml"


@dataclass(frozen=True)
class NewMachine:
    """A machine read from answers.

    Attributes
    ----------
    period : float [s]
    tolerance : float [m]
        Of the first run.
    below : mapping of str to str
        The axis on which an axis stands; step drives, which no load moves, are left out.
    control : ControlFile or None
        The control's own file, which the machine file then names.
    """

    name: str
    period: float
    tolerance: float
    axes: tuple[SizedAxis, ...]
    below: Mapping[str, str]
    answers: Mapping[str, str]
    control: ControlFile | None = None

    def files(self, folder: str | Path = "") -> dict[str, str]:
        """Return file name -> TOML text: machine, axes, controller, answers; and a scenario if there is a first contour.

        A machine of a control's own file has all axes in one file, which names that file relative to the folder.
        """
        machine = machine_tables(self.name, self.period, self.axes, self.below)
        if self.control is not None:
            machine["machine"] = {"file": os.path.relpath(self.control.file, folder or os.curdir), "name": self.name}
            for axis in self.axes:
                own, read = axis_tables(axis), self.control.tables["axes"][axis.name]
                absent = {"jerk"} & axis.guesses  # such a control plans without
                own["limits"] = {key: value for key, value in own["limits"].items() if key not in {*read["limits"], *absent}}
                own["plant"] = {key: value for key, value in own["plant"].items() if key != "pulse"}
                machine["axes"][axis.name] = {**machine["axes"][axis.name], **own}
                del machine["axes"][axis.name]["file"]
        files = {"machine.toml": f"# {self.name}\n\n" + toml(machine)}
        for axis in self.axes if self.control is None else ():
            files[f"axis-{axis.name}.toml"] = f"# Axis {axis.name}; total moved mass {axis.mass:.4g} kg\n\n" + toml(axis_tables(axis))
        closes = not all(axis.stepping for axis in self.axes)
        note = "P-PI cascades; the gains follow from bandwidth and Kv" if closes else "it closes no loop, and has no gains"
        files["controller.toml"] = proposed(f"Controller for {self.name}: {note}", toml(controller_tables(self.axes)))
        scenario = scenario_tables(self.name, self.axes, self.tolerance) if self.control is None else None
        if scenario is not None:
            files["scenario.toml"] = "# Run it with: contourlab run scenario.toml\n\n" + toml(scenario)
        return {**files, ANSWERS: answers_text(self.answers)}

    def summary(self) -> str:
        """Return the values computed from the answers, as text."""
        return paragraphs((line for axis in self.axes for line in _about(axis)), indent="    ")


def new_machine(answers: Mapping[str, str], name: str = "My machine", control: ControlFile | None = None) -> NewMachine:
    """Return a machine from answers.

    Parameters
    ----------
    answers : mapping of str to str
        Answers by key of the question: ``servo_period``, ``x.lead``. A bare number has the unit of the question.
    name : str
        Name of a machine whose answers give none.
    control : ControlFile, optional
        The control's own file; see `contourlab.features.machines.answers.of_control`.

    Raises
    ------
    ScenarioError
        If an answer is missing, implausible, or does not fit the others; has the key of its question.

    Notes
    -----
    Moved mass m + m_c + J (2 pi/l)^2; force 2 pi eta T/l. The velocity loop gets both poles at the bandwidth (Pritschow, CIRP Annals 47(2),
    1998, for the structure); a value without an answer is a guess with a range.
    """
    check_keys(answers)
    general, below = machine_values(answers), mounting(answers)
    period = general["servo_period"]
    bare = {name: sized(answers, name, period) for name in axis_names(answers)}
    below = {name: under for name in below if (under := _bearing(name, bare, below))}
    axes = tuple(sized(answers, name, period, carried=_carried(name, bare, below)).slowed_down() for name in bare)
    hanging = [axis.name for axis in axes if axis.weight]
    if len(hanging) > 1:
        raise fault(f"{hanging[1]}.unbalanced_mass", f"{hanging[0]} hangs already: only one axis is vertical")
    for axis in axes:
        _check(axis, tuple(bare))
    return NewMachine(general["name"] or name, period, general["tolerance"], axes, below, answers, control)


def _bearing(name: str, axes: Mapping[str, SizedAxis], below: Mapping[str, str]) -> str:
    """Return the first axis below whose plant has a mass, which a step drive has not; empty for none."""
    under = below.get(name, "")
    return under if not under or axes[under].drive != "step-drive" else _bearing(under, axes, below)


def _carried(name: str, axes: Mapping[str, SizedAxis], below: Mapping[str, str]) -> float:
    """Return the mass of all modules carried by an axis."""
    above = [other for other, under in below.items() if under == name]
    return math.fsum(axes[other].stage_mass + _carried(other, axes, below) for other in above)


def _check(axis: SizedAxis, names: Sequence[str]) -> None:
    """Raise if the values of an axis do not fit together."""
    if axis.drive == "step-drive":
        return
    effort, unit = ("force", "N") if axis.linear else ("torque", "N*m")
    hanging, moved, rated = axis.unbalanced_mass or 0.0, axis.moved_mass + axis.carried, axis.force(axis.rated)
    horizontal = axis.name.lower() == "x" and {"y", "z"} <= {name.lower() for name in names}
    rest = (axis.peak - axis.standing_force) / axis.mass
    able = f"at most {rest:.3g} m/s^2" if rest > 0.0 else "friction, damping and weight alone need all of it"
    needs = f"{axis.acceleration:.4g} m/s^2 needs {axis.wanted_force:.4g} N, but the peak force of the motor is {axis.peak:.4g} N: {able}"
    resonance, most = (show(value, "Hz", 4) for value in (axis.resonance or 0.0, 0.5 / axis.period))
    on_x = f"x is horizontal in a machine with y and z, but {hanging:g} kg hang on it: give them to the vertical axis"
    heavy = f"{hanging:g} kg weigh {axis.weight:.4g} N, more than the rated force of {rated:.4g} N holds"
    off = f"a full step has {axis.microsteps:.4g} pulses of {show(axis.pulse or 0.0, 'um', 4)}: check it against the steps per millimetre"
    for key, wrong, message in (
        ("lead", axis.pulse and not abs(axis.microsteps - max(round(axis.microsteps), 1)) < 0.02, off),
        (f"peak_{effort}", axis.peak < axis.force(axis.rated), f"is below the rated {effort} of {axis.rated:g} {unit}"),
        ("unbalanced_mass", hanging and horizontal, on_x),
        ("unbalanced_mass", hanging > moved, f"{hanging:g} kg hang, but only {moved:g} kg move"),
        ("friction", axis.friction > rated, f"{axis.friction:g} N exceed the rated force of {rated:.4g} N"),
        ("unbalanced_mass", axis.weight > rated, heavy),
        ("acceleration", axis.wanted_force > axis.peak, needs),
        ("resonance", not axis.below_half, f"{resonance} is not below half of the servo frequency, {most}: leave it out"),
    ):
        refuse(wrong, fault, f"{axis.name}.{key}", message)
    if axis.stepping:
        return
    try:
        stable = axis.margins().stable
    except ParameterError as error:
        raise fault(f"{axis.name}.bandwidth", f"{show(axis.bandwidth, 'Hz', 4)} is too low for the damping of the axis: {error}") from error
    if not stable:
        fast = "bandwidth" if axis.bandwidth_rate * axis.period > FASTEST else "kv"
        raise fault(f"{axis.name}.{fast}", f"the loop is unstable with {_gains(axis)}: give less, or leave out bandwidth and kv")


def _gains(axis: SizedAxis) -> str:
    return f"a velocity loop of {show(axis.bandwidth, 'Hz', 3)} and Kv {axis.kv:.4g} 1/s ({show(axis.kv, '(m/min)/mm', 3)})"


def _about(axis: SizedAxis) -> list[str]:
    if axis.drive == "step-drive":
        return [f"axis {axis.name}: follows its steps, with a lag that is guessed; loads and friction do not move it"]
    rotating = "" if axis.linear else f", rotating parts {axis.reflected:.4g} kg ({axis.reflected / axis.mass:.0%})"
    carried = f", {axis.carried:.4g} kg carried" if axis.carried else ""
    rated, most = axis.force(axis.rated), "held at rest" if axis.stepping else "peak"
    lines = [
        f"axis {axis.name}: {axis.mass:.4g} kg in total: {axis.moved_mass:.4g} kg moved{carried}{rotating}",
        f"  force {rated:.4g} N rated, {axis.peak:.4g} N {most}; {axis.wanted_force:.4g} N needed at its limits",
    ]
    if axis.weight:
        lines.append(f"  {axis.unbalanced_mass:g} kg hang on it: {axis.weight:.4g} N of its rated force")
    loss = {"friction": f"friction {axis.friction:.4g} N", "damping": f"damping {axis.damping:.4g} N*s/m"}
    guessed = [text for key, text in loss.items() if key in axis.guesses]
    lines += [f"  guessed {' and '.join(guessed)}: measure them"] if guessed else []
    if axis.stepping:
        return lines
    margins, model = axis.margins(), axis.plant.loaded(axis.carried).rigid_model()
    lines.append(f"  model {model[0]:.4g} m/s^2/A, {model[1]:.4g} 1/s")
    lines.append(f"  {_gains(axis)}: margins {20.0 * math.log10(margins.gain):.3g} dB, {math.degrees(margins.phase):.3g} deg")
    if margins.gain < ENOUGH[0] or margins.phase < ENOUGH[1]:
        lines.append("  that is less than 6 dB and 30 deg: lower bandwidth or Kv, or leave them to the proposal")
    if axis.wanted_force > 1.001 * rated:
        lines.append("  its limits need more than the rated force, which the motor gives only for a short time")
    return lines


def check_folder(folder: str | Path, *, force: bool = False) -> None:
    """Raise OutputError if a machine cannot be written into a folder, or would replace one; before any question."""
    refuse(Path(folder).suffix == ".toml", OutputError, f"{folder}: --out names a folder for several files: write a name without .toml")
    refuse_existing([Path(folder) / "machine.toml"], folder, force)


def write_machine(machine: NewMachine, folder: str | Path, *, force: bool = False, inputs: Sequence[str | Path] = ()) -> list[Path]:
    """Write the files of a machine into a folder; create it if missing.

    Parameters
    ----------
    force : bool
        Whether to overwrite existing files.
    inputs : sequence of str or Path
        Files that were read; never overwritten. The answers are not written if they were read from there.

    Raises
    ------
    ParameterError
        If another target is among `inputs`.
    OutputError
        If the folder has the name of a file, a file exists (raised before anything is written) or cannot be written.
    """
    check_folder(folder, force=force)
    targets = {Path(folder) / name: text for name, text in machine.files(folder).items()}
    answers = Path(folder) / ANSWERS
    if any(Path(read).resolve() == answers.resolve() for read in inputs):
        del targets[answers]
    refuse_existing(targets, folder, force)
    for target in targets:
        spared(target, inputs)
    for target, text in targets.items():
        write_text_atomic(target, text)
    return list(targets)
