"""Controllers divided into base and axis, and the links between them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from refusals import refuses
from stages import PERIOD, control, make, stage

import contourlab as cl
from contourlab.components.ideal import IdealLink
from contourlab.components.link.network import Network
from contourlab.components.registry import component
from contourlab.errors import ParameterError
from contourlab.loop import DIVISIONS, Division

PLAIN = ("axis_position", "position", "velocity", "command", "applied_command", "disturbance_estimate", "modified_reference")


def in_two(controller: cl.Controller, division: str, down: Any, up: Any, **top: Any) -> cl.Controller:
    return replace(controller, axes={n: replace(m, link=Division(division, down, up)) for n, m in controller.axes.items()}, **top)


def short(machine: cl.Machine, frequency: float = 1.0) -> cl.Reference:
    return cl.uniform(cl.contour("circle", radius=5e-3), frequency, 1, machine.servo_period)


def alike(one: cl.Result, other: cl.Result) -> bool:
    return set(one.signals) == set(other.signals) and all(np.array_equal(one[name], other[name]) for name in one.signals)


def crossed() -> cl.Controller:
    """Return position loops with a cross-coupling that reads the accepted commands."""
    coupling = make("coupling", "cross-coupled", gain=300.0, integral_rate=5.0, limit=0.5)
    return replace(control(), coupling=coupling)


def predicted() -> cl.Controller:
    smith = make("predictor", "smith", dc_gain=0.1, damping_ratio=1.0, natural_frequency=300.0, delay=1.5e-3)
    plain = control()
    return replace(plain, axes={name: replace(mine, predictor=smith) for name, mine in plain.axes.items()})


def fed() -> cl.Controller:
    kind = component("feedforward", "friction")
    friction = kind(**kind.example)
    plain = control()
    return replace(plain, axes={name: replace(mine, feedforward=friction) for name, mine in plain.axes.items()})


def filtered() -> cl.Controller:
    """Return position loops with filters, and a cross-coupling that reads the commands accepted before them."""
    filters = (("notch", make("filter", "notch", frequency=150.0)), ("smooth", make("filter", "first-order-low-pass", frequency=300.0)))
    plain = crossed()
    return replace(plain, axes={name: replace(mine, filters=filters) for name, mine in plain.axes.items()})


CONTROLLERS = {"modified reference": control, "cross-coupled": crossed, "predictor": predicted, "feedforward": fed, "filters": filtered}


INSTANT = [Network(), Network(message_period=PERIOD), Network(between="extrapolate"), IdealLink()]


PAIRS = [*((name, INSTANT[0]) for name in CONTROLLERS), *(("modified reference", link) for link in INSTANT[1:])]
"""Each controller with a network, and each link with one controller."""
MORE = [pytest.param("filters", link, marks=pytest.mark.slow) for link in INSTANT[1:]]


@pytest.mark.parametrize("division", DIVISIONS)
@pytest.mark.parametrize(("name", "link"), [*PAIRS, *MORE], ids=str)
def test_an_instant_link_changes_no_bit(division: str, name: str, link: Any, circle: cl.Reference) -> None:
    """With sticking friction, noise, counts and late commands."""
    controller = CONTROLLERS[name]()
    if division == "observer" and name == "predictor":
        with pytest.raises(ParameterError, match="predictor"):
            in_two(controller, division, link, link)
        return
    machine = stage()
    assert alike(cl.simulate(machine, controller, circle), cl.simulate(machine, in_two(controller, division, link, link), circle))


@pytest.mark.parametrize("division", DIVISIONS)
def test_an_instant_link_changes_nothing_at_the_drive_limit(division: str) -> None:
    machine = stage(drive=make("drive", "saturation", limit=0.25))
    fast = short(machine, 2.0)
    whole = cl.simulate(machine, control(), fast)
    assert (np.abs(whole["command"]) > 0.25).sum() > 20
    found = cl.simulate(machine, in_two(control(), division, Network(), Network()), fast)
    assert all(np.array_equal(whole[name], found[name]) for name in PLAIN)


def test_a_late_reference_gives_the_same_motion_later(circle: cl.Reference) -> None:
    """One way with the whole controller in the axis: a network can only shift time."""
    machine = stage(sensor=make("sensor", "ideal"))
    alone = control(coupled=False)
    whole = cl.simulate(machine, alone, circle)
    ticks = 13
    late = cl.simulate(machine, in_two(alone, "controller", Network(delay=ticks * PERIOD), None), circle)
    for name in ("axis_position", "command", "disturbance_estimate"):
        assert np.array_equal(late[name][ticks:], whole[name][:-ticks]), name


@pytest.mark.parametrize("division", ["drive", "observer"])
def test_delay_does_not_look_like_a_limit(division: str) -> None:
    """With a limit that is never reached the integral never waits, however late the drive's answer is."""
    machine = stage(drive=make("drive", "saturation", limit=10.0), sensor=make("sensor", "ideal"))
    link = Network(delay=2 * PERIOD)
    found = []
    for way in ("hold", "none"):
        plain = control(coupled=False)
        axes = {name: replace(mine, controller=mine.controller.replace(anti_windup=way)) for name, mine in plain.axes.items()}
        found.append(cl.simulate(machine, in_two(replace(plain, axes=axes), division, link, link), short(machine)))
    assert np.abs(found[0]["command"]).max() < 10.0
    # The two variants compile to different machine code, so products and sums may be rounded differently.
    assert all(np.allclose(found[0][name], found[1][name], rtol=0, atol=1e-12) for name in ("axis_position", "command"))


def test_the_limit_is_reported_across_the_network() -> None:
    """An integral without knowledge of the limit overshoots; one that learns of it late hardly does."""
    line = cl.uniform(cl.contour("circle", radius=5e-3), 3.0, 3, PERIOD)
    machine = stage(drive=make("drive", "saturation", limit=0.9), sensor=make("sensor", "ideal"), friction=make("friction", "none"))
    largest = {}
    for way in ("hold", "none"):
        plain = control(coupled=False, integral_gain=40.0)
        axes = {name: replace(mine, controller=mine.controller.replace(anti_windup=way)) for name, mine in plain.axes.items()}
        found = cl.simulate(machine, in_two(replace(plain, axes=axes), "observer", Network(delay=PERIOD), IdealLink()), line)
        largest[way] = np.abs(found["command"]).max()
    assert largest["hold"] < 0.8 * largest["none"]


def test_the_axis_subtracts_its_own_estimate_at_once() -> None:
    """The base's command minus the drive's is the estimate of the same tick, for any network."""
    machine = stage(sensor=make("sensor", "ideal"))
    controller = in_two(control(coupled=False), "observer", Network(message_period=3 * PERIOD, delay=2 * PERIOD), Network())
    found = cl.simulate(machine, controller, short(machine))
    base = found["command"] + found["disturbance_estimate"]
    changes = np.flatnonzero(np.abs(np.diff(base[:, 0])) > 1e-12) + 1
    assert len(changes) > 50
    assert set((changes % 3).tolist()) == {2}  # sent at multiples of 3, two ticks on the way
    assert np.count_nonzero(np.diff(found["disturbance_estimate"][:, 0])) > 2 * len(changes)


def test_the_record_contains_what_the_axis_measures() -> None:
    machine = stage(sensor=make("sensor", "ideal"))
    slow = Network(message_period=5 * PERIOD, delay=3 * PERIOD)
    found = cl.simulate(machine, in_two(control(), "observer", slow, slow), short(machine))
    assert np.array_equal(found["position"], found["axis_position"])


@pytest.mark.parametrize("division", DIVISIONS)
def test_lanes_single_runs_and_plain_python_agree(division: str) -> None:
    machine = stage(sensor=make("sensor", "ideal"), friction=make("friction", "none"))
    chance = Network(message_period=2 * PERIOD, delay=0.7e-3, jitter=1.1e-3, loss=0.1)
    # Tangent estimator: two forms of the path table may find foot points that differ by the error of the table.
    whole = replace(control(), estimator=make("estimator", "tangent"))
    controller, circle = in_two(whole, division, chance, chance), cl.uniform(cl.contour("circle", radius=5e-3), 2.0, 1, PERIOD)
    fast, plain = (cl.simulate(machine, controller, circle, jit=jit) for jit in (True, False))
    for name in ("axis_position", "modified_reference", "command"):
        assert np.abs(fast[name] - plain[name]).max() <= 1e-9 * np.abs(plain[name]).max()
    # Message period, delay, jitter and loss differ from lane to lane.
    each = {
        "message_period": np.array([1.0, 2.0, 3.0]) * PERIOD,
        "delay": np.array([0.0, 0.7, 2.0]) * PERIOD,
        "jitter": np.array([3.0, 1.1, 0.0]) * PERIOD,
        "loss": np.array([0.0, 0.1, 0.3]),
    }
    variants = {f"controller.axes.{a}.link.{w}.{q}": v for a in "xy" for w in ("down", "up") for q, v in each.items()}
    batch = cl.simulate_batch(machine, controller, circle, variants, keep=("axis_position",))
    for i in range(3):
        part = Network(**{name: float(values[i]) for name, values in each.items()})
        alone = cl.simulate(machine, in_two(whole, division, part, part), circle)
        assert np.abs(batch.signals["axis_position"][:, :, i] - alone["axis_position"]).max() <= 1e-9 * 5e-3


def test_the_seed_determines_the_messages(circle: cl.Reference) -> None:
    machine, lossy = stage(sensor=make("sensor", "ideal")), Network(loss=0.3)
    controller = in_two(control(), "observer", lossy, lossy)
    one, again, other = (cl.simulate(machine, controller, circle, seed=seed) for seed in (4, 4, 5))
    assert alike(one, again) and not alike(one, other)


def test_only_some_axes_may_be_divided(circle: cl.Reference) -> None:
    machine, plain = stage(), control()
    half = replace(plain, axes={**plain.axes, "x": replace(plain.axes["x"], link=Division("observer", Network(), Network()))})
    assert alike(cl.simulate(machine, plain, circle), cl.simulate(machine, half, circle))
    late = replace(plain.axes["x"], link=Division("controller", Network(delay=0.05), Network()))
    found = cl.simulate(machine, replace(plain, axes={**plain.axes, "x": late}), circle)
    assert (found["axis_position"][:50, 0] == found["axis_position"][0, 0]).all()
    assert found["axis_position"][49, 1] != found["axis_position"][0, 1]


def test_indivisible_controllers_are_refused(circle: cl.Reference) -> None:
    with refuses(ParameterError, name="link.division"):
        Division("velocity")
    for division in ("drive", "observer"):
        with refuses(ParameterError, name="link.up", value='"none"'):
            Division(division, Network(), None)
    with refuses(ParameterError, name="controller.estimator", value='"newton"'):
        in_two(control(), "controller", Network(), None)
    mine = control().axes["x"]
    with refuses(ParameterError, '"observer"', name="local", value="'controller.position_gain'"):
        replace(mine, link=Division("observer"), local=("controller.position_gain",))
    other = in_two(control(), "observer", Network(delay=PERIOD), Network())
    with refuses(ParameterError, r"link.* axis x\b", name="changes"):
        cl.simulate(stage(), control(), circle, changes=[cl.Change(0.5, other)])


def test_a_controller_with_the_same_links_may_take_over(circle: cl.Reference) -> None:
    link = Network(delay=PERIOD)
    one, other = (in_two(control(position_gain=gain), "controller", link, link) for gain in (2800.0, 2000.0))
    machine = stage(sensor=make("sensor", "ideal"))
    found = cl.simulate(machine, one, circle, changes=[cl.Change(0.5, other)])
    moved = np.abs(np.diff(found["axis_position"], axis=0))
    assert found.status.ok and moved[495:520].max() < 2.0 * moved[300:495].max()


def test_parameters_of_the_axis_part_are_local() -> None:
    mine = replace(control().axes["x"], link=Division("observer"))
    heads = {name.partition(".")[0] for name in mine.local_parameters}
    assert heads == {"velocity", "observer"}
    assert "observer.model_gain" in mine.local_parameters
    assert {name.partition(".")[0] for name in replace(mine, link=Division("drive")).local_parameters} == {"velocity"}
    assert "controller.position_gain" in replace(mine, link=Division("controller")).local_parameters
    assert replace(mine, local=("observer.model_gain",)).local_parameters == ("observer.model_gain",)
    assert replace(mine, link=None).local_parameters == ()
