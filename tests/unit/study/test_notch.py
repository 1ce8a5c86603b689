"""Notch filters designed for a resonance: margins kept where they were broken, for feedback from either side."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from component_rig import make
from refusals import refuses

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.components.controller.cascade import Cascade
from contourlab.components.plant.plant import MassDamper, resonance_of
from contourlab.components.plant.two_sided import ElasticBallScrew, TwoMass
from contourlab.errors import ParameterError
from contourlab.study.guards import Bounds
from contourlab.study.notch import NAME, design_notch, with_velocity_gain

PERIOD = 5e-4
PLANT = TwoMass(mass=40.0, load_share=0.7, resonance=60.0, damping_ratio=0.03, damping=80.0, force_constant=55.0)


def loop(side: str, bandwidth: float, plant: TwoMass = PLANT) -> tuple[cl.Machine, cl.Controller]:
    machine = cl.Machine("one", (cl.Axis("x", plant, drive=make("drive", "delayed-saturation", delay=1e-3)),), PERIOD)
    law = Cascade(**Cascade.tune(bandwidth, 1.0, *plant.rigid_model(), position_gain=8.0))
    velocity = make("velocity", "filtered-difference", bandwidth=3000.0)
    return machine, cl.Controller({"x": cl.AxisController(law, velocity, feedback=side, velocity_feedback=side)})


def broken(controller: cl.Controller, bounds: Bounds) -> list[str]:
    """Return the broken margins for a resonance that moves by 5 %."""
    axes = (loop("motor", 80.0, PLANT.replace(resonance=60.0 * move))[0].axis("x") for move in (0.95, 1.0, 1.05))
    return [bounds.broken(sampled_loop(axis, controller.axes["x"], PERIOD).margins()) for axis in axes]


@pytest.mark.parametrize(
    ("side", "bandwidth", "bounds"),
    [("motor", 80.0, Bounds()), ("load", 60.0, Bounds()), ("load", 150.0, Bounds()), ("motor", 150.0, Bounds(8.0, 40.0))],
)
@pytest.mark.slow
def test_the_margins_are_kept_with_the_notch_and_not_without(side: str, bandwidth: float, bounds: Bounds) -> None:
    machine, controller = loop(side, bandwidth)
    design, made = design_notch(machine, controller, "x", bounds)
    assert bounds.broken(design.margins_before)
    assert not any(broken(made, bounds))
    ((name, notch),) = made.axes["x"].filters
    assert name == NAME and notch.frequency == design.frequency
    # The largest gain is the largest: a little more breaks the margins.
    assert any(broken(with_velocity_gain(made, "x", 1.01 * design.largest_after / design.velocity_gain_after), bounds))
    assert design.largest_after > 1.3 * design.largest_before


@pytest.mark.slow
def test_a_second_design_replaces_the_first_and_keeps_other_filters() -> None:
    machine, controller = loop("motor", 80.0)
    smooth = make("filter", "low-pass", frequency=500.0)
    controller = replace(controller, axes={"x": replace(controller.axes["x"], filters=(("smooth", smooth),))})
    once = design_notch(machine, controller, "x")[1]
    again = design_notch(machine, once, "x")[1]
    assert [name for name, _ in once.axes["x"].filters] == [NAME, "smooth"] and again == once


def test_the_resonance_is_that_of_the_loaded_axis() -> None:
    assert resonance_of(PLANT.replace(damping=0.0)) == pytest.approx((60.0, 0.03))
    loaded = resonance_of(PLANT.replace(damping=0.0).loaded(28.0))
    assert loaded is not None and loaded[0] == pytest.approx(60.0 * math.sqrt((1 / 12 + 1 / 56) / (1 / 12 + 1 / 28)))
    screw = ElasticBallScrew(mass=30.0, inertia=2e-4, lead=0.01, torque_constant=0.5, resonance=85.0)
    assert resonance_of(screw) == pytest.approx((85.0, 0.02))
    assert resonance_of(MassDamper(mass=10.0, force_constant=50.0)) is None


def test_axes_without_a_usable_resonance_are_refused() -> None:
    machine, controller = loop("motor", 80.0)
    rigid = replace(machine, axes=(replace(machine.axes[0], plant=MassDamper(mass=40.0, force_constant=55.0)),))
    with refuses(ParameterError, "resonance", name="axes.x.plant"):
        design_notch(rigid, controller, "x")
    fast = replace(machine, axes=(replace(machine.axes[0], plant=PLANT.replace(resonance=1200.0), substeps=16),))
    with refuses(ParameterError, "1000 Hz", name="axes.x.plant"):
        design_notch(fast, controller, "x")


def test_a_factor_on_the_velocity_gain_keeps_the_damping_of_the_velocity_loop() -> None:
    _, controller = loop("motor", 80.0)
    law = with_velocity_gain(controller, "x", 0.5).axes["x"].controller.values()
    expected = Cascade.tune(40.0, 1.0, *PLANT.replace(damping=0.0).rigid_model())
    assert np.array([law["velocity_gain"], law["integral_time"]]) == pytest.approx(
        [expected["velocity_gain"], expected["integral_time"]], rel=0.03
    )
