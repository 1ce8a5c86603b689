"""The wizard of ``contourlab new machine``: questions, and the files of a machine and its controller from the answers.

Nothing here reads input or prints. `questions` returns the questions, `build_machine` the files, `explain` a summary; `write_machine`
writes the files.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from contourlab.app.results import spared
from contourlab.errors import ScenarioError, UnitError
from contourlab.features.machines import sizing
from contourlab.features.machines.command import refuse_existing
from contourlab.features.machines.machine_files import axis_tables, controller_tables, machine_tables, scenario_tables
from contourlab.features.machines.sizing import SizedAxis
from contourlab.result import write_text_atomic
from contourlab.scenario.quantities import read_number
from contourlab.scenario.toml_text import toml

NAME = re.compile(r"[A-Za-z0-9_]{1,32}\Z")
MOST_AXES = 9


@dataclass(frozen=True)
class Question:
    """One question.

    Attributes
    ----------
    key : str
        Key of the answer: ``name``, ``x.lead``.
    text : str
        Printed text.
    unit : str
        Unit of a bare number; empty for text.
    si : str
        SI unit of the same dimension.
    default : str
        Default answer; may be empty.
    required : bool
        Whether an answer is required.
    """

    key: str
    text: str
    unit: str = ""
    si: str = ""
    default: str = ""
    required: bool = True


_GENERAL = (
    Question("name", "Name of the machine", default="My machine"),
    Question("axes", "Names of the axes, in the order of the coordinates", default="x, y"),
    Question("servo_period", "Servo period", "ms", "s", "1 ms"),
)
_PER_AXIS = (
    Question("rated_torque", "Rated torque of the motor", "N*m", "N*m"),
    Question("peak_torque", "Peak torque of the motor with its drive", "N*m", "N*m"),
    Question("torque_constant", "Torque constant of the motor", "N*m/A", "N*m/A"),
    Question("rotor_inertia", "Inertia of the rotor", "kg*cm^2", "kg*m^2"),
    Question("screw_inertia", "Inertia of coupling and screw", "kg*cm^2", "kg*m^2", "0.5 kg*cm^2"),
    Question("lead", "Lead of the screw (travel per turn)", "mm", "m", "10 mm"),
    Question("moved_mass", "Moved mass, without other axes of this machine on it", "kg", "kg"),
    Question("unbalanced_mass", "Unbalanced mass of a vertical axis (empty: none)", "kg", "kg", required=False),
    Question("encoder_resolution", "Encoder resolution, with interpolation (travel per count)", "um", "m", "1 um"),
    Question("velocity", "Velocity limit", "m/min", "m/s", "12 m/min"),
    Question("acceleration", "Acceleration limit", "m/s^2", "m/s^2", "2 m/s^2"),
    Question("jerk", "Jerk limit", "m/s^3", "m/s^3", "50 m/s^3"),
    Question("kv", "Wanted Kv (bandwidth of the position loop)", "1/s", "1/s", "40 1/s"),
    Question("mounted_on", "Axis below it (empty: the bed)", required=False),
    Question("stage_mass", "Mass of the whole module, carried by the axis below (empty: the moved mass)", "kg", "kg", required=False),
)


def questions(axes: Sequence[str] = ()) -> list[Question]:
    """Return the questions about the machine, or about each of its axes if `axes` names them.

    >>> [question.key for question in questions()]
    ['name', 'axes', 'servo_period']
    >>> questions(["x"])[0].key
    'x.rated_torque'
    """
    if not axes:
        return list(_GENERAL)
    return [Question(f"{axis}.{q.key}", f"{axis}: {q.text}", q.unit, q.si, q.default, q.required) for axis in axes for q in _PER_AXIS]


def axis_names(answer: str) -> tuple[str, ...]:
    """Return the names of the axes from an answer such as ``"x, y"``.

    Raises
    ------
    ScenarioError
        If there is no name, a name is repeated, or a name is invalid.
    """
    names = tuple(answer.replace(",", " ").split())
    if not 1 <= len(names) <= MOST_AXES:
        raise _fault("axes", f"{len(names)} axes: give 1 to {MOST_AXES}, as in x, y, z")
    for name in names:
        if not NAME.match(name):
            raise _fault("axes", f"{name!r} is not a valid axis name: use letters, digits and _")
        # The axis files must differ also on file systems that ignore case.
        if [other.lower() for other in names].count(name.lower()) > 1:
            raise _fault("axes", f"axis {name!r} is given twice")
    return names


def _fault(key: str, message: str) -> ScenarioError:
    return ScenarioError(message, file="answers", key=key)


def read_answer(question: Question, answer: str) -> float | str | None:
    """Return an answer in SI, or as text; None for an optional question without an answer.

    Raises
    ------
    ScenarioError
        If the answer is missing, not a quantity, or not positive.
    """
    text = answer.strip() or question.default
    if not text:
        if question.required:
            raise _fault(question.key, f"no answer: give {question.text.lower()}{f' [{question.unit}]' if question.unit else ''}")
        return None
    if not question.unit:
        return text
    try:
        number = read_number(text if " " in text else f"{text} {question.unit}", question.si, question.unit)
    except UnitError as error:
        raise _fault(question.key, str(error)) from error
    if not number > 0.0:
        raise _fault(question.key, f"{text!r} is out of range: must be > 0 {question.unit}")
    return number


def _read(answers: Mapping[str, str]) -> tuple[str, float, list[SizedAxis]]:
    general = {q.key: read_answer(q, answers.get(q.key, "")) for q in _GENERAL}
    names = axis_names(str(general["axes"]))
    asked = questions(names)
    known = [q.key for q in (*_GENERAL, *asked)]
    for key in answers:
        if key not in known:
            raise _fault(key, "no such question")
    values: dict[str, dict[str, Any]] = {name: {} for name in names}
    for question in asked:
        name, _, key = question.key.partition(".")
        values[name][key] = read_answer(question, answers.get(question.key, ""))
    for name in names:
        below = values[name]["mounted_on"]
        if below is not None and (below not in names or below == name):
            raise _fault(f"{name}.mounted_on", f"{below!r} is not another axis of this machine: {', '.join(n for n in names if n != name)}")
        if values[name]["stage_mass"] is None:
            values[name]["stage_mass"] = values[name]["moved_mass"]
    period = float(general["servo_period"] or 0.0)
    axes = [SizedAxis(name, values[name], _carried(name, values), _defaults(values[name])) for name in names]
    for axis in axes:
        _check(axis, period)
    return str(general["name"]), period, axes


def _defaults(values: Mapping[str, Any]) -> frozenset[str]:
    """Return the keys of the questions answered by their default."""
    return frozenset(q.key for q in _PER_AXIS if q.default and read_answer(q, "") == values[q.key])


def _carried(name: str, values: Mapping[str, Mapping[str, Any]]) -> float:
    """Return the mass of all modules carried by an axis."""
    total = 0.0
    for other in values:
        below, steps = values[other]["mounted_on"], 0
        while below is not None and steps <= len(values):
            if below == name:
                total += values[other]["stage_mass"]
                break
            below, steps = values[below]["mounted_on"], steps + 1
        if steps > len(values):
            raise _fault(f"{other}.mounted_on", "the axes are mounted on each other in a circle")
    return total


def _check(axis: SizedAxis, period: float) -> None:
    """Raise if the motor cannot reach the limits, or the servo period or damping does not allow the Kv."""
    name, peak = axis.name, axis.force(axis.peak_torque)
    if axis.peak_torque < axis.rated_torque:
        raise _fault(f"{name}.peak_torque", f"is below the rated torque of {axis.rated_torque:g} N*m")
    if axis.wanted_force > peak:
        rest = (peak - axis.standing_force) / axis.mass
        able = f"at most {rest:.3g} m/s^2" if rest > 0.0 else "friction, damping and weight alone need all of it"
        raise _fault(
            f"{name}.acceleration",
            f"{axis.acceleration:g} m/s^2 needs {axis.wanted_force:.4g} N, but the peak force of the motor is {peak:.4g} N: {able}",
        )
    if axis.kv * period > sizing.FASTEST:
        most = f"at most {sizing.FASTEST / period:.4g} 1/s"
        raise _fault(f"{name}.kv", f"{axis.kv:g} 1/s is too fast for a servo period of {period * 1e3:g} ms: {most}")
    least = axis.model[1] / (1.0 + 2.0 * sizing.DAMPING)
    if axis.kv < least:
        raise _fault(f"{name}.kv", f"{axis.kv:g} 1/s is slower than the damping of the axis: at least {least:.3g} 1/s")


def build_machine(answers: Mapping[str, str]) -> dict[str, str]:
    """Return the files of a machine and a matching controller.

    Parameters
    ----------
    answers : mapping of str to str
        Answers by key of the question. A bare number has the unit of the question; a missing answer takes the default.

    Returns
    -------
    dict
        File name -> TOML text: ``machine.toml``, ``axis-NAME.toml`` for each axis, ``controller.toml``, and ``scenario.toml`` if there is
        a first contour for these axes.

    Raises
    ------
    ScenarioError
        If an answer is missing or impossible; has the key of its question.

    Notes
    -----
    Moved mass m + m_c + J (2 pi/l)^2; force 2 pi eta T/l. Friction and damping are guesses and marked as such. Poles at w_n = alpha = Kv
    with any damping give a velocity gain K_P a'/(a' K_V + b') equal to Kv, by eqs (21)-(23) of Ghaffari & Ulsoy.
    """
    name, period, axes = _read(answers)
    files = {"machine.toml": f"# {name}\n\n" + toml(machine_tables(name, period, axes))}
    for axis in axes:
        files[f"axis-{axis.name}.toml"] = f"# Axis {axis.name}; total moved mass {axis.mass:.4g} kg\n\n" + toml(axis_tables(axis))
    files["controller.toml"] = f"# Controller for {name}; the gains follow from the poles\n\n" + toml(controller_tables(axes))
    scenario = scenario_tables(name, axes)
    if scenario is not None:
        files["scenario.toml"] = "# Run it with: contourlab run scenario.toml\n\n" + toml(scenario)
    return files


def explain(answers: Mapping[str, str]) -> str:
    """Summarise the values computed from the answers.

    Raises
    ------
    ScenarioError
        See `build_machine`.
    """
    _, period, axes = _read(answers)
    lines = []
    for axis in axes:
        gain, decay = axis.model
        rotating = f"rotating parts {axis.reflected:.4g} kg ({axis.reflected / axis.mass:.0%})"
        rated, peak = axis.force(axis.rated_torque), axis.force(axis.peak_torque)
        carried = f", {axis.carried:.4g} kg carried" if axis.carried else ""
        lines += [
            f"axis {axis.name}: {axis.mass:.4g} kg in total: {axis.moved_mass:.4g} kg moved{carried}, {rotating}",
            f"  force {rated:.4g} N rated, {peak:.4g} N peak; {axis.wanted_force:.4g} N needed at its limits",
            f"  guessed friction {axis.friction:.4g} N and damping {axis.damping:.4g} N*s/m: measure them",
            f"  model {gain:.4g} m/s^2/A, {decay:.4g} 1/s; servo period {period * 1e3:g} ms; "
            f"poles at {axis.kv:.4g} rad/s, observer {sizing.OBSERVER_RATIO * axis.kv:.4g} rad/s",
        ]
        if axis.wanted_force > axis.force(axis.rated_torque):
            lines.append("  its limits need more than the rated torque: suitable for short moves only")
    return "\n".join(lines)


def write_machine(files: Mapping[str, str], folder: str | Path, *, force: bool = False, inputs: Sequence[str | Path] = ()) -> list[Path]:
    """Write files into a folder; create it if missing.

    Parameters
    ----------
    files : mapping of str to str
        From `build_machine`.
    folder : str or Path
    force : bool
        Whether to overwrite existing files.
    inputs : sequence of str or Path
        Files that were read; never overwritten.

    Raises
    ------
    ParameterError
        If a target is among `inputs`.
    OutputError
        If a file exists (raised before anything is written) or cannot be written.
    """
    targets = {Path(folder) / name: text for name, text in files.items()}
    refuse_existing(targets, folder, force)
    for target in targets:
        spared(target, inputs)
    for target, text in targets.items():
        write_text_atomic(target, text)
    return list(targets)
