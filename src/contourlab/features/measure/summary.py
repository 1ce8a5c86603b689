"""Results of ``measure`` and of ``compare`` for logs as summary.json: one object for each run, in SI."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from contourlab import __version__
from contourlab.features.measure.study import Measured
from contourlab.features.run.summary import SCHEMA
from contourlab.logs import Log


@dataclass(frozen=True, eq=False, kw_only=True)
class MeasuredRun(Measured):
    """One measured run.

    Listed are the keys of its JSON, see `json_form`; its Python attributes are those of `JudgedRun`.

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

    json_form: ClassVar = {
        "file": "log.record.file",
        "format": "log.record.format",
        "axes": "result.axes",
        "servo_period": "result.servo_period",
        "n_sample": "result.n_sample",
        "shift": "shift",
        "metrics": "metrics",
        "circles": "circles",
        "reversals": "spikes",
        "reversal_figures": "reversal_figures",
        "clock": "log.clocks",
        "columns": "log.columns",
        "notes": "notes",
        "findings": "findings",
    }

    log: Log
    inputs: tuple[str | Path, ...]

    @property
    def notes(self) -> tuple[str, ...]:
        """Texts of the findings."""
        return tuple(finding.text for finding in self.findings)


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
    schemes : mapping of str to MeasuredRun
        Runs by name.
    version : str
        Version of contourlab.
    """

    name: str
    command: str
    tolerance: float | None
    passed: bool | None
    schemes: Mapping[str, MeasuredRun]
    schema: str = SCHEMA
    version: str = __version__
