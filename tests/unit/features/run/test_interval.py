"""The interval of contour error from stated deviations, against closed forms."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import norm, spearmanr, truncnorm

from contourlab.components.controller.cascade import Cascade
from contourlab.components.controller.position import PositionController
from contourlab.components.disturbance.loads import ConstantLoad
from contourlab.components.drive.saturation import Saturation
from contourlab.components.friction.laws import Coulomb
from contourlab.components.origin import Origin
from contourlab.components.plant.plant import MassDamper
from contourlab.features.run.trust import SAMPLES, draw, main_contributor, noticeable, part_interval
from contourlab.feed import Reference
from contourlab.geometry import Line, Path
from contourlab.loop import Axis, AxisController, Controller, Limits, Machine, simulate_batch
from contourlab.rendering.judgement import Rank
from contourlab.rendering.origins import numbers_of
from contourlab.study import Setting

PERIOD = 1e-3
GAIN, FORCE_CONSTANT = 4000.0, 50.0
FITTED = {"source": "fitted", "reference": "log"}


def axis(name: str, push_force: float = 0.0, /, **origins: Origin) -> Axis:
    plant = MassDamper(mass=20.0, damping=100.0, force_constant=FORCE_CONSTANT)
    plant = plant.traced({key: origin for key, origin in origins.items() if key in plant.parameters})
    push = ConstantLoad(force=push_force).traced({"force": origins["force"]} if "force" in origins else {})
    return Axis(name, plant, disturbance=push, limits=Limits(following_error=1.0))


def machine(*axes: Axis) -> Machine:
    return Machine("m", axes, PERIOD)


def controller() -> Controller:
    law = PositionController(position_gain=GAIN, velocity_gain=100.0)  # overdamped: no overshoot
    return Controller({name: AxisController(law) for name in ("x", "y")})


def along_x(n: int = 2000) -> Reference:
    """Return a motion along x: the contour error is the distance of y from zero."""
    x = 0.1 * np.linspace(0.0, 1.0, n) ** 2
    line = Path([Line(np.zeros(2), np.array([0.2, 0.0]))])
    return Reference.from_samples(np.column_stack([x, np.zeros(n)]), PERIOD, line)


def uncertain(found: Machine, law: Controller) -> list:
    return [number for number in numbers_of(found, law) if number.drawn]


def test_a_force_across_the_path_gives_the_quantiles_of_its_normal_distribution() -> None:
    """The loop is linear and settles at F/(K_P K_f): this is a sample's largest contour error, and the rms is proportional to it."""
    law, force, deviation = controller(), 40.0, 5.0
    found = part_interval(Setting(machine(axis("x"), axis("y", force, force=Origin(**FITTED, deviation=deviation))), law, along_x()))
    pushes = found.values["axes.y.disturbance.force"]
    assert (found.samples, found.failed) == (SAMPLES, 0)
    assert found.figures["max"] == pytest.approx(pushes / (GAIN * FORCE_CONSTANT), rel=1e-9)
    share = found.figures["rms"] / found.figures["max"]
    assert share == pytest.approx(np.full(SAMPLES, share[0]), rel=1e-9)
    # Each of 64 strata of equal probability holds one point, so a quantile of the sample is at most two strata off.
    for spread, factor in ((found.max, 1.0 / (GAIN * FORCE_CONSTANT)), (found.rms, share[0] / (GAIN * FORCE_CONSTANT))):
        assert spread is not None
        for value, level in ((spread.low, 0.05), (spread.median, 0.5), (spread.high, 0.95)):
            low, high = norm.ppf([level - 2.0 / SAMPLES, level + 2.0 / SAMPLES], force, deviation) * factor
            assert low <= value <= high
    assert found.main == "axes.y.disturbance.force"
    assert (found.ranks[0].rms, found.ranks[0].max) == pytest.approx((1.0, 1.0))
    assert [one.code for one in found.findings] == ["CL225", "CL228"]


def test_geometric_errors_are_left_out_and_named() -> None:
    given = axis("y", 40.0, force=Origin("fitted", deviation=5.0, reference="log"))
    bent = replace(machine(axis("x"), given), squareness={("x", "y"): 1e-3})
    for built, told in ((replace(bent, squareness={}), 0), (bent, 1)):
        found = part_interval(Setting(built, controller(), along_x()))
        assert [one.code for one in found.findings].count("CL230") == told


def test_a_number_without_effect_has_no_significant_rank() -> None:
    pushed = axis("y", 40.0, force=Origin(**FITTED, deviation=5.0))
    moving = axis("x", mass=Origin(**FITTED, deviation=1.0))
    found = part_interval(Setting(machine(moving, pushed), controller(), along_x()))
    assert [rank.name for rank in found.ranks] == ["axes.y.disturbance.force", "axes.x.plant.mass"]
    assert max(abs(found.ranks[1].rms), abs(found.ranks[1].max)) < found.noticeable
    told = spearmanr(found.values["axes.x.plant.mass"], found.figures["rms"]).statistic
    assert found.ranks[1].rms == pytest.approx(told)


def test_the_threshold_of_chance_is_that_of_a_test_at_five_percent() -> None:
    """For independent numbers one correlation in twenty exceeds it."""
    found = part_interval(Setting(machine(axis("x"), axis("y", 40.0, force=Origin(**FITTED, deviation=5.0))), controller(), along_x(50)))
    rng = np.random.default_rng(1)
    beyond = [abs(spearmanr(*rng.standard_normal((2, SAMPLES))).statistic) > found.noticeable for _ in range(2000)]
    assert 0.03 < np.mean(beyond) < 0.07


@pytest.mark.slow
def test_of_many_numbers_without_effect_none_is_significant() -> None:
    """The largest of thirty chance correlations exceeds the threshold in one study of twenty, not in most."""
    rng = np.random.default_rng(2)
    named = 0
    for _ in range(400):
        figure, *numbers = rng.standard_normal((31, SAMPLES))
        ranks = [Rank(f"n{i}", *2 * (float(spearmanr(values, figure).statistic),)) for i, values in enumerate(numbers)]
        named += bool(main_contributor(sorted(ranks, key=lambda one: -abs(one.rms)), noticeable(30, SAMPLES)))
    assert 0.02 < named / 400 < 0.08


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_threads_change_nothing(threads: int) -> None:
    pair = machine(axis("x", mass=Origin(**FITTED, deviation=1.0)), axis("y", 40.0, force=Origin(**FITTED, deviation=5.0)))
    one, other = (part_interval(Setting(pair, controller(), along_x(200)), threads=n) for n in (1, threads))
    for name in ("rms", "max"):
        assert one.figures[name].tobytes() == other.figures[name].tobytes()
    assert one.ranks == other.ranks


def test_the_points_follow_from_the_seed() -> None:
    pair = machine(axis("x"), axis("y", 40.0, force=Origin(**FITTED, deviation=5.0)))
    law = controller()
    points = [draw(uncertain(pair, law), pair, law, seed)["axes.y.disturbance.force"] for seed in (0, 0, 1)]
    assert np.array_equal(points[0], points[1])
    assert not np.array_equal(points[0], points[2])


def test_samples_stay_within_the_bounds_of_the_component() -> None:
    """A mass of 1 kg +- 1 kg stays positive: the samples follow a truncated normal distribution."""
    light = replace(axis("y"), plant=MassDamper(mass=1.0, damping=0.5, force_constant=1.0))
    plant = light.plant.traced({"mass": Origin(**FITTED, deviation=1.0), "damping": Origin(**FITTED, deviation=2.0)})
    pair, law = machine(axis("x"), replace(light, plant=plant)), controller()
    points = draw(uncertain(pair, law), pair, law, 0, 1024)
    mass, damping = points["axes.y.plant.mass"], points["axes.y.plant.damping"]
    assert mass.min() > 0.0 and damping.min() >= 0.0
    for values, mean, deviation in ((mass, 1.0, 1.0), (damping, 0.5, 2.0)):
        cut = truncnorm(-mean / deviation, np.inf, mean, deviation)
        assert np.quantile(values, [0.05, 0.5, 0.95]) == pytest.approx(cut.ppf([0.05, 0.5, 0.95]), rel=0.02)


def test_a_uniform_range_is_filled_evenly() -> None:
    ranged = axis("y", 40.0, force=Origin("datasheet", span=(30.0, 60.0)))
    pair, law = machine(axis("x"), ranged), controller()
    points = np.sort(draw(uncertain(pair, law), pair, law, 3)["axes.y.disturbance.force"])
    edges = np.linspace(30.0, 60.0, SAMPLES + 1)
    assert np.all((points >= edges[:-1]) & (points <= edges[1:]))


def test_correlated_numbers_move_together() -> None:
    origin = Origin(**FITTED, deviation=0.5)
    fitted = replace(axis("y", 40.0, force=origin, mass=origin, damping=origin), correlations=(("plant.mass", "disturbance.force", -0.8),))
    pair, law = machine(axis("x"), fitted), controller()
    points = draw(uncertain(pair, law), pair, law, 0, 4096)
    found = np.corrcoef([points[f"axes.y.{name}"] for name in ("plant.mass", "disturbance.force", "plant.damping")])
    assert found == pytest.approx(np.array([[1.0, -0.8, 0.0], [-0.8, 1.0, 0.0], [0.0, 0.0, 1.0]]), abs=0.02)
    assert points["axes.y.plant.mass"].std() == pytest.approx(0.5, rel=0.01)


def test_correlated_numbers_of_two_axes_move_together() -> None:
    origin = Origin(**FITTED, deviation=0.5)
    x, y = (replace(axis(name, 40.0, force=origin, mass=origin), correlations=(("plant.mass", "disturbance.force", 0.5),)) for name in "xy")
    pair, law = replace(machine(x, y), correlations=(("x.plant.mass", "y.plant.mass", -0.6),)), controller()
    points = draw(uncertain(pair, law), pair, law, 0, 4096)
    found = np.corrcoef([points[f"axes.{name}"] for name in ("x.plant.mass", "y.plant.mass", "x.disturbance.force")])
    assert found == pytest.approx(np.array([[1.0, -0.6, 0.5], [-0.6, 1.0, 0.0], [0.5, 0.0, 1.0]]), abs=0.02)
    assert pair.swapped("x", y).correlations == (), "another axis was fitted apart"


def test_controller_parameters_are_not_varied() -> None:
    law = controller()
    stated = law.axes["y"].controller.traced({"position_gain": Origin(**FITTED, deviation=100.0)})
    law = replace(law, axes={**law.axes, "y": replace(law.axes["y"], controller=stated)})
    found = part_interval(Setting(machine(axis("x"), axis("y", 40.0)), law, along_x(50)))
    assert ([one.code for one in found.findings], found.samples) == (["CL220"], 0)
    assert found.main == "" and found.rms is None


def test_a_machine_of_exact_numbers_has_no_interval_and_says_why() -> None:
    def exact(one: Axis) -> Axis:
        stated = {slot: getattr(one, slot) for slot in ("plant", "disturbance")}
        return replace(one, **{slot: part.traced(dict.fromkeys(part.parameters, Origin("design"))) for slot, part in stated.items()})

    found = part_interval(Setting(machine(exact(axis("x")), exact(axis("y", 40.0))), controller(), along_x(50)))
    assert [one.code for one in found.findings] == ["CL221"]
    found = part_interval(Setting(machine(exact(axis("x")), axis("y", 40.0)), controller(), along_x(50)))
    assert [one.code for one in found.findings] == ["CL220"]


def test_samples_equal_those_of_a_batch_and_are_counted_against_the_tolerance() -> None:
    pair, law = machine(axis("x"), axis("y", 40.0, force=Origin(**FITTED, deviation=5.0))), controller()
    reference, tolerance = along_x(), 40.0 / (GAIN * FORCE_CONSTANT)
    found = part_interval(Setting(pair, law, reference), tolerance=tolerance)
    again = simulate_batch(pair, law, reference, found.values)
    assert np.array_equal(again.figures["contour_error_rms"], found.figures["rms"])
    assert found.beyond_tolerance == SAMPLES // 2  # the tolerance is the mean, and the points lie evenly around it


def test_failed_samples_are_counted_and_widen_the_interval() -> None:
    pair = machine(axis("x"), axis("y", 40.0, force=Origin(**FITTED, deviation=5.0)))
    tripping = replace(pair, axes=(pair.axes[0], replace(pair.axes[1], limits=Limits(following_error=40.0 / (GAIN * FORCE_CONSTANT)))))
    found = part_interval(Setting(tripping, controller(), along_x()), tolerance=1.0)
    assert found.failed == found.beyond_tolerance == SAMPLES // 2
    assert found.max is not None and found.max.high == np.inf and np.isfinite(found.max.low)


def test_changes_that_lanes_cannot_make_are_reported() -> None:
    pair, law = machine(axis("x"), axis("y", 40.0, force=Origin(**FITTED, deviation=5.0))), controller()
    assert [one.code for one in part_interval(Setting(pair, law, along_x(50)), changes=[object()]).findings] == ["CL222"]
    stiff = replace(pair.axes[0], friction=Coulomb(coulomb=1.0).traced({"stribeck_velocity": Origin("assumed", deviation=1e-3)}))
    assert part_interval(Setting(replace(pair, axes=(stiff, pair.axes[1])), law, along_x(50))).samples == SAMPLES


def test_a_changed_number_loses_its_deviation() -> None:
    stated = axis("y", 40.0, force=Origin(**FITTED, deviation=5.0), mass=Origin(**FITTED, deviation=1.0))
    other = replace(stated, plant=stated.plant.replace(mass=30.0))
    names = [number.name for number in uncertain(machine(axis("x"), other), controller())]
    assert names == ["axes.y.disturbance.force"]
    assert numbers_of(machine(axis("x"), other), controller())[1].source == "not stated"


def test_numbers_at_their_defaults_are_not_listed() -> None:
    names = [number.name for number in numbers_of(machine(axis("x")), Controller({"x": AxisController(Cascade(**Cascade.example))}))]
    assert "axes.x.plant.mass" in names and "axes.x.plant.carried_mass" not in names
    assert "controller.axes.x.controller.position_gain" in names and "controller.axes.x.controller.anti_windup" not in names
    assert not any("drive" in name for name in names) and Saturation().limit == np.inf
