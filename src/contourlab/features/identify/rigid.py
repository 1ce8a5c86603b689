"""A rigid axis from one log: mass, friction and offset by inverse dynamics; gain and damping in open loop, or behind an observer."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from typing import Any

import numpy as np

from contourlab.analysis.identification.filtered_motion import ANTI_ALIAS_BAND
from contourlab.analysis.identification.first_order import FirstOrderFit, identify_closed_loop, identify_first_order
from contourlab.analysis.identification.inverse_dynamics import InverseDynamicsSettings, cross_validate, identify_inverse_dynamics
from contourlab.analysis.identification.least_squares import mass_findings
from contourlab.analysis.identification.left_over import left_over_findings
from contourlab.errors import ParameterError, ResultError, refused
from contourlab.features.identify.axis_tables import forces_of, friction_tables, plant_numbers, rigid_tables
from contourlab.features.identify.options import Identify
from contourlab.features.identify.records import AxisRecord, command_label, newton_option, samples_digest
from contourlab.features.identify.result import Identification, Tables, figures, propagate
from contourlab.findings import Finding, finding
from contourlab.logs.load import about
from contourlab.rendering.charts import Chart, traces_chart
from contourlab.units import split, to_si

UNITS = {"M": "kg", "Fv": "N*s/m", "Fc": "N", "offset": "N"}
"""Units of the parameters, without the sign of a direction."""


def identify_rigid(records: Sequence[AxisRecord], options: Identify) -> Identification:
    """Identify mass, friction and offset of an axis.

    Parameters
    ----------
    records : sequence of AxisRecord
        With the force, or with a command and its gain; and perhaps another record of the same axis, for validation.

    Raises
    ------
    ResultError
        If a log has no force.
    LogError
        If a record is unusable, see `contourlab.analysis.identification.inverse_dynamics.identify_inverse_dynamics`; names the log.
    ParameterError
        If a setting is out of range for the record.
    """
    model = options.model or "rigid"
    if options.full_scale is not None:
        raise ParameterError("--full-scale", options.full_scale, f"omitted: model {model} needs forces, see --gain")
    record, friction = records[0], "symmetric" if model == "rigid" else "asymmetric"
    # Settings are named like their options, so that an error can name the option.
    slowest = options.si("slowest") or 0.0
    settings, lowered = _filter(options, max(one.period for one in records))
    settings = replace(settings, friction=friction, slowest=slowest)
    named = [setting.name for setting in fields(InverseDynamicsSettings)]
    with about(record.source, options=named):
        fit = identify_inverse_dynamics(record.time, record.position, _force(record), settings)
    details: dict[str, Any] = {"relative_error_percent": fit.relative_error, "condition_number": fit.condition_number, "validation": None}
    lines, same = [f"relative error {fit.relative_error:.4g} %, condition number {fit.condition_number:.4g}"], []
    for second in records[1:]:
        with about(second.source, options=named):
            validation = cross_validate(fit, second.time, second.position, _force(second))
        same += [finding("CL516", second.source)] if samples_digest([record]) == samples_digest([second]) else []
        lines.append(f"on the second log: fit {validation.fit:.4g} %, relative error {validation.relative_error:.4g} %")
        details["validation"] = {"fit_percent": validation.fit, "relative_error_percent": validation.relative_error}
    forces = forces_of([record])

    def numbers(x: Mapping[str, float]) -> dict[str, float]:
        plant = plant_numbers(forces, 1.0 / x["M"], both_ways(x, "Fv") / x["M"])
        return plant | {"friction.coulomb": both_ways(x, "Fc"), "disturbance.force": -offset_of(x)}

    uncertainty = propagate(numbers, replace(fit, robust_deviations=fit.known), record.source)
    findings, tables = [*lowered, *fit.findings], Tables()
    if fit.usable:
        findings += direction_findings(fit.parameters, UNITS)
        mass, damping, coulomb, force = numbers(fit.parameters).values()
        own, held = friction_tables(coulomb, force, "N", uncertainty.origin), coulomb + abs(force)
        tables = rigid_tables([record], 1.0 / mass, damping / mass, uncertainty.origin, held=held, friction=own)
    rest = fit.force - fit.predicted
    with about(record.source, options=named):
        whole = identify_inverse_dynamics(record.time, record.position, _force(record), replace(settings, decimation=1))
    findings += left_over_findings("", whole.force - whole.predicted, whole.force, whole.predicted, record.period, settings.cutoff)
    measured, over_time = {"measured": (fit.time, fit.force), "model": (fit.time, fit.predicted)}, ("time [s]", "force [N]")
    over_velocity = {"residual": (1e3 * fit.velocity, rest)}
    return Identification(
        model,
        record.axis,
        (record.source,),
        figures(fit, UNITS),
        fit.fit,
        fit.usable,
        (*findings, *same),
        details=details,
        lines=tuple(lines),
        tables=tables,
        correlations=uncertainty.correlations if fit.usable else (),
        charts=(
            traces_chart("force", f"Force of axis {record.axis}, {record.source}", over_time, measured),
            traces_chart("residual", "Force residual", over_time, {"residual": (fit.time, rest)}),
            traces_chart("residual-speed", "Force residual over velocity", ("velocity [mm/s]", "force [N]"), over_velocity),
        ),
    )


def _filter(options: Identify, period: float) -> tuple[InverseDynamicsSettings, list[Finding]]:
    """Return filter and decimation for records with a period [s] of up to this, and a finding where the usual filter is out of reach."""
    usual, nyquist = InverseDynamicsSettings(), 0.5 / period
    cutoff = options.si("cutoff") or min(usual.cutoff, ANTI_ALIAS_BAND * nyquist)
    decimation = options.decimation or max(min(usual.decimation, int(2.0 * nyquist / cutoff * (1.0 + 1e-9))), 1)
    is_lower = options.cutoff is None and cutoff < usual.cutoff
    lowered = [finding("CL590", cutoff=cutoff, usual=usual.cutoff, nyquist=nyquist)] if is_lower else []
    return InverseDynamicsSettings(cutoff=cutoff, decimation=decimation), lowered


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


def both_ways(x: Mapping[str, float], name: str) -> float:
    """Return a parameter, 0 if there is none; the mean of both directions if it has two: a component has the same friction for both."""
    return 0.5 * (x[f"{name}+"] + x[f"{name}-"]) if f"{name}+" in x else x.get(name, 0.0)


def offset_of(x: Mapping[str, float]) -> float:
    """Return the offset of the command, which by direction is half the difference of the Coulomb friction."""
    return 0.5 * (x["Fc+"] - x["Fc-"]) if "Fc+" in x else x.get("offset", 0.0)


def _force(record: AxisRecord) -> np.ndarray:
    command = record.driven()
    if record.unit != "N":
        raise ResultError(f"{record.source}: the force per command is unknown: give {newton_option(record.logged)}")
    return command


# --- gain and damping ----------------------------------------------------------------------------------------------------------------

FROM_COMMAND = "from the command before the observer, with noise and friction; --position-gain and --velocity-gain select eq 18"


def identify_open_loop(records: Sequence[AxisRecord], options: Identify) -> Identification:
    """Identify v' = -b v + a (u - friction) of an axis in open loop.

    Parameters
    ----------
    records : sequence of AxisRecord
        One, with command and position.

    Raises
    ------
    ResultError
        If the log has no command.
    ParameterError
        See `contourlab.analysis.identification.first_order.identify_first_order`.
    """
    (record,) = records
    fit = identify_first_order(record.time, record.driven(), record.position)
    unit, forces = record.unit, forces_of(records)

    def numbers(x: Mapping[str, float]) -> dict[str, float]:
        held = (("friction.coulomb", "friction", 1.0), ("disturbance.force", "offset", -1.0))
        delay = {"drive.delay": x["delay"]} if "delay" in x else {}
        return plant_numbers(forces, x["a"], x["b"]) | {name: sign * x[key] / forces.one for name, key, sign in held if key in x} | delay

    uncertainty, tables = propagate(numbers, fit, record.source), Tables()
    if fit.usable:
        coulomb, offset, delay = (fit.parameters.get(name, 0.0) for name in ("friction", "offset", "delay"))  # the log may not show them
        friction = friction_tables(coulomb / forces.one, -(offset / forces.one), forces.unit, uncertainty.origin)
        held = coulomb + abs(offset)
        tables = rigid_tables(records, fit["a"], fit["b"], uncertainty.origin, held=held, delay=delay, friction=friction)
    on_mass, possible = mass_findings(1.0 / fit["a"]) if unit == "N" else ([], True)
    left = left_over_findings("", fit.measured - fit.predicted, fit.command, fit.predicted, float(fit.time[1] - fit.time[0]))
    return Identification(
        "first-order",
        record.axis,
        (record.source,),
        figures(fit, {"a": f"m/s^2/{unit}".rstrip("/"), "b": "1/s", "friction": unit, "offset": unit, "delay": "s", "start": "m/s"}),
        fit.fit,
        fit.usable and possible,
        (*fit.findings, *on_mass, *left),
        details={"condition_number": fit.condition_number, "smoothing": fit.smoothing},
        lines=(
            f"velocity over {fit.smoothing} sample{'s' * (fit.smoothing > 1)}; "
            f"steady {1e3 * fit['a'] / max(fit['b'], 1e-12):.4g} mm/s per {unit or 'command'}",
        ),
        tables=tables,
        correlations=uncertainty.correlations if fit.usable else (),
        charts=_charts(fit, record, "velocity [mm/s]", command_label(unit)),
    )


def identify_behind_observer(records: Sequence[AxisRecord], options: Identify) -> Identification:
    """Identify a' and b' of an axis behind its disturbance observer.

    Parameters
    ----------
    records : sequence of AxisRecord
        One, with reference and position if the options give the gains of the recorded loop (eq 18); else with the command before the
        observer as command and disturbance estimate.

    Raises
    ------
    ResultError
        If a signal is missing.
    ParameterError
        See `contourlab.analysis.identification.first_order`; if a gain is missing, or no command per length or speed.
    """
    (record,), gains = records, _loop_gains(options)
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
    primed = replace(fit, names=tuple(f"{name}'" if name in ("a", "b") else name for name in fit.names))
    return Identification(
        "closed-loop",
        record.axis,
        (record.source,),
        figures(primed, {"a'": f"m/s^2/{unit}".rstrip("/"), "b'": "1/s", "delay": "s", "start": "m/s"}),
        fit.fit,
        fit.usable,
        fit.findings,
        details={"condition_number": fit.condition_number},
        lines=(start, "use them as model_gain and model_damping of a controller, not in a plant"),
        charts=_charts(fit, record, *labels),
    )


def _loop_gains(options: Identify) -> tuple[float, float, str] | None:
    """Return K_P [command/m] and K_V [command s/m] of the recorded loop, and the unit of the command, taken from K_P."""
    position, velocity = options.position_gain, options.velocity_gain
    if position is None and velocity is None:
        return None
    if position is None or velocity is None:
        option = "--position-gain" if position is None else "--velocity-gain"
        raise ParameterError(option, "missing", "given with the other one: eq 18 needs both K_P and K_V")
    with refused("--position-gain", position, 'command per length, such as "4 full_scale/mm"'):
        unit = split(position)[1].partition("/")[0].strip()
        proportional = to_si(position, f"{unit}/m")
    with refused("--velocity-gain", velocity, f'command per speed, such as "0.1 {unit}*s/mm"'):
        derivative = to_si(velocity, f"{unit}*s/m")
    return proportional, derivative, unit


def _charts(fit: FirstOrderFit, record: AxisRecord, output: str, command: str) -> tuple[Chart, ...]:
    """Return the output with the given command below it, and the residual; the labels are those of their axes."""
    time, measured, model = fit.time, 1e3 * fit.measured, 1e3 * fit.predicted
    given = 1e3 * fit.command if command.endswith("[mm]") else fit.command
    key, _, unit = output.partition(" ")
    both, title = {"measured": (time, measured), "model": (time, model)}, f"{key.capitalize()} of axis {record.axis}, {record.source}"
    return (
        traces_chart(key, title, ("time [s]", output), both, below={command: {"given": (time, given)}}),
        traces_chart("residual", f"Residual of {key}", ("time [s]", f"residual {unit}"), {"residual": (time, measured - model)}),
    )
