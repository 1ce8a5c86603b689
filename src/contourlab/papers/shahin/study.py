"""Rows of Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives"."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from contourlab.papers.rows import Part, Row, derived, ours, printed
from contourlab.papers.shahin import setup
from contourlab.papers.shahin.runs import circular, prepare, ramp
from contourlab.papers.shahin.setup import Setting
from contourlab.papers.shahin.theory import theory_rows

READ = "total gap 25 um, motors on the forward flanks at the start"
CHAOS = 0.2 * 32.6
"""A lossless load in a gap is chaotic: its largest error changes by a fifth with the integration step."""
WHOLE_GAP = Setting(gap=50e-6)
EXCHANGED = Setting(gap=50e-6, start_in_gap=0.0, direction="acceleration", exchanged=True)
DAMPED = Setting(shaft_damping=1.0)
AS_PRINTED = Setting(follows_load=True)
SHORT = 4.0
"""End of the tests over feeds [s]."""
FEEDS = (1000.0, 2000.0, 4000.0, 6000.0, 8000.0, 10000.0)


def _circles() -> Iterator[Row]:
    """Yield the rows of all circular tests, run in parallel."""
    prepare(_needed())
    for part in (_tables, _baseline, _schemes, _readings, _reduction, _feedrates, _over_feeds):
        yield from part()


def _needed() -> list[tuple[Any, ...]]:
    """Return the arguments of `circular` for all rows."""
    settings = (Setting(), Setting(start_in_gap=0.0), WHOLE_GAP, EXCHANGED, DAMPED)
    tests: list[tuple[Any, ...]] = [(name, setting) for setting in settings for name in setup.SCHEMES]
    baselines = ("PI", "PI with feedforward", "PI on the load")
    tests += [(name, setting) for setting in (Setting(), Setting(gap=0.0)) for name in baselines]
    tests += [("PI on the load", WHOLE_GAP), ("I", AS_PRINTED)]
    return tests + [(name, Setting(), feed / 60e3, SHORT) for feed in FEEDS for name in ("PI", *setup.SCHEMES)]


def _tables() -> Iterator[Row]:
    """Yield Tables 1 and 2, read back from the machine and its controllers."""
    plant = setup.machine(Setting(), setup.SERVO_PERIOD).axes[0].plant
    shown = (("J_m", 5.2e-3, "motor_inertia", "kg m^2"), ("J_l", 4.4e-3, "load_inertia", "kg m^2"), ("K_s", 950.0, "stiffness", "N m/rad"))
    for symbol, paper, name, unit in (*shown, ("l", 0.016, "lead", "m/rev")):
        assert plant.values()[name] == paper
        yield ours("Table 1", symbol, paper, unit, "as printed, read back from the machine")
    yield ours("Table 1", "r", setup.RADIUS, "m", "as printed")
    gains = {"K_1, K_4": ("I", "rate_gain", 1e4, "1/s"), "K_2, K_5": ("I", "position_gain", 2e3, "1/s^2")}
    gains |= {"K_1', K_4'": ("II", "rate_gain", 1e3, "N m s/rad"), "K_2', K_5'": ("II", "position_gain", 200.0, "N m/rad")}
    gains |= {"K_3, K_6": ("III", "integral_gain", 25.0, "N m/rad/s")}
    for symbol, (name, parameter, paper, unit) in gains.items():
        held = setup.scheme(name, Setting()).axes["x"].controller.values()[parameter]
        assert held == paper
        yield ours("Table 2", symbol, held, unit, "as printed, the same in the gap")
    half = math.pi * 25e-6 / plant.values()["lead"]
    printed_half, note = math.pi * 25e-6 / 0.016 * 1e3, "9.82 mrad if 25 um is the half"
    yield derived("half of the gap as an angle", "25 um in all", printed_half, half * 1e3, "mrad", 1e-9, note)
    yield derived("angular velocity on the circle", "8000 mm/min, eq (19)", 8000.0 / 60.0 / 25.0, setup.FEED / setup.RADIUS, "rad/s", 1e-9)
    rate = gains["K_1', K_4'"][2] / plant.values()["motor_inertia"]
    yield ours("rate of the motor under K_1'", "K_1'/J_m", rate, "1/s", "needs a servo period of microseconds")


def _baseline() -> Iterator[Row]:
    with_gap, without = circular("PI", Setting()), circular("PI", Setting(gap=0.0))
    chosen = "P-PI cascade on the motors with K_v = v/946.3 um = 140.9 1/s, chosen for this lag: agreement proves nothing"
    yield printed("PI max error", READ, 946.3, with_gap.largest * 1e6, "um", 0.02 * 946.3, chosen)
    yield printed("PI max error", "without backlash (Fig 7a): the lag alone", 946.3, without.largest * 1e6, "um", 0.02 * 946.3, chosen)
    yield ours("PI max error", "what backlash adds", (with_gap.largest - without.largest) * 1e6, "um", "half the free travel")
    note = "a fair baseline: with velocity and acceleration feedforward the same loop has no lag"
    for words, setting in (("without backlash", Setting(gap=0.0)), (READ, Setting())):
        yield ours("PI max error", f"with feedforward, {words}", circular("PI with feedforward", setting).largest * 1e6, "um", note)
    note = "with the position loop closed over the loads: limit cycles along the whole circle (Figs 7b, 8)"
    for words, setting in (("total gap 25 um", Setting()), ("total gap 50 um", WHOLE_GAP)):
        yield ours("PI max error", f"closed over the loads, {words}", circular("PI on the load", setting).largest * 1e6, "um", note)
    note = "the lag shrinks the circle; free loads swing out by half the gap, which compensates most of the lag"
    for words, setting in (("without backlash (Fig 7a)", Setting(gap=0.0)), ("with backlash (Fig 7b)", Setting())):
        yield ours("PI contour error", f"on the motors, {words}", circular("PI", setting).contour_error * 1e6, "um", note)
        yield ours("PI contour error", f"closed over the loads, {words}", circular("PI on the load", setting).contour_error * 1e6, "um")


def _schemes() -> Iterator[Row]:
    chaos = "32.6 um is printed for 'all of the proposed schemes'; a lossless load is chaotic, which changes the error by a fifth"
    for name in setup.SCHEMES:
        found = circular(name, Setting())
        for axis, largest in zip(setup.AXES, found.axis_error, strict=True):
            case = f"{axis} axis, {READ}"
            if name == "I":
                note = "follows the reference in the gap; as printed it diverges. No worse than II and III on x, worse on y"
                yield ours("I max error", case, largest * 1e6, "um", note)
            else:
                yield printed(f"{name} max error", case, 32.6, largest * 1e6, "um", CHAOS, chaos)
        yield ours(f"{name} contour error", READ, found.contour_error * 1e6, "um")
        yield ours(f"{name} switches", READ, found.switches, "", "in 9 s, both axes")
    literal = circular("I", AS_PRINTED)
    note = "eq (14) as printed follows the load in the gap, never the reference: nothing holds a frictionless load"
    yield ours("I as printed", f"following error passes 50 mm after, {READ}", literal.diverged, "s", note)


def _readings() -> Iterator[Row]:
    """Yield other readings: 25 um as half the gap, start in mid-gap, Table 2's columns exchanged."""
    readings = (
        ("total gap 25 um, motors in mid-gap at the start", Setting(start_in_gap=0.0)),
        ("total gap 50 um, motors on the forward flanks", WHOLE_GAP),
        ("total gap 50 um, mid-gap, flank by acceleration, rate and position gains exchanged", EXCHANGED),
    )
    for words, setting in readings:
        for name in setup.SCHEMES:
            found = circular(name, setting)
            yield ours(f"{name} max error", words, found.largest * 1e6, "um")
            yield ours(f"{name} contour error", words, found.contour_error * 1e6, "um")


def _reduction() -> Iterator[Row]:
    why = "scheme I would need 70 to 72 um, which no reading gives: with K' = J_m K, 52 instead of 1000, scheme I is the law of scheme II"
    for paper, name in ((53.6, "II"), (54.5, "III")):
        for words, setting in ((READ, Setting()), ("gains exchanged, total gap 50 um", EXCHANGED)):
            first, other = circular("I", setting), circular(name, setting)
            for what, before, after in (("axis", first.largest, other.largest), ("contour", first.contour_error, other.contour_error)):
                case = f"{name}, largest {what} error, {words}"
                yield printed("error reduction against scheme I", case, paper, 100.0 * (1.0 - after / before), "%", 5.0, reason=why)


def _feedrates() -> Iterator[Row]:
    per_min = 60.0
    yield derived("feedrate error of scheme I over the feedrate", "0.936217 m/min over 8 m/min", 11.703, 100.0 * 0.936217 / 8.0, "%", 5e-4)
    ripple = {name: circular(name, Setting()).feed_ripple * per_min for name in setup.SCHEMES}
    axis = circular("I", Setting()).axis_feed_error * per_min
    why = "a free load hits the other flank at 0.132 m/min under any scheme; the shaft oscillation that follows is chaotic"
    yield printed("feedrate error of scheme I", f"largest of an axis, {READ}", 0.936217, axis, "m/min", 0.1, reason=why)
    yield printed("I feed ripple", READ, 0.25, ripple["I"], "m/min", 0.05, reason=why)
    yield ours("II feed ripple", READ, ripple["II"], "m/min")
    smooth = "with a higher gain on the motor's rate than I, impacts are harder; without damping the 464.7 rad/s oscillation hardly decays"
    yield printed("III feed ripple", READ, 0.027, ripple["III"], "m/min", 0.005, reason=smooth)
    largest = 100.0 * max(ripple.values()) / 8.0
    note = "the paper's figure is an upper limit"
    yield printed("feedrate fluctuation", "largest of the three: below 10 %", 10.0, largest, "%", 10.0, note)
    free = per_min * setup.free_flight(Setting().gap)
    note = "v'' = w^2 v: a free load crosses the gap while its reference slows down, and hits at this speed"
    yield ours("feed ripple of a free load", "total gap 25 um", free, "m/min", note)
    yield ours("feed ripple of a free load", "total gap 50 um", per_min * setup.free_flight(2.0 * Setting().gap), "m/min", note)
    for name in setup.SCHEMES:
        here = circular(name, DAMPED).feed_ripple * per_min
        yield ours(f"{name} feed ripple", "with 1 N m s/rad of damping in the shafts", here, "m/min", "same order as the paper's figures")


def _over_feeds() -> Iterator[Row]:
    for feed in FEEDS:
        for name in ("PI", *setup.SCHEMES):
            found = circular(name, Setting(), feed / 60e3, SHORT)
            yield ours(f"{name} max error over feeds", f"{feed:g} mm/min", found.largest * 1e6, "um", f"from 1 to {SHORT:g} s")


def _ramps() -> Iterator[Row]:
    lag, _ = ramp("PI", Setting(gap=0.0))
    note = "the lag of a cascade, for which its K_v is chosen"
    yield derived("PI error on a ramp", "without backlash: f/K_v", 946.3, lag * 1e6, "um", 0.5, note)
    for name in ("PI", *setup.SCHEMES):
        error, ripple = ramp(name, Setting(start_in_gap=0.0))
        case = "total gap 25 um, motors in mid-gap at the start"
        yield ours(f"{name} error on a ramp", case, error * 1e6, "um", "from 0.5 to 1.4 s, after a run-up at 2 m/s^2")
        yield ours(f"{name} feed ripple on a ramp", case, ripple * 60.0, "m/min", "a lossless load keeps bouncing in its gap")


PARTS: tuple[Part, ...] = (("circular tests", _circles), ("ramps", _ramps), ("stability", theory_rows))
