"""Drives of two inertias, identified from their frequency response, as typed."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from identified_logs import PERIOD, codes, found_by, written
from typed_commands import Refused

from contourlab.scenario.load import load_axis


def shaken(tmp_path: Path, side: str) -> tuple[str, dict[str, float]]:
    """Write the log of motor 4, load 3 kg and a shaft at 60 Hz, built from its lines: a multisine of ten periods."""
    from contourlab.analysis.identification.drive_fit import held_response, two_inertia

    period, lap = PERIOD, 2000
    true = {"motor_mass": 4.0, "load_mass": 3.0, "stiffness": 2.4e5, "shaft_damping": 60.0, "damping": 40.0, "delay": 0.0}
    lines = np.arange(1, 601)
    spectrum = np.zeros(lap // 2 + 1, dtype=complex)
    spectrum[lines] = np.exp(2j * np.pi * np.random.default_rng(0).random(lines.size))
    answer = np.zeros_like(spectrum)
    answer[lines] = spectrum[lines] * held_response(lambda s: two_inertia(true, s, side), lines / (lap * period), period)
    force, place = (np.tile(np.fft.irfft(part, lap) * 400.0, 10) for part in (spectrum, answer))
    time = period * np.arange(force.size)
    return written(tmp_path / "multisine.csv", "time [s],push [N],pos x [mm]", time, force, 1e3 * place), true


@pytest.mark.slow
def test_the_load_s_side_makes_an_axis_with_the_motor_s_inertia(
    tmp_path: Path, refused: Refused, capsys: pytest.CaptureFixture[str]
) -> None:
    log, true = shaken(tmp_path, "load")
    out, turn = tmp_path / "drive.toml", 0.01 / (2.0 * math.pi)
    words = [log, "--column", "force.x=push", "--model", "two-inertia", "--side", "load", "--lead", "10 mm", "--write", str(out)]
    found = found_by(words, capsys, code=1)
    assert "CL504" in codes(found) and not out.exists()
    inertia = f"{1e4 * 4.0 * turn**2:.8g} kg*cm^2"
    found = found_by([*words, "--motor-inertia", inertia], capsys)
    plant = load_axis(out).plant
    for name, key in (("load_inertia", "load_mass"), ("stiffness", "stiffness"), ("shaft_damping", "shaft_damping")):
        assert plant.values()[name] == pytest.approx(true[key] * turn**2, rel=0.02), name
    assert plant.origins["motor_inertia"].source == "assumed" and plant.origins["motor_inertia"].deviation is None
    deviation = found["parameters"]["load_mass"]["robust_deviation"] * turn**2
    assert plant.origins["load_inertia"].deviation == pytest.approx(deviation, rel=0.02)
    for more, said in ((["--motor-inertia", "1 kg*m^2"], "1 kg*m^2"), (["--motor-inertia", "2 kg"], "2 kg*cm^2")):
        assert said in refused("identify", *words, *more)
    assert "--motor-inertia" in refused("identify", *words, "--motor-inertia", inertia, "--side", "motor")


def turning_drive(tmp_path: Path, damping: float) -> tuple[list[str], dict[str, float]]:
    """Write the log of motor 2, load 1.013 kg cm^2 and a shaft at 74 Hz, driven by a torque in a multisine; the load's position."""
    from scipy.linalg import expm

    x = {"motor": 2e-4, "load": 1.013e-4, "stiffness": 14.4, "shaft": 4.58e-4, "damping": damping}
    lines = np.arange(4, 400, 3)
    time = 5e-4 * np.arange(4000)
    phase = np.pi * np.arange(lines.size) * (np.arange(lines.size) - 1) / lines.size
    torque = np.cos(np.pi * lines * time[:, None] - phase).sum(axis=1)
    torque = np.tile(0.6 * torque / np.abs(torque).max(), 6)
    spring, loss = np.array([1.0, 0.0, -1.0, 0.0]) * x["stiffness"], np.array([0.0, 1.0, 0.0, -1.0]) * x["shaft"]
    rates = np.zeros((5, 5))
    rates[0, 1] = rates[2, 3] = 1.0
    rates[1, :4] = -(spring + loss + np.array([0.0, damping, 0.0, 0.0])) / x["motor"]
    rates[3, :4] = (spring + loss) / x["load"]
    rates[1, 4] = 1.0 / x["motor"]
    flow = expm(rates * 5e-4)
    state, place = np.zeros(4), []
    for held in torque:
        place.append(state[2])
        state = flow[:4, :4] @ state + flow[:4, 4] * held
    noise = 1e-5 * np.random.default_rng(3).standard_normal(torque.size)
    file = written(
        tmp_path / "turns.csv",
        "time [s],T [N*m],pos [mm]",
        5e-4 * np.arange(torque.size),
        torque,
        np.array(place) * 10.0 / math.tau + noise,
    )
    return [file, "--column", "position.x=pos", "--column", "torque.x=T", "--model", "two-inertia", "--side", "load"], x


@pytest.mark.parametrize("damping", [1e-3, 5e-3])
@pytest.mark.slow
def test_shaft_damping_is_separated_from_motor_damping_at_the_load(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], damping: float
) -> None:
    """A damped motor also damps the resonance; the given motor inertia separates this share from the shaft's."""
    words, x = turning_drive(tmp_path, damping)
    out = tmp_path / "drive.toml"
    found_by([*words, "--lead", "10 mm", "--motor-inertia", "2 kg*cm^2", "--write", str(out)], capsys)
    plant = load_axis(out).plant
    for name, key in (("load_inertia", "load"), ("stiffness", "stiffness"), ("shaft_damping", "shaft"), ("motor_damping", "damping")):
        assert plant.values()[name] == pytest.approx(x[key], rel=0.01), name
        assert abs(plant.values()[name] - x[key]) < 5.0 * plant.origins[name].deviation + 1e-3 * x[key], name
    # Without it the damping ratio is that of the resonance, from both sources.
    reduced = x["motor"] * x["load"] / (x["motor"] + x["load"])
    w = math.sqrt(x["stiffness"] / reduced)
    ratio = x["shaft"] / (2.0 * w * reduced) + damping * x["load"] / (2.0 * w * x["motor"] * (x["motor"] + x["load"]))
    figures = found_by([*words, "--lead", "10 mm"], capsys)["parameters"]
    assert figures["damping_ratio"]["value"] == pytest.approx(ratio, rel=0.02)
    assert figures["resonance"]["value"] == pytest.approx(w / math.tau, rel=2e-3)


def test_an_inertia_does_not_scale_masses_in_volts(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words, _ = turning_drive(tmp_path, 1e-3)
    words[words.index("torque.x=T")] = "command.x=T [V]"
    found = found_by([*words, "--lead", "10 mm", "--motor-inertia", "2 kg*cm^2"], capsys)
    assert "mass" in found["parameters"] and "CL504" in codes(found)


def test_a_number_at_its_bound_is_not_written_as_fitted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """With a motor inertia three times too small, the motor alone damps more than the resonance shows: the shaft's damping is unknown."""
    words, _ = turning_drive(tmp_path, 5e-3)
    out = tmp_path / "drive.toml"
    words += ["--lead", "10 mm", "--motor-inertia", "0.6 kg*cm^2", "--write", str(out)]
    found = found_by(words, capsys)
    assert found["parameters"]["shaft_damping"] == {"value": 0.0, "unit": "N*s/m", "deviation": None, "robust_deviation": None}
    assert ("CL527", "shaft_damping") in {(one["code"], one["place"]) for one in found["findings"]}
    origin = load_axis(out).plant.origins["shaft_damping"]
    assert (origin.source, origin.deviation) == ("assumed", None) and "bound" in origin.note
    assert not any("plant.shaft_damping" in pair for pair in load_axis(out).correlations)


@pytest.mark.slow
def test_two_inertias_make_an_axis(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log, true = shaken(tmp_path, "motor")
    out = tmp_path / "drive.toml"
    words = [log, "--column", "force.x=push", "--model", "two-inertia", "--lead", "10 mm"]
    figures = found_by([*words, "--write", str(out)], capsys)["parameters"]
    for name in ("motor_mass", "load_mass", "stiffness", "shaft_damping"):
        assert figures[name]["value"] == pytest.approx(true[name], rel=5e-3), name
    axis = load_axis(out)
    turn = 0.01 / (2.0 * math.pi)
    assert axis.plant.values()["load_inertia"] == pytest.approx(3.0 * turn**2, rel=5e-3)
    assert axis.plant.values()["stiffness"] == pytest.approx(2.4e5 * turn**2, rel=5e-3)
    assert axis.limits.acceleration > 0.0
    points = found_by([*words[:-2], "--model", "frequency-response"], capsys)["details"]["points"]
    assert len(points) > 400 and min(point["coherence"] for point in points[:300]) > 0.99
