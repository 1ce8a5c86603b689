"""Tables of the files that ``contourlab new machine`` writes: each value with its origin, each guess with its range."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from contourlab.components.origin import Origin
from contourlab.features.machines.questions import AXIS
from contourlab.features.machines.sizing import DAMPING, SizedAxis, rounded
from contourlab.scenario.provenance import origin_table
from contourlab.scenario.toml_text import Noted
from contourlab.units import from_si, show

_QUESTIONS = {question.key: question for question in AXIS}


def _written(value: float, unit: str) -> str | float:
    """Write an SI value in a unit; a bare number without one."""
    number = f"{from_si(value, unit):.12g}"
    return f"{number} {unit}" if unit else float(number)


def _number(axis: SizedAxis, key: str, unit: str, of: Callable[[SizedAxis], float] | None = None, note: str = "") -> Noted:
    """Return a number in a unit that follows from the answer `key`: as given, or guessed within a range."""
    value = of or (lambda sized: float(sized.values[key]))
    question = _QUESTIONS[key]
    if key not in axis.guesses:
        return _noted(value(axis), unit, Origin("datasheet", reference="as given", note=note))
    span = axis.span(key, value, question.spread) if question.spread else None
    why = f"guess: {question.rule or question.guess()}" + (f"; {note}" if note else "")
    return _noted(rounded(value(axis)), unit, Origin("assumed", span=span, note=why))


def _noted(value: float, unit: str, origin: Origin) -> Noted:
    return Noted(origin_table(_written(value, unit), origin, lambda end: _written(rounded(end), unit)))


def _plant(axis: SizedAxis) -> dict[str, Any]:
    mass = {"mass": _number(axis, "moved_mass", "kg")}
    damping = {"damping": _number(axis, "damping", "N*s/m")}
    elastic = {"resonance": _number(axis, "resonance", "Hz", lambda sized: sized.own_resonance)} if axis.resonance else {}
    if axis.linear:
        kind = "two-mass" if elastic else "mass-damper"
        return {"kind": kind, **mass, "force_constant": _number(axis, "force_constant", "N/A"), **damping, **elastic}
    return {
        "kind": "elastic-ball-screw" if elastic else "ball-screw",
        **mass,
        "inertia": _number(axis, "screw_inertia", "kg*cm^2", lambda sized: sized.inertia, "rotor, coupling and screw"),
        "lead": _number(axis, "lead", "mm"),
        "torque_constant": _number(axis, "torque_constant", "N*m/A"),
        "efficiency": _number(axis, "efficiency", ""),
        **damping,
        **elastic,
    }


def _friction(axis: SizedAxis) -> dict[str, Any]:
    rest = Origin("assumed", span=(axis.friction, 1.5 * axis.friction), note="guess: a quarter above sliding")
    return {
        "kind": "coulomb",
        "coulomb": _number(axis, "friction", "N", note="measure it"),
        "breakaway": _noted(rounded(1.25 * axis.friction), "N", rest),
        "stribeck_velocity": _noted(2e-3, "mm/s", Origin("assumed", span=(1e-3, 3e-3), note="guess: typical of rail guides")),
    }


def axis_tables(axis: SizedAxis) -> dict[str, Any]:
    """Return the axis file."""
    peak = "peak_force" if axis.linear else "peak_torque"
    sensor = "motor_sensor" if axis.resonance else "sensor"
    tables: dict[str, Any] = {
        **({"substeps": axis.substeps} if axis.resonance else {}),
        "plant": _plant(axis),
        **({"friction": _friction(axis)} if axis.friction else {}),
        "drive": {"kind": "saturation", "limit": _number(axis, peak, "A", lambda sized: rounded(sized.current), f"{axis.peak:.4g} N")},
        sensor: {"kind": "encoder", "resolution": _number(axis, "encoder_resolution", "um")},
        "limits": {
            "velocity": _number(axis, "velocity", "m/min"),
            "acceleration": _number(axis, "acceleration", "m/s^2"),
            "jerk": _number(axis, "jerk", "m/s^3"),
            **({"travel": _number(axis, "travel", "mm")} if axis.travel else {}),
        },
    }
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
