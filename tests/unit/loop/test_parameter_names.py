"""Parameters by name: their units, patterns, and what a mistyped name suggests."""

from __future__ import annotations

import numpy as np
import pytest
from refusals import refuses

import contourlab as cl
from contourlab.errors import ParameterError
from contourlab.loop.parameters import fits

GAINS = np.array([0.8, 1.2])


@pytest.fixture(scope="module")
def case():
    return cl.load_scenario("builtin:ghaffari/demo-stage").base


def test_every_parameter_has_its_unit(case):
    units = cl.parameter_names(case.machine, case.controller)
    assert (units["axes.1.plant.gain"], units["axes.3.plant.damping"]) == ("m/s^2/full_scale", "1/s")
    assert units["controller.axes.1.controller.position_gain"] == "full_scale/m"


def test_a_pattern_gives_all_that_match_the_same_values(case):
    circle = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, case.machine.servo_period)
    one = {f"axes.{axis}.plant.gain": GAINS for axis in case.machine.axis_names}
    both = one, {"axes.*.plant.gain": GAINS}
    each, together = (cl.simulate_batch(case.machine, case.controller, circle, variants) for variants in both)
    assert np.array_equal(each.figures["contour_error_rms"], together.figures["contour_error_rms"])


@pytest.mark.parametrize(
    ("pattern", "fitting"),
    [
        ("axes.*.plant.gain", {"axes.1.plant.gain", "axes.3.plant.gain"}),
        ("controller.*.*.controller.position_g*", {f"controller.axes.{axis}.controller.position_gain" for axis in "13"}),
        ("plant.gain", {"axes.1.plant.gain", "axes.3.plant.gain"}),
        ("*.gain", set()),
        ("axes.*.controller.position_gain", set()),
    ],
)
def test_a_star_is_one_name_between_dots_and_a_pattern_begins_at_the_start(case, pattern, fitting):
    known = cl.parameter_names(case.machine, case.controller)
    assert {name for name in known if fits(name, pattern)} == fitting


def test_a_parameter_is_given_once(case):
    circle = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, case.machine.servo_period)
    with refuses(ParameterError, name="variants"):
        cl.simulate_batch(case.machine, case.controller, circle, {"axes.1.plant.gain": GAINS, "axes.*.plant.gain": GAINS})


def test_a_mistyped_name_suggests_the_nearest(case):
    circle = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, case.machine.servo_period)
    with refuses(ParameterError, "axes.1.plant.gain"):
        cl.simulate_batch(case.machine, case.controller, circle, {"axes.1.plant.gian": GAINS})


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("controller.axes.3.controller.positon_gain", "controller.axes.3.controller.position_gain"),
        ("axs.3.plant.gain", "axes.3.plant.gain"),
        ("axes.*.plant.dampng", "axes.*.plant.damping"),
        ("axes.*.controller.position_gain", "controller.axes.*.controller.position_gain"),
    ],
)
def test_the_nearest_name_comes_first(case, typed, meant):
    circle = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, case.machine.servo_period)
    with pytest.raises(ParameterError) as caught:
        cl.simulate_batch(case.machine, case.controller, circle, {typed: GAINS})
    assert caught.value.bound.partition("such as ")[2].split(", ")[0] == meant
