"""A plug-in is edited between two runs: the second run is that of the edited file."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typed_commands import Run

from contourlab.engine import fused
from contourlab.native import store

SCENARIO = """
machine = "builtin:xyz"
contour = "helix"
[feed]
feedrate = "2000 mm/min"
[controller.axes."*"]
velocity = {kind = "filtered-difference", bandwidth = "3000 rad/s"}
controller = {kind = "stiff"%s}
[schemes.base]
axes."*".sensor = "ideal"
"""
PLUGIN = """import numpy as np
from contourlab import Component, Port, param

K = np.array([%s, 200.0])


class Stiff(Component):
    "u = K e."

    family = "controller"
    kind = "stiff"
    reference = "none"
    inputs = (Port("reference"), Port("position"), Port("velocity"), Port("reference_velocity"))
    outputs = (Port("command"),)
    example = {"stiffness": 1e4}
    stiffness: float = param(default=1.0, minimum=0.0, structural=True, doc="stiffness")

    def step_function(self):
        def step(par, x, inp, clock):
            gain = %s
            return (), (gain * (inp.reference - inp.position) + K[1] * (inp.reference_velocity - inp.velocity),)
        return step
"""
WANTED = {"1e4": 52.590739189311e-6, "2e4": 27.142689081667e-6, "4e4": 13.785208188260e-6}
"""Stiffness -> largest contour error [m], in plain Python; without encoder counts, which amplify the last digit."""


@pytest.mark.parametrize("written", ["an array of the plug-in", "a parameter of the scenario"])
@pytest.mark.slow
def test_machine_code_follows_an_edit(written: str, contourlab: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    in_file = written == "an array of the plug-in"

    def largest_error(gain: str, cache: str, *, in_another_process: bool) -> float:
        (tmp_path / cache).mkdir(exist_ok=True)
        monkeypatch.setattr(store, "folder", lambda: tmp_path / cache)
        if in_another_process:
            monkeypatch.setattr(fused, "_loops", {})
        (tmp_path / "stiff.py").write_text(PLUGIN % ((gain, "K[0]") if in_file else ("0.0", "self.stiffness")), encoding="utf-8")
        (tmp_path / "scen.toml").write_text(SCENARIO % ("" if in_file else f", stiffness = {float(gain)}"), encoding="utf-8")
        said = json.loads(contourlab("run", "scen.toml", "--plugin", "stiff.py", "--json").answer)
        return float(said["schemes"]["base"]["metrics"]["contour_error"]["max"])

    found = {gain: largest_error(gain, "cache", in_another_process=True) for gain in WANTED}
    assert found == pytest.approx(WANTED, rel=1e-11)
    assert largest_error("1e4", "cache", in_another_process=False) == found["1e4"]
    assert largest_error("2e4", "empty", in_another_process=True) == found["2e4"]
