"""Plants, controllers and filters given by matrices or transfer functions, against scipy.signal."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, make, run_alone
from refusals import refuses
from scipy import signal

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.components.controller.lead_lag import LeadLag
from contourlab.components.friction.laws import Coulomb
from contourlab.components.plant.lagged_mass import SecondOrderIntegrator
from contourlab.components.plant.plant import resonance_of
from contourlab.errors import ComponentError, ParameterError
from contourlab.geometry import Line, Path
from contourlab.scenario import dump, parse_scenario

RNG = np.random.default_rng(5)
U = RNG.normal(size=400)
METHODS = {"tustin": "bilinear", "zero-order-hold": "zoh"}
MOVE = cl.plan(cl.route_from_path(Path([Line((0.02,), (0.07,))]), 0.05), cl.AxisLimits(1.0, 5.0, 100.0), PERIOD)
KINDS = [cl.component(family, kind) for family in ("plant", "controller", "filter") for kind in ("state-space", "transfer-function")]


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: f"{kind.family}/{kind.kind}")
def test_the_contract(kind: Any) -> None:
    checks = cl.check_component(kind)
    assert "linear model agrees with the step" in checks and "compiled form and lanes agree with plain Python" in checks


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("jit", [False, True])
@pytest.mark.parametrize("order", [1, 2, 5, 12])
def test_a_filter_is_that_of_scipy(order: int, method: str, jit: bool) -> None:
    z, p, k = signal.bessel(order, 2.0 * np.pi * 60.0, analog=True, output="zpk", norm="phase")
    b, a = signal.zpk2tf(z, p, k)
    a2, b2, c2, d2 = signal.zpk2ss(z, p, k)
    # An exact discretisation by modes, which shares nothing with matrices.
    zd, pd, kd = signal.bilinear_zpk(z, p, k, 1.0 / PERIOD)
    for part in (
        make("filter", "transfer-function", numerator=b, denominator=a, method=method),
        cl.component("filter", "state-space")(a=a2, b=b2, c=c2, d=d2.ravel(), method=method),
    ):
        assert part.rest_gain == pytest.approx(1.0, abs=1e-9)
        found = run_alone(part, {"command": U}, jit=jit)["command"]
        wanted = signal.sosfilt(signal.zpk2sos(zd, pd, kd), U) if method == "tustin" else modal(p, k, U)
        assert np.abs(found - wanted).max() < 1e-9 * np.abs(wanted).max()


def modal(poles: Any, gain: float, u: Any) -> Any:
    """Return the response of gain over a product of poles to a held input, mode by mode."""
    residues = [gain / np.prod(pole - np.delete(poles, i)) for i, pole in enumerate(poles)]
    total = np.zeros(u.size)
    for residue, pole in zip(residues, poles, strict=True):
        keep = np.exp(pole * PERIOD)
        x, found = 0.0, []
        for value in u:
            found.append((residue * x).real)
            x = keep * x + (keep - 1.0) / pole * value
        total += np.array(found)
    return total


def test_a_discrete_filter_is_as_given() -> None:
    b, a = signal.butter(3, 0.2)
    part = make("filter", "transfer-function", numerator=b, denominator=a, period=PERIOD)
    assert run_alone(part, {"command": U})["command"] == pytest.approx(signal.lfilter(b, a, U), abs=1e-12)
    with refuses(ParameterError, name="transfer-function.period"):
        part.derive(None, 2.0 * PERIOD)


PLANT = {"numerator": (3.0, 4e3), "denominator": (1.0, 35.0, 9e3, 5e4, 0.0)}


def exact(system: Any, u: Any) -> Any:
    discrete = signal.cont2discrete(system, PERIOD)[:2]
    x, found = np.zeros(len(discrete[0])), []
    for value in u:
        x = discrete[0] @ x + discrete[1][:, 0] * value
        found.append(x)
    return np.array(found)


@pytest.mark.parametrize("jit", [False, True])
@pytest.mark.parametrize("substeps", [1, 4])
def test_a_plant_moves_exactly(jit: bool, substeps: int) -> None:
    system = signal.tf2ss(*PLANT.values())
    states = exact(system, U)
    position = (states @ system[2].T)[:, 0]
    velocity = (states @ (system[2] @ system[0]).T)[:, 0]
    for part in (
        make("plant", "transfer-function", **PLANT),
        cl.component("plant", "state-space")(**dict(zip("abc", system[:3], strict=True))),
    ):
        found = run_alone(part, {"command": U}, jit=jit, substeps=substeps)
        assert np.abs(found["position"] - position).max() < 1e-9 * np.abs(position).max()
        assert np.abs(found["velocity"] - velocity).max() < 1e-9 * np.abs(velocity).max()
        assert found["acceleration"] == pytest.approx(np.diff(found["velocity"], prepend=0.0) / PERIOD * substeps, abs=1.0) or substeps > 1


def test_a_discrete_plant_is_the_continuous_one() -> None:
    a, b, c, *_ = signal.cont2discrete(signal.tf2ss(*PLANT.values()), PERIOD)
    part = cl.component("plant", "state-space")(a=a, b=b, c=c, period=PERIOD)
    found, wanted = (run_alone(one, {"command": U}) for one in (part, make("plant", "transfer-function", **PLANT)))
    assert np.abs(found["position"] - wanted["position"]).max() < 1e-9 * np.abs(wanted["position"]).max()
    assert found["velocity"] == pytest.approx(np.diff(found["position"], prepend=0.0) / PERIOD)
    assert found["acceleration"] == pytest.approx(np.diff(found["velocity"], prepend=0.0) / PERIOD)
    axis = cl.Axis("x", part)
    for at in (0.02, -3.0):
        assert run_from(part, at) == pytest.approx(np.full(5, at), rel=1e-12)
    margins = [
        sampled_loop(one, cl.AxisController(make("controller", "pid", proportional_gain=20.0)), PERIOD).margins()
        for one in (axis, cl.Axis("x", make("plant", "transfer-function", **PLANT)))
    ]
    assert margins[0].gain == pytest.approx(margins[1].gain, rel=1e-6)
    with refuses(ParameterError, name="state-space.period"):
        cl.simulate(cl.Machine("m", (cl.Axis("x", part, substeps=2),), PERIOD), LOOP, MOVE)
    with pytest.raises(ComponentError, match="no linear model"):
        part.rigid_model()


def run_from(part: Any, position: float) -> Any:
    return run_alone(part, {"command": np.zeros(5)}, initial=part.at_rest(position)[0])["position"]


LAW = {"gain": 30.0, "lead_time": 0.02, "lag_time": 0.002, "integral_rate": 5.0}
AS_POLYNOMIALS = {"numerator": np.polymul([30.0 * 0.02, 30.0], [1.0, 5.0]), "denominator": [0.002, 1.0, 0.0]}
LOOP = cl.Controller({"x": cl.AxisController(make("controller", "transfer-function", **AS_POLYNOMIALS))})


def test_a_loop_of_polynomials_is_that_of_kinds() -> None:
    kinds = cl.Machine("m", (cl.Axis("x", SecondOrderIntegrator(dc_gain=0.05, damping_ratio=1.1, natural_frequency=150.0)),), PERIOD)
    w = 150.0
    plant = make("plant", "transfer-function", numerator=(0.05 * w * w,), denominator=(1.0, 2.2 * w, w * w, 0.0))
    rational = cl.Machine("m", (cl.Axis("x", plant),), PERIOD)
    controller = cl.Controller({"x": cl.AxisController(LeadLag(**LAW, anti_windup="none"))})
    runs = [cl.simulate(*case, MOVE, jit=jit) for case in ((kinds, controller), (rational, LOOP)) for jit in (False, True)]
    for run in runs[1:]:
        assert np.abs(run["position"] - runs[0]["position"]).max() < 1e-12
    batch = cl.simulate_batch(rational, LOOP, MOVE, {"axes.x.drive.limit": np.array([100.0, 200.0, 300.0])}, keep=("position",))
    for lane in np.moveaxis(batch.signals["position"], 2, 0):
        assert np.abs(lane - runs[0]["position"]).max() < 1e-12
    loops = [sampled_loop(m.axes[0], c.axes["x"], PERIOD) for m, c in ((kinds, controller), (rational, LOOP))]
    assert loops[0].margins().phase == pytest.approx(loops[1].margins().phase, rel=1e-9)


def test_a_static_gain_and_an_observer() -> None:
    """State feedback with the true velocity, and with a Luenberger observer of it, which starts at rest at the path's start."""
    gains = [40.0, -40.0, 1.5, -1.5]
    static = make("controller", "state-space", d=gains)
    assert static.states == () and run_alone(static, {"reference": U, "velocity": U})["command"] == pytest.approx(38.5 * U)
    a, b, c = np.array([[0.0, 1.0], [0.0, -5.0]]), np.array([[0.0], [2.0]]), np.array([[1.0, 0.0]])
    k, low = np.array([[40.0, 4.0]]), np.array([[200.0], [1e4]])
    observer = cl.component("controller", "state-space")(a=a - b @ k - low @ c, b=np.hstack([b * 40.0, low]), c=-k, d=(40.0, 0.0))
    known = make("controller", "state-space", d=(40.0, -40.0, 0.0, -4.0))
    axis = cl.Axis("x", cl.component("plant", "state-space")(a=a, b=b, c=c))
    parts = [cl.AxisController(law, velocity=make("velocity", "true")) for law in (known, observer)]
    runs = [cl.simulate(cl.Machine("m", (axis,), PERIOD), cl.Controller({"x": part}), MOVE)["position"] for part in parts]
    assert np.abs(runs[1][:3] - 0.02).max() < 1e-6
    assert np.abs(runs[1] - runs[0]).max() < 2e-3 * np.ptp(runs[0])


def test_friction_acts_where_a_load_pushes() -> None:
    pushed = make("plant", "state-space", a=(0.0, 1.0, 0.0, -5.0), b=(0.0, 2.0), c=(1.0, 0.0), load_input=(0.0, 0.1))
    assert pushed.mobilities() == (0.1,) and pushed.force_unit == "N" and resonance_of(pushed) is None
    assert pushed.rigid_model() == (pytest.approx(2.0), pytest.approx(5.0)) and pushed.force_per_command == pytest.approx(20.0)
    held = run_alone(pushed, {"command": np.full(50, 0.4)}, friction=Coulomb(coulomb=10.0))
    assert np.abs(held["position"]).max() < 1e-15
    rigid = run_alone(make("plant", "rigid-axis", gain=2.0, damping=5.0), {"command": np.full(300, 0.9)}, friction=Coulomb(coulomb=0.5))
    same = run_alone(pushed, {"command": np.full(300, 0.9)}, friction=Coulomb(coulomb=10.0))
    assert same["position"] == pytest.approx(rigid["position"], rel=2e-3, abs=1e-6)
    with refuses(ParameterError, name="axes.x.friction"):
        cl.Machine("m", (cl.Axis("x", make("plant", "transfer-function", **PLANT), friction=Coulomb(coulomb=1.0)),), PERIOD)


BAD = [
    (("filter", "state-space"), {"a": (1.0, 2.0), "b": (1.0,), "c": (1.0,)}, "a"),
    (("filter", "state-space"), {"a": (-1.0,), "b": (1.0, 2.0), "c": (1.0,)}, "b"),
    (("filter", "state-space"), {"a": (-1.0,), "b": (1.0,), "c": (1.0, 1.0)}, "c"),
    (("filter", "state-space"), {"a": (1.0,), "b": (1.0,), "c": (1.0,)}, "a"),
    (("filter", "state-space"), {"a": (-1.0, 0.0, 0.0, -2.0), "b": (1.0, 0.0), "c": (1.0, 1.0)}, "a"),
    (("filter", "state-space"), {"a": (-1.0, 0.0, 0.0, -2.0), "b": (1.0, 1.0), "c": (1.0, 0.0)}, "a"),
    (("filter", "transfer-function"), {"numerator": (1.0, 0.0, 1.0), "denominator": (1.0, 1.0)}, "numerator"),
    (("filter", "transfer-function"), {"numerator": (1.0,), "denominator": (0.0, 0.0)}, "denominator"),
    (("filter", "transfer-function"), {"numerator": (0.0,), "denominator": (1.0, 1.0)}, "numerator"),
    (("filter", "transfer-function"), {"numerator": (1.0, 3.0), "denominator": np.poly([-3.0, -5.0, -60.0])}, "denominator"),
    (("filter", "transfer-function"), {"numerator": (1.0,), "denominator": np.poly(-np.arange(1.0, 14.0))}, "denominator"),
    (("filter", "transfer-function"), {"numerator": (1.0,), "denominator": (1.0, 0.0)}, "denominator"),
    (("controller", "transfer-function"), {"numerator": (1.0,), "denominator": (1.0, -3.0)}, "denominator"),
    (("controller", "state-space"), {"d": (1.0, 2.0, 3.0)}, "d"),
    (("plant", "transfer-function"), {"numerator": (1.0, 0.0), "denominator": (1.0, 2.0)}, "d"),
    (("plant", "state-space"), {"a": (0.0,), "b": (1.0,), "c": (1.0,), "load_input": (1.0, 2.0)}, "load_input"),
]


@pytest.mark.parametrize(("which", "values", "name"), BAD)
def test_what_does_not_fit_is_refused(which: Any, values: Any, name: str) -> None:
    with refuses(ParameterError, name=f"{which[1]}.{name}"):
        make(*which, **values)


def test_a_plant_without_an_integrator_rests_at_zero() -> None:
    spring = make("plant", "transfer-function", numerator=(1.0,), denominator=(1.0, 2.0, 1.0))
    assert spring.at_rest(0.0)[1] == {"position": 0.0}
    with refuses(ParameterError, name="transfer-function"):
        spring.at_rest(0.1)


MACHINE = """
[machine]
name = "linear parts"
servo_period = "1 ms"
axes = ["x", "y"]
[axes.x]
plant = {kind = "state-space", a = [0, 1, 0, -5], b = [0, 2], c = [1, 0]}
[axes.y]
plant = {kind = "transfer-function", numerator = [2], denominator = [1, 5, 0]}
"""
CONTROLLER = """
[controller.axes.x]
controller = {kind = "state-space", d = [40, -40, 1.5, -1.5]}
[controller.axes.x.filters]
smooth = {kind = "state-space", a = [-800], b = [800], c = [1]}
[controller.axes.y]
controller = {kind = "transfer-function", numerator = [1.5, 40], denominator = [1e-3, 1]}
[controller.axes.y.filters]
smooth = {kind = "transfer-function", numerator = [1], denominator = [1e-5, 4e-3, 1]}
"""


def test_they_survive_a_file_and_run_in_a_module(tmp_path: Any) -> None:
    (tmp_path / "machine.toml").write_text(MACHINE, "utf-8")
    (tmp_path / "controller.toml").write_text(CONTROLLER, "utf-8")
    scenario = parse_scenario(
        'name = "s"\nmachine = "machine.toml"\ncontroller = "controller.toml"\n[contour]\nname = "circle"\nradius = "20 mm"\n'
        '[feed]\nlaw = "uniform"\nfrequency = "0.5 Hz"\nlaps = 2\n',
        str(tmp_path / "case.toml"),
    )
    assert [axis.plant.kind for axis in scenario.machine.axes] == ["state-space", "transfer-function"]
    again = parse_scenario(dump(scenario), str(tmp_path / "again.toml"))
    assert (again.machine.axes, again.controller) == (scenario.machine.axes, scenario.controller)
    (case,) = scenario.cases()
    run = cl.simulate(case.machine, case.controller, case.reference())
    assert np.ptp(run["position"]) > 0.01
    assert cl.translate(case, "wasm")[:4] == b"\0asm"
    assert "double" in cl.translate(case.controller.axes["y"].controller)


def test_a_matrix_in_rows_is_one_in_a_list() -> None:
    kind = cl.component("plant", "state-space")
    part = kind(a=(0, 1, 0, -5), b=(0, 2), c=(1, 0))
    again = pickle.loads(pickle.dumps(part))
    assert again == part and again.derive(None, PERIOD) == part.derive(None, PERIOD)
    assert kind(a=[[0, 1], [0, -5]], b=[[0], [2]], c=[[1, 0]]) == kind(a=(0, 1, 0, -5), b=(0, 2), c=(1, 0))


def test_a_filter_of_positions_keeps_them() -> None:
    stepper = make("plant", "step-drive", natural_frequency=30.0)
    machine = cl.Machine("m", (cl.Axis("x", stepper, substeps=4),), PERIOD)
    for gain in (1.0, 0.9):
        part = make("filter", "transfer-function", numerator=(gain,), denominator=(2e-5, 4e-3, 1.0))
        parts = cl.AxisController(make("controller", "steps"), filters=(("smooth", part),))
        if gain == 1.0:
            run = cl.simulate(machine, cl.Controller({"x": parts}), MOVE)
            assert run["position"][:5] == pytest.approx(np.full((5, 1), 0.02), abs=1e-9)
        else:
            with refuses(ParameterError, name="controller.axes.x.filters.smooth"):
                cl.simulate(machine, cl.Controller({"x": parts}), MOVE)
