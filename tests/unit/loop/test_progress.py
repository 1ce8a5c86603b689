"""Progress decided in the loop, and a loop that Python steps."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from refusals import refuses
from stages import PERIOD, control, make, stage

import contourlab as cl
from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.errors import ComponentError, DivergenceError, ParameterError
from contourlab.features.run.verdict import judged_run
from contourlab.primitives import fabs, select

RADIUS = 5e-3
PLUGIN = """
import contourlab as cl


class Half(cl.Component):
    \'\'\'Half the planned feed.\'\'\'

    family, kind = "coupling", "test-half"
    inputs = (cl.Port("feedrate"),)
    outputs = (cl.Port("rate"),)
    rate: float = cl.param(default=0.5, minimum=0.0, doc="planned time per time")

    @staticmethod
    def step(par, x, inp, clock):
        return (), (par.rate,)
"""
SCENARIO = """
name = "half"
machine = "builtin:xyz"
controller = "builtin:xyz-controller"
[contour]
name = "circle"
radius = "4 mm"
[feed]
feedrate = "2000 mm/min"
[run]
tolerance = "50 um"
[schemes.half]
controller.coupling = {kind = "test-half"}
"""


class Slowing(Component):
    """Feed that falls as the estimated contour error grows."""

    family, kind = "coupling", "test-slowing"
    example = {"error": 5e-6}
    states = (Port("rate"),)
    inputs = (Port("contour_error_estimate"),)
    outputs = (Port("rate"),)
    error: float = param(unit="m", minimum=0.0, exclusive=True, doc="error at which the feed is halved")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        rate = x.rate + 0.02 * (1.0 / (1.0 + fabs(inp.contour_error_estimate) / par.error) - x.rate)
        return (rate,), (rate,)

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        return {"rate": 1.0}, {}


class Standing(Component):
    """Feed that stops at an arc length."""

    family, kind = "coupling", "test-standing"
    inputs = (Port("arc_length"),)
    outputs = (Port("rate"),)
    place: float = param(default=0.01, unit="m", doc="where it stops")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (select(inp.arc_length >= par.place, 0.0, 1.0),)


PORTS = ("reference_velocity", "reference_acceleration", "velocity", "disturbance_estimate", "arc_length", "feedrate", "curvature")


class Showing(Component):
    """Adds one of its inputs, that of the second axis, to the command of the first one."""

    family, kind = "coupling", "test-showing"
    inputs = (*(Port(name, -1) for name in PORTS[:4]), *(Port(name) for name in PORTS[4:]))
    outputs = (Port("correction", -1),)
    which: float = param(default=0.0, minimum=0.0, maximum=6.0, whole=True, doc="number of the input")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        value = 0.0
        for i in range(7):
            value = select(par.which == float(i), inp[i][1] if i < 4 else inp[i], value)
        return (), ((1e-6 * value, 0.0),)


def limited() -> cl.Machine:
    """Return the stage with limits to plan within."""
    bounds = cl.Limits(velocity=0.2, acceleration=2.0, jerk=100.0)
    return replace(stage(), axes=tuple(replace(axis, limits=bounds) for axis in stage().axes))


def coupled(coupling: Component | None) -> cl.Controller:
    """Return the controller of the stage with another coupling."""
    return replace(control(), coupling=coupling)


@pytest.fixture(scope="module")
def lap() -> cl.Reference:
    """Return a circle at constant speed, in 0.5 s."""
    return cl.uniform(cl.contour("circle", radius=RADIUS), 2.0, 1, PERIOD)


@pytest.fixture(scope="module")
def planned() -> cl.Reference:
    """Return a circle from rest to rest, with a dwell-free plan of two laps."""
    limits = limited().planner_limits()
    return cl.plan(cl.route_from_path(cl.contour("circle", radius=RADIUS), 0.06), limits, PERIOD)


def test_a_stepped_loop_is_the_simulated_one(lap: cl.Reference) -> None:
    whole = cl.simulate(stage(), control(), lap, seed=5)
    loop = cl.Loop(stage(), control(), lap, seed=5)
    for n in (1, 7, 200):
        loop.step(n)
    assert loop["position"].tolist() == whole["position"][207].tolist() and loop.time == pytest.approx(0.207)
    while not loop.done:
        loop.step(13)
    result = loop.result()
    assert set(whole.signals) <= set(result.signals) and loop.tick == lap.n_sample
    for name in whole.signals:
        assert np.array_equal(result[name], whole[name]), name
    assert result.motion is lap and result.attributes == whole.attributes


def test_a_restored_loop_has_the_past_of_its_snapshot(lap: cl.Reference) -> None:
    loop = cl.Loop(stage(), control(), lap, inputs=("rate", "command"), seed=5)
    loop.step(100, rate=0.7)
    early = loop.snapshot()
    loop.step(50, command=(0.1, 0.0))
    late, first = loop.snapshot(), loop.result()
    loop.restore(early)
    loop.step(80, rate=0.1)
    assert loop.tick == 180 and not np.array_equal(loop.result()["position"][:150], first["position"])
    loop.restore(late)
    assert loop.tick == 150 and np.array_equal(loop.result()["position"], first["position"])
    loop.restore(early)
    loop.step(50, command=(0.1, 0.0))
    assert np.array_equal(loop.result()["position"], first["position"])


def test_compiled_and_plain_loops_agree(lap: cl.Reference) -> None:
    results = []
    smooth = stage(friction=make("friction", "none"), sensor=make("sensor", "ideal"))  # neither sticks nor counts
    for jit in (True, False):
        loop = cl.Loop(smooth, control(), lap, inputs=("command", "reference", "rate"), seed=5, jit=jit)
        loop.step(60, rate=1.3, reference=(1e-4, 0.0))
        loop.step(60, rate=0.35, command=(0.0, 0.2))
        results.append(loop.result())
    for name in results[0].signals:
        size = np.abs(results[1][name]).max()
        assert np.abs(results[0][name] - results[1][name]).max() <= 1e-9 * size, name


def test_inputs_act_where_they_say(lap: cl.Reference) -> None:
    given = {"command": (0.0, 0.3), "reference": (2e-5, 0.0)}
    for name, value in given.items():
        learned = cl.Learned(**{name: np.tile(value, (lap.n_sample, 1))})
        whole = cl.simulate(stage(), control(), lap, learned=learned)
        loop = cl.Loop(stage(), control(), lap, inputs=(name,))
        loop.step(lap.n_sample, **{name: value})
        assert np.array_equal(loop.result()["position"], whole["position"])


@pytest.mark.parametrize("rate", [0.5, 0.3, 1.7])
def test_a_constant_rate_scales_time(lap: cl.Reference, rate: float) -> None:
    loop = cl.Loop(stage(), control(), lap, inputs=("rate",))
    loop.step(250, rate=rate)
    run, time = loop.result(), rate * PERIOD * np.arange(250)
    speed = 2.0 * np.pi * RADIUS * 2.0
    np.testing.assert_allclose(run["planned_time"], time, atol=1e-12)
    np.testing.assert_allclose(run["arc_length"], speed * time, atol=1e-12)
    # The cubic through two points of a circle: h^4/384 of the fourth derivative.
    at = run["arc_length"]
    assert np.abs(run["reference"] - lap.path.derivatives(at, 0)[0]).max() <= (PERIOD**4 / 384.0) * speed**4 / RADIUS**3 * 1.01 + 1e-15
    tangent, kinks = lap.path.tangent(at), speed**2 / RADIUS
    np.testing.assert_allclose(run["reference_velocity"], rate * speed * tangent, atol=speed * (speed / RADIUS * PERIOD) ** 2)
    inward = -lap.path.derivatives(at, 0)[0] / RADIUS
    np.testing.assert_allclose(run["reference_acceleration"], rate**2 * kinks * inward, atol=kinks * (speed / RADIUS * PERIOD) ** 2)


def test_set_points_are_derivatives_of_each_other(planned: cl.Reference) -> None:
    loop = cl.Loop(stage(), control(), planned, inputs=("rate",))
    k = 0
    while not loop.done:
        loop.step(rate=1.0 + 0.6 * np.sin(0.02 * k))
        k += 1
    run = loop.result()
    position, velocity, acceleration = (run[name] for name in ("reference", "reference_velocity", "reference_acceleration"))
    block, fastest, change = planned.block(0, planned.n_sample), 1.6, 0.6 * 0.02 / PERIOD
    steep, jerk = np.abs(block.acceleration).max(), np.abs(np.diff(block.acceleration, axis=0)).max() / PERIOD
    # Backward differences: half a period late.
    assert np.abs(np.diff(position, axis=0) / PERIOD - velocity[1:]).max() <= 0.5 * PERIOD * fastest**2 * steep * 1.01
    late = PERIOD * (0.5 * fastest**3 * jerk + change * fastest * steep)
    assert np.abs(np.diff(velocity, axis=0) / PERIOD - acceleration[1:]).max() <= late * 1.01
    assert run.motion.duration == pytest.approx((k - 1) * PERIOD) and run["planned_time"][-1] >= planned.duration


def test_a_coupling_decides_the_feed(planned: cl.Reference) -> None:
    machine, controller = stage(), coupled(Slowing(error=5e-6))
    assert cl.check_component(Slowing)
    run = cl.simulate(machine, controller, planned, seed=3)
    motion = run.motion
    assert motion.decided and motion.n_sample == run.n_sample > 1.1 * planned.n_sample
    # Both figures: the time that the run took, and the time of its plan.
    assert motion.duration == pytest.approx((run.n_sample - 1) * PERIOD)
    assert run["planned_time"][-1] == pytest.approx((planned.n_sample - 1) * PERIOD)
    # The motion that it followed, given as a reference, is followed as it was.
    again = cl.simulate(machine, controller, motion, seed=3)
    for name in again.signals:
        assert np.array_equal(again[name], run[name]), name
    stepped = cl.Loop(machine, controller, planned, seed=3)
    while not stepped.done:
        stepped.step(500)
    assert np.array_equal(stepped.result()["position"], run["position"]) and stepped.result().motion.digest == motion.digest
    plain = cl.Loop(machine, controller, planned, seed=3, jit=False)
    plain.step(150)
    np.testing.assert_allclose(plain.result()["position"], run["position"][:150], rtol=1e-9, atol=1e-12)
    # Blocks do not matter, and signals that are not asked for are not kept.
    few = cl.simulate(machine, controller, planned, seed=3, signals=("position",))
    assert set(few.signals) == {"position"} and few.motion.digest == motion.digest
    figures = cl.summarise(cl.judge(run, motion), motion)
    assert figures.cycle_time == pytest.approx(motion.duration)
    batch = cl.simulate_batch(machine, controller, motion, {"axes.*.friction.coulomb": [0.055, 0.06]})
    assert (batch.failed_at == -1).all()


def test_judged_samples_are_those_of_the_plan() -> None:
    program = cl.parse_program("G21 G90 G94 G17\nG1 X5 F2000\nG0 Y4\nG1 X0\nM2\n")
    planned = cl.plan(cl.route_from_program(program, ("x", "y")), limited().planner_limits(), PERIOD)
    run = cl.simulate(stage(), coupled(Slowing(error=2e-6)), planned)
    motion, lines = run.motion, planned.source_line(run["arc_length"])
    assert motion.judged.basis == planned.judged.basis and len(motion.judged.ranges) == len(planned.judged.ranges) == 2
    for (start, stop), (first, last), line in zip(motion.judged.ranges, planned.judged.ranges, (2, 4), strict=True):
        # The first sample after the last one of the rapid before.
        assert run["planned_time"][start] > (first - 1) * PERIOD and (start == 0 or run["planned_time"][start - 1] <= (first - 1) * PERIOD)
        assert stop - start > last - first and set(lines[start + 1 : stop - 1]) == {line}


def test_a_reversal_between_moves_counts_as_in_the_plan() -> None:
    program = cl.parse_program("G21 G90 G94 G17\nG1 X5 F2000\nG0 X2\nG1 X6\nM2\n")
    planned = cl.plan(cl.route_from_program(program, ("x", "y")), limited().planner_limits(), PERIOD)
    for rate in (1.0, 0.73, 1.19):
        loop = cl.Loop(limited(), control(), planned, inputs=("rate",))
        while not loop.done:
            loop.step(100, rate=rate)
        run = loop.result()
        (_, stop), (start, _) = run.motion.judged.ranges
        moving = np.flatnonzero(run["reference_velocity"][:, 0])
        turns = moving[1:][np.diff(np.sign(run["reference_velocity"][moving, 0])) != 0.0]
        assert len(turns) == 2 and stop <= turns[0] < stop + 3 and start <= turns[1] < start + 3, rate


def test_what_looks_ahead_sees_where_the_motion_will_be() -> None:
    circle, smooth = cl.contour("circle", radius=RADIUS), stage(friction=make("friction", "none"), sensor=make("sensor", "ideal"))
    lead = make("feedforward", "zpetc", numerator=(1.0,), denominator=(1.0,), lead=30)
    leading = replace(control(), axes={name: replace(axis, feedforward=lead) for name, axis in control().axes.items()})
    slow = cl.simulate(smooth, leading, cl.uniform(circle, 1.0, 1, PERIOD))
    loop = cl.Loop(smooth, leading, cl.uniform(circle, 2.0, 1, PERIOD), inputs=("rate",))
    loop.step(960, rate=0.5)
    # With planned ticks in place of real ones they are 225 um apart.
    assert np.abs(loop.result()["axis_position"] - slow["axis_position"][:960]).max() < 2e-8


def test_advice_about_a_slower_plan_is_judged_by_what_was_followed(planned: cl.Reference) -> None:
    machine, controller = stage(), coupled(Slowing(error=5e-6))
    slower = cl.plan(cl.route_from_path(planned.path, 0.03), limited().planner_limits(), PERIOD)
    judged, sample = judged_run(machine, controller, slower)
    run = cl.simulate(machine, controller, slower)
    figures = cl.summarise(cl.judge(run, run.motion), run.motion)
    assert judged.motion is not None and judged.motion.digest == run.motion.digest != slower.digest
    assert abs(judged["part_error"][sample]) == figures.part_error.max


def test_a_motion_that_does_not_end_fails(planned: cl.Reference) -> None:
    with refuses(DivergenceError, sample=10 * planned.n_sample - 1, axis=""):
        cl.simulate(stage(), coupled(Standing()), planned)
    ended = cl.simulate(stage(), coupled(Standing()), planned, on_failure="return")
    assert not ended.status.ok and ended["arc_length"][-1] == pytest.approx(0.01, abs=1e-4)


def test_what_needs_a_known_motion_refuses_to_decide_it(planned: cl.Reference) -> None:
    machine, controller = stage(), coupled(Slowing(error=5e-6))
    with refuses(ParameterError, name="controller.coupling"):
        cl.simulate_batch(machine, controller, planned, {"controller.coupling.error": [1e-6, 2e-6]})
    with refuses(ParameterError, name="controller.coupling"):
        cl.simulate(machine, controller, planned, learned=cl.Learned(command=np.zeros((planned.n_sample, 2))))
    with refuses(ParameterError, name="changes"):
        cl.simulate(machine, controller, planned, changes=(cl.Change(0.05, control()),))
    with refuses(ComponentError):
        cl.contour_margins(machine, controller)


@pytest.mark.parametrize("which", range(7))
def test_couplings_see_the_reference_and_the_axes(lap: cl.Reference, which: int) -> None:
    run = cl.simulate(stage(), coupled(Showing(which=float(which))), lap, seed=2)
    name, shown = PORTS[which], 1e6 * run["coupling_command"][:, 0]
    seen = np.full(len(shown), 1.0 / RADIUS) if name == "curvature" else run[name]
    wanted = seen[:, 1] if seen.ndim == 2 else seen
    late = 1 if name == "disturbance_estimate" else 0  # observers come after the coupling
    np.testing.assert_allclose(shown[late:], wanted[: len(wanted) - late], rtol=1e-9, atol=1e-12)


def test_curvature_follows_the_progress(lap: cl.Reference) -> None:
    ellipse = cl.uniform(cl.contour("ellipse"), 1.0, 1, PERIOD)
    loop = cl.Loop(stage(), coupled(Showing(which=6.0)), ellipse, inputs=("rate",))
    loop.step(400, rate=0.5)
    run = loop.result()
    wanted = ellipse.path.curvature(run["arc_length"])
    bend = np.abs(np.diff(ellipse.path.curvature(ellipse.block(0, 300).arc_length), 2)).max()
    assert np.abs(1e6 * run["coupling_command"][:, 0] - wanted).max() <= bend / 8.0 * 1.01  # of a straight line between two samples


def test_wrong_use_is_refused(lap: cl.Reference) -> None:
    with refuses(ParameterError, name="inputs"):
        cl.Loop(stage(), control(), lap, inputs=("feed",))
    with refuses(ParameterError, name="inputs"):
        cl.Loop(stage(), coupled(Slowing(error=1e-6)), lap, inputs=("rate",))
    with refuses(ParameterError, name="controller.axes.x.observer"):
        blind = {name: replace(axis, observer=None) for name, axis in control().axes.items()}
        cl.Loop(stage(), replace(coupled(Showing()), axes=blind), lap)
    loop = cl.Loop(stage(), control(), lap, inputs=("rate", "command"))
    with refuses(ParameterError, name="signal"):
        loop["position"]
    with refuses(ParameterError, name="result"):
        loop.result()
    wrong: list[dict[str, Any]] = [
        {"reference": (0.0, 0.0)},
        {"rate": -0.1},
        {"rate": np.nan},
        {"rate": (1.0, 1.0)},
        {"command": 0.0},
        {"command": (0.0, np.inf)},
        {"rate": "fast"},
        {"command": [[1.0], [1.0, 2.0]]},
        {"n": 0},
        {"n": 1.5},
    ]
    for arguments in wrong:
        with refuses(ParameterError, name=next(iter(arguments))):
            loop.step(**arguments)
    for other in (cl.Loop(stage(), control(), lap, inputs="rate").snapshot(), None):  # one name may be given alone
        with refuses(ParameterError, name="saved"):
            loop.restore(other)
    with refuses(ParameterError, name="signal"):
        loop.step() and loop["speed"]
    loop.step(lap.n_sample)
    with refuses(ParameterError, name="step"):
        loop.step()


def test_a_loop_that_runs_away_says_where(lap: cl.Reference) -> None:
    machine = replace(stage(), axes=tuple(replace(axis, limits=replace(axis.limits, following_error=1e-3)) for axis in stage().axes))
    loop = cl.Loop(machine, control(), lap, inputs=("command",))
    loop.step(20)
    status = loop.step(100, command=(8.0, 0.0))
    assert not status.ok and loop.done and status.axis == "x" and loop.tick == status.sample + 1 == loop.result().n_sample


def test_a_run_states_both_times(tmp_path: Path) -> None:
    plugin = tmp_path / "standing.py"
    plugin.write_text(PLUGIN, encoding="utf-8")
    scenario = tmp_path / "case.toml"
    scenario.write_text(SCENARIO, encoding="utf-8")
    answer = (cl.load_plugin(plugin), cl.run(str(scenario)))[1]
    decided = [found for found in answer.outcomes[0].findings if found.code == "CL231"]
    assert len(decided) == 1 and decided[0].values["time"] == pytest.approx(2.0 * decided[0].values["planned"], rel=0.01)
    assert answer.outcomes[0].metrics.cycle_time == pytest.approx(decided[0].values["time"], abs=2e-3)
    # What is quicker than its plan breaks the limits of the plan.
    scenario.write_text(SCENARIO.replace('"test-half"', '"test-half", rate = 1.5'), encoding="utf-8")
    hasty = cl.run(str(scenario)).outcomes[0]
    (beyond,) = (found for found in hasty.findings if found.code == "CL232")
    planned = cl.limit_report(hasty.case.reference(), hasty.machine.planner_limits())
    assert beyond.values["use"] == pytest.approx(1.5**3 * max(worst.ratio for worst in planned.jerk), rel=0.02)
    assert not any(found.code == "CL232" for found in answer.outcomes[0].findings)
