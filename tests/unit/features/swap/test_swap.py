"""Swapping: what a loss is, and cases whose answer is known."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from contourlab.components.controller.position import PositionController
from contourlab.components.friction.laws import NoFriction
from contourlab.components.plant.mass_damper import MassDamper
from contourlab.components.plant.rigid_axis import RigidAxis
from contourlab.design import Space
from contourlab.design.bounds import Bounds
from contourlab.design.values import machine_with
from contourlab.errors import ParameterError
from contourlab.features.swap import course
from contourlab.features.swap.course import made_one
from contourlab.features.swap.coverage import coverage
from contourlab.features.swap.design import evaluated
from contourlab.features.swap.division import Division
from contourlab.features.swap.final import final
from contourlab.features.swap.fleet import Fleet
from contourlab.features.swap.kept import Kept
from contourlab.features.swap.loss import losses, swap_loss
from contourlab.features.swap.network import network_cost
from contourlab.features.swap.numbers import divided_controller
from contourlab.features.swap.own import Own
from contourlab.features.swap.picture import _drawing
from contourlab.features.swap.report import SwapReport
from contourlab.features.swap.settings import SwapSettings
from contourlab.features.swap.study import SwapStudy, swap_study
from contourlab.features.swap.text import matrices, text_of
from contourlab.features.swap.variants import Variant, variants_of
from contourlab.features.swap.verdict import search_words, verdict
from contourlab.feed import uniform
from contourlab.geometry import contour
from contourlab.loop import Axis, AxisController, Controller, Limits, Machine

GAINS = {"velocity_gain": 60.0, "position_gain": 3000.0, "integral_gain": 10.0}
AHEAD = "controller.axes.x.controller.model_gain"


def rigid(name: str, gain: float) -> Axis:
    """Return an axis without damping, friction or counting: a double integrator."""
    return Axis(name, RigidAxis(gain=gain, damping=0.0), friction=NoFriction(), limits=Limits(velocity=1.0))


def stage(gain: float = 1.0) -> tuple[Machine, Controller]:
    machine = Machine("stage", (rigid("x", gain), rigid("y", 1.0)), 1e-3)
    return machine, Controller({n: AxisController(PositionController(**GAINS, model_gain=1.05, model_damping=0.0)) for n in ("x", "y")})


def fleet_of(others: list[tuple[str, Axis]], texts: tuple[str, ...] = ("model_gain=0.3 m/s^2/full_scale..4 m/s^2/full_scale",)) -> Fleet:
    machine, controller = stage()
    variants = variants_of(machine, {"x": others})
    circle = uniform(contour("circle", radius=0.01), 1.0, 2, 1e-3)
    return Fleet(variants, controller, circle, Space.chosen(machine, controller, texts), moving=True, bounds=Bounds(0.0, 0.0, 1.0))


def studied(others: list[tuple[str, Axis]], **settings: object) -> SwapStudy:
    fleet = fleet_of(others)
    candidates = tuple(name for name in fleet.space.names if fleet.variants[0].module(name))
    return swap_study(fleet, candidates, SwapSettings(budget=700, **settings))  # type: ignore[arg-type]


def test_loss_is_counted_from_the_larger_of_best_and_floor() -> None:
    assert losses([3e-6, 12e-6], [1e-6, 10e-6], 2e-6) == pytest.approx([1.0, 0.2])
    assert swap_loss([3e-6, 12e-6], [1e-6, 10e-6], 2e-6) == pytest.approx(1.0)
    assert swap_loss([1e-6], [1e-6], 2e-6) == 0.0


def test_a_copy_of_the_axis_loses_nothing() -> None:
    fleet = fleet_of([("strong", rigid("other", 2.0))])
    copy = Variant("x = copy", fleet.variants[0].machine.swapped("x", rigid("other", 1.0)), (("x", "copy"),))
    study = swap_study(replace(fleet, variants=(fleet.variants[0], copy)), (AHEAD,), SwapSettings(budget=700))
    assert study.full and study.base.loss < 1e-3
    assert study.recommended is not None and study.recommended.effort == 0
    assert "full modularity" in verdict(study)


@pytest.fixture(scope="module")
def unequal() -> SwapStudy:
    return studied([("strong", rigid("other", 2.0))])


def test_axes_that_differ_in_gain_want_one_local_number(unequal: SwapStudy) -> None:
    # A rigid frictionless axis under eq (15) follows exactly when a' is its own gain, whatever its other gains are: so one local number.
    study = unequal
    assert not study.full and study.base.loss > 1.0
    assert study.recommended is not None
    assert study.recommended.design.local == {AHEAD}
    assert study.recommended.loss < 0.03 and "1 local number: x.model_gain" in verdict(study)
    number = next(n for n in study.fleet.space.numbers if n.name == AHEAD)
    j = study.fleet.space.names.index(AHEAD)
    # The held command moves the best a' off the gain of the plant by what half a servo period is of the loop's time.
    assert number.physical(study.recommended.design.points[:, j]) == pytest.approx([1.0, 2.0], rel=0.05)


def test_best_value_counts_every_search(unequal: SwapStudy) -> None:
    assert (unequal.fleet.best <= [own.value for own in unequal.owns]).all()
    for choice in unequal.choices:
        assert (choice.losses >= 0.0).all()


def test_more_local_numbers_never_lose_more(unequal: SwapStudy) -> None:
    for less in unequal.choices:
        for more in unequal.choices:
            if less.design.local <= more.design.local:
                assert more.loss <= less.loss


def test_the_picture_has_one_row_for_each_number_of_local_numbers(unequal: SwapStudy) -> None:
    first, second = matrices(unequal)
    efforts = {choice.effort for choice in unequal.choices}
    assert first.rows[0] == "nothing" and len(first.rows) == len(efforts) and first.losses.shape == (len(efforts), 2)
    assert (first.losses.max(axis=1)[1:] <= first.losses[0].max()).all() and len(second.rows) == 3


def test_diagonal_of_the_crossed_designs_is_the_best(unequal: SwapStudy) -> None:
    assert np.diag(unequal.crossed) == pytest.approx(unequal.fleet.best, rel=1e-12)


@pytest.mark.parametrize("settings", [{}, {"local": (frozenset({AHEAD}),)}, {"exhaustive": True}])
def test_no_design_that_was_found_makes_a_better_shared_one(settings: dict[str, object]) -> None:
    fleet = fleet_of([("like", rigid("other", 1.01))], ("x.*_gain",))
    names = tuple(name for name in fleet.space.names if ".axes.x." in name)
    study = swap_study(fleet, names, SwapSettings(budget=100, **settings))  # type: ignore[arg-type]
    shared = [np.tile(point, (fleet.n_variant, 1)) for point in fleet.best_points]
    for choice in study.choices:
        shared += made_one(fleet, choice.design, fleet.space.names)
    values, broken = fleet.values(np.stack(shared, axis=1))
    assert (broken == 0.0).all()
    assert study.base.loss <= min(swap_loss(mine, fleet.best, fleet.floor) for mine in values.T) + 1e-12


def test_a_search_that_fell_short_makes_no_verdict(unequal: SwapStudy) -> None:
    assert unequal.fell_short == ()
    best, floor = unequal.fleet.best, unequal.fleet.floor
    # Above what another search found, shown where that was or not; or still falling.
    above = [replace(own, value=float(value) + 0.1 * floor) for own, value in zip(unequal.owns, best, strict=True)]
    value = float(best[1])
    shown = replace(above[1], on=np.array([[value, value]]))
    falling = replace(unequal.owns[1], on=np.array([[value + 0.1 * floor, value]]))
    for late in (above[1], shown, falling, replace(shown, afresh=np.inf)):
        short = replace(unequal, owns=(unequal.owns[0], late))
        assert short.fell_short == ("x = strong",) and short.recommended is not None
        assert re.search(r"the least is at least [\d.e+]+ %, with nothing local", verdict(replace(short, choices=short.choices[:1])))
        assert verdict(short).startswith("not told: the searches for x = strong alone did not come within 3 % of what others")
    # One that came there by itself the second time is told.
    assert replace(unequal, owns=(unequal.owns[0], replace(shown, afresh=value + 0.01 * floor))).fell_short == ()


def test_what_is_not_told_is_not_coloured(unequal: SwapStudy) -> None:
    assert not any(one.untold.any() for one in matrices(unequal) if one.untold is not None)
    best, floor = float(unequal.fleet.best[1]), unequal.fleet.floor
    short = replace(unequal, owns=(unequal.owns[0], replace(unequal.owns[1], value=best + 0.1 * floor)))
    for one in matrices(short):
        assert one.untold is not None and not one.untold[:, 0].any()
        # What is over the limit is so for certain; what is under it may not be.
        np.testing.assert_array_equal(one.untold[:, 1], one.losses[:, 1] < 0.03)
        assert all(row[1].startswith(("at least ", "breaks")) and not row[0].startswith("at least") for row in one.texts)
    first = matrices(short)[0]
    figure = _drawing([first], 0.03, "a")
    place = figure.axes[0]
    assert len(place.patches) == np.count_nonzero(first.untold) > 0 and all(patch.get_hatch() for patch in place.patches)
    assert place.images[0].get_array()[first.untold].mask.all() and "not told" in figure._supxlabel.get_text()


def starved(fleet: Fleet, i: int, *, budget: int, seed: int, starts: object, spread: float = 0.2) -> Own:
    """Return what a search that stays where it starts comes to."""
    values, _ = fleet.values(fleet.space.start[None, None], (i,))
    return Own(fleet.space.start, float(values[0, 0]), np.full(5, values[0, 0]), 1)


def test_a_search_that_stuck_goes_on_from_where_a_shared_one_found_better(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(course, "best_of_its_own", starved)
    whole, kept = kept_study(tmp_path / "whole")
    assert all(len(own.on) for own in whole.owns) and whole.fell_short == ()
    for own, best in zip(whole.owns, whole.fleet.best, strict=True):
        # Each goes on from what another search found, and no search lies.
        assert own.value > own.on[0, 0] >= own.on[0, 1] >= best and (own.on[1:, 0] <= own.on[:-1, 1]).all()
        # It is told because a second search came there by itself.
        assert own.value - best > 0.03 * whole.fleet.floor > own.afresh - best >= 0.0
    assert all("of another search to" in words for words in search_words(whole) if words.startswith("x ="))
    assert [choice.loss for choice in whole.choices] == [
        swap_loss(choice.design.values, whole.fleet.best, whole.fleet.floor) for choice in whole.choices
    ]
    # And so it does after an interrupt.
    stages = len(list(kept.home.iterdir()))
    with pytest.raises(KeyboardInterrupt):
        kept_study(tmp_path / "again", stop_at="x = strong alone, once more")
    resumed, kept = kept_study(tmp_path / "again")
    assert 0 < kept.found < stages and told(resumed) == told(whole)


def test_same_study_on_any_number_of_threads() -> None:
    found = []
    for threads in (1, 2):
        fleet = replace(fleet_of([("strong", rigid("other", 2.0))]), threads=threads)
        study = swap_study(fleet, (AHEAD,), SwapSettings(budget=300))
        found.append([choice.design.values.tolist() for choice in study.choices])
    assert found[0] == found[1]


def test_chosen_sets_are_looked_at_in_place_of_a_search() -> None:
    study = studied([("strong", rigid("other", 2.0))], local=(frozenset({AHEAD}),))
    assert [choice.effort for choice in study.choices] == [0, 1] and not study.ranking


def test_guards_count() -> None:
    fleet = fleet_of([("strong", rigid("other", 2.0))])
    strict = replace(fleet, bounds=Bounds(40.0, 0.0, 1.0))
    start = np.tile(fleet.space.start, (2, 1))
    assert np.isfinite(evaluated(fleet, frozenset(), start).values).all()
    assert not np.isfinite(evaluated(strict, frozenset(), start).values).any()
    with pytest.raises(ParameterError, match="smaller margins"):
        swap_study(strict, (), SwapSettings(budget=100))


def test_coverage_of_a_region_of_gains() -> None:
    fleet = fleet_of([("strong", rigid("other", 2.0))])
    machine, controller = stage()
    region = Space.chosen(machine, controller, ["axes.x.plant.gain=0.5 m/s^2/full_scale..2 m/s^2/full_scale"])
    at = fleet.space.points({AHEAD: 1.0, "controller.axes.y.controller.model_gain": 1.0})[0]
    good = fleet.values(np.tile(at, (2, 1))[:, None], whole=True)[0][0, 0]
    over = coverage(fleet, at, region, full=0.03, tolerance=20.0 * good)
    gains = region.columns(over.points)["axes.x.plant.gain"]
    # Gains are covered on either side of the one that the feedforward has, without a hole.
    inside = np.sort(gains)[over.values[np.argsort(gains)] <= over.tolerance]
    assert 0.0 < over.share < 1.0 and inside.min() < 1.0 < inside.max()
    assert over.covered == ((gains >= inside.min()) & (gains <= inside.max())).sum()
    low, high = over.bounds
    assert low < over.share < high
    searched = coverage(fleet, at, region, full=0.03, places=2, budget=200)
    assert len(searched.best) == 2 and (searched.best <= searched.values).all()


def test_a_plant_that_no_design_keeps_is_not_covered_and_is_counted() -> None:
    """The gains stay, and with a plant a hundred times as strong no feedforward makes the loop stable."""
    fleet = fleet_of([("strong", rigid("other", 2.0))])
    region = Space.chosen(*stage(), ["axes.x.plant.gain=0.5 m/s^2/full_scale..500 m/s^2/full_scale"])
    over = coverage(fleet, fleet.space.start, region, full=0.03, places=4, budget=100)
    strong = region.columns(over.points)["axes.x.plant.gain"] > 40.0
    assert np.isinf(over.best).tolist() == np.isinf(over.values).tolist() == strong.tolist()
    assert over.without == strong.sum() > 0 and over.covered <= over.judged - over.without
    assert over.judged == 4


def test_each_division_that_was_asked_for_is_in_the_verdict(unequal: SwapStudy) -> None:
    """What one of them leaves in the base is said with it, and once, whichever ways messages go."""
    best = unequal.recommended
    assert best is not None
    costs = [(division, ways) for division in ("drive", "controller") for ways in ("both", "one")]
    given = unequal.fleet, best.design.points, best.design.local
    networks = tuple(network_cost(*given, *one, longest=1e-3) for one in costs)
    report = SwapReport(unequal, final(unequal.fleet, best.design.points), networks)
    for ways in ("both ways", "one way"):
        assert f"with the drive in the axis (x.model_gain set in the base for each axis) and messages {ways} " in report.verdict
        assert f"with the controller in the axis and messages {ways} " in report.verdict
    assert text_of(report).count("drive: x.model_gain would have to be set in the base for each axis") == 1


def test_modules_keep_their_local_numbers_in_any_company() -> None:
    machine, controller = stage()
    variants = variants_of(machine, {"x": [("b", rigid("o", 2.0))], "y": [("c", rigid("o", 3.0))]})
    assert [v.name for v in variants] == ["x = as it is, y = as it is", "x = as it is, y = c", "x = b, y = as it is", "x = b, y = c"]
    space = Space.chosen(machine, controller, ["model_gain=0.3 m/s^2/full_scale..4 m/s^2/full_scale"])
    division = Division(space, variants, frozenset({AHEAD}))
    assert division.size == 3
    points = division.spread(np.arange(3.0)[None])[:, 0]
    j = space.names.index(AHEAD)
    assert points[0, j] == points[1, j] != points[2, j] == points[3, j]
    assert len(set(points[:, 1 - j])) == 1
    assert division.gathered(points).tolist() == [0.0, 1.0, 2.0]


def test_a_number_of_another_axis_cannot_be_local() -> None:
    fleet = fleet_of([("strong", rigid("other", 2.0))])
    with pytest.raises(ParameterError, match="those of other axes are base"):
        Division(fleet.space, fleet.variants, frozenset({"controller.axes.y.controller.model_gain"}))


@pytest.mark.parametrize(
    ("swaps", "said"),
    [
        ({}, "at least one axis to swap"),
        ({"z": [("b", rigid("o", 2.0))]}, "one of x, y"),
        ({"x": []}, "take the place of x"),
        ({"x": [("b", rigid("o", 2.0)), ("b", rigid("o", 3.0))]}, "differ in their names"),
        ({"x": [("b", rigid("o", 1.0))]}, "b: must be an axis that differs from axis x of the machine in a value"),
        ({"x": [("b", rigid("o", 2.0)), ("c", rigid("p", 2.0))]}, "b, c: must be axes that differ in a value"),
        ({"x": [("b", rigid("o", 2.0)), ("c", rigid("p", 1.0)), ("d", rigid("q", 1.0))]}, "c, d: must be axes that differ"),
        ({"x": [("b", Axis("o", MassDamper(mass=1.0, damping=1.0, force_constant=1.0)))]}, "takes its command in full_scale"),
    ],
)
def test_what_cannot_be_swapped_is_refused(swaps: dict[str, list[tuple[str, Axis]]], said: str) -> None:
    machine, _ = stage()
    with pytest.raises(ParameterError, match=said):
        variants_of(machine, swaps)


def test_numbers_are_put_in_their_places() -> None:
    machine, controller = stage()
    made = divided_controller(controller, {AHEAD: 2.0}, [AHEAD])
    assert made.axes["x"].controller.values()["model_gain"] == 2.0 and made.axes["x"].local == ("controller.model_gain",)
    assert made.axes["y"].controller.values()["model_gain"] == 1.05 and made.axes["y"].local == ()
    assert machine_with(machine, {"axes.x.plant.gain": 3.0}).axis("x").plant.values()["gain"] == 3.0
    assert isinstance(Variant("a", machine), Variant)


def kept_study(folder: Path, stop_after: int | None = None, model: str = "one", stop_at: str = "") -> tuple[SwapStudy, Kept]:
    """Return a study of which the searches are kept, or stop at the beginning of a stage, by their number or its name."""
    fleet, kept, begun = fleet_of([("strong", rigid("other", 2.0))], ("*.x.controller.*_gain",)), Kept(folder, model), []

    def stage(said: str, most: int) -> None:
        if len(begun) == stop_after or said == stop_at:
            raise KeyboardInterrupt
        if most:  # else it is no search
            begun.append(said)

    candidates = tuple(name for name in fleet.space.names if ".axes.x." in name)
    return swap_study(fleet, candidates, SwapSettings(budget=200), stage, kept), kept


def told(study: SwapStudy) -> list[object]:
    """Return all that a study says, bit by bit."""
    fleet = study.fleet
    designs = [
        [choice.name, choice.design.points.tobytes(), choice.design.values.tobytes(), choice.design.per_start.tobytes(), choice.design.runs]
        for choice in study.choices
    ]
    owns = [[own.point.tobytes(), own.value, own.per_start.tobytes(), own.runs, own.on.tobytes(), str(own.afresh)] for own in study.owns]
    return [
        designs,
        owns,
        fleet.best.tobytes(),
        fleet.best_points.tobytes(),
        fleet.runs,
        fleet.tried,
        study.crossed.tobytes(),
        study.ranking,
    ]


def test_an_interrupted_study_goes_on_to_the_same_bits(tmp_path: Path) -> None:
    whole, kept = kept_study(tmp_path / "whole")
    stages = len(list(kept.home.iterdir()))
    assert kept.found == 0 and stages >= 5
    for after in range(1, stages, 2):
        folder = tmp_path / str(after)
        with pytest.raises(KeyboardInterrupt):
            kept_study(folder, stop_after=after)
        resumed, kept = kept_study(folder)
        assert kept.found == after and told(resumed) == told(whole)


def test_searches_of_another_study_are_left_alone_and_damaged_ones_made_again(tmp_path: Path) -> None:
    whole, first = kept_study(tmp_path)
    other, second = kept_study(tmp_path, model="two")
    assert second.found == 0 and second.others == 1 and told(other) == told(whole)
    file = sorted(first.home.iterdir())[0]
    file.write_bytes(file.read_bytes()[:-40])
    again, kept = kept_study(tmp_path)
    assert kept.damaged == 1 and kept.found == len(list(first.home.iterdir())) - 1 and told(again) == told(whole)


def test_numbers_that_are_not_missed_are_dropped() -> None:
    # The other gains of a rigid frictionless axis do not move with its strength, only a' does.
    fleet = fleet_of([("strong", rigid("other", 2.0))], ("x.*_gain",))
    names = tuple(name for name in fleet.space.names if ".axes.x." in name)
    study = swap_study(fleet, names, SwapSettings(budget=600))
    assert len(names) == 4 and study.recommended is not None and study.recommended.design.local == {AHEAD}
    assert study.choices[0].effort == 0 and study.choices[-1].effort == 4
    assert "found by dropping" in verdict(study)
    # Nothing was tried within a set that failed.
    tried = [choice for choice in study.choices if 0 < choice.effort < 4]
    failed = [choice.design.local for choice in tried if choice.loss >= 0.03]
    assert not any(one < other for one in failed for other in failed)


def test_a_known_design_is_started_from() -> None:
    fleet = fleet_of([("strong", rigid("other", 2.0))])
    known = ({AHEAD: 1.0, "controller.axes.y.controller.model_gain": 1.0}, {AHEAD: 2.0, "controller.axes.y.controller.model_gain": 1.0})
    points = np.vstack([fleet.space.points(one) for one in known])
    values = fleet.values(points[:, None])[0][:, 0]
    study = swap_study(replace(fleet), (AHEAD,), SwapSettings(budget=100, known=(known,)))
    assert (study.fleet.best <= values).all() and (study.choices[-1].design.values <= 1.1 * values).all()
