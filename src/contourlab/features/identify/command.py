"""``contourlab identify``: the model of an axis out of measured logs, as text, JSON, pictures and an axis file."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import nullcontext
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from contourlab.app.json_values import json_values
from contourlab.app.results import check_file, staged
from contourlab.components.origin import Origin
from contourlab.features.identify.finding import Figure, Finding, Picture
from contourlab.features.identify.requests.register import study_of
from contourlab.features.identify.requests.request import Request, listed
from contourlab.features.run.command import check_plots
from contourlab.result import write_text_atomic
from contourlab.scenario.provenance import origin_table
from contourlab.scenario.toml_text import Noted, toml
from contourlab.units import from_si

SHOWN = {"m": "um", "m/s": "m/min"}


@dataclass(frozen=True)
class Identification:
    """What the command prints: whether the figures can be used and the file that was asked for is written, a summary, and text."""

    done: bool
    summary: dict[str, Any]
    text: str


def identify_log(
    request: Request, *, out: str | Path | None = None, plots: Sequence[str] = (), folder: str | Path = "results"
) -> Identification:
    """Identify an axis and write the file of an axis that it makes.

    Parameters
    ----------
    request : Request
        Model, logs and options.
    out : str or Path, optional
        The axis file; none is written by default, nor where the figures are unusable.
    plots : sequence of str
        png, svg or pdf, into ``plots`` in `folder`; what else is there stays.
    folder : str or Path

    Raises
    ------
    LogError, ResultError
        If a log cannot be read or lacks a signal, or the axis cannot be identified from the logs; says which.
    ParameterError
        If an option is out of range, or `out` is a file that is read.
    OutputError
        If `out` or `folder` cannot be written; found before a log is read.
    """
    check_plots(plots)
    study = study_of(request)
    if out is not None:
        check_file(out, request.inputs)
    with staged(folder, inputs=request.inputs, option="--folder") if plots else nullcontext() as stage:
        with request.about():
            found = study(request)
        found = replace(found, remarks=(*found.remarks, *request.doubts))
        text = _text(found, request.notes)
        if stage is not None:
            text += "".join(f"\nplot: {Path(folder) / file.relative_to(stage)}" for file in _draw(found, stage / "plots", plots))
    written = out is not None and found.usable and bool(found.tables)
    if out is not None and written:
        write_text_atomic(Path(out), axis_file(found))
        text += f"\naxis file: {out}"
    elif out is not None:
        why = "the figures cannot be used as they stand" if not found.usable else f"there is nothing for an axis file (model {found.model})"
        text += f"\n{out} is not written: {why}"
    summary = {**_summary(found), "notes": request.notes, "axis_file": str(out) if written else None}
    return Identification(found.usable and (written or out is None), json_values(summary), text)


def axis_file(found: Finding) -> str:
    """Return the text of the axis file, with where each number is from behind it."""
    together = [list(one) for one in found.correlations]
    tables: dict[str, Any] = {"correlations": Noted(together, "of what was fitted together")} if together else {}
    for name, rows in found.tables.items():
        tables[name] = {key: value if origin is None else _number(key, value, unit, origin) for key, (value, unit, origin) in rows.items()}
    worth = "" if found.fit is None else f": fit {found.fit:.4g} %"
    head = [f"# Axis {found.axis}, model {found.model}, identified from {listed(found.sources)}{worth}."]
    if "plant" not in tables:
        head.append("# Tables of an axis file; what is not in these logs is to be added.")
    head += [f"# {remark}" for remark in found.remarks]
    return "\n".join(head) + "\n\n" + toml(tables)


def _number(key: str, value: Any, unit: str, origin: Origin) -> Noted:
    shown = "mm/s" if key.endswith("_velocity") else SHOWN.get(unit, unit)
    return Noted(origin_table(f"{from_si(value, shown):.6g} {shown}", origin, lambda number: f"{from_si(number, shown):.3g} {shown}"))


def _text(found: Finding, notes: Sequence[str]) -> str:
    rows = [("parameter", "value", "unit", "deviation", "with colour", "%"), *(_cells(figure) for figure in found.figures)]
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    lines = [f"{listed(found.sources)}, axis {found.axis}"]
    rows = rows if found.figures else []
    lines += ["  ".join(c.ljust(w) if i in (0, 2) else c.rjust(w) for i, (c, w) in enumerate(zip(r, widths, strict=True))) for r in rows]
    lines += [*([f"fit {found.fit:.4g} %"] if found.fit is not None else []), *found.lines]
    lines += [f"note: {remark}" for remark in (*found.remarks, *notes)]
    return "\n".join(lines)


def _cells(figure: Figure) -> tuple[str, ...]:
    share = 100.0 * figure.robust_deviation / abs(figure.value) if figure.value else float("inf")
    told = (f"{figure.deviation:.3g}", f"{figure.robust_deviation:.3g}", f"{share:.2g}")
    numbers = told if figure.robust_deviation else ("-", "-", "-")
    return (figure.name, f"{figure.value:.6g}", figure.unit, *numbers)


def _summary(found: Finding) -> dict[str, Any]:
    return {
        "log": found.sources[0],
        "logs": list(found.sources),
        "axis": found.axis,
        "model": found.model,
        "parameters": {
            figure.name: {
                "value": figure.value,
                "unit": figure.unit,
                "deviation": figure.deviation or None,
                "robust_deviation": figure.robust_deviation or None,
            }
            for figure in found.figures
        },
        "fit_percent": found.fit,
        "usable": found.usable,
        "remarks": list(found.remarks),
        **found.more,
    }


def _draw(found: Finding, folder: Path, plots: Sequence[str]) -> tuple[Path, ...]:
    from contourlab.report.plots import write_charts

    return write_charts([_chart(picture) for picture in found.pictures], folder, plots)


def _chart(picture: Picture) -> Any:
    from contourlab.report.charts import Chart, Curve, Level, Panel
    from contourlab.report.style import scheme_style

    # One name, one look, in all graphs of a picture: their legends are one.
    names = list(dict.fromkeys(name for graph in picture.graphs for name in graph.curves))
    looks = {name: scheme_style(i, max(len(names), 2)) for i, name in enumerate(names)}
    panels = []
    for graph in picture.graphs:
        curves = tuple(
            Curve(*drawn[:2], name, *looks[name], half=drawn[2] if len(drawn) == 3 else None) for name, drawn in graph.curves.items()
        )
        levels = () if graph.log_x else (Level(0.0, ""),)
        panels.append(Panel(graph.x_label, graph.y_label, curves, levels, log_x=graph.log_x, log_y=graph.log_y))
    return Chart(picture.key, picture.title, picture.caption, tuple(panels))
