"""The engine on small schedules: order, feedback, rates, rings, lanes, noise, cache."""

from __future__ import annotations

import math

import numpy as np
import pytest

from contourlab import primitives
from contourlab.engine import fused
from contourlab.engine.runner import make_group
from contourlab.engine.step import Bank, Late, Node, Port, Schedule, Step
from contourlab.errors import EngineError
from contourlab.native import store
from contourlab.primitives import (
    Clock,
    add,
    delayed,
    dot,
    exp,
    lincomb,
    log,
    lookup,
    normal,
    scale,
    sin,
    sub,
    tanh,
    uniform,
)
from contourlab.primitives import cos as cosine

FORMS = [(False, 1), (True, 1), (True, 32)]


def gain_step(par, x, inp, clock):
    return (), (par.factor * inp.u,)


GAIN = Step("gain", gain_step, ("factor",), inputs=(Port("u"),), outputs=(Port("y"),))


def integrate_step(par, x, inp, clock):
    total = x.total + clock.dt * inp.u
    return (total,), (total,)


INTEGRATE = Step("integrate", integrate_step, states=(Port("total"),), inputs=(Port("u"),), outputs=(Port("y"),))


def run(schedule, fed, signals, jit, width=1, lanes=None):
    group = make_group(schedule, width, lanes or slice(0, width), jit)
    return group.run(np.asarray(fed, dtype=float), [schedule.row(s) for s in signals])


@pytest.mark.parametrize(("jit", "width"), FORMS)
def test_feedback_is_one_tick_late(jit, width):
    """y = u - (y of the previous tick): 1, 0, 1, 0 ... for a constant input of 1."""

    def subtract(par, x, inp, clock):
        return (), (inp.u - inp.back,)

    step = Step("subtract", subtract, inputs=(Port("u"), Port("back")), outputs=(Port("y"),))
    nodes = (
        Node("difference", step, {"u": "in.u", "back": Late("hold.y")}),
        Node("hold", GAIN, {"u": "difference.y"}, {"factor": 1.0}),
    )
    log = run(Schedule(nodes, (Port("u"),), 1e-3, 2), np.ones((5, 1)), ["difference.y"], jit, width)
    assert np.array_equal(log[:, 0, 0], [1, 0, 1, 0, 1])


@pytest.mark.parametrize(("jit", "width"), FORMS)
def test_recording_sees_the_state_before_the_move(jit, width):
    nodes = (
        Node("drive", GAIN, {"u": "in.u"}, {"factor": 2.0}),
        Node("plant", INTEGRATE, {"u": "drive.y"}, initial={"total": 5.0}, start={"y": 5.0}),
    )
    log = run(Schedule(nodes, (Port("u"),), 0.5, 1), np.ones((3, 1)), ["drive.y", "plant.y"], jit, width)
    assert np.array_equal(log[:, 1, 0], [5.0, 6.0, 7.0])


@pytest.mark.parametrize(("jit", "width"), FORMS)
def test_substeps(jit, width):
    def stamp(par, x, inp, clock):
        return (x.runs + 1.0,), (clock.k, clock.t, clock.dt, x.runs + 1.0)

    step = Step("stamp", stamp, states=(Port("runs"),), outputs=(Port("k"), Port("t"), Port("dt"), Port("runs")))
    names = ["fine.k", "fine.t", "fine.dt", "fine.runs"]
    log = run(Schedule((Node("fine", step, repeat=4),), (Port("u"),), 0.1, 1), np.zeros((6, 1)), names, jit, width)[:, :, 0]
    assert np.array_equal(log[:, 0], range(6))
    assert log[2, 1] == pytest.approx(0.2 + 3 * 0.025)
    assert log[2, 2] == pytest.approx(0.025)
    assert log[5, 3] == 24


@pytest.mark.parametrize(("jit", "width"), FORMS)
def test_ring_delays_by_whole_ticks(jit, width):
    def late(par, x, inp, clock):
        return (), (delayed(par.ring, clock, par.n),)

    step = Step("late", late, ("n",), ring="u", inputs=(Port("u"),), outputs=(Port("y"),))
    schedule = Schedule((Node("late", step, {"u": "in.u"}, {"n": 5.0}, ring_length=6),), (Port("u"),), 1.0, 1)
    fed = np.arange(1.0, 21.0)[:, None]
    log = run(schedule, fed, ["late.y"], jit, width)[:, 0, 0]
    assert np.array_equal(log, np.concatenate([np.zeros(5), fed[:-5, 0]]))


def test_lanes_differ_in_ring_delay():
    def late(par, x, inp, clock):
        return (), (delayed(par.ring, clock, par.n),)

    step = Step("late", late, ("n",), ring="u", inputs=(Port("u"),), outputs=(Port("y"),))
    delays = np.arange(32.0)
    schedule = Schedule((Node("late", step, {"u": "in.u"}, {"n": delays}, ring_length=32),), (Port("u"),), 1.0, 1)
    log = run(schedule, np.arange(1.0, 41.0)[:, None], ["late.y"], True, 32)[:, 0]
    for lane in range(32):
        assert np.array_equal(log[:, lane], np.maximum(np.arange(1.0, 41.0) - lane, 0.0))


@pytest.mark.parametrize("width", [1, 16])
def test_one_loop_serves_rings_of_any_length(width):
    def late(par, x, inp, clock):
        return (), (lookup(par.table, 1.0) * delayed(par.ring, clock, par.n),)

    step = Step("late", late, ("n",), tables=("table",), ring="u", inputs=(Port("u"),), outputs=(Port("y"),))
    fed, loops = np.arange(1.0, 301.0)[:, None], set()
    for first, second in ((0, 1), (6, 33), (200, 2), (0, 0)):
        nodes = (
            Node("a", step, {"u": "in.u"}, {"n": float(first)}, {"table": np.array([0.0, 2.0])}, ring_length=first + 1),
            Node("b", step, {"u": "a.y"}, {"n": float(second)}, {"table": np.array([0.0, 3.0])}, ring_length=second + 1),
        )
        schedule = Schedule(nodes, (Port("u"),), 1.0, 2)
        group = make_group(schedule, width, slice(0, width), jit=True)
        log = group.run(fed, [schedule.row("b.y")])
        assert np.array_equal(log[:, 0, 0], 6.0 * np.maximum(fed[:, 0] - first - second, 0.0))
        assert np.array_equal(log[:, 0], np.repeat(log[:, 0, :1], width, axis=1))
        loops |= set(map(id, group.loops.values()))
    assert len(loops) == 1


@pytest.mark.parametrize(("jit", "width"), FORMS)
def test_vectors_and_tables(jit, width):
    def mix(par, x, inp, clock):
        v = lincomb(2.0, inp.a, -1.0, sub(inp.b, inp.a))
        return (), (add(v, scale(3.0, inp.b)), dot(inp.a, inp.b) + lookup(par.table, inp.i))

    step = Step("mix", mix, tables=("table",), inputs=(Port("a", 3), Port("b", 3), Port("i")), outputs=(Port("v", 3), Port("d")))
    wires = {"a": "in.a", "b": ("in.b[0]", "in.b[1]", 7.0), "i": 2.0}
    node = Node("mix", step, wires, tables={"table": np.array([10.0, 20.0, 30.0])})
    a, b = np.array([1.0, 2.0, 3.0]), np.array([4.0, 5.0, 7.0])
    log = run(
        Schedule((node,), (Port("a", 3), Port("b", 2)), 1.0, 1),
        [[1, 2, 3, 4, 5]],
        ["mix.v[0]", "mix.v[1]", "mix.v[2]", "mix.d"],
        jit,
        width,
    )
    assert np.array_equal(log[0, :3, 0], 2 * a - (b - a) + 3 * b)
    assert log[0, 3, 0] == a @ b + 30.0


def members(constant):
    """Return a step of four members, each summing its own multiple of the input; the last output of a member is their count."""

    def member(par, x, kept, found, index, inp, clock):
        total = kept[0] + constant * index * inp.u
        return (total, x.ticks), (found[0] + par.factor * total, found[1] + 1.0)

    def judge(par, x, inp, clock, found):
        return (x.ticks + 1.0,), (found[0], found[1])

    bank = Bank(member, 4, 2, 2)
    ports = {"states": (Port("ticks"), bank.port), "inputs": (Port("u"),), "outputs": (Port("y"), Port("count"))}
    return Step("members", judge, ("factor",), **ports, bank=bank)


@pytest.mark.parametrize(("jit", "width"), FORMS)
def test_equal_members_run_one_after_the_other(jit, width):
    """Member i sums i u, together 6 u times the lane's factor; each keeps its own state and sees the step's old states."""
    factors = np.linspace(1.0, 2.0, width)
    schedule = Schedule((Node("m", members(1.0), {"u": "in.u"}, {"factor": factors}),), (Port("u"),), 1.0, 1)
    group = make_group(schedule, width, slice(0, width), jit)
    log = group.run(np.array([[1.0], [2.0], [-5.0]]), [schedule.row("m.y"), schedule.row("m.count")])
    assert log[:, 0] == pytest.approx(6.0 * np.outer([1.0, 3.0, -2.0], factors))
    assert np.all(log[:, 1] == 4.0)
    assert group.state[0][:, -1].tolist() == [3.0, 0.0, 2.0, -2.0, 2.0, -4.0, 2.0, -6.0, 2.0]


def test_a_lane_does_not_depend_on_its_neighbours():
    factors = np.linspace(0.5, 2.0, 32)
    alone = run(
        Schedule((Node("g", GAIN, {"u": "in.u"}, {"factor": np.full(32, factors[7])}),), (Port("u"),), 1.0, 1),
        [[3.7]],
        ["g.y"],
        True,
        32,
    )
    mixed = run(
        Schedule((Node("g", GAIN, {"u": "in.u"}, {"factor": factors}),), (Port("u"),), 1.0, 1),
        [[3.7]],
        ["g.y"],
        True,
        32,
    )
    assert alone[0, 0, 7] == mixed[0, 0, 7]


@pytest.mark.parametrize("width", [1, 32])
def test_primitives_agree_with_plain_python(width):
    def fixed(par, x, inp, clock):
        from_u = inp.u
        return (), (
            exp(from_u),
            tanh(from_u),
            sin(from_u),
            cosine(from_u),
            log(fabs(from_u) + 1e-3),
            rint(from_u),
            floor(from_u),
            copysign(2.0, from_u),
        )

    fabs, rint, floor, copysign = primitives.fabs, primitives.rint, primitives.floor, primitives.copysign
    step = Step("fixed", fixed, inputs=(Port("u"),), outputs=tuple(Port(f"y{i}") for i in range(8)))
    schedule = Schedule((Node("f", step, {"u": "in.u"}),), (Port("u"),), 1.0, 1)
    u = np.concatenate([np.linspace(-30, 30, 4001), [-1e4, -700.5, -699.5, 500.0, 0.0, -0.0, 1e-300, 12345.678]])[:, None]
    names = [f"f.y{i}" for i in range(8)]
    plain, fast = run(schedule, u, names, False), run(schedule, u, names, True, width)[:, :, :1]
    assert np.allclose(fast, plain, rtol=4e-15, atol=4e-15)


@pytest.mark.parametrize("width", [1, 32])
def test_noise_is_normal_and_the_same_in_all_forms(width):
    def draw(par, x, inp, clock):
        return (), (normal(par.stream, clock.k), uniform(par.stream, clock.k, 3.0))

    step = Step("noise", draw, ("stream",), outputs=(Port("n"), Port("u")))
    schedule = Schedule((Node("noise", step, {}, {"stream": 123456789.0}),), (Port("u"),), 1.0, 1)
    fed = np.zeros((4000, 1))
    plain = run(schedule, fed, ["noise.n", "noise.u"], False)[:, :, 0]
    fast = run(schedule, fed, ["noise.n", "noise.u"], True, width)[:, :, 0]
    assert np.array_equal(plain[:, 1], fast[:, 1])
    assert np.allclose(plain[:, 0], fast[:, 0], atol=1e-12)
    assert abs(plain[:, 0].mean()) < 4.0 / math.sqrt(4000)
    assert abs(plain[:, 0].std() - 1.0) < 0.05
    assert abs(np.corrcoef(plain[1:, 0], plain[:-1, 0])[0, 1]) < 0.06
    assert abs(plain[:, 1].mean() - 0.5) < 0.02


def test_exp_makes_no_denormals():
    assert exp(-701.0) == 0.0
    assert exp(-699.0) > 0.0


@pytest.mark.parametrize("place", ["before", "after"])
def test_a_planted_nan_is_found(place):
    """Fast arithmetic must not optimise the check away."""

    def poison(par, x, inp, clock):
        return (x.bad,), (inp.u + x.bad,)

    step = Step("poison", poison, states=(Port("bad"),), inputs=(Port("u"),), outputs=(Port("y"),))
    first = Node("first", step, {"u": "in.u"}, initial={"bad": math.nan if place == "before" else 0.0})
    second = Node("second", step, {"u": "first.y"}, initial={"bad": math.nan if place == "after" else 0.0})
    group = make_group(Schedule((first, second), (Port("u"),), 1.0, 2), 32, slice(0, 32), True)
    group.run(np.zeros((1, 1)), [])
    assert not group.finite().any()
    assert group.first_bad_node() == ("first" if place == "before" else "second")


def test_a_nan_in_one_lane_stays_there():
    bad = np.zeros(32)
    bad[5] = math.inf
    group = make_group(Schedule((Node("g", GAIN, {"u": "in.u"}, {"factor": bad}),), (Port("u"),), 1.0, 1), 32, slice(0, 32), True)
    group.run(np.zeros((1, 1)), [])
    assert not group.finite()[5]
    assert group.finite().sum() == 31


def test_wiring_errors_say_what_is_wrong():
    with pytest.raises(EngineError, match=r"node a .*b\.y.*Late"):
        Schedule(
            (Node("a", GAIN, {"u": "b.y"}, {"factor": 1.0}), Node("b", GAIN, {"u": "in.u"}, {"factor": 1.0})),
            (Port("u"),),
            1.0,
            2,
        )
    with pytest.raises(EngineError, match=r"'in\.w'"):
        Schedule((Node("a", GAIN, {"u": "in.w"}, {"factor": 1.0}),), (Port("u"),), 1.0, 1)
    with pytest.raises(EngineError, match=r"own .*a\.y"):
        Schedule((Node("a", GAIN, {"u": Late("a.y")}, {"factor": 1.0}),), (Port("u"),), 1.0, 1)
    with pytest.raises(EngineError, match="factor"):
        Node("a", GAIN, {"u": "in.u"}, {})
    with pytest.raises(EngineError, match=r"\['a'\]"):
        node = Node("a", GAIN, {"u": "in.u"}, {"factor": 1.0})
        Schedule((node, node), (Port("u"),), 1.0, 1)


def test_the_cache_key_follows_the_source_of_callees(tmp_path, monkeypatch):
    def made(constant):
        def helper(u):
            return constant * u

        def step(par, x, inp, clock):
            return (), (helper(inp.u),)

        return Step("s", step, inputs=(Port("u"),), outputs=(Port("y"),))

    def answer(step):
        schedule = Schedule((Node("s", step, {"u": "in.u"}, dict.fromkeys(step.parameters, 1.0)),), (Port("u"),), 1.0, 1)
        return run(schedule, [[1.0]], ["s.y"], True)[0, 0, 0]

    monkeypatch.setattr(store, "folder", lambda: tmp_path)
    monkeypatch.setattr(fused, "_loops", {})
    assert [answer(made(constant)) for constant in (2.0, 3.0, 2.0)] == [2.0, 3.0, 2.0]
    assert [answer(members(constant)) for constant in (2.0, 3.0, 2.0)] == [12.0, 18.0, 12.0]
    assert len(list(tmp_path.glob("*.code"))) == 4


def test_the_cache_survives_corrupt_files_and_serves_a_second_process(tmp_path, monkeypatch):
    monkeypatch.setattr(store, "folder", lambda: tmp_path)
    schedule = Schedule((Node("g", GAIN, {"u": "in.u"}, {"factor": 2.0}),), (Port("u"),), 1.0, 1)
    for fed in (21.0, 4.0, 5.0):  # compiled, compiled again, loaded
        monkeypatch.setattr(fused, "_loops", {})
        assert run(schedule, [[fed]], ["g.y"], True)[0, 0, 0] == 2.0 * fed
        (file,) = tmp_path.glob("*.code")
        assert file.stat().st_size > 100
        if fed == 21.0:
            file.write_bytes(b"rubbish")
    assert not list(tmp_path.glob("tmp*"))


def test_time_is_the_index_times_the_period():
    def stamp(par, x, inp, clock):
        return (), (clock.t,)

    step = Step("stamp", stamp, outputs=(Port("t"),))
    group = make_group(Schedule((Node("s", step),), (Port("u"),), 1e-3, 1), 1, slice(0, 1), True)
    group.run(np.zeros((100_000, 1)), [])
    log = group.run(np.zeros((1, 1)), [group.schedule.row("s.t")])
    assert log[0, 0, 0] == 100_000 * 1e-3
    assert Clock(1.0, 2.0, 3.0).dt == 3.0


def growing_step(par, x, inp, clock):
    values = [1.0, 2.0]
    values.append(inp.u)
    return (), (values[2],)


def undefined_step(par, x, inp, clock):
    return (), (inp.missing,)


def global_step(par, x, inp, clock):
    global LAST
    LAST = inp.u
    return (), (LAST,)


def foreign_step(par, x, inp, clock):
    return (), (ANYTHING,)


ANYTHING = object()


@pytest.mark.parametrize("function", [growing_step, undefined_step, global_step, foreign_step])
def test_a_step_that_cannot_be_compiled_is_reported_in_one_line(function):
    step = Step("odd", function, inputs=(Port("u"),), outputs=(Port("y"),))
    schedule = Schedule((Node("odd", step, {"u": "in.u"}),), (Port("u"),), 1.0, 1)
    with pytest.raises(EngineError, match=r"test_engine\.py:\d+: .+$") as caught:
        run(schedule, [[1.0]], ["odd.y"], True)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_primitives_never_raise(value):
    """Non-finite values pass through plain Python as through compiled code; the check of the loop finds them."""
    for function in (primitives.floor, primitives.rint):
        assert function(value) == value or math.isnan(value)
    assert math.isnan(primitives.clip(math.nan, -1.0, 2.0))
