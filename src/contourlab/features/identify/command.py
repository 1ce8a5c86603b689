"""``contourlab identify``: the model of an axis from measured logs, as text, JSON, pictures and an axis file."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from contourlab.app.json_values import json_values
from contourlab.app.results import staged
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.components.origin import Origin
from contourlab.features.identify.options import Identify
from contourlab.features.identify.request import Request
from contourlab.features.identify.result import Identified, Picture, join_names
from contourlab.features.measure.log_choice import LogChoice
from contourlab.findings import Finding
from contourlab.logs import Log
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result import write_text_atomic
from contourlab.scenario.provenance import origin_table
from contourlab.scenario.toml_text import Noted, toml
from contourlab.units import from_si

SHOWN = {"m": "um", "m/s": "m/min"}


@dataclass(frozen=True, eq=False)
class Identification(Answer):
    """An identified axis.

    Attributes
    ----------
    identified : Identified
    wanted : Path or None
        Axis file that was asked for; written only if the parameters are usable.
    plots : tuple of Path
        Pictures that were written.
    """

    identified: Identified
    inputs: tuple[str | Path, ...] = field(default=(), repr=False)
    wanted: Path | None = None
    plots: tuple[Path, ...] = ()

    @property
    def passed(self) -> bool:
        """Whether the parameters are usable, and the file that was asked for is written."""
        return self.identified.usable and (self.written is not None or self.wanted is None)

    @property
    def written(self) -> Path | None:
        """The axis file that was written."""
        return self.wanted if self.identified.usable and self.identified.tables else None

    @property
    def findings(self) -> tuple[Finding, ...]:
        """What was found."""
        return self.identified.findings

    @property
    def json(self) -> Any:
        """What was identified."""
        return replace(self.identified, axis_file=self.written)

    @property
    def text(self) -> str:
        """Parameters, fit, findings and files."""
        identified = self.identified
        lines = [_text(identified), *(f"plot: {file}" for file in self.plots)]
        if self.written is not None:
            lines.append(f"axis file: {self.written}")
        elif self.wanted is not None:
            why = f"these logs give no axis file for model {identified.model}" if identified.usable else "the results are not usable"
            lines.append(f"{self.wanted} not written: {why}")
        elif identified.usable and identified.tables:
            lines.append("no axis file: name one with --write")
        return "\n".join(lines)

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The parameters, one a row."""
        return [{"parameter": name, **json_values(one)} for name, one in self.identified.parameters.items()]

    def _charts(self) -> Iterator[Any]:
        yield from map(_chart, self.identified.pictures)

    def save(self, folder: str | Path = "results", *, write: str | Path | None = None, plots: Sequence[str] = ()) -> Identification:
        """Write an axis file, if the parameters are usable, and pictures.

        Parameters
        ----------
        folder : str or Path
            Of the pictures, in ``plots``; other files there stay.
        write : str or Path, optional
            The axis file.
        plots : sequence of str
            Formats: png, svg or pdf.

        Returns
        -------
        Identification
            With the names of its files.

        Raises
        ------
        OutputError
            If a file cannot be written.
        """
        drawn: tuple[Path, ...] = ()
        if plots:
            with staged(folder, inputs=self.inputs) as stage:
                drawn = self._draw(stage, folder, plots)
        saved = replace(self, wanted=None if write is None else Path(write), plots=drawn)
        if saved.written is not None:
            write_text_atomic(saved.written, axis_file(self.identified))
        return saved

    def _next(self, asked: Asked) -> Sequence[object]:
        """Write the axis file, or look at it."""
        return asked.again("--write", "axis.toml") if self.wanted is None else ["machines", self.wanted]


@question(Identify)
def identify(*logs: str | Path | Log, settings: Identify, session: Session = QUIET) -> Identification:
    """Identify a model of an axis from logs.

    Parameters
    ----------
    *logs : str, Path or Log
        Logs of runs that excite the axis.

    Returns
    -------
    Identification

    Raises
    ------
    LogError, ResultError
        If a log cannot be read or lacks a signal, or the axis cannot be identified; names the log.
    ParameterError
        If an option is out of range.
    """
    request = Request(settings, tuple(LogChoice.of(log, settings) for log in logs))
    request.check()
    session.will_write(request.inputs, pictures_only=True)
    return Identification(request.identify(), request.inputs)


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
