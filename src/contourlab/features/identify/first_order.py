"""Gain and damping of an axis from a log: in open loop, or in closed loop behind its disturbance observer."""

from __future__ import annotations

from collections.abc import Mapping

from contourlab.analysis.identification.first_order import FirstOrderFit, identify_closed_loop, identify_first_order
from contourlab.analysis.identification.inverse_dynamics import mass_findings
from contourlab.components.origin import Origin
from contourlab.errors import ResultError
from contourlab.features.identify.axis_tables import Forces, forces_of, friction_tables, plant_numbers, rigid_tables
from contourlab.features.identify.records import AxisRecord
from contourlab.features.identify.result import Graph, Identified, Picture, Propagated, Tables, command_label, figures, propagate

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
    uncertainty = _propagated(forces, fit)
    on_mass, possible = mass_findings(1.0 / fit["a"]) if unit == "N" else ([], True)
    units = {"a": f"m/s^2/{unit}".rstrip("/"), "b": "1/s", "friction": unit, "offset": unit, "delay": "s", "start": "m/s"}
    found = fit.found
    steady = f"steady {1e3 * fit['a'] / max(fit['b'], 1e-12):.4g} mm/s per {unit or 'command'}"
    return Identified(
        "first-order",
        record.axis,
        (record.source,),
        figures(found.names, found.values, found.deviations, found.robust_deviations, units.__getitem__),
        found.fit,
        fit.usable and possible,
        (*fit.findings, *on_mass),
        details={"condition_number": found.condition_number, "smoothing": fit.smoothing},
        lines=(f"velocity over {fit.smoothing} sample{'s' * (fit.smoothing > 1)}; {steady}",),
        tables=_tables(record, forces, fit, uncertainty) if fit.usable else {},
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
    found, key = fit.found, labels[0].partition(" ")[0]
    units = {"a'": f"m/s^2/{unit}".rstrip("/"), "b'": "1/s", "delay": "s", "start": "m/s"}
    names = [{"a": "a'", "b": "b'"}.get(name, name) for name in found.names]
    return Identified(
        "closed-loop",
        record.axis,
        (record.source,),
        figures(names, found.values, found.deviations, found.robust_deviations, units.__getitem__),
        found.fit,
        fit.usable,
        fit.findings,
        details={"condition_number": found.condition_number},
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


def _propagated(forces: Forces, fit: FirstOrderFit) -> Propagated:
    """Return the uncertainty of the parameters in the axis file."""

    def numbers(x: Mapping[str, float]) -> dict[str, float]:
        held = (("friction.coulomb", "friction", 1.0), ("disturbance.force", "offset", -1.0))
        delay = {"drive.delay": x["delay"]} if "delay" in x else {}
        return plant_numbers(forces, x["a"], x["b"]) | {name: sign * x[key] / forces.one for name, key, sign in held if key in x} | delay

    found = fit.found
    return propagate(numbers, found.names, found.values, found.robust_deviations, found.correlation)


def _tables(record: AxisRecord, forces: Forces, fit: FirstOrderFit, uncertainty: Propagated) -> Tables:
    """Return the axis file: in newtons if the command is a force, else in shares of full scale."""

    def origin(name: str, note: str = "") -> Origin:
        if name not in uncertainty.deviations:
            return Origin("assumed", reference=record.source, note="not visible in the log")
        return uncertainty.origin(record.source, name, note)

    friction = friction_tables(fit["friction"] / forces.one, -(fit["offset"] / forces.one), forces.unit, origin)
    held = fit["friction"] + abs(fit["offset"])
    return rigid_tables([record], forces, fit["a"], fit["b"], origin, held=held, delay=fit["delay"], friction=friction)
