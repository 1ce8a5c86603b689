"""Friction from logs as typed: over speed, from rest, in the file and together with a plant."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from identified_logs import PERIOD, PLANT, TIME, UBC, codes, driven, found_by, jogged, ramped, written
from reference_data import reference_file

from contourlab.analysis.identification.first_order import first_order_motion
from contourlab.scenario.load import load_axis


def test_stiction_over_ramps(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ramp = np.r_[np.linspace(0.0, 0.2, 2000), np.zeros(500)]
    u = np.r_[np.zeros(50), ramp, -ramp, ramp, -ramp]
    place = np.round(1.695e3 * first_order_motion(u, PERIOD, 10.1, 0.06, 0.05)[1] / 0.125e-3) * 0.125e-3
    log = written(tmp_path / "ramp.csv", "time [s],cmd [full_scale],pos x [mm]", PERIOD * np.arange(u.size), u, place)
    out = tmp_path / "friction.toml"
    found = found_by([log, "--column", "command.x=cmd", "--model", "stiction", "--write", str(out)], capsys)
    assert found["parameters"]["breakaway+"]["value"] == pytest.approx(0.06, rel=0.02)
    assert found["parameters"]["breakaway-"]["value"] == pytest.approx(0.05, rel=0.02)
    assert len(found["details"]["ramps"]) == 4 and "spread over 4 slow ramps" in out.read_text()


def test_an_axis_that_slows_down_without_stopping_has_no_friction_of_its_own_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """From a fast run into a slow one: the mass, not friction, determines the braking in between, without a reference too."""
    levels = np.array([0.04, 0.12, 0.04, -0.04, -0.12, -0.04, 0.04, 0.08, -0.08])
    v = np.convolve(np.repeat(levels, 600), np.ones(150) / 150.0, mode="same")
    u = 10.0 * np.sign(v) + 100.0 * v + 90.0 * np.gradient(v, PERIOD) + 0.2 * np.random.default_rng(2).standard_normal(v.size)
    log = written(tmp_path / "jog.csv", "time [s],push [N],pos x [mm]", PERIOD * np.arange(v.size), u, 1e3 * PERIOD * np.cumsum(v))
    found = found_by([log, "--column", "force.x=push", "--model", "friction"], capsys)
    assert len(found["details"]["points"]) >= 6 and max(point["scatter"] for point in found["details"]["points"]) < 3.0
    assert found["fit_percent"] > 97.0 and "CL512" in codes(found)


@pytest.mark.slow
def test_friction_of_the_measured_table(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    logs = [str(reference_file(f"data/ubc-xy-table/friction_{v}_mmps.mat")) for v in (10, 120, 160, 200, 20, 50, 5, 80)]
    words = [*logs, "--column", "reference.x=CH1in [mm]", *UBC, "--full-scale", "10 V"]
    words += ["--model", "friction", "--plots", "png", "--write", "friction.toml"]
    found = found_by(words, capsys)
    assert len(found["details"]["points"]) == 16 and found["fit_percent"] > 97.0
    assert [round(1e3 * point["speed"]) for point in found["details"]["points"][:4]] == [10, -10, 120, -121]
    line = next(curve for curve in found["details"]["tried"] if curve["model"] == "Coulomb and viscous")["parameters"]
    # The table's own fit: 0.335 V and 5.3 V s/m forwards, 0.340 and 5.2 backwards.
    assert 10.0 * line["Fc"] == pytest.approx(0.34, abs=0.02) and 10.0 * line["Fv"] == pytest.approx(5.2, rel=0.12)
    assert "CL546" in codes(found)
    assert Path("results/plots/friction.png").stat().st_size > 10_000
    assert "[friction]" in Path("friction.toml").read_text()


@pytest.mark.parametrize("kind", ["friction", "stiction"])
def test_a_friction_file_runs_together_with_a_plant(tmp_path: Path, capsys: pytest.CaptureFixture[str], kind: str) -> None:
    out = tmp_path / "axis.toml"
    if kind == "friction":
        speeds = np.array([0.01, -0.01, 0.03, -0.03, 0.06, -0.06, 0.1, -0.1])
        v = np.repeat(speeds, 1500)
        u = 0.5 * np.sign(v) + 5.0 * v + 0.02 + 0.01 * np.random.default_rng(1).standard_normal(v.size)
        log = written(tmp_path / "jog.csv", "time [s],cmd [V],pos x [mm]", PERIOD * np.arange(v.size), u, 1e3 * PERIOD * np.cumsum(v))
    else:
        log = ramped(tmp_path, 10.0)
    words = [log, "--column", "command.x=cmd", "--model", kind, "--write", str(out)]
    nothing = found_by(words, capsys, code=1)
    assert "CL505" in codes(nothing) and nothing["axis_file"] is None and not out.exists()
    found_by([*words, "--full-scale", "10 V"], capsys)
    text = out.read_text()
    assert " V" not in text.split("[friction]")[1] and text.count("deviation") >= 2
    assert ("CL514" in text) == (kind == "friction")
    out.write_text(text + PLANT.replace("10.1", "0" if kind == "friction" else "10.1"))
    assert driven(tmp_path) < 0.2e-3
    if kind == "friction":
        force = load_axis(out).disturbance
        assert force.values()["force"] == pytest.approx(-0.002, abs=3.0 * force.origins["force"].deviation)


@pytest.mark.parametrize(("seed", "said"), [(3, "CL511"), (1, "CL533")])
def test_random_force_steps_identify_no_friction(tmp_path: Path, capsys: pytest.CaptureFixture[str], seed: int, said: str) -> None:
    """A mass under force steps has no constant speed, even where its position looks straight."""
    u = np.repeat(np.random.default_rng(seed).uniform(-200.0, 200.0, 60), 300)
    v = np.zeros(u.size)
    for k in range(1, u.size):
        v[k] = v[k - 1] + PERIOD * (u[k - 1] - 100.0 * v[k - 1]) / 20.0
    log = written(tmp_path / "levels.csv", "time [s],push [N],pos x [mm]", PERIOD * np.arange(v.size), u, 1e3 * PERIOD * np.cumsum(v))
    out = tmp_path / "axis.toml"
    found = found_by([log, "--column", "force.x=push", "--model", "friction", "--write", str(out)], capsys, code=1)
    assert said in codes(found) and not out.exists()


def test_friction_that_rises_is_not_called_stribeck(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = jogged(tmp_path, lambda v: np.sign(v) * (0.6 - 0.3 * np.exp(-((v / 0.06) ** 2))) + 3.0 * v)
    found = found_by([log, "--column", "command.x=cmd", "--model", "friction"], capsys)
    assert "Stribeck" not in found["details"]["friction_model"]
    assert "CL546" in codes(found)
    log = jogged(tmp_path, lambda v: np.sign(v) * (0.3 + 0.3 * np.exp(-((v / 0.03) ** 2))) + 3.0 * v)
    found = found_by([log, "--column", "command.x=cmd", "--model", "friction"], capsys)
    assert "Stribeck" in found["details"]["friction_model"] and "CL546" not in codes(found)


def test_friction_that_rises_from_rest_keeps_its_rise_in_the_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = jogged(tmp_path, lambda v: np.sign(v) * (0.6 - 0.3 * np.exp(-((v / 0.06) ** 2))) + 3.0 * v)
    out = tmp_path / "axis.toml"
    words = [log, "--column", "command.x=cmd", "--model", "friction", "--full-scale", "10 V", "--write", str(out)]
    found = found_by(words, capsys)
    figures = {name: one["value"] for name, one in found["parameters"].items()}
    assert figures["drop"] == pytest.approx(-0.03, rel=0.1) and "CL546" in codes(found)
    out.write_text(out.read_text() + PLANT.replace("10.1", "0"))
    axis = load_axis(out)
    friction, origins = axis.friction.values(), axis.friction.origins
    assert axis.friction.kind == "rising" and "mm/s" in out.read_text()
    assert (friction["coulomb"], friction["viscous"]) == pytest.approx((figures["Fc"], figures["Fv"]), rel=1e-4)
    assert friction["breakaway"] == pytest.approx(figures["Fc"] + figures["drop"], rel=1e-4)
    assert friction["rise_velocity"] == pytest.approx(figures["vs"], rel=1e-4)
    # The friction at rest is better known than its level at speed and the rise, which are correlated.
    assert origins["breakaway"].deviation < found["parameters"]["drop"]["deviation"]
    assert {frozenset(pair[:2]) for pair in axis.correlations} >= {frozenset(("friction.breakaway", "friction.rise_velocity"))}
    assert driven(tmp_path) < 0.2e-3


def test_a_curve_below_zero_at_rest_is_no_component(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = jogged(tmp_path, lambda v: np.sign(v) * (0.5 - 0.7 * np.exp(-((v / 0.06) ** 2))) + 3.0 * v)
    out = tmp_path / "friction.toml"
    words = [log, "--column", "command.x=cmd", "--model", "friction", "--full-scale", "10 V", "--write", str(out)]
    assert "CL513" in codes(found_by(words, capsys))
    assert 'kind = "coulomb"' in out.read_text()


@pytest.mark.parametrize("model", ["rigid-by-direction", "friction"])
def test_friction_averaged_over_directions_is_reported(tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str) -> None:
    out = tmp_path / "axis.toml"
    if model == "friction":
        words = [jogged(tmp_path, lambda v: np.where(v > 0.0, 0.5 + 4.0 * v, -0.7 + 8.0 * v)), "--column", "command.x=cmd"]
    else:
        v = 0.05 * np.cos(2.0 * np.pi * 0.7 * TIME) + 0.04 * np.cos(2.0 * np.pi * 2.9 * TIME)
        force = 40.0 * np.gradient(v, PERIOD) + np.where(v > 0.0, 5.0 + 40.0 * v, -7.0 + 80.0 * v)
        place = 1e3 * PERIOD * np.cumsum(v)
        words = [written(tmp_path / "log.csv", "time [s],cmd [V],pos x [mm]", TIME, 0.1 * force, place), "--column", "command.x=cmd"]
    found = found_by([*words, "--model", model, "--gain", "10 N/V", "--write", str(out)], capsys)
    (mean,) = (one for one in found["findings"] if one["code"] == "CL515" and one["place"] == "Fv")
    assert mean["text"] in out.read_text() and mean["values"]["unit"] == "N*s/m"
    assert mean["values"]["forward"] / mean["values"]["backward"] == pytest.approx(0.5, abs=0.05)
