"""Rows of Shahin, ElMaraghy & ElBeheiry on stability, eq (17), servo periods and limit cycles."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import chain

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import MissingPackageError
from contourlab.papers.rows import Row, derived, identity, ours
from contourlab.papers.shahin import setup
from contourlab.papers.shahin.circle_criterion import circle_criterion
from contourlab.papers.shahin.common_lyapunov import CommonLyapunov, common_quadratic
from contourlab.papers.shahin.limit_cycle_cases import CASES, CASES_WITHOUT, compare
from contourlab.papers.shahin.lure_postnikov import energy_function
from contourlab.papers.shahin.servo_period import servo_period_limit
from contourlab.papers.shahin.two_inertia_loop import TwoInertias, motor_pid, two_inertia_loop

HALF_GAP = math.pi * 25e-6 / setup.LEAD
"""Half of 25 um as an angle of the motor [rad]."""
DRIVE = TwoInertias(setup.MOTOR_INERTIA, setup.LOAD_INERTIA, setup.STIFFNESS, HALF_GAP)
LAWS = {
    "I": motor_pid(1e4 * setup.MOTOR_INERTIA, 2e3 * setup.MOTOR_INERTIA),
    "II": motor_pid(1000.0, 200.0),
    "III": motor_pid(1000.0, 200.0, 25.0),
}
"""Table 2 under the stated reading: its columns exchanged."""
DAMPED = TwoInertias(setup.MOTOR_INERTIA, setup.LOAD_INERTIA, setup.STIFFNESS, HALF_GAP, load_damping=0.01, shaft_damping=0.1)


def theory_rows() -> Iterator[Row]:
    """Yield the rows."""
    return chain(_stability(), _rigid(), _pi_of_position(), _periods(), _limit_cycles())


def _stability() -> Iterator[Row]:
    loop = two_inertia_loop(DRIVE, LAWS["II"])
    case = "scheme II, gap and contact: 1 exists, 0 proved that none does"
    yield _common(case, [loop.gap_matrix, loop.contact_matrix], ("gap", "contact"), loop.names)[1]
    energy = energy_function(loop)
    yield ours("Lur'e-Postnikov function", "scheme II: 1 found, nan not", 1.0 if energy.p is not None else math.nan, "", str(energy))
    if energy.p is not None:
        # At rest, motor ahead by one gap width.
        start = np.zeros(loop.n)
        start[0] = 2.0 * HALF_GAP
        bound = energy.difference_bound(start) * setup.LEAD / (2.0 * math.pi)
        case = "scheme II, from the motor one whole gap ahead, at rest"
        yield ours("bound of motor less load", case, bound * 1e6, "um", "from the Lur'e-Postnikov function")
    linear = two_inertia_loop(DAMPED, LAWS["II"])
    words = "contact mode with 0.01 N m s/rad on the load and 0.1 in the shaft"
    alone, row = _common(words, [linear.contact_matrix], ("contact",), linear.names)
    yield row
    yield ours("alpha_1 of eq (17)", words, alone.overshoot, "", missing=row.missing)
    yield ours("alpha_2 of eq (17)", words, alone.rate, "1/s", missing=row.missing)
    for words, drive in (("no damping, as in the paper", DRIVE), ("0.01 N m s/rad on the load", replace(DRIVE, load_damping=0.01))):
        circle = circle_criterion(two_inertia_loop(drive, LAWS["II"]))
        decided = 1.0 if circle.verdict == "stable" else math.nan
        yield ours("circle criterion", f"scheme II, {words}: 1 stable, nan undecided", decided, "", str(circle))


def _rigid() -> Iterator[Row]:
    """Yield rows of eq (8), and of the rigid model (11) under the stated reading: J_m moves in the gap, J_m + J_l in contact."""
    growth = float(np.linalg.eigvals(DRIVE.a).real.max())
    note = "stable in the paper's words, but a position that nothing holds has eigenvalue 0, with damping too"
    yield identity("largest real part of an eigenvalue", "A_m and A_l of eq (8)", 0.0, growth, "1/s", 1e-9, note)
    both = np.array([DRIVE.motor_inertia, DRIVE.motor_inertia + DRIVE.load_inertia])
    for name, feedback in LAWS.items():
        position, rate, _, _, integral = (*feedback.gain, 0.0)[:5]
        n = 3 if integral else 2
        loops = [np.array([[0.0, 1.0, 0.0], [-position / j, -rate / j, -integral / j], [1.0, 0.0, 0.0]])[:n, :n] for j in both]
        yield _common(f"scheme {name} on the rigid model (11): 1 exists, 0 proved that none does", loops, ("gap", "contact"))[1]


def _common(case: str, matrices: list[Array], labels: tuple[str, ...], states: tuple[str, ...] = ()) -> tuple[CommonLyapunov, Row]:
    """Return the verdict on a common quadratic function, and its row, which says so if the solver is not installed."""
    missing = ""
    try:
        found = common_quadratic(matrices, labels, states)
    except MissingPackageError as error:
        missing = str(error)
        found = CommonLyapunov("undecided", None, math.nan, math.nan, (), missing)
    return found, ours("common quadratic Lyapunov function", case, _coded(found.verdict), "", str(found), missing=missing)


def _coded(verdict: str) -> float:
    return {"feasible": 1.0, "infeasible": 0.0}.get(verdict, math.nan)


def _pi_of_position() -> Iterator[Row]:
    """Yield the growth rate of eq (9) without derivative part on the rigid, undamped drive: J s^3 + K_P s + K_I is never stable."""
    inertia = setup.MOTOR_INERTIA + setup.LOAD_INERTIA
    for gain, integral in ((200.0, 25.0), (1000.0, 5000.0)):
        growth = float(np.roots([inertia, 0.0, gain, integral]).real.max())
        note = "the three roots sum to zero: the baseline must be a cascade"
        yield ours("growth of PI on the position alone, eq (9)", f"K_P {gain:g} N m/rad, K_I {integral:g} N m/(rad s)", growth, "1/s", note)


def _periods() -> Iterator[Row]:
    name, note = "largest stable servo period", "2 J_m/K: above it the held command reverses and enlarges the motor's rate in each period"
    for scheme, feedback in LAWS.items():
        gap, contact = servo_period_limit(DRIVE, feedback)
        held = 2.0 * setup.MOTOR_INERTIA / feedback.gain[1]
        yield derived(name, f"scheme {scheme} in the gap", held * 1e6, gap * 1e6, "us", 1e-3 * held * 1e6, note)
        yield ours(name, f"scheme {scheme} in contact", contact * 1e6, "us")
    printed = "Table 2 as printed"
    gap, contact = servo_period_limit(DRIVE, motor_pid(200.0, 1000.0))
    for mode, largest in (("in the gap", gap), ("in contact", contact)):
        yield ours(name, f"scheme II {mode}, {printed}", largest * 1e6, "us", reading=printed, main=False)


def _limit_cycles() -> Iterator[Row]:
    for case in (*CASES, *CASES_WITHOUT):
        found = compare(case)
        ratio = 0.0 if found.orbit is None else found.orbit.ratio
        off = "" if math.isnan(found.amplitude_error) else f" ({100.0 * found.amplitude_error:+.2g} %)"
        predicted = "none" if found.predicted is None else f"{found.predicted.ratio:.4g}{off}"
        note = f"describing function: {predicted}"
        yield ours("limit cycle, amplitude over half of the gap", case.name, ratio, "", note)
