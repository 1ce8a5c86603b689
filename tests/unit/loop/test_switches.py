"""The list of switches gives the active controller of every sample and the reason of each switch."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import contourlab as cl
from contourlab.components.controller.cascade import Cascade
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.components.supervisor.switching import EstimatorBased, Performance, PreRouted
from contourlab.feed import route_from_program
from contourlab.loop import Change
from contourlab.loop.switches import Switches, SwitchKind, SwitchLog, switches_of

PERIOD, GAP = 1e-3, 20e-6
DRIVE = TwoInertia(motor_inertia=5.2e-3, load_inertia=4.4e-3, lead=0.016, stiffness=950.0, shaft_damping=0.05, backlash_gap=GAP)
FAST = Cascade(**Cascade.tune(80.0, 0.9, *DRIVE.rigid_model(), 20.0))
SLOW = Cascade(**Cascade.tune(40.0, 0.9, *DRIVE.rigid_model(), 10.0))
Whole = NDArray[np.int64]


def led(supervisor: Any, *others: str) -> cl.AxisController:
    return cl.AxisController(FAST, feedback="motor", supervisor=supervisor, others=tuple((name, SLOW) for name in others))


def recorded(active: Any, reason: Any, start: int = 0, **more: Any) -> cl.Result:
    """Return a run of axes x, y ... with only the supervisors' signals."""
    columns = {"active_controller": active, "switch_reason": reason, **more}
    signals = {
        name: cl.Signal(np.asarray(data, float), ("sample", "axis") if np.ndim(data) == 2 else ("sample",), "")
        for name, data in columns.items()
    }
    return cl.Result("made", tuple("xyz"[: np.shape(active)[1]]), PERIOD, signals, start=start)


def tuples(switches: Switches) -> list[tuple[int, str, str, str, str]]:
    """Return the switches as tuples: sample, axis, from, to, reason."""
    kinds = [switches.kinds[k] for k in switches.kind]
    return [(int(n), k.axis, k.before, k.after, k.reason) for n, k in zip(switches.sample, kinds, strict=True)]


def test_a_short_list_against_a_manual_check() -> None:
    controller = cl.Controller({"x": led(Performance(thresholds=(1e-5,)), "gap"), "y": cl.AxisController(FAST)})
    active = np.array([[0, 0], [1, 0], [1, 0], [0, 0], [0, 0], [1, 0]])
    reason = np.array([[0, 0], [2, 0], [0, 0], [1, 0], [0, 0], [2, 0]])
    found = switches_of(recorded(active, reason, arc_length=np.arange(6) * 0.5), controller)
    assert found is not None and found.axes == ("x",) and found.first == {"x": "controller"}
    rose, fell = Performance.reasons
    assert tuples(found) == [(1, "x", "controller", "gap", fell), (3, "x", "gap", "controller", rose), (5, "x", "controller", "gap", fell)]
    np.testing.assert_allclose(found.time, [1e-3, 3e-3, 5e-3])
    np.testing.assert_allclose(found.arc_length, [0.5, 1.5, 2.5])
    assert found.active == {"x": {"controller": 3, "gap": 3}}
    assert found.counts() == {SwitchKind("x", "controller", "gap", fell): 2, SwitchKind("x", "gap", "controller", rose): 1}


def test_a_run_without_a_supervisor_has_no_list() -> None:
    controller = cl.Controller(dict.fromkeys("xy", cl.AxisController(FAST)))
    assert switches_of(cl.Result("made", ("x", "y"), PERIOD, {}), controller) is None


def test_a_supervisor_may_switch_at_the_very_first_sample() -> None:
    """A run begins with number 0; for a part of a run the previous controller is unknown."""
    controller = cl.Controller({"x": led(EstimatorBased(), "gap")})
    result = recorded([[1], [1], [0]], [[1], [0], [3]])
    whole, part = switches_of(result, controller), switches_of(result.window(1, 3), controller)
    assert whole is not None and part is not None
    assert tuples(whole) == [
        (0, "x", "controller", "gap", EstimatorBased.reasons[0]),
        (2, "x", "gap", "controller", EstimatorBased.reasons[2]),
    ]
    assert tuples(part) == tuples(whole)[1:] and part.first == {"x": "gap"}


def test_a_reason_may_name_the_controller_that_takes_over() -> None:
    class Named(PreRouted):
        reasons = ("{name} here",)

    controller = cl.Controller({"x": led(Named(places=(0.0, 1.0, 2.0), numbers=(0.0, 1.0, 2.0)), "light", "heavy")})
    found = switches_of(recorded([[0], [1], [2]], [[0], [1], [1]]), controller)
    assert found is not None
    assert [kind.reason for kind in found.kinds] == ["light here", "heavy here"]


def test_unknown_numbers_and_reasons_of_a_foreign_supervisor_are_shown_unchanged() -> None:
    """An unknown controller number, an unknown reason, and no number in the last sample of a failed run."""
    controller = cl.Controller({"x": led(Performance(thresholds=(1e-5,)), "gap")})
    found = switches_of(recorded([[0], [7], [1], [np.nan]], [[0], [9], [0], [np.nan]]), controller)
    assert found is not None
    assert [switch[:4] for switch in tuples(found)] == [(1, "x", "controller", "number 7"), (2, "x", "number 7", "gap")]
    assert all(reason not in Performance.reasons for *_, reason in tuples(found))


def rebuilt(switches: Switches, axis: str, n: int) -> list[str]:
    """Return the active controller of each sample, from the list alone."""
    names, now = [], switches.first[axis]
    changes = {sample: after for sample, name, _, after, _ in tuples(switches) if name == axis}
    for k in range(n):
        now = changes.get(k, now)
        names.append(now)
    return names


numbers = st.integers(1, 60).flatmap(lambda n: st.lists(st.lists(st.integers(0, 2), min_size=2, max_size=2), min_size=n, max_size=n))


@settings(deadline=None, max_examples=60)
@given(numbers, st.lists(st.integers(1, 9), min_size=1, max_size=60))
def test_blocks_of_any_length_give_the_whole_list_and_the_list_gives_the_signal(rows: list[list[int]], lengths: list[int]) -> None:
    active = np.array(rows)
    reason = (np.diff(active, axis=0, prepend=0) != 0) * (1 + (active > 0))
    supervisor = Performance(thresholds=(1e-6, 1e-5))
    controller = cl.Controller(dict.fromkeys("xy", led(supervisor, "light", "heavy")))
    result = recorded(active, reason)
    whole = switches_of(result, controller)
    assert whole is not None
    for axis, column in (("x", 0), ("y", 1)):
        assert rebuilt(whole, axis, len(rows)) == [("controller", "light", "heavy")[number] for number in active[:, column]]
    log, parts, edge = SwitchLog(controller, PERIOD), [], 0
    while edge < len(rows):
        step = lengths[len(parts) % len(lengths)]
        parts.append(log.add(result.window(edge, min(edge + step, len(rows)))))
        edge += step
    assert [one for part in parts for one in tuples(part)] == tuples(whole)
    assert sum((Counter(part.counts()) for part in parts), Counter()) == Counter(whole.counts())
    held = sum((Counter(part.active["x"]) for part in parts), Counter())
    assert held == Counter(whole.active["x"]) and held.total() == len(rows)


def test_the_list_of_a_run_agrees_with_the_motion() -> None:
    """At each switch the measure has just passed its threshold by the hysteresis; switches are at least the dwell time apart."""
    supervisor = Performance(thresholds=(0.5 * GAP,), hysteresis=1e-6, dwell_time=4e-3)
    axes = tuple(cl.Axis(name, DRIVE, substeps=4) for name in "xy")
    reference = cl.uniform(cl.contour("circle", radius=0.02), 1.0, 2, PERIOD)
    controller = cl.Controller(dict.fromkeys("xy", led(supervisor, "gap")))
    run = cl.simulate(cl.Machine("stage", axes, PERIOD), controller, reference)
    found = switches_of(run, controller, reference)
    assert found is not None and len(found) > 20
    apart = np.abs(run["motor_position"] - run["axis_position"])
    rose, fell = Performance.reasons
    for sample, axis, before, after, reason in tuples(found):
        seen = apart[sample, "xy".index(axis)]
        if after == "gap":
            assert before == "controller" and reason == fell and seen <= 0.5 * GAP + 1e-6
        else:
            assert after == "controller" and reason == rose and seen >= 0.5 * GAP - 1e-6
    for axis in "xy":
        assert np.diff(found.sample[found.of(axis)]).min() >= 4


def test_switches_name_the_line_of_the_program() -> None:
    """Routed by arc length: the first corner of a square is at 10 mm, where line 3 begins."""
    program = cl.parse_program("G21 G90 G61 F6000\nG1 X10\nG1 Y10\nG1 X0\nG1 Y0\nM2\n")
    limits = cl.AxisLimits([0.2, 0.2], [2.0, 2.0], [100.0, 100.0])
    reference = cl.plan(route_from_program(program, ("x", "y")), limits, PERIOD)
    controller = cl.Controller(dict.fromkeys("xy", led(PreRouted(places=(0.01, 0.03), numbers=(1.0, 0.0)), "light")))
    axes = tuple(cl.Axis(name, DRIVE, substeps=4) for name in "xy")
    run = cl.simulate(cl.Machine("stage", axes, PERIOD), controller, reference)
    found = switches_of(run, controller, reference)
    assert found is not None
    assert [(one[1], one[3]) for one in tuples(found)] == [("x", "light"), ("y", "light"), ("x", "controller"), ("y", "controller")]
    assert found.line.tolist() == [3, 3, 5, 5]
    along = run["arc_length"]
    for sample, edge in zip(found.sample, (0.01, 0.01, 0.03, 0.03), strict=True):
        assert along[sample - 1] < edge <= along[sample]


@pytest.mark.parametrize("block", [1 << 16, 300])
def test_a_controller_change_is_a_switch_too(block: int) -> None:
    supervisor = Performance(thresholds=(0.5 * GAP,), hysteresis=1e-6)
    first = cl.Controller(dict.fromkeys("xy", led(supervisor, "gap")))
    then = cl.Controller(dict.fromkeys("xy", led(supervisor, "free")))
    changes = (Change(0.6, then, file="folder/second.toml"),)
    axes = tuple(cl.Axis(name, DRIVE, substeps=4) for name in "xy")
    machine, reference = cl.Machine("stage", axes, PERIOD), cl.uniform(cl.contour("circle", radius=0.02), 1.0, 1, PERIOD)
    run = cl.simulate(machine, first, reference, changes=changes)
    log = SwitchLog(first, PERIOD, reference, changes)
    found = [one for k in range(0, run.n_sample, block) for one in tuples(log.add(run.window(k, min(k + block, run.n_sample))))]
    taken = [(sample, axis) for sample, axis, _, _, reason in found if "folder/second.toml" in reason]
    assert taken == [(600, axis) for axis in "xy"]
    for sample, _, before, after, _ in found:
        assert (before in ("controller", "gap")) == (sample <= 600)
        assert (after in ("second: controller", "second: free")) == (sample >= 600)


@pytest.mark.parametrize("supervised_first", [True, False])
def test_switches_are_listed_if_only_one_of_two_controllers_has_a_supervisor(supervised_first: bool) -> None:
    """The list up to the change, or after it, is that of the supervisor; the other controller never switches."""
    several = cl.Controller(dict.fromkeys("xy", led(Performance(thresholds=(0.5 * GAP,), hysteresis=1e-6), "gap")))
    single = cl.Controller(dict.fromkeys("xy", cl.AxisController(FAST, feedback="motor")))
    first, then = (several, single) if supervised_first else (single, several)
    axes = tuple(cl.Axis(name, DRIVE, substeps=4) for name in "xy")
    reference = cl.uniform(cl.contour("circle", radius=0.02), 1.0, 1, PERIOD)
    changes = (Change(0.5, then, file="second.toml"),)
    run = cl.simulate(cl.Machine("stage", axes, PERIOD), first, reference, changes=changes)
    found = switches_of(run, first, reference, changes)
    assert found is not None
    own = [sample for sample, *_, reason in tuples(found) if reason.startswith("the measure")]
    assert len(own) > 6 and all((sample < 500) == supervised_first for sample in own)
    assert sum("takes over" in reason for *_, reason in tuples(found)) == 2
    assert not run["active_controller"][slice(500, None) if supervised_first else slice(500)].any()


def test_an_axis_with_one_controller_is_listed_when_it_changes() -> None:
    first, then = (cl.Controller({"x": cl.AxisController(kind, feedback="motor")}) for kind in (FAST, SLOW))
    result = cl.Result("made", ("x",), PERIOD, {"position": cl.Signal(np.zeros((10, 1)), ("sample", "axis"), "m")})
    found = switches_of(result, first, changes=(Change(4e-3, then, file="slow.toml"), Change(7.5e-3, first)))
    assert found is not None
    assert [one[:4] for one in tuples(found)] == [(4, "x", "controller", "slow"), (8, "x", "slow", "from 0.0075 s")]
    assert found.active == {"x": {"controller": 4, "slow": 4, "from 0.0075 s": 2}}
