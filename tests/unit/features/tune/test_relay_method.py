"""``tune --method relay``: the experiment on machines whose ultimate gain is known, and the rules in the terms of each controller."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tuned_axes import PERIOD, circle, position_control, rigid_stage

from contourlab.analysis.identification.relay import RULES, relay_test
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.components.contract import Component
from contourlab.components.controller.cascade import Cascade
from contourlab.components.controller.pid import PID, SpeedPID
from contourlab.components.controller.state_feedback import StateFeedback
from contourlab.components.drive.saturation import DelayedSaturation
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.sensor.encoder import Encoder
from contourlab.errors import ParameterError
from contourlab.features.tune.drive_terms import drive_terms
from contourlab.features.tune.relay import relay_tests, rule_values
from contourlab.features.tune.study import Tuned, TuneSettings, tune
from contourlab.loop import AxisController, Controller
from contourlab.loop.parameters import with_values
from contourlab.study import Setting, Space

LAWS = {
    "pid": PID(proportional_gain=1500.0, integral_gain=7500.0, derivative_gain=40.0),
    "cascade": Cascade(position_gain=40.0, velocity_gain=40.0, integral_time=0.1),
    "state-feedback": StateFeedback(position_gain=1500.0, integral_gain=7500.0, velocity_gain=40.0),
}


def setting(law: Component | None = None, limit: float = 1.0, delay: float = 3e-3) -> Setting:
    """Return two axes with delayed, limited drives and encoders, under a law or the position controller."""
    drive, stage = DelayedSaturation(limit=limit, delay=delay), rigid_stage()
    stage = replace(stage, axes=tuple(replace(axis, drive=drive, sensor=Encoder(resolution=1e-7)) for axis in stage.axes))
    control = position_control() if law is None else Controller({name: AxisController(law) for name in ("x", "y")})
    return Setting(stage, control, circle())


@pytest.mark.parametrize("delay", [1e-3, 3e-3, 8e-3])
def test_the_ultimate_point_is_that_of_the_margins(delay: float) -> None:
    """The exact gain margin of P control is its ultimate gain, at the frequency of the phase crossover."""
    made = setting(delay=delay)
    exact = sampled_loop(made.machine.axes[0], AxisController(PID(proportional_gain=1.0)), PERIOD).margins()
    for test in relay_tests(made).values():
        assert test.gain.low <= exact.gain <= test.gain.high and test.gain.half < 0.15 * exact.gain
        assert test.period.low <= 2.0 * np.pi / exact.phase_crossover <= test.period.high


def test_behind_an_observer_the_ultimate_gain_is_that_of_both() -> None:
    """The command counts before the observer's estimate, as a rule's gains do: P control there is stable up to the ultimate gain."""
    made = setting()
    observer = DisturbanceObserver(bandwidth=30.0, filter_bandwidth=1000.0, model_gain=1.2, model_damping=20.0)
    axes = {name: replace(slots, observer=observer) for name, slots in made.controller.axes.items()}
    test = relay_tests(replace(made, controller=replace(made.controller, axes=axes)))["x"]
    assert test.level == pytest.approx(0.5, rel=1e-9) and test.gain.half < 0.25 * test.gain.value
    low, high = test.gain.low, test.gain.high
    for gain, stable in ((low, True), (high, False)):
        law = PID(proportional_gain=gain)
        assert sampled_loop(made.machine.axes[0], replace(axes["x"], controller=law), PERIOD).margins().stable == stable


@pytest.mark.parametrize("kind", [None, *LAWS])
def test_each_law_gets_the_gains_of_the_rule(kind: str | None) -> None:
    made = setting(LAWS[kind] if kind else None)
    tests = relay_tests(made)
    by_rule = rule_values(made, Space.chosen(made.machine, made.controller), tests)
    assert list(by_rule) == [rule for rule in RULES if rule.endswith("PID")]
    for rule, values in by_rule.items():
        law = with_values(made.machine, made.controller, values)[1]
        for terms in drive_terms(made.machine, law, None):
            gains, wanted = terms.linuxcnc, tests[terms.axis].gains(rule)
            assert gains is not None
            assert (gains.p, gains.i, gains.d) == pytest.approx((wanted.proportional, wanted.integral, wanted.derivative), rel=1e-9)


@pytest.mark.parametrize(("changes", "ends"), [({"integral_gain": 0.0, "derivative_gain": 0.0}, "P"), ({"derivative_gain": 0.0}, "PI")])
def test_gains_that_are_not_in_use_stay_so(changes: dict[str, float], ends: str) -> None:
    made = setting(LAWS["pid"].replace(**changes))
    by_rule = rule_values(made, Space.chosen(made.machine, made.controller), relay_tests(made))
    assert list(by_rule) == [rule for rule in RULES if rule.split()[-1] == ends]


def calibrated(made: Setting, **options: float) -> Tuned:
    return tune(made, TuneSettings(method="relay", **options))


def test_the_best_rule_within_the_margins_is_taken() -> None:
    found = calibrated(setting(LAWS["pid"]))
    kept = {rule: given.figures["part_error_max"] for rule, given in found.rules.items() if not given.violations}
    assert found.method == min(kept, key=lambda rule: kept[rule]) and not found.after.violations
    assert found.after.figures["part_error_max"] == kept[found.method]
    assert set(found.relay) == {"x", "y"} and [one.code for one in found.findings].count("CL612") == 2


def test_without_such_a_rule_the_bounds_are_broken() -> None:
    found = calibrated(setting(), phase_margin=75.0)
    assert found.after.violations and found.method in found.rules


@pytest.mark.parametrize(
    "made",
    [
        setting(limit=np.inf),
        setting(SpeedPID(dc_gain=0.13, damping_ratio=1.0, natural_frequency=100.0, time_constant=0.05)),
        setting(LAWS["pid"].replace(integral_gain=0.0)),
    ],
)
def test_refused(made: Setting) -> None:
    with pytest.raises(ParameterError) as caught:
        calibrated(made)
    assert caught.value.value == "relay"


def test_a_drive_at_its_limit_is_refused() -> None:
    """An observer with far too small a model gain adds more to the relay than the drive can give."""
    made = setting(delay=0.0)
    observer = DisturbanceObserver(bandwidth=300.0, filter_bandwidth=3000.0, model_gain=0.1, model_damping=20.0)
    axes = {name: replace(slots, observer=observer) for name, slots in made.controller.axes.items()}
    with pytest.raises(ParameterError, match="at its limit"):
        relay_tests(replace(made, controller=replace(made.controller, axes=axes)))


def test_the_kind_relay_swings_as_its_test_says() -> None:
    """A scenario may use the relay itself: its run gives the same outcome."""
    from contourlab.components.controller.relay import Relay
    from contourlab.feed import Reference
    from contourlab.loop import simulate

    made = setting(Relay(amplitude=0.5, hysteresis=1e-7))
    start = made.reference.block(0, 1).position
    run = simulate(made.machine, made.controller, Reference.from_samples(np.repeat(start, 8192, axis=0), PERIOD, made.reference.path))
    alone = relay_test(run["command"][:, 0], run["position"][:, 0], PERIOD)
    assert alone.gain.value == pytest.approx(relay_tests(setting())["x"].gain.value, rel=0.02)
