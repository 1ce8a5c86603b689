"""A loop as WebAssembly, in node: the bits of its unfused machine code, and the constants of every changed parameter."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from component_rig import make
from numpy.typing import NDArray
from parts_in_loops import KINDS, loop_with
from stages import control, stage
from wasm_host import in_node, log_of, needs_node

import contourlab as cl
from contourlab.components.contract import Component
from contourlab.components.registry import component
from contourlab.engine import fused
from contourlab.engine.runner import CompiledGroup
from contourlab.engine.translate import step_graph
from contourlab.engine.translate.maths import LANES
from contourlab.engine.translate.step_graph import Rows, tick_graph
from contourlab.engine.translate.tick_loop import SIGNATURE, source_of
from contourlab.engine.translate.tracing import KnownError, Trace
from contourlab.errors import ParameterError
from contourlab.geometry.view import view_of
from contourlab.loop import parameters_of
from contourlab.loop.batch import judged_loop
from contourlab.loop.feeding import Feed
from contourlab.loop.judging import all_judged
from contourlab.loop.portable import PortableLoop, portable
from contourlab.native import llvm, store

Array = NDArray[np.float64]


def circle(machine: cl.Machine, duration: float = 0.2) -> cl.Reference:
    return cl.uniform(cl.contour("circle", radius=5e-3), duration, 1, machine.servo_period)


def native(loop: PortableLoop, *, fused: bool = True) -> tuple[Array, Array]:
    """Return the rows of memory after all ticks, and the log, from this machine's processor."""
    group = CompiledGroup(loop.schedule, 1, slice(0, 1), like_lanes=True)
    if not fused:
        made = tick_graph(loop.schedule, Rows(group.places.states, group.places.parameters), loop.rows, LANES, contract=False)
        code = llvm.object_code(source_of(made, 1, 1, fused=False))
        group.loops[loop.rows] = llvm.loaded(code, "run", SIGNATURE)
    log = group.run(loop.fed().T, list(loop.rows))
    return group.memory[:, 0], log[:, :, 0]


def assert_same_bits(loop: PortableLoop) -> None:
    memory, log = native(loop, fused=False)
    _, seen, rows = in_node(loop, ("run", 0, loop.feed.reference.n_sample), log_of(loop), ("read", loop.first, memory.size))
    np.testing.assert_array_equal(seen.reshape(log.shape), log)
    np.testing.assert_array_equal(rows, memory)


def changed(loop: PortableLoop, name: str) -> float:
    """Return another value that is allowed."""
    word, declared = loop.parameters[name]
    value = loop.start[word - loop.first]
    step = 1.0 if declared.whole else 0.0625 * abs(value) or 2.0**-10
    for new in (value + step, value - step) if np.isfinite(value) else (1e3,):
        with suppress(ParameterError):
            return float(declared.check(new))
    raise AssertionError(name)


def assert_prepared(machine: cl.Machine, controller: cl.Controller, reference: cl.Reference, loop: PortableLoop) -> None:
    """Check each parameter: its constants are those of a machine that has the value, or the module refuses what the machine refuses."""
    n_row, view = loop.state[1][1] - loop.first, view_of(reference.path)
    commands: list[tuple[Any, ...]] = []
    for name, (word, _) in loop.parameters.items():
        commands += [("write", word, [changed(loop, name)]), ("prepare",), ("read", loop.first, n_row), ("write", loop.first, loop.start)]
    found = in_node(loop, *commands)
    for name, holds, rows in zip(loop.parameters, found[::2], found[1::2], strict=True):
        try:
            one, other = cl.with_values(machine, controller, {name: changed(loop, name)})
            schedule = judged_loop(one, other, Feed(one, other, reference, None, None), {}, view, 0).schedule
        except ParameterError:
            assert holds[0] == 0.0, name
            continue
        assert holds[0] == 1.0, name
        wanted = CompiledGroup(all_judged(schedule), 1, slice(0, 1), like_lanes=True).memory[:, 0]
        np.testing.assert_allclose(rows, wanted, rtol=1e-13, atol=0.0, err_msg=name)


@needs_node
def test_the_module_computes_the_bits_of_its_loop() -> None:
    machine, controller = stage(), control()
    assert_same_bits(portable(machine, controller, circle(machine), seed=3))


@needs_node
def test_the_loop_of_another_motion_is_found_in_the_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    machine, controller = stage(), control()
    monkeypatch.setattr(store, "folder", lambda: tmp_path)
    for duration in (0.2, 0.25):
        monkeypatch.setattr(fused, "_loops", {})
        loop = portable(machine, controller, circle(machine, duration))
        monkeypatch.setattr(step_graph, "tick_graph", None)
    assert_same_bits(loop)


@needs_node
def test_a_run_begins_in_the_middle() -> None:
    machine, controller = stage(), control()
    loop, k = portable(machine, controller, circle(machine)), 70
    reads = [("read", begin, end - begin) for begin, end in loop.state]
    _, *states, _, whole = in_node(loop, ("run", 0, k), *reads, ("run", k, loop.feed.reference.n_sample - k), log_of(loop))
    writes = [("write", begin, state) for (begin, _), state in zip(loop.state, states, strict=True)]
    *_, part = in_node(loop, *writes, ("run", k, loop.feed.reference.n_sample - k), log_of(loop))
    rows = slice(k * len(loop.rows), None)
    np.testing.assert_array_equal(part[rows], whole[rows])


def smooth() -> tuple[cl.Machine, cl.Controller]:
    """Return a loop without decisions that amplify a last digit."""
    return stage(friction=make("friction", "none"), sensor=make("sensor", "ideal")), control()


@needs_node
def test_a_changed_parameter_gives_the_figures_of_a_variant() -> None:
    machine, controller = smooth()
    reference, name, value = circle(machine), "controller.axes.x.observer.bandwidth", 260.0
    loop = portable(machine, controller, reference)
    commands = ("write", loop.parameters[name][0], [value]), ("prepare",), ("run", 0, loop.feed.reference.n_sample), ("judge",)
    reads = [("read", word, 1) for word in (*loop.figures.values(), loop.failed_at)]
    holds, _, _, *found, failed = in_node(loop, *commands, *reads)
    batch = cl.simulate_batch(machine, controller, reference, {name: [value]}, part=True, effort=True)
    base = cl.simulate_batch(machine, controller, reference, {name: [200.0]}, part=True, effort=True)
    assert holds[0] == 1.0 and failed[0] == batch.failed_at[0] == -1
    assert batch.figures["contour_error_max"][0] != pytest.approx(base.figures["contour_error_max"][0], rel=1e-3)
    figures = dict(zip(loop.figures, (float(one[0]) for one in found), strict=True))
    unsure = figures.pop("unsure")
    assert unsure < reference.n_sample
    assert figures.keys() == batch.figures.keys()
    for figure, known in batch.figures.items():
        assert figures[figure] == pytest.approx(known[0], rel=1e-6, abs=1e-12), figure


@needs_node
@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind.kind in ("two-inertia", "load-observer", "backlash-inverse")])
def test_constants_follow_from_parameters(kind: type[Component]) -> None:
    machine, controller = loop_with(kind)
    reference = circle(machine)
    assert_prepared(machine, controller, reference, portable(machine, controller, reference))


@needs_node
def test_parameters_that_do_not_fit_together_are_refused() -> None:
    machine, controller = loop_with(component("compensation", "adaptive-backlash-inverse"))
    loop = portable(machine, controller, circle(machine))
    gap = loop.parameters["controller.axes.y.compensation.backlash_gap"][0]
    most = controller.axes["y"].compensation.largest_gap
    fits, refused = in_node(loop, ("write", gap, [0.9 * most]), ("prepare",), ("write", gap, [1.1 * most]), ("prepare",))
    assert (fits[0], refused[0]) == (1.0, 0.0)


@needs_node
def test_a_value_beyond_its_bounds_is_refused() -> None:
    machine, controller = smooth()
    loop = portable(machine, controller, circle(machine))
    word = loop.parameters["controller.axes.x.observer.bandwidth"][0]
    for value, holds in ((260.0, 1.0), (0.0, 0.0), (-1.0, 0.0), (np.nan, 0.0), (np.inf, 0.0)):
        assert in_node(loop, ("write", word, [value]), ("prepare",))[0][0] == holds, value


def test_what_cannot_change_is_named() -> None:
    machine, controller = stage(), control()
    loop = portable(machine, controller, circle(machine))
    assert loop.fixed.keys() == {f"axes.{axis}.{name}" for axis in "xy" for name in ("sensor.stream", "drive.delay")}


def test_code_beside_numpy_names_its_parameters() -> None:
    trace = Trace()
    a, b = trace.leaf(0, 2.0, "a"), trace.leaf(1, 3.0, "b")
    asks = (
        lambda: float(a * b),
        lambda: np.column_stack([a]),
        lambda: (a + 1.0).min(),
        lambda: 2.0**b,
        lambda: np.asarray(a),
        lambda: a * np.ones(2),
    )
    for ask, names in zip(asks, ("ab", "a", "a", "b", "a", "a"), strict=True):
        with pytest.raises(KnownError) as caught:
            ask()
        assert caught.value.args[1] == set(names)
    assert max(a, b) is b and len(trace.conditions) == 1


FRICTIONS = {
    "none": make("friction", "none"),
    "smooth": make("friction", "smooth-coulomb", coulomb=0.05, breakaway=0.07, stribeck_velocity=2e-3, smoothing_velocity=1e-4),
    "lugre": make("friction", "lugre", coulomb=0.05, breakaway=0.07, stribeck_velocity=2e-3, stiffness=1e4, bristle_damping=10.0),
    "sticking": make("friction", "coulomb", coulomb=0.055, breakaway=0.066, stribeck_velocity=2e-3),
}
COUNT = 125e-9


@needs_node
@pytest.mark.slow
@pytest.mark.parametrize("friction", FRICTIONS)
@pytest.mark.parametrize("sensor", ["ideal", "encoder"])
def test_a_module_is_as_near_to_lanes_as_rounding_allows(friction: str, sensor: str) -> None:
    """Within 1 nm; where an encoder decides on a last digit, within one of its counts."""
    numbers = np.random.default_rng([len(friction), len(sensor)])
    seen = make("sensor", "encoder", resolution=COUNT, noise=5e-8) if sensor == "encoder" else make("sensor", "ideal")
    for seed in range(7):
        machine = stage(friction=FRICTIONS[friction], sensor=seen, substeps=2 if friction == "smooth" else 1)
        controller = control(coupled=bool(numbers.integers(2)))
        varied = [name for name in parameters_of(machine, controller) if "friction" not in name and "sensor" not in name]
        varied = [name for name in varied if not name.endswith(("delay", "limit")) and numbers.random() < 0.5]
        values = {name: float(getattr(*parameters_of(machine, controller)[name])) * numbers.uniform(0.85, 1.15) for name in varied}
        machine, controller = cl.with_values(machine, controller, values)
        shape = ("circle", "ellipse", "lemniscate", "butterfly")[numbers.integers(4)]
        loop = portable(machine, controller, cl.uniform(cl.contour(shape), 2.0, 1, machine.servo_period), seed=seed)
        log = native(loop)[1]
        _, found = in_node(loop, ("run", 0, len(log)), log_of(loop))
        positions = list(loop.signals["axis_position"])
        assert np.isfinite(log).all() and np.ptp(log[:, positions], axis=0).min() > 1e-3
        difference = np.abs(found.reshape(log.shape) - log)[:, positions].max()
        assert difference <= (COUNT if sensor == "encoder" else 1e-9), (seed, shape)


@needs_node
@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: f"{kind.family}/{kind.kind}")
def test_every_component(kind: type[Component]) -> None:
    machine, controller = loop_with(kind)
    reference = circle(machine)
    loop = portable(machine, controller, reference)
    assert_same_bits(loop)
    assert_prepared(machine, controller, reference, loop)
    # Structural for the module: a length of memory, a stream of noise, the rest of counted steps, a power of two, the profile of a gap.
    words = {"stream", "delay", "jitter", "bits", "pitch", "resolution", "pulse", "lead", "full_steps", "microsteps"}
    assert {name.rpartition(".")[2] for name in loop.fixed} <= words | {"profile_start", "profile_step"}
