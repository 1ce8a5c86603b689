"""Synthetic logs of axes with known parameters, and the results of ``contourlab identify``."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from contourlab.analysis.identification.first_order import first_order_motion
from contourlab.cli.main import main

PERIOD = 1e-3
TIME = PERIOD * np.arange(6000)
UBC = ["--column", "position.x=CH1out [mm]", "--column", "command.x=CH1sig [V]"]
SCENARIO = """
program = "way.ngc"
[machine]
name = "found"
servo_period = "1 ms"
axes = ["x"]
[axes.x]
file = "axis.toml"
limits = {velocity = "50 mm/s", acceleration = "0.5 m/s^2", jerk = "10 m/s^3"}
[controller.axes.x]
velocity = {kind = "filtered-difference", bandwidth = "600 rad/s"}
controller = {kind = "position", gains = {natural_frequency = "30 rad/s", damping = 0.8, pole = "30 rad/s"}}
[controller.axes.x.observer]
kind = "disturbance-observer"
bandwidth = "50 rad/s"
filter_bandwidth = "500 rad/s"
model_gain = "GAIN"
model_damping = "RATE 1/s"
"""
PLANT = """
[plant]
kind = "rigid-axis"
gain = "1.695 m/s^2/full_scale"
damping = "10.1 1/s"
[drive]
kind = "saturation"
limit = "1 full_scale"
"""


def codes(found: dict[str, Any]) -> set[str]:
    """Return the codes of the findings in a JSON document."""
    return {one["code"] for one in found["findings"]}


def written(file: Path, heads: str, *columns: np.ndarray) -> str:
    np.savetxt(file, np.column_stack(columns), delimiter=",", header=heads, comments="", fmt="%.10g")
    return str(file)


def found_by(words: list[str], capsys: pytest.CaptureFixture[str], code: int = 0) -> dict:  # type: ignore[type-arg]
    assert main(["identify", *words, "--json"]) == code
    return json.loads(capsys.readouterr().out)  # type: ignore[no-any-return]


def steps(seed: int = 0, size: float = 0.6, hold: int = 100) -> np.ndarray:
    return np.repeat(np.random.default_rng(seed).uniform(-size, size, TIME.size // hold), hold)


def stepped(tmp_path: Path, unit: str, size: float, noise: float = 0.0, seed: int = 0) -> str:
    """Return the log of axis 1 of Ghaffari & Ulsoy, full scale `size` of a unit, an offset of 1 % and an encoder of 0.125 um."""
    u = steps()
    place = 1.695 * first_order_motion(u + 0.01, PERIOD, 10.1, 0.055, 0.055)[1]
    place = np.round((place + noise * np.random.default_rng(seed).standard_normal(place.size)) / 0.125e-6) * 0.125e-6
    return written(tmp_path / "open.csv", f"time [s],cmd [{unit}],pos x [mm]", TIME, size * u, 1e3 * place)


def ramped(tmp_path: Path, size: float) -> str:
    ramp = np.r_[np.linspace(0.0, 0.2, 2000), np.zeros(500)]
    u = np.r_[np.zeros(50), ramp, -ramp, ramp, -ramp]
    place = np.round(1.695e3 * first_order_motion(u, PERIOD, 10.1, 0.06, 0.05)[1] / 0.125e-3) * 0.125e-3
    return written(tmp_path / "ramp.csv", "time [s],cmd [V],pos x [mm]", PERIOD * np.arange(u.size), size * u, place)


def driven(tmp_path: Path, gain: str = "1.695 m/s^2/full_scale", rate: float = 10.1) -> float:
    """Run the axis file there and back; return the rms of its tracking error [m]."""
    from contourlab.loop import simulate
    from contourlab.scenario import load_scenario

    (tmp_path / "way.ngc").write_text("G21 G90\nG1 X20 F1800\nX0\nM2\n")
    (tmp_path / "run.toml").write_text(SCENARIO.replace("GAIN", gain).replace("RATE", str(rate)))
    scenario = load_scenario(tmp_path / "run.toml")
    result = simulate(scenario.machine, scenario.controller, scenario.base.reference())
    error = result["reference"] - result["position"]
    return float(np.sqrt(np.mean(error**2)))


def jogged(tmp_path: Path, law: Callable[[np.ndarray], np.ndarray]) -> str:
    """Return the log of jogs both ways, from 5 to 200 mm/s, under a friction in volts."""
    speeds = np.array([5, 10, 20, 50, 80, 120, 160, 200]) * 1e-3
    v = np.repeat(np.ravel(np.column_stack([speeds, -speeds])), 600)
    u = law(v) + 0.01 * np.random.default_rng(1).standard_normal(v.size)
    return written(tmp_path / "jog.csv", "time [s],cmd [V],pos x [mm]", PERIOD * np.arange(v.size), u, 1e3 * PERIOD * np.cumsum(v))
