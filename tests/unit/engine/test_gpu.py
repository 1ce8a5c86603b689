"""Variants on a GPU have the bits of variants in lanes."""

from __future__ import annotations

import ctypes
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from host_gpu import HostGpu
from stages import PERIOD, control, make, stage, with_axis

import contourlab as cl
from contourlab.app.quick import beginning
from contourlab.engine import gpu, runner
from contourlab.errors import EngineError
from contourlab.loop import parameters_of
from contourlab.scenario.load import load_scenario, scenario_from_parts

FRICTIONS = {
    "smooth": make("friction", "smooth-coulomb", coulomb=0.05, breakaway=0.07, stribeck_velocity=2e-3, smoothing_velocity=1e-4),
    "lugre": make("friction", "lugre", coulomb=0.05, breakaway=0.07, stribeck_velocity=2e-3, stiffness=1e4, bristle_damping=10.0),
    "sticking": make("friction", "coulomb", coulomb=0.055, breakaway=0.066, stribeck_velocity=2e-3),
}
SHIPPED = ("backlash/part", "emps/circle", "gecer-ulu/contour-simulated", "ghaffari/demo-stage", "ubc/lead-lag")
PART = """\
G17 G21 G90 G94 G64 P0.02
F3000
G1 X6
G1 X8 Y4 Z-1
G3 X4 Y8 Z-2 I-4
G5.2 X0 Y10 P2 L3
X-5 Y8 P1
X-6 Y4 P1
X-6 Y0 P1
G5.3
G18 G2 X-2 Z-2 I2 K0
G17 G0 X0 Y0 Z0
M2
"""
"""Lines and a rapid, blended; a helix, a NURBS curve, an arc in another plane."""
GAINS = {"axes.x.plant.gain": np.linspace(0.9, 1.3, 70), "controller.coupling.weight": np.linspace(0.0, 0.75, 70)}


def same(machine: cl.Machine, controller: cl.Controller, reference: cl.Reference, variants: dict[str, Any], **more: Any) -> cl.BatchResult:
    """Check that a GPU and lanes give the same bits; return the result."""
    lanes, there = (cl.simulate_batch(machine, controller, reference, variants, gpu=on, **more) for on in (False, True))
    assert np.array_equal(lanes.failed_at, there.failed_at) and np.array_equal(lanes.unsure, there.unsure)
    for of_lanes, of_gpu in ((lanes.figures, there.figures), (lanes.signals, there.signals)):
        assert of_lanes.keys() == of_gpu.keys()
        for name, values in of_lanes.items():
            assert np.array_equal(values, of_gpu[name], equal_nan=True), name
    return there


@pytest.fixture
def turn() -> cl.Reference:
    return cl.uniform(cl.contour("circle", radius=5e-3), 4.0, 1, PERIOD)


@pytest.mark.parametrize("friction", FRICTIONS)
def test_a_gpu_gives_the_bits_of_lanes(a_gpu: None, turn: cl.Reference, friction: str) -> None:
    machine = with_axis(stage(friction=FRICTIONS[friction]), "x", substeps=3)
    assert np.ptp(same(machine, control(), turn, GAINS, keep=("position", "command"), effort=True).figures["contour_error_max"]) > 0.0


def test_calls_and_groups_of_any_size_give_the_same_bits(a_gpu: None, turn: cl.Reference, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(gpu, "LANES", 64)
    monkeypatch.setattr(runner, "FIRST", 37)
    monkeypatch.setattr(runner, "CALL", 0.0)
    same(stage(), control(), turn, GAINS)
    monkeypatch.setattr(runner, "LOGGED", 2000)
    same(stage(), control(), turn, GAINS, keep=("axis_position",))


@pytest.mark.slow
def test_doubtful_samples_are_judged_alike(a_gpu: None) -> None:
    rosette = cl.uniform(cl.contour("butterfly"), 2.0, 1, PERIOD)
    same(stage(sensor=make("sensor", "ideal")), control(coupled=False), rosette, {"axes.x.plant.gain": np.linspace(0.9, 1.3, 40)})


@pytest.mark.parametrize(("following_error", "most"), [(1e-3, 6e3), (1e308, 1e9)])
def test_variants_that_diverge_do_so_at_the_same_sample(a_gpu: None, turn: cl.Reference, following_error: float, most: float) -> None:
    machine = stage(drive=make("drive", "saturation"), friction=make("friction", "none"), sensor=make("sensor", "ideal"))
    machine = with_axis(machine, "y", limits=cl.Limits(following_error=following_error))
    found = same(machine, control(coupled=False), turn, {"controller.axes.y.controller.velocity_gain": np.geomspace(100.0, most, 40)})
    assert 0 < np.count_nonzero(found.failed_at >= 0) < 40


@pytest.mark.slow
@pytest.mark.parametrize("name", SHIPPED)
def test_shipped_machines_give_the_same_bits(a_gpu: None, name: str) -> None:
    case = load_scenario(f"builtin:{name}", ()).base
    known = {text: getattr(part, key) for text, (part, key) in parameters_of(case.machine, case.controller).items()}
    varied = [text for text, value in known.items() if ".plant." in text and 0.0 < abs(value) < 1e12]
    factors = np.random.default_rng(1).normal(1.0, 0.01, (len(varied), 40))
    variants = {text: known[text] * factor for text, factor in zip(varied, factors, strict=True)}
    reference = case.reference()
    if isinstance(gpu.gpu_of_process(), HostGpu):  # which runs one thread after another
        reference = beginning(reference, 3000)
    same(case.machine, case.controller, reference, variants, part=True, seed=3, moving=case.moving)


@pytest.mark.slow
@pytest.mark.parametrize("play", [0.0, 5e-6])
def test_a_part_program_gives_the_same_bits(a_gpu: None, tmp_path: Path, play: float) -> None:
    (tmp_path / "part.ngc").write_text(PART)
    case = scenario_from_parts(tmp_path / "part.ngc", "xyz", "xyz-controller").base
    machine = with_axis(case.machine, "x", substeps=2, error=replace(case.machine.axis("x").error, backlash=play))
    mass = {"axes.x.plant.mass": case.machine.axis("x").plant.mass * np.linspace(0.9, 1.1, 40)}
    found = same(machine, case.controller, case.reference(), mass, part=True, seed=3)
    assert np.ptp(found.figures["part_error_max"]) > 0.0


def test_the_driver_may_not_round_otherwise(turn: cl.Reference, monkeypatch: pytest.MonkeyPatch) -> None:
    """A driver may join a product and a sum that do not say how they round; and nothing is called that a GPU has not."""
    seen: list[str] = []

    class Seen(HostGpu):
        code = "seen"
        compiled = gpu.Gpu.compiled  # type: ignore[assignment]

        def loaded(self, assembly: bytes) -> Any:
            seen.append(assembly.decode())
            raise EngineError("seen")

    monkeypatch.setattr(gpu, "Gpu", Seen)
    gpu.gpu_of_process.cache_clear()
    for friction in FRICTIONS.values():
        with pytest.raises(EngineError, match="seen"):
            cl.simulate_batch(stage(friction=friction), control(), turn, GAINS, gpu=True)
    gpu.gpu_of_process.cache_clear()
    for text in seen:
        assert len(re.findall(r"\bfma\.rn\.f64", text)) > 100
        assert not re.findall(r"\b(?:add|sub|mul|mad|fma|div|sqrt)(?:\.approx|\.full|\.ftz)*\.f64|\bcall\b|\.extern", text)


class Driver:
    """A driver whose functions return a code."""

    def __init__(self, **codes: int) -> None:
        self.codes = codes

    def __getattr__(self, name: str) -> Any:
        def function(*arguments: Any) -> int:
            return self.codes.get(name, 0)

        return function


@pytest.mark.parametrize(("codes", "said"), [({"cuInit": 100}, "cuInit"), ({"cuMemAlloc_v2": 2}, "memory")])
def test_what_fails_in_the_driver_is_said(codes: dict[str, int], said: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ctypes, "CDLL", lambda name: Driver(**codes))
    with pytest.raises(EngineError, match=said):
        gpu.Gpu().memory(10)


def test_without_a_driver_there_is_no_gpu(turn: cl.Reference, no_gpu: None) -> None:
    with pytest.raises(EngineError, match="driver"):
        cl.simulate_batch(stage(), control(), turn, GAINS, gpu=True)
