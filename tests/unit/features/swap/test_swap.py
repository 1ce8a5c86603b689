"""Swapping: the definition of a loss, and cases with a known answer."""

from __future__ import annotations

import re
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from contourlab.components.controller.position import PositionController
from contourlab.components.friction.laws import Coulomb, NoFriction
from contourlab.components.plant.plant import MassDamper, RigidAxis
from contourlab.errors import ContourlabError, ParameterError
from contourlab.features.swap import search as searches
from contourlab.features.swap.beyond import coverage, network_cost
from contourlab.features.swap.command import quick_budget
from contourlab.features.swap.report import SwapResult, drawing, judged_exactly, matrices, text_of
from contourlab.features.swap.search import SharedSpace, SwapSearch, SwapSettings, merged
from contourlab.features.swap.study import SwapStudy, swap_study
from contourlab.features.swap.variants import Variant, Variants, losses, numbers_of, variants_of
from contourlab.feed import uniform
from contourlab.geometry import contour
from contourlab.loop import Axis, AxisController, Controller, Limits, Machine
from contourlab.study import Setting, Space
from contourlab.study.checkpoint import Checkpoint
from contourlab.study.guards import Bounds

GAINS = {"velocity_gain": 60.0, "position_gain": 3000.0, "integral_gain": 10.0}
FREE = "model_gain=0.3 m/s^2/full_scale..4 m/s^2/full_scale"
AHEAD = "controller.axes.x.controller.model_gain"


def rigid(name: str, gain: float) -> Axis:
    """Return an axis without damping, friction or counting: a double integrator."""
    return Axis(name, RigidAxis(gain=gain, damping=0.0), friction=NoFriction(), limits=Limits(velocity=1.0))


def stage(gain: float = 1.0) -> tuple[Machine, Controller]:
    machine = Machine("stage", (rigid("x", gain), rigid("y", 1.0)), 1e-3)
    return machine, Controller({n: AxisController(PositionController(**GAINS, model_gain=1.05, model_damping=0.0)) for n in ("x", "y")})


def variants_under(others: list[tuple[str, Axis]], texts: tuple[str, ...] = (FREE,)) -> Variants:
    machine, controller = stage()
    members = variants_of(machine, {"x": others})
    circle = uniform(contour("circle", radius=0.01), 1.0, 2, 1e-3)
    return Variants(
        members, Setting(machine, controller, circle, moving=True), Space.chosen(machine, controller, texts), bounds=Bounds(0.0, 0.0, 1.0)
    )


def studied(others: list[tuple[str, Axis]], budget: int = 200, **settings: object) -> SwapStudy:
    variants = variants_under(others)
    candidates = tuple(name for name in variants.space.names if variants.members[0].module(name))
    return swap_study(variants, candidates, SwapSettings(budget=budget, **settings))  # type: ignore[arg-type]


def test_loss_refers_to_the_larger_of_best_and_floor() -> None:
    assert losses([3e-6, 12e-6], [1e-6, 10e-6], 2e-6) == pytest.approx([1.0, 0.2])
    assert losses([1e-6], [1e-6], 2e-6).tolist() == [0.0]


@pytest.mark.slow
def test_a_quick_study_holds_its_own_uncertainty() -> None:
    others = [("other", rigid("other", 1.01))]
    variants = variants_under(others)
    candidates = tuple(name for name in variants.space.names if variants.members[0].module(name))
    quick = swap_study(variants, candidates, SwapSettings(budget=400, quick=True))
    whole = studied(others, 700)
    assert quick.uncertainty is not None and abs(quick.base.swap_loss - whole.base.swap_loss) <= quick.uncertainty < 0.03
    assert not quick.unsure and quick.verdict.code == whole.verdict.code
    near = replace(quick, settings=replace(quick.settings, full=quick.base.swap_loss + 0.5 * quick.uncertainty))
    assert near.unsure and near.verdict.code == "CL704"


@pytest.mark.slow
def test_a_quick_study_finds_local_parameters_where_one_controller_is_not_enough() -> None:
    variants = variants_under([("strong", rigid("other", 2.0))])
    quick = swap_study(variants, (AHEAD,), SwapSettings(budget=300, quick=True))
    assert not quick.full and not quick.unsure
    assert quick.recommended is not None and quick.recommended.local == {AHEAD}


def test_a_quick_study_takes_what_fits_and_refuses_what_does_not(monkeypatch: pytest.MonkeyPatch) -> None:
    variants = variants_under([("strong", rigid("other", 2.0))])

    def budget(runs: float, most: int = 8000) -> int:
        monkeypatch.setattr("contourlab.features.swap.command.affordable_candidates", lambda *_: runs)
        return quick_budget(variants, most)

    each = 2 * 2 * 3 * 2.0  # half of the time runs; twice, two variants have a search alone and one of twice the budget together
    assert [budget(each * fits) for fits in (129.0, 255.0, 256.0, 5000.0, 1e6)] == [128, 128, 256, 4096, 8000]
    assert budget(each * 5000.0, 1000) == 1000
    with pytest.raises(ParameterError) as refused:
        budget(each * 127.0)
    assert refused.value.name == "--quick"


@pytest.mark.slow
def test_a_copy_of_the_axis_loses_nothing() -> None:
    variants = variants_under([("strong", rigid("other", 2.0))])
    copy = Variant("x = copy", variants.members[0].machine.swapped("x", rigid("other", 1.0)), (("x", "copy"),))
    study = swap_study(replace(variants, members=(variants.members[0], copy)), (AHEAD,), SwapSettings(budget=200))
    assert study.full and study.base.swap_loss < 1e-3
    assert study.recommended is not None and study.recommended.local == frozenset()
    assert study.verdict.code == "CL700"


@pytest.fixture(scope="module")
def unequal() -> SwapStudy:
    return studied([("strong", rigid("other", 2.0))])


@pytest.mark.slow
def test_axes_of_different_gain_need_one_local_parameter(unequal: SwapStudy) -> None:
    # A rigid frictionless axis under eq (15) follows exactly when a' is its own gain, for any other gains: so one local parameter.
    study = unequal
    assert not study.full and study.base.swap_loss > 1.0
    assert study.recommended is not None
    assert study.recommended.local == {AHEAD}
    assert study.recommended.swap_loss < 0.03 and study.verdict.code == "CL701" and study.verdict.values["names"] == "x.model_gain"
    # The held command moves the best a' off the plant's gain by half a servo period in relation to the loop's time.
    assert [values[AHEAD] for values in study.recommended.parameters] == pytest.approx([1.0, 2.0], rel=0.05)


def test_the_best_value_considers_every_search(unequal: SwapStudy) -> None:
    assert (unequal.variants.best <= [optimum.value for optimum in unequal.optima]).all()
    for choice in unequal.choices:
        assert (choice.losses >= 0.0).all()


def test_more_local_parameters_never_lose_more(unequal: SwapStudy) -> None:
    for less in unequal.choices:
        for more in unequal.choices:
            if set(less.local) <= set(more.local):
                assert more.swap_loss <= less.swap_loss


def test_the_picture_has_one_row_per_number_of_local_parameters(unequal: SwapStudy) -> None:
    first, second = matrices(unequal)
    sizes = {len(choice.local) for choice in unequal.choices}
    assert first.rows[0] == "nothing local" and len(first.rows) == len(sizes) and first.losses.shape == (len(sizes), 2)
    assert (first.losses.max(axis=1)[1:] <= first.losses[0].max()).all() and len(second.rows) == 3


def test_diagonal_of_the_crossed_designs_is_the_best(unequal: SwapStudy) -> None:
    assert np.diag(unequal.crossed) == pytest.approx(unequal.variants.best, rel=1e-12)


@pytest.mark.parametrize("settings", [{}, {"local": (frozenset({AHEAD}),)}, {"exhaustive": True}])
@pytest.mark.slow
def test_no_found_design_improves_a_shared_one(settings: dict[str, object]) -> None:
    variants = variants_under([("like", rigid("other", 1.01))], ("controller.axes.x.controller.*_gain",))
    names = tuple(name for name in variants.space.names if ".axes.x." in name)
    study = swap_study(variants, names, SwapSettings(budget=100, **settings))  # type: ignore[arg-type]
    shared = [np.tile(point, (len(variants), 1)) for point in variants.best_points]
    for choice in study.choices:
        shared += merged(choice.points, np.full(choice.points.shape[1], True))
    values, broken = variants.values(np.stack(shared, axis=1))
    assert (broken == 0.0).all()
    assert study.base.swap_loss <= variants.losses(values.T).max(axis=1).min() + 1e-12


def test_a_stalled_search_is_inconclusive(unequal: SwapStudy) -> None:
    assert unequal.inconclusive == ()
    best, floor = unequal.variants.best, unequal.variants.floor
    above = replace(unequal.optima[1], value=float(best[1]) + 0.1 * floor)
    for late in (above, replace(above, again=np.inf), replace(above, value=np.inf)):
        short = replace(unequal, optima=(unequal.optima[0], late))
        assert short.inconclusive == ("x = strong",) and short.recommended is not None
        assert short.verdict.code == "CL703" and short.verdict.values["names"] == ("x = strong",)
        assert not re.search(r"\b(inf|nan)\b", str(short.verdict))
        assert not SwapResult(short, judged_exactly(short)).passed
    # A second, independent search that reaches it settles the result.
    assert replace(unequal, optima=(unequal.optima[0], replace(above, again=float(best[1]) + 0.01 * floor))).inconclusive == ()


def test_inconclusive_results_are_hatched(unequal: SwapStudy) -> None:
    assert not any(matrix.uncertain.any() for matrix in matrices(unequal))
    best, floor = float(unequal.variants.best[1]), unequal.variants.floor
    short = replace(unequal, optima=(unequal.optima[0], replace(unequal.optima[1], value=best + 0.1 * floor)))
    for matrix in matrices(short):
        assert not matrix.uncertain[:, 0].any()
        # A loss over the limit is certain; one under it may not be.
        np.testing.assert_array_equal(matrix.uncertain[:, 1], matrix.losses[:, 1] < 0.03)
    first = matrices(short)[0]
    place = drawing([first], 0.03).axes[0]
    assert len(place.patches) == np.count_nonzero(first.uncertain) > 0 and all(patch.get_hatch() for patch in place.patches)
    assert place.images[0].get_array()[first.uncertain].mask.all()


@pytest.mark.slow
def test_a_variant_whose_search_stalled_is_searched_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = SwapSearch.variant_optimum

    def stalled(search: SwapSearch, i: int, *, again: bool = False) -> searches.Optimum:
        if again:
            return whole(search, i, again=True)
        values, _ = search.variants.values(search.variants.space.start[None, None], (i,))
        return searches.Optimum(float(values[0, 0]), np.full(5, values[0, 0]))

    monkeypatch.setattr(SwapSearch, "variant_optimum", stalled)
    study, checkpoint = kept_study(tmp_path / "whole", budget=200)
    assert study.inconclusive == ()
    for optimum, best in zip(study.optima, study.variants.best, strict=True):
        assert optimum.value - best > 0.03 * study.variants.floor > optimum.again - best >= 0.0
    # The same after an interrupt.
    kept = len(list(checkpoint.home.iterdir()))
    with pytest.raises(KeyboardInterrupt):
        kept_study(tmp_path / "again", stop_at="x = strong alone, again", budget=200)
    resumed, checkpoint = kept_study(tmp_path / "again", budget=200)
    assert 0 < checkpoint.reused < kept and all_results(resumed) == all_results(study)


@pytest.mark.slow
def test_same_study_on_any_number_of_threads() -> None:
    found = []
    for threads in (1, 2):
        variants = replace(variants_under([("strong", rigid("other", 2.0))]), threads=threads)
        study = swap_study(variants, (AHEAD,), SwapSettings(budget=100))
        found.append([choice.values.tolist() for choice in study.choices])
    assert found[0] == found[1]


@pytest.mark.slow
def test_given_sets_replace_the_search() -> None:
    study = studied([("strong", rigid("other", 2.0))], budget=100, local=(frozenset({AHEAD}),))
    assert [len(choice.local) for choice in study.choices] == [0, 1]


def test_variants_that_differ_in_numbers_give_the_same_bits_in_one_batch() -> None:
    variants = variants_under([("strong", rigid("other", 2.0)), ("weak", rigid("other", 0.7))])
    assert variants.numbers == tuple({"axes.x.plant.gain": gain} for gain in (1.0, 2.0, 0.7))
    apart = replace(variants)
    apart.numbers = ()
    points = np.random.default_rng(2).random((3, 5, 2))
    for only in (None, (2, 0)):
        assert np.array_equal(
            variants.values(points if only is None else points[:2], only), apart.values(points if only is None else points[:2], only)
        )
    other = replace(rigid("other", 1.0), friction=Coulomb(coulomb=0.01))
    assert numbers_of([variants.members[0].machine, variants.members[0].machine.swapped("x", other)], variants.setting.controller) == ()


def test_guards_count_as_constraints() -> None:
    variants = variants_under([("strong", rigid("other", 2.0))])
    strict = replace(variants, bounds=Bounds(40.0, 0.0, 1.0))
    start = np.tile(variants.space.start, (2, 1, 1))
    assert (variants.values(start)[1] == 0.0).all() and (strict.values(start)[1] > 0.0).all()
    with pytest.raises(ContourlabError, match="smaller margins"):
        swap_study(strict, (), SwapSettings(budget=100))


@pytest.mark.slow
def test_coverage_of_a_region_of_gains() -> None:
    variants = variants_under([("strong", rigid("other", 2.0))])
    machine, controller = stage()
    region = Space.chosen(machine, controller, ["axes.x.plant.gain=0.5 m/s^2/full_scale..2 m/s^2/full_scale"])
    at = variants.space.points({AHEAD: 1.0, "controller.axes.y.controller.model_gain": 1.0})[0]
    good = variants.values(np.tile(at, (2, 1))[:, None], whole=True)[0][0, 0]
    over = coverage(variants, at, region, full=0.03, tolerance=20.0 * good)
    gains = region.columns(over.points)["axes.x.plant.gain"]
    # Gains are covered on either side of the feedforward's, without a hole.
    inside = np.sort(gains)[over.values[np.argsort(gains)] <= over.tolerance]
    assert 0.0 < over.share < 1.0 and inside.min() < 1.0 < inside.max()
    assert over.covered == ((gains >= inside.min()) & (gains <= inside.max())).sum()
    low, high = over.interval
    assert low < over.share < high
    searched = coverage(variants, at, region, full=0.03, places=2, budget=200)
    assert len(searched.best) == 2 and (searched.best <= searched.values).all()


def test_a_plant_without_a_feasible_design_is_counted_as_uncovered() -> None:
    """The gains stay fixed: with a plant a hundred times as strong no feedforward makes the loop stable."""
    variants = variants_under([("strong", rigid("other", 2.0))])
    region = Space.chosen(*stage(), ["axes.x.plant.gain=0.5 m/s^2/full_scale..500 m/s^2/full_scale"])
    over = coverage(variants, variants.space.start, region, full=0.03, places=4, budget=100)
    strong = region.columns(over.points)["axes.x.plant.gain"] > 40.0
    assert np.isinf(over.best).tolist() == np.isinf(over.values).tolist() == strong.tolist()
    assert over.without_design == strong.sum() > 0 and over.covered <= 4 - over.without_design and len(over.points) == 4


def test_each_division_has_its_finding_and_names_the_base_parameters(unequal: SwapStudy) -> None:
    best = unequal.recommended
    assert best is not None
    costs = [(division, ways) for division in ("drive", "controller") for ways in ("both", "one")]
    networks = tuple(network_cost(best, *pair, longest=1e-3) for pair in costs)
    result = SwapResult(unequal, judged_exactly(unequal), networks)
    rates = [one.place for one in result.findings if one.code in ("CL705", "CL706", "CL707")]
    assert rates == [cost.name for cost in networks]
    in_base = [one.place for one in result.findings if one.code == "CL710"]
    assert in_base == [cost.name for cost in networks if cost.division == "drive"]
    assert all(len(line) <= 100 for line in text_of(result).splitlines())


def test_local_parameters_of_a_module_do_not_depend_on_other_modules() -> None:
    machine, controller = stage()
    variants = variants_of(machine, {"x": [("b", rigid("o", 2.0))], "y": [("c", rigid("o", 3.0))]})
    assert [v.name for v in variants] == ["x = as it is, y = as it is", "x = as it is, y = c", "x = b, y = as it is", "x = b, y = c"]
    space = Space.chosen(machine, controller, ["model_gain=0.3 m/s^2/full_scale..4 m/s^2/full_scale"])
    division = SharedSpace(space, variants, frozenset({AHEAD}))
    assert division.size == 3
    points = division.spread(np.arange(3.0)[None])[:, 0]
    j = space.names.index(AHEAD)
    assert points[0, j] == points[1, j] != points[2, j] == points[3, j]
    assert len(set(points[:, 1 - j])) == 1
    assert division.gathered(points).tolist() == [0.0, 1.0, 2.0]


def test_a_parameter_of_another_axis_cannot_be_local() -> None:
    variants = variants_under([("strong", rigid("other", 2.0))])
    with pytest.raises(ParameterError, match=r"axes.*base"):
        SharedSpace(variants.space, variants.members, frozenset({"controller.axes.y.controller.model_gain"}))


@pytest.mark.parametrize(
    ("swaps", "said"),
    [
        ({}, "at least one axis to swap"),
        ({"z": [("b", rigid("o", 2.0))]}, "one of x, y"),
        ({"x": []}, "at least one module for axis x"),
        ({"x": [("b", rigid("o", 2.0)), ("b", rigid("o", 3.0))]}, "modules with different names"),
        ({"x": [("b", rigid("o", 1.0))]}, "b: must be a module that differs from axis x of the machine"),
        ({"x": [("b", rigid("o", 2.0)), ("c", rigid("p", 2.0))]}, "b, c: must be modules of axis x that differ"),
        ({"x": [("b", rigid("o", 2.0)), ("c", rigid("p", 1.0)), ("d", rigid("q", 1.0))]}, "c, d: must be modules of axis x that differ"),
        ({"x": [("b", Axis("o", MassDamper(mass=1.0, damping=1.0, force_constant=1.0)))]}, "takes its command in full_scale"),
    ],
)
def test_invalid_swaps_are_refused(swaps: dict[str, list[tuple[str, Axis]]], said: str) -> None:
    machine, _ = stage()
    with pytest.raises(ParameterError, match=said):
        variants_of(machine, swaps)


def test_local_parameters_are_marked_in_their_axis() -> None:
    variants = variants_under([("strong", rigid("other", 2.0))])
    made = variants.controller_at(variants.space.points({AHEAD: 2.0})[0], [AHEAD])
    assert made.axes["x"].controller.values()["model_gain"] == 2.0 and made.axes["x"].local == ("controller.model_gain",)
    assert made.axes["y"].controller.values()["model_gain"] == 1.05 and made.axes["y"].local == ()


def kept_study(
    folder: Path, stop_after: int | None = None, model: str = "one", stop_at: str = "", budget: int = 100
) -> tuple[SwapStudy, Checkpoint]:
    """Return a study with saved searches, or stop it at the start of a stage, given by number or name."""
    variants = variants_under([("strong", rigid("other", 2.0))], ("controller.axes.x.controller.*_gain",))
    checkpoint, begun = Checkpoint(folder, model), list[str]()

    def stage(name: str, most: int) -> None:
        if len(begun) == stop_after or name == stop_at:
            raise KeyboardInterrupt
        begun.append(name)

    candidates = tuple(name for name in variants.space.names if ".axes.x." in name)
    return swap_study(variants, candidates, SwapSettings(budget=budget), stage, checkpoint), checkpoint


def all_results(study: SwapStudy) -> list[object]:
    """Return all results of a study, bit by bit."""
    variants = study.variants
    choices = [[choice.name, choice.points.tobytes(), choice.values.tobytes()] for choice in study.choices]
    optima = [[optimum.value, optimum.per_start.tobytes(), str(optimum.again)] for optimum in study.optima]
    best = [variants.best.tobytes(), variants.best_points.tobytes(), variants.runs, variants.tried]
    return [choices, optima, best, study.crossed.tobytes()]


@pytest.fixture(scope="module")
def uninterrupted(tmp_path_factory: pytest.TempPathFactory) -> tuple[SwapStudy, Checkpoint]:
    return kept_study(tmp_path_factory.mktemp("whole"))


@pytest.mark.slow
def test_an_interrupted_study_continues_with_the_same_bits(uninterrupted: tuple[SwapStudy, Checkpoint], tmp_path: Path) -> None:
    """Each start finds the stages of all before it, and is stopped after one more."""
    whole, kept = uninterrupted
    stages, home = len(list(kept.home.iterdir())), tmp_path / kept.home.name
    assert kept.reused == 0 and stages >= 5
    for after in range(1, stages):
        with pytest.raises(KeyboardInterrupt):
            kept_study(tmp_path, stop_after=after)
        assert len(list(home.iterdir())) == after
    resumed, kept = kept_study(tmp_path)
    assert kept.reused == stages - 1 and all_results(resumed) == all_results(whole)


@pytest.mark.slow
def test_searches_of_another_study_are_ignored_and_damaged_ones_repeated(
    uninterrupted: tuple[SwapStudy, Checkpoint], tmp_path: Path
) -> None:
    whole, first = uninterrupted
    home = tmp_path / first.home.name
    shutil.copytree(first.home, home)
    other, second = kept_study(tmp_path, model="two")
    assert second.reused == 0 and second.others == 1 and all_results(other) == all_results(whole)
    file = sorted(home.iterdir())[0]
    file.write_bytes(file.read_bytes()[:-40])
    again, kept = kept_study(tmp_path)
    assert kept.damaged == 1 and kept.reused == len(list(home.iterdir())) - 1 and all_results(again) == all_results(whole)


@pytest.mark.slow
def test_superfluous_local_parameters_are_dropped() -> None:
    # The other gains of a rigid frictionless axis do not depend on its strength; only a' does.
    variants = variants_under([("strong", rigid("other", 2.0))], ("controller.axes.x.controller.*_gain",))
    names = tuple(name for name in variants.space.names if ".axes.x." in name)
    study = swap_study(variants, names, SwapSettings(budget=600))
    assert len(names) == 4 and study.recommended is not None and study.recommended.local == {AHEAD}
    assert study.choices[0].local == frozenset() and len(study.choices[-1].local) == 4
    # No subset of a failed set was tried.
    failed = [set(choice.local) for choice in study.choices if 0 < len(choice.local) < 4 and choice.swap_loss >= 0.03]
    assert not any(one < other for one in failed for other in failed)


@pytest.mark.slow
def test_the_search_starts_from_a_known_design() -> None:
    variants = variants_under([("strong", rigid("other", 2.0))])
    known = ({AHEAD: 1.0, "controller.axes.y.controller.model_gain": 1.0}, {AHEAD: 2.0, "controller.axes.y.controller.model_gain": 1.0})
    points = np.vstack([variants.space.points(one) for one in known])
    values = variants.values(points[:, None])[0][:, 0]
    study = swap_study(replace(variants), (AHEAD,), SwapSettings(budget=100, known=(known,)))
    assert (study.variants.best <= values).all() and (study.choices[-1].values <= 1.1 * values).all()
