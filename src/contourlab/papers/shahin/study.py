"""Rows of Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives".

A load without friction is chaotic in its gap: bands cover starts in contact and mid-gap, periods of 1, 2 and 4 us, ends at 4 and 10 s.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from contourlab.papers.rows import INPUT, Part, Row, derived, identity, ours, printed
from contourlab.papers.shahin import setup
from contourlab.papers.shahin.runs import circular, part_error, prepare, ramp
from contourlab.papers.shahin.setup import TO_FLANK, Setting
from contourlab.papers.shahin.theory import theory_rows

STATED = Setting()
READING = (
    "beta and its rate enter as +, for a motor ahead of its load, word for word; scheme I follows the reference in the gap; the columns of "
    "Table 2 exchanged; 25 um is the whole gap"
)
WORDS = "word for word"
READ = "total gap 25 um, motors on the forward flanks at the start"
BY_ACCELERATION = Setting(direction="acceleration")
AS_PRINTED = Setting(follows_load=True)
REDUCTION = {"II": 53.6, "III": 54.5}
NEAR = 0.05
SHORT = 4.0
"""End of the tests over feeds [s]."""
FEEDS = (1000.0, 2000.0, 4000.0, 6000.0, 8000.0, 10000.0)


def _circles() -> Iterator[Row]:
    """Yield the rows of all circular tests, run in parallel."""
    prepare(_needed())
    for part in (_tables, _baseline, _schemes, _readings, _feedrates, _over_feeds, _coupling):
        yield from part()


def _needed() -> list[tuple[Any, ...]]:
    """Return the arguments of `circular` for all rows."""
    settings = (STATED, TO_FLANK, BY_ACCELERATION)
    tests: list[tuple[Any, ...]] = [(name, setting) for setting in settings for name in setup.SCHEMES]
    baselines = ("PI", "PI with feedforward", "PI on the load")
    tests += [(name, setting) for setting in (STATED, Setting(gap=0.0)) for name in baselines]
    tests += [("I", AS_PRINTED), *((setup.COUPLED[name], STATED) for name in setup.SCHEMES)]
    return tests + [(name, STATED, feed / 60e3, SHORT) for feed in FEEDS for name in ("PI", *setup.SCHEMES)]


def _tables() -> Iterator[Row]:
    """Yield Tables 1 and 2, read back from the machine and its controllers."""
    plant = setup.machine(STATED, setup.SERVO_PERIOD).axes[0].plant.values()
    held = {"J_m": (5.2e-3, plant["motor_inertia"], "kg m^2"), "J_l": (4.4e-3, plant["load_inertia"], "kg m^2")}
    held |= {"K_s": (950.0, plant["stiffness"], "N m/rad"), "l": (0.016, plant["lead"], "m/rev"), "r": (0.025, setup.RADIUS, "m")}
    for symbol, (paper, here, unit) in held.items():
        yield printed("Table 1", symbol, paper, here, unit, 0.0, "read back from the machine", kind=INPUT)
    laws = {name: setup.scheme(name, STATED).axes["x"].controller.values() for name in setup.SCHEMES}
    gains = {"K_1, K_4": ("I", "position_gain", 1e4, "1/s^2"), "K_2, K_5": ("I", "rate_gain", 2e3, "1/s")}
    gains |= {"K_1', K_4'": ("II", "position_gain", 1e3, "N m/rad"), "K_2', K_5'": ("II", "rate_gain", 200.0, "N m s/rad")}
    gains |= {"K_3, K_6": ("III", "integral_gain", 25.0, "N m/rad/s")}
    for symbol, (name, parameter, paper, unit) in gains.items():
        note = "read back from the controller; the columns are exchanged: K_1 acts on the angle, K_2 on the rate"
        yield printed("Table 2", symbol, paper, laws[name][parameter], unit, 0.0, note, kind=INPUT, reading=READING)
    half = math.pi * STATED.gap / plant["lead"]
    printed_half, note = math.pi * 25e-6 / 0.016 * 1e3, "9.82 mrad if 25 um is the half"
    yield identity("half of the gap as an angle", "25 um in all", printed_half, half * 1e3, "mrad", 1e-9, note)
    yield identity("angular velocity on the circle", "8000 mm/min, eq (19)", 8000.0 / 60.0 / 25.0, setup.FEED / setup.RADIUS, "rad/s", 1e-9)


def _baseline() -> Iterator[Row]:
    with_gap, without = circular("PI", STATED), circular("PI", Setting(gap=0.0))
    chosen = "P-PI cascade on the motors; K_v = v/946.3 um = 140.9 1/s is chosen for this figure"
    for words, run in ((READ, with_gap), ("without backlash (Fig 7a): the lag alone", without)):
        yield printed("PI max error", words, 946.3, run.largest * 1e6, "um", 0.02 * 946.3, chosen, kind=INPUT)
    yield ours("PI max error", "what backlash adds", (with_gap.largest - without.largest) * 1e6, "um", "half the free travel")
    note = "a fair baseline: with velocity and acceleration feedforward the same loop has no lag"
    for words, setting in (("without backlash", Setting(gap=0.0)), (READ, STATED)):
        yield ours("PI max error", f"with feedforward, {words}", circular("PI with feedforward", setting).largest * 1e6, "um", note)
    note = "with the position loop closed over the loads: limit cycles along the whole circle (Figs 7b, 8)"
    yield ours("PI max error", "closed over the loads, total gap 25 um", circular("PI on the load", STATED).largest * 1e6, "um", note)
    note = "the lag shrinks the circle; free loads swing out by half the gap, which compensates most of the lag"
    for words, setting in (("without backlash (Fig 7a)", Setting(gap=0.0)), ("with backlash (Fig 7b)", STATED)):
        yield ours("PI contour error", f"on the motors, {words}", circular("PI", setting).contour_error * 1e6, "um", note)
        yield ours("PI contour error", f"closed over the loads, {words}", circular("PI on the load", setting).contour_error * 1e6, "um")


def _schemes() -> Iterator[Row]:
    """Yield the largest errors under the stated reading; the figure of scheme I follows from two printed ones."""
    runs = {name: circular(name, STATED) for name in setup.SCHEMES}
    largest = {name: run.largest * 1e6 for name, run in runs.items()}
    implied = 32.6 / (1.0 - REDUCTION["II"] / 100.0)
    note = "not printed: 32.6 um and a reduction by 53.6 % imply it; its gains times J_m are 19 times smaller than those of II"
    yield derived("I max error", WORDS, implied, largest["I"], "um", NEAR * implied, note)
    note = "without beta in its rate term, eq (13), the load stays 2 um nearer than under II; the paper calls the two 'quite the same'"
    for name in ("II", "III"):
        yield printed(f"{name} max error", WORDS, 32.6, largest[name], "um", NEAR * 32.6, reason=note, reading=READING)
    for name, paper in REDUCTION.items():
        here, case = 100.0 * (1.0 - largest[name] / largest["I"]), f"{name}, largest axis error, {WORDS}"
        yield printed("error reduction against scheme I", case, paper, here, "%", NEAR * paper, reading=READING)
    for name, run in runs.items():
        yield ours(f"{name} contour error", WORDS, run.contour_error * 1e6, "um", reading=READING)
        yield ours(f"{name} switches", WORDS, run.switches, "", "in 9 s, both axes", reading=READING)
    note = "eq (14) as printed follows the load in the gap, never the reference: nothing holds a frictionless load"
    yield ours("I as printed", f"following error passes 50 mm after, {READ}", circular("I", AS_PRINTED).diverged, "s", note)


def _readings() -> Iterator[Row]:
    """Yield the axis with the larger error under two other readings."""
    flank = "beta moves the motor's target to the flank, Table 2 as printed"
    for name, axis in (("I", "y"), ("II", "x"), ("III", "x")):
        here = circular(name, TO_FLANK).axis_error[setup.AXES.index(axis)] * 1e6
        yield ours(f"{name} max error", f"{axis} axis, {READ}", here, "um", flank, reading=flank, main=False)
    for name in setup.SCHEMES:
        here, words = circular(name, BY_ACCELERATION).largest * 1e6, "flank by the reference's acceleration, else word for word"
        yield ours(f"{name} max error", words, here, "um", reading=words, main=False)


def _feedrates() -> Iterator[Row]:
    per_min = 60.0
    axis = circular("I", STATED).axis_feed_error * per_min
    ripple = {name: circular(name, STATED).feed_ripple * per_min for name in setup.SCHEMES}
    yield identity("feedrate error of scheme I over the feedrate", "0.936217 m/min over 8 m/min", 11.703, 100.0 * 0.936217 / 8.0, "%", 5e-4)
    why = "a load without friction crosses the gap freely and hits at 0.132 m/min under any scheme; no reading we tried gives the figure"
    for name, case, paper, here in (
        ("feedrate error of scheme I", "largest of an axis", 0.936217, axis),
        ("I feed ripple", "", 0.25, ripple["I"]),
        ("III feed ripple", "", 0.027, ripple["III"]),
    ):
        case = f"{case}, {WORDS}" if case else WORDS
        yield printed(name, case, paper, here, "m/min", NEAR * paper, reason=why, reading=READING)
    yield ours("II feed ripple", WORDS, ripple["II"], "m/min", reading=READING)
    worst = 100.0 * max(ripple.values()) / 8.0
    note = "the paper's figure is an upper limit"
    yield printed("feedrate fluctuation", "largest of the three: below 10 %", 10.0, worst, "%", 10.0, note, at_most=True, reading=READING)
    note = "v'' = w^2 v: a free load crosses the gap while its reference slows down, and hits at this speed"
    yield ours("feed ripple of a free load", "total gap 25 um", per_min * setup.free_flight(STATED.gap), "m/min", note)


def _over_feeds() -> Iterator[Row]:
    for feed in FEEDS:
        for name in ("PI", *setup.SCHEMES):
            found = circular(name, STATED, feed / 60e3, SHORT)
            note = f"from 1 to {SHORT:g} s"
            yield ours(f"{name} max error over feeds", f"{feed:g} mm/min", found.largest * 1e6, "um", note, reading=READING)


def _coupling() -> Iterator[Row]:
    """Yield what cross-coupling, which the paper announces, adds to the schemes."""
    note = f"PI on the contour error of the loads: half of the axes' own position gain, integral rate {setup.INTEGRAL_RATE:g} 1/s"
    for name in setup.SCHEMES:
        here = circular(setup.COUPLED[name], STATED).contour_error * 1e6
        yield ours(f"{name} contour error", f"with cross-coupling, {WORDS}", here, "um", note, reading=READING)
    note = "builtin:backlash/part, 20 um of backlash and friction; cross-coupling with a modulus margin of 0.5"
    for words, here in zip(("rms", "largest"), part_error("scheme III"), strict=True):
        yield ours("part error of the shipped part", f"scheme III, {words}", here * 1e6, "um", note)
    note += "; chaotic: the last digits of the gain move it from 4.3 to 4.75 um, and the largest error from 29 to 42 um"
    coupled, _ = part_error("scheme III, cross-coupled")
    yield ours("part error of the shipped part", "scheme III, cross-coupled, rms", coupled * 1e6, "um", note)


def _ramps() -> Iterator[Row]:
    lag, _ = ramp("PI", Setting(gap=0.0))
    note = "the lag of a cascade, for which its K_v is chosen"
    yield derived("PI error on a ramp", "without backlash: f/K_v", 946.3, lag * 1e6, "um", 0.5, note)
    for name in ("PI", *setup.SCHEMES):
        error, ripple = ramp(name, Setting(start_in_gap=0.0))
        case = "total gap 25 um, motors in mid-gap at the start"
        yield ours(f"{name} error on a ramp", case, error * 1e6, "um", "from 0.5 to 1.4 s, after a run-up at 2 m/s^2", reading=READING)
        yield ours(f"{name} feed ripple on a ramp", case, ripple * 60.0, "m/min", "a load without friction bounces", reading=READING)


PARTS: tuple[Part, ...] = (("circular tests", _circles), ("ramps", _ramps), ("stability", theory_rows))
