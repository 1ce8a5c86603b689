"""Frequency responses of plants with known models, through noise, in open and closed loop; drives fitted to them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from axis_bench import driven
from numpy.typing import NDArray
from refusals import refuses

from contourlab.analysis.identification.drive_fit import (
    damping_ratio,
    fit_linear_motor,
    fit_two_inertia,
    held_response,
    linear_motor,
    load_side,
    resonances,
    two_inertia,
)
from contourlab.analysis.identification.frequency_response import (
    Measured,
    MeasuredResponse,
    is_sweep,
    periodic_response,
    repeating,
    sine_point,
    sine_responses,
    sine_stretch,
    spectral_response,
    swept_response,
)
from contourlab.components.drive.saturation import DelayedSaturation
from contourlab.components.plant.plant import MassDamper
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.errors import ParameterError

Array = NDArray[np.float64]
PERIOD = 5e-4
MASS, DAMPING = 20.0, 300.0
TRUE = {"M": MASS, "B": DAMPING, "delay": 0.0}
PLANT = MassDamper(mass=MASS, damping=DAMPING, force_constant=1.0)
DRIVE = TwoInertia(motor_inertia=5e-4, load_inertia=4e-4, lead=0.01, stiffness=200.0, shaft_damping=0.02, motor_damping=0.01)
TURN = 2.0 * math.pi / 0.01


def random_command(n: int, size: float = 20.0, seed: int = 0) -> Array:
    return size * np.random.default_rng(seed).normal(size=n)


def multisine(period: int, count: int, highest: int, size: float) -> Array:
    phases = np.exp(2j * np.pi * np.random.default_rng(1).random(highest))
    one = np.fft.irfft(np.r_[0.0, phases, np.zeros(period // 2 - highest)], period)
    return np.tile(size * one / one.std(), count)


def chirp(n: int, size: float = 20.0) -> Array:
    t = PERIOD * np.arange(n)
    return size * np.sin(2.0 * np.pi * (0.5 * t + 0.5 * 80.0 * t**2 / t[-1]))


def noise(n: int, size: float, seed: int = 5) -> Array:
    return size * np.random.default_rng(seed).normal(size=n)


def apart(found: MeasuredResponse, true: dict[str, float], low: float, high: float) -> Array:
    """Return measured over true response, minus one, in a band [Hz]."""
    kept = (found.frequency >= low) & (found.frequency <= high)
    expected = held_response(lambda s: linear_motor(true, s), found.frequency[kept], found.period)
    return np.abs(found.response[kept] / expected - 1.0)


def mean_ratio(found: MeasuredResponse, low: float, high: float) -> complex:
    """Return measured over true response, averaged over a band: scatter averages out, bias stays."""
    kept = (found.frequency >= low) & (found.frequency <= high)
    return complex(np.mean(found.response[kept] / held_response(lambda s: linear_motor(TRUE, s), found.frequency[kept], found.period)))


def test_a_sweep_is_distinguished_from_noise() -> None:
    assert is_sweep(chirp(8000)) and not is_sweep(random_command(8000)) and not is_sweep(multisine(2000, 4, 300, 1.0))


@pytest.mark.parametrize("excitation", [random_command(40_000), chirp(40_000), multisine(4000, 10, 600, 20.0)])
def test_the_response_of_a_mass_is_found_in_open_loop(excitation: Array) -> None:
    place = driven(PLANT, excitation, PERIOD) + noise(excitation.size, 1e-8)
    run = Measured(PERIOD, excitation, place)
    repeated = repeating(excitation)
    assert repeated == ((4000, slice(0, 40_000)) if excitation[4000] == excitation[0] else None)
    found = periodic_response(run, 4000) if repeated else swept_response(run) if is_sweep(excitation) else spectral_response([run])
    assert float(np.median(apart(found, TRUE, 5.0, 60.0))) < 0.02
    assert float(np.median(found.coherence[(found.frequency > 5.0) & (found.frequency < 60.0)])) > 0.95
    fit = fit_linear_motor(found)
    assert (fit["M"], fit["B"]) == pytest.approx((MASS, DAMPING), rel=0.02)
    assert fit.usable and fit["delay"] < 0.2 * PERIOD


def test_a_stop_at_the_end_does_not_bias_a_periodic_response() -> None:
    u = multisine(4000, 6, 600, 20.0)
    u[-150:] -= 40.0
    run = Measured(PERIOD, u, driven(PLANT, u, PERIOD))
    repeated = repeating(u)
    assert repeated == (4000, slice(0, 24_000 - 150))
    fit = fit_linear_motor(periodic_response(run.part(repeated[1]), 4000))
    assert (fit["M"], fit["B"]) == pytest.approx((MASS, DAMPING), rel=1e-3)


def test_deviations_of_the_response_are_correct() -> None:
    inside = []
    for seed in range(6):
        u = random_command(20_000, seed=seed)
        place = driven(PLANT, u, PERIOD) + noise(u.size, 2e-6, 100 + seed)
        found = spectral_response([Measured(PERIOD, u, place)])
        kept = (found.frequency > 10.0) & (found.frequency < 60.0)
        expected = held_response(lambda s: linear_motor(TRUE, s), found.frequency[kept], PERIOD)
        size = np.log(np.abs(found.response[kept] / expected))
        inside.append(np.mean(np.abs(size) < 2.0 * found.deviation[kept]))
    assert 0.85 < float(np.mean(inside)) <= 1.0


def closed_loop(n: int, disturbance: float, seed: int = 2) -> tuple[Measured, Array]:
    """Return a hand-written position loop: a mass under PD, a random reference, and noise that the loop feeds back."""
    rng = np.random.default_rng(seed)
    reference = np.repeat(rng.uniform(-1e-3, 1e-3, n // 20), 20)
    felt = disturbance * rng.normal(size=n)
    p, v, last = 0.0, 0.0, 0.0
    u, y = np.zeros(n), np.zeros(n)
    e = math.exp(-DAMPING / MASS * PERIOD)
    gained = (1.0 - e) / DAMPING
    for k in range(n):
        y[k] = p + felt[k]
        u[k] = 4e4 * (reference[k] - y[k]) - 600.0 * (y[k] - last) / PERIOD
        last = y[k]
        p += MASS / DAMPING * (1.0 - e) * v + u[k] / DAMPING * (PERIOD - gained * MASS)
        v = e * v + gained * u[k]
    return Measured(PERIOD, u, y, reference), reference


def test_noise_in_the_feedback_biases_the_direct_method_and_not_the_joint_one() -> None:
    run, _ = closed_loop(60_000, 3e-5)
    joint = spectral_response([run])
    direct = spectral_response([Measured(PERIOD, run.command, run.position)])
    band = (20.0, 60.0)
    good, biased = (abs(mean_ratio(found, *band) - 1.0) for found in (joint, direct))
    assert good < 0.03 and biased > 3.0 * good
    assert joint.method.count("reference") == 2 and "reference" not in direct.method
    assert fit_linear_motor(joint)["M"] == pytest.approx(MASS, rel=0.05)


def test_one_sine_per_run() -> None:
    """Sines on a moving axis, as on a test bench: rest, a run-up, the sine, rest."""
    runs, frequencies = [], (4.0, 11.0, 30.0, 73.0, 150.0)
    for frequency in frequencies:
        t = PERIOD * np.arange(6000)
        on = (t >= 0.6) & (t < 2.4)
        u = np.where(t > 0.2, 30.0, 0.0) + np.where(on, 15.0 * np.sin(2.0 * np.pi * frequency * (t - 0.6)), 0.0)
        delayed = driven(PLANT, u, PERIOD, drive=DelayedSaturation(limit=1e3, delay=1.5e-3))
        runs.append(Measured(PERIOD, u, delayed + noise(t.size, 1e-8)))
        stretch = sine_stretch(u, PERIOD)
        assert stretch is not None and stretch[2] == pytest.approx(frequency, rel=1e-4)
        point = sine_point(runs[-1], *stretch)
        assert point.distortion < 0.02 and point.still == 0.0
    found = sine_responses(runs, [f"{f:g} Hz" for f in frequencies])
    assert found.frequency == pytest.approx(frequencies, rel=1e-4)
    fit = fit_linear_motor(found)
    assert (fit["M"], fit["B"]) == pytest.approx((MASS, DAMPING), rel=0.02)
    assert fit["delay"] == pytest.approx(1.5e-3, rel=0.02)
    # A log that keeps every fifth sample does not lengthen the hold of the drive.
    thin = Measured(5.0 * PERIOD, runs[0].command[::5], runs[0].position[::5])
    mixed = sine_responses([thin, *runs[1:]], [f"{f:g} Hz" for f in frequencies])
    assert mixed.period == PERIOD and "CL542" in {one.code for one in mixed.findings}
    assert mixed.response == pytest.approx(found.response, rel=2e-2)


def test_a_sine_with_a_stuck_axis_is_left_out_and_harmonics_are_reported() -> None:
    t = PERIOD * np.arange(8000)
    u = 30.0 * np.sin(2.0 * np.pi * 2.0 * t)
    place = driven(PLANT, u, PERIOD)
    stopped = np.minimum(place, 0.5 * place.max())
    with pytest.raises(ParameterError, match=r"stop.*still"):
        sine_responses([Measured(PERIOD, u, stopped)], ["end stop"])
    bent = place + 0.08 * float(np.ptp(place)) * np.sin(2.0 * np.pi * 4.0 * t)
    found = sine_responses([Measured(PERIOD, u, bent)], ["bent"])
    assert found.distortion[0] > 0.1 and "CL524" in {one.code for one in found.findings}
    assert sine_stretch(random_command(4000), PERIOD) is None
    assert sine_stretch(np.zeros(4000), PERIOD) is None
    assert sine_stretch(chirp(4000), PERIOD) is None


@pytest.mark.parametrize("how", ["noise", "multisine"])
def test_two_inertias_are_identified_at_the_motor(how: str) -> None:
    period = 2.5e-4
    u = random_command(40_000, 0.3) if how == "noise" else multisine(2000, 12, 900, 0.4)
    place = driven(DRIVE, u, period, "motor_position") + noise(u.size, 1e-7)
    run = Measured(period, TURN * u, place)
    fit = fit_two_inertia(spectral_response([run]) if how == "noise" else periodic_response(run, 2000))
    true = {"motor_mass": 5e-4, "load_mass": 4e-4, "stiffness": 200.0, "shaft_damping": 0.02, "damping": 0.01}
    for name, value in true.items():
        assert fit[name] == pytest.approx(value * TURN**2, rel=0.02), name
    assert fit.usable and fit.fit > 85.0
    x = fit.estimate.parameters
    resonance = math.sqrt(200.0 * (1.0 / 5e-4 + 1.0 / 4e-4)) / (2.0 * math.pi)
    assert resonances(x) == pytest.approx((resonance, math.sqrt(200.0 / 4e-4) / (2.0 * math.pi)), rel=5e-3)


def test_the_load_side_identifies_only_the_total_mass_and_the_resonance() -> None:
    period = 2.5e-4
    u = multisine(2000, 12, 900, 0.4)
    place = driven(DRIVE, u, period) + noise(u.size, 1e-7)
    fit = fit_two_inertia(periodic_response(Measured(period, TURN * u, place), 2000), "load")
    assert fit["mass"] == pytest.approx(9e-4 * TURN**2, rel=0.02)
    assert fit["resonance"] == pytest.approx(151.0, rel=0.01)
    assert "CL539" in {one.code for one in fit.findings}


@pytest.mark.parametrize("share", [0.2, 0.5, 0.8])
def test_from_the_load_the_damping_ratio_is_the_resonance_s_own(share: float) -> None:
    """Wherever the damping acts, and for any mass share of the load, the response is that of mass, damping and one resonance."""
    s = 2j * np.pi * np.linspace(2.0, 200.0, 100)
    for shaft, damping in ((100.0, 0.0), (0.0, 500.0), (100.0, 500.0)):
        x = {
            "motor_mass": 120.0 * (1.0 - share),
            "load_mass": 120.0 * share,
            "stiffness": 5.7e6,
            "shaft_damping": shaft,
            "damping": damping,
        }
        seen = {"mass": 120.0, "resonance": resonances(x)[0], "damping_ratio": damping_ratio(x), "damping": damping, "delay": 0.0}
        w, load = 2.0 * np.pi * seen["resonance"], x["load_mass"] / x["motor_mass"]
        own, late = shaft * 120.0 / (2.0 * w * x["motor_mass"] * x["load_mass"]), damping * load / (120.0 * w**2)
        assert seen["damping_ratio"] == pytest.approx(own + 0.5 * w * late, rel=0.01)
        # The motor's part of the ratio has no lead, so it counts as additional delay.
        assert load_side({**seen, "delay": late}, s) == pytest.approx(two_inertia(x, s, "load"), rel=0.03)


def test_one_mass_is_not_identified_as_two() -> None:
    u = random_command(12_000)
    place = driven(PLANT, u, PERIOD) + noise(u.size, 1e-7)
    found = spectral_response([Measured(PERIOD, u, place)])
    try:
        fit = fit_two_inertia(found)
    except ParameterError as error:
        assert "apart" in str(error) or "shows" in str(error)
    else:
        assert not fit.usable and fit.findings


def test_faults_are_reported() -> None:
    u = random_command(4000)
    place = driven(PLANT, u, PERIOD)
    for arguments, said in (
        ((PERIOD, u, place[:-1]), "long as"),
        ((PERIOD, u, np.where(place > 0.0, np.nan, place)), "finite"),
        ((PERIOD, np.zeros(4000), place), "throughout"),
    ):
        with pytest.raises(ParameterError, match=said):
            Measured(*arguments)
    with refuses(ParameterError, r"\b256\b", name="record", value="100 samples"):
        spectral_response([Measured(PERIOD, u[:100], place[:100])])
    with refuses(ParameterError, "sign", name="M"):
        fit_linear_motor(spectral_response([Measured(PERIOD, u, -place)]))
    with refuses(ParameterError, "noise", name="frequency", value="0 points"):
        fit_linear_motor(spectral_response([Measured(PERIOD, u, noise(4000, 1.0))]))
