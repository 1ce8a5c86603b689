"""Design variables, the order of results, and the runs that judge them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from contourlab.components.drive.saturation import Saturation
from contourlab.errors import ParameterError
from contourlab.feed import uniform
from contourlab.geometry import contour
from contourlab.loop import simulate
from contourlab.papers.ghaffari.setup import TABLE_2, TABLE_3, Reading, controller, machine
from contourlab.scenario.dump import quantity
from contourlab.study import DesignVariable, Runner, Setting, Space, calibration_order
from contourlab.units import to_si

READING = Reading()
MACHINE, CONTROLLER = machine(2, READING), controller(2, TABLE_2, READING)


def test_order_is_that_of_the_paper() -> None:
    order = [name.removeprefix("controller.axes.") for name in calibration_order(MACHINE, CONTROLLER)]
    observer = ["observer.model_damping", "observer.model_gain"]
    gains = ["controller.velocity_gain", "controller.position_gain", "controller.integral_gain"]
    ahead = ["controller.model_damping", "controller.model_gain"]
    assert order == [f"{axis}.{name}" for group in (observer, gains, ahead) for axis in ("3", "2") for name in group]


def test_names_may_be_short_or_match_many() -> None:
    one = Space.chosen(MACHINE, CONTROLLER, ["3.position_gain"])
    assert one.names == ("controller.axes.3.controller.position_gain",)
    both = Space.chosen(MACHINE, CONTROLLER, ["observer.model_gain=300 mm/s^2/full_scale..2 m/s^2/full_scale"])
    assert both.names == ("controller.axes.2.observer.model_gain", "controller.axes.3.observer.model_gain")
    assert [(n.low, n.high, n.short) for n in both.numbers] == [
        (pytest.approx(0.3), 2.0, "2.observer.model_gain"),
        (pytest.approx(0.3), 2.0, "3.observer.model_gain"),
    ]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("3.position", "such as"),
        ("3.position_gain=1..2", "full_scale/mm"),
        ("3.position_gain=2 full_scale/mm", "LOW..HIGH"),
        ("3.position_gain=5 full_scale/mm..2 full_scale/mm", "lower one first"),
        ("coupling.weight=0..1.5", "0.99"),
        ("disturbance.amplitude", "such as"),
        ("", "such as"),
    ],
)
def test_invalid_choices_are_refused(text: str, said: str) -> None:
    with pytest.raises(Exception, match=r".") as caught:
        Space.chosen(MACHINE, CONTROLLER, [text])
    assert said in str(caught.value)


def test_zero_has_no_range_by_a_factor() -> None:
    with pytest.raises(ParameterError, match="factor"):
        Space.chosen(MACHINE, replace(CONTROLLER, coupling=CONTROLLER.coupling.replace(weight=0.0)), ["coupling.weight"])


@pytest.mark.parametrize("logarithmic", [True, False])
def test_normalised_and_physical_values_correspond(logarithmic: bool) -> None:
    number = DesignVariable("a", 3.0, 1.0, 9.0, logarithmic=logarithmic)
    places = np.linspace(0.0, 1.0, 11)
    np.testing.assert_allclose(number.normalise(number.physical(places)), places, atol=1e-14)
    assert number.physical(0.5) == pytest.approx(3.0 if logarithmic else 5.0)
    assert number.physical(7.0) == 9.0


def test_a_bound_of_the_range_differs_from_a_bound_of_the_component() -> None:
    number = DesignVariable("a", 2.0, 1.0, 4.0, most=4.0)
    assert [number.end(value) for value in (1.0, 1.5, 4.0)] == ["lower end of its range", "", "the most it may be"]
    assert [number.cramped(value) for value in (1.0, 1.5, 4.0)] == [True, False, False]


WIDE = "3.observer.model_gain=1e-7 m/s^2/full_scale..2e4 m/s^2/full_scale"


@pytest.mark.parametrize("text", ["3.position_gain", "3.observer.model_damping", WIDE])
@pytest.mark.parametrize("width", [4.0, 3.7])
def test_written_values_read_back_exactly(text: str, width: float) -> None:
    """Six digits in the unit of the file, bit by bit, within the bounds."""
    number = Space.chosen(MACHINE, CONTROLLER, [text], width).numbers[0]
    values = number.physical(np.append(np.random.default_rng(3).random(500), [0.0, 1.0]))
    made = number.written(values)
    assert made == pytest.approx(values, rel=6e-6)
    assert (made >= number.low * (1.0 - 1e-8)).all() and (made <= number.high * (1.0 + 1e-8)).all()
    assert all(to_si(f"{number.display_value(value):.6g} {number.display_unit}", number.unit) == value for value in made.tolist())
    np.testing.assert_array_equal(number.written(made), made)
    assert all(len(str(quantity(value, number.unit, number.display)).split()[0]) <= 13 for value in made.tolist())


def test_the_value_of_the_scenario_is_kept_exactly() -> None:
    number = DesignVariable("a", 3.123456789, 1.0, 9.0)
    assert number.written([3.1234567, 3.123457, 3.12344]).tolist() == [3.123456789, 3.123456789, 3.12344]
    space = Space((number,), written=True)
    assert space.values(space.start) == {"a": 3.123456789} and space.only(["a"]).written


def test_figures_equal_those_of_a_single_run() -> None:
    """The batch tests compare errors with the exact judge; this test compares the command figures."""
    limit = 0.7
    axes = tuple(replace(axis, drive=Saturation(limit=limit)) for axis in MACHINE.axes)
    tight, made = replace(MACHINE, axes=axes), controller(2, TABLE_3, READING)
    reference = uniform(contour("circle", radius=0.02), 0.5, 2, READING.servo_period)
    figures = Runner(Setting(tight, made, reference), ("limited_share",))(
        {"controller.axes.3.controller.position_gain": np.array([4000.0])}
    )
    run = simulate(tight, made, reference)
    start, stop = reference.laps[-1]
    command, applied = run["command"][start:stop], run["applied_command"][start:stop]
    assert figures["command_energy"][0] == pytest.approx(np.sum((applied / limit) ** 2) * READING.servo_period, rel=1e-6)
    assert figures["command_largest"][0] == pytest.approx(np.abs(command).max() / limit, rel=1e-6)
    limited = (np.abs(command) > limit).any(axis=1).mean()
    assert 0.0 < limited < 1.0
    assert figures["limited_share"][0] == pytest.approx(limited, abs=2.5 / (stop - start))


def test_batch_size_and_threads_change_nothing() -> None:
    reference = uniform(contour("circle", radius=0.02), 0.5, 1, READING.servo_period)
    name = "controller.axes.3.controller.position_gain"
    values = np.linspace(2000.0, 6000.0, 70)
    many = Runner(Setting(MACHINE, CONTROLLER, reference))({name: values})
    few = Runner(Setting(MACHINE, CONTROLLER, reference), threads=1)({name: values[63:66]})
    for figure, found in few.items():
        np.testing.assert_array_equal(found, many[figure][63:66])
