"""Gains learned from one motion serve another, and are printed as a feedforward."""

from __future__ import annotations

import tomllib
from typing import Any

import numpy as np
import pytest
from learning_stages import PERIOD, make

import contourlab as cl
from contourlab.components.registry import component
from contourlab.features.learn import LearningRun, Stopping, learn

A, B, FRICTION = 1.8, 20.0, 0.06
AXES = ("x", "y")


def machine(gain: float = A, **parts: Any) -> cl.Machine:
    friction = make("friction", "smooth-coulomb", coulomb=FRICTION, breakaway=FRICTION, smoothing_velocity=3e-4)
    plant = make("plant", "rigid-axis", gain=gain, damping=B)
    return cl.Machine("stage", tuple(cl.Axis(name, plant, friction, substeps=2, **parts) for name in AXES), PERIOD)


def control(*feedforward: Any) -> cl.Controller:
    law = make("controller", "pid", proportional_gain=900.0, integral_gain=2000.0, derivative_gain=30.0)
    ahead = feedforward or (None,) * 2
    return cl.Controller({name: cl.AxisController(law, feedforward=part) for name, part in zip(AXES, ahead, strict=True)})


def planned(name: str, feedrate: float) -> cl.Reference:
    return cl.plan(cl.route_from_path(cl.contour(name), feedrate), cl.AxisLimits([0.2] * 2, [1.0] * 2, [20.0] * 2), PERIOD)


def contour_rms(controller: cl.Controller, reference: cl.Reference) -> float:
    return cl.summarise(cl.judge(cl.simulate(machine(), controller, reference), reference), reference).contour_error.rms


def learned(controller: cl.Controller, trials: int = 3) -> tuple[LearningRun, list[Any]]:
    """Return learning from an ellipse, and the feedforward of each axis as its finding prints it."""
    law = component("learning", "basis-functions")()
    run = learn(machine(), controller, planned("ellipse", 0.02), law, trials=trials, stopping=Stopping(improvement=0.0))
    printed = [tomllib.loads(f"feedforward = {one.values['feedforward']}")["feedforward"] for one in run.findings if one.code == "CL316"]
    kinds = [component("feedforward", table.pop("kind")) for table in printed]
    parts = [kind(**{name: float(text.split()[0]) for name, text in table.items()}) for kind, table in zip(kinds, printed, strict=True)]
    return run, parts


@pytest.fixture(scope="module")
def ellipse() -> tuple[LearningRun, list[Any]]:
    return learned(control())


def test_the_gains_are_the_inverse_of_the_axis_and_its_friction(ellipse: tuple[LearningRun, list[Any]]) -> None:
    """k_v = b/a, k_a = 1/a and half a tick of k_v for the hold, k_f the friction."""
    run, parts = ellipse
    assert run.trials[run.best].contour_rms < 0.02 * run.trials[0].contour_rms
    for part in parts:
        assert part.velocity_gain == pytest.approx(B / A, rel=0.01)
        assert part.acceleration_gain == pytest.approx(1.0 / A + 0.5 * PERIOD * B / A, rel=0.01)
        assert part.friction == pytest.approx(FRICTION, rel=0.01)


@pytest.mark.parametrize(("name", "feedrate"), [("circle", 0.02), ("ellipse", 0.05), ("diamond", 0.03)])
def test_gains_learned_on_an_ellipse_serve_another_motion(ellipse: tuple[LearningRun, list[Any]], name: str, feedrate: float) -> None:
    reference = planned(name, feedrate)
    assert contour_rms(control(*ellipse[1]), reference) < 0.05 * contour_rms(control(), reference)


def test_the_printed_feedforward_repeats_the_learned_trial(ellipse: tuple[LearningRun, list[Any]]) -> None:
    run, parts = ellipse
    again = contour_rms(control(*parts), planned("ellipse", 0.02))
    assert again == pytest.approx(run.trials[run.best].contour_rms, rel=0.05)


def test_what_an_axis_feeds_forward_already_is_contained_in_the_gains(ellipse: tuple[LearningRun, list[Any]]) -> None:
    begun = make("feedforward", "inverse-dynamics", velocity_gain=0.7 * B / A, acceleration_gain=1.3 / A)
    for part, alone in zip(learned(control(begun, begun))[1], ellipse[1], strict=True):
        for name in ("velocity_gain", "acceleration_gain", "friction"):
            assert getattr(part, name) == pytest.approx(getattr(alone, name), rel=5e-3)


def test_with_noise_thirty_trials_do_not_grow() -> None:
    noisy = machine(sensor=make("sensor", "encoder", resolution=1e-7, noise=1e-7))
    law = component("learning", "basis-functions")()
    run = learn(noisy, control(), planned("ellipse", 0.02), law, trials=30, stopping=Stopping(improvement=0.0))
    tracking = np.array([trial.tracking for trial in run.trials])
    assert tracking[2:].max() < 1.2 * tracking[2:].min()


def test_gains_learned_into_the_reference_are_no_feedforward() -> None:
    law = component("learning", "basis-functions")(target="reference")
    run = learn(machine(), control(), planned("ellipse", 0.02), law, trials=2)
    assert run.trials[-1].contour_rms < 0.8 * run.trials[0].contour_rms
    assert all(one.code != "CL316" for one in run.findings)
