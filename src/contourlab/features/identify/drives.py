"""Models of a drive out of its frequency response: a mass with damping and delay, or two inertias with a shaft."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.identification.drive_fit import (
    DriveFit,
    damping_ratio,
    fit_linear_motor,
    fit_load_share,
    fit_two_inertia,
    held_response,
    linear_motor,
    load_side,
    resonances,
    two_inertia,
)
from contourlab.analysis.identification.filtered_motion import filtered_motion
from contourlab.analysis.identification.frequency_response import MeasuredResponse
from contourlab.analysis.identification.identification_remarks import on_mass
from contourlab.components.origin import Origin
from contourlab.errors import ParameterError
from contourlab.features.identify.finding import Carried, Drawn, Figure, Finding, Graph, Picture, Tables, carried, told
from contourlab.features.identify.frequency import FEW, bode_graphs, measured_response, response_points
from contourlab.features.identify.limits import Effort, MotionLimits, Peak, motion_limits
from contourlab.features.identify.plant_tables import Forces, drive_table, forces_of, plant_numbers, plant_table
from contourlab.features.identify.signals import TRAVEL, AxisRecord, in_newtons, sensor_table, source_of
from contourlab.features.identify.two_inertias import TwoInertias

CURVE = 400
"""Points of a model's curve."""
BEYOND, BELOW_NYQUIST = 2.0, 0.4
"""Cut-off ahead of accelerations: of the highest frequency that was fitted, and at most of the sampling frequency."""
SMOOTHED, SLOW, RARELY = 0.005, 0.1, 0.05
"""Time [s] over which speed is told, share of the largest from which it counts as motion, share of the samples that turning round is."""


def identify_linear_motor(records: Sequence[AxisRecord]) -> Finding:
    """Fit mass, damping and delay of a drive to its frequency response.

    Parameters
    ----------
    records : sequence of AxisRecord
        As of `contourlab.features.identify.frequency.measured_response`.

    Raises
    ------
    ResultError, ParameterError
        If the response cannot be measured, or the model not fitted to it.
    """
    found = measured_response(records)
    fit = fit_linear_motor(found)
    forces = forces_of(records)
    worth = _motor_worth(forces, fit)
    tables: Tables = {}
    if fit.usable:
        limits = _limits(records, fit, fit["B"])
        tables = {**_motor_tables(records, forces, fit, worth.deviations, limits), **sensor_table(records)}
    return _finding("linear-motor", records, found, fit, tables, (), worth=worth)


def identify_two_inertia(
    records: Sequence[AxisRecord], side: str = "motor", lead: float | None = None, motor_inertia: float | None = None
) -> Finding:
    """Fit two inertias, their shaft, damping and delay of a drive to its frequency response.

    Parameters
    ----------
    records : sequence of AxisRecord
    side : str
        Where the position is measured, ``"motor"`` or ``"load"``.
    lead : float [m], optional
        Travel per turn; wanted for an axis file, whose inertias turn.
    motor_inertia : float [kg m^2], optional
        Of motor and screw, from a data sheet: what the response at the load does not tell, and an axis file wants. It counts
        where there is a lead and commands are forces.

    Raises
    ------
    ResultError, ParameterError
        If the response cannot be measured, or the model not fitted to it; if the motor's inertia is given beside one that is measured, or
        is more than the whole.
    """
    if motor_inertia is not None and side == "motor":
        raise ParameterError("motor_inertia", f"{motor_inertia:g} kg*m^2", "left out: at the motor it is measured")
    found = measured_response(records)
    fit = fit_two_inertia(found, side)
    if motor_inertia is not None and lead is not None and records[0].unit == "N" and fit.usable:
        fit = _shared(found, fit, motor_inertia, lead)
    lines, tables, remarks = _lines(fit), {}, []
    worth = Carried({}, ())
    wanted = [] if lead is not None else [TRAVEL]
    wanted += ["--motor-inertia, of motor and screw"] if side == "load" and motor_inertia is None else []
    wanted += [] if records[0].unit == "N" else [in_newtons(records[0].logged)]
    if fit.usable and wanted:
        remarks.append(f"an axis file of two inertias takes {' and '.join(dict.fromkeys(wanted))}")
    elif fit.usable and lead is not None:
        drive, forces = TwoInertias(lead, frozenset(fit.given)), forces_of(records)
        worth = _worth(fit, lambda x: drive.numbers({**fit.given, **x}))
        origins = {name: told(source_of(records), deviation, drive.note) for name, deviation in worth.deviations.items()}
        limits = _limits(records, fit, fit["damping"])
        tables = {**drive.tables(fit.parameters, origins, forces, limits), **sensor_table(records)}
    return _finding("two-inertia", records, found, fit, tables, lines, tuple(remarks), worth)


def _shared(found: MeasuredResponse, whole: DriveFit, motor_inertia: float, lead: float) -> DriveFit:
    """Return the fit at the load with the motor's inertia given."""
    arm = lead / (2.0 * math.pi)
    if motor_inertia >= whole["mass"] * arm**2:
        bound = f"below the whole inertia that the response tells, {whole['mass'] * arm**2:.4g}"
        raise ParameterError("motor_inertia", f"{motor_inertia:.4g}", bound, "kg*m^2")
    return fit_load_share(found, whole, motor_inertia / arm**2)


def _lines(fit: DriveFit) -> tuple[str, ...]:
    """Return the resonance that two masses make; where it was looked for itself, it is among the figures."""
    if "resonance" in fit.parameters:
        return ()
    resonance, antiresonance = resonances(fit.parameters)
    given = "".join(f", {name} {value:.4g} as given" for name, value in fit.given.items())
    ratio = damping_ratio(fit.parameters)
    return (f"resonance {resonance:.4g} Hz with a damping ratio of {ratio:.3g}, antiresonance {antiresonance:.4g} Hz{given}",)


def _finding(
    model: str,
    records: Sequence[AxisRecord],
    found: MeasuredResponse,
    fit: DriveFit,
    tables: Tables,
    lines: tuple[str, ...],
    remarks: tuple[str, ...] = (),
    worth: Carried | None = None,
) -> Finding:
    unit = records[0].unit
    force = unit or "command"
    mass, loss = ("kg", "N*s/m") if unit == "N" else (f"{force}*s^2/m", f"{force}*s/m")
    units = dict.fromkeys(("M", "mass", "motor_mass", "load_mass"), mass) | dict.fromkeys(("B", "damping", "shaft_damping"), loss)
    units |= {"delay": "s", "stiffness": f"{force}/m", "resonance": "Hz", "damping_ratio": ""}
    names, values = fit.found.names, fit.found.values.tolist()
    rows = zip(names, values, fit.found.deviations.tolist(), fit.found.robust_deviations.tolist(), strict=True)
    told, possible = on_mass(fit.whole_mass) if unit == "N" else ([], True)
    remarks = (*remarks, *told, *_turning(records, found))
    if unit != "N":
        wanted = f"give {in_newtons(records[0].logged)} for kilograms"
        remarks = (*remarks, f"no force per command is given: masses are in {mass}, as the command sees them; {wanted}")
    return Finding(
        model,
        records[0].axis,
        tuple(record.source for record in records),
        tuple(Figure(name, value, units[name], white, robust) for name, value, white, robust in rows),
        fit.fit,
        fit.usable and possible,
        (*found.remarks, *fit.remarks, *remarks),
        tables,
        _pictures(records[0].axis, model, found, fit, unit),
        (found.method, f"fitted to {fit.frequency.size} points, {fit.frequency[0]:.4g} to {fit.frequency[-1]:.4g} Hz", *lines),
        {"method": found.method, "condition_number": fit.found.condition_number, "points": response_points(found, unit)},
        worth.correlations if worth is not None and tables else (),
    )


def _turning(records: Sequence[AxisRecord], found: MeasuredResponse) -> list[str]:
    """Remark on an axis that turns round where no harmonics tell what its friction does."""
    if not np.isnan(found.distortion).all():
        return []
    turning = []
    for record in records:
        stride = max(1, round(SMOOTHED / record.period))
        speed = np.diff(record.position[::stride])
        moving = speed[np.abs(speed) > SLOW * np.abs(speed).max()]
        if min(np.mean(moving > 0.0), np.mean(moving < 0.0)) > RARELY:
            turning.append(record.source)
    if not turning:
        return []
    words = (
        "sliding friction, where there is any, counts as damping and is not in the deviations: let the excitation ride on a steady motion"
    )
    return [f"the axis turns round in {', '.join(turning)}: {words}, or take rigid or first-order"]


def _pictures(axis: str, model: str, found: MeasuredResponse, fit: DriveFit, unit: str) -> tuple[Picture, ...]:
    of = _model(fit)
    f = np.geomspace(found.frequency[0], found.frequency[-1], CURVE)
    velocity = 2j * np.pi * f * held_response(of, f, found.period)
    ratio = fit.measured / fit.predicted
    left = _left(fit, "size [%]", 100.0 * (np.abs(ratio) - 1.0)), _left(fit, "phase [deg]", np.degrees(np.angle(ratio)))
    return (
        Picture("bode", f"Frequency response of axis {axis}, {model}", bode_graphs(found, unit, (f, velocity)), found.method),
        Picture("residual", "What the model leaves of the response", left, "Measured over model, less one; measured less model."),
    )


def _model(fit: DriveFit) -> Callable[[NDArray[np.complex128]], NDArray[np.complex128]]:
    """Return the response of the model over s."""
    x = fit.parameters
    if "M" in x:
        return lambda s: linear_motor(x, s)
    if "resonance" in x:
        return lambda s: load_side(x, s)
    return lambda s: two_inertia(x, s, "load" if fit.given else "motor")


def _left(fit: DriveFit, label: str, values: NDArray[np.float64]) -> Graph:
    f = fit.frequency
    drawn: Drawn = (f, values, np.zeros(f.size)) if f.size <= FEW else (f, values)
    return Graph("frequency [Hz]", label, {label.partition(" ")[0]: drawn}, log_x=True)


def _limits(records: Sequence[AxisRecord], fit: DriveFit, damping: float) -> MotionLimits:
    """Return the limits; accelerations as far as frequencies were fitted, above them counts and noise rule."""
    found = []
    for record in records:
        cutoff = min(BEYOND * float(fit.frequency[-1]), BELOW_NYQUIST / record.period)
        ends = math.ceil(1.0 / (cutoff * record.period))
        acceleration = filtered_motion(record.position, record.period, cutoff=cutoff).acceleration
        found.append(float(np.abs(acceleration[ends:-ends]).max(initial=0.0)))
    effort = Effort(forces_of(records), 1.0 / fit.whole_mass, damping / fit.whole_mass)
    return motion_limits(records, effort, Peak(max(found)))


def _worth(fit: DriveFit, numbers: Callable[[Mapping[str, float]], Mapping[str, float]]) -> Carried:
    found = fit.found
    return carried(numbers, found.names, found.values, found.robust_deviations, found.correlation)


def _motor_worth(forces: Forces, fit: DriveFit) -> Carried:
    """Return what the numbers of the axis file of a linear motor are worth."""
    return _worth(fit, lambda x: plant_numbers(forces, 1.0 / x["M"], x["B"] / x["M"]) | {"drive.delay": x["delay"]})


def _motor_tables(
    records: Sequence[AxisRecord], forces: Forces, fit: DriveFit, deviations: Mapping[str, float], limits: MotionLimits
) -> Tables:
    def origin(name: str, note: str = "") -> Origin:
        return told(source_of(records), deviations[name], note or "frequency response")

    plant = plant_table(forces, 1.0 / fit["M"], fit["B"] / fit["M"], origin)
    return {
        "plant": plant,
        "drive": drive_table(forces, limits.command, limits.origin, fit["delay"], origin),
        "limits": limits.table,
    }
