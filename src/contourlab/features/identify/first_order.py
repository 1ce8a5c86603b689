"""Gain and damping of an axis out of a log: open loop, and closed behind its disturbance observer."""

from __future__ import annotations

from collections.abc import Mapping

from contourlab.analysis.identification.first_order import FirstOrderFit, identify_closed_loop, identify_first_order
from contourlab.analysis.identification.identification_remarks import on_mass
from contourlab.components.origin import Origin
from contourlab.errors import ResultError
from contourlab.features.identify.finding import Carried, Figure, Finding, Graph, Picture, Tables, carried, of_command, told
from contourlab.features.identify.limits import Effort, motion_limits
from contourlab.features.identify.plant_tables import Forces, drive_table, forces_of, plant_numbers, plant_table
from contourlab.features.identify.signals import AxisRecord, sensor_table


def identify_open_loop(record: AxisRecord) -> Finding:
    """Find v' = -b v + a (u - friction) of an axis that its command drives in open loop.

    Parameters
    ----------
    record : AxisRecord
        With command and position.

    Raises
    ------
    ResultError
        If the log has no command.
    ParameterError
        As of `contourlab.analysis.identification.first_order.identify_first_order`.
    """
    fit = identify_first_order(record.time, record.driven(), record.position)
    unit = record.unit
    units = {"a": _over("m/s^2", unit), "b": "1/s", "friction": unit, "offset": unit, "delay": "s", "start": "m/s"}
    figures = _figures(fit, units, {name: name for name in units})
    pictures = _pictures(fit, "velocity", f"Velocity of axis {record.axis}, {record.source}", ("velocity [mm/s]", of_command(unit)))
    steady = f"steady {1e3 * fit['a'] / max(fit['b'], 1e-12):.4g} mm/s per {unit or 'command'}"
    lines = (f"velocity over {fit.smoothing} sample{'s' * (fit.smoothing > 1)}; {steady}",)
    forces = forces_of([record])
    worth = _worth(forces, fit)
    told, possible = on_mass(1.0 / fit["a"]) if unit == "N" else ([], True)
    return Finding(
        "first-order",
        record.axis,
        (record.source,),
        figures,
        fit.found.fit,
        fit.usable and possible,
        (*fit.remarks, *told),
        _tables(record, forces, fit, worth.deviations) if fit.usable else {},
        pictures,
        lines,
        {"condition_number": fit.found.condition_number, "smoothing": fit.smoothing},
        worth.correlations if fit.usable else (),
    )


def identify_behind_observer(record: AxisRecord, gains: tuple[float, float, str] | None) -> Finding:
    """Find a' and b' of an axis behind its disturbance observer.

    Parameters
    ----------
    record : AxisRecord
        With reference and position where gains are given; else with the command and the disturbance estimate that was taken off it.
    gains : (K_P, K_V, unit of the command) or None [command/m, command s/m]
        Of the loop as it ran (eq 18); None to go from the command before the observer to the position.

    Raises
    ------
    ResultError
        If a signal is missing.
    ParameterError
        As of the identifications.
    """
    if gains is not None:
        fit = identify_closed_loop(record.time, record.asked(), record.position, *gains[:2])
        unit, quantity, said = gains[2], ("position [mm]", "reference [mm]"), "eq 18, from the reference"
        remarks = fit.remarks
    else:
        if record.estimate is None:
            raise ResultError(
                f"no disturbance_estimate of {record.axis} in {record.source}: give --position-gain and --velocity-gain of the loop, "
                "or the column of what the observer takes off the command"
            )
        ahead = record.driven() + record.estimate
        fit = identify_first_order(record.time, ahead, record.position, friction=False)
        unit, said = record.unit, "from the command ahead of the observer"
        quantity = "velocity [mm/s]", of_command(unit)
        remarks = (
            *fit.remarks,
            "the loop feeds noise and friction back into this command: K_P and K_V given, the reference is a better input",
        )
    units = {"a": _over("m/s^2", unit), "b": "1/s", "delay": "s", "start": "m/s"}
    what = quantity[0].partition(" ")[0]
    pictures = _pictures(fit, what, f"{what.capitalize()} of axis {record.axis}, {record.source}", quantity)
    return Finding(
        "closed-loop",
        record.axis,
        (record.source,),
        _figures(fit, units, {"a": "a'", "b": "b'", "delay": "delay", "start": "start"}),
        fit.found.fit,
        fit.usable,
        remarks,
        {},
        pictures,
        (said, "for a controller's model_gain and model_damping, not for a plant"),
        {"condition_number": fit.found.condition_number},
    )


def _over(top: str, unit: str) -> str:
    return f"{top}/{unit}" if unit else top


def _figures(fit: FirstOrderFit, units: dict[str, str], called: dict[str, str]) -> tuple[Figure, ...]:
    found = fit.found
    rows = zip(found.names, found.values.tolist(), found.deviations.tolist(), found.robust_deviations.tolist(), strict=True)
    return tuple(Figure(called[name], value, units[name], white, robust) for name, value, white, robust in rows)


def _pictures(fit: FirstOrderFit, key: str, title: str, labels: tuple[str, str]) -> tuple[Picture, ...]:
    time, measured, model = fit.time, 1e3 * fit.found.measured, 1e3 * fit.found.predicted
    curves = {"measured": (time, measured), "model": (time, model)}
    given = 1e3 * fit.command if labels[1].endswith("[mm]") else fit.command
    unit = labels[0].partition(" ")[2]
    return (
        Picture(key, title, (Graph("time [s]", labels[0], curves), Graph("time [s]", labels[1], {"given": (time, given)}))),
        Picture(
            "residual",
            f"What the model leaves of the {key}",
            (Graph("time [s]", f"residual {unit}", {"residual": (time, measured - model)}),),
        ),
    )


def _worth(forces: Forces, fit: FirstOrderFit) -> Carried:
    """Return what the numbers of the axis file are worth."""

    def numbers(x: Mapping[str, float]) -> dict[str, float]:
        own = (("friction.coulomb", "friction", 1.0), ("disturbance.force", "offset", -1.0))
        late = {"drive.delay": x["delay"]} if "delay" in x else {}
        held = {name: sign * x[key] / forces.one for name, key, sign in own if key in x}
        return plant_numbers(forces, x["a"], x["b"]) | held | late

    found = fit.found
    return carried(numbers, found.names, found.values, found.robust_deviations, found.correlation)


def _tables(record: AxisRecord, forces: Forces, fit: FirstOrderFit, deviations: Mapping[str, float]) -> Tables:
    """Return the axis: in newtons where the command is a force, else in parts of full scale."""

    def origin(name: str, note: str = "") -> Origin:
        if name not in deviations:
            return Origin("assumed", reference=record.source, note="none is told from the log")
        return told(record.source, deviations[name], note)

    limits = motion_limits([record], Effort(forces, fit["a"], fit["b"], fit["friction"] + abs(fit["offset"])))
    friction, offset = fit["friction"] / forces.one, fit["offset"] / forces.one
    return {
        "plant": plant_table(forces, fit["a"], fit["b"], origin),
        "friction": {"kind": ("coulomb", "", None), "coulomb": (friction, forces.unit, origin("friction.coulomb"))},
        "disturbance": {"kind": ("constant", "", None), "force": (-offset, forces.unit, origin("disturbance.force"))},
        "drive": drive_table(forces, limits.command, limits.origin, fit["delay"], origin),
        "limits": limits.table,
        **sensor_table([record]),
    }
