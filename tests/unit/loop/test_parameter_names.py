"""Parameters by name: their units, patterns, and what a mistyped name suggests."""

from __future__ import annotations

import numpy as np
import pytest
from refusals import refuses

import contourlab as cl
from contourlab.errors import ParameterError
from contourlab.features.sweep.study import load_study
from contourlab.loop.batch import checked_variants
from contourlab.loop.parameters import fits
from contourlab.study.space import Space

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


GAIN = {f"controller.axes.{axis}.controller.position_gain" for axis in "13"}
PLANT = {f"axes.{axis}.plant.gain" for axis in "13"}


@pytest.mark.parametrize(
    ("text", "fitting"),
    [
        *((text, PLANT) for text in ("axes.*.plant.gain", "axes.*.gain", "plant.gain", "*.plant.gain", "plant*.gain", "*.gain")),
        *((text, GAIN) for text in ("position_gain", "*.position_gain", "controller.*.position_gain", "*.controller.position_g*")),
        *((text, {max(GAIN)}) for text in ("3.position_gain", "3.*.position_gain", "controller.axes.3.position_gain")),
        *((text, set()) for text in ("axes.*.position_gain", "axes.3.position_gain", "ain", "*.ain", "gain.*", "")),
    ],
)
def test_a_text_means_what_it_ends_with_a_star_for_anything_and_axes_only_the_machine(case, text, fitting):
    known = cl.parameter_names(case.machine, case.controller)
    assert {name for name in known if fits(name, text)} == fitting


@pytest.mark.parametrize("text", ["observer.*", "3.observer.*", "*.observer.bandwidth", "controller.*.position_gain", "3.*.position_gain"])
def test_a_text_means_the_same_in_every_command(text, tmp_path):
    scenario, scheme = "builtin:ghaffari/demo-stage", "with disturbance observer"
    case = cl.load_scenario(scenario).case(scheme)
    names = {name for name in cl.parameter_names(case.machine, case.controller) if fits(name, text)}
    assert names
    assert {variable.name for variable in Space.chosen(case.machine, case.controller, [text]).numbers} == names
    assert set(checked_variants(case.machine, case.controller, {text: np.ones(2)})[0]) == names
    vary = f'[vary]\n"{text}" = {{ uniform = ["90 %", "110 %"] }}\n'
    (tmp_path / "study.toml").write_text(f'scenario = "{scenario}"\nscheme = "{scheme}"\nvariants = 4\n{vary}')
    assert set(load_study(tmp_path / "study.toml").columns) == names


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
