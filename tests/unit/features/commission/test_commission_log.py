"""Position loops from logs of any control: figures of a cascade that is simulated here, in the terms of each control."""

import json
from pathlib import Path

import numpy as np
import pytest

import contourlab as cl
from contourlab.cli.main import main
from contourlab.features.commission.log_command import TERMS, terms_of_log
from contourlab.features.commission.log_loop import Bounds

PERIOD = 1e-3
TRUE = {"Kv": 30.0, "velocity_feedforward": 0.6, "equivalent_time": 0.0045}
"""Two ticks of dead time, a lag of 2 ms, and half a tick of hold."""


def moves(seed: int = 1) -> np.ndarray:
    """Return moves to and fro with ramps of many lengths [m]."""
    generator, parts = np.random.default_rng(seed), [np.zeros(100)]
    for way in (0.05, -0.02, 0.03, -0.06, 0.02, -0.03):
        velocity = np.ones(round(abs(way) / generator.uniform(0.05, 0.2) / PERIOD))
        for samples in (round(generator.uniform(40, 90)), round(generator.uniform(20, 40))):
            velocity = np.convolve(velocity, np.ones(samples))
        parts += [parts[-1][-1] + way * np.cumsum(velocity) / velocity.sum()]
        parts += [np.full(120, parts[-1][-1])]
    return np.concatenate(parts)


def cascade(reference: np.ndarray, weight: float = 0.6, held: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """Return position [m] and set velocity [m/s] of a P controller at each tick, two ticks late, before a lag; `held` [m/s] is friction."""
    lag, steps, waiting, place, speed = 2e-3, 10, [0.0, 0.0], 0.0, 0.0
    position, asked, fade = np.zeros(reference.size), np.zeros(reference.size), np.exp(-PERIOD / 10 / 2e-3)
    ahead = np.append(np.diff(reference), 0.0) / PERIOD
    for k, wanted in enumerate(reference):
        position[k] = place
        asked[k] = 30.0 * (wanted - place) + weight * ahead[k]
        waiting.append(asked[k])
        drive = waiting.pop(0)
        for _ in range(steps):
            way = np.sign(speed) if speed else np.sign(drive) * (abs(drive) > held)
            target = drive - held * way if way else 0.0
            later = target + (speed - target) * fade
            later = 0.0 if held and speed * later < 0.0 else later
            place += PERIOD / steps * target + lag * (speed - later)
            speed = later
    return position, asked


def written(file: Path, reference: np.ndarray, position: np.ndarray, *more: np.ndarray, heads: str = "") -> Path:
    noise = 2e-7 * np.random.default_rng(0).standard_normal(reference.size)
    columns = np.column_stack([PERIOD * np.arange(reference.size), 1e3 * reference, 1e3 * (position + noise), *more])
    np.savetxt(file, columns, delimiter=",", header=f"time [s],x cmd [mm],x pos [mm]{heads}", comments="", fmt="%.9g")
    return file


@pytest.fixture(scope="module")
def log(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a log with the set velocity in rpm of a screw with 10 mm a turn."""
    position, asked = cascade(reference := moves())
    return written(tmp_path_factory.mktemp("log") / "log.csv", reference, position, 6000.0 * asked, heads=",speed [V]")


@pytest.mark.slow
def test_figures_are_those_of_the_loop(log: Path) -> None:
    axis = cl.commission.log(log).axes["x"]
    for name, true in TRUE.items():
        figure = axis.figures[name]
        assert figure.low < true < figure.high
    assert axis.figures["Kv"].half < 0.15 * 30.0
    assert axis.figures["shown"].value == pytest.approx(30.0 / 0.4, rel=1e-3)
    assert axis.stays < 0.01


@pytest.mark.slow
def test_the_drive_command_narrows_the_gain(log: Path) -> None:
    answer = cl.commission.log(log, column="command.x=speed [V]", for_="twincat")
    gain = answer.axes["x"].figures["Kv"]
    assert gain.low < 30.0 < gain.high and gain.half < 0.05 * 30.0
    assert answer.axes["x"].figures["drive_gain"].value == pytest.approx(1.0 / 6000.0, rel=0.01)
    assert "CL946" in {finding.code for finding in answer.findings}


@pytest.mark.slow
def test_friction_is_seen_at_reversals(tmp_path: Path) -> None:
    position, _ = cascade(reference := moves(), held=3e-4)
    friction = cl.commission.log(written(tmp_path / "log.csv", reference, position), for_="cia402").axes["x"].figures["friction_offset"]
    assert friction.low < 1e-5 < friction.high and friction.half < 1e-6


@pytest.mark.slow
def test_a_torque_command_shows_the_mass(tmp_path: Path) -> None:
    """A velocity loop of 500 1/s before 40 kg: the force is that of the acceleration, and friction."""
    position, _ = cascade(reference := moves())
    speed = np.gradient(position, PERIOD)
    force = 40.0 * np.gradient(speed, PERIOD) + 12.0 * np.sign(np.where(np.abs(speed) > 1e-5, speed, 0.0))
    log = written(tmp_path / "log.csv", reference, position, force, heads=",force [N]")
    answer = cl.commission.log(log, column="force.x=force [N]", for_="sinumerik")
    assert answer.axes["x"].figures["mass"].value == pytest.approx(40.0, rel=0.03)


def with_integral(reference: np.ndarray, weight: float, ticks: int) -> tuple[np.ndarray, np.ndarray]:
    """Return position and set velocity under a gain of 30 1/s with an integral of 5 1/s, some ticks late, before a lag of 3 ms."""
    place, speed, drift, waiting = 0.0, 0.0, 0.0, [0.0] * ticks
    position, asked = np.zeros(reference.size), np.zeros(reference.size)
    ahead = np.append(np.diff(reference), 0.0) / PERIOD
    for k, wanted in enumerate(reference):
        position[k] = place
        drift += 150.0 * (wanted - place) * PERIOD
        asked[k] = 30.0 * (wanted - place) + drift + weight * ahead[k]
        waiting.append(asked[k])
        drive = waiting.pop(0)
        later = drive + (speed - drive) * np.exp(-PERIOD / 3e-3)
        place += PERIOD * drive + 3e-3 * (speed - later)
        speed = later
    return position, asked


@pytest.mark.slow
def test_an_integral_is_not_taken_for_feedforward(tmp_path: Path) -> None:
    """From positions a gain six times too low explains the log as well: none is given. The drive command tells gain and integral."""
    position, asked = with_integral(reference := moves(), 0.0, 0)
    log = written(tmp_path / "log.csv", reference, position, 1e3 * asked, heads=",speed [V]")
    answer = cl.commission.log(log)
    assert "CL947" in {finding.code for finding in answer.findings}
    assert not answer.passed and not {"shown", "velocity_feedforward"} & set(answer.axes["x"].figures)
    x = cl.commission.log(log, column="command.x=speed [V]").axes["x"].figures
    for name, true in {"Kv": 30.0, "reset": 5.0, "velocity_feedforward": 0.0, "equivalent_time": 3.5e-3}.items():
        assert x[name].low < true < x[name].high


@pytest.mark.slow
def test_an_integral_behind_a_dead_time_shows_in_the_positions(tmp_path: Path) -> None:
    position, _ = with_integral(reference := moves(), 0.4, 3)
    x = cl.commission.log(written(tmp_path / "log.csv", reference, position)).axes["x"].figures
    for name, true in {"Kv": 30.0, "reset": 5.0, "velocity_feedforward": 0.4, "equivalent_time": 6.5e-3}.items():
        assert x[name].low < true < x[name].high


@pytest.mark.slow
def test_a_command_of_no_linear_law_gives_no_gain(tmp_path: Path) -> None:
    position, asked = cascade(reference := moves())
    log = written(tmp_path / "log.csv", reference, position, np.sign(asked) * np.abs(asked) ** 0.7, heads=",speed [V]")
    answer = cl.commission.log(log, column="command.x=speed [V]")
    assert "CL944" in {finding.code for finding in answer.findings}
    assert not answer.passed and not {"Kv", "velocity_feedforward"} & set(answer.axes["x"].figures)


@pytest.mark.slow
def test_a_control_of_2_ms_with_a_late_feedforward(tmp_path: Path) -> None:
    """Six ms of dead time, and the velocity of the last tick as feedforward."""
    tick, steps, place, speed, waiting = 2e-3, 20, 0.0, 0.0, [0.0] * 3
    reference = np.interp(np.arange(0, moves().size, 2), np.arange(moves().size), moves())
    position = np.zeros(reference.size)
    for k, wanted in enumerate(reference):
        position[k] = place
        waiting.append(40.0 * (wanted - place) + 0.9 * (wanted - reference[max(k - 1, 0)]) / tick)
        drive = waiting.pop(0)
        for _ in range(steps):
            later = drive + (speed - drive) * np.exp(-tick / steps / 3e-3)
            place += tick / steps * drive + 3e-3 * (speed - later)
            speed = later
    table = np.column_stack([tick * np.arange(reference.size), 1e3 * reference, 1e3 * np.round(position, 7)])
    np.savetxt(tmp_path / "log.csv", table, delimiter=",", header="time [s],x cmd [mm],x pos [mm]", comments="", fmt="%.9g")
    assert "CL947" in {finding.code for finding in cl.commission.log(tmp_path / "log.csv").findings}
    x = cl.commission.log(tmp_path / "log.csv", proportional=True).axes["x"].figures
    for name, true in {"Kv": 40.0, "velocity_feedforward": 0.9, "equivalent_time": 0.010}.items():
        assert name not in x or x[name].low < true < x[name].high
    assert {"Kv", "equivalent_time"} & set(x)


def test_one_velocity_determines_no_loop(tmp_path: Path) -> None:
    """Not even how far it follows: the encoder may have another zero."""
    steady = 0.02 * PERIOD * np.arange(1500)
    answer = cl.commission.log(written(tmp_path / "log.csv", steady, steady - 0.02 / 25.0))
    assert not answer.passed
    axis = answer.axes["x"]
    assert not axis.figures
    assert all(np.isnan(term.value.value) and np.isnan(term.proposed) for term in axis.terms)
    assert {"CL940", "CL593"} < {finding.code for finding in answer.findings}


def test_exchanged_columns_give_no_loop(tmp_path: Path) -> None:
    position, _ = cascade(reference := moves())
    answer = cl.commission.log(written(tmp_path / "log.csv", position, reference))
    assert "CL942" in {finding.code for finding in answer.findings} and not answer.axes["x"].figures


def test_terms_have_the_units_of_their_control() -> None:
    figures = {"Kv": Bounds(25.0, 20.0, 30.0), "velocity_feedforward": Bounds(0.5, 0.4, 0.6), "equivalent_time": Bounds(4e-3, 3e-3, 5e-3)}
    shown = {control: {term.name: term for term in terms_of_log(control, figures)} for control in TERMS}
    gain = shown["sinumerik"]["MD32200 POSCTRL_GAIN"]
    assert (gain.unit, gain.value.value, gain.value.low) == ("1000/min", pytest.approx(1.5), pytest.approx(1.2))
    assert shown["sinumerik"]["MD32810 EQUIV_SPEEDCTRL_TIME"].proposed == pytest.approx(0.004)
    assert shown["sinumerik"]["MD32620 FFW_MODE"].proposed == 3.0
    assert shown["twincat"]["Proportional Factor Ka"].proposed == pytest.approx(0.004)
    assert shown["twincat"]["Pre-Control Weighting"].proposed == 1.0
    assert shown["generic"]["velocity feedforward"].value.value == pytest.approx(50.0)
    assert shown["cia402"]["0x60B1 velocity offset"].value.high == pytest.approx(0.6)


@pytest.mark.slow
def test_as_typed(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["commission", "log", str(log), "--for", "twincat", "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["control"] == "twincat"
    assert answer["axes"]["x"]["figures"]["Kv"]["low"] < 30.0 < answer["axes"]["x"]["figures"]["Kv"]["high"]
    assert main(["commission", "log", str(log), "--for", "twincat"]) == 0
    out = capsys.readouterr().out
    assert max(map(len, out.splitlines())) <= 80


def test_bad_input_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    reference = moves()
    for words in (["--for", "fanuc"], ["--axis", "q"]):
        assert main(["commission", "log", str(written(tmp_path / "log.csv", reference, 0.99 * reference)), *words]) == 2
    backwards = written(tmp_path / "back.csv", reference, -reference)
    assert main(["commission", "log", str(backwards)]) == 2
    assert "follow" in capsys.readouterr().err
