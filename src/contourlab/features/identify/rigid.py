"""Mass, friction and offset of an axis out of one log, by inverse dynamics, and the axis file that they make."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields

import numpy as np

from contourlab.analysis.identification.inverse_dynamics import (
    InverseDynamicsFit,
    InverseDynamicsSettings,
    Validation,
    cross_validate,
    identify_inverse_dynamics,
)
from contourlab.components.origin import Origin
from contourlab.errors import ResultError
from contourlab.features.identify.finding import Carried, Figure, Finding, Graph, Picture, Tables, carried, told
from contourlab.features.identify.limits import Effort, motion_limits
from contourlab.features.identify.plant_tables import Forces, drive_table, forces_of, plant_numbers, plant_table
from contourlab.features.identify.signals import AxisRecord, in_newtons, samples_digest, sensor_table
from contourlab.features.identify.ways import on_ways
from contourlab.logs.error_context import about

MODELS = {"symmetric": "rigid", "asymmetric": "rigid-by-direction"}
UNITS = {"M": "kg", "Fv": "N*s/m", "Fc": "N", "offset": "N"}
"""Of the parameters, without the signs of a direction."""


def identify_rigid(record: AxisRecord, settings: InverseDynamicsSettings | None = None, second: AxisRecord | None = None) -> Finding:
    """Find mass, friction and offset of an axis.

    Parameters
    ----------
    record : AxisRecord
        With the force, or a command and its gain.
    settings : InverseDynamicsSettings, optional
    second : AxisRecord, optional
        Another record of the same axis, to see what the parameters are worth there.

    Raises
    ------
    ResultError
        If a log has no force.
    LogError
        If a record tells no axis, as of `contourlab.analysis.identification.inverse_dynamics.identify_inverse_dynamics`; says which.
    ParameterError
        If a setting is out of range for it.
    """
    options = [each.name for each in fields(InverseDynamicsSettings)]
    with about(record.source, options=options):
        fit = identify_inverse_dynamics(record.time, record.position, _force(record), settings)
    there = None
    if second is not None:
        with about(second.source, options=options):
            there = cross_validate(fit, second.time, second.position, _force(second))
    forces = forces_of([record])
    known = np.maximum(fit.deviations, fit.robust_deviations)
    worth = carried(lambda x: _numbers(forces, x), fit.names, fit.values, known, fit.correlation)
    rows = zip(fit.names, fit.values.tolist(), fit.deviations.tolist(), fit.robust_deviations.tolist(), strict=True)
    return Finding(
        MODELS[fit.settings.friction],
        record.axis,
        (record.source,),
        tuple(Figure(name, value, UNITS[name.rstrip("+-")], white, robust) for name, value, white, robust in rows),
        fit.fit,
        fit.usable,
        (*fit.remarks, *(on_ways(fit.parameters(), UNITS) if fit.usable else ()), *_on_second(record, second)),
        _tables(record, forces, fit, worth) if fit.usable else {},
        _pictures(record, fit),
        _lines(fit, there),
        _more(fit, there),
        worth.correlations if fit.usable else (),
    )


def _force(record: AxisRecord) -> np.ndarray:
    """Return the force [N]."""
    command = record.driven()
    if record.unit != "N":
        raise ResultError(f"{record.source}: how much force is a command? Give {in_newtons(record.logged)}")
    return command


def _lines(fit: InverseDynamicsFit, there: Validation | None) -> tuple[str, ...]:
    lines = (f"relative error {fit.relative_error:.4g} %, condition number {fit.condition_number:.4g}",)
    if there is None:
        return lines
    return (*lines, f"on the second log: fit {there.fit:.4g} %, relative error {there.relative_error:.4g} %")


def _more(fit: InverseDynamicsFit, there: Validation | None) -> dict[str, object]:
    checked = None if there is None else {"fit_percent": there.fit, "relative_error_percent": there.relative_error}
    return {"relative_error_percent": fit.relative_error, "condition_number": fit.condition_number, "validation": checked}


def _on_second(record: AxisRecord, second: AxisRecord | None) -> list[str]:
    """Remark on a second log that is the first one: it shows how well the figures fit what they were fitted to."""
    if second is None or samples_digest([record]) != samples_digest([second]):
        return []
    return [f"{second.source} has the samples that were fitted: it validates nothing"]


def _numbers(forces: Forces, x: Mapping[str, float]) -> dict[str, float]:
    """Return the numbers of the axis file: friction that differs by direction as its mean, since a component has one for both."""
    if "Fc" in x:
        viscous, coulomb, offset = x["Fv"], x["Fc"], x["offset"]
    else:
        viscous, coulomb, offset = 0.5 * (x["Fv+"] + x["Fv-"]), 0.5 * (x["Fc+"] + x["Fc-"]), 0.5 * (x["Fc+"] - x["Fc-"])
    return plant_numbers(forces, 1.0 / x["M"], viscous / x["M"]) | {"friction.coulomb": coulomb, "disturbance.force": -offset}


def _tables(record: AxisRecord, forces: Forces, fit: InverseDynamicsFit, worth: Carried) -> Tables:
    """Return the axis in newtons."""
    value = _numbers(forces, fit.parameters())
    mass, damping, held = value["plant.mass"], value["plant.damping"], value["friction.coulomb"] + abs(value["disturbance.force"])
    limits = motion_limits([record], Effort(forces, 1.0 / mass, damping / mass, held))

    def origin(name: str, note: str = "") -> Origin:
        return told(record.source, worth.deviations[name], note)

    return {
        "plant": plant_table(forces, 1.0 / mass, damping / mass, origin),
        "friction": {"kind": ("coulomb", "", None), "coulomb": (value["friction.coulomb"], "N", origin("friction.coulomb"))},
        "disturbance": {"kind": ("constant", "", None), "force": (value["disturbance.force"], "N", origin("disturbance.force"))},
        "drive": drive_table(forces, limits.command, limits.origin, 0.0, origin),
        "limits": limits.table,
        **sensor_table([record]),
    }


def _pictures(record: AxisRecord, fit: InverseDynamicsFit) -> tuple[Picture, ...]:
    force = {"measured": (fit.time, fit.force), "model": (fit.time, fit.predicted)}
    rest = fit.force - fit.predicted
    over_time = Graph("time [s]", "force [N]", {"residual": (fit.time, rest)})
    over_speed = Graph("velocity [mm/s]", "force [N]", {"residual": (1e3 * fit.velocity, rest)})
    return (
        Picture("force", f"Force of axis {record.axis}, {record.source}", (Graph("time [s]", "force [N]", force),)),
        Picture("residual", "What the model leaves of the force", (over_time,)),
        Picture("residual-speed", "What the model leaves of the force, over speed", (over_speed,)),
    )
