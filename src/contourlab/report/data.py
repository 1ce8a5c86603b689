"""What a report is made of: handed in whole by the caller, and read only."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ParameterError
from contourlab.feed.verify import LimitReport
from contourlab.findings import Finding
from contourlab.metrics import Bidirectional, CircleFigures, Metrics, Spike
from contourlab.report.shapes import DrawnPath, Verdict
from contourlab.report.trust import Trust
from contourlab.result import Result

if TYPE_CHECKING:
    from contourlab.analysis.learning.learning_analysis import LearningAnalysis
    from contourlab.loop.switches import Switches
    from contourlab.report.feed_picture import FeedRun
    from contourlab.report.trials import TrialCourse

Array = NDArray[np.float64]
NANOMETRE = 1e-9  # below this two paths are one: so far may the curves of a path be apart at a joint


@dataclass(frozen=True, eq=False)
class AxisBounds:
    """Limits of the axes, drawn beside the signals.

    Parameters
    ----------
    velocity, acceleration, jerk : ndarray (n_axis,) [m/s, m/s^2, m/s^3], > 0, inf for none
    command : ndarray (n_axis,), > 0, inf for none
        Command at which the drive saturates, in the unit of the command signal.
    """

    velocity: Array
    acceleration: Array
    jerk: Array
    command: Array

    def __post_init__(self) -> None:
        for name, unit in (("velocity", "m/s"), ("acceleration", "m/s^2"), ("jerk", "m/s^3"), ("command", "")):
            value = np.atleast_1d(np.asarray(getattr(self, name), dtype=np.float64))
            if not bool(np.all(value > 0.0)):
                raise ParameterError(name, value.tolist(), "> 0 on every axis (inf for no limit)", unit)
            object.__setattr__(self, name, value)

    def of(self, name: str, axis: int) -> float:
        """Return one limit of one axis; a single value stands for all axes."""
        value: Array = getattr(self, name)
        return float(value[axis] if value.size > 1 else value[0])


@dataclass(frozen=True, eq=False)
class FrequencyResponse:
    """Closed loop of one axis, reference to position.

    Parameters
    ----------
    frequency : ndarray (n,) [Hz], > 0, ascending
    response : ndarray of complex (n,)
        Position over reference, 1 when the axis follows exactly.
    notes : mapping of str to str
        Figures to print beside it, for example ``{"bandwidth": "42 Hz", "phase margin": "61 deg"}``.
    stable : bool
        Whether the loop is stable.
    meant : str
        Which loop it is, where the axis has not just one linear one: ``"in contact"``, say.
    """

    frequency: Array
    response: NDArray[np.complex128]
    notes: Mapping[str, str] = field(default_factory=dict)
    stable: bool = True
    meant: str = ""

    def __post_init__(self) -> None:
        frequency = np.asarray(self.frequency, dtype=np.float64)
        response = np.asarray(self.response, dtype=np.complex128)
        if frequency.ndim != 1 or frequency.shape != response.shape or frequency.size < 2:
            raise ParameterError("response", response.shape, f"one value per frequency, at least 2: {frequency.shape}")
        if not bool(np.all(frequency > 0.0) and np.all(np.diff(frequency) > 0.0)):
            raise ParameterError("frequency", "array", "> 0 and ascending", "Hz")
        object.__setattr__(self, "frequency", frequency)
        object.__setattr__(self, "response", response)


@dataclass(frozen=True, eq=False)
class CircleRun:
    """One run round a circle, as a ball bar would record it; `contourlab.metrics.CircleFigures` can stand for it.

    Parameters
    ----------
    name : str
        Which circle, for example ``"XY, radius 20 mm"``; runs of one name share a plot.
    clockwise : bool
    radius : float [m], > 0
        Nominal.
    angle : ndarray (n,) [rad]
        Of the points as seen from the centre.
    deviation : ndarray (n,) [m]
        Distance from the centre less the nominal radius.
    figures : mapping of str to float [m]
        By their names in ISO 230-4.
    spikes : sequence of int
        Points at which reversal spikes are highest, to be marked.
    """

    name: str
    clockwise: bool
    radius: float
    angle: Array
    deviation: Array
    figures: Mapping[str, float] = field(default_factory=dict)
    spikes: Sequence[int] = ()

    def __post_init__(self) -> None:
        angle, deviation = np.asarray(self.angle, dtype=np.float64), np.asarray(self.deviation, dtype=np.float64)
        if angle.ndim != 1 or angle.shape != deviation.shape or angle.size == 0:
            raise ParameterError("deviation", deviation.shape, f"one value per angle, at least 1: {angle.shape}")
        if not 0.0 < self.radius < float("inf"):
            raise ParameterError("radius", self.radius, "finite and > 0", "m")
        object.__setattr__(self, "angle", angle)
        object.__setattr__(self, "deviation", deviation)


@dataclass(frozen=True)
class Mark:
    """A moment worth marking on the error over time; `contourlab.metrics.Spike` can stand for it.

    Parameters
    ----------
    time : float [s]
    label : str
        For example ``"x reverses"``.
    kind : str
        ``"reversal"`` or ``"corner"``. The corners of the planned path are marked without being given.
    height : float [m] or nan
        Of the spike, where it was measured.
    """

    time: float
    label: str
    kind: str = "reversal"
    height: float = float("nan")

    def __post_init__(self) -> None:
        if self.kind not in ("reversal", "corner"):
            raise ParameterError("kind", self.kind, "'reversal' or 'corner'")


@dataclass(frozen=True, eq=False)
class SchemeReport:
    """One simulated or measured run.

    Parameters
    ----------
    name : str
        For people, for example ``"without observer"``.
    result : Result
        Judged: with the signals ``contour_error`` and ``tracking_error``.
    metrics : Metrics
    bounds : AxisBounds or None
    verdict : Verdict or None
    bode : mapping of axis name to FrequencyResponse
    circles : sequence of CircleRun or CircleFigures
    bidirectional : mapping of str to Bidirectional
        Of those circles that were run in both senses, by their name.
    spikes : sequence of Mark or Spike
    limits : LimitReport or None
        Of the planned motion; None where it was not planned within limits.
    trials : TrialCourse or None
        Of a scheme that learns: the result is that of its best trial.
    foretold : LearningAnalysis or None
        What an analysis said of its learning beforehand.
    tick : float or None [s]
        What a tick of the servo loop costs, where it was measured.
    switches : Switches or None
        From one controller of an axis to another.
    gaps : mapping of str to (ndarray (n,), ndarray (n,)) [m]
        For each axis with a motor and a load: places of the load, and the free travel there.
    trust : Trust or None
        Where the numbers are from, and what their deviations make of the contour error.
    findings : sequence of Finding
    """

    name: str
    result: Result
    metrics: Metrics
    bounds: AxisBounds | None = None
    verdict: Verdict | None = None
    bode: Mapping[str, FrequencyResponse] = field(default_factory=dict)
    circles: Sequence[CircleRun | CircleFigures] = ()
    bidirectional: Mapping[str, Bidirectional] = field(default_factory=dict)
    spikes: Sequence[Mark | Spike] = ()
    limits: LimitReport | None = None
    trials: TrialCourse | None = None
    foretold: LearningAnalysis | None = None
    tick: float | None = None
    switches: Switches | None = None
    gaps: Mapping[str, tuple[Array, Array]] = field(default_factory=dict)
    trust: Trust | None = None
    findings: Sequence[Finding] = ()

    @property
    def runs(self) -> tuple[CircleRun, ...]:
        """The circles in one form."""
        return tuple(
            CircleRun(c.name, c.clockwise, c.radius, c.angle, c.deviation, c.figures()) if isinstance(c, CircleFigures) else c
            for c in self.circles
        )

    @property
    def marks(self) -> tuple[Mark, ...]:
        """The spikes in one form."""
        return tuple(Mark(s.time, f"{s.axis} reverses", "reversal", abs(s.height)) if isinstance(s, Spike) else s for s in self.spikes)


@dataclass(frozen=True)
class Provenance:
    """Where the figures come from; holds no date, so that the same run gives the same file.

    Parameters
    ----------
    version : str
        Of contourlab.
    command : str
        The command line as typed.
    run_again : str
        The command that makes this report again from `scenario`.
    scenario : str
        The whole scenario as TOML.
    seed : int or None
    platform : str
        For example ``"Linux x86_64, Python 3.11.9, numba 0.62"``.
    """

    version: str
    command: str
    run_again: str
    scenario: str
    seed: int | None = None
    platform: str = ""


@dataclass(frozen=True, eq=False)
class ReportData:
    """All of a report.

    Parameters
    ----------
    title : str
    schemes : sequence of SchemeReport
        At least one; the first is what the others are compared with ("before").
    planned : Path
        The path that was followed.
    provenance : Provenance
    programmed : Path or None
        The path that the program asked for, where it differs: the judge's ``foot_arc_length`` belongs to it.
    program : sequence of str
        Source text of the part program, by line; empty where there is none.
    tolerance : float [m] or None, > 0
        What the errors are held against.
    notes : sequence of str
        What else is to be known of the path and the runs, such as that it was scaled.
    feed : FeedRun or None
        The planned motion, the same for all schemes.
    is_measured : bool
        Whether the runs are logs, of which only what they recorded is known.

    Raises
    ------
    ParameterError
        If there is no scheme, two have one name, they differ in their axes, or the tolerance is not positive.
    """

    title: str
    schemes: Sequence[SchemeReport]
    planned: DrawnPath
    provenance: Provenance
    programmed: DrawnPath | None = None
    program: Sequence[str] = ()
    tolerance: float | None = None
    notes: Sequence[str] = ()
    feed: FeedRun | None = None
    is_measured: bool = False

    def __post_init__(self) -> None:
        if not self.schemes:
            raise ParameterError("schemes", "()", "at least one run to report")
        names = [scheme.name for scheme in self.schemes]
        if len(set(names)) < len(names):
            raise ParameterError("schemes", names, "named differently, each name once")
        axes = tuple(self.schemes[0].result.axes)
        for scheme in self.schemes:
            if tuple(scheme.result.axes) != axes:
                found = tuple(scheme.result.axes)
                raise ParameterError(f"axes of {scheme.name!r}", found, f"{axes}, as of the first scheme")
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
    def asked(self) -> DrawnPath:
        """The path that the part is held against."""
        return self.planned if self.programmed is None else self.programmed

    @property
    def is_blended(self) -> bool:
        """Whether the planned path leaves the programmed one, so that part error and contour error differ."""
        return any(scheme.metrics.planning_deviation.max > NANOMETRE for scheme in self.schemes)
