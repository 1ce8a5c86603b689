"""Friction of an axis: the friction curve from runs at constant speed, and breakaway from slow command ramps."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from contourlab.analysis.identification.friction import (
    LEAST_TRAVEL,
    Breakaway,
    FrictionCurve,
    Stretch,
    breakaways,
    constant_speed_stretches,
    fit_friction,
)
from contourlab.errors import ParameterError
from contourlab.features.identify.options import Identify
from contourlab.features.identify.records import AxisRecord, command_label, common_unit, log_names, reference_name, unit_findings
from contourlab.features.identify.result import Figure, Identification, Propagated, Tables, assumed, figures, fitted, propagate
from contourlab.features.identify.rigid import both_ways, direction_findings, offset_of
from contourlab.findings import Finding, finding
from contourlab.logs.load import about
from contourlab.rendering.charts import Chart, traces_chart
from contourlab.rendering.table import Column, Table

DIP, RISE = "stribeck_velocity", "rise_velocity"
"""Parameter for the speed of the bend: in a component whose friction dips, and in one whose friction rises."""
UNEVEN = 0.1
"""Median variation of the speed within stretches from which it does not count as constant; ball-screw ripple causes 0.06."""
EXPLAINED = 60.0
"""Fit [percent] of the first motion below which it is low; below half of it the levels are not usable."""
SPREAD = 0.1
"""Relative spread over repeats from which it is large."""


def identify_friction(records: Sequence[AxisRecord], options: Identify) -> Identification:
    """Fit a friction curve to stretches of constant speed in one or several logs of an axis.

    Parameters
    ----------
    records : sequence of AxisRecord
        With force or command.

    Raises
    ------
    ResultError
        If a log has no command, or the commands have different units.
    LogError
        If the signals of a record are not finite; names the log.
    ParameterError
        If there are fewer than three stretches of constant speed, or the command helps the motion.
    """
    unit = common_unit(records, "one friction curve")
    stretches = list[Stretch]()
    for record in records:
        with about(record.source):
            stretches += constant_speed_stretches(record.period, record.position, record.driven(), record.reference, record.source)
    fit = fit_friction(*_points(stretches))
    uneven = float(np.median([stretch.unevenness for stretch in stretches]))
    usable = fit.usable and uneven <= UNEVEN
    bare = log_names([record for record in records if record.reference is None])
    with_points = {stretch.source for stretch in stretches}
    findings = [*fit.findings, *([finding("CL512", logs=bare, share=LEAST_TRAVEL)] if bare else [])]
    findings += [finding("CL510", source) for source in log_names(records) if source not in with_points]
    findings += [finding("CL511", share=uneven)] if uneven > UNEVEN else []
    curve, written, units = fit.chosen, fit.writable if usable else None, _units(unit)
    tables, uncertainty = Tables(), Propagated()
    if written is not None and (wrong_unit := unit_findings(unit)):
        findings += wrong_unit
    elif written is not None:
        # How the axis file differs from the curve.
        findings += [] if written is curve else [finding("CL513", model=written.name, fit=written.fit / 100.0)]
        findings += direction_findings(written.parameters, units)
        findings += [finding("CL514")] if both_ways(written.parameters, "Fv") > 0.0 else []
        uncertainty = propagate(lambda x: _numbers(x, written.rises), written, reference_name(records))
        tables = _curve_tables(written, unit, uncertainty)
    return Identification(
        "friction",
        records[0].axis,
        log_names(records),
        figures(curve, units),
        curve.fit,
        usable,
        tuple(findings),
        details={
            "friction_model": curve.name,
            "scatter_between_runs": curve.scatter,
            "unit": unit,
            "points": stretches,
            "tried": [{"model": c.name, "aicc": c.criterion, "fit_percent": c.fit, "parameters": c.parameters} for c in fit.tried],
        },
        points=_stretch_table(stretches, unit),
        tables=tables,
        correlations=uncertainty.correlations,
        charts=_curve_charts(curve, stretches, unit, records[0].axis),
    )


def _points(stretches: Sequence[Stretch]) -> tuple[list[float], list[float], list[float]]:
    return [s.speed for s in stretches], [s.command for s in stretches], [s.deviation for s in stretches]


def _units(unit: str) -> dict[str, str]:
    force = unit or "command"
    return {**dict.fromkeys(("Fc", "drop", "offset"), force), "Fv": f"{force}*s/m", "vs": "m/s"}


def _stretch_table(stretches: Sequence[Stretch], unit: str) -> Table:
    heads = ("speed [mm/s]", f"mean [{unit}]", "deviation", "scatter within", "samples")
    rows = (
        (f"{1e3 * s.speed:.4g}", f"{s.command:.4g}", f"{s.deviation:.2g}", f"{s.scatter:.3g}", f"{s.count}", s.source)
        for s in sorted(stretches, key=lambda s: s.speed)
    )
    return Table([*map(Column, heads), Column("log", left=True)], rows=rows)


def _numbers(x: Mapping[str, float], rises: bool) -> dict[str, float]:
    """Return the parameters of the axis file: one friction for both directions, and the difference in level as an offset."""
    numbers = {"friction.coulomb": max(both_ways(x, "Fc"), 0.0), "friction.viscous": max(both_ways(x, "Fv"), 0.0)}
    if "vs" in x:
        numbers |= {"friction.breakaway": both_ways(x, "Fc") + both_ways(x, "drop"), f"friction.{RISE if rises else DIP}": x["vs"]}
    return {**numbers, "disturbance.force": -offset_of(x)}


def _curve_tables(curve: FrictionCurve, unit: str, uncertainty: Propagated) -> Tables:
    force = unit or "full_scale"
    units = {"friction.viscous": f"{force}*s/m", f"friction.{DIP}": "m/s", f"friction.{RISE}": "m/s"}
    kind = "rising" if curve.rises else "coulomb"
    tables: Tables = {"friction": {"kind": (kind, "", None)}, "disturbance": {"kind": ("constant", "", None)}}
    for name, value in _numbers(curve.parameters, curve.rises).items():
        table, _, key = name.partition(".")
        note = "offset of the command" if table == "disturbance" else "constant speeds"
        tables[table][key] = (value, units.get(name, force), uncertainty.origin(name, note))
    return tables


def _curve_charts(curve: FrictionCurve, stretches: Sequence[Stretch], unit: str, axis: str) -> tuple[Chart, ...]:
    v, u, s = (np.array(values) for values in _points(stretches))
    label = "mean force [N]" if unit == "N" else f"mean {command_label(unit)}"
    top, lowest = 1.05 * float(np.abs(v).max()), float(np.abs(v).min())
    ways = [way for way in (-1.0, 1.0) if np.any(way * v > 0.0)]
    line = np.concatenate([part for way in ways for part in (way * np.linspace(0.2 * lowest, top, 200), [np.nan])])
    model = np.where(np.isnan(line), np.nan, curve.at(np.where(np.isnan(line), top, line)))
    curves = {"measured ± 2 deviations": (1e3 * v, u, 2.0 * s), curve.name: (1e3 * line, model)}
    rest, residual = {"residual ± 2 deviations": (1e3 * v, u - curve.predicted, 2.0 * s)}, command_label(unit, "residual")
    return (
        traces_chart("friction", f"Friction of axis {axis} at constant speed", ("velocity [mm/s]", label), curves),
        traces_chart("residual", "Residual of the friction curve", ("velocity [mm/s]", residual), rest),
    )


# --- stiction ------------------------------------------------------------------------------------------------------------------------


def identify_stiction(records: Sequence[AxisRecord], options: Identify) -> Identification:
    """Identify the breakaway of an axis from rest in each direction, with the spread over repeats.

    Parameters
    ----------
    records : sequence of AxisRecord
        With slow command ramps from about zero.

    Raises
    ------
    ResultError
        If a log has no command, or the commands have different units.
    ParameterError
        See `contourlab.analysis.identification.friction.breakaways`; with several records, if none has a breakaway.
    """
    unit = common_unit(records, "one axis")
    ramps, findings = list[Breakaway](), list[Finding]()
    for record in records:
        try:
            moved, without = breakaways(record.time, record.driven(), record.position)
        except ParameterError as error:
            if len(records) == 1:
                raise
            findings.append(finding("CL520", record.source, reason=str(error)))
            continue
        ramps += [replace(ramp, time=ramp.time + record.start) for ramp in moved]
        findings += [replace(doubt, place=record.source) for doubt in without]
    if not ramps:
        reasons = "; ".join(doubt.text for doubt in findings)
        raise ParameterError("LOG", f"{len(records)} records", f"one in which a command ramp moves the axis from rest; {reasons}")
    ways = {name: [ramp for ramp in ramps if ramp.direction == way] for name, way in (("breakaway+", 1), ("breakaway-", -1))}
    fit = float(np.mean([ramp.fit for ramp in ramps]))
    wrong_unit = unit_findings(unit)
    findings += [*_ramp_findings(ways), *([finding("CL525", fit=fit / 100.0)] if fit < EXPLAINED else []), *wrong_unit]
    measured, parameters = {name: of_way for name, of_way in ways.items() if of_way}, {}
    for name, of_way in measured.items():
        own = math.sqrt(sum(ramp.deviation**2 for ramp in of_way)) / len(of_way)
        deviation = max(own, _spread(of_way) / math.sqrt(len(of_way)))
        parameters[name] = Figure(float(_levels(of_way).mean()), unit, own, deviation)
    return Identification(
        "stiction",
        records[0].axis,
        log_names(records),
        parameters,
        fit,
        fit > 0.5 * EXPLAINED,
        tuple(findings),
        details={"ramps": ramps},
        points=_ramp_table(ramps, unit),
        tables=_stiction_tables([*measured.values()], unit, reference_name(records)) if fit > 0.5 * EXPLAINED and not wrong_unit else {},
        charts=_stiction_charts(measured, unit, records[0]),
    )


def _levels(ramps: Sequence[Breakaway]) -> np.ndarray:
    return np.abs([ramp.level for ramp in ramps])


def _spread(ramps: Sequence[Breakaway]) -> float:
    """Return the standard deviation over repeats; for a single ramp its own deviation."""
    return float(_levels(ramps).std(ddof=1)) if len(ramps) > 1 else ramps[0].deviation


def _ramp_findings(ways: Mapping[str, Sequence[Breakaway]]) -> list[Finding]:
    findings = []
    for name, ramps in ways.items():
        direction = "forwards" if name.endswith("+") else "backwards"
        if len(ramps) < 2:
            findings.append(finding("CL522" if ramps else "CL521", direction=direction))
        elif (spread := _spread(ramps) / float(_levels(ramps).mean())) > SPREAD:
            findings.append(finding("CL523", direction=direction, spread=spread, ramps=len(ramps)))
    return findings


def _ramp_table(ramps: Sequence[Breakaway], unit: str) -> Table:
    heads = ("time [s]", f"breakaway [{unit}]", "deviation", f"rate [{unit}/s]", "fit [%]")
    rows = ((f"{b.time:.4g}", f"{b.level:.5g}", f"{b.deviation:.2g}", f"{b.rate:.3g}", f"{b.fit:.4g}") for b in ramps)
    return Table([*map(Column, heads)], rows=rows)


def _stiction_tables(ways: Sequence[Sequence[Breakaway]], unit: str, source: str) -> Tables:
    """Return the tables from the ramps of each direction that has some, the forward one first."""
    levels = [float(_levels(ramps).mean()) for ramps in ways]
    level, spread = float(np.mean(levels)), float(np.hypot.reduce([_spread(ramps) for ramps in ways])) / len(ways)
    force, count = unit or "full_scale", sum(map(len, ways))
    tables: Tables = {
        "friction": {
            "kind": ("coulomb", "", None),
            "coulomb": (level, force, assumed("equal to breakaway")),
            "breakaway": (level, force, fitted(source, spread, f"spread over {count} slow ramps")),
        }
    }
    if len(ways) == 2:
        half = fitted(source, spread, "half the difference between the directions")
        tables["disturbance"] = {"kind": ("constant", "", None), "force": (0.5 * (levels[1] - levels[0]), force, half)}
    return tables


def _stiction_charts(ways: Mapping[str, Sequence[Breakaway]], unit: str, first: AxisRecord) -> tuple[Chart, ...]:
    points = {
        name: (np.array([ramp.time for ramp in ramps]), _levels(ramps), np.array([2.0 * ramp.deviation for ramp in ramps]))
        for name, ramps in ways.items()
    }
    level, ramp = command_label(unit, "breakaway"), {"command": (first.time, first.driven())}
    moved = {"position [mm]": {"position": (first.time, 1e3 * (first.position - first.position[0]))}}
    return (
        traces_chart("breakaway", f"Breakaway of axis {first.axis}, ± 2 deviations", ("time [s]", level), points),
        traces_chart("ramps", f"Ramps of {first.source}", ("time [s]", command_label(unit)), ramp, below=moved),
    )
