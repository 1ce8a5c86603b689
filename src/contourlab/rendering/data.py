"""Data of a report, complete and read-only."""

from __future__ import annotations

import platform
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from contourlab import __version__
from contourlab.analysis.learning.learning_analysis import LearningAnalysis
from contourlab.arrays import Array, Index
from contourlab.errors import ParameterError
from contourlab.feed.verify import LimitReport
from contourlab.findings import Finding
from contourlab.geometry import Path
from contourlab.loop.switches import Switches
from contourlab.metrics import CircleFigures, Metrics, Spike
from contourlab.rendering.judgement import Trust, Verdict
from contourlab.rendering.run_data import AxisBounds, FeedRun, FrequencyResponse, TrialCourse
from contourlab.result import Result

NANOMETRE = 1e-9
"""Paths closer than this count as one: junctions may have gaps of this size."""


@dataclass(frozen=True, eq=False)
class SchemeReport:
    """One simulated or measured run.

    Parameters
    ----------
    name : str
        For example ``"without observer"``.
    result : Result
        Judged, with the signals ``contour_error`` and ``tracking_error``.
    bode : mapping of axis name to FrequencyResponse
    circle_spikes : sequence of sequence of int
        Points of each circle at which reversal spikes are highest, to be marked.
    limits : LimitReport or None
        Largest values of the planned motion against its limits; None without limits.
    trials : TrialCourse or None
        Trials of a scheme that learns; `result` is the best one.
    foretold : LearningAnalysis or None
        Prediction of its learning.
    tick : float or None [s]
        Measured computing time of a servo tick.
    switches : Switches or None
        Between controllers of an axis.
    gaps : mapping of str to (ndarray (n,), ndarray (n,)) [m]
        Load positions and the free travel there, for each axis with motor and load.
    trust : Trust or None
        Sources of the parameters, and the interval of the part error.
    lines : ndarray (n_sample,) of int, or None
        Line of the program at each sample, 0 for none.
    """

    name: str
    result: Result
    metrics: Metrics
    bounds: AxisBounds | None = None
    verdict: Verdict | None = None
    bode: Mapping[str, FrequencyResponse] = field(default_factory=dict)
    circles: Sequence[CircleFigures] = ()
    spikes: Sequence[Spike] = ()
    circle_spikes: Sequence[Sequence[int]] = ()
    limits: LimitReport | None = None
    trials: TrialCourse | None = None
    foretold: LearningAnalysis | None = None
    tick: float | None = None
    switches: Switches | None = None
    gaps: Mapping[str, tuple[Array, Array]] = field(default_factory=dict)
    trust: Trust | None = None
    findings: Sequence[Finding] = ()
    lines: Index | None = None


@dataclass(frozen=True)
class Provenance:
    """Origin of the figures; without a date, so that the same run gives the same file.

    Parameters
    ----------
    run_again : str
        Command that repeats this report from `scenario`.
    scenario : str
        As TOML.
    platform : str
        For example ``"Linux x86_64, Python 3.11.9"``.
    """

    command: str = ""
    run_again: str = ""
    scenario: str = ""
    seed: int | None = None
    version: str = __version__
    platform: str = field(default_factory=lambda: f"{platform.system()} {platform.machine()}, Python {platform.python_version()}")


@dataclass(frozen=True, eq=False)
class ReportData:
    """Everything in a report.

    Parameters
    ----------
    schemes : sequence of SchemeReport
        At least one; the others are compared with the first ("before").
    planned : Path
        The followed path.
    programmed : Path or None
        The programmed path, if it differs; the judge's ``foot_arc_length`` belongs to it.
    program : sequence of str
        Lines of the part program.
    tolerance : float [m] or None, > 0
        Largest part error that passes.
    notes : sequence of str
        On the path and the runs, for example that the path was scaled.
    feed : FeedRun or None
        Planned motion, common to all schemes.
    is_measured : bool
        Whether the runs are logs.
    next_steps : sequence of (str, str)
        What to do next, and the command for it.

    Raises
    ------
    ParameterError
        If there is no scheme, names repeat, axes differ, or the tolerance is not positive.
    """

    title: str
    schemes: Sequence[SchemeReport]
    planned: Path
    provenance: Provenance
    programmed: Path | None = None
    program: Sequence[str] = ()
    tolerance: float | None = None
    notes: Sequence[str] = ()
    feed: FeedRun | None = None
    is_measured: bool = False
    next_steps: Sequence[tuple[str, str]] = ()

    def __post_init__(self) -> None:
        if not self.schemes:
            raise ParameterError("schemes", "()", "at least one run to report")
        names = [scheme.name for scheme in self.schemes]
        if len(set(names)) < len(names):
            raise ParameterError("schemes", names, "unique names")
        axes = tuple(self.schemes[0].result.axes)
        for scheme in self.schemes:
            if tuple(scheme.result.axes) != axes:
                raise ParameterError(f"axes of {scheme.name!r}", tuple(scheme.result.axes), f"{axes}, as in the first scheme")
        if self.tolerance is not None and not 0.0 < self.tolerance < float("inf"):
            raise ParameterError("tolerance", self.tolerance, "finite and > 0", "m")

    @property
    def axes(self) -> tuple[str, ...]:
        """Names of the axes."""
        return tuple(self.schemes[0].result.axes)

    @property
    def findings(self) -> list[tuple[str, Finding]]:
        """The findings of all schemes, each with the name of its scheme."""
        return [(scheme.name, finding) for scheme in self.schemes for finding in scheme.findings]

    @property
    def asked(self) -> Path:
        """The path that the part is compared with."""
        return self.planned if self.programmed is None else self.programmed

    @property
    def is_blended(self) -> bool:
        """Whether the planned path leaves the programmed one, so that part error and contour error differ."""
        return any(scheme.metrics.planning_deviation.max > NANOMETRE for scheme in self.schemes)
