"""Results of ``measure`` and of ``compare`` for logs as summary.json: one object for each run, in SI."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from contourlab import __version__
from contourlab.features.run.summary import SCHEMA
from contourlab.findings import Finding
from contourlab.logs.clock import ClockReport
from contourlab.logs.mapping import Column
from contourlab.metrics import CircleFigures, Metrics, ReversalFigures, Spike


@dataclass(frozen=True)
class MeasuredScheme:
    """One measured run.

    Attributes
    ----------
    file : Path
        The log.
    format : str
        Format of the log.
    servo_period : float [s]
    shift : mapping of str to float [m], or None
        Shift of the path in the coordinates of the log, by axis; null without --shift.
    circles : tuple of CircleFigures
        Each full circle of the path, with the figures of ISO 230-4.
    clock : mapping of str to ClockReport
        Clock by column.
    columns : tuple of Column
        Columns used.
    notes : tuple of str
        Texts of the findings.
    """

    file: Path
    format: str
    axes: tuple[str, ...]
    servo_period: float
    n_sample: int
    shift: Mapping[str, float] | None
    metrics: Metrics
    circles: tuple[CircleFigures, ...]
    reversals: tuple[Spike, ...]
    reversal_figures: tuple[ReversalFigures, ...]
    clock: Mapping[str, ClockReport]
    columns: tuple[Column, ...]
    notes: tuple[str, ...]
    findings: tuple[Finding, ...]


@dataclass(frozen=True)
class MeasuredSummary:
    """The results of measured runs.

    Attributes
    ----------
    command : str
        Command line as typed.
    tolerance : float or None [m]
    passed : bool or None
        Whether the largest contour error of each run is within the tolerance; null without one.
    schemes : mapping of str to MeasuredScheme
        Runs by name.
    version : str
        Version of contourlab.
    """

    name: str
    command: str
    tolerance: float | None
    passed: bool | None
    schemes: Mapping[str, MeasuredScheme]
    schema: str = SCHEMA
    version: str = __version__
