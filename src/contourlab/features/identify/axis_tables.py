"""Tables of an axis file: plant, friction, drive, sensor, and limits from the motion in the logs.

A plan may use the largest velocity and the largest acceleration at once. The drive must then overcome mass, damping, friction and constant
force and keep a reserve for the controller. Otherwise the axis cannot follow its own plans.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array
from contourlab.components.origin import Origin
from contourlab.features.identify.records import AxisRecord, reference_name
from contourlab.features.identify.result import Row, Tables, assumed
from contourlab.features.measure.plausibility import fastest

OriginOf = Callable[..., Origin]
"""Returns the origin of a parameter from its name, such as "plant.mass", and a note."""
ROOM = 0.2
"""Share by which limits exceed the largest value in the log. Without it, no plan would reach the motion of the log."""
RESERVE = 0.1
"""Share of the drive's limit that plans leave to the controller."""
MOST_ROOM = 0.5
"""Largest share by which an assumed drive limit exceeds the largest command in the logs."""
PLANNED, REACTED = 0.005, 0.05
"""Intervals [s] for accelerations: of a reference, and of a position alone, whose fast part is the controller's reaction."""
TWO_INERTIAS = {
    "motor_inertia": ("motor_mass", "kg*m^2"),
    "load_inertia": ("load_mass", "kg*m^2"),
    "stiffness": ("stiffness", "N*m/rad"),
    "shaft_damping": ("shaft_damping", "N*m*s/rad"),
    "motor_damping": ("damping", "N*m*s/rad"),
}
"""Parameters of a two-inertia plant: name in the fit, and unit."""


@dataclass(frozen=True)
class Forces:
    """How an axis file counts forces.

    Attributes
    ----------
    unit : str
        ``"N"`` or ``"full_scale"``.
    one : float [unit of the command]
        Size of one unit.
    largest : float [unit of the command]
        Largest command in the logs.
    constant : float [N/A]
        Force per command as given; one unit of the logged command counts as one ampere.
    note : str
        Assumption about full scale; may be empty.
    """

    unit: str
    one: float
    largest: float
    constant: float = 1.0
    note: str = ""


def forces_of(records: Sequence[AxisRecord]) -> Forces:
    """Return how to count forces: in newtons, or in shares of full scale; by default full scale is the largest command.

    Raises
    ------
    ResultError
        If a log has no command.
    """
    unit, largest = records[0].unit, max(record.largest() for record in records)
    if unit == "N":
        return Forces("N", 1.0, largest, abs(records[0].gain))
    if unit in ("", "full_scale"):
        return Forces("full_scale", 1.0, largest)
    where = "log" if len(records) == 1 else "logs"
    note = f"full scale is assumed to be the largest command in the {where}, {largest:.4g} {unit}"
    return Forces("full_scale", largest, largest, note=note)


def plant_numbers(forces: Forces, a: float, b: float) -> dict[str, float]:
    """Return the parameters of the plant v' = -b v + a u by their names in an axis file, in SI.

    Parameters
    ----------
    a : float [m/s^2 per command], > 0
    b : float [1/s]
    """
    if forces.unit == "N":
        return {"plant.mass": 1.0 / a, "plant.damping": b / a}
    return {"plant.gain": forces.one * a, "plant.damping": b}


def rigid_tables(
    records: Sequence[AxisRecord],
    a: float,
    b: float,
    origin: OriginOf,
    *,
    held: float = 0.0,
    delay: float = 0.0,
    friction: Tables | None = None,
    peak: float | None = None,
) -> Tables:
    """Return the axis file of the plant v' = -b v + a u.

    Parameters
    ----------
    a : float [m/s^2 per command], > 0
    b : float [1/s]
    held : float [command]
        Friction and constant force.
    delay : float [s]
        Delay of the drive.
    friction : Tables, optional
        Tables of friction and disturbance.
    peak : float [m/s^2], optional
        Largest acceleration; by default from reference and position.
    """
    forces = forces_of(records)
    limits, top, of_drive = _motion_limits(records, forces, (a, b, held), peak)
    x, per_unit, unit = plant_numbers(forces, a, b), forces.one, "full_scale"
    if forces.unit == "N":
        per_unit, unit = forces.constant, "A"
        plant: dict[str, Row] = {
            "kind": ("mass-damper", "", None),
            "mass": (x["plant.mass"], "kg", origin("plant.mass")),
            "damping": (x["plant.damping"], "N*s/m", origin("plant.damping")),
            "force_constant": (forces.constant, "N/A", assumed("as given; one unit of the command counts as one ampere")),
        }
    else:
        plant = {
            "kind": ("rigid-axis", "", None),
            "gain": (x["plant.gain"], "m/s^2/full_scale", origin("plant.gain", forces.note)),
            "damping": (x["plant.damping"], "1/s", origin("plant.damping")),
        }
    drive = _drive_table((top / per_unit, unit, of_drive), delay, origin)
    return {"plant": plant, **(friction or {}), "drive": drive, "limits": limits, **_sensor_table(records)}


def friction_tables(coulomb: float, force: float, unit: str, origin: OriginOf) -> Tables:
    """Return the tables of Coulomb friction and of a constant force."""
    return {
        "friction": {"kind": ("coulomb", "", None), "coulomb": (coulomb, unit, origin("friction.coulomb"))},
        "disturbance": {"kind": ("constant", "", None), "force": (force, unit, origin("disturbance.force"))},
    }


def two_inertia_numbers(lead: float, x: Mapping[str, float]) -> dict[str, float]:
    """Return the parameters of two inertias by their names in an axis file, in SI, from masses along the axis."""
    arm = lead / (2.0 * math.pi)
    return {f"plant.{name}": arm**2 * x[key] for name, (key, _) in TWO_INERTIAS.items()} | {"drive.delay": x["delay"]}


def two_inertia_tables(
    records: Sequence[AxisRecord], lead: float, x: Mapping[str, float], given: Mapping[str, float], origin: OriginOf, peak: float
) -> Tables:
    """Return the axis file of two inertias.

    Parameters
    ----------
    lead : float [m]
        Travel per turn.
    x, given : mapping of str to float
        All parameters, and those that are given instead of fitted.
    peak : float [m/s^2]
        Largest acceleration.
    """
    whole = x["motor_mass"] + x["load_mass"]
    limits, top, of_drive = _motion_limits(records, forces_of(records), (1.0 / whole, x["damping"] / whole, 0.0), peak)
    values = two_inertia_numbers(lead, x)
    plant: dict[str, Row] = {"kind": ("two-inertia", "", None), "lead": (lead, "m", assumed("as given"))}
    for name, (key, unit) in TWO_INERTIAS.items():
        plant[name] = (values[f"plant.{name}"], unit, assumed("as given") if key in given else origin(f"plant.{name}"))
    plant["torque_gain"] = (1.0, "", assumed("the command counts as a torque: force times lead over 2 pi"))
    drive = _drive_table((top * (lead / (2.0 * math.pi)), "N*m", of_drive), x["delay"], origin)
    return {"plant": plant, "drive": drive, "limits": limits, **_sensor_table(records)}


def _drive_table(limit: Row, delay: float, origin: OriginOf) -> dict[str, Row]:
    if delay <= 0.0:
        return {"kind": ("saturation", "", None), "limit": limit}
    return {"kind": ("delayed-saturation", "", None), "limit": limit, "delay": (delay, "s", origin("drive.delay"))}


def _sensor_table(records: Sequence[AxisRecord]) -> Tables:
    """Return the encoder, with the smallest step in the records as its resolution."""
    steps = np.concatenate([np.abs(np.diff(record.position)) for record in records])
    seen = steps[steps > 1e-12]
    if not seen.size:
        return {}
    origin = Origin("measured", reference=reference_name(records), note="the smallest step in the log")
    return {"sensor": {"kind": ("encoder", "", None), "resolution": (float(seen.min()), "m", origin)}}


def _motion_limits(
    records: Sequence[AxisRecord], forces: Forces, plant: tuple[float, float, float], peak: float | None
) -> tuple[dict[str, Row], float, Origin]:
    """Return the table of velocity, acceleration and jerk of an axis file; the limit of the drive [command] and its origin.

    Parameters
    ----------
    plant : (float, float, float)
        a [m/s^2 per command], > 0; b [1/s]; friction and constant force [command].
    peak : float [m/s^2], optional
        Largest acceleration; by default from reference and position.

    Notes
    -----
    The limits of velocity, acceleration and command are 20 % above the largest values in the logs. Velocity and acceleration at once must
    leave a tenth of the drive's limit to the controller. If they do not, the drive's limit rises to at most half above the largest command
    in the logs; full scale does not rise. If that is not enough, each is first limited to what the drive gives for it alone, then both are
    lowered by the same share.
    """
    a, b, held = plant

    def drive(velocity: float, acceleration: float) -> float:
        """Return the drive limit [command].

        Full scale, or for forces the command for both at once with `RESERVE`, between `ROOM` and `MOST_ROOM` above the largest command.
        """
        if forces.unit != "N":
            return forces.one
        taken = (held + (acceleration + b * velocity) / a) / (1.0 - RESERVE)
        return min(max(taken, (1.0 + ROOM) * forces.largest), (1.0 + MOST_ROOM) * forces.largest)

    def given(velocity: float, acceleration: float) -> float:
        """Return the share of velocity and acceleration that the drive can give at once, at most 1."""
        limit = drive(velocity, acceleration)
        left = max((1.0 - RESERVE) * limit - held, RESERVE * limit)
        taken = (acceleration + b * velocity) / a
        return min(1.0, left / taken) if taken > 0.0 else 1.0

    source = reference_name(records)
    largest, of_signal = (peak, "") if peak is not None else max(map(_largest_acceleration, records), key=lambda pair: pair[0])
    top = max(fastest(record.position[:, None], record.period) for record in records)
    velocity, gain = (1.0 + ROOM) * top, (1.0 + ROOM) * largest
    velocity, gain = velocity * given(velocity, 0.0), gain * given(0.0, gain)
    share, command = given(velocity, gain), drive(velocity, gain)

    def origin(value: float, largest: float, note: str, why: str) -> Origin:
        """Tell how a limit compares with the largest value in the log, and why if the share is not the usual one."""
        above = value / largest - 1.0 if largest else ROOM
        apart = f"{100.0 * abs(above):.0f} % {'above' if above >= 0.0 else 'below'} the largest value{note} in the log"
        reason = "" if math.isclose(above, ROOM) else f", since {why}"
        return Origin("assumed", reference=source, note=f"{apart}{reason}: replace it by the axis' own limit")

    less = "the drive cannot give more velocity and acceleration at once"
    velocity, gain = share * velocity, share * gain
    table = _limits_table(velocity, gain, origin(velocity, top, "", less), origin(gain, largest, of_signal, less))
    more = "velocity and acceleration at their limits need it"
    return table, command, origin(command, forces.largest, "", more) if forces.unit == "N" else assumed("full scale")


def position_limits(record: AxisRecord) -> dict[str, Row]:
    """Return the limits of velocity, acceleration and jerk of an axis whose log has positions alone."""
    acceleration, of_signal = _largest_acceleration(record)
    velocity, share = fastest(record.position[:, None], record.period), 1.0 + ROOM
    note = f"{100.0 * ROOM:.0f} % above the largest value{{}} in the log: replace it by the axis' own limit"
    return _limits_table(share * velocity, share * acceleration, assumed(note.format("")), assumed(note.format(of_signal)))


def _limits_table(velocity: float, acceleration: float, of_velocity: Origin, of_acceleration: Origin) -> dict[str, Row]:
    of_jerk, jerk = assumed("the acceleration in 10 ms"), 100.0 * acceleration
    return {
        "velocity": (velocity, "m/s", of_velocity),
        "acceleration": (acceleration, "m/s^2", of_acceleration),
        "jerk": (jerk, "m/s^3", of_jerk),
    }


def _largest_acceleration(record: AxisRecord) -> tuple[float, str]:
    """Return the largest acceleration [m/s^2] of the planned motion in a log, the smaller one of reference and position; and a note on it.

    The position contains the controller's reaction to friction, and the reference contains corners that the axis did not follow. Without
    a reference the position counts.
    """
    if record.reference is None or not np.ptp(record.reference) > 0.0:
        return _acceleration(record.position, record.period, REACTED), f" over {1e3 * REACTED:.0f} ms"
    asked, driven = (_acceleration(values, record.period, PLANNED) for values in (record.reference, record.position))
    return (asked, " of the reference") if asked <= driven else (driven, "")


def _acceleration(position: Array, period: float, over: float) -> float:
    """Return the largest second difference over a time [m/s^2]."""
    n = max(1, min(round(over / period), (position.size - 1) // 2))
    return float(np.abs(position[2 * n :] - 2.0 * position[n:-n] + position[: -2 * n]).max(initial=0.0)) / (n * period) ** 2
