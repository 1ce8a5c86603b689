"""One case after another: simulate, judge, sum up, give a verdict."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Protocol

from contourlab.analysis import AxisResponse, Margins, sampled_loop
from contourlab.errors import ComponentError
from contourlab.feed import AxisLimits, LimitReport, Reference, Route, limit_report
from contourlab.loop import Controller, Machine, simulate
from contourlab.metrics import CircleFigures, Metrics, Spike, circles_of, judge, reversal_spikes, summarise
from contourlab.result import Result
from contourlab.studies.verdict import Verdict, verdict

__all__ = ["AxisBode", "Case", "Outcome", "run_case"]

KEPT_REPORTS = 16
_REPORTS: dict[tuple[str, bytes, bytes, bytes], LimitReport] = {}
"""The latest reports by motion and limits: the schemes of a file mostly share both, and each report reads the whole motion."""


class Case(Protocol):
    """What a case is: a machine under a controller along a reference, and what it is held against."""

    @property
    def name(self) -> str:
        """Name of the scheme."""

    @property
    def machine(self) -> Machine:
        """The machine."""

    @property
    def controller(self) -> Controller:
        """Its controller."""

    @property
    def curvature_step(self) -> float:
        """By how much of its limit the acceleration of an axis may step where the curvature jumps."""

    @property
    def tolerance(self) -> float | None:
        """Largest part error that passes [m]; None for no verdict."""

    @property
    def seed(self) -> int:
        """Of all noise."""

    @property
    def signals(self) -> tuple[str, ...]:
        """Signals to write; empty for all."""

    @property
    def lines(self) -> tuple[str, ...]:
        """Source text of the program; empty for a contour."""

    @property
    def notes(self) -> tuple[str, ...]:
        """What is to be known of the motion, such as that it was scaled."""

    @property
    def limits(self) -> AxisLimits:
        """Limits of the axes that the motion was planned with."""

    def route(self) -> Route | None:
        """The path with its feedrates; None where the motion was not planned."""

    def reference(self, feed_scale: float = 1.0) -> Reference:
        """Return the sampled reference, at a part of the programmed feed."""

    def closer(self, tolerance: float) -> Mapping[str, Callable[[], Reference]]:
        """Return ways, in words, of planning closer to the programmed path, such as within a tolerance [m]."""


@dataclass(frozen=True, eq=False)
class AxisBode:
    """Closed loop and margins of one axis, sampled as it runs."""

    response: AxisResponse
    margins: Margins


@dataclass(frozen=True, eq=False)
class Outcome:
    """A judged case; `limits` is None where the motion was not planned within limits."""

    name: str
    case: Case
    reference: Reference
    result: Result
    metrics: Metrics
    verdict: Verdict | None
    circles: tuple[CircleFigures, ...]
    spikes: tuple[Spike, ...]
    bode: dict[str, AxisBode]
    limits: LimitReport | None


def run_case(
    case: Case,
    *,
    explain: bool = True,
    progress: Callable[[int, int], None] | None = None,
    stage: Callable[[str], None] | None = None,
) -> Outcome:
    """Run one case and judge it.

    Parameters
    ----------
    case : Case
    explain : bool
        Whether causes and advice of a failed verdict are worked out; a passed one needs none.
    progress : callable, optional
        Told samples done and samples in all, while simulating.
    stage : callable, optional
        Told in words what is begun: planning, simulating, judging, and looking for the causes of a verdict that failed.

    Raises
    ------
    DivergenceError
        If the loop runs away.
    """
    begin = stage or (lambda words: None)
    begin(f"planning {case.name}")
    reference = case.reference()

    def told(done: int) -> None:
        if progress is not None:
            progress(done, reference.n_sample)

    begin(f"simulating {case.name}")
    result = simulate(case.machine, case.controller, reference, scheme=case.name, seed=case.seed, progress=told)
    begin(f"judging {case.name}")
    judged = judge(result, reference)
    figures = summarise(judged, reference)
    found = None
    if case.tolerance is not None:
        failed = figures.part_error.max > case.tolerance
        if explain and failed:
            begin(f"looking for the causes of the error of {case.name}")
        found = verdict(
            case.machine,
            case.controller,
            reference,
            judged,
            case.tolerance,
            lines=case.lines,
            slower=case.reference,
            closer=case.closer,
            explain=explain and failed,
            seed=case.seed,
        )
    circles = circles_of(judged, reference)
    spikes = reversal_spikes(judged, (max(figures.window[0] - 5, 0), figures.window[1]))
    bode = bode_of(case.machine, case.controller)
    return Outcome(case.name, case, reference, judged, figures, found, circles, spikes, bode, limits_of(case, reference))


def limits_of(case: Case, reference: Reference) -> LimitReport | None:
    """Hold the reference of a case against the limits of its axes; None where it was not planned within them."""
    if case.route() is None:
        return None
    limits = case.limits
    key = (reference.digest, limits.velocity.tobytes(), limits.acceleration.tobytes(), limits.jerk.tobytes())
    if key not in _REPORTS:
        while len(_REPORTS) >= KEPT_REPORTS:
            del _REPORTS[next(iter(_REPORTS))]
        _REPORTS[key] = limit_report(reference, limits)
    return _REPORTS[key]


def bode_of(machine: Machine, controller: Controller) -> dict[str, AxisBode]:
    """Return the closed loop of each axis whose components are linear but for friction, counts and limits."""
    found = {}
    for axis in machine.axes:
        try:
            loop = sampled_loop(axis, controller.axes[axis.name], machine.servo_period, machine.carried_mass(axis.name))
        except ComponentError:
            continue
        found[axis.name] = AxisBode(loop.response(loop.frequencies()), loop.margins())
    return found
