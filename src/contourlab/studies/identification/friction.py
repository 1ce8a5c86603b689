"""The friction curve of an axis out of runs at constant speeds."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from contourlab.analysis.constant_speed import Stretch, StretchSettings, constant_speed_stretches
from contourlab.analysis.friction_curve import FrictionCurve, FrictionFit, fit_friction
from contourlab.components.origin import Origin
from contourlab.errors import ResultError
from contourlab.studies.identification.finding import Figure, Finding, Graph, Picture, Row, Tables, bars, fitted
from contourlab.studies.identification.signals import AxisRecord

__all__ = ["identify_friction"]


def identify_friction(records: Sequence[AxisRecord], settings: StretchSettings | None = None) -> Finding:
    """Fit a friction curve to the constant speeds of one or several logs of an axis.

    Parameters
    ----------
    records : sequence of AxisRecord
        With the force or the command.
    settings : StretchSettings, optional

    Raises
    ------
    ResultError
        If a log has no command, or the logs' commands are in different units.
    ParameterError
        If there are fewer than three stretches of constant speed, or what drives the axis helps its motion.
    """
    units = {record.unit for record in records}
    if len(units) > 1:
        raise ResultError(f"commands in {' and '.join(sorted(units))}: logs of one friction curve have one unit")
    stretches: list[Stretch] = []
    silent = []
    for record in records:
        found = constant_speed_stretches(record.period, record.position, record.driven(), record.reference, settings, record.source)
        stretches += found
        silent += [] if found else [record.source]
    fit = fit_friction(*_points(stretches))
    unit = units.pop()
    remarks = [*fit.remarks, *_by_log(records)]
    remarks += [f"no constant speed in {', '.join(silent)}"] if silent else []
    shown = _writable(fit)
    if shown is not fit.chosen and shown is not None:
        remarks.append(
            f"an axis file's friction does not rise into its Coulomb level: it is given {shown.model.name}, fit {shown.fit:.4g} %"
        )
    curve = fit.chosen
    return Finding(
        "friction",
        records[0].axis,
        tuple(record.source for record in records),
        _figures(curve, unit),
        curve.fit,
        fit.usable,
        tuple(remarks),
        _tables(shown, unit, records) if shown is not None else {},
        _pictures(curve, stretches, unit, records[0].axis),
        _lines(stretches, unit),
        _more(fit, stretches, unit),
    )


def _points(stretches: Sequence[Stretch]) -> tuple[list[float], list[float], list[float]]:
    return [s.speed for s in stretches], [s.command for s in stretches], [s.deviation for s in stretches]


def _by_log(records: Sequence[AxisRecord]) -> list[str]:
    bare = [record.source for record in records if record.reference is None]
    return [f"no reference in {', '.join(bare)}: constant speed is told from the position"] if bare else []


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
        "friction_model": fit.chosen.model.name,
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
                "model": curve.model.name,
                "aicc": curve.criterion if np.isfinite(curve.criterion) else None,
                "fit_percent": curve.fit,
                "parameters": dict(zip(curve.names, curve.values.tolist(), strict=True)),
            }
            for curve in fit.tried
        ],
    }


def _writable(fit: FrictionFit) -> FrictionCurve | None:
    """Return the curve that a friction component can have: the chosen one, or without its Stribeck part where that is none."""
    if not fit.chosen.model.stribeck or _mean(fit.chosen, "drop")[0] > 0.0:
        return fit.chosen
    plain = [curve for curve in fit.tried if not curve.model.stribeck]
    return min(plain, key=lambda curve: curve.criterion) if plain else None


def _mean(curve: FrictionCurve, name: str) -> tuple[float, float]:
    """Return a parameter, over both directions where it has one each, and its deviation."""
    if not curve.model.directed:
        return curve[name], curve.deviation(name)
    pair = (f"{name}+", f"{name}-")
    return 0.5 * sum(curve[part] for part in pair), 0.5 * math.hypot(*(curve.deviation(part) for part in pair))


def _tables(curve: FrictionCurve, unit: str, records: Sequence[AxisRecord]) -> Tables:
    source = records[0].source if len(records) == 1 else f"{records[0].source} and {len(records) - 1} more"
    shown = unit or "full_scale"

    def told(deviation: float) -> Origin:
        return fitted(source, deviation, "constant speeds")

    coulomb, spread = _mean(curve, "Fc")
    viscous, viscous_spread = _mean(curve, "Fv")
    friction: dict[str, Row] = {
        "kind": ("coulomb", "", None),
        "coulomb": (max(coulomb, 0.0), shown, told(spread)),
        "viscous": (max(viscous, 0.0), f"{shown}*s/m", told(viscous_spread)),
    }
    if curve.model.stribeck:
        drop, drop_spread = _mean(curve, "drop")
        friction["breakaway"] = (coulomb + drop, shown, told(float(np.hypot(spread, drop_spread))))
        friction["stribeck_velocity"] = (curve["vs"], "m/s", told(curve.deviation("vs")))
    offset = 0.5 * (curve["Fc+"] - curve["Fc-"]) if curve.model.directed else curve["offset"]
    return {
        "friction": friction,
        "disturbance": {"kind": ("constant", "", None), "force": (-offset, shown, fitted(source, note="offset of the command"))},
    }


def _pictures(curve: FrictionCurve, stretches: Sequence[Stretch], unit: str, axis: str) -> tuple[Picture, ...]:
    v, u, s = (np.array(values) for values in _points(stretches))
    label = f"mean command [{unit}]" if unit != "N" else "mean force [N]"
    top = 1.05 * float(np.abs(v).max())
    lowest = float(np.abs(v).min())
    ways = [way for way in (-1.0, 1.0) if np.any(way * v > 0.0)]
    line = np.concatenate([part for way in ways for part in (way * np.linspace(0.2 * lowest, top, 200), [np.nan])])
    model = curve.at(np.where(np.isnan(line), top, line))
    model[np.isnan(line)] = np.nan
    rest = u - curve.predicted
    curves = {"measured, two deviations": bars(1e3 * v, u, 2.0 * s), curve.model.name: (1e3 * line, model)}
    left = Graph("velocity [mm/s]", f"residual [{unit}]", {"residual, two deviations": bars(1e3 * v, rest, 2.0 * s)})
    title = f"Friction of axis {axis} at constant speed"
    return (Picture("friction", title, (Graph("velocity [mm/s]", label, curves),)), Picture("residual", "What the curve leaves", (left,)))
