"""``contourlab backlash``: the gap of each axis, its limit cycles, and the best compensation."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from time import process_time
from typing import Any

from contourlab.app.json_values import HIDDEN
from contourlab.app.quick import PLANNED
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.features.backlash.options import Backlash
from contourlab.features.backlash.study import BacklashStudy, Cycle, backlash_study, loose_axes
from contourlab.features.run.source import Source, scenario_asked
from contourlab.figures import NONE, figure, number
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.study.checkpoint import said_if_interrupted

FEW = 0.05
"""Largest ratio of servo period to limit-cycle period at which a continuous loop approximates the sampled one."""


@dataclass(frozen=True)
class BacklashOutcome(Answer):
    """The study of the backlash of each scheme."""

    name: str
    schemes: Mapping[str, BacklashStudy]
    servo_period: float = field(metadata=HIDDEN)

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The gaps of the axes, one a row [SI]."""
        return [
            {"scheme": name, "axis": axis, "estimate": gap.estimate, "lost_motion": gap.lost_motion, "recommended": study.recommended}
            for name, study in self.schemes.items()
            for axis, gap in study.axes.items()
        ]

    def _next(self, asked: Asked) -> Sequence[object]:
        """Compare the schemes."""
        return ["compare", *asked.inputs]

    @property
    def text(self) -> str:
        """The result for the terminal."""
        return "\n\n".join(text for name, study in self.schemes.items() for text in _texts(name, study, self.servo_period))


@question(Backlash)
def backlash(*source: Source, settings: Backlash, session: Session = QUIET) -> BacklashOutcome:
    """Study the backlash of the schemes of a scenario whose machine has axes with backlash.

    Parameters
    ----------
    *source : str, Path, Scenario, Case, or a Machine, its Controller and a Reference
        A scenario, as a file or read; or what it consists of.

    Returns
    -------
    BacklashOutcome

    Raises
    ------
    ComponentError
        If no axis has backlash.
    DivergenceError
        If a run of an unchanged scheme diverges.
    """
    scenario = scenario_asked(source, settings)
    cases = scenario.cases()
    studies: dict[str, BacklashStudy] = {}
    outcome = BacklashOutcome(scenario.name, studies, cases[0].machine.servo_period)
    stages = session.stages()
    with said_if_interrupted(lambda: outcome.text):
        stages.expect(sum(3 + len(loose_axes(case.machine)) for case in cases))
        began = process_time()
        for i, case in enumerate(cases):
            stages.begin(f"planning {case.name}")
            reference = case.reference()
            left = max((1.0 - (process_time() - began) / PLANNED) / (len(cases) - i), 0.5 / len(cases))
            studies[case.name] = backlash_study(case, reference, stages, left if settings.quick else None)
    return outcome


def _texts(name: str, study: BacklashStudy, period: float) -> Iterator[str]:
    """Yield the conclusions of a study, its tables and the recommended compensation."""
    yield paragraphs([_sentence(name, study), *map(str, study.findings)])
    heads = ("gap in file [um]", "lost motion [um]", "motor and load: lost motion [um]", "motor alone: gap [um]", "confidence")
    gaps = Table([Column("axis", left=True), *map(Column, heads)])
    if study.on_circle is not None:
        gaps.columns = [*gaps.columns, Column("on the circle, controlled [um]")]
    on_circle = {} if study.on_circle is None else dict(zip(study.on_circle.axes, study.on_circle.backlash, strict=True))
    cycles = Table([Column("axis", left=True), Column("limit cycle", left=True), Column("frequency [Hz]"), Column("amplitude [um]")])
    for axis, gap in study.axes.items():
        pair, alone = gap.from_motor_and_load, gap.from_motor_alone
        seen = NONE if pair is None else _plus_minus(pair.lost_motion, pair.lost_motion_deviation)
        cells = [NONE, NONE] if alone is None else [_plus_minus(alone.gap, alone.deviation), f"{alone.confidence:.2f}"]
        left = [] if study.on_circle is None else [number(1e6 * on_circle[axis]) if axis in on_circle else NONE]
        gaps.add(axis, number(1e6 * gap.backlash_gap), number(1e6 * gap.lost_motion), seen, *cells, *left)
        for kind, cycles_found in (("describing function", gap.describing_function), ("exact, without friction", gap.limit_cycles)):
            for cycle in cycles_found or ():
                cycles.add(axis, _kind(kind, cycle, period), number(cycle.frequency, 4), number(1e6 * cycle.amplitude))
            if cycles_found == ():
                cycles.add(axis, f"{kind}: none", NONE, NONE)
    yield gaps.text()
    if cycles.rows:
        yield cycles.text()
    trials = Table([Column("compensation", left=True), Column("part error rms [um]"), Column("largest [um]"), Column("", left=True)])
    for trial in study.trials:
        errors = (NONE if error is None else number(1e6 * error) for error in (trial.part_error_rms, trial.part_error_max))
        trials.add(trial.name, *errors, "recommended" if trial.name == study.recommended else "")
    yield trials.text()
    if study.toml:
        yield f"Add to the scenario:\n\n{study.toml.rstrip()}"


def _sentence(name: str, study: BacklashStudy) -> str:
    """Say how large the lost motion is, and what the recommended compensation gains."""
    lost = ", ".join(f"{axis} {number(1e6 * gap.estimate)} um" for axis, gap in study.axes.items())
    before, best = study.trials[0], next(trial for trial in study.trials if trial.name == study.recommended)
    if best is before or before.part_error_rms is None or best.part_error_rms is None:
        gain = "no compensation that was tried lowers the part error"
    else:
        gain = f"{best.name} lowers the part error from {number(1e6 * before.part_error_rms)} to {number(1e6 * best.part_error_rms)} um rms"
    return f"{name}: lost motion {lost}; {gain}."


def _plus_minus(value: float, deviation: float) -> str:
    """Return a value [m] in um with twice its standard deviation."""
    return f"{number(1e6 * value)} +- {number(2e6 * deviation)}"


def _kind(kind: str, cycle: Cycle, period: float) -> str:
    """Name a limit cycle; add the reasons for a limited accuracy of the prediction."""
    notes = [cycle.validity.partition(":")[0]] if cycle.validity else []
    if cycle.frequency * period > FEW:
        notes.append(f"period {figure(1.0 / (cycle.frequency * period), digits=2)} servo periods")
    return f"{kind}: {'stable' if cycle.stable else 'unstable'}" + (f" ({', '.join(notes)})" if notes else "")
