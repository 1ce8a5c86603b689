"""A learning run: verdicts, the split, and the saved table."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from learning_stages import PERIOD, control, eased, full_stage, make, stage

import contourlab as cl
from contourlab.components.learning.law import LearningProblem
from contourlab.errors import OutputError, ParameterError, ResultError
from contourlab.features.learn import LearnedTable, Stopping, TrialFigures, learn
from contourlab.features.learn.run import best_of, verdict
from contourlab.features.learn.split import Memory, growth_of
from contourlab.feed import AxisLimits
from contourlab.geometry import Line
from contourlab.geometry import Path as Contour

ON = Stopping(improvement=0.0)


def course(merits: list[float], tracking: list[float] | None = None, changes: list[float] | None = None) -> list[TrialFigures]:
    """Return figures of a plausible learning run."""
    follow, steps = tracking or [1.0 + m for m in merits], changes or [1.0] * len(merits)
    return [
        TrialFigures(i, m, m, m, (t / math.sqrt(2.0),) * 2, (t, t), (1.0, 1.0), 0, change=c)
        for i, (m, t, c) in enumerate(zip(merits, follow, steps, strict=True))
    ]


# --- verdicts ------------------------------------------------------------------------------------------------------------------------


def word(figures: list[TrialFigures], stopping: Stopping, explained: bool = False) -> str:
    found = verdict(figures, stopping, explained)
    return "" if found is None else found.status


def test_learning_continues_while_it_improves() -> None:
    assert word(course([0.9**i for i in range(40)]), Stopping()) == ""


def test_learning_converges_when_nothing_more_is_gained() -> None:
    falling = [1.0, 0.5, 0.25, 0.2]
    flat = [*falling, *[0.2 * (1.0 + 1e-4 * (-1) ** i) for i in range(10)]]
    assert word(course(flat), Stopping(patience=10)) == "converged"
    assert word(course(flat[:-2]), Stopping(patience=10)) == ""
    assert word(course(flat), Stopping(patience=10, improvement=0.0)) == ""


def test_learning_ends_when_chance_explains_the_changes() -> None:
    merits = [0.996**i for i in range(12)]
    assert word(course(merits), Stopping(), explained=True) == "converged"
    assert word(course(merits), Stopping(explained=False), explained=True) == ""
    # However much the trials differ, chance cannot explain an error that falls by a fifth.
    assert word(course([0.98**i for i in range(12)]), Stopping(), explained=True) == ""


def test_trials_never_better_than_the_first_are_not_called_converged() -> None:
    rising = [1.0, *[1.0 + 0.9 * (1.0 - 0.5**i) for i in range(1, 12)]]
    settled = [math.nan, *[0.5**i for i in range(1, 12)]]
    assert word(course(rising, changes=settled), Stopping()) == "diverged"
    assert word(course([1.0, *[1.01] * 11], changes=settled), Stopping()) == "converged"


def test_learning_continues_while_tracking_improves_although_the_contour_error_rises() -> None:
    merits = [27.0, 14.6, 5.2, 4.8, 9.5, 12.9, 14.0, 14.8, 15.2, 15.1, 14.8, 14.4, 13.9, 13.2]
    falls = [1159.0 * 0.8**i for i in range(14)]
    assert word(course(merits, tracking=falls), Stopping()) == ""
    assert word(course(merits, tracking=[*falls[:3], *[falls[3]] * 11]), Stopping()) != ""


def test_growth_of_a_fifth_of_a_percent_is_not_called_converged() -> None:
    def grown(n: int) -> str:
        merits = [1.0, 0.1, *[0.1 * 1.002**i for i in range(1, n)]]
        return word(course(merits, changes=[math.nan, 1.0, *[1e-4 * 1.002**i for i in range(1, n)]]), Stopping())

    assert grown(15) == "" and grown(24) == ""
    assert grown(27) == "diverged"


def test_a_slow_rise_and_a_quick_one_are_divergence() -> None:
    slow = [1.0, 0.1, *[0.1 * 1.02**i for i in range(1, 6)]]
    assert word(course(slow), Stopping(growth=5)) == "diverged"
    assert word(course(slow[:-2]), Stopping(growth=5)) == ""
    assert word(course([1.0, 0.1, 0.25, 0.3]), Stopping(divergence=2.0)) == "diverged"
    assert word(course([1.0, 0.1, 0.25]), Stopping(divergence=2.0)) == ""  # a single rise may be chance
    assert word(course([1.0, 0.1, 0.19, 0.19]), Stopping(divergence=2.0)) == ""


def test_falling_tracking_or_a_limit_is_no_divergence() -> None:
    merits = [0.1, 0.2, 0.3, 0.4]
    assert word(course(merits, tracking=[4.0, 3.0, 2.0, 1.0]), ON) == ""
    assert word(course(merits, changes=[math.nan, 1.0, 0.1, 0.01]), ON) == ""
    assert word(course(merits, changes=[math.nan, 1.0, 1.0, 1.1]), ON) == "diverged"


def test_changes_below_rounding_are_neither_better_nor_worse() -> None:
    assert word(course([1.0, 1e-17, 1e-15, 1e-14]), ON) == ""


def test_the_best_trial_is_the_first_of_equals_and_never_a_failed_one() -> None:
    assert best_of(course([3.0, 1.0, 1.0, 2.0])) == 1
    assert best_of([*course([3.0]), *[replace(course([math.nan])[0], trial=1, failed="x")]]) == 0


@pytest.mark.parametrize(
    ("name", "value"), [("improvement", -0.1), ("patience", 1), ("divergence", 1.0), ("growth", 1), ("growth_margin", 0.0)]
)
def test_settings_out_of_range_are_named(name: str, value: Any) -> None:
    with pytest.raises(ParameterError, match=name):
        Stopping(**{name: value})


# --- growth --------------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("hertz", [0.7, 3.5, 40.0])
def test_the_planted_band_of_growth_is_found(hertz: float) -> None:
    t = np.arange(8000)[:, None] * PERIOD
    rng = np.random.default_rng(1)
    fixed = rng.normal(size=(8000, 2))
    errors = [fixed + 1e-2 * 1.3**i * np.sin(2.0 * np.pi * hertz * t) * (0.1, 1.0) + 0.5**i * np.cos(20.0 * t) for i in range(12)]
    found = growth_of(errors, PERIOD, ("x", "y"))
    assert found is not None
    assert found.low < hertz < found.high
    assert found.peak == pytest.approx(hertz, abs=max(0.15, 0.06 * hertz))
    assert found.factor == pytest.approx(1.3, rel=1e-3)
    assert found.axis == "y"
    assert growth_of(errors[:2], PERIOD, ("x", "y")) is None
    assert growth_of([0.5**i * fixed for i in range(5)], PERIOD, ("x", "y")) is None


# --- the split -----------------------------------------------------------------------------------------------------------------------


def _remembered(noise: float, decay: float, seed: int = 4) -> tuple[Memory, LearningProblem]:
    n, rng = 4000, np.random.default_rng(seed)
    memory = Memory(10)
    shape = np.sin(np.arange(n)[:, None] * (1e-3, 2e-3))
    for i in range(10):
        parts = [shape * (1.0 + decay**i) + noise * rng.normal(size=(n, 2)) for _ in range(2)]
        memory.add(parts[0], parts[1], parts[1][:, 0])
    impulse = np.zeros((2, 2))
    impulse[1] = 2.0
    return memory, LearningProblem(PERIOD, np.tile((1.0, 0.0), (n, 1)), lambda: impulse)


def test_the_split_finds_the_planted_noise_and_its_bound() -> None:
    memory, problem = _remembered(0.01, 0.8)
    split = memory.split(make("learning", "zero-phase", half_width=11), problem)
    assert split is not None
    assert split.non_repeatable == pytest.approx((0.01, 0.01), rel=0.03)
    assert split.floor == pytest.approx(0.01, rel=0.03)
    # 28 000 numbers whose average over 23 has a deviation of 0.01/sqrt(23): their maximum lies between 3.5 and 5 deviations.
    assert all(3.5 < bound / (0.01 / math.sqrt(23.0)) < 5.0 for bound in split.bound)
    assert split.bound_position == pytest.approx(2.0 * np.array(split.bound))
    size = math.sqrt(np.mean(np.sin(np.arange(4000) * 1e-3) ** 2))
    assert split.repeatable[0] == pytest.approx(size * (1.0 + np.mean(0.8 ** np.arange(10))), rel=1e-2)


def test_steady_learning_is_not_taken_for_chance_nor_chance_for_learning() -> None:
    for noise, decay, by_chance in ((0.01, 0.9, False), (0.01, 0.0, False), (0.0, 0.9, False)):
        assert _remembered(noise, decay)[0].explained() == by_chance
    memory, rng = Memory(6), np.random.default_rng(0)
    for _ in range(6):
        part = 1.0 + rng.normal(size=(500, 2))
        memory.add(part, part, part[:, 0])
    assert memory.explained()
    assert _remembered(0.0, 0.8)[0].split(make("learning", "zero-phase"), _remembered(0.0, 0.8)[1]).floor < 0.002  # type: ignore[union-attr]


def test_only_a_noisy_machine_has_a_floor() -> None:
    reference = eased(3.0)
    law = make("learning", "zero-phase", gain=0.5, half_width=5, passes=2)
    still = learn(stage(), control(), reference, law, trials=25, stopping=ON)
    noisy = learn(
        stage(sensor=make("sensor", "encoder", resolution=1e-9, noise=5e-5)), control(), reference, law, trials=25, stopping=ON, seed=5
    )
    assert still.split is not None
    assert noisy.split is not None
    assert still.split.floor < 0.1 * noisy.split.floor
    assert noisy.trials[-1].contour_rms > 0.8 * noisy.split.floor


# --- the run -------------------------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def reference() -> cl.Reference:
    return cl.uniform(cl.contour("ellipse"), 0.5, 1, PERIOD)


def test_equal_seeds_learn_the_same_and_different_ones_do_not(reference: cl.Reference) -> None:
    law = make("learning", "zero-phase", gain=0.3, half_width=5, passes=2)
    runs = [learn(*full_stage(), reference, law, trials=3, seed=seed) for seed in (1, 1, 2)]
    assert [t.contour_rms for t in runs[0].trials] == [t.contour_rms for t in runs[1].trials]
    assert np.array_equal(runs[0].table.values, runs[1].table.values)
    assert runs[0].trials[0].contour_rms != runs[2].trials[0].contour_rms


def test_progress_is_reported_during_a_run(reference: cl.Reference) -> None:
    told: list[int] = []
    seen: list[TrialFigures] = []
    run = learn(stage(), control(), reference, make("learning", "zero-phase"), trials=2, progress=told.append, on_trial=seen.append)
    assert told == [reference.n_sample * k for k in (1, 2, 3)]
    assert [t.trial for t in seen] == [0, 1, 2]
    assert "CL300" in {one.code for one in run.findings}
    assert len(run.trials) == 3
    for figures, (at, error) in zip(run.trials, run.course.errors, strict=True):
        assert np.abs(error).max() >= figures.contour_max and 0.0 <= at[0] < at[-1] <= (reference.n_sample - 1) * PERIOD
    with pytest.raises(ParameterError, match="trials"):
        learn(stage(), control(), reference, make("learning", "zero-phase"), trials=-1)


def test_a_diverging_loop_is_rolled_back_to_the_best_trial(reference: cl.Reference) -> None:
    run = learn(stage(), control(), reference, make("learning", "p-type", gain=1e5), trials=20)
    assert run.diverged and run.best == 0
    assert run.findings[0].code in ("CL303", "CL304")
    assert not run.table.values.any()


def test_the_part_error_is_computed_on_a_blended_path() -> None:
    program = cl.parse_program("G21 G90 G64 P0.5\nG1 X20 F1500\nG1 Y20\nM2\n")
    route = cl.blended(cl.route_from_program(program, axes=("x", "y")))
    planned = cl.plan(route, AxisLimits([0.2] * 2, [1.0] * 2, [50.0] * 2), PERIOD)
    law = make("learning", "zero-phase", gain=0.4, half_width=5, passes=2)
    run = learn(stage(), control(), planned, law, trials=3)
    assert [math.isnan(t.part_max) for t in run.trials] == [i not in (0, run.best) for i in range(4)]
    every = learn(stage(), control(), planned, law, trials=3, part="all")
    assert every.trials[0].part_max == run.trials[0].part_max
    whole = cl.judge(cl.simulate(stage(), control(), planned), planned)
    assert run.trials[0].part_max == pytest.approx(np.abs(whole["part_error"]).max(), rel=1e-9)


@pytest.mark.parametrize("n_axis", [1, 3, 5])
def test_any_number_of_axes_can_learn(n_axis: int) -> None:
    t = np.linspace(0.0, 1.0, 2001)
    s = t**3 * (10.0 - 15.0 * t + 6.0 * t**2)
    line = np.array([0.02 / (j + 1.0) for j in range(n_axis)])
    path = Contour([Line(tuple(np.zeros(n_axis)), tuple(line))])
    motion = cl.Reference.from_samples(s[:, None] * line, PERIOD, path)
    run = learn(
        stage(n_axis), control(n_axis), motion, make("learning", "zero-phase", gain=0.5, half_width=5, passes=2), trials=15, stopping=ON
    )
    assert run.trials[-1].tracking < 0.05 * run.trials[0].tracking
    assert len(run.trials[-1].tracking_rms) == n_axis


# --- the table -----------------------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def learned(reference: cl.Reference) -> LearnedTable:
    return learn(stage(), control(), reference, make("learning", "zero-phase"), trials=4).table


def test_a_table_survives_a_round_trip(learned: LearnedTable, reference: cl.Reference, tmp_path: Path) -> None:
    learned.save(tmp_path / "sub" / "table.nc")
    again = LearnedTable.load(tmp_path / "sub" / "table.nc")
    assert np.array_equal(again.values, learned.values)
    for name in ("target", "axes", "servo_period", "path", "reference", "machine", "controller", "law", "scheme"):
        assert getattr(again, name) == getattr(learned, name), name
    assert set(again.figures) == set(learned.figures)
    assert all(np.array_equal(again.figures[k], learned.figures[k], equal_nan=True) for k in learned.figures)
    again.check(stage(), control(), reference)
    goes_on = learn(stage(), control(), reference, make("learning", "zero-phase"), trials=0, start=again)
    assert goes_on.trials[0].contour_rms == pytest.approx(float(learned.figures["contour_rms"].min()), rel=1e-12)


def test_a_table_is_refused_on_any_other_setup(learned: LearnedTable, reference: cl.Reference) -> None:
    stiffer = replace(stage(), axes=(stage().axes[0], replace(stage().axes[1], plant=stage().axes[1].plant.replace(damping_ratio=0.7))))
    renamed = replace(stage(), axes=tuple(replace(a, name=n) for a, n in zip(stage().axes, "ab", strict=True)))
    faster, larger = cl.uniform(cl.contour("ellipse"), 1.0, 1, PERIOD), cl.uniform(cl.contour("circle"), 0.5, 1, PERIOD)
    slow = cl.uniform(cl.contour("ellipse"), 0.5, 1, 2e-3)
    for machine, controller, motion, said in (
        (stiffer, control(), reference, r"\[axes.y.plant\] damping_ratio = 1.1.*damping_ratio = 0.7"),
        (stage(), control(2, 0.2), reference, "time_constant"),
        (renamed, control(), reference, "axes x, y.*a, b"),
        (stage(2, 2e-3), control(), slow, "servo period of 0.001 s.*0.002"),
        (stage(), control(), larger, "use the program"),
        (stage(), control(), faster, "the feed"),
    ):
        with pytest.raises(ResultError, match=said):
            learned.check(machine, controller, motion)
    with pytest.raises(ResultError, match='target = "command"'):
        learn(stage(), control(), reference, make("learning", "zero-phase", target="reference"), start=learned)


def test_files_that_are_not_tables_are_refused(learned: LearnedTable, reference: cl.Reference, tmp_path: Path) -> None:
    with pytest.raises(ResultError, match=r"nothing\.nc"):
        LearnedTable.load(tmp_path / "nothing.nc")
    (tmp_path / "text.nc").write_text("no table")
    with pytest.raises(ResultError, match=r"text\.nc"):
        LearnedTable.load(tmp_path / "text.nc")
    cl.simulate(stage(), control(), reference).save(tmp_path / "result.nc")
    with pytest.raises(ResultError, match=r"result\.nc"):
        LearnedTable.load(tmp_path / "result.nc")
    replace(learned, values=np.full_like(learned.values, np.nan)).save(tmp_path / "nan.nc")
    with pytest.raises(ResultError, match="damaged"):
        LearnedTable.load(tmp_path / "nan.nc")
    (tmp_path / "file").write_text("")
    with pytest.raises(OutputError):
        learned.save(tmp_path / "file" / "table.nc")


def test_a_law_continues_from_the_table_of_another(learned: LearnedTable, reference: cl.Reference) -> None:
    run = learn(stage(), control(), reference, make("learning", "plant-inversion", bandwidth=80.0), trials=1, start=learned)
    assert run.trials[0].contour_rms < 1.01 * float(learned.figures["contour_rms"].min())
    assert run.trials[1].tracking < run.trials[0].tracking


# --- interrupts, and laws that look too far ahead ----------------------------------------------------------------------------------------


def test_an_interrupt_keeps_the_learned_table() -> None:
    machine, controller = stage(), control()
    reference = eased(2.0)

    def stop(figures: TrialFigures) -> None:
        if figures.trial == 3:
            raise KeyboardInterrupt

    law = make("learning", "zero-phase", gain=0.4, half_width=5, passes=2)
    run = learn(machine, controller, reference, law, trials=50, stopping=ON, on_trial=stop)
    whole = learn(machine, controller, reference, law, trials=3, stopping=ON)
    assert run.status == f"interrupted, trial {whole.best} kept"
    assert len(run.trials) == 4
    np.testing.assert_array_equal(run.table.values, whole.table.values)


@pytest.mark.parametrize("changes", [{"half_width": 100_000.0}, {"lead": 100.0}])
def test_a_law_that_looks_beyond_the_trial_is_refused(changes: dict[str, float]) -> None:
    law = make("learning", "zero-phase", gain=0.4, **{"half_width": 5.0, **changes})
    with pytest.raises(ParameterError, match=next(iter(changes))):
        learn(stage(), control(), eased(2.0), law, trials=1)
