"""Mass, friction and offset of an axis from one log, by inverse dynamics."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
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
from contourlab.features.identify.axis_tables import forces_of, friction_tables, plant_numbers, rigid_tables
from contourlab.features.identify.records import AxisRecord, newton_option, samples_digest
from contourlab.features.identify.result import Graph, Identified, Picture, Tables, figures, propagate
from contourlab.findings import Finding, finding
from contourlab.logs.load import about

MODELS = {"symmetric": "rigid", "asymmetric": "rigid-by-direction"}
UNITS = {"M": "kg", "Fv": "N*s/m", "Fc": "N", "offset": "N"}
"""Units of the parameters, without the sign of a direction."""


def identify_rigid(record: AxisRecord, settings: InverseDynamicsSettings, second: AxisRecord | None = None) -> Identified:
    """Identify mass, friction and offset of an axis.

    Parameters
    ----------
    record : AxisRecord
        With the force, or with a command and its gain.
    second : AxisRecord, optional
        Another record of the same axis, for validation.

    Raises
    ------
    ResultError
        If a log has no force.
    LogError
        If a record is unusable, see `contourlab.analysis.identification.inverse_dynamics.identify_inverse_dynamics`; names the log.
    ParameterError
        If a setting is out of range for the record.
    """
    options = [setting.name for setting in fields(InverseDynamicsSettings)]
    with about(record.source, options=options):
        fit = identify_inverse_dynamics(record.time, record.position, _force(record), settings)
    validation = None
    if second is not None:
        with about(second.source, options=options):
            validation = cross_validate(fit, second.time, second.position, _force(second))
    forces = forces_of([record])

    def numbers(x: Mapping[str, float]) -> dict[str, float]:
        viscous, coulomb, offset = _mean_friction(x)
        return plant_numbers(forces, 1.0 / x["M"], viscous / x["M"]) | {"friction.coulomb": coulomb, "disturbance.force": -offset}

    known = np.maximum(fit.deviations, fit.robust_deviations)
    uncertainty = propagate(numbers, fit.names, fit.values, known, fit.correlation)
    findings = [*fit.findings]
    tables: Tables = {}
    if fit.usable:
        findings += direction_findings(fit.parameters(), UNITS)
        x = numbers(fit.parameters())
        mass, damping, coulomb, force = (x[key] for key in ("plant.mass", "plant.damping", "friction.coulomb", "disturbance.force"))

        def origin(name: str, note: str = "") -> Origin:
            return uncertainty.origin(record.source, name, note)

        friction, held = friction_tables(coulomb, force, "N", origin), coulomb + abs(force)
        tables = rigid_tables([record], forces, 1.0 / mass, damping / mass, origin, held=held, friction=friction)
    if second is not None and samples_digest([record]) == samples_digest([second]):
        findings.append(finding("CL516", second.source))
    return Identified(
        MODELS[fit.settings.friction],
        record.axis,
        (record.source,),
        figures(fit.names, fit.values, fit.deviations, fit.robust_deviations, lambda name: UNITS[name.rstrip("+-")]),
        fit.fit,
        fit.usable,
        tuple(findings),
        details=_details(fit, validation),
        lines=_lines(fit, validation),
        tables=tables,
        correlations=uncertainty.correlations if fit.usable else (),
        pictures=_pictures(record, fit),
    )


def direction_findings(x: Mapping[str, float], units: Mapping[str, str]) -> list[Finding]:
    """Return findings on parameters by direction, for which the axis file has the mean of both directions.

    Parameters
    ----------
    x : mapping
        Parameters by name; ``"Fv+"`` and ``"Fv-"`` are friction against forward and backward motion.
    units : mapping
        Units by name without its sign.

    >>> [found.place for found in direction_findings({"Fc+": 21.0, "Fc-": 23.0}, {"Fc": "N"})]
    ['Fc']
    """
    names = [name.removesuffix("+") for name in x if name.endswith("+")]
    return [finding("CL515", name, forward=x[f"{name}+"], backward=x[f"{name}-"], unit=units[name]) for name in names]


def _mean_friction(x: Mapping[str, float]) -> Sequence[float]:
    """Return viscous and Coulomb friction and offset: means of both directions, since a component has the same friction for both."""
    if "Fc" in x:
        return x["Fv"], x["Fc"], x["offset"]
    return 0.5 * (x["Fv+"] + x["Fv-"]), 0.5 * (x["Fc+"] + x["Fc-"]), 0.5 * (x["Fc+"] - x["Fc-"])


def _force(record: AxisRecord) -> np.ndarray:
    command = record.driven()
    if record.unit != "N":
        raise ResultError(f"{record.source}: the force per command is unknown: give {newton_option(record.logged)}")
    return command


def _lines(fit: InverseDynamicsFit, validation: Validation | None) -> tuple[str, ...]:
    line = f"relative error {fit.relative_error:.4g} %, condition number {fit.condition_number:.4g}"
    if validation is None:
        return (line,)
    return (line, f"on the second log: fit {validation.fit:.4g} %, relative error {validation.relative_error:.4g} %")


def _details(fit: InverseDynamicsFit, validation: Validation | None) -> dict[str, object]:
    second = None if validation is None else {"fit_percent": validation.fit, "relative_error_percent": validation.relative_error}
    return {"relative_error_percent": fit.relative_error, "condition_number": fit.condition_number, "validation": second}


def _pictures(record: AxisRecord, fit: InverseDynamicsFit) -> tuple[Picture, ...]:
    force = {"measured": (fit.time, fit.force), "model": (fit.time, fit.predicted)}
    rest = fit.force - fit.predicted
    over_time = Graph("time [s]", "force [N]", {"residual": (fit.time, rest)})
    over_speed = Graph("velocity [mm/s]", "force [N]", {"residual": (1e3 * fit.velocity, rest)})
    return (
        Picture("force", f"Force of axis {record.axis}, {record.source}", (Graph("time [s]", "force [N]", force),)),
        Picture("residual", "Force residual", (over_time,)),
        Picture("residual-speed", "Force residual over velocity", (over_speed,)),
    )
