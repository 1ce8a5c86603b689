"""Play between a motor and a load that has inertia: the interval of the answer holds the truth."""

import math
from dataclasses import replace

import made_commission as bench
import numpy as np
import pytest
from made_two_masses import TwoMasses, drawn

from contourlab.features.commission.command import planned_commands
from contourlab.features.commission.excitation import excitation
from contourlab.features.commission.identification import IdentifiedAxis, identify_axis, lost_motion_at_motor, play_at_load
from contourlab.features.commission.loop import GAINS, AxisModel, Law
from contourlab.features.commission.records import AxisLog, moving
from contourlab.features.commission.setup import Setup, read_setup

PLAY = 30e-6


@pytest.fixture(scope="module")
def setup(tmp_path_factory: pytest.TempPathFactory) -> Setup:
    folder = tmp_path_factory.mktemp("machine")
    return read_setup(*bench.Rig().write(folder))


@pytest.fixture(scope="module")
def command(setup: Setup, tmp_path_factory: pytest.TempPathFactory) -> np.ndarray:
    program = tmp_path_factory.mktemp("program") / "excite.ngc"
    program.write_text(excitation(setup))
    return planned_commands(program, setup)["x"]


def log_of(plant: TwoMasses, setup: Setup, command: np.ndarray, noise: float = bench.NOISE, load: bool = True) -> AxisLog:
    """Return the log of an axis; motor and load have the same counts and noise."""
    generator = np.random.default_rng(1)
    motor_noise, load_noise = generator.uniform(-noise, noise, (2, command.size))
    motor, output, moved = plant.with_load(command, setup.axes[0].gains, bench.PERIOD, motor_noise)
    seen = moved + load_noise
    seen = plant.count * np.round(seen / plant.count) if plant.count else seen
    return moving(AxisLog("log.csv", "x", bench.PERIOD, command, motor, output, seen if load else None))


def model_of(plant: TwoMasses) -> AxisModel:
    share = plant.load / (1.0 - plant.load)
    return AxisModel(plant.gain, plant.damping, sum(plant.frictions), resonance=plant.frequency, share=share)


MACHINES = {
    "friction at the load": TwoMasses(play=PLAY),
    "friction at the motor": TwoMasses(play=PLAY, frictions=(0.02, 0.006)),
    "damping at the load": TwoMasses(play=PLAY, damped=0.0),
    "light load": TwoMasses(play=PLAY, load=0.25),
    "counts, and friction that falls": TwoMasses(play=PLAY, breakaway=0.4, count=1e-6),
}


@pytest.mark.parametrize("frequency", [45.0, 90.0])
@pytest.mark.parametrize("machine", MACHINES)
def test_play_is_measured_at_the_load(setup: Setup, command: np.ndarray, machine: str, frequency: float) -> None:
    plant = replace(MACHINES[machine], frequency=frequency)
    play, deviation = play_at_load([log_of(plant, setup, command)], model_of(plant))
    assert play == pytest.approx(PLAY, abs=2e-6)
    assert abs(play - PLAY) < 2.0 * deviation < 5e-6


@pytest.mark.parametrize("frequency", [45.0, 90.0])
def test_a_load_that_swings_between_the_flanks_has_a_wide_interval(setup: Setup, command: np.ndarray, frequency: float) -> None:
    plant = TwoMasses(frequency=frequency, play=PLAY, frictions=(0.03, 3e-4))
    play, deviation = play_at_load([log_of(plant, setup, command)], model_of(plant))
    assert abs(play - PLAY) < 2.0 * deviation < PLAY
    assert math.isnan(lost_motion_at_motor([log_of(plant, setup, command)], model_of(plant), bench.NOISE)[0])


def test_the_load_decelerates_on_the_other_flank(setup: Setup, command: np.ndarray) -> None:
    """What the constant speed is for: the mean of all samples of a stroke would show half the play."""
    log = log_of(TwoMasses(frequency=90.0, play=PLAY), setup, command)
    assert log.load is not None
    rate = np.gradient(log.command, bench.PERIOD)
    slower = (np.gradient(np.abs(rate), bench.PERIOD) < -0.5) & (np.abs(rate) > 0.02)
    assert np.mean(np.sign(rate[slower]) * (log.measured - log.load)[slower]) < -0.3 * PLAY


@pytest.mark.parametrize("play", [0.0, 14e-6, PLAY])
def test_play_before_a_load_without_mass(setup: Setup, command: np.ndarray, play: float) -> None:
    log = log_of(TwoMasses(frequency=200.0, frictions=(0.03, 0.0), load=0.01), setup, command)
    log = replace(log, load=bench.behind(log.measured, play))
    found, deviation = play_at_load([log], AxisModel(2.0, 25.0, 0.03))
    assert found == pytest.approx(play, abs=5e-7)
    assert deviation < 1e-6


@pytest.mark.parametrize("frequency", [45.0, 90.0, 200.0])
@pytest.mark.parametrize("machine", MACHINES)
def test_what_the_motor_shows_of_play_holds_it(setup: Setup, command: np.ndarray, machine: str, frequency: float) -> None:
    plant = replace(MACHINES[machine], frequency=frequency)
    log = log_of(plant, setup, command, load=False)
    play, deviation = lost_motion_at_motor([log], model_of(plant), math.hypot(bench.NOISE, plant.count) / math.sqrt(12.0))
    assert abs(play - PLAY) < 2.0 * deviation < 0.16 * PLAY


@pytest.mark.slow
def test_intervals_of_random_machines_hold_their_play(setup: Setup, command: np.ndarray) -> None:
    off, at_motor = list[float](), list[float]()
    for seed in range(60):
        plant, noise = drawn(seed)
        log, model = log_of(plant, setup, command, noise), model_of(plant)
        play, deviation = play_at_load([log], model)
        off.append(abs(play - plant.play) / deviation)
        play, deviation = lost_motion_at_motor([log], model, math.hypot(noise / math.sqrt(3.0), plant.count / math.sqrt(12.0)))
        at_motor += [] if math.isnan(play) else [abs(play - plant.play) / deviation]
    assert max(off) < 2.0
    assert len(at_motor) >= 5
    assert max(at_motor) < 3.0


@pytest.mark.slow
@pytest.mark.parametrize("frequency", [45.0, 90.0])
def test_an_identified_axis_knows_its_play(setup: Setup, command: np.ndarray, frequency: float, monkeypatch: pytest.MonkeyPatch) -> None:
    bench.fitted_once(monkeypatch)
    present = np.array([setup.axes[0].gains[name] / setup.unit for name in GAINS])
    for load, code in ((True, "CL892"), (False, "CL862")):
        log = log_of(TwoMasses(frequency=frequency, play=PLAY), setup, command, load=load)
        axis = identify_axis([log], present, Law(bench.PERIOD))
        assert isinstance(axis, IdentifiedAxis)
        assert abs(axis.play - PLAY) < min(2e-6, 2.0 * axis.play_deviation), load
        assert code in {one.code for one in axis.findings}
