"""``contourlab identify``: the model of an axis from measured logs, as text, JSON, pictures and an axis file."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import nullcontext
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from contourlab.app.json_values import json_values
from contourlab.app.results import check_file, staged
from contourlab.components.origin import Origin
from contourlab.features.identify.request import Request
from contourlab.features.identify.result import Identified, Picture, join_names
from contourlab.features.run.command import check_plots
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result import write_text_atomic
from contourlab.scenario.provenance import origin_table
from contourlab.scenario.toml_text import Noted, toml
from contourlab.units import from_si

SHOWN = {"m": "um", "m/s": "m/min"}


@dataclass(frozen=True)
class Identification:
    """Output of the command.

    Attributes
    ----------
    done : bool
        Whether the parameters are usable and the requested file is written.
    """

    done: bool
    summary: dict[str, Any]
    text: str


def identify_log(
    request: Request, *, out: str | Path | None = None, plots: Sequence[str] = (), folder: str | Path = "results"
) -> Identification:
    """Identify an axis and write its axis file.

    Parameters
    ----------
    request : Request
        Model, logs and options.
    out : str or Path, optional
        Axis file; written only if the parameters are usable.
    plots : sequence of str
        Formats: png, svg or pdf. Plots go to ``plots`` in `folder`; other files there stay.

    Raises
    ------
    LogError, ResultError
        If a log cannot be read or lacks a signal, or the axis cannot be identified; names the log.
    ParameterError
        If an option is out of range, or `out` is also an input file.
    OutputError
        If `out` or `folder` cannot be written; raised before a log is read.
    """
    check_plots(plots)
    request.check()
    if out is not None:
        check_file(out, request.inputs)
    drawn: list[Path] = []
    with staged(folder, inputs=request.inputs) if plots else nullcontext() as stage:
        identified = request.identify()
        if stage is not None:
            from contourlab.rendering.plots import write_charts

            files = write_charts([_chart(picture) for picture in identified.pictures], stage / "plots", plots)
            drawn = [Path(folder) / file.relative_to(stage) for file in files]
    lines = [_text(identified), *(f"plot: {file}" for file in drawn)]
    written = out is not None and identified.usable and bool(identified.tables)
    if out is not None and written:
        write_text_atomic(Path(out), axis_file(identified))
        lines.append(f"axis file: {out}")
    elif out is not None:
        why = f"these logs give no axis file for model {identified.model}" if identified.usable else "the results are not usable"
        lines.append(f"{out} not written: {why}")
    elif identified.usable and identified.tables:
        lines.append("no axis file: name one with --write")
    summary = json_values(replace(identified, axis_file=Path(out) if out is not None and written else None))
    return Identification(identified.usable and (written or out is None), summary, "\n".join(lines))


def axis_file(identified: Identified) -> str:
    """Return the text of the axis file, with the origin of each number."""
    correlations = [list(pair) for pair in identified.correlations]
    tables: dict[str, Any] = {"correlations": Noted(correlations, "of parameters fitted together")} if correlations else {}
    for name, rows in identified.tables.items():
        tables[name] = {key: value if origin is None else _number(key, value, unit, origin) for key, (value, unit, origin) in rows.items()}
    fit = "" if identified.fit_percent is None else f": fit {identified.fit_percent:.4g} %"
    head = [f"# Axis {identified.axis}, model {identified.model}, identified from {join_names(identified.logs)}{fit}."]
    if "plant" not in tables:
        head.append("# Part of an axis file: add the tables that these logs do not give.")
    head += [f"# {finding}" for finding in identified.findings if not "CL419" <= finding.code <= "CL449"]  # not those on reading
    return "\n".join(head) + "\n\n" + toml(tables)


def _number(key: str, value: Any, unit: str, origin: Origin) -> Noted:
    shown = "mm/s" if key.endswith("_velocity") else SHOWN.get(unit, unit)

    def quantity(number: float, digits: int) -> str:
        return f"{from_si(number, shown):.{digits}g} {shown}".strip()

    return Noted(origin_table(quantity(value, 6), origin, lambda number: quantity(number, 3)))


def _text(identified: Identified) -> str:
    parts = [f"{join_names(identified.logs)}, axis {identified.axis}, model {identified.model}"]
    if identified.parameters:
        heads = ("value", "deviation", "robust", "robust [%]")
        table = Table([Column("parameter", left=True), *(Column(head) for head in heads), Column("unit", left=True)])
        for name, x in identified.parameters.items():
            share = 100.0 * x.robust_deviation / abs(x.value) if x.value else math.inf
            deviations = (x.deviation, x.robust_deviation, share)
            cells = ("-",) * 3 if math.isnan(x.robust_deviation) else (f"{value:.{2 + (i < 2)}g}" for i, value in enumerate(deviations))
            table.add(name, f"{x.value:.6g}", *cells, x.unit)
        parts.append(table.text())
    parts += [] if identified.fit_percent is None else [f"fit {identified.fit_percent:.4g} %"]
    parts += identified.lines
    parts += [] if identified.points is None else [identified.points.text()]
    return "\n".join([*parts, paragraphs(map(str, identified.findings))]).rstrip()


def _chart(picture: Picture) -> Any:
    from contourlab.rendering.charts import Chart, Curve, Level, Panel
    from contourlab.rendering.style import scheme_style

    # A name looks the same in all graphs: they share the legend.
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
