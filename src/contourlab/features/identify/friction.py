"""The friction curve of an axis out of runs at constant speeds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from contourlab.analysis.identification.constant_speed import LEAST_TRAVEL, Stretch, constant_speed_stretches
from contourlab.analysis.identification.friction_curve import FrictionCurve, FrictionFit, fit_friction
from contourlab.features.identify.finding import Carried, Drawn, Figure, Finding, Graph, Picture, Row, Tables, carried, of_command, told
from contourlab.features.identify.signals import AxisRecord, fits_a_plant, no_plant, one_unit, source_of, sources_of
from contourlab.features.identify.ways import on_ways
from contourlab.logs.error_context import about

DIP, RISE = "stribeck_velocity", "rise_velocity"
"""Speed of the bend as the components of a dip and of a rise call it."""
UNEVEN = 0.1
"""Variation of the speed within stretches, on the median, from which they are none of constant speed; ripple of a ball screw makes 0.06."""


def identify_friction(records: Sequence[AxisRecord]) -> Finding:
    """Fit a friction curve to the constant speeds of one or several logs of an axis.

    Parameters
    ----------
    records : sequence of AxisRecord
        With the force or the command.

    Raises
    ------
    ResultError
        If a log has no command, or the logs' commands are in different units.
    LogError
        If the signals of a record are not finite; says which.
    ParameterError
        If there are fewer than three stretches of constant speed, or what drives the axis helps its motion.
    """
    unit = one_unit(records, "one friction curve")
    stretches: list[Stretch] = []
    for record in records:
        with about(record.source):
            stretches += constant_speed_stretches(
                record.period, record.position, record.driven(), record.reference, record.source
            )
    heard = {stretch.source for stretch in stretches}
    silent = [source for source in sources_of(records) if source not in heard]
    fit = fit_friction(*_points(stretches))
    uneven = float(np.median([stretch.unevenness for stretch in stretches]))
    usable = fit.usable and uneven <= UNEVEN
    remarks = [*fit.remarks, *_by_log(records)]
    remarks += [f"no constant speed in {', '.join(silent)}"] if silent else []
    if uneven > UNEVEN:
        remarks.append(
            f"the speeds are not constant, on the median they vary by {100.0 * uneven:.2g} % within: mass counts as friction there"
        )
    shown = _writable(fit) if usable else None
    worth = Carried({}, ()) if shown is None else _worth(shown)
    if shown is not None and not fits_a_plant(unit):
        remarks.append(no_plant(unit))
        shown = None
    elif shown is not fit.chosen and shown is not None:
        remarks.append(f"the curve is below zero at rest: an axis file is given {shown.name}, fit {shown.fit:.4g} %")
    if shown is not None:
        remarks += on_ways(_values(shown), _units(unit))
    if shown is not None and _mean(_values(shown), "Fv") > 0.0:
        remarks.append("the axis file has the viscous friction in its table friction: the damping of the plant beside it is to be 0")
    curve = fit.chosen
    return Finding(
        "friction",
        records[0].axis,
        sources_of(records),
        _figures(curve, unit),
        curve.fit,
        usable,
        tuple(remarks),
        _tables(shown, unit, records, worth) if shown is not None else {},
        _pictures(curve, stretches, unit, records[0].axis),
        _lines(stretches, unit),
        _more(fit, stretches, unit),
        worth.correlations if shown is not None else (),
    )


def _points(stretches: Sequence[Stretch]) -> tuple[list[float], list[float], list[float]]:
    return [s.speed for s in stretches], [s.command for s in stretches], [s.deviation for s in stretches]


def _by_log(records: Sequence[AxisRecord]) -> list[str]:
    bare = sources_of([record for record in records if record.reference is None])
    how = f"constant speed is told from the position, where it lasts over {100.0 * LEAST_TRAVEL:g} % of the way or more"
    return [f"no reference in {', '.join(bare)}: {how}; where there is a reference, give its column"] if bare else []


def _units(unit: str) -> dict[str, str]:
    force = unit or "command"
    plain = dict.fromkeys(("Fc", "Fc+", "Fc-", "drop", "drop+", "drop-", "offset"), force)
    return {**plain, **dict.fromkeys(("Fv", "Fv+", "Fv-"), f"{force}*s/m"), "vs": "m/s"}


def _figures(curve: FrictionCurve, unit: str) -> tuple[Figure, ...]:
    units = _units(unit)
    rows = zip(curve.names, curve.values.tolist(), curve.deviations.tolist(), strict=True)
    return tuple(Figure(name, value, units[name], deviation, deviation) for name, value, deviation in rows)


def _lines(stretches: Sequence[Stretch], unit: str) -> tuple[str, ...]:
    rows = [f"speed [mm/s]  mean [{unit}]  deviation  scatter within  samples  log"]
    for s in sorted(stretches, key=lambda s: s.speed):
        rows.append(f"{1e3 * s.speed:12.4g}  {s.command:8.4g}  {s.deviation:9.2g}  {s.scatter:14.3g}  {s.count:7d}  {s.source}")
    return tuple(rows)


def _more(fit: FrictionFit, stretches: Sequence[Stretch], unit: str) -> dict[str, object]:
    return {
        "friction_model": fit.chosen.name,
        "scatter_between_runs": fit.chosen.scatter,
        "points": [
            {
                "speed": s.speed,
                "command": s.command,
                "deviation": s.deviation,
                "scatter": s.scatter,
                "samples": s.count,
                "log": s.source,
                "unit": unit,
            }
            for s in stretches
        ],
        "tried": [
            {
                "model": curve.name,
                "aicc": curve.criterion if np.isfinite(curve.criterion) else None,
                "fit_percent": curve.fit,
                "parameters": dict(zip(curve.names, curve.values.tolist(), strict=True)),
            }
            for curve in fit.tried
        ],
    }


def _writable(fit: FrictionFit) -> FrictionCurve | None:
    """Return the curve that a friction component can have: the chosen one, or one that does not bend where that is below zero at rest."""
    x = _values(fit.chosen)
    if not fit.chosen.model.stribeck or _mean(x, "Fc") + _mean(x, "drop") >= 0.0:
        return fit.chosen
    plain = [curve for curve in fit.tried if not curve.model.stribeck]
    return min(plain, key=lambda curve: curve.criterion) if plain else None


def _mean(x: Mapping[str, float], name: str) -> float:
    """Return a parameter, over both directions where it has one each; 0 for one that the curve lacks."""
    return 0.5 * (x[f"{name}+"] + x[f"{name}-"]) if f"{name}+" in x else x.get(name, 0.0)


def _numbers(x: Mapping[str, float], rises: bool) -> dict[str, float]:
    """Return the numbers of the axis file: a component has one friction for both directions, and what differs in level is an offset."""
    found = {"friction.coulomb": max(_mean(x, "Fc"), 0.0), "friction.viscous": max(_mean(x, "Fv"), 0.0)}
    if "vs" in x:
        found |= {"friction.breakaway": _mean(x, "Fc") + _mean(x, "drop"), f"friction.{RISE if rises else DIP}": x["vs"]}
    offset = 0.5 * (x["Fc+"] - x["Fc-"]) if "Fc+" in x else x.get("offset", 0.0)
    return {**found, "disturbance.force": -offset}


def _values(curve: FrictionCurve) -> dict[str, float]:
    return dict(zip(curve.names, curve.values.tolist(), strict=True))


def _worth(curve: FrictionCurve) -> Carried:
    """Return what the numbers of the axis file are worth."""
    rises = curve.rises
    return carried(lambda x: _numbers(x, rises), curve.names, curve.values, curve.deviations, curve.correlation)


def _tables(curve: FrictionCurve, unit: str, records: Sequence[AxisRecord], worth: Carried) -> Tables:
    source = source_of(records)
    shown = unit or "full_scale"
    units = {"friction.viscous": f"{shown}*s/m", f"friction.{DIP}": "m/s", f"friction.{RISE}": "m/s"}
    kind: Row = ("rising" if curve.rises else "coulomb", "", None)
    tables: dict[str, dict[str, Row]] = {"friction": {"kind": kind}, "disturbance": {"kind": ("constant", "", None)}}
    for name, value in _numbers(_values(curve), curve.rises).items():
        table, _, key = name.partition(".")
        note = "offset of the command" if table == "disturbance" else "constant speeds"
        tables[table][key] = (value, units.get(name, shown), told(source, worth.deviations[name], note))
    return tables


def _pictures(curve: FrictionCurve, stretches: Sequence[Stretch], unit: str, axis: str) -> tuple[Picture, ...]:
    v, u, s = (np.array(values) for values in _points(stretches))
    label = "mean force [N]" if unit == "N" else f"mean {of_command(unit)}"
    top = 1.05 * float(np.abs(v).max())
    lowest = float(np.abs(v).min())
    ways = [way for way in (-1.0, 1.0) if np.any(way * v > 0.0)]
    line = np.concatenate([part for way in ways for part in (way * np.linspace(0.2 * lowest, top, 200), [np.nan])])
    model = curve.at(np.where(np.isnan(line), top, line))
    model[np.isnan(line)] = np.nan
    rest = u - curve.predicted
    curves: dict[str, Drawn] = {"measured, two deviations": (1e3 * v, u, 2.0 * s), curve.name: (1e3 * line, model)}
    over = of_command(unit).replace("command", "residual")
    left = Graph("velocity [mm/s]", over, {"residual, two deviations": (1e3 * v, rest, 2.0 * s)})
    title = f"Friction of axis {axis} at constant speed"
    return (Picture("friction", title, (Graph("velocity [mm/s]", label, curves),)), Picture("residual", "What the curve leaves", (left,)))
