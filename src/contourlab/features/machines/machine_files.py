"""Tables of the files that ``contourlab new machine`` writes: each value with its origin."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from contourlab.components.origin import Origin
from contourlab.features.machines import sizing
from contourlab.features.machines.sizing import SizedAxis, rounded
from contourlab.scenario.dump import quantity
from contourlab.scenario.provenance import origin_table
from contourlab.scenario.toml_text import Noted
from contourlab.units import from_si


def _guessed(value: Any, note: str) -> Noted:
    return Noted(origin_table(value, Origin("assumed", note=note), str))


def _designed(value: Any, note: str) -> Noted:
    """Return a value computed for a controller."""
    return Noted(origin_table(value, Origin("design", note=note), str))


def _given(axis: SizedAxis, key: str, value: Any, note: str = "") -> Noted:
    """Return an answer: from a data sheet, or assumed if it is the default of its question."""
    if key in axis.defaults:
        return _guessed(value, note or "default of the question")
    return Noted(origin_table(value, Origin("datasheet", reference="as given", note=note), str))


def axis_tables(axis: SizedAxis) -> dict[str, Any]:
    """Return the axis file."""
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
            "efficiency": _guessed(sizing.EFFICIENCY, "typical of a ball screw"),
            "damping": _guessed(quantity(axis.damping, "N*s/m"), viscous),
        },
        "friction": {
            "kind": "coulomb",
            "coulomb": _guessed(quantity(axis.friction, "N"), sliding),
            "breakaway": _guessed(quantity(rounded(sizing.BREAKAWAY_RATIO * axis.friction), "N"), "guess: a quarter above sliding"),
            "stribeck_velocity": _guessed("2 mm/s", "typical of rail guides"),
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
        note = "weight of the unbalanced mass; the positive direction is up"
        tables["disturbance"] = {"kind": "constant", "force": _given(axis, "unbalanced_mass", quantity(-axis.weight, "N"), note)}
    return tables


def machine_tables(name: str, period: float, axes: Sequence[SizedAxis]) -> dict[str, Any]:
    """Return the machine file."""

    def placed(axis: SizedAxis) -> dict[str, Any]:
        table: dict[str, Any] = {"file": f"axis-{axis.name}.toml"}
        if axis.mounted_on:
            table |= {"mounted_on": axis.mounted_on, "alignment": 0.0, "stage_mass": quantity(axis.stage_mass, "kg")}
        return table

    head = {"name": name, "servo_period": quantity(period, "s", "ms"), "axes": [axis.name for axis in axes]}
    return {"machine": head, "axes": {axis.name: placed(axis) for axis in axes}}


def controller_tables(axes: Sequence[SizedAxis]) -> dict[str, Any]:
    """Return the controller file."""

    def of_axis(axis: SizedAxis) -> dict[str, Any]:
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
                "model_gain": _designed(f"{gain:g} m/s^2/A", f"force per ampere over {axis.mass:.4g} kg"),
                "model_damping": _designed(f"{decay:g} 1/s", f"damping over {axis.mass:.4g} kg"),
            },
            "controller": {"kind": "position", "gains": gains},
        }

    tables: dict[str, Any] = {"axes": {axis.name: of_axis(axis) for axis in axes}}
    if len(axes) > 1:
        coupling = {"kind": "modified-reference", "weight": 0.5}
        tables = {"estimator": {"kind": "newton"}, "coupling": coupling, **tables}
    return {"controller": tables}


def scenario_tables(name: str, axes: Sequence[SizedAxis]) -> dict[str, Any] | None:
    """Return a first scenario: the shipped test part for x, y and z, a circle for two axes; None for other machines."""
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
