"""The cost of a division: limits of the links, and the message rate that a swap needs."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from numpy.typing import NDArray

import contourlab as cl
from contourlab.components.ideal import IdealLink
from contourlab.components.link.network import Network
from contourlab.errors import DivergenceError, ParameterError
from contourlab.features.link.cost import DivisionCost, allowed_error, divided, division_cost, link_limit, message_rate, undivided_error
from contourlab.features.link.sweep import LinkSetting, LinkSweep, swept
from contourlab.loop import Division, simulate_batch
from contourlab.scenario import load_controller, load_machine
from contourlab.study import Setting

Array = NDArray[np.float64]


@pytest.fixture(scope="module")
def machine() -> cl.Machine:
    return load_machine("builtin:ghaffari/a3a1")


@pytest.fixture(scope="module")
def controller(machine: cl.Machine) -> cl.Controller:
    return load_controller("builtin:ghaffari/calibrated", machine)


@pytest.fixture(scope="module")
def circle(machine: cl.Machine) -> cl.Reference:
    """Return the circle of the paper, as in Fig 9."""
    return cl.uniform(cl.contour("circle", radius=0.02), 0.5, 2, machine.servo_period)


def delay_cost(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference, allowed: float, longest: float) -> DivisionCost:
    return division_cost(LinkSetting(Setting(machine, controller, circle), "contour_error_rms", allowed), ("delay",), longest)


def test_the_undivided_error_is_that_of_a_run(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    found = undivided_error(Setting(machine, divided(controller, "observer", link=Network(delay=0.02)), circle))
    metrics = cl.summarise(cl.judge(cl.simulate(machine, controller, circle), circle), circle)
    assert found == pytest.approx(metrics.contour_error.rms, rel=1e-6)


def test_each_run_with_chance_is_that_of_its_seed(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    """The noise of the encoders too: run again with the seed, a study's figure comes back to the last bit."""
    noisy = replace(machine, axes=tuple(replace(axis, sensor=axis.sensor.replace(noise=2e-7)) for axis in machine.axes))
    made = divided(controller, "observer", link=Network(loss=0.1))
    losses = np.array([0.05, 0.1])
    errors = LinkSetting(Setting(noisy, made, circle, seed=5), "contour_error_rms", 1.0, seeds=3).errors("loss", losses)
    for i in range(3):
        alone = simulate_batch(noisy, made, circle, {"controller.axes.*.link.*.loss": losses}, seed=5 + i)
        assert np.array_equal(errors[:, i], alone.figures["contour_error_rms"])
    assert np.unique(errors).size == errors.size


def test_the_axes_of_the_paper_hold_at_125_messages_a_second(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    """Table III with the observer in the axis: the result of the study against separate runs on both sides of the limit."""
    found = message_rate(machine, controller, circle)
    assert found.rate == pytest.approx(125.0)
    assert found.limited and found.error <= found.allowed == pytest.approx(1.1 * found.undivided)
    at, beyond = (
        simulate_batch(
            machine, divided(controller, "observer", link=Network(message_period=ticks * 1e-3)), circle, {"axes.1.plant.damping": [10.1]}
        )
        for ticks in (8, 12)
    )
    assert at.figures["contour_error_rms"][0] == pytest.approx(found.error)
    assert beyond.figures["contour_error_rms"][0] > found.allowed


@pytest.mark.parametrize("longest", [pytest.param(1.0, marks=pytest.mark.slow), 10.0])
def test_a_wide_search_finds_a_small_limit_too(
    machine: cl.Machine, controller: cl.Controller, circle: cl.Reference, longest: float
) -> None:
    assert message_rate(machine, controller, circle, longest=longest).rate == pytest.approx(125.0)
    whole = divided(controller, "drive", "both", Network())
    near, far = (link_limit(machine, whole, circle, "delay", longest=to) for to in (0.1, longest))
    assert far.value == near.value == pytest.approx(1e-3) and far.limited


class Known(LinkSetting):
    """Links with known limits in servo periods: the last period with a small error, a stable model, and a stable run."""

    def __init__(self, machine: cl.Machine, error: int, linear: int, simulated: int) -> None:
        self.divided, self.allowed, self.asked = cast(Any, SimpleNamespace(machine=machine)), 1.0, 0
        self.error, self.linear, self.simulated = (1e-3 * (tick + 0.5) for tick in (error, linear, simulated))

    def errors(self, quantity: str, values: Array) -> Array:
        self.asked += len(values)
        return np.where(values < self.error, 0.5, 2.0)[:, None]

    def growth(self, quantity: str, value: float, size_limit: int = 0) -> float:
        return math.nan if size_limit < 300 and value > 0.2 else 0.9 if value < self.linear else 1.1

    def repeats(self, quantity: str, values: Array) -> Array:
        return np.where(values < self.simulated, 1.0, 9.0)


@pytest.mark.parametrize("quantity", ["message_period", "delay"])
@pytest.mark.parametrize(
    ("error", "linear", "simulated"), [(6, 14, 12), (2, 100, 90), (300, 500, 333), (700, 641, 900), (999, 199, 77), (450, 500, 640)]
)
def test_limits_do_not_depend_on_the_search_range(quantity: str, error: int, linear: int, simulated: int, machine: cl.Machine) -> None:
    """For error and stability alike, even where the linear model is large and partly unknown."""
    for longest in (2.0, 3.3, 10.0):
        setting = Known(machine, error, linear, simulated)
        sweep = swept(setting, quantity, longest)
        found = np.array([sweep.most, sweep.stable_linear, sweep.stable_simulated])
        assert found == pytest.approx(np.array([min(error, linear), linear, simulated]) * 1e-3)
        assert len(np.unique(sweep.values)) == len(sweep.values) and setting.asked < 700
        assert (sweep.asked, sweep.ended_early) == (pytest.approx(longest), True)


@pytest.mark.parametrize(
    ("division", "ways", "delay"), [("drive", "both", 1e-3), ("drive", "one", 3e-3), ("observer", "both", 1e-3), ("observer", "one", 3e-3)]
)
def test_the_delay_limit_is_that_of_the_linear_model(
    division: str, ways: str, delay: float, machine: cl.Machine, controller: cl.Controller, circle: cl.Reference
) -> None:
    allowed = allowed_error(undivided_error(Setting(machine, controller, circle)), 0.1)
    made = divided(controller, division, ways)
    cost = delay_cost(machine, made, circle, allowed, 0.03)
    sweep = cost.sweeps["delay"]
    assert (cost.division, cost.ways, cost.findings) == (division, ways, ())
    assert sweep.most == pytest.approx(delay)
    assert sweep.stable_linear == pytest.approx(delay) == sweep.stable_simulated


def test_a_reference_may_have_any_delay(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    """One way with the whole controller in the axis: both axes are equally late, so the contour stays."""
    found = link_limit(machine, divided(controller, "controller", "one"), circle, "delay", longest=0.05)
    assert not found.limited
    assert found.value == pytest.approx(0.05)


def test_the_worst_seed_counts(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    made = divided(controller, "observer", "both")
    one, many = (link_limit(machine, made, circle, "loss", seeds=seeds) for seeds in (1, 8))
    assert 0.0 < many.value <= one.value < 1.0
    again = link_limit(machine, made, circle, "loss", seeds=8)
    assert (again.value, again.error) == (many.value, many.error)


@pytest.mark.slow
def test_a_larger_allowed_error_never_needs_more_messages(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    rates = [message_rate(machine, controller, circle, "controller", within=within).rate for within in (0.05, 0.2, 0.5)]
    assert rates[0] >= rates[1] >= rates[2]
    none = message_rate(machine, controller, circle, "controller", allowed=1e-9)
    assert math.isnan(none.value) and math.isnan(none.rate) and none.limited


def test_a_slow_link_leaves_less_delay(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    fast, slow = (
        link_limit(machine, divided(controller, "observer", "one", Network(message_period=period)), circle, "delay")
        for period in (1e-3, 6e-3)
    )
    assert slow.value < fast.value


def test_ways_of_dividing(controller: cl.Controller) -> None:
    both = divided(controller, "drive", "both", Network(delay=1e-3), axes=("1",))
    assert both.axes["1"].link == Division("drive", Network(delay=1e-3), Network(delay=1e-3))
    assert both.axes["3"].link is None
    assert divided(controller, "observer", "one").axes["1"].link == Division("observer", Network(), IdealLink())
    blind = divided(controller, "controller", "one")
    assert blind.axes["1"].link == Division("controller", Network(), None) and blind.estimator is None and blind.coupling is None


def test_invalid_settings_are_refused(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    for given in ({"ways": "three"}, {"axes": ("7",)}, {"division": "half"}):
        with pytest.raises(ParameterError):
            divided(controller, **{"division": "drive", **given})  # type: ignore[arg-type]
    made = divided(controller, "observer")
    for given in ({"quantity": "colour"}, {"within": -0.1}, {"allowed": 0.0}, {"longest": 1e-4}, {"figure": "mood"}):
        with pytest.raises(ParameterError):
            link_limit(machine, made, circle, **given)  # type: ignore[arg-type]
    whole = replace(made, axes={name: replace(mine, link=None) for name, mine in made.axes.items()})
    with pytest.raises(ParameterError, match="network"):
        link_limit(machine, whole, circle)


def test_rounding_of_a_message_period_is_reported(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    made = divided(controller, "observer", link=Network(message_period=2.4e-3))
    cost = delay_cost(machine, made, circle, 1e-5, 2e-3)
    assert cost.findings[0].code == "CL750" and cost.findings[0].values == {"asked": 2.4e-3, "sent": pytest.approx(3e-3)}
    assert set(cost.local_parameters["1"]) >= {"observer.model_gain", "velocity.bandwidth"}


def test_limits_are_read_from_the_values_in_order() -> None:
    unknown = np.full(5, np.nan)
    sweep = LinkSweep("delay", np.arange(5.0), np.array([1.0, 2.0, 9.0, 1.0, 1.0]), np.ones(5), unknown, unknown, 3.0)
    assert sweep.holds.tolist() == [True, True, False, True, True]
    assert (sweep.most, sweep.limited) == (1.0, True)  # values that hold beyond a gap do not count
    assert math.isnan(sweep.stable_linear)
    stable = replace(sweep, error=np.ones(5), growth=np.array([0.9, 0.95, 0.99, 1.01, np.nan]))
    assert (stable.most, stable.stable_linear) == (2.0, 2.0)
    assert replace(stable, growth=np.full(5, 0.9)).stable_linear == math.inf
    gaps = np.array([0.9, np.nan, 0.9, np.nan, np.nan])
    assert math.isnan(replace(stable, growth=gaps).stable_linear)
    assert replace(stable, growth=np.where(np.arange(5) == 4, 1.1, gaps)).stable_linear == 2.0
    lost = replace(sweep, error=np.full(5, np.nan))
    assert math.isnan(lost.most) and lost.limited


def test_a_quick_limit_by_chance_leaves_room() -> None:
    values, error, median = np.arange(4.0), np.array([1.0, 1.5, 2.0, 9.0]), np.array([1.0, 1.0, 1.4, 5.0])
    unknown = np.full(4, np.nan)
    whole, quick = (LinkSweep("loss", values, error, median, unknown, unknown, 2.1, coarse=coarse) for coarse in (False, True))
    assert (whole.most, whole.fails) == (2.0, 3.0)
    assert (quick.most, quick.fails) == (1.0, 3.0)


def test_different_links_are_run_as_given(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    slow, quick = (divided(controller, "observer", link=Network(delay=delay)).axes for delay in (3e-3, 1e-3))
    made = replace(controller, axes={"1": slow["1"], "3": quick["3"]})
    cost = delay_cost(machine, made, circle, 1e-4, 4e-3)
    found = cl.summarise(cl.judge(cl.simulate(machine, made, circle), circle), circle)
    assert cost.error == pytest.approx(found.contour_error.rms, rel=1e-6)
    assert cost.error not in cost.sweeps["delay"].error
    mixed = replace(controller, axes={"1": slow["1"], "3": divided(controller, "drive", "one").axes["3"]})
    cost = delay_cost(machine, mixed, circle, 1e-4, 1e-3)
    assert (cost.division, cost.ways) == ("observer, drive", "both, one")


def test_command_figures_refer_to_the_command_at_the_drive(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    """Neither an older command of the base nor one before the observer's estimate is subtracted: the figures equal the signals of a run."""
    for division in ("drive", "observer", "controller"):
        made = divided(controller, division, link=Network(delay=2e-3))
        lanes = simulate_batch(machine, made, circle, {"axes.1.plant.damping": [10.1]}, effort=True).figures
        run = cl.simulate(machine, made, circle)
        lap = slice(*circle.laps[-1])
        limits = np.array([axis.drive.limit for axis in machine.axes])  # type: ignore[attr-defined]
        asked = np.abs(run["command"][lap])
        assert lanes["limited_share"][0] == np.mean((asked > limits).any(axis=1))
        assert lanes["command_largest"][0] == pytest.approx((asked / limits).max(), rel=1e-9)


def test_an_undivided_loop_that_fails_says_where(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    tight = replace(machine, axes=tuple(replace(axis, limits=replace(axis.limits, following_error=1e-6)) for axis in machine.axes))
    with pytest.raises(DivergenceError, match="sample"):
        undivided_error(Setting(tight, controller, circle))
