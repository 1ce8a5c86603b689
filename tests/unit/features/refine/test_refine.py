"""Refinement against logs simulated with known numbers, through an encoder."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from contourlab.components.controller.lead_lag import LeadLag
from contourlab.components.disturbance.loads import ScrewRipple
from contourlab.components.friction.laws import Coulomb
from contourlab.components.plant.plant import MassDamper
from contourlab.components.sensor.encoder import Encoder
from contourlab.errors import ParameterError, ResultError
from contourlab.features.refine.log_run import LogRun, log_run
from contourlab.features.refine.study import RefineSettings, refine, seek
from contourlab.feed import Reference
from contourlab.geometry import Line, Path
from contourlab.loop import Axis, AxisController, Controller, Machine, simulate
from contourlab.loop.parameters import with_values
from contourlab.result import Result, Signal

PERIOD = 1e-3
TRUE = {"axes.x.plant.damping": 400.0, "axes.x.friction.coulomb": 60.0, "axes.x.disturbance.sine": 8.0}
GUESS = {"axes.x.plant.damping": 700.0, "axes.x.friction.coulomb": 30.0, "axes.x.disturbance.sine": 0.0}
WANTED = ("axes.x.plant.damping", "axes.x.friction.coulomb", "axes.x.disturbance.sine=-30 N..30 N")


def parts(resolution: float = 1e-7, **axis: object) -> tuple[Machine, Controller]:
    plant = MassDamper(mass=50.0, damping=400.0, force_constant=100.0)
    ripple = ScrewRipple(lead=0.01, sine=8.0)
    mine = Axis("x", plant, Coulomb(coulomb=60.0), sensor=Encoder(resolution=resolution), disturbance=ripple, **axis)  # type: ignore[arg-type]
    gains = LeadLag.design(np.radians(60.0), 60.0, 2.0, 8.0)
    return Machine("axis", (mine,), PERIOD), Controller({"x": AxisController(LeadLag(**gains))})


def way(seconds: float = 2.0) -> np.ndarray:
    """Return positions back and forth that begin and end at rest."""
    time = np.arange(0.0, seconds, PERIOD)
    fade = np.sin(np.pi * time / seconds) ** 2
    moved = 0.02 * fade * np.sin(2.0 * np.pi * 1.3 * time)
    return np.concatenate([np.zeros(60), moved, np.zeros(100)])[:, None]


def log_of(machine: Machine, controller: Controller, noise: np.ndarray | float = 0.0, place: np.ndarray | None = None) -> Result:
    asked = way() if place is None else place
    path = Path([Line([-0.05], [0.05])])
    reference = Reference.from_samples(asked, PERIOD, path, arc_length=asked[:, 0] + 0.05)
    seen = simulate(machine, controller, reference, signals=("position", "command"))
    signals = {"reference": Signal(asked, ("sample", "axis"), "m"), "position": Signal(seen["position"] + noise, ("sample", "axis"), "m")}
    return Result("log", ("x",), PERIOD, signals)


def guessed(result: Result) -> LogRun:
    machine, controller = parts()
    return log_run(*with_values(machine, controller, GUESS), result, "log")


@pytest.fixture(scope="module")
def result() -> Result:
    return log_of(*parts())


def test_an_axis_that_stands_still_does_not_make_the_others_uncertain(result: Result) -> None:
    machine, controller = with_values(*parts(), {name: GUESS[name] for name in list(GUESS)[:2]})
    still, zeros = replace(machine.axes[0], name="y", disturbance=None), np.zeros(result.n_sample)
    signals = {name: Signal(np.column_stack([result[name][:, 0], zeros]), ("sample", "axis"), "m") for name in result.signals}
    two = replace(machine, axes=(*machine.axes, still)), replace(controller, axes=dict.fromkeys("xy", controller.axes["x"]))
    runs = log_run(machine, controller, result, "log"), log_run(*two, Result("log", ("x", "y"), PERIOD, signals), "log")
    alone, beside = (refine([run], WANTED[:2], settings=RefineSettings(starts=1)).parameters for run in runs)
    for one, other in zip(alone, beside, strict=True):
        assert 0.5 * one.deviation < other.deviation < 2.0 * one.deviation
        assert abs(other.value - one.value) < 2.0 * one.deviation


def test_known_numbers_are_recovered_within_their_deviations(result: Result) -> None:
    found = refine([guessed(result)], WANTED, settings=RefineSettings(starts=2))
    for one in found.parameters:
        true = TRUE[one.sought.name]
        assert abs(one.value - true) < 4.0 * one.deviation + 1e-4 * abs(true), one.sought.name
        assert one.deviation < 0.02 * abs(true)
    assert found.usable and found.after[0].explained > 0.9999 > found.before[0].explained
    assert found.after[0].rms < 1e-7  # one encoder count


def test_motion_outside_a_window_is_ignored(result: Result) -> None:
    found = refine([guessed(result)], WANTED, windows=[(0.0, 1.0)], settings=RefineSettings(starts=1))
    (unseen,) = found.unseen
    (before,) = found.unseen_before
    assert unseen.explained > 0.999 and unseen.rms < before.rms and (before.run, before.axis) == (unseen.run, unseen.axis)
    assert refine([guessed(result)], WANTED[:1], settings=RefineSettings(starts=1)).unseen == ()


def test_one_machine_under_two_controllers_shares_its_numbers(result: Result) -> None:
    machine, controller = parts()
    name = "controller.axes.x.controller.gain"
    gain = controller.axes["x"].controller.values()["gain"]
    soft = with_values(machine, controller, {name: 0.5 * gain})[1]
    guess = with_values(machine, controller, GUESS | {name: 0.7 * gain})
    runs = [guessed(result), log_run(*guess, log_of(machine, soft), "soft")]
    found = refine(runs, [*WANTED, f"soft:{name}={0.2 * gain} A/m..{gain} A/m"], settings=RefineSettings(starts=1))
    wanted = TRUE | {f"soft:{name}": 0.5 * gain}
    assert {one.sought.label: one.value for one in found.parameters} == pytest.approx(wanted, rel=2e-3)
    assert found.runs[0].controller == runs[0].controller and found.runs[1].controller != runs[1].controller
    assert {one.run for one in found.after} == {"log", "soft"}


@pytest.mark.slow
def test_deviations_match_the_scatter_over_many_logs() -> None:
    """Thirty logs with noise correlated over ten rows: the estimates scatter by their stated deviation."""
    from scipy.signal import lfilter

    machine, controller = parts()
    clean = log_of(machine, controller)
    rng, settings = np.random.default_rng(3), RefineSettings(starts=1, rounds=1)
    values, told = [], []
    for _ in range(30):
        noise = 2e-6 * lfilter([1.0], [1.0, -0.9], rng.standard_normal((clean.n_sample, 1)), axis=0)
        noisy = clean.with_signals(position=Signal(clean["position"] + noise, ("sample", "axis"), "m"))
        run = log_run(machine, controller, noisy, "log")
        found = refine([run], WANTED, settings=settings)
        values.append([one.value for one in found.parameters])
        told.append([one.deviation for one in found.parameters])
    # A standard deviation from 30 draws is itself known to 13 percent: allow three times that.
    assert np.sqrt(np.mean(np.square(told), axis=0)) == pytest.approx(np.std(values, axis=0, ddof=1), rel=0.4)
    assert np.mean(values, axis=0) == pytest.approx(list(TRUE.values()), abs=4.0 * np.max(told, axis=0).max() / np.sqrt(30.0))


def test_a_command_in_the_log_is_compared_too(result: Result) -> None:
    machine, controller = parts()
    path = Path([Line([-0.05], [0.05])])
    reference = Reference.from_samples(way(), PERIOD, path, arc_length=way()[:, 0] + 0.05)
    command = simulate(machine, controller, reference, signals=("command",))["command"]
    both = result.with_signals(command=Signal(command, ("sample", "axis"), "A"))
    found = refine([guessed(both)], WANTED, settings=RefineSettings(starts=1))
    assert [one.signal for one in found.after] == ["position", "command"]
    assert all(one.explained > 0.999 for one in found.after)
    strange = result.with_signals(command=Signal(command, ("sample", "axis"), "V"))
    assert [one.code for one in guessed(strange).findings] == ["CL562"]


def test_unidentifiable_and_correlated_numbers_are_reported(result: Result) -> None:
    wanted = [*WANTED, "axes.x.friction.viscous=0 N*s/m..100 N*s/m"]
    machine, controller = parts()
    run = log_run(*with_values(machine, controller, GUESS | {"axes.x.friction.viscous": 50.0}), result, "log")
    found = refine([run], wanted, settings=RefineSettings(starts=1))
    # Two ways to write one damper: only encoder counts distinguish them.
    values = [one.values for one in found.findings if one.code == "CL553" and "plant.damping" in one.place and "viscous" in one.place]
    assert [-1.0 < one["correlation"] < -0.9 for one in values] == [True]
    total = found.parameters[0].value + found.parameters[3].value
    assert total == pytest.approx(TRUE["axes.x.plant.damping"], rel=1e-2)
    name = "axes.x.drive.limit"
    run = log_run(*with_values(*parts(), GUESS | {name: 99.0}), result, "log")
    idle = refine([run], [*WANTED, f"{name}=50 A..200 A"], settings=RefineSettings(starts=1))  # never reached
    assert ("CL551", name) in {(one.code, one.place) for one in idle.findings}
    deviations = [one.deviation for one in idle.parameters]
    assert idle.usable and np.isinf(deviations[3]) and np.isfinite(deviations[:3]).all()


def test_an_active_bound_is_reported(result: Result) -> None:
    wanted = [WANTED[0], "axes.x.friction.coulomb=20 N..40 N", WANTED[2]]
    found = refine([guessed(result)], wanted, settings=RefineSettings(starts=1))
    held = found.parameters[1]
    assert held.at_bound and held.value == 40.0 and np.isnan(held.deviation)
    assert ("CL550", "axes.x.friction.coulomb") in {(one.code, one.place) for one in found.findings}


def test_diverging_lanes_are_handled(result: Result) -> None:
    """The search tries gains up to a hundred times too large, which diverge."""
    machine, controller = parts()
    run = log_run(*with_values(machine, controller, GUESS), result, "log")
    gain = run.controller.axes["x"].controller.values()["gain"]
    wanted = [*WANTED, f"controller.axes.x.controller.gain={gain / 10.0} A/m..{gain * 100.0} A/m"]
    left = run.simulated({"controller.axes.x.controller.gain": [gain, 100.0 * gain]})
    assert np.isfinite(left[:, :, 0]).all() and not np.isfinite(left[:, :, 1]).any()
    found = refine([run], wanted, settings=RefineSettings(starts=3))
    assert found.parameters[3].value == pytest.approx(gain, rel=0.01)


def test_invalid_settings_are_refused_in_words(result: Result) -> None:
    run = guessed(result)
    for wanted, said in (
        (["axes.x.plant.dampings"], "axes.x.plant.dampings"),
        (["elsewhere:axes.x.plant.damping"], "log"),
        (["axes.x.disturbance.sine"], "bounds"),
        (["axes.x.plant.damping", "axes.*.plant.damping"], "once"),
        (["axes.x.plant.damping=10 N*s/m..20 N*s/m"], "start"),
        (["axes.x.plant.damping=900 N*s/m..20 N*s/m"], "first"),
        (["axes.x.plant.damping=-5 N*s/m..900 N*s/m"], ">= 0"),
        (["axes.x.disturbance.order"], "axes.x.disturbance.order"),
        (["axes.x.drive.limit"], "bounds"),
        ([], "one"),
    ):
        with pytest.raises(ParameterError, match=said):
            seek([run], wanted)
    with pytest.raises(ParameterError, match=r"0\.06 s to 2\.159 s"):
        refine([run], WANTED, windows=[(50.0, 60.0)])
    with pytest.raises(ParameterError, match="rows"):
        refine([run], WANTED, windows=[(0.5, 0.51)])
    with pytest.raises(ParameterError, match="1 to 32"):
        RefineSettings(starts=0)


def test_a_log_that_does_not_fit_the_machine_is_refused_in_words(result: Result) -> None:
    machine, controller = parts()
    for other, said in (
        (Result("log", ("z",), PERIOD, result.signals), "no axis x in log"),
        (Result("log", ("x",), 2e-3, result.signals), "sample every 2 ms"),
        (Result("log", ("x",), PERIOD, {"position": result.signals["position"]}), "no reference in log"),
    ):
        with pytest.raises(ResultError, match=said):
            log_run(machine, controller, other, "log")
    hurt = np.array(result["position"])
    hurt[7] = np.nan
    with pytest.raises(ResultError, match="not finite"):
        log_run(machine, controller, result.with_signals(position=Signal(hurt, ("sample", "axis"), "m")), "log")


def test_a_log_that_begins_in_motion_is_reported(result: Result) -> None:
    cut = {name: Signal(signal.data[400:], signal.dims, signal.unit) for name, signal in result.signals.items()}
    machine, controller = parts()
    run = log_run(machine, controller, Result("log", ("x",), PERIOD, cut), "log")
    assert run.steady and run.findings[0].code == "CL561"
    late = run.moves[0] + 300  # the initial transient has decayed
    assert run.agreement(run.once(), slice(late, run.moves[1]))[0].explained > 0.99
