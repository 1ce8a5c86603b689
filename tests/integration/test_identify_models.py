"""The models of ``contourlab identify`` as typed: from logs to figures, pictures and axis files."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from contourlab.analysis.closed_first_order import closed_loop_position
from contourlab.analysis.first_order_motion import first_order_motion
from contourlab.cli.main import main
from contourlab.loop import Machine
from contourlab.scenario.load import load_axis

PERIOD = 1e-3
TIME = PERIOD * np.arange(6000)
UBC = ["--column", "position.x=CH1out [mm]", "--column", "command.x=CH1sig [V]"]


def written(file: Path, heads: str, *columns: np.ndarray) -> str:
    np.savetxt(file, np.column_stack(columns), delimiter=",", header=heads, comments="", fmt="%.10g")
    return str(file)


def found_by(words: list[str], capsys: pytest.CaptureFixture[str], code: int = 0) -> dict:  # type: ignore[type-arg]
    assert main(["identify", *words, "--json"]) == code
    return json.loads(capsys.readouterr().out)  # type: ignore[no-any-return]


def steps(seed: int = 0, size: float = 0.6, hold: int = 100) -> np.ndarray:
    return np.repeat(np.random.default_rng(seed).uniform(-size, size, TIME.size // hold), hold)


def test_first_order_makes_an_axis(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    u = steps()
    place = np.round(1.695e3 * first_order_motion(u, PERIOD, 10.1, 0.055, 0.055)[1] / 0.125e-3) * 0.125e-3
    log = written(tmp_path / "open.csv", "time [s],cmd [full_scale],pos x [mm]", TIME, u, place)
    out = tmp_path / "axis.toml"
    figures = found_by([log, "--column", "command.x=cmd", "--model", "first-order", "--out", str(out)], capsys)["parameters"]
    assert [figures[name]["value"] for name in ("a", "b", "friction")] == pytest.approx([1.695, 10.1, 0.055], rel=2e-3)
    assert figures["a"]["unit"] == "m/s^2/full_scale"
    axis = load_axis(out)
    assert axis.plant.values()["gain"] == pytest.approx(1.695, rel=2e-3)
    assert axis.friction.values()["coulomb"] == pytest.approx(0.055, rel=2e-3)
    assert "deviation" in out.read_text() and "open.csv" in out.read_text()


def test_closed_loop_takes_the_gains_of_the_loop(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    asked = steps(1, 1e-4, 250)
    place = closed_loop_position(asked, PERIOD, 0.873, 19.7, 4000.0, 100.0)
    log = written(tmp_path / "closed.csv", "time [s],ref x [mm],pos x [mm]", TIME, 1e3 * asked, 1e3 * place)
    words = [log, "--model", "closed-loop", "--position-gain", "4 full_scale/mm"]
    gains = [*words, "--velocity-gain", "0.1 full_scale*s/mm"]
    figures = found_by(gains, capsys)["parameters"]
    assert (figures["a'"]["value"], figures["b'"]["value"]) == pytest.approx((0.873, 19.7), rel=1e-3)
    for wrong, said in (
        (words, "--velocity-gain"),
        ([*words, "--velocity-gain", "3 parsecs"], "0.1 full_scale*s/mm"),
        ([log, "--model", "closed-loop"], "no disturbance_estimate"),
        ([log, log, *gains[1:]], "a single run"),
    ):
        assert main(["identify", *wrong]) == 2
        assert said in capsys.readouterr().err


def test_stiction_over_ramps(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ramp = np.r_[np.linspace(0.0, 0.2, 2000), np.zeros(500)]
    u = np.r_[np.zeros(50), ramp, -ramp, ramp, -ramp]
    place = np.round(1.695e3 * first_order_motion(u, PERIOD, 10.1, 0.06, 0.05)[1] / 0.125e-3) * 0.125e-3
    log = written(tmp_path / "ramp.csv", "time [s],cmd [full_scale],pos x [mm]", PERIOD * np.arange(u.size), u, place)
    out = tmp_path / "friction.toml"
    found = found_by([log, "--column", "command.x=cmd", "--model", "stiction", "--out", str(out)], capsys)
    assert found["parameters"]["breakaway+"]["value"] == pytest.approx(0.06, rel=0.02)
    assert found["parameters"]["breakaway-"]["value"] == pytest.approx(0.05, rel=0.02)
    assert len(found["ramps"]) == 4 and "spread over 4 slow ramps" in out.read_text()


def shaken(tmp_path: Path, side: str) -> tuple[str, dict[str, float]]:
    """Write the log of motor 4, load 3 kg and a shaft at 60 Hz, built from its lines: a multisine of ten periods."""
    from contourlab.analysis.drive_models import held_response, two_inertia

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


def test_the_load_s_side_makes_an_axis_with_the_motor_s_inertia(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log, true = shaken(tmp_path, "load")
    out, turn = tmp_path / "drive.toml", 0.01 / (2.0 * math.pi)
    words = [log, "--column", "force.x=push", "--model", "two-inertia", "--side", "load", "--lead", "10 mm", "--out", str(out)]
    found = found_by(words, capsys, code=1)
    assert any("takes --motor-inertia, of motor and screw" in said for said in found["remarks"]) and not out.exists()
    inertia = f"{1e4 * 4.0 * turn**2:.8g} kg*cm^2"
    found = found_by([*words, "--motor-inertia", inertia], capsys)
    plant = load_axis(out).plant
    for name, key in (("load_inertia", "load_mass"), ("stiffness", "stiffness"), ("shaft_damping", "shaft_damping")):
        assert plant.values()[name] == pytest.approx(true[key] * turn**2, rel=0.02), name
    assert plant.origins["motor_inertia"].source == "assumed" and plant.origins["motor_inertia"].deviation is None
    deviation = found["parameters"]["load_mass"]["robust_deviation"] * turn**2
    assert plant.origins["load_inertia"].deviation == pytest.approx(deviation, rel=0.02)
    for more, said in ((["--motor-inertia", "1 kg*m^2"], "below the whole inertia"), (["--motor-inertia", "2 kg"], "2 kg*cm^2")):
        assert main(["identify", *words, *more]) == 2
        assert said in capsys.readouterr().err
    assert main(["identify", *words, "--motor-inertia", inertia, "--side", "motor"]) == 2
    assert "at the motor it is measured" in capsys.readouterr().err


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
def test_the_shaft_is_told_from_what_the_motor_damps_at_the_load(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], damping: float
) -> None:
    """A motor that is damped damps the resonance by its share: what is given of the motor tells that from the shaft's part."""
    words, x = turning_drive(tmp_path, damping)
    out = tmp_path / "drive.toml"
    found_by([*words, "--lead", "10 mm", "--motor-inertia", "2 kg*cm^2", "--out", str(out)], capsys)
    plant = load_axis(out).plant
    for name, key in (("load_inertia", "load"), ("stiffness", "stiffness"), ("shaft_damping", "shaft"), ("motor_damping", "damping")):
        assert plant.values()[name] == pytest.approx(x[key], rel=0.01), name
        assert abs(plant.values()[name] - x[key]) < 5.0 * plant.origins[name].deviation + 1e-3 * x[key], name
    # Without the share the damping ratio is that of the resonance itself, whoever damps it.
    reduced = x["motor"] * x["load"] / (x["motor"] + x["load"])
    w = math.sqrt(x["stiffness"] / reduced)
    ratio = x["shaft"] / (2.0 * w * reduced) + damping * x["load"] / (2.0 * w * x["motor"] * (x["motor"] + x["load"]))
    figures = found_by([*words, "--lead", "10 mm"], capsys)["parameters"]
    assert figures["damping_ratio"]["value"] == pytest.approx(ratio, rel=0.02)
    assert figures["resonance"]["value"] == pytest.approx(w / math.tau, rel=2e-3)


def test_an_inertia_says_nothing_of_masses_in_volts(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words, _ = turning_drive(tmp_path, 1e-3)
    words[words.index("torque.x=T")] = "command.x=T [V]"
    found = found_by([*words, "--lead", "10 mm", "--motor-inertia", "2 kg*cm^2"], capsys)
    assert "mass" in found["parameters"] and 'an axis file of two inertias takes --gain, as "35.15 N/V"' in found["remarks"]


def test_a_number_at_its_bound_is_not_written_as_fitted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A motor said to be three times too light leaves less damping to its resonance than the motor's own: none is told of the shaft."""
    words, _ = turning_drive(tmp_path, 5e-3)
    out = tmp_path / "drive.toml"
    words += ["--lead", "10 mm", "--motor-inertia", "0.6 kg*cm^2", "--out", str(out)]
    found = found_by(words, capsys)
    assert found["parameters"]["shaft_damping"] == {"value": 0.0, "unit": "N*s/m", "deviation": None, "robust_deviation": None}
    assert any("shaft_damping = 0 is at the bound of what is looked for" in said for said in found["remarks"])
    origin = load_axis(out).plant.origins["shaft_damping"]
    assert (origin.source, origin.deviation) == ("assumed", None) and "at the bound" in origin.note
    assert not any("plant.shaft_damping" in pair for pair in load_axis(out).correlations)


def test_a_log_given_twice_is_refused_and_one_of_the_same_samples_remarked_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    log = Path(jogged(tmp_path, lambda v: 0.5 * np.sign(v) + 4.0 * v))
    monkeypatch.chdir(tmp_path)
    (tmp_path / "link.csv").symlink_to(log)
    words = ["--column", "command.x=cmd", "--model", "friction"]
    for again, said in ((log.name, "jog.csv: must be given once"), ("link.csv", "link.csv, the same file as jog.csv")):
        assert main(["identify", log.name, again, *words]) == 2
        assert said in capsys.readouterr().err
    (tmp_path / "copy.csv").write_bytes(log.read_bytes())
    told = "copy.csv has the samples of jog.csv: they count twice"
    assert told in found_by([log.name, "copy.csv", *words], capsys)["remarks"]


def test_an_axis_that_slows_down_without_stopping_has_no_friction_of_its_own_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """From a fast run into a slow one: what brakes in between is mass, not friction, without a reference too."""
    levels = np.array([0.04, 0.12, 0.04, -0.04, -0.12, -0.04, 0.04, 0.08, -0.08])
    v = np.convolve(np.repeat(levels, 600), np.ones(150) / 150.0, mode="same")
    u = 10.0 * np.sign(v) + 100.0 * v + 90.0 * np.gradient(v, PERIOD) + 0.2 * np.random.default_rng(2).standard_normal(v.size)
    log = written(tmp_path / "jog.csv", "time [s],push [N],pos x [mm]", PERIOD * np.arange(v.size), u, 1e3 * PERIOD * np.cumsum(v))
    found = found_by([log, "--column", "force.x=push", "--model", "friction"], capsys)
    assert len(found["points"]) >= 6 and max(point["scatter"] for point in found["points"]) < 3.0
    assert found["fit_percent"] > 97.0 and any("constant speed is told from the position" in said for said in found["remarks"])


def test_two_inertias_make_an_axis(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log, true = shaken(tmp_path, "motor")
    out = tmp_path / "drive.toml"
    words = [log, "--column", "force.x=push", "--model", "two-inertia", "--lead", "10 mm"]
    figures = found_by([*words, "--out", str(out)], capsys)["parameters"]
    for name in ("motor_mass", "load_mass", "stiffness", "shaft_damping"):
        assert figures[name]["value"] == pytest.approx(true[name], rel=5e-3), name
    axis = load_axis(out)
    turn = 0.01 / (2.0 * math.pi)
    assert axis.plant.values()["load_inertia"] == pytest.approx(3.0 * turn**2, rel=5e-3)
    assert axis.plant.values()["stiffness"] == pytest.approx(2.4e5 * turn**2, rel=5e-3)
    assert axis.limits.acceleration > 0.0
    points = found_by([*words[:-2], "--model", "frequency-response"], capsys)["points"]
    assert len(points) > 400 and min(point["coherence"] for point in points[:300]) > 0.99


def test_friction_of_the_measured_table(
    shared: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    logs = sorted(str(file) for file in (shared / "data" / "ubc-xy-table").glob("friction_*_mmps.mat"))
    assert len(logs) == 8
    words = [*logs, "--column", "reference.x=CH1in [mm]", *UBC, "--full-scale", "10 V"]
    words += ["--model", "friction", "--plots", "png", "--out", "friction.toml"]
    found = found_by(words, capsys)
    assert len(found["points"]) == 16 and found["fit_percent"] > 97.0
    assert [round(1e3 * point["speed"]) for point in found["points"][:4]] == [10, -10, 120, -121]
    line = next(curve for curve in found["tried"] if curve["model"] == "Coulomb and viscous")["parameters"]
    # The table's own fit: 0.335 V and 5.3 V s/m forwards, 0.340 and 5.2 backwards.
    assert 10.0 * line["Fc"] == pytest.approx(0.34, abs=0.02) and 10.0 * line["Fv"] == pytest.approx(5.2, rel=0.12)
    assert any(said.startswith("concave") for said in found["remarks"])
    assert Path("results/plots/friction.png").stat().st_size > 10_000
    assert "[friction]" in Path("friction.toml").read_text()


def test_sines_of_the_measured_table(shared: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    logs = [str(shared / "data" / "ubc-xy-table" / f"sine_{f}Hz.mat") for f in (1, 4, 10, 30, 50, 70)]
    out = tmp_path / "axis.toml"
    found = found_by([*logs, *UBC, "--model", "linear-motor", "--out", str(out)], capsys)
    assert [point["frequency"] for point in found["points"]] == pytest.approx([4.0, 10.0, 30.0, 50.0, 70.0], rel=2e-3)
    assert any("sine_1Hz.mat: the axis stands still" in said for said in found["remarks"])
    assert any("sine_4Hz.mat: harmonics" in said for said in found["remarks"])
    assert not any("turns round" in said for said in found["remarks"])
    assert found["parameters"]["M"]["value"] == pytest.approx(0.347, rel=0.02) and found["fit_percent"] > 95.0
    assert found["parameters"]["M"]["unit"] == "V*s^2/m" and any(
        'give --gain, as "35.15 N/V" for kilograms' in said for said in found["remarks"]
    )
    assert load_axis(out).plant.values()["damping"] == pytest.approx(10.3, rel=0.05)


@pytest.mark.parametrize(
    "model", ["friction", "stiction", "first-order", "closed-loop", "frequency-response", "linear-motor", "two-inertia"]
)
def test_a_log_of_an_axis_at_rest_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str) -> None:
    log = written(tmp_path / "rest.csv", "time [s],cmd [V],pos x [mm],ref x [mm]", TIME, steps(), 0.0 * TIME, 0.0 * TIME)
    gains = ["--position-gain", "4 V/mm", "--velocity-gain", "0.1 V*s/mm"]
    assert main(["identify", log, "--column", "command.x=cmd", "--model", model, *gains, "--out", str(tmp_path / "axis.toml")]) == 2
    said = capsys.readouterr().err
    assert "Traceback" not in said and len(said) > 40
    assert not (tmp_path / "axis.toml").exists()


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


@pytest.mark.parametrize(
    ("unit", "size", "more", "gain"),
    [
        ("full_scale", 1.0, [], "1.695 m/s^2/full_scale"),
        ("V", 10.0, ["--full-scale", "10 V"], "1.695 m/s^2/full_scale"),
        ("V", 10.0, [], "1.0 m/s^2/full_scale"),
        ("V", 10.0, ["--gain", "5 N/V"], "0.1695 m/s^2/A"),
    ],
)
@pytest.mark.parametrize("model", ["first-order", "linear-motor", "rigid"])
def test_the_file_of_an_axis_runs(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str, unit: str, size: float, more: list[str], gain: str
) -> None:
    out = tmp_path / "axis.toml"
    words = [stepped(tmp_path, unit, size), "--column", "command.x=cmd", "--model", model, "--out", str(out), *more]
    if model == "rigid":
        if "--gain" not in more:
            assert main(["identify", *words]) == 2 and not out.exists()
            return
        words += ["--cutoff", "100 Hz"]
    found = found_by(words, capsys)
    assert driven(tmp_path, gain) < 0.2e-3
    assert any("turns round in open.csv" in said for said in found["remarks"]) == (model == "linear-motor")
    axis = load_axis(out)
    assert axis.correlations and axis.plant.origins["damping"].deviation
    if "--gain" in more and model == "first-order":
        assert axis.plant.values()["mass"] == pytest.approx(50.0 / 1.695, rel=1e-2)
        assert axis.disturbance.values()["force"] == pytest.approx(0.5, rel=0.05)
        # 1/a and b/a: relative deviations of mass and damping are nearly those of a, and of b with a's share.
        a = found["parameters"]["a"]
        assert axis.plant.origins["mass"].deviation / axis.plant.values()["mass"] == pytest.approx(
            a["robust_deviation"] / a["value"], rel=0.01
        )


@pytest.mark.parametrize("kind", ["friction", "stiction"])
def test_the_file_of_a_friction_runs_beside_a_plant(tmp_path: Path, capsys: pytest.CaptureFixture[str], kind: str) -> None:
    out = tmp_path / "axis.toml"
    if kind == "friction":
        speeds = np.array([0.01, -0.01, 0.03, -0.03, 0.06, -0.06, 0.1, -0.1])
        v = np.repeat(speeds, 1500)
        u = 0.5 * np.sign(v) + 5.0 * v + 0.02 + 0.01 * np.random.default_rng(1).standard_normal(v.size)
        log = written(tmp_path / "jog.csv", "time [s],cmd [V],pos x [mm]", PERIOD * np.arange(v.size), u, 1e3 * PERIOD * np.cumsum(v))
    else:
        log = ramped(tmp_path, 10.0)
    words = [log, "--column", "command.x=cmd", "--model", kind, "--out", str(out)]
    nothing = found_by(words, capsys, code=1)
    assert any("--full-scale" in said for said in nothing["remarks"]) and nothing["axis_file"] is None and not out.exists()
    found_by([*words, "--full-scale", "10 V"], capsys)
    text = out.read_text()
    assert " V" not in text.split("[friction]")[1] and text.count("deviation") >= 2
    assert ("damping of the plant beside it is to be 0" in text) == (kind == "friction")
    out.write_text(text + PLANT.replace("10.1", "0" if kind == "friction" else "10.1"))
    assert driven(tmp_path) < 0.2e-3
    if kind == "friction":
        force = load_axis(out).disturbance
        assert force.values()["force"] == pytest.approx(-0.002, abs=3.0 * force.origins["force"].deviation)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (["--gain", "35 N/A"], "per V"),
        (["--full-scale", "10 A"], "in V"),
        (["--full-scale", "0 V"], "> 0"),
        (["--full-scale", "ten"], "10 V"),
        (["--full-scale", "10 V", "--gain", "35 N/V"], "one of the two"),
    ],
)
def test_a_gain_per_another_unit_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str], more: list[str], said: str) -> None:
    words = [stepped(tmp_path, "V", 10.0), "--column", "command.x=cmd", "--model", "first-order", *more]
    assert main(["identify", *words]) == 2
    error = capsys.readouterr().err
    assert said in error and "Traceback" not in error


@pytest.mark.slow
def test_deviations_are_the_spread_over_many_logs() -> None:
    """Thirty noisy logs of one axis in open loop, and thirty frequency responses of one drive by five sines."""
    from contourlab.analysis.drive_models import held_response, linear_motor
    from contourlab.analysis.first_order import identify_first_order
    from contourlab.studies.identification.drives import identify_linear_motor
    from contourlab.studies.identification.signals import AxisRecord

    u, true = steps()[:4000], {"M": 0.347, "B": 3.56, "delay": 5e-4}
    place, time = 1.695 * first_order_motion(u, PERIOD, 10.1, 0.055, 0.055)[1], TIME[:3000]

    def sine(f: float, noise: np.ndarray) -> AxisRecord:
        h = held_response(lambda s: linear_motor(true, s), np.array([f]), PERIOD)[0]
        wave = np.exp(2j * np.pi * f * time)
        return AxisRecord(f"{f}", "x", PERIOD, (h * wave).imag + noise, wave.imag, "V", None, None)

    found: dict[str, list[tuple[float, float]]] = {}
    for seed in range(30):
        rng = np.random.default_rng(seed)
        fit = identify_first_order(TIME[:4000], u, place + 2e-6 * rng.standard_normal(4000))
        for name in ("a", "b", "friction"):
            found.setdefault(name, []).append((fit[name], fit.found.deviation(name)))
        drive = identify_linear_motor([sine(f, 2e-6 * rng.standard_normal(3000)) for f in (4.0, 10.0, 30.0, 50.0, 70.0)])
        for figure in drive.figures:
            found.setdefault(figure.name, []).append((figure.value, figure.robust_deviation))
    for name, rows in found.items():
        values, deviations = np.array(rows).T
        # The spread of thirty is itself known to 13 %; the damping's deviation is on the safe side.
        assert 0.6 < np.median(deviations) / values.std(ddof=1) < (6.0 if name == "B" else 1.6), name


@pytest.mark.parametrize("model", ["rigid", "first-order", "linear-motor"])
def test_units_that_cannot_be_right_are_told(tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str) -> None:
    """The same log with its millimetres taken for nanometres: 30 kg become 30 thousand tonnes."""
    out = tmp_path / "axis.toml"
    words = [stepped(tmp_path, "V", 10.0), "--column", "command.x=cmd", "--gain", "5 N/V", "--model", model, "--out", str(out)]
    assert not any("units" in said for said in found_by(words, capsys)["remarks"]) and out.exists()
    out.unlink()
    found = found_by([*words, "--column", "position.x=pos x [nm]"], capsys, code=1)
    assert any("kg is moved: are the units of position, force and gain right?" in said for said in found["remarks"]) and not out.exists()


@pytest.mark.parametrize("more", [["--gain", "5 N/V"], ["--gain", "-5 N/V", "--column", "command.x=-cmd"]])
def test_a_gain_makes_the_same_kind_of_axis_by_every_model(tmp_path: Path, capsys: pytest.CaptureFixture[str], more: list[str]) -> None:
    """An axis of 50/1.695 kg in a log in volts: force constant, limit and offset of its file do not hang on the model."""
    column = [] if "--column" in more else ["--column", "command.x=cmd"]
    log, found = stepped(tmp_path, "V", 10.0), {}
    for model in ("rigid", "first-order", "linear-motor"):
        out = tmp_path / f"{model}.toml"
        found[model] = found_by([log, *column, *more, "--model", model, "--out", str(out)], capsys)
        axis = load_axis(out)
        assert axis.plant.kind == "mass-damper" and axis.plant.values()["force_constant"] == pytest.approx(5.0), model
        # The sliding friction of an axis that turns round counts as damping over frequency, and as some mass.
        assert axis.plant.values()["mass"] == pytest.approx(50.0 / 1.695, rel=0.05 if model == "linear-motor" else 0.01)
        largest = 10.0 * float(np.abs(steps()).max())
        assert axis.drive.values()["limit"] == pytest.approx(1.5 * largest)
        assert "50 % above the largest in the log, as velocity and acceleration take it" in axis.drive.origins["limit"].note
        assert axis.limits.velocity == pytest.approx(load_axis(tmp_path / "rigid.toml").limits.velocity, rel=0.1)
        if model != "linear-motor":  # a command of half a newton is what the constant force of the axis takes
            assert axis.disturbance.values()["force"] == pytest.approx(0.5, rel=0.05)
    assert found["rigid"]["parameters"]["offset"]["value"] == pytest.approx(-0.5, rel=0.05)
    assert found["first-order"]["parameters"]["offset"]["value"] == pytest.approx(-0.5, rel=0.05)


@pytest.mark.parametrize("full_scale", [False, True])
@pytest.mark.parametrize("model", ["first-order", "linear-motor", "rigid"])
def test_an_identified_axis_follows_plans_at_its_limits(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str, full_scale: bool
) -> None:
    """Velocity and acceleration at once are less than the drive gives, whatever the log: here steps in open loop, which have them apart."""
    if model == "rigid" and full_scale:
        return  # takes forces
    out, mass = tmp_path / "axis.toml", 1.0 if full_scale else 50.0
    log = stepped(tmp_path, "full_scale" if full_scale else "N", mass)
    column = "force.x=cmd" if model == "rigid" else "command.x=cmd"
    found_by([log, "--column", column, "--model", model, "--out", str(out)], capsys)
    axis = load_axis(out)
    limits, rate = axis.limits, 10.1
    taken = mass * ((limits.acceleration + rate * limits.velocity) / 1.695 + 0.055 + 0.01)
    drive = axis.drive.values()["limit"]
    assert 0.8 * drive < taken < 0.95 * drive
    assert limits.jerk == pytest.approx(100.0 * limits.acceleration, rel=1e-4)
    assert "as the drive's limit gives no more of velocity and acceleration at once" in limits.origins["acceleration"].note
    assert limits.origins["velocity"].source == "assumed" and "give the axis' own" in limits.origins["velocity"].note
    assert Machine("m", (axis,), PERIOD).planner_limits().acceleration[0] == limits.acceleration


def test_a_limit_that_is_missing_is_told_with_its_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "axis.toml").write_text(PLANT + '[limits]\nvelocity = "50 mm/s"\n')
    text = SCENARIO.replace("GAIN", "1.695 m/s^2/full_scale").replace("RATE", "10.1").replace("limits =", "#")
    (tmp_path / "way.ngc").write_text("G21 G90\nG1 X20 F1800\nX0\nM2\n")
    (tmp_path / "run.toml").write_text(text)
    assert main(["run", str(tmp_path / "run.toml"), "--out", str(tmp_path / "out")]) == 2
    said = capsys.readouterr().err
    assert f"{tmp_path / 'axis.toml'}: axis x of found has no limit for its ramps: give it limits.acceleration" in said


def test_logs_of_one_name_are_told_apart_by_their_folders(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name, speeds in (("slow", [10, 20, 40]), ("fast", [80, 120, 160])):
        (tmp_path / name).mkdir()
        v = np.repeat(np.ravel(np.column_stack([speeds, np.negative(speeds)])), 600) * 1e-3
        u = 0.5 * np.sign(v) + 5.0 * v + 0.01 * np.random.default_rng(1).standard_normal(v.size)
        written(tmp_path / name / "jog.csv", "time [s],cmd [N],pos x [mm]", PERIOD * np.arange(v.size), u, 1e3 * PERIOD * np.cumsum(v))
    logs, out = [str(tmp_path / name / "jog.csv") for name in ("slow", "fast")], tmp_path / "axis.toml"
    words = [*logs, "--column", "force.x=cmd", "--model", "friction", "--out", str(out)]
    found = found_by(words, capsys)
    assert found["logs"] == ["slow/jog.csv", "fast/jog.csv"]
    assert {point["log"] for point in found["points"]} == {"slow/jog.csv", "fast/jog.csv"}
    assert 'from = "slow/jog.csv and 1 more"' in out.read_text() and str(tmp_path) not in out.read_text()
    assert main(["identify", *words]) == 0
    assert "slow/jog.csv, fast/jog.csv, axis x" in capsys.readouterr().out
    # What is to be said of one log only names it.
    rows = (tmp_path / "fast" / "jog.csv").read_text().splitlines()
    (tmp_path / "fast" / "jog.csv").write_text("\n".join([*rows[:700], *rows[703:]]) + "\n")
    notes = found_by(words, capsys)["notes"]
    assert any(note.startswith("fast/jog.csv: ") and "missing" in note for note in notes)


def jogged(tmp_path: Path, law: Callable[[np.ndarray], np.ndarray]) -> str:
    """Return the log of jogs both ways, from 5 to 200 mm/s, under a friction in volts."""
    speeds = np.array([5, 10, 20, 50, 80, 120, 160, 200]) * 1e-3
    v = np.repeat(np.ravel(np.column_stack([speeds, -speeds])), 600)
    u = law(v) + 0.01 * np.random.default_rng(1).standard_normal(v.size)
    return written(tmp_path / "jog.csv", "time [s],cmd [V],pos x [mm]", PERIOD * np.arange(v.size), u, 1e3 * PERIOD * np.cumsum(v))


@pytest.mark.parametrize(("seed", "said"), [(3, "the speeds are not constant"), (4, "% of the command: more than friction is at work")])
def test_levels_of_force_at_random_tell_no_friction(tmp_path: Path, capsys: pytest.CaptureFixture[str], seed: int, said: str) -> None:
    """What looks straight on the whole is no constant speed where a mass follows steps of force."""
    u = np.repeat(np.random.default_rng(seed).uniform(-200.0, 200.0, 60), 300)
    v = np.zeros(u.size)
    for k in range(1, u.size):
        v[k] = v[k - 1] + PERIOD * (u[k - 1] - 100.0 * v[k - 1]) / 20.0
    log = written(tmp_path / "levels.csv", "time [s],push [N],pos x [mm]", PERIOD * np.arange(v.size), u, 1e3 * PERIOD * np.cumsum(v))
    out = tmp_path / "axis.toml"
    found = found_by([log, "--column", "force.x=push", "--model", "friction", "--out", str(out)], capsys, code=1)
    assert any(said in remark for remark in found["remarks"]) and not out.exists()


def test_friction_that_rises_is_not_called_stribeck(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = jogged(tmp_path, lambda v: np.sign(v) * (0.6 - 0.3 * np.exp(-((v / 0.06) ** 2))) + 3.0 * v)
    found = found_by([log, "--column", "command.x=cmd", "--model", "friction"], capsys)
    assert found["friction_model"] == "Coulomb, viscous and a rise"
    assert not any("Stribeck is what" in said or "and Stribeck" in said for said in found["remarks"])
    log = jogged(tmp_path, lambda v: np.sign(v) * (0.3 + 0.3 * np.exp(-((v / 0.03) ** 2))) + 3.0 * v)
    assert found_by([log, "--column", "command.x=cmd", "--model", "friction"], capsys)["friction_model"] == "Coulomb, viscous and Stribeck"


def test_friction_that_rises_from_rest_keeps_its_rise_in_the_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = jogged(tmp_path, lambda v: np.sign(v) * (0.6 - 0.3 * np.exp(-((v / 0.06) ** 2))) + 3.0 * v)
    out = tmp_path / "axis.toml"
    words = [log, "--column", "command.x=cmd", "--model", "friction", "--full-scale", "10 V", "--out", str(out)]
    found = found_by(words, capsys)
    figures = {name: one["value"] for name, one in found["parameters"].items()}
    assert figures["drop"] == pytest.approx(-0.03, rel=0.1) and any(said.startswith("concave") for said in found["remarks"])
    out.write_text(out.read_text() + PLANT.replace("10.1", "0"))
    axis = load_axis(out)
    friction, origins = axis.friction.values(), axis.friction.origins
    assert axis.friction.kind == "rising" and "mm/s" in out.read_text()
    assert (friction["coulomb"], friction["viscous"]) == pytest.approx((figures["Fc"], figures["Fv"]), rel=1e-4)
    assert friction["breakaway"] == pytest.approx(figures["Fc"] + figures["drop"], rel=1e-4)
    assert friction["rise_velocity"] == pytest.approx(figures["vs"], rel=1e-4)
    # At rest the curve is better known than its level at speed and the rise from there, which go together.
    assert origins["breakaway"].deviation < found["parameters"]["drop"]["deviation"]
    assert {frozenset(pair[:2]) for pair in axis.correlations} >= {frozenset(("friction.breakaway", "friction.rise_velocity"))}
    assert driven(tmp_path) < 0.2e-3


def test_a_curve_below_zero_at_rest_is_no_component(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = jogged(tmp_path, lambda v: np.sign(v) * (0.5 - 0.7 * np.exp(-((v / 0.06) ** 2))) + 3.0 * v)
    out = tmp_path / "friction.toml"
    words = [log, "--column", "command.x=cmd", "--model", "friction", "--full-scale", "10 V", "--out", str(out)]
    assert any("the curve is below zero at rest" in said for said in found_by(words, capsys)["remarks"])
    assert 'kind = "coulomb"' in out.read_text()


@pytest.mark.parametrize("model", ["rigid-by-direction", "friction"])
def test_friction_that_is_averaged_over_directions_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str) -> None:
    out = tmp_path / "axis.toml"
    if model == "friction":
        words = [jogged(tmp_path, lambda v: np.where(v > 0.0, 0.5 + 4.0 * v, -0.7 + 8.0 * v)), "--column", "command.x=cmd"]
    else:
        v = 0.05 * np.cos(2.0 * np.pi * 0.7 * TIME) + 0.04 * np.cos(2.0 * np.pi * 2.9 * TIME)
        force = 40.0 * np.gradient(v, PERIOD) + np.where(v > 0.0, 5.0 + 40.0 * v, -7.0 + 80.0 * v)
        place = 1e3 * PERIOD * np.cumsum(v)
        words = [written(tmp_path / "log.csv", "time [s],cmd [V],pos x [mm]", TIME, 0.1 * force, place), "--column", "command.x=cmd"]
    assert main(["identify", *words, "--model", model, "--gain", "10 N/V", "--out", str(out)]) == 0
    said = next(line for line in capsys.readouterr().out.splitlines() if "one friction for both directions" in line)
    assert said.removeprefix("note: ") in out.read_text()
    assert re.search(r"Fv [\d.]+ N\*s/m of [\d.]+ forwards and [\d.]+ backwards, 6\d % apart", said)


@pytest.mark.parametrize(
    ("model", "more", "files", "labels"),
    [
        ("friction", ["--full-scale", "10 V"], ["friction", "residual"], ["mean command [full_scale]", "residual [full_scale]"]),
        ("frequency-response", [], ["bode"], ["velocity [mm/s/V]", "phase [deg]", "coherence"]),
    ],
)
def test_pictures_have_points_labels_and_a_folder(
    shared: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str, more: list[str], files: list[str], labels: list[str]
) -> None:
    name = "friction_*_mmps.mat" if model == "friction" else "sine_[13457]0Hz.mat"
    logs = sorted(str(file) for file in (shared / "data" / "ubc-xy-table").glob(name))
    assert main(["identify", *logs, *UBC, "--model", model, *more, "--plots", "svg", "--folder", str(tmp_path / "seen")]) == 0
    assert sorted(file.stem for file in (tmp_path / "seen" / "plots").iterdir()) == files
    drawn = "".join((tmp_path / "seen" / "plots" / f"{file}.svg").read_text() for file in files)
    assert all(f">{label}<" in drawn for label in labels) and ">measured, two deviations<" in drawn
    assert f"plot: {tmp_path / 'seen' / 'plots' / files[0]}.svg" in capsys.readouterr().out


def test_a_file_that_was_asked_for_and_is_not_written_is_no_success(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "axis.toml"
    out.write_text("of another day")
    words = [stepped(tmp_path, "V", 10.0), "--column", "command.x=cmd", "--model", "frequency-response"]
    assert main(["identify", *words]) == 0
    assert main(["identify", *words, "--out", str(out)]) == 1
    assert "is not written: there is nothing for an axis file" in capsys.readouterr().out and out.read_text() == "of another day"
