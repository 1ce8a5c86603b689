"""The loop of an axis as numbers, against python-control, scipy.signal and runs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, make
from refusals import refuses
from scipy import signal

import contourlab as cl
from contourlab.errors import ComponentError, ParameterError
from contourlab.geometry import Line, Path

control = pytest.importorskip("control")

PLANT = make("plant", "two-mass", mass=20.0, force_constant=50.0, resonance=40.0, damping=80.0)
LAW = make("controller", "pid", proportional_gain=60.0, integral_gain=60.0, derivative_gain=5.0)
OBSERVER = make("observer", "disturbance-observer", model_gain=2.5, model_damping=4.0, bandwidth=20.0)
DRIVE = make("drive", "delayed-saturation", limit=1e9, delay=2e-3)
MACHINE = cl.Machine("m", (cl.Axis("x", PLANT, drive=DRIVE, substeps=4),), PERIOD)
PARTS = {"plain": cl.AxisController(LAW), "observed": cl.AxisController(LAW, observer=OBSERVER)}
MOVE = cl.plan(cl.route_from_path(Path([Line((0.0,), (0.05,))]), 0.05), cl.AxisLimits(1.0, 5.0, 100.0), PERIOD)


def margins(name: str) -> Any:
    from contourlab.analysis.linear.sampled_loop import sampled_loop

    return sampled_loop(MACHINE.axes[0], PARTS[name], PERIOD).margins()


@pytest.mark.parametrize("name", PARTS)
def test_margins_and_poles_are_those_of_python_control(name: str) -> None:
    found = cl.linear(MACHINE, cl.Controller({"x": PARTS[name]}), "x")
    loop, closed = found.loop.to_control(), found.closed_loop.to_control()
    grid = np.geomspace(0.1, 0.999 * np.pi / PERIOD, 4000)
    gain, phase, *_ = control.stability_margins(control.frd(loop, grid, smooth=True))
    ours = margins(name)
    assert 20.0 * np.log10(gain) == pytest.approx(20.0 * np.log10(ours.gain), abs=1e-3)
    assert phase == pytest.approx(np.degrees(ours.phase), abs=1e-2)
    peak = np.abs(control.frequency_response(found.sensitivity.to_control(), np.linspace(1.0, 0.999 * np.pi / PERIOD, 20000)).frdata).max()
    assert 1.0 / peak == pytest.approx(ours.modulus, rel=1e-3)
    assert np.abs(control.poles(closed)).max() < 1.0
    around = control.poles(control.feedback(loop, 1))
    slow = lambda poles: np.sort_complex(np.round([pole for pole in poles if abs(pole) > 0.3], 7))  # noqa: E731
    assert slow(around) == pytest.approx(slow(control.poles(closed)), abs=1e-6)


@pytest.mark.parametrize("name", PARTS)
def test_the_closed_loop_is_a_run(name: str) -> None:
    controller = cl.Controller({"x": PARTS[name]})
    found = cl.linear(MACHINE, controller, "x").closed_loop
    block = MOVE.block(0, MOVE.n_sample)
    fed = np.column_stack([block.position[:, 0], block.velocity[:, 0], block.acceleration[:, 0], np.zeros(MOVE.n_sample)])
    run = cl.simulate(MACHINE, controller, MOVE)["axis_position"][:, 0]
    _, scipys, _ = signal.dlsim(found.to_scipy(), fed)
    controls = control.forced_response(found.to_control(), inputs=fed.T).outputs
    for other in (scipys[:, 0], controls[0]):
        assert np.abs(other - run).max() < 1e-10 * 0.05


def test_a_step_of_the_plant() -> None:
    free = cl.Machine("m", (cl.Axis("x", make("plant", "rigid-axis", gain=2.0, damping=5.0)),), PERIOD)
    plant = cl.linear(free, cl.Controller({"x": PARTS["plain"]}), "x").plant
    exact = signal.cont2discrete((np.array([[0, 1], [0, -5.0]]), np.array([[0, 0], [2.0, 2.0]]), np.eye(2), np.zeros((2, 2))), PERIOD)
    assert len(plant.a) == 2 and (plant.inputs, plant.outputs) == (("command", "load"), ("position", "velocity"))
    for mine, other in zip((plant.a, plant.b), exact[:2], strict=True):
        assert mine == pytest.approx(other, abs=1e-9)
    assert control.step_response(plant.to_control()[0, 0], timepts=np.arange(500) * PERIOD).outputs.ravel()[-1] == pytest.approx(
        0.4 * (0.499 - (1.0 - np.exp(-5.0 * 0.499)) / 5.0), rel=1e-6
    )


SYSTEMS = {
    "control ss": lambda: control.ss([[-3.0, 1.0], [0.0, -40.0]], [[0.0], [900.0]], [[1.0, 0.2]], [[2.0]]),
    "control tf": lambda: control.tf([2.0, 80.0], [1.0, 20.0, 300.0]),
    "scipy ss": lambda: signal.StateSpace([[-3.0, 1.0], [0.0, -40.0]], [[0.0], [900.0]], [[1.0, 0.2]], [[2.0]]),
    "scipy tf": lambda: signal.TransferFunction([2.0, 80.0], [1.0, 20.0, 300.0]),
    "scipy zpk": lambda: signal.ZerosPolesGain([-40.0], [-3.0, -400.0], 700.0),
    "control discrete": lambda: control.ss([[0.9, 0.1], [0.0, 0.7]], [[0.0], [1.0]], [[1.0, 0.2]], [[2.0]], PERIOD),
    "scipy discrete": lambda: signal.dlti([0.2, 0.1], [1.0, -0.7], dt=PERIOD),
}


@pytest.mark.parametrize("family", ["controller", "filter"])
@pytest.mark.parametrize("name", SYSTEMS)
def test_systems_become_components(name: str, family: str) -> None:
    system = SYSTEMS[name]()
    part: Any = cl.from_system(system, family)
    w = np.array([1.0, 30.0, 700.0])
    at = np.exp(1j * w * PERIOD) if "discrete" in name else 1j * w
    if hasattr(system, "freqresp") and not hasattr(system, "frequency_response"):
        wanted = system.freqresp(w * (PERIOD if "discrete" in name else 1.0))[1]
    else:
        wanted = np.array([complex(np.squeeze(system(one))) for one in at])
    a, b, c, d = part.system
    found = np.array([(c @ np.linalg.solve(one * np.eye(len(a)) - a, b) + d)[0, 0] for one in at])
    assert found == pytest.approx(wanted, rel=1e-9)


def test_a_regulator_of_python_control_runs() -> None:
    """The discrete LQR of the sampled plant stabilises the run; its poles are those that python-control gives."""
    plant = make("plant", "state-space", a=(0.0, 1.0, 0.0, -5.0), b=(0.0, 2.0), c=(1.0, 0.0))
    machine = cl.Machine("m", (cl.Axis("x", plant),), PERIOD)
    free = cl.linear(machine, cl.Controller({"x": PARTS["plain"]}), "x").plant
    gain, _, poles = control.dlqr(free.a, free.b[:, :1], np.diag([1e4, 1.0]), np.eye(1))
    k1, k2 = np.asarray(gain)[0] if free.c[0, 0] == 1.0 else np.asarray(gain)[0] @ np.linalg.inv(free.c)
    law = make("controller", "state-space", d=(k1, -k1, k2, -k2))
    loop = cl.linear(machine, cl.Controller({"x": cl.AxisController(law, velocity=make("velocity", "true"))}), "x").closed_loop
    live = [pole for pole in np.linalg.eigvals(loop.a) if abs(pole) > 0.1]
    assert np.sort(np.abs(live)) == pytest.approx(np.sort(np.abs(poles)), rel=1e-9)


def test_what_cannot_be_used_is_refused() -> None:
    controller = cl.Controller({"x": PARTS["plain"]})
    with refuses(ParameterError, name="axis"):
        cl.linear(MACHINE, controller, "z")
    with refuses(ParameterError, name="family"):
        cl.from_system(SYSTEMS["scipy tf"](), "sensor")
    with refuses(ParameterError, name="system"):
        cl.from_system(3.0)
    with refuses(ParameterError, name="system"):
        cl.from_system(control.ss(-1.0, 1.0, [[1.0], [1.0]], [[0.0], [0.0]]))
    with refuses(ParameterError, name="axis"):
        cl.linear(MACHINE, cl.Controller({}), "x")
    plant = cl.linear(MACHINE, controller, "x").plant.to_control()
    assert cl.from_system(plant[0, 0], "plant").kind == "state-space"
    for wrong in (plant[0, :], control.frd([1.0, 2.0], [1.0, 2.0])):
        with refuses(ParameterError, name="system"):
            cl.from_system(wrong, "plant")
    with refuses(ParameterError, name="period"):
        cl.from_system(control.tf([1.0], [1.0, 0.5], PERIOD), period=2 * PERIOD)
    with refuses(ParameterError, name="dt"):
        cl.from_system(control.ss(0.5, 1.0, 1.0, 0.0, True))
    with refuses(ParameterError, name="system"):
        cl.from_system(control.ss(-1.0, 1.0, 1.0, 1.0), "plant")
    stepper = cl.Machine("m", (cl.Axis("x", make("plant", "step-drive", natural_frequency=30.0), substeps=4),), PERIOD)
    with pytest.raises(ComponentError, match="no margins"):
        cl.linear(stepper, controller, "x")
