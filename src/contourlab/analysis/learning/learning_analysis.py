"""Will it learn? What is known before the first trial of a machine, its controller and a learning law, with warnings in words."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.learning.learning_frequency import FrequencyLearning, frequency_learning
from contourlab.analysis.learning.learning_lifted import LiftedLearning, lifted_learning
from contourlab.analysis.learning.learning_rules import GROWTH, LearningDesign, design_zero_phase, first_zero
from contourlab.analysis.linear.coupled_loop import CoupledLoop, coupled_loop
from contourlab.components.learning.error_law import ZeroPhase
from contourlab.components.learning.law import LearningLaw
from contourlab.errors import ComponentError
from contourlab.feed import Reference
from contourlab.loop.machine import Controller, Machine

Array = NDArray[np.float64]
TURN = 2.0 * math.pi
SMALL = 1e-3
"""Growth per trial that a rule may leave."""
MOST_WIDER = 10
"""So often an average is made wider for a coupling."""
DIVERGES = 1.1
"""A factor beyond which a few trials are enough to see it."""


@dataclass(frozen=True, eq=False)
class LearningAnalysis:
    """What learning will do.

    Attributes
    ----------
    law : LearningLaw
    servo_period : float [s]
    response : FrequencyLearning
        Factors of a trial over frequency, the worst over all directions of the path.
    lifted : LiftedLearning or None
        Over a whole trial on a given path; None without one.
    zero : float [rad/s]
        First zero of the law's average; nan for a law without one.
    design : LearningDesign or None
        What the rules would have, for zero-phase learning that amplifies.
    warnings : tuple of str
        In words; empty where there is nothing to say.
    """

    law: LearningLaw
    servo_period: float
    response: FrequencyLearning
    lifted: LiftedLearning | None
    zero: float
    design: LearningDesign | None
    warnings: tuple[str, ...]

    @property
    def worst_frequency(self) -> float:
        """Frequency [rad/s] at which learning converges most slowly, or diverges fastest."""
        return self.response.worst_radius[0]

    @property
    def worst_factor(self) -> float:
        """What a trial multiplies it by in the end."""
        return self.response.worst_radius[1]

    @property
    def converges(self) -> bool:
        """Whether no frequency grows in the end, nor anything on the path that was given."""
        return self.worst_factor <= 1.0 + GROWTH and (self.lifted is None or self.lifted.radius <= 1.0 + 1e-4)

    @property
    def monotone(self) -> bool:
        """Whether no frequency grows in any trial; at the ends of a trial, and where the path turns, `lifted.norm` may still exceed 1."""
        return self.response.worst_norm[1] <= 1.0 + GROWTH


def learning_analysis(machine: Machine, controller: Controller, law: LearningLaw, reference: Reference | None = None) -> LearningAnalysis:
    """Return what learning will do, before a trial is run.

    Parameters
    ----------
    machine, controller
        Linear but for limits, friction and quantisation, which are left out.
    law : LearningLaw
        Linear in the table and the trial.
    reference : Reference, optional
        With one, the trial on its path is looked at as a whole as well, which takes seconds for 30 000 samples.

    Raises
    ------
    ComponentError
        If a component is not linear, or an axis is unstable without learning.
    """
    loop = coupled_loop(machine, controller)
    for name, axis in zip(loop.names, loop.axes, strict=True):
        if not axis.loop.stable:
            raise ComponentError(f"axis {name} is unstable under its own controller: there is nothing to learn before that is mended")
    response = frequency_learning(loop, law)
    lifted = None
    if reference is not None:
        lifted = lifted_learning(loop, law, reference.path.tangent(reference.block(0, reference.n_sample).arc_length))
    zero = first_zero(int(law.half_width), loop.servo_period) if isinstance(law, ZeroPhase) and law.half_width else math.nan
    worst = response.worst_radius[1]
    design = design_for(loop, law) if worst > 1.0 + GROWTH and isinstance(law, ZeroPhase) else None
    return LearningAnalysis(law, loop.servo_period, response, lifted, zero, design, tuple(_warnings(loop, law, response, lifted, design)))


def design_for(loop: CoupledLoop, law: ZeroPhase) -> LearningDesign | None:
    """Return zero-phase learning by rule for the axis with the most lag, wide enough for the coupling; None where none was found."""

    def closed(w: Array) -> NDArray[np.complex128]:
        forms = [axis.form(w) for axis in loop.axes]
        if law.target == "command":
            answers = np.stack([1.0 - form[:, 1, 0] for form in forms], axis=1)
        else:
            answers = np.stack([form[:, 0, 1] for form in forms], axis=1)
        # The one whose phase is furthest back at each frequency.
        phase = np.unwrap(np.angle(answers), axis=0) if w.size > 1 else np.angle(answers)
        return np.asarray(answers[np.arange(w.size), np.argmin(phase, axis=1)])

    design = design_zero_phase(closed, loop.servo_period)
    for _ in range(MOST_WIDER):
        # The rule knows the axes; the coupling makes their loops steeper across the path.
        tried = law.replace(gain=design.gain, half_width=float(design.half_width), passes=float(design.passes), lead=design.lead)
        at, factor = frequency_learning(loop, tried).worst_radius
        if factor <= 1.0 + SMALL:
            return replace(design, worst_frequency=at, worst_factor=factor)
        width = 1 + design.half_width + design.half_width // 2
        design = replace(design, half_width=width, passes=2, bandwidth=first_zero(width, loop.servo_period))
    return None


def _warnings(
    loop: CoupledLoop, law: LearningLaw, response: FrequencyLearning, lifted: LiftedLearning | None, design: LearningDesign | None
) -> list[str]:
    found = []
    frequency, factor = response.worst_radius
    if factor > 1.0 + GROWTH:
        found.append(f"{_setting(law, loop.servo_period)} {_grows(frequency, factor)}")
        if isinstance(law, ZeroPhase):
            found.append(_second_pass(loop, law, factor))
        elif math.isinf(law.values().get("bandwidth", 0.0)):
            start = _first_above(response)
            found.append(f"without a Q-filter learning diverges from {start / TURN:.3g} Hz up: set bandwidth below that")
    elif response.worst_norm[1] > 1.0 + GROWTH:
        at, size = response.worst_norm
        found.append(f"{law.kind} converges in the end, but a trial may make {at / TURN:.3g} Hz worse by a factor of {size:.4g} before")
    if design is not None and design.worst_factor < factor:
        found.append(_advice(design, loop.servo_period))
    elif design is None and factor > 1.0 + GROWTH and isinstance(law, ZeroPhase):
        found.append("no average was found that converges under this coupling: lower its gain, or learn by p-type with a Q-filter")
    if lifted is not None and lifted.radius > 1.0 + 1e-4 and factor <= 1.0 + GROWTH:
        found.append(f"on this path, its normal turning, learning diverges by a factor of {lifted.radius:.4g} per trial")
    return [text for text in found if text]


def _setting(law: LearningLaw, servo_period: float) -> str:
    if not isinstance(law, ZeroPhase):
        return law.kind
    twice = ", filtered twice," if law.passes == 2 else ""
    return f"M = {law.half_width:.0f} at {1e3 * servo_period:g} ms{twice}"


def _grows(frequency: float, factor: float) -> str:
    hertz = f"{frequency / TURN:.1f} Hz"
    if factor >= DIVERGES:
        return f"diverges: {hertz} grows by a factor of {factor:.3g} per trial"
    return f"amplifies {hertz} by {100.0 * (factor - 1.0):.2g} % per trial"


def _second_pass(loop: CoupledLoop, law: ZeroPhase, single: float) -> str:
    """Say whether averaging twice is enough."""
    if law.passes == 2:
        return ""
    frequency, factor = frequency_learning(loop, law.replace(passes=2)).worst_radius
    if factor >= single:
        return "" if single <= 1.0 + SMALL else f"a second pass alone does not cure it: it still {_grows(frequency, factor)}"
    if factor <= 1.0 + SMALL:
        return f"a second pass cures it but for {100.0 * max(factor - 1.0, 0.0):.1g} % per trial: passes = 2"
    return f"a second pass alone does not cure it: it still {_grows(frequency, factor)}"


def _advice(design: LearningDesign, servo_period: float) -> str:
    lead = f", lead = {1e3 * design.lead:g} ms" if design.lead else ""
    left = 100.0 * max(design.worst_factor - 1.0, 0.0)
    return (
        f"by rule: M = {design.half_width}, gain = {design.gain:.2g}, passes = {design.passes}{lead}, which learns up to about"
        f" {design.bandwidth / TURN:.3g} Hz and amplifies nothing by more than {left:.1g} % per trial"
    )


def _first_above(response: FrequencyLearning) -> float:
    return float(response.frequency[np.flatnonzero(response.radius > 1.0 + GROWTH)[0]])
