"""A judged case, and the results of ``run``, ``compare``, ``learn`` and ``demo`` as summary.json: one object for each scheme, in SI."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

from contourlab import __version__
from contourlab.analysis.linear.margins import Margins
from contourlab.app.json_values import json_values
from contourlab.errors import DivergenceError
from contourlab.features.learn import LearningRun
from contourlab.feed import LimitReport
from contourlab.feed.verify import Worst
from contourlab.loop.switches import Switch, Switches
from contourlab.metrics.circles import Bidirectional, pairs
from contourlab.rendering.data import JudgedRun
from contourlab.rendering.page_tables import nearest
from contourlab.result import Status
from contourlab.scenario import Case

SCHEMA = "contourlab-summary/1"
LISTED = 100
"""Switches that are listed one by one."""


@dataclass(frozen=True)
class SwitchCount:
    """Switches of one kind: controllers before and after, reason, and how many."""

    before: str = field(metadata={"json": "from"})
    after: str = field(metadata={"json": "to"})
    reason: str
    count: int


@dataclass(frozen=True)
class AxisSwitches:
    """The switches of one axis.

    Attributes
    ----------
    count : int
    first : str
        The controller that was active at the start.
    active : mapping of str to float [s]
        Time for which each controller was active.
    kinds : tuple of SwitchCount
        The most frequent first.
    """

    count: int
    first: str
    active: Mapping[str, float]
    kinds: tuple[SwitchCount, ...]


@dataclass(frozen=True)
class SwitchSummary:
    """Switches between the controllers of an axis.

    Attributes
    ----------
    axes : mapping of str to AxisSwitches
    listed : tuple of Switch
        The first 100.
    left_out : int
        Switches that are not listed; ``switches/NAME.csv`` has them all.
    """

    axes: Mapping[str, AxisSwitches]
    listed: tuple[Switch, ...]
    left_out: int


@dataclass(frozen=True)
class NearestLimit:
    """The axis nearest to its limit, or furthest beyond.

    Attributes
    ----------
    value, limit : float [m/s, m/s^2 or m/s^3]
        The limit is null if there is none.
    ratio : float
        Value over limit, without what rounding explains; above 1 the limit is violated.
    time : float [s]
    line : int
        Program line; 0 for none.
    """

    json_form: ClassVar = (
        {"axis": "axis"} | {name: f"worst.{name}" for name in ("value", "limit", "ratio", "time")} | {"line": "worst.source_line"}
    )

    axis: str
    worst: Worst


@dataclass(frozen=True)
class LimitSummary:
    """The planned motion against the limits of the axes, checked from its samples alone; null for a kind that does not occur.

    Attributes
    ----------
    curvature_step : NearestLimit or None
        Steps of acceleration where the curvature jumps; `jerk` leaves them out.
    kink : NearestLimit or None
        Steps of velocity where the direction jumps slightly.
    """

    velocity: NearestLimit | None
    acceleration: NearestLimit | None
    jerk: NearestLimit | None
    curvature_step: NearestLimit | None
    kink: NearestLimit | None


@dataclass(frozen=True, eq=False, kw_only=True)
class Outcome(JudgedRun):
    """A judged case; of a case that learns, its best trial.

    Listed are the keys of its JSON, see `json_form`; its Python attributes are those of `JudgedRun`.

    Attributes
    ----------
    machine : str
    servo_period : float [s]
    path_digest : str
        Hash of the planned path's geometry.
    verdict : Verdict or None
        Null without a tolerance.
    circles : tuple of CircleFigures
        Each full circle of the path, with the figures of ISO 230-4.
    circles_both_ways : mapping of str to Bidirectional
        Circles that run in both directions.
    switches : SwitchSummary or None
        Null if no axis has several controllers.
    margins : mapping of str to Margins
        Of the sampled loop of each axis; all but `stable` are null if it is unstable.
    limits : LimitSummary or None
        Null under the uniform law.
    learning : LearningRun or None
        All other figures are those of its best trial.
    warnings : tuple of str
        Texts of the findings of severity "warning".
    tick : float or None [s]
        Time that one servo tick takes to compute, under `compare`.
    trust : Trust or None
        Sources of the numbers, and the interval of the part error, where asked for.
    """

    json_form: ClassVar = {
        "machine": "case.machine.name",
        "axes": "result.axes",
        "servo_period": "result.servo_period",
        "seed": "case.seed",
        "n_sample": "result.n_sample",
        "path_digest": "path_digest",
        "status": "result.status",
        "metrics": "metrics",
        "verdict": "verdict",
        "circles": "circles",
        "circles_both_ways": "circles_both_ways",
        "reversals": "spikes",
        "reversal_figures": "reversal_figures",
        "switches": "switch_summary",
        "margins": "margins",
        "limits": "limit_summary",
        "learning": "learning",
        "warnings": "warnings",
        "findings": "findings",
        "tick": "tick",
        "trust": "trust",
    }

    case: Case
    learning: LearningRun | None

    @property
    def circles_both_ways(self) -> dict[str, Bidirectional]:
        """Circles that run in both directions."""
        return pairs(self.circles)

    @property
    def margins(self) -> dict[str, Margins]:
        """Margins of the sampled loop of each axis."""
        return {axis: loop.margins for axis, loop in self.bode.items()}

    @property
    def switch_summary(self) -> SwitchSummary | None:
        """How often and why controllers were switched."""
        return None if self.switches is None else _switches(self.switches)

    @property
    def limit_summary(self) -> LimitSummary | None:
        """The axis nearest to each kind of limit."""
        return None if self.limits is None else _limits(self.limits, self.result.axes)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Texts of the findings of severity "warning"."""
        return tuple(finding.text for finding in self.findings if finding.entry.severity == "warning")


@dataclass(frozen=True)
class DivergedScheme:
    """A scheme that diverged."""

    status: Status


@dataclass(frozen=True)
class Summary:
    """The results of a command that runs schemes.

    Attributes
    ----------
    name : str
        Of the scenario.
    command : str
        What was run.
    passed : bool or None
        Whether all verdicts passed; null without a tolerance.
    schemes : mapping of str to Outcome or DivergedScheme
    notes : tuple of str
        On the motion: leniency of the program's reader, scaling, contours from files.
    version : str
        Of contourlab.
    """

    name: str
    command: str
    notes: tuple[str, ...]
    passed: bool | None
    schemes: Mapping[str, Outcome | DivergedScheme]
    schema: str = SCHEMA
    version: str = __version__


def summary_of(
    name: str, outcomes: Sequence[Outcome], command: str, diverged: Mapping[str, DivergenceError] | None = None
) -> dict[str, Any]:
    """Return the summary of a command as JSON values.

    Parameters
    ----------
    name : str
        Of the scenario.
    outcomes : sequence of Outcome
    command : str
        What was run.
    diverged : mapping of str to DivergenceError, optional
        Schemes that diverged: the summary has their status only, and has not passed.
    """
    lost = diverged or {}
    verdicts = [outcome.verdict for outcome in outcomes if outcome.verdict is not None]
    passed = False if lost else all(verdict.passed for verdict in verdicts) if verdicts else None
    schemes: dict[str, Outcome | DivergedScheme] = {outcome.name: outcome for outcome in outcomes}
    schemes |= {name: DivergedScheme(Status(False, error.sample, error.axis, str(error))) for name, error in lost.items()}
    values: dict[str, Any] = json_values(Summary(name, command, outcomes[0].case.notes if outcomes else (), passed, schemes))
    return values


def _switches(switches: Switches) -> SwitchSummary:
    """Return how often and why controllers were switched, and the first switches one by one."""
    kinds: dict[str, list[SwitchCount]] = {axis: [] for axis in switches.axes}
    for kind, count in switches.counts().items():
        kinds[kind.axis].append(SwitchCount(kind.before, kind.after, kind.reason, count))
    axes = {}
    for axis, counts in kinds.items():
        active = {name: held * switches.servo_period for name, held in switches.active[axis].items()}
        axes[axis] = AxisSwitches(sum(kind.count for kind in counts), switches.first[axis], active, tuple(counts))
    return SwitchSummary(axes, tuple(switches.rows(LISTED)), max(len(switches) - LISTED, 0))


def _limits(report: LimitReport, axes: Sequence[str]) -> LimitSummary:
    """Return for each kind of limit the axis that comes nearest to it; None where the motion has nothing of the kind."""
    worsts = map(nearest, report.kinds)
    return LimitSummary(*(None if worst is None else NearestLimit(axes[worst.axis], worst) for worst in worsts))
