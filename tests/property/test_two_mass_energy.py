"""Energy and soundness of the two-mass drive: the stored energy rises at most by the motor's work, for any events in a step."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from two_mass_rig import DRIVE, NONE, Drive, energy, gains, half_gap, random_command

from contourlab.components.friction.laws import Coulomb
from contourlab.components.plant.two_inertia import TwoInertia

Array = NDArray[np.float64]
ROUNDING = 1e-13
"""Allowed rise of the energy relative to its terms: some hundred roundings."""
BLOCK = 125_000

RUBBING = Coulomb(coulomb=60.0, breakaway=60.0, viscous=100.0)
STICKY = Coulomb(coulomb=50.0, breakaway=80.0, stribeck_velocity=5e-3)
SLIPPERY = Coulomb(coulomb=0.0)
WAVY = {"gap_profile": (1.0, 3.0, 0.0), "profile_start": -0.02, "profile_step": 0.017}
DRIVES = {
    "without losses": Drive(TwoInertia(**DRIVE), period=1e-4),
    "without losses, coarse": Drive(TwoInertia(**DRIVE), period=5e-4),
    "1 um": Drive(TwoInertia(**{**DRIVE, "backlash_gap": 1e-6}), period=2e-4),
    "no gap": Drive(TwoInertia(**{**DRIVE, "backlash_gap": 0.0}), period=5e-4),
    "200 um, friction on the load": Drive(TwoInertia(**{**DRIVE, "backlash_gap": 2e-4}), STICKY, SLIPPERY, period=5e-4),
    "friction on the motor": Drive(TwoInertia(**DRIVE), SLIPPERY, STICKY, period=2e-4),
    "friction on both": Drive(TwoInertia(**DRIVE), RUBBING, STICKY, period=1e-4),
    "friction on both, coarse": Drive(TwoInertia(**DRIVE), STICKY, RUBBING, period=5e-4),
    "damped, friction on both": Drive(TwoInertia(**DRIVE, shaft_damping=0.3), RUBBING, STICKY, period=2e-4),
    "dead zone, damped, friction on both": Drive(TwoInertia(**DRIVE, shaft_damping=0.3, contact_model="dead-zone"), RUBBING, STICKY),
    "gap that varies, friction on both": Drive(TwoInertia(**DRIVE, **WAVY), RUBBING, STICKY, period=2e-4),
    "gap that varies, damped": Drive(TwoInertia(**DRIVE, shaft_damping=0.1, load_damping=0.1, **WAVY), period=2e-4),
}


def scale(plant: TwoInertia, run: dict[str, Array], command: Array) -> Array:
    """Return the size of the terms in the energy of each tick but the first [J]."""
    d, held = plant.constants(), energy(plant, run)
    place = np.abs(run["motor_position"]) + d.half_gap
    pushed = np.abs(d.force_value * command) + np.abs(run["shaft_force"]) + np.sqrt(2.0 * held * d.stiffness_value)
    return np.asarray((held + held.max() * 1e-3 + pushed * place)[1:])


def check(drive: Drive, run: dict[str, Array], command: Array) -> None:
    plant, d = drive.plant, drive.plant.constants()
    assert all(np.isfinite(values).all() for values in run.values())
    assert (gains(plant, run, command) <= ROUNDING * scale(plant, run, command)).all()
    half = half_gap(plant, run["position"])
    tolerance = 1e-9 * d.half_gap + 8.0 * np.finfo(float).eps * np.abs(run["position"])
    theta, side = run["motor_position"] - run["position"], run["gap_state"]
    free = side == 0.0
    # In the gap no further than its flanks, the twist of a damped shaft aside; in contact beyond the flank by the compression.
    assert (np.abs(theta - run["twist_x"])[free] <= (half + tolerance)[free]).all()
    compression = side * theta - half
    if d.damper_value == 0.0 and not d.bonded:
        assert (compression[~free] >= -tolerance[~free]).all()
        pressing = np.where(free, 0.0, side * compression)
        assert (np.abs(run["shaft_force"] / d.stiffness_value - pressing) <= tolerance).all()
    if plant.contact_model == "physical" and not d.bonded:
        assert (run["shaft_force"] * side >= -d.stiffness_value * tolerance).all()


@pytest.mark.slow
@pytest.mark.parametrize("name", DRIVES)
def test_a_million_random_samples_are_sound(name: str) -> None:
    """Ten million over the twelve drives; forces of 1 N to 10 kN, held for 1 to 32 ticks, on a shaft that rings at 100 Hz."""
    drive, rng = DRIVES[name], np.random.default_rng(len(name))
    group, switches = drive.group(), 0
    for _ in range(7):
        command = random_command(rng, BLOCK, 5.0)
        run = drive.run(command, group=group)
        check(drive, run, command)
        switches += np.count_nonzero(np.diff(run["gap_state"]))
    assert switches > 1000 or drive.plant.constants().bonded


def sampled(seed: int, n: int, level: float) -> Array:
    return random_command(np.random.default_rng(seed), n, level)


@st.composite
def any_drive(draw: st.DrawFn, damped: bool, rubbing: bool) -> Drive:
    """Return a drive with light and heavy sides, stepped at up to half a radian of its shaft."""
    motor, load = (10.0 ** draw(st.floats(-5.0, -1.0)) for _ in range(2))
    stiffness, gap = 10.0 ** draw(st.floats(1.0, 4.0)), 10.0 ** draw(st.floats(-7.0, -3.0))
    fast = np.sqrt(stiffness * (1.0 / motor + 1.0 / load))
    ratio = draw(st.floats(0.01, 0.5)) if damped else 0.0
    plant = TwoInertia(
        motor_inertia=motor,
        load_inertia=load,
        lead=0.01,
        stiffness=stiffness,
        shaft_damping=2.0 * ratio * stiffness / fast,
        backlash_gap=gap,
        start_in_gap=draw(st.floats(-1.0, 1.0)),
        contact_model=draw(st.sampled_from(("physical", "dead-zone"))) if damped else "physical",
    )
    period = 0.5 / fast * draw(st.floats(0.02, 1.0))
    # A step resolves the drop from F_s to F_c.
    force, mobility = 10.0 ** draw(st.floats(-1.0, 3.0)), max(plant.mobilities())
    drop = max(1e-3, 5.0 * period * mobility * (force + 20.0 * plant.constants().stiffness_value * gap))
    some = (Coulomb(coulomb=force * draw(st.floats(0.0, 1.0)), breakaway=force, stribeck_velocity=drop) for _ in range(2))
    frictions = some if rubbing else (NONE, NONE)
    return Drive(plant, *frictions, period=period)


@settings(max_examples=100)
@given(drive=st.one_of(any_drive(damped=d, rubbing=r) for d in (False, True) for r in (False, True)), seed=st.integers(0, 2**32 - 1))
def test_no_drive_gains_energy(drive: Drive, seed: int) -> None:
    command = sampled(seed, 600, 10.0 * drive.plant.stiffness * drive.plant.backlash_gap)
    check(drive, drive.run(command), command)


@pytest.mark.parametrize("model", ["physical", "dead-zone"])
def test_damping_and_friction_dissipate_their_work(model: str) -> None:
    """The lost energy is the work of viscous and dry friction and of the shaft's damper, each computed separately."""
    plant = TwoInertia(**DRIVE, shaft_damping=0.3, motor_damping=0.02, load_damping=0.03, contact_model=model)
    drive, command = Drive(plant, RUBBING, RUBBING, period=2e-6), np.repeat(sampled(5, 400, 3.0), 100)
    run = drive.run(command)
    d, missing = plant.constants(), -gains(plant, run, command)
    mean = {name: 0.5 * (run[name][1:] + run[name][:-1]) for name in ("motor_velocity", "velocity")}
    turn = 2.0 * np.pi / plant.lead
    viscous = 0.02 * turn**2 * mean["motor_velocity"] ** 2 + 0.03 * turn**2 * mean["velocity"] ** 2
    dry = sum(60.0 * np.abs(v) + 100.0 * v * v for v in mean.values())
    lag = d.stiffness_value * run["twist_x"] / d.damper_value
    rate = np.where(run["side_x"] == 0.0, lag, run["motor_velocity"] - run["velocity"])
    damper = d.damper_value * (0.5 * (rate[1:] + rate[:-1])) ** 2
    taken = 2e-6 * (viscous + dry + damper)
    assert missing.sum() == pytest.approx(taken.sum(), rel=1e-3)
    assert (missing >= -ROUNDING * scale(plant, run, command)).all()


def test_only_the_dead_zone_model_pulls_at_a_flank_that_it_leaves() -> None:
    """Nordin, Galic & Gutman: a flank can only push. In the dead zone a motor braked in contact leaves with the wrong torque sign."""
    command = np.r_[np.full(300, 2.0), np.full(100, -6.0)]
    pulls = {}
    for model in ("physical", "dead-zone"):
        run = Drive(TwoInertia(**DRIVE, shaft_damping=0.5, contact_model=model), period=2e-5).run(command)
        assert set(run["gap_state"]) >= {0.0, 1.0}
        pulls[model] = float((run["shaft_force"] * run["gap_state"]).min())
    assert pulls["physical"] == 0.0
    assert pulls["dead-zone"] < -10.0


def test_a_step_with_more_events_than_are_located_is_sound_and_of_second_order(monkeypatch: pytest.MonkeyPatch) -> None:
    """With a single stretch, the rest of the step handles each contact by evaluating the gap at every stage."""
    monkeypatch.setattr("contourlab.components.mechanics.two_mass_mechanics.STRETCHES", 1)
    command = sampled(3, 80, 3.0)
    exact = Drive(TwoInertia(**DRIVE), substeps=200).run(command)["position"]
    errors = []
    for n in (5, 10, 20, 40):
        run = Drive(TwoInertia(**DRIVE), substeps=n, jit=False).run(command)
        assert np.isfinite(run["position"]).all()
        errors.append(float(np.abs(run["position"] - exact).max()))
        worst = float((gains(TwoInertia(**DRIVE), run, command) / energy(TwoInertia(**DRIVE), run).max()).max())
        assert worst < 0.3 / n**2
    assert np.log2(errors[0] / errors[-1]) / 3.0 > 1.7


def test_many_tiny_bounces_and_stops_within_a_step_stay_sound() -> None:
    """A gap of a nanometre between sticking sides, in steps of half a radian: many stops, releases and contacts within a step."""
    plant = TwoInertia(**{**DRIVE, "backlash_gap": 1e-9})
    drive = Drive(plant, STICKY, RUBBING, period=7.5e-4)
    for seed in range(4):
        command = sampled(seed, 20_000, 0.3)
        check(drive, drive.run(command), command)


def test_a_body_that_turns_back_and_forth_within_a_step_is_not_pushed_by_its_friction() -> None:
    """A load at 1.5 um/s that a shaft pulls back and pushes on again within half a millisecond comes to rest in between."""
    plant, friction = TwoInertia(**DRIVE, load_damping=0.05), Coulomb(coulomb=60.0, breakaway=80.0)
    start = {
        "motor_position": 2.48281332e-3,
        "motor_velocity": 9.25077458e-4,
        "position": 2.47002462e-3,
        "velocity": 1.47055877e-6,
        "side": 1.0,
    }
    drive, command = Drive(plant, friction, SLIPPERY, period=5e-6), np.full(100, 1.4036516)
    fine = drive.run(command, **start)
    coarse = Drive(plant, friction, SLIPPERY, period=5e-4).run(command[:1], **start)
    assert (fine["velocity"] == 0.0).any()
    assert float(coarse["position"]) == pytest.approx(fine["position"][-1], abs=2e-9)
    check(drive, fine, command)


@pytest.mark.parametrize("model", ["physical", "dead-zone"])
@pytest.mark.parametrize("frictions", [(NONE, NONE), (RUBBING, STICKY)], ids=["free", "rubbing"])
def test_a_flank_that_is_pressed_on_is_not_left_and_bounces_die_out(frictions: tuple[Any, Any], model: str) -> None:
    """A steady force ends in steady contact: after the first bounces the side never changes again, at a coarse step as at a fine one."""
    plant = TwoInertia(**DRIVE, shaft_damping=0.1, motor_damping=0.05, load_damping=0.05, contact_model=model)
    counts = []
    for substeps in (1, 10):
        run = Drive(plant, *frictions, period=5e-4, substeps=substeps).run(np.repeat([2.0, -2.0, 2.0], 1000))
        for k, side in enumerate((1.0, -1.0, 1.0)):
            assert (run["gap_state"][1000 * k + 200 : 1000 * (k + 1)] == side).all()
        counts.append(np.count_nonzero(np.diff(run["gap_state"])))
    assert counts[0] == counts[1]


def test_a_load_at_rest_in_its_gap_stays_at_rest() -> None:
    """Friction holds both sides wherever they came to rest: nothing creeps, nothing changes."""
    drive = Drive(TwoInertia(**DRIVE), STICKY, STICKY, period=1e-4)
    run = drive.run(np.r_[random_command(np.random.default_rng(8), 4000, 0.3), np.zeros(30_000)])
    last = {name: values[-5000:] for name, values in run.items()}
    assert all(np.ptp(last[name]) == 0.0 for name in ("position", "motor_position", "gap_state", "shaft_force"))
