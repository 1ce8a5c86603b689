"""Data of a report, complete and read-only: judged runs, the planned motion, and where they come from."""

from __future__ import annotations

import math
import platform
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from contourlab import __version__
from contourlab.analysis.learning.learning_analysis import LearningAnalysis
from contourlab.analysis.linear.margins import Margins
from contourlab.arrays import Array, Complex, Index
from contourlab.errors import ParameterError
from contourlab.feed import LimitReport, Reference
from contourlab.findings import Finding
from contourlab.geometry import Path
from contourlab.loop import Machine
from contourlab.loop.switches import Switches
from contourlab.metrics.circles import CircleFigures
from contourlab.metrics.figures import Metrics
from contourlab.metrics.reversals import ReversalFigures, Spike, reversal_figures
from contourlab.rendering.charts import LiveLoop
from contourlab.rendering.judgement import Trust, Verdict
from contourlab.rendering.margin_words import gain_words, phase_words
from contourlab.rendering.style import scheme_style
from contourlab.result import Result

NANOMETRE = 1e-9
"""Paths closer than this count as one: junctions may have gaps of this size."""


@dataclass(frozen=True, eq=False)
class ClosedLoop:
    """The closed loop of one axis, reference to position, and its margins.

    Parameters
    ----------
    frequency : ndarray (n,) [Hz], > 0, ascending
    response : ndarray of complex (n,)
        Position over reference, 1 when the axis follows exactly.
    meant : str
        Which loop of the axis the linear analysis is of, if it has several: for example ``"in contact"``.
    """

    frequency: Array
    response: Complex
    margins: Margins
    meant: str = ""

    @property
    def notes(self) -> dict[str, str]:
        """Bandwidth and margins in words."""
        margins = self.margins
        if not margins.stable:
            return {"loop": "unstable: no margins; the curve is not a real response"}
        below = np.flatnonzero(np.abs(self.response) < math.sqrt(0.5))
        bandwidth = f"{self.frequency[below[0]]:.3g} Hz" if below.size else f"above {self.frequency[-1]:.3g} Hz"
        notes = {"bandwidth (-3 dB)": bandwidth}
        if math.isfinite(margins.phase):
            notes["phase margin"] = f"{phase_words(margins.phase)} at {margins.crossover / (2.0 * math.pi):.3g} Hz"
        if math.isfinite(margins.gain):
            notes["gain margin"] = f"{gain_words(margins.gain)} at {margins.phase_crossover / (2.0 * math.pi):.3g} Hz"
        return notes | {"modulus margin": f"{margins.modulus:.3g}"}


@dataclass(frozen=True, eq=False)
class FeedRun:
    """A planned motion along its path.

    Parameters
    ----------
    arc_length : ndarray (n,) [m]
        Ascending.
    feedrate : ndarray (n,) [m/s]
    programmed : ndarray (n,) [m/s]
        inf on rapids.
    time : ndarray (n,) [s]
        Ascending.
    binding : ndarray (n,) of int
        What limits the speed up to the next point: an index into `names`.
    """

    arc_length: Array
    feedrate: Array
    programmed: Array
    time: Array
    binding: NDArray[np.int8]
    names: Sequence[str]

    def shares(self) -> dict[str, float]:
        """Return the share of time for which each cause limits the speed, the largest first."""
        lasting = np.diff(self.time)
        total = float(lasting.sum()) or 1.0
        held = {name: float(lasting[self.binding[:-1] == code].sum()) / total for code, name in enumerate(self.names)}
        return dict(sorted(((name, part) for name, part in held.items() if part > 0.0), key=lambda item: -item[1]))


@dataclass(frozen=True, eq=False)
class TrialCourse:
    """Errors from trial to trial.

    Parameters
    ----------
    contour_rms : ndarray (n_trial,) [m]
        NaN for a trial that did not finish.
    tracking_rms : ndarray (n_trial, n_axis) [m]
    best : int
        The trial that gives the scheme's figures.
    status : str
        How learning ended.
    errors : tuple of (ndarray (n,) [s], ndarray (n,) [m])
        Times and contour errors of each trial, thinned; empty where they were not kept.
    """

    contour_rms: Array
    tracking_rms: Array
    best: int
    status: str
    errors: tuple[tuple[Array, Array], ...] = ()

    @property
    def whole_rms(self) -> Array:
        """Tracking rms over all axes, (n_trial,) [m]."""
        return np.asarray(np.sqrt(np.square(self.tracking_rms).sum(axis=1)))

    @property
    def in_words(self) -> str:
        """The end of learning in a few words."""
        trials = len(self.contour_rms) - 1
        return self.status if self.status.startswith("diverged") else f"{self.status}, best trial {self.best} of {trials}"


@dataclass(frozen=True, eq=False)
class JudgedRun:
    """One simulated or measured run, judged. Tables, pictures, pages and JSON are made from it.

    Parameters
    ----------
    name : str
        For example ``"without observer"``.
    reference : Reference
        What it was asked to follow; for a log the motion along the path that it is compared with.
    result : Result
        With the signals of the judge.
    metrics : Metrics
        Of a log: over the moving part; tracking errors are nan without a reference.
    verdict : Verdict or None
        None without a tolerance.
    circles : sequence of CircleFigures
        Each full circle of the path, with the figures of ISO 230-4.
    spikes : sequence of Spike
        Spikes of the contour error at reversals on the judged moves.
    machine : Machine or None
        Whose limits the pictures show.
    bode : mapping of axis name to ClosedLoop
        Of the axes whose components are linear but for friction, counts and limits.
    limits : LimitReport or None
        Largest values of the planned motion against its limits; None where it was not planned within limits.
    trials : TrialCourse or None
        Trials of a scheme that learns; `result` is the best one.
    foretold : LearningAnalysis or None
        Prediction of its learning.
    tick : float or None [s]
        Measured computing time of a servo tick.
    switches : Switches or None
        Between controllers of an axis; None where no axis has several.
    gaps : mapping of str to (ndarray (n,), ndarray (n,)) [m]
        Load positions and the free travel there, for each axis with motor and load.
    trust : Trust or None
        Sources of the parameters, and the interval of the part error.
    """

    name: str
    reference: Reference
    result: Result
    metrics: Metrics
    verdict: Verdict | None = None
    circles: tuple[CircleFigures, ...] = ()
    spikes: tuple[Spike, ...] = ()
    findings: tuple[Finding, ...] = ()
    machine: Machine | None = None
    bode: Mapping[str, ClosedLoop] = field(default_factory=dict)
    limits: LimitReport | None = None
    trials: TrialCourse | None = None
    foretold: LearningAnalysis | None = None
    tick: float | None = None
    switches: Switches | None = None
    gaps: Mapping[str, tuple[Array, Array]] = field(default_factory=dict)
    trust: Trust | None = None

    @property
    def path_digest(self) -> str:
        """Hash of the planned path's geometry."""
        return self.reference.path.digest

    def lines(self, samples: Index) -> Index:
        """Return the program line at each of some samples (n,), from 1; 0 for none."""
        return self.reference.source_line(self.result.at("arc_length", samples))

    @property
    def reversal_figures(self) -> tuple[ReversalFigures, ...]:
        """The reversal spikes by axis, direction and quadrant."""
        return reversal_figures(self.spikes)


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
    schemes : sequence of JudgedRun
        At least one, along one path; the others are compared with the first ("before").
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
    live : LiveLoop or None
        Runs that the page itself can repeat with other values.

    Raises
    ------
    ParameterError
        If there is no scheme, names repeat, axes differ, or the tolerance is not positive.
    """

    title: str
    schemes: Sequence[JudgedRun]
    provenance: Provenance
    program: Sequence[str] = ()
    tolerance: float | None = None
    notes: Sequence[str] = ()
    feed: FeedRun | None = None
    is_measured: bool = False
    next_steps: Sequence[tuple[str, str]] = ()
    live: LiveLoop | None = None

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

    def passed(self, scheme: JudgedRun) -> bool | None:
        """Return the verdict of a scheme, or whether its largest error is within the tolerance; a run that stopped early fails."""
        if not scheme.result.status.ok:
            return False
        if scheme.verdict is not None:
            return scheme.verdict.passed
        return None if self.tolerance is None else bool(scheme.metrics.part_error.max <= self.tolerance)

    @property
    def axes(self) -> tuple[str, ...]:
        """Names of the axes."""
        return tuple(self.schemes[0].result.axes)

    @property
    def looks(self) -> dict[str, tuple[str, str, str]]:
        """Name, colour and dash of each scheme, by name: the same in every picture."""
        return {scheme.name: (scheme.name, *scheme_style(i, len(self.schemes))) for i, scheme in enumerate(self.schemes)}

    @property
    def findings(self) -> list[tuple[str, Finding]]:
        """The findings of all schemes, each with the name of its scheme."""
        return [(scheme.name, finding) for scheme in self.schemes for finding in scheme.findings]

    @property
    def planned(self) -> Path:
        """The followed path."""
        return self.schemes[0].reference.path

    @property
    def asked(self) -> Path:
        """The programmed path, which the part is compared with; the judge's ``foot_arc_length`` belongs to it."""
        return self.schemes[0].reference.programmed

    @property
    def is_blended(self) -> bool:
        """Whether the planned path leaves the programmed one, so that part error and contour error differ."""
        return any(scheme.metrics.planning_deviation.max > NANOMETRE for scheme in self.schemes)
