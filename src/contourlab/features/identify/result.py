"""Result of an identification: parameters with deviations, findings, pictures, tables of an axis file; as text, JSON and files."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.analysis.identification.least_squares import Estimate
from contourlab.app.json_values import HIDDEN, json_values
from contourlab.app.results import write_together
from contourlab.app.session import Answer, Asked
from contourlab.components.origin import Origin
from contourlab.findings import Finding
from contourlab.logs.reading import join_names
from contourlab.rendering.charts import Chart
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result.stamp import current
from contourlab.scenario.provenance import origin_table
from contourlab.scenario.toml_text import Noted, toml
from contourlab.units import from_si

Row = tuple[Any, str, Origin | None]
"""A value in SI, its unit, and its origin (None for words, lists and whole numbers)."""
Tables = dict[str, dict[str, Row]]
"""Rows of an axis file, or of a machine or controller file, by table, such as ``"axes.x.plant"``, and key."""
Numbers = Callable[[Mapping[str, float]], Mapping[str, float]]
"""From the parameters of a fit to those of an axis file, such as ``"plant.mass"``, both by name."""
AT_BOUND = "at the bound of the search: the log does not determine it"
SHOWN = {"m": "um", "m/s": "m/min"}


@dataclass(frozen=True)
class Figure:
    """An identified parameter.

    Attributes
    ----------
    value : float
        In SI.
    deviation : float
        Standard deviation for a white residual; nan at the bound of the search.
    robust_deviation : float
        Standard deviation for a correlated residual.
    """

    value: float
    unit: str
    deviation: float
    robust_deviation: float


@dataclass(frozen=True, eq=False)
class Identification(Answer):
    """An identified axis.

    Attributes
    ----------
    fit_percent : float or None
        ``100 (1 - |measured - model|/|measured - mean|)``; None if nothing is fitted.
    usable : bool
        Whether the parameters are usable; if not, no axis file is written.
    details : mapping
        Further results of the model.
    axis_file : Path or None
        The file that was written, if any.
    lines : tuple of str
        Further lines of text.
    points : Table or None
        Table printed below the lines.
    tables : Tables
        Tables of the axis file, or of the machine file; empty if there is none.
    controller : Tables
        Tables of a controller file, which is written with it.
    correlations : tuple of (str, str, float)
        Correlations between parameters of the axis file, such as ``"plant.mass"``.
    wanted : Path or None
        Axis file that was asked for; written only if the parameters are usable.
    plots : tuple of Path
        Pictures that were written.
    """

    model: str
    axis: str
    logs: tuple[str, ...]
    parameters: dict[str, Figure]
    fit_percent: float | None
    usable: bool
    findings: tuple[Finding, ...] = ()
    details: Mapping[str, Any] = field(default_factory=dict)
    axis_file: Path | None = None
    lines: tuple[str, ...] = field(default=(), metadata=HIDDEN)
    points: Table | None = field(default=None, metadata=HIDDEN)
    tables: Tables = field(default_factory=dict, metadata=HIDDEN)
    controller: Tables = field(default_factory=dict, metadata=HIDDEN)
    correlations: tuple[tuple[str, str, float], ...] = field(default=(), metadata=HIDDEN)
    charts: tuple[Chart, ...] = field(default=(), metadata=HIDDEN, repr=False)
    inputs: tuple[str | os.PathLike[str], ...] = field(default=(), metadata=HIDDEN, repr=False)
    wanted: Path | None = field(default=None, metadata=HIDDEN)
    plots: tuple[Path, ...] = field(default=(), metadata=HIDDEN)

    @property
    def passed(self) -> bool:
        """Whether the parameters are usable, and the file that was asked for is written."""
        return self.usable and (self.axis_file is not None or self.wanted is None)

    @property
    def text(self) -> str:
        """Parameters, fit, findings and files."""
        parts = [f"{join_names(self.logs)}, axis {self.axis}, model {self.model}"]
        if self.parameters:
            heads = ("value", "deviation", "robust", "robust [%]")
            rows = []
            for name, x in self.parameters.items():
                share = 100.0 * x.robust_deviation / abs(x.value) if x.value else math.inf
                cells = f"{x.deviation:.3g}", f"{x.robust_deviation:.3g}", f"{share:.2g}"
                rows.append((name, f"{x.value:.6g}", *(("-",) * 3 if math.isnan(x.robust_deviation) else cells), x.unit))
            parts.append(Table([Column("parameter", left=True), *map(Column, heads), Column("unit", left=True)], rows=rows).text())
        parts += [] if self.fit_percent is None else [f"fit {self.fit_percent:.4g} %"]
        parts += self.lines
        parts += [] if self.points is None else [self.points.text()]
        body = "\n".join([*parts, paragraphs(map(str, self.findings))]).rstrip()
        lines = [body, *(f"plot: {file}" for file in self.plots)]
        if self.axis_file is not None:
            kind = "machine" if self.controller else "axis"
            lines.append(f"{kind} file: {self.axis_file}")
            lines += [f"controller file: {_beside(self.axis_file)}"] if self.controller else []
        elif self.wanted is not None:
            why = f"these logs give no axis file for model {self.model}" if self.usable else "the results are not usable"
            lines.append(f"{self.wanted} not written: {why}")
        elif self.usable and self.tables:
            lines.append("no axis file: name one with --write")
        return "\n".join(lines)

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The parameters, one a row."""
        return [{"parameter": name, **json_values(parameter)} for name, parameter in self.parameters.items()]

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
        drawn = self._put(folder, plots, self.inputs)
        wanted = None if write is None else Path(write)
        file = wanted if self.usable and self.tables else None
        if file is not None:
            texts: dict[Path, str | bytes] = {file: self.axis_text()}
            texts |= {_beside(file): self._text_of(self.controller, {})} if self.controller else {}
            write_together(texts, self.inputs, "--write")
        return replace(self, wanted=wanted, axis_file=file, plots=drawn)

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Write the axis file, if there is one, or look at it."""
        if self.axis_file is not None:
            return ["machines", self.axis_file]
        return asked.again("--write", "axis.toml") if self.tables and self.usable else None

    def axis_text(self) -> str:
        """Return the text of the axis file, with the origin of each number."""
        correlations = [list(pair) for pair in self.correlations]
        return self._text_of(self.tables, {"correlations": Noted(correlations, "of parameters fitted together")} if correlations else {})

    def _text_of(self, rows_of: Tables, first: Mapping[str, Any]) -> str:
        """Return the text of a file with these tables."""
        tables: dict[str, Any] = dict(first)
        for name, rows in rows_of.items():
            table = tables
            for part in name.split("."):
                table = table.setdefault(part, {})
            for key, (value, unit, origin) in rows.items():
                table[key] = value if origin is None else _number(key, value, unit, origin)
        fit = "" if self.fit_percent is None else f": fit {self.fit_percent:.4g} %"
        head = [f"# Axis {self.axis}, model {self.model}, identified from {join_names(self.logs)}{fit}.", f"# {current()}"]
        if not tables.keys() & {"plant", "machine", "controller"}:
            head.append("# Part of an axis file: add the tables that these logs do not give.")
        head += [f"# {finding}" for finding in self.findings if not "CL419" <= finding.code <= "CL449"]  # not those on reading
        return "\n".join(head) + "\n\n" + toml(tables)


def _beside(file: Path) -> Path:
    """Return the controller file that goes with a machine file."""
    return file.with_name(f"{file.stem}-controller.toml")


def _number(key: str, value: Any, unit: str, origin: Origin) -> Noted:
    shown = "mm/s" if key.endswith("_velocity") else SHOWN.get(unit, unit)

    def quantity(number: float, digits: int = 3) -> str:
        return f"{from_si(number, shown):.{digits}g} {shown}".strip()

    return Noted(origin_table(quantity(value, 6), origin, quantity))


def figures(estimate: Estimate, units: Mapping[str, str]) -> dict[str, Figure]:
    """Return the parameters of a fit by name; units are by name without the sign of a direction."""
    pairs = zip(estimate.parameters.items(), estimate.deviations.tolist(), estimate.robust_deviations.tolist(), strict=True)
    return {
        name: Figure(value, units[name.rstrip("+-")], white or math.nan, coloured or math.nan) for (name, value), white, coloured in pairs
    }


@dataclass(frozen=True, eq=False)
class Propagated:
    """Uncertainty of the parameters of an axis file, by name: deviations, and correlations of pairs; the log, and a note on the method."""

    deviations: Mapping[str, float] = field(default_factory=dict)
    correlations: tuple[tuple[str, str, float], ...] = ()
    log: str = ""
    note: str = ""

    def origin(self, name: str, note: str = "") -> Origin:
        """Return the origin of a parameter: fitted, or assumed if the fit lacks it, or if it is at its bound and so has no deviation."""
        deviation = self.deviations.get(name)
        if deviation is None or not deviation > 0.0:
            return Origin("assumed", reference=self.log, note="not visible in the log" if deviation is None else AT_BOUND)
        return fitted(self.log, deviation, note or self.note)


def propagate(numbers: Numbers, estimate: Estimate, log: str = "", note: str = "") -> Propagated:
    """Propagate the uncertainty of fitted parameters to the parameters of an axis file.

    Parameters
    ----------
    numbers : callable
        See `Numbers`.
    estimate : Estimate
        A parameter without a robust deviation, for example at its bound, adds nothing.
    log, note : str
        Log of the fit, and its method.

    Notes
    -----
    First order: S = D C D', where D is the effect of one deviation of each fitted parameter on those of the axis file.
    """
    columns, small = [], 1e-3
    for step in small * np.diag(estimate.robust_deviations):
        up, down = (numbers(dict(zip(estimate.names, (estimate.values + sign * step).tolist(), strict=True))) for sign in (1.0, -1.0))
        columns.append([(up[name] - down[name]) / (2.0 * small) for name in up])
    effect = np.array(columns).T
    covariance = effect @ estimate.correlation @ effect.T
    sizes = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    of = list(numbers(estimate.parameters))
    known = np.flatnonzero((sizes > 0.0) & (sizes < np.inf)).tolist()
    pairs = ((of[i], of[j], round(float(covariance[i, j] / (sizes[i] * sizes[j])), 4)) for i, j in combinations(known, 2))
    return Propagated(dict(zip(of, sizes.tolist(), strict=True)), tuple(pair for pair in pairs if pair[2]), log, note)


def fitted(log: str, deviation: float, note: str = "") -> Origin:
    """Return the origin of a parameter fitted to a log; only a finite deviation > 0 is kept."""
    return Origin("fitted", deviation=deviation if 0.0 < deviation < math.inf else None, reference=log, note=note)


def assumed(note: str) -> Origin:
    """Return the origin of a parameter that the log does not give."""
    return Origin("assumed", note=note)
