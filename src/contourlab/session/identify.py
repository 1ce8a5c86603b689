"""``contourlab identify``: an axis file out of a measured log."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from contourlab.analysis.inverse_dynamics import InverseDynamicsSettings
from contourlab.components.origin import Origin
from contourlab.errors import ParameterError, UnitError
from contourlab.result import write_text_atomic
from contourlab.scenario.provenance import origin_table
from contourlab.scenario.toml_text import Noted, toml
from contourlab.session.log_choice import LogChoice, open_log, positive
from contourlab.studies.identify import AxisFit, axis_tables, correlations, identify_rigid, units_of
from contourlab.units import from_si, split, to_si

__all__ = ["MODELS", "Identification", "identify_log"]

MODELS = {"rigid": "symmetric", "rigid-by-direction": "asymmetric"}
"""Models of an axis, and the friction that each has."""
SHOWN = {"m": "um", "m/s": "m/min"}


@dataclass(frozen=True)
class Identification:
    """What the command prints: whether the figures can be used, a summary, and text."""

    usable: bool
    summary: dict[str, Any]
    text: str


def identify_log(
    choice: LogChoice,
    *,
    model: str = "rigid",
    axis: str | None = None,
    gain: str | None = None,
    cutoff: str = "100 Hz",
    decimation: int = 10,
    validation: str | Path | None = None,
    out: str | Path | None = None,
    plots: Sequence[str] = (),
    folder: str | Path = "results",
) -> Identification:
    """Identify an axis and write the file of an axis that it makes.

    Parameters
    ----------
    choice : LogChoice
    model : str
        Of `MODELS`.
    axis : str, optional
    gain : str, optional
        Force per command, as ``"35.15 N/V"``.
    cutoff : str
        Of the low-pass of the position, as ``"100 Hz"``.
    decimation : int
    validation : str or Path, optional
        A second log, read as the first.
    out : str or Path, optional
        The axis file; none is written by default, nor where the figures are unusable.
    plots : sequence of str
        png, svg or pdf, into `folder`.

    Raises
    ------
    LogError, ResultError
        If a log cannot be read or lacks a signal.
    ParameterError
        If an option is out of range, or the axis cannot be identified from the log.
    """
    if model not in MODELS:
        raise ParameterError("--model", repr(model), f"one of {', '.join(MODELS)}")
    settings = InverseDynamicsSettings(
        MODELS[model], cutoff=positive("--cutoff", cutoff, "Hz", 'a frequency, such as "100 Hz"'), decimation=decimation
    )
    log = open_log(choice)
    second = None if validation is None else open_log(replace(choice, file=validation))
    found = identify_rigid(log, axis, _gain(gain), settings, second)
    text = _text(found, log.notes)
    if plots:
        text += "".join(f"\nplot: {file}" for file in _draw(found, folder, plots))
    if out is not None and found.fit.usable:
        write_text_atomic(Path(out), axis_file(found, model))
        text += f"\naxis file: {out}"
    elif out is not None:
        text += f"\n{out} is not written: the figures cannot be used as they stand"
    return Identification(found.fit.usable, _summary(found, model), text)


def _gain(text: str | None) -> float | None:
    if text is None:
        return None
    try:
        number, unit = split(text)
        top, _, below = unit.partition("/")
        gain = number * to_si(f"1 {top.strip()}", "N") / to_si(f"1 {below.strip()}", below.strip())
    except UnitError as error:
        raise ParameterError("--gain", repr(text), 'a force per command, such as "35.15 N/V"') from error
    if not 0.0 < abs(gain) < 1e12:
        raise ParameterError("--gain", text, "other than 0")
    return gain


def axis_file(found: AxisFit, model: str) -> str:
    """Return the text of the axis file, with where each number is from behind it."""
    listed = [list(one) for one in correlations(found)]
    tables: dict[str, Any] = {"correlations": Noted(listed, "of what was fitted together")} if listed else {}
    for name, rows in axis_tables(found).items():
        tables[name] = {key: value if origin is None else _number(value, unit, origin) for key, (value, unit, origin) in rows.items()}
    fit = found.fit
    worth = f"fit {fit.fit:.4g} %, relative error {fit.relative_error:.4g} %"
    head = [f"# Axis {found.axis}, model {model}, identified from {found.source}: {worth}."]
    head += [f"# {remark}" for remark in fit.remarks]
    return "\n".join(head) + "\n\n" + toml(tables)


def _number(value: Any, unit: str, origin: Origin) -> Noted:
    shown = SHOWN.get(unit, unit)
    return Noted(origin_table(f"{from_si(value, shown):.6g} {shown}", origin, lambda number: f"{from_si(number, shown):.3g} {shown}"))


def _text(found: AxisFit, notes: Sequence[str]) -> str:
    fit = found.fit
    rows = [("parameter", "value", "unit", "deviation", "with colour", "%")]
    for name, unit, value, white, robust in zip(
        fit.names, units_of(fit.names), fit.values, fit.deviations, fit.robust_deviations, strict=True
    ):
        share = 100.0 * robust / abs(value) if value else float("inf")
        rows.append((name, f"{value:.6g}", unit, f"{white:.3g}", f"{robust:.3g}", f"{share:.2g}"))
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    lines = [f"{found.source}, axis {found.axis}"]
    lines += ["  ".join(c.ljust(w) if i in (0, 2) else c.rjust(w) for i, (c, w) in enumerate(zip(r, widths, strict=True))) for r in rows]
    lines.append(f"fit {fit.fit:.4g} %, relative error {fit.relative_error:.4g} %, condition number {fit.condition_number:.4g}")
    if found.validation is not None:
        there = found.validation
        lines.append(f"on the second log: fit {there.fit:.4g} %, relative error {there.relative_error:.4g} %")
    lines += [f"note: {remark}" for remark in (*fit.remarks, *notes)]
    return "\n".join(lines)


def _summary(found: AxisFit, model: str) -> dict[str, Any]:
    fit = found.fit
    rows = zip(fit.names, units_of(fit.names), fit.values, fit.deviations, fit.robust_deviations, strict=True)
    return {
        "log": found.source,
        "axis": found.axis,
        "model": model,
        "parameters": {
            name: {"value": float(value), "unit": unit, "deviation": float(white), "robust_deviation": float(robust)}
            for name, unit, value, white, robust in rows
        },
        "fit_percent": fit.fit,
        "relative_error_percent": fit.relative_error,
        "condition_number": fit.condition_number,
        "usable": fit.usable,
        "remarks": list(fit.remarks),
        "validation": None
        if found.validation is None
        else {"fit_percent": found.validation.fit, "relative_error_percent": found.validation.relative_error},
    }


def _draw(found: AxisFit, folder: str | Path, plots: Sequence[str]) -> tuple[Path, ...]:
    from contourlab.report.plots import write_charts
    from contourlab.report.reproduction_pictures import traces_chart

    fit = found.fit
    force = {"measured": (fit.time, fit.force), "model": (fit.time, fit.predicted)}
    rest = fit.force - fit.predicted
    charts = [
        traces_chart("force", f"Force of axis {found.axis}, {found.source}", ("time [s]", "force [N]"), force),
        traces_chart("residual", "What the model leaves of the force", ("time [s]", "force [N]"), {"residual": (fit.time, rest)}),
        traces_chart(
            "residual-speed",
            "What the model leaves of the force, over speed",
            ("velocity [mm/s]", "force [N]"),
            {"residual": (1e3 * fit.velocity, rest)},
        ),
    ]
    return write_charts(charts, folder, plots)
