"""A rigid axis from one log: mass, friction and offset by inverse dynamics; gain and damping in open loop, or behind an observer."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields

import numpy as np

from contourlab.analysis.identification.first_order import FirstOrderFit, identify_closed_loop, identify_first_order
from contourlab.analysis.identification.inverse_dynamics import (
    InverseDynamicsFit,
    InverseDynamicsSettings,
    cross_validate,
    identify_inverse_dynamics,
    mass_findings,
)
from contourlab.errors import ResultError
from contourlab.features.identify.axis_tables import forces_of, friction_tables, plant_numbers, rigid_tables
from contourlab.features.identify.records import AxisRecord, newton_option, samples_digest
from contourlab.features.identify.result import Graph, Identified, Picture, Tables, command_label, figures, propagate
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
        viscous, coulomb, offset = x.get("Fv"), x.get("Fc"), x.get("offset")
        if viscous is None or coulomb is None or offset is None:  # by direction: a component has the same friction for both
            viscous, coulomb, offset = 0.5 * (x["Fv+"] + x["Fv-"]), 0.5 * (x["Fc+"] + x["Fc-"]), 0.5 * (x["Fc+"] - x["Fc-"])
        return plant_numbers(forces, 1.0 / x["M"], viscous / x["M"]) | {"friction.coulomb": coulomb, "disturbance.force": -offset}

    known = np.maximum(fit.deviations, fit.robust_deviations)
    uncertainty = propagate(numbers, fit.names, fit.values, known, fit.correlation, record.source)
    findings = [*fit.findings]
    tables: Tables = {}
    if fit.usable:
        findings += direction_findings(fit.parameters(), UNITS)
        x = numbers(fit.parameters())
        mass, damping, coulomb, force = (x[key] for key in ("plant.mass", "plant.damping", "friction.coulomb", "disturbance.force"))
        friction, held = friction_tables(coulomb, force, "N", uncertainty.origin), coulomb + abs(force)
        tables = rigid_tables([record], forces, 1.0 / mass, damping / mass, uncertainty.origin, held=held, friction=friction)
    lines = [f"relative error {fit.relative_error:.4g} %, condition number {fit.condition_number:.4g}"]
    second_fit = None
    if second is not None and validation is not None:
        findings += [finding("CL516", second.source)] if samples_digest([record]) == samples_digest([second]) else []
        lines.append(f"on the second log: fit {validation.fit:.4g} %, relative error {validation.relative_error:.4g} %")
        second_fit = {"fit_percent": validation.fit, "relative_error_percent": validation.relative_error}
    return Identified(
        MODELS[fit.settings.friction],
        record.axis,
        (record.source,),
        figures(fit.names, fit.values, fit.deviations, fit.robust_deviations, lambda name: UNITS[name.rstrip("+-")]),
        fit.fit,
        fit.usable,
        tuple(findings),
        details={"relative_error_percent": fit.relative_error, "condition_number": fit.condition_number, "validation": second_fit},
        lines=tuple(lines),
        tables=tables,
        correlations=uncertainty.correlations if fit.usable else (),
        pictures=_force_pictures(record, fit),
    )


def direction_findings(x: Mapping[str, float], units: Mapping[str, str]) -> list[Finding]:
    """Return findings on parameters by direction, for which the axis file has the mean of both directions.

    Parameters
    ----------
    x : mapping
        Parameters by name; ``"Fv+"`` and ``"Fv-"`` are friction against forward and backward motion.
    units : mapping
        Units by name without its sign.

    >>> [doubt.place for doubt in direction_findings({"Fc+": 21.0, "Fc-": 23.0}, {"Fc": "N"})]
    ['Fc']
    """
    names = [name.removesuffix("+") for name in x if name.endswith("+")]
    return [finding("CL515", name, forward=x[f"{name}+"], backward=x[f"{name}-"], unit=units[name]) for name in names]


def _force(record: AxisRecord) -> np.ndarray:
    command = record.driven()
    if record.unit != "N":
        raise ResultError(f"{record.source}: the force per command is unknown: give {newton_option(record.logged)}")
    return command


def _force_pictures(record: AxisRecord, fit: InverseDynamicsFit) -> tuple[Picture, ...]:
    force = {"measured": (fit.time, fit.force), "model": (fit.time, fit.predicted)}
    rest = fit.force - fit.predicted
    over_time = Graph("time [s]", "force [N]", {"residual": (fit.time, rest)})
    over_speed = Graph("velocity [mm/s]", "force [N]", {"residual": (1e3 * fit.velocity, rest)})
    return (
        Picture("force", f"Force of axis {record.axis}, {record.source}", (Graph("time [s]", "force [N]", force),)),
        Picture("residual", "Force residual", (over_time,)),
        Picture("residual-speed", "Force residual over velocity", (over_speed,)),
    )


# --- gain and damping ----------------------------------------------------------------------------------------------------------------

FROM_COMMAND = "from the command before the observer, with noise and friction; --position-gain and --velocity-gain select eq 18"


def identify_open_loop(record: AxisRecord) -> Identified:
    """Identify v' = -b v + a (u - friction) of an axis in open loop.

    Parameters
    ----------
    record : AxisRecord
        With command and position.

    Raises
    ------
    ResultError
        If the log has no command.
    ParameterError
        See `contourlab.analysis.identification.first_order.identify_first_order`.
    """
    fit = identify_first_order(record.time, record.driven(), record.position)
    unit, forces = record.unit, forces_of([record])

    def numbers(x: Mapping[str, float]) -> dict[str, float]:
        held = (("friction.coulomb", "friction", 1.0), ("disturbance.force", "offset", -1.0))
        delay = {"drive.delay": x["delay"]} if "delay" in x else {}
        return plant_numbers(forces, x["a"], x["b"]) | {name: sign * x[key] / forces.one for name, key, sign in held if key in x} | delay

    estimate = fit.found
    tables: Tables = {}
    uncertainty = propagate(numbers, estimate.names, estimate.values, estimate.robust_deviations, estimate.correlation, record.source)
    if fit.usable:
        friction = friction_tables(fit["friction"] / forces.one, -(fit["offset"] / forces.one), forces.unit, uncertainty.origin)
        held = fit["friction"] + abs(fit["offset"])
        tables = rigid_tables([record], forces, fit["a"], fit["b"], uncertainty.origin, held=held, delay=fit["delay"], friction=friction)
    on_mass, possible = mass_findings(1.0 / fit["a"]) if unit == "N" else ([], True)
    units = {"a": f"m/s^2/{unit}".rstrip("/"), "b": "1/s", "friction": unit, "offset": unit, "delay": "s", "start": "m/s"}
    steady = f"steady {1e3 * fit['a'] / max(fit['b'], 1e-12):.4g} mm/s per {unit or 'command'}"
    return Identified(
        "first-order",
        record.axis,
        (record.source,),
        figures(estimate.names, estimate.values, estimate.deviations, estimate.robust_deviations, units.__getitem__),
        estimate.fit,
        fit.usable and possible,
        (*fit.findings, *on_mass),
        details={"condition_number": estimate.condition_number, "smoothing": fit.smoothing},
        lines=(f"velocity over {fit.smoothing} sample{'s' * (fit.smoothing > 1)}; {steady}",),
        tables=tables,
        correlations=uncertainty.correlations if fit.usable else (),
        pictures=_pictures(fit, "velocity", f"Velocity of axis {record.axis}, {record.source}", ("velocity [mm/s]", command_label(unit))),
    )


def identify_behind_observer(record: AxisRecord, gains: tuple[float, float, str] | None) -> Identified:
    """Identify a' and b' of an axis behind its disturbance observer.

    Parameters
    ----------
    record : AxisRecord
        With reference and position if gains are given; else with the command and the disturbance estimate subtracted from it.
    gains : (K_P, K_V, unit of the command) or None [command/m, command s/m]
        Gains of the recorded loop (eq 18); None to identify from the command before the observer to the position.

    Raises
    ------
    ResultError
        If a signal is missing.
    ParameterError
        See `contourlab.analysis.identification.first_order`.
    """
    if gains is not None:
        fit = identify_closed_loop(record.time, record.asked(), record.position, *gains[:2])
        unit, labels, start = gains[2], ("position [mm]", "reference [mm]"), "eq 18, from the reference"
    else:
        if record.estimate is None:
            raise ResultError(
                f"no disturbance_estimate of {record.axis} in {record.source}: give --position-gain and --velocity-gain of the loop, "
                "or the column of the observer's estimate"
            )
        fit = identify_first_order(record.time, record.driven() + record.estimate, record.position, friction=False)
        unit, labels, start = record.unit, ("velocity [mm/s]", command_label(record.unit)), FROM_COMMAND
    estimate, key = fit.found, labels[0].partition(" ")[0]
    units = {"a'": f"m/s^2/{unit}".rstrip("/"), "b'": "1/s", "delay": "s", "start": "m/s"}
    names = [{"a": "a'", "b": "b'"}.get(name, name) for name in estimate.names]
    return Identified(
        "closed-loop",
        record.axis,
        (record.source,),
        figures(names, estimate.values, estimate.deviations, estimate.robust_deviations, units.__getitem__),
        estimate.fit,
        fit.usable,
        fit.findings,
        details={"condition_number": estimate.condition_number},
        lines=(start, "use them as model_gain and model_damping of a controller, not in a plant"),
        pictures=_pictures(fit, key, f"{key.capitalize()} of axis {record.axis}, {record.source}", labels),
    )


def _pictures(fit: FirstOrderFit, key: str, title: str, labels: tuple[str, str]) -> tuple[Picture, ...]:
    time, measured, model = fit.time, 1e3 * fit.found.measured, 1e3 * fit.found.predicted
    given = 1e3 * fit.command if labels[1].endswith("[mm]") else fit.command
    output = Graph("time [s]", labels[0], {"measured": (time, measured), "model": (time, model)})
    residual = Graph("time [s]", f"residual {labels[0].partition(' ')[2]}", {"residual": (time, measured - model)})
    return (
        Picture(key, title, (output, Graph("time [s]", labels[1], {"given": (time, given)}))),
        Picture("residual", f"Residual of {key}", (residual,)),
    )
