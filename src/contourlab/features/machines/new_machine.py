"""The wizard behind ``contourlab new machine``: questions, and from their answers the files of a machine and a controller that fits it.

Nothing here asks or prints: `questions` says what to ask, `build_machine` turns answers into files, `explain` says in words what was worked
out, `write_machine` puts the files into a folder.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from contourlab.app.results import spared
from contourlab.errors import OutputError, ScenarioError, UnitError
from contourlab.features.machines import sizing
from contourlab.features.machines.sizing import SizedAxis, rounded
from contourlab.features.machines.sourced import designed, given, guessed
from contourlab.result import write_text_atomic
from contourlab.scenario.dump import quantity
from contourlab.scenario.quantities import read_number
from contourlab.scenario.toml_text import Noted, toml
from contourlab.units import from_si

_NAME = re.compile(r"[A-Za-z0-9_]{1,32}\Z")
_MOST_AXES = 9


@dataclass(frozen=True)
class Question:
    """One question.

    Attributes
    ----------
    key : str
        What its answer goes by: ``name``, ``x.lead``.
    text : str
        The question for people.
    unit : str
        Unit that a bare number is taken to have; empty for text.
    si : str
        The same in SI.
    default : str
        Answer where none is given; empty where one has to be given, or the question may stay open.
    required : bool
        Whether it has to be answered.
    """

    key: str
    text: str
    unit: str = ""
    si: str = ""
    default: str = ""
    required: bool = True


_GENERAL = (
    Question("name", "Name of the machine", default="My machine"),
    Question("axes", "Names of its axes, in the order of the coordinates", default="x, y"),
    Question("servo_period", "Servo period", "ms", "s", "1 ms"),
)
_PER_AXIS = (
    Question("rated_torque", "Rated torque of the motor", "N*m", "N*m"),
    Question("peak_torque", "Peak torque of the motor with its drive", "N*m", "N*m"),
    Question("torque_constant", "Torque constant of the motor", "N*m/A", "N*m/A"),
    Question("rotor_inertia", "Inertia of the rotor", "kg*cm^2", "kg*m^2"),
    Question("screw_inertia", "Inertia of coupling and screw", "kg*cm^2", "kg*m^2", "0.5 kg*cm^2"),
    Question("lead", "Lead of the screw (travel per turn)", "mm", "m", "10 mm"),
    Question("moved_mass", "Mass that the axis moves, without what other axes here put on it", "kg", "kg"),
    Question("unbalanced_mass", "Mass that hangs on a vertical axis without counterweight (empty: none)", "kg", "kg", required=False),
    Question("encoder_resolution", "Travel per count of the encoder, interpolation included", "um", "m", "1 um"),
    Question("velocity", "Velocity limit", "m/min", "m/s", "12 m/min"),
    Question("acceleration", "Acceleration limit", "m/s^2", "m/s^2", "2 m/s^2"),
    Question("jerk", "Jerk limit", "m/s^3", "m/s^3", "50 m/s^3"),
    Question("kv", "Wanted Kv (bandwidth of the position loop)", "1/s", "1/s", "40 1/s"),
    Question("mounted_on", "Axis that it is mounted on (empty: the bed)", required=False),
    Question("stage_mass", "Mass of its whole module, which that axis carries (empty: the moved mass)", "kg", "kg", required=False),
)


def questions(axes: Sequence[str] = ()) -> list[Question]:
    """Return what to ask: about the machine, or, with the names of its axes, about each of them.

    >>> [question.key for question in questions()]
    ['name', 'axes', 'servo_period']
    >>> questions(["x"])[0].key
    'x.rated_torque'
    """
    if not axes:
        return list(_GENERAL)
    return [Question(f"{axis}.{q.key}", f"{axis}: {q.text}", q.unit, q.si, q.default, q.required) for axis in axes for q in _PER_AXIS]


def axis_names(answer: str) -> tuple[str, ...]:
    """Return the names of the axes out of an answer such as ``"x, y"``.

    Raises
    ------
    ScenarioError
        If there is none, one stands twice, or one is no name.
    """
    names = tuple(answer.replace(",", " ").split())
    if not 1 <= len(names) <= _MOST_AXES:
        raise _fault("axes", f"{len(names)} axes: 1 to {_MOST_AXES} are wanted, as in x, y, z")
    for name in names:
        if not _NAME.match(name):
            raise _fault("axes", f"{name!r} is no name of an axis: letters, digits and _ are wanted")
        # Their files must differ where a file system does not tell x from X.
        if [other.lower() for other in names].count(name.lower()) > 1:
            raise _fault("axes", f"axis {name!r} stands there twice")
    return names


def _fault(key: str, message: str) -> ScenarioError:
    return ScenarioError(message, file="answers", key=key)


def read_answer(question: Question, answer: str) -> float | str | None:
    """Return an answer in SI, or as text; None where the question stays open.

    Raises
    ------
    ScenarioError
        If it is missing, no quantity, or not positive.
    """
    given = answer.strip() or question.default
    if not given:
        if question.required:
            raise _fault(question.key, f"no answer: {question.text.lower()}{f' [{question.unit}]' if question.unit else ''} is wanted")
        return None
    if not question.unit:
        return given
    try:
        number = read_number(given if " " in given else f"{given} {question.unit}", question.si, question.unit)
    except UnitError as error:
        raise _fault(question.key, str(error)) from error
    if not number > 0.0:
        raise _fault(question.key, f"{given!r} is out of range: must be > 0 {question.unit}")
    return number


def _read(answers: Mapping[str, str]) -> tuple[str, float, list[SizedAxis]]:
    general = {q.key: read_answer(q, answers.get(q.key, "")) for q in _GENERAL}
    names = axis_names(str(general["axes"]))
    asked = questions(names)
    known = [q.key for q in (*_GENERAL, *asked)]
    for key in answers:
        if key not in known:
            raise _fault(key, "answers no question")
    values: dict[str, dict[str, Any]] = {name: {} for name in names}
    for question in asked:
        name, _, key = question.key.partition(".")
        values[name][key] = read_answer(question, answers.get(question.key, ""))
    for name in names:
        below = values[name]["mounted_on"]
        if below is not None and (below not in names or below == name):
            raise _fault(f"{name}.mounted_on", f"{below!r} is no other axis of this machine: {', '.join(n for n in names if n != name)}")
        if values[name]["stage_mass"] is None:
            values[name]["stage_mass"] = values[name]["moved_mass"]
    period = float(general["servo_period"] or 0.0)
    axes = [SizedAxis(name, values[name], _carried(name, values)) for name in names]
    for axis in axes:
        _check(axis, period)
    return str(general["name"]), period, axes


def _carried(name: str, values: Mapping[str, Mapping[str, Any]]) -> float:
    """Return the mass of all modules that stand on an axis."""
    total = 0.0
    for other in values:
        below, steps = values[other]["mounted_on"], 0
        while below is not None and steps <= len(values):
            if below == name:
                total += values[other]["stage_mass"]
                break
            below, steps = values[below]["mounted_on"], steps + 1
        if steps > len(values):
            raise _fault(f"{other}.mounted_on", "the axes stand on each other in a circle")
    return total


def _check(axis: SizedAxis, period: float) -> None:
    """Refuse what the motor cannot do and what the servo period does not allow."""
    name, peak = axis.name, axis.force(axis.peak_torque)
    if axis.peak_torque < axis.rated_torque:
        raise _fault(f"{name}.peak_torque", f"is below the rated torque of {axis.rated_torque:g} N*m")
    if axis.wanted_force > peak:
        rest = (peak - axis.standing_force) / axis.mass
        able = f"it can do {rest:.3g} m/s^2" if rest > 0.0 else "friction, damping and weight alone take all of it"
        raise _fault(
            f"{name}.acceleration",
            f"{axis.acceleration:g} m/s^2 wants {axis.wanted_force:.4g} N, the motor gives {peak:.4g} N at its peak: {able}",
        )
    if axis.kv * period > sizing.FASTEST:
        most = f"at most {sizing.FASTEST / period:.4g} 1/s"
        raise _fault(f"{name}.kv", f"{axis.kv:g} 1/s is too fast for a servo period of {period * 1e3:g} ms: {most}")
    least = axis.model[1] / (1.0 + 2.0 * sizing.DAMPING)
    if axis.kv < least:
        raise _fault(f"{name}.kv", f"{axis.kv:g} 1/s is slower than the axis damps itself: at least {least:.3g} 1/s")


# --- files ---------------------------------------------------------------------------------------------------------------------------


def _given(axis: SizedAxis, key: str, value: Any, note: str = "") -> Noted:
    """Return the answer to a question with where it is from: a data sheet, or what the question proposes."""
    proposed = any(q.key == key and q.default and read_answer(q, "") == axis.answers[key] for q in _PER_AXIS)
    return guessed(value, note or "as proposed") if proposed else given(value, note)


def _axis_tables(axis: SizedAxis) -> dict[str, Any]:
    viscous = f"guess: {sizing.DAMPING_SHARE:.0%} of the {axis.force(axis.rated_torque):.4g} N at rated torque, at top speed"
    limit = quantity(rounded(axis.peak_torque / axis.torque_constant), "A")
    peak = f"peak torque over torque constant: {axis.force(axis.peak_torque):.4g} N at the table"
    sliding = f"guess: {sizing.FRICTION_SHARE:.0%} of the force at rated torque; measure it"
    tables: dict[str, Any] = {
        "plant": {
            "kind": "ball-screw",
            "mass": _given(axis, "moved_mass", quantity(axis.moved_mass, "kg")),
            "inertia": _given(axis, "rotor_inertia", f"{from_si(axis.inertia, 'kg*cm^2'):.10g} kg*cm^2", "rotor, coupling and screw"),
            "lead": _given(axis, "lead", quantity(axis.lead, "m", "mm")),
            "torque_constant": _given(axis, "torque_constant", quantity(axis.torque_constant, "N*m/A")),
            "efficiency": guessed(sizing.EFFICIENCY, "typical of a ball screw"),
            "damping": guessed(quantity(axis.damping, "N*s/m"), viscous),
        },
        "friction": {
            "kind": "coulomb",
            "coulomb": guessed(quantity(axis.friction, "N"), sliding),
            "breakaway": guessed(quantity(rounded(sizing.BREAKAWAY_RATIO * axis.friction), "N"), "guess: a quarter above sliding"),
            "stribeck_velocity": guessed("2 mm/s", "typical of rail guides"),
        },
        "drive": {"kind": "saturation", "limit": _given(axis, "peak_torque", limit, peak)},
        "sensor": {"kind": "encoder", "resolution": _given(axis, "encoder_resolution", quantity(axis.encoder_resolution, "m", "um"))},
        "limits": {
            "velocity": _given(axis, "velocity", quantity(axis.velocity, "m/s", "m/min")),
            "acceleration": _given(axis, "acceleration", quantity(axis.acceleration, "m/s^2")),
            "jerk": _given(axis, "jerk", quantity(axis.jerk, "m/s^3")),
        },
    }
    if axis.weight:
        note = "weight of what hangs on the axis; its positive direction is up"
        tables["disturbance"] = {"kind": "constant", "force": _given(axis, "unbalanced_mass", quantity(-axis.weight, "N"), note)}
    return tables


def _machine_tables(name: str, period: float, axes: Sequence[SizedAxis]) -> dict[str, Any]:
    def placed(axis: SizedAxis) -> dict[str, Any]:
        found: dict[str, Any] = {"file": f"axis-{axis.name}.toml"}
        if axis.mounted_on:
            found |= {"mounted_on": axis.mounted_on, "alignment": 0.0, "stage_mass": quantity(axis.stage_mass, "kg")}
        return found

    head = {"name": name, "servo_period": quantity(period, "s", "ms"), "axes": [axis.name for axis in axes]}
    return {"machine": head, "axes": {axis.name: placed(axis) for axis in axes}}


def _controller_tables(axes: Sequence[SizedAxis]) -> dict[str, Any]:
    def each(axis: SizedAxis) -> dict[str, Any]:
        kv, observer = axis.kv, sizing.OBSERVER_RATIO * axis.kv
        pole = f"{rounded(kv):g} rad/s"
        gain, decay = axis.model
        gains = {"natural_frequency": Noted(pole, "Kv"), "damping": sizing.DAMPING, "pole": Noted(pole, "Kv")}
        return {
            "velocity": {"kind": "filtered-difference", "bandwidth": f"{rounded(sizing.VELOCITY_RATIO * kv):g} rad/s"},
            "observer": {
                "kind": "disturbance-observer",
                "bandwidth": f"{rounded(observer):g} rad/s",
                "filter_bandwidth": f"{rounded(sizing.FILTER_RATIO * observer):g} rad/s",
                "model_gain": designed(f"{gain:g} m/s^2/A", f"force per ampere over {axis.mass:.4g} kg"),
                "model_damping": designed(f"{decay:g} 1/s", f"damping over {axis.mass:.4g} kg"),
            },
            "controller": {"kind": "position", "gains": gains},
        }

    found: dict[str, Any] = {"axes": {axis.name: each(axis) for axis in axes}}
    if len(axes) > 1:
        coupling = {"kind": "modified-reference", "weight": 0.5}
        found = {"estimator": {"kind": "newton"}, "coupling": coupling, **found}
    return {"controller": found}


def _scenario_tables(name: str, axes: Sequence[SizedAxis]) -> dict[str, Any] | None:
    """Return a first scenario: the shipped test part on x, y, z, a circle on two axes."""
    names = [axis.name for axis in axes]
    parts: dict[str, Any] = {"name": f"{name}: first run", "machine": "machine.toml", "controller": "controller.toml"}
    run = {"run": {"tolerance": "50 um"}}
    if [n.lower() for n in names] == ["x", "y", "z"]:
        return {**parts, "program": "builtin:programs/circle_diamond_square.ngc", **run}
    if len(names) != 2:
        return None
    feed = 0.25 * min(axis.velocity for axis in axes)
    return {
        **parts,
        "contour": {"name": "circle", "radius": "20 mm"},
        "feed": {"law": "planned", "feedrate": quantity(rounded(feed * 60.0) / 60.0, "m/s", "m/min"), "laps": 2},
        **run,
    }


def build_machine(answers: Mapping[str, str]) -> dict[str, str]:
    """Return the files of a machine and of a controller that fits it.

    Parameters
    ----------
    answers : mapping of str to str
        Question's key -> answer; a number without a unit has the question's. Questions left out take their defaults.

    Returns
    -------
    dict
        File name -> TOML text: ``machine.toml``, one ``axis-NAME.toml`` for each axis, ``controller.toml``, and ``scenario.toml`` where
        there is something to drive along at once.

    Raises
    ------
    ScenarioError
        With the key of the question whose answer is missing or cannot be.

    Notes
    -----
    Moved mass m + m_c + J (2 pi/l)^2; force 2 pi eta T/l. Friction and damping are guesses, marked as such. The poles are placed at
    w_n = alpha = Kv with any damping: eqs (21)-(23) of Ghaffari & Ulsoy then give a velocity gain K_P a'/(a' K_V + b') of just Kv.
    """
    name, period, axes = _read(answers)
    found = {"machine.toml": f"# {name}\n\n" + toml(_machine_tables(name, period, axes))}
    for axis in axes:
        found[f"axis-{axis.name}.toml"] = f"# Axis {axis.name}; all that is moved counts {axis.mass:.4g} kg\n\n" + toml(_axis_tables(axis))
    found["controller.toml"] = f"# Controller for {name}; the gains follow from the poles\n\n" + toml(_controller_tables(axes))
    scenario = _scenario_tables(name, axes)
    if scenario is not None:
        found["scenario.toml"] = "# Run it with: contourlab run scenario.toml\n\n" + toml(scenario)
    return found


def explain(answers: Mapping[str, str]) -> str:
    """Return in words what was worked out from the answers.

    Raises
    ------
    ScenarioError
        As `build_machine`.
    """
    _, period, axes = _read(answers)
    lines = []
    for axis in axes:
        gain, decay = axis.model
        rotating = f"rotating parts {axis.reflected:.4g} kg ({axis.reflected / axis.mass:.0%})"
        rated, peak = axis.force(axis.rated_torque), axis.force(axis.peak_torque)
        carried = f", {axis.carried:.4g} kg carried" if axis.carried else ""
        lines += [
            f"axis {axis.name}: moves {axis.mass:.4g} kg: {axis.moved_mass:.4g} kg itself{carried}, {rotating}",
            f"  force {rated:.4g} N rated, {peak:.4g} N peak; {axis.wanted_force:.4g} N wanted at its limits",
            f"  guessed friction {axis.friction:.4g} N and damping {axis.damping:.4g} N*s/m: measure them",
            f"  model {gain:.4g} m/s^2/A, {decay:.4g} 1/s; servo period {period * 1e3:g} ms; "
            f"poles at {axis.kv:.4g} rad/s, observer {sizing.OBSERVER_RATIO * axis.kv:.4g} rad/s",
        ]
        if axis.wanted_force > axis.force(axis.rated_torque):
            lines.append("  its limits want more than the rated torque: fine for short moves, not for long ones")
    return "\n".join(lines)


def write_machine(files: Mapping[str, str], folder: str | Path, *, force: bool = False, inputs: Sequence[str | Path] = ()) -> list[Path]:
    """Write files into a folder, made if it is not there.

    Parameters
    ----------
    files : mapping of str to str
        From `build_machine`.
    folder : str or Path
    force : bool
        Whether files that are there already may be overwritten.
    inputs : sequence of str or Path
        Files that were read, which are never overwritten.

    Raises
    ------
    ParameterError
        If one is among `inputs`.
    OutputError
        If one is there already, before anything is written; or if one cannot be written.
    """
    targets = {Path(folder) / name: text for name, text in files.items()}
    there = [target.name for target in targets if target.exists()]
    if there and not force:
        listed = f"{', '.join(there)} {'is' if len(there) == 1 else 'are'}"
        raise OutputError(f"{folder}: {listed} there already: choose another folder, or use --force")
    for target in targets:
        spared(target, inputs)
    for target, text in targets.items():
        write_text_atomic(target, text)
    return list(targets)
