"""An accelerometer's table, as firmware for printers writes it: a resonance by ``identify``, a notch for it by ``notch``."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.signal import cont2discrete, lfilter
from test_resonance_and_notch import MACHINE
from typed_commands import AsJson, Refused

from contourlab.cli.main import main
from contourlab.logs import load_log
from contourlab.logs.formats import format_of

FREQUENCY, DAMPING, RATE = 52.0, 0.05, 3200.0
SCENARIO = """
name = "a pocket"
program = "part.ngc"
machine = "machine.toml"
[controller.axes."*"]
feedback = "motor"
velocity = {kind = "filtered-difference", bandwidth = "3000 rad/s"}
controller = {kind = "cascade", gains = {bandwidth = "70 rad/s", damping = 1.0, position_gain = "14 1/s"}}
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A log of 10 s at 3200 Hz, times in seconds of the firmware's clock with six decimals, gravity on z."""
    folder = tmp_path_factory.mktemp("accelerometer")
    n, w, rng = 32_000, math.tau * FREQUENCY, np.random.default_rng(5)
    top, bottom, _ = cont2discrete(([2.0 * DAMPING * w, w * w], [1.0, 2.0 * DAMPING * w, w * w]), 1.0 / RATE, "foh")
    heard = lfilter(np.ravel(top), bottom, 2000.0 * rng.standard_normal(n))
    rows = np.column_stack([1234.5 + np.arange(n) / RATE, heard, 50.0 * rng.standard_normal(n), 9806.0 + 50.0 * rng.standard_normal(n)])
    np.savetxt(folder / "heard.csv", rows, delimiter=",", comments="#", header="time,accel_x,accel_y,accel_z", fmt="%.6f")
    (folder / "machine.toml").write_text(MACHINE)
    (folder / "part.toml").write_text(SCENARIO)
    (folder / "part.ngc").write_text("G21 G90 G64 P0.01\nG1 X20 F3000\nY20\nM2\n")
    return folder


def test_the_table_has_the_units_of_the_firmware(folder: Path) -> None:
    assert format_of(folder / "heard.csv").name == "accelerometer"
    (folder / "noted.csv").write_text("# bench\n#\n" + (folder / "heard.csv").read_text())
    assert format_of(folder / "noted.csv").name == "accelerometer"
    log = load_log(folder / "heard.csv")
    assert log.result.axes == ("x", "y", "z") and log.result.servo_period == pytest.approx(1.0 / RATE, rel=1e-6)
    assert np.mean(log.result["acceleration"][:, 2]) == pytest.approx(9.806, rel=1e-3)


def test_a_resonance_with_its_deviations(folder: Path, as_json: AsJson, refused: Refused, capsys: pytest.CaptureFixture[str]) -> None:
    log = folder / "heard.csv"
    found = as_json("identify", log, "--axis", "x")
    assert found["usable"] and found["model"] == "resonance"
    for name, true in (("frequency", FREQUENCY), ("damping_ratio", DAMPING)):
        figure = found["parameters"][name]
        assert abs(figure["value"] - true) < 3.0 * figure["robust_deviation"] < 0.3 * true
    assert refused("identify", log, "--model", "resonance").count("--axis") == 1
    assert "excited" in refused("identify", log, "--model", "resonance", "--axis", "y")
    assert "position" in refused("identify", log, "--model", "rigid", "--axis", "x")
    assert main(["identify", str(log), "--model", "resonance", "--axis", "x"]) == 0
    assert main(["identify", str(log), "--axis", "x", "--write", str(folder / "axis.toml")]) == 1
    assert "next:" not in capsys.readouterr().out  # this model has no axis file
    half = as_json("identify", log, "--model", "resonance", "--axis", "x", "--window", "..15999")
    assert half["parameters"]["frequency"]["robust_deviation"] > found["parameters"]["frequency"]["robust_deviation"]


@pytest.mark.slow
def test_a_notch_for_the_resonance_that_is_heard(folder: Path, as_json: AsJson, refused: Refused) -> None:
    words = ("notch", folder / "part.toml", "--axes", "x", "--log", folder / "heard.csv")
    found, plain = as_json(*words, code=(0, 1)), as_json(*words[:4], code=(0, 1))
    (said,) = (one["values"] for one in found["findings"] if one["code"] == "CL643")
    assert said["frequency"] == pytest.approx(FREQUENCY, rel=0.01) and said["damping"] == pytest.approx(DAMPING, rel=0.15)
    design = found["designs"]["x"]
    assert (design["resonance"], design["damping_ratio"]) == (
        pytest.approx(said["frequency"], rel=1e-4),
        pytest.approx(said["damping"], rel=1e-3),
    )
    assert plain["designs"]["x"]["resonance"] == pytest.approx(60.0, rel=1e-2)
    refused("notch", folder / "part.toml", "--log", folder / "heard.csv")
    refused("notch", folder / "part.toml", "--axes", "y", "--log", folder / "heard.csv")


@pytest.mark.parametrize(
    "head", ["#time,accel_x,accel_y,accel_z,", '"time","accel_x","accel_y","accel_z"', '#"time","accel_x","accel_y","accel_z",']
)
def test_a_table_with_closed_lines_or_quoted_names(tmp_path: Path, head: str) -> None:
    end = "," * head.endswith(",")
    (tmp_path / "heard.csv").write_text("\n".join([head, *(f"{k * 1e-3:.3f},{k},0,9806{end}" for k in range(50)), ""]))
    log = load_log(tmp_path / "heard.csv")
    assert log.result["acceleration"][7].tolist() == pytest.approx([7e-3, 0.0, 9.806])
