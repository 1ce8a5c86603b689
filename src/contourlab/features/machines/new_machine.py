"""The files of ``contourlab new machine``: a machine, a controller that fits it and a first scenario, from answers.

Nothing here reads input or prints.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from contourlab.app.results import proposed, spared
from contourlab.errors import OutputError, ParameterError
from contourlab.features.machines.answers import answers_text, axis_names, check_keys, machine_values, mounting, sized
from contourlab.features.machines.command import refuse_existing
from contourlab.features.machines.machine_files import axis_tables, controller_tables, machine_tables, scenario_tables
from contourlab.features.machines.questions import fault
from contourlab.features.machines.sizing import FASTEST, SizedAxis
from contourlab.rendering.table import paragraphs
from contourlab.result import write_text_atomic
from contourlab.scenario.toml_text import toml
from contourlab.units import show

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
        The axis on which an axis stands.
    """

    name: str
    period: float
    tolerance: float
    axes: tuple[SizedAxis, ...]
    below: Mapping[str, str]
    answers: Mapping[str, str]

    def files(self) -> dict[str, str]:
        """Return file name -> TOML text: machine, axes, controller, answers; and a scenario if there is a first contour."""
        files = {"machine.toml": f"# {self.name}\n\n" + toml(machine_tables(self.name, self.period, self.axes, self.below))}
        for axis in self.axes:
            files[f"axis-{axis.name}.toml"] = f"# Axis {axis.name}; total moved mass {axis.mass:.4g} kg\n\n" + toml(axis_tables(axis))
        note = "P-PI cascades; the gains follow from bandwidth and Kv"
        files["controller.toml"] = proposed(f"Controller for {self.name}: {note}", toml(controller_tables(self.axes)))
        scenario = scenario_tables(self.name, self.axes, self.tolerance)
        if scenario is not None:
            files["scenario.toml"] = "# Run it with: contourlab run scenario.toml\n\n" + toml(scenario)
        return {**files, ANSWERS: answers_text(self.answers)}

    def summary(self) -> str:
        """Return the values computed from the answers, as text."""
        return paragraphs((line for axis in self.axes for line in _about(axis)), indent="    ")


def new_machine(answers: Mapping[str, str], name: str = "My machine") -> NewMachine:
    """Return a machine from answers.

    Parameters
    ----------
    answers : mapping of str to str
        Answers by key of the question: ``servo_period``, ``x.lead``. A bare number has the unit of the question.
    name : str
        Name of a machine whose answers give none.

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
    axes = tuple(replace(axis, carried=_carried(axis.name, bare, below)).slowed_down() for axis in bare.values())
    hanging = [axis.name for axis in axes if axis.weight]
    if len(hanging) > 1:
        raise fault(f"{hanging[1]}.unbalanced_mass", f"{hanging[0]} hangs already: only one axis is vertical")
    for axis in axes:
        _check(axis, tuple(bare))
    return NewMachine(general["name"] or name, period, general["tolerance"], axes, below, answers)


def _carried(name: str, axes: Mapping[str, SizedAxis], below: Mapping[str, str]) -> float:
    """Return the mass of all modules carried by an axis."""
    above = [other for other, under in below.items() if under == name]
    return math.fsum(axes[other].stage_mass + _carried(other, axes, below) for other in above)


def _check(axis: SizedAxis, names: Sequence[str]) -> None:
    """Raise if the values of an axis do not fit together."""
    effort = "force" if axis.linear else "torque"
    if axis.values[f"peak_{effort}"] < axis.rated:
        raise fault(f"{axis.name}.peak_{effort}", f"is below the rated {effort} of {axis.rated:g} {'N' if axis.linear else 'N*m'}")
    _check_weight(axis, names)
    if axis.wanted_force > axis.peak:
        rest = (axis.peak - axis.standing_force) / axis.mass
        able = f"at most {rest:.3g} m/s^2" if rest > 0.0 else "friction, damping and weight alone need all of it"
        raise fault(
            f"{axis.name}.acceleration",
            f"{axis.acceleration:.4g} m/s^2 needs {axis.wanted_force:.4g} N, but the peak force of the motor is {axis.peak:.4g} N: {able}",
        )
    if axis.resonance and 2.0 * axis.resonance * axis.period >= 1.0:
        own, most = (show(value, "Hz", 4) for value in (axis.resonance, 0.5 / axis.period))
        raise fault(f"{axis.name}.resonance", f"{own} is not below half of the servo frequency, {most}: leave it out")
    try:
        stable = axis.margins().stable
    except ParameterError as error:
        raise fault(f"{axis.name}.bandwidth", f"{show(axis.bandwidth, 'Hz', 4)} is too low for the damping of the axis: {error}") from error
    if not stable:
        fast = "bandwidth" if axis.bandwidth_rate * axis.period > FASTEST else "kv"
        raise fault(f"{axis.name}.{fast}", f"the loop is unstable with {_gains(axis)}: give less, or leave out bandwidth and kv")


def _check_weight(axis: SizedAxis, names: Sequence[str]) -> None:
    """Raise if the unbalanced mass is not that of a vertical axis, or the motor holds neither it nor the friction."""
    key, hanging = f"{axis.name}.unbalanced_mass", axis.unbalanced_mass or 0.0
    if hanging and axis.name.lower() == "x" and {"y", "z"} <= {name.lower() for name in names}:
        raise fault(key, f"x is horizontal in a machine with y and z, but {hanging:g} kg hang on it: give them to the vertical axis")
    if hanging > axis.moved_mass + axis.carried:
        raise fault(key, f"{hanging:g} kg hang, but only {axis.moved_mass + axis.carried:g} kg move")
    if axis.friction > axis.force(axis.rated):
        raise fault(f"{axis.name}.friction", f"{axis.friction:g} N exceed the rated force of {axis.force(axis.rated):.4g} N")
    if axis.weight > axis.force(axis.rated):
        raise fault(key, f"{hanging:g} kg weigh {axis.weight:.4g} N, more than the rated force of {axis.force(axis.rated):.4g} N holds")


def _gains(axis: SizedAxis) -> str:
    return f"a velocity loop of {show(axis.bandwidth, 'Hz', 3)} and Kv {axis.kv:.4g} 1/s ({show(axis.kv, '(m/min)/mm', 3)})"


def _about(axis: SizedAxis) -> list[str]:
    rotating = "" if axis.linear else f", rotating parts {axis.reflected:.4g} kg ({axis.reflected / axis.mass:.0%})"
    carried = f", {axis.carried:.4g} kg carried" if axis.carried else ""
    rated, margins, model = axis.force(axis.rated), axis.margins(), axis.plant.loaded(axis.carried).rigid_model()
    lines = [
        f"axis {axis.name}: {axis.mass:.4g} kg in total: {axis.moved_mass:.4g} kg moved{carried}{rotating}",
        f"  force {rated:.4g} N rated, {axis.peak:.4g} N peak; {axis.wanted_force:.4g} N needed at its limits",
    ]
    if axis.weight:
        lines.append(f"  {axis.unbalanced_mass:g} kg hang on it: {axis.weight:.4g} N of its rated force")
    loss = {"friction": f"friction {axis.friction:.4g} N", "damping": f"damping {axis.damping:.4g} N*s/m"}
    guessed = [text for key, text in loss.items() if key in axis.guesses]
    lines += [f"  guessed {' and '.join(guessed)}: measure them"] if guessed else []
    lines.append(f"  model {model[0]:.4g} m/s^2/A, {model[1]:.4g} 1/s")
    lines.append(f"  {_gains(axis)}: margins {20.0 * math.log10(margins.gain):.3g} dB, {math.degrees(margins.phase):.3g} deg")
    if margins.gain < ENOUGH[0] or margins.phase < ENOUGH[1]:
        lines.append("  that is less than 6 dB and 30 deg: lower bandwidth or Kv, or leave them to the proposal")
    if axis.wanted_force > 1.001 * rated:
        lines.append("  its limits need more than the rated force, which the motor gives only for a short time")
    return lines


def check_folder(folder: str | Path, *, force: bool = False) -> None:
    """Raise OutputError if a machine cannot be written into a folder, or would replace one; before any question."""
    if Path(folder).suffix == ".toml":
        raise OutputError(f"{folder}: --out names a folder for several files: write a name without .toml")
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
    targets = {Path(folder) / name: text for name, text in machine.files().items()}
    answers = Path(folder) / ANSWERS
    if any(Path(read).resolve() == answers.resolve() for read in inputs):
        del targets[answers]
    refuse_existing(targets, folder, force)
    for target in targets:
        spared(target, inputs)
    for target, text in targets.items():
        write_text_atomic(target, text)
    return list(targets)
