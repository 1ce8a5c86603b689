"""Reproduction of Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives"."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from contourlab.papers.rows import Part, Row, Stage, derived, in_parts, ours, printed
from contourlab.papers.shahin import setup as setup
from contourlab.papers.shahin.ramps import ramp_rows
from contourlab.papers.shahin.runs import WINDOW, circular, prepare
from contourlab.papers.shahin.setup import Setting
from contourlab.papers.shahin.theory import theory_rows

READ = "total gap 25 um, motors on the forward flanks at the start"
CHAOS = 0.2 * 32.6
"""A lossless load in a gap is chaotic: with the step of the integration its largest error changes by a fifth."""
WHOLE_GAP = Setting(gap=50e-6)
EXCHANGED = Setting(gap=50e-6, start_in_gap=0.0, direction="acceleration", exchanged=True)
DAMPED = Setting(shaft_damping=1.0)
AS_PRINTED = Setting(follows_load=True)
SHORT = 4.0
"""Until when tests over feeds are looked at [s]."""
FEEDS = (1000.0, 2000.0, 4000.0, 6000.0, 8000.0, 10000.0)


def reproduce(stage: Stage | None = None) -> list[dict[str, Any]]:
    """Return every figure of the paper beside ours: rows with the keys of `contourlab.papers.rows.Row.as_dict`.

    Parameters
    ----------
    stage : callable, optional
        Told in words what is begun.
    """
    return list(in_parts(PARTS, stage))


def _circles() -> Iterator[Row]:
    """Yield the rows of all circular tests, which run side by side."""
    prepare(_needed())
    for part in (_tables, _baseline, _schemes, _readings, _reduction, _feedrates, _over_feeds):
        yield from part()


def _needed() -> list[tuple[str, Setting, float, float]]:
    """Return the circular tests that the rows are made of: scheme, setting, feedrate, and until when."""
    settings = (Setting(), Setting(start_in_gap=0.0), WHOLE_GAP, EXCHANGED, DAMPED)
    tests = [(name, setting) for setting in settings for name in setup.SCHEMES]
    baselines = ("PI", "PI with feedforward", "PI on the load")
    tests += [(name, setting) for setting in (Setting(), Setting(gap=0.0)) for name in baselines]
    tests += [("PI on the load", WHOLE_GAP), ("I", AS_PRINTED)]
    over = [(name, Setting(), feed / 60e3, SHORT) for feed in FEEDS for name in ("PI", *setup.SCHEMES)]
    return [(*test, setup.FEED, WINDOW[1]) for test in tests] + over


def _tables() -> Iterator[Row]:
    """Tables 1 and 2 as the machine and its controllers hold them, read back, and what follows from them."""
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
    yield derived(
        "half of the gap as an angle",
        "25 um in all",
        math.pi * 25e-6 / 0.016 * 1e3,
        half * 1e3,
        "mrad",
        1e-9,
        "9.82 mrad if 25 um is the half",
    )
    yield derived("angular velocity on the circle", "8000 mm/min, eq (19)", 8000.0 / 60.0 / 25.0, setup.FEED / setup.RADIUS, "rad/s", 1e-9)
    rate = gains["K_1', K_4'"][2] / plant.values()["motor_inertia"]
    yield ours("rate of the motor under K_1'", "K_1'/J_m", rate, "1/s", "what asks for a servo period of microseconds")


def _baseline() -> Iterator[Row]:
    with_gap, without = circular("PI", Setting()), circular("PI", Setting(gap=0.0))
    pinned = "P-PI cascade on the motors; its K_v is v/946.3 um = 140.9 1/s, so that the lag is the paper's by choice and proves nothing"
    yield printed("PI max error", READ, 946.3, with_gap.largest * 1e6, "um", 0.02 * 946.3, pinned)
    yield printed("PI max error", "without backlash (Fig 7a): the lag alone", 946.3, without.largest * 1e6, "um", 0.02 * 946.3, pinned)
    yield ours("PI max error", "what backlash adds", (with_gap.largest - without.largest) * 1e6, "um", "half of the free travel")
    said = "an honest baseline: the same loop that is told the reference's velocity and acceleration has no lag"
    for words, setting in (("without backlash", Setting(gap=0.0)), (READ, Setting())):
        yield ours("PI max error", f"with feedforward, {words}", circular("PI with feedforward", setting).largest * 1e6, "um", said)
    said = "with the position loop closed over the loads it hunts: limit cycles along the whole circle (Figs 7b, 8)"
    for words, setting in (("total gap 25 um", Setting()), ("total gap 50 um", WHOLE_GAP)):
        yield ours("PI max error", f"closed over the loads, {words}", circular("PI on the load", setting).largest * 1e6, "um", said)
    shrunk = "the lag makes the circle smaller; free loads swing out by half of the gap, which takes most of that back"
    for words, setting in (("without backlash (Fig 7a)", Setting(gap=0.0)), ("with backlash (Fig 7b)", Setting())):
        yield ours("PI contour error", f"on the motors, {words}", circular("PI", setting).contour_error * 1e6, "um", shrunk)
        yield ours("PI contour error", f"closed over the loads, {words}", circular("PI on the load", setting).contour_error * 1e6, "um")


def _schemes() -> Iterator[Row]:
    tells = (
        "the printed 32.6 um is that of 'all of the proposed schemes'; a fifth of it is what the chaos of a lossless load makes of nothing"
    )
    for name in setup.SCHEMES:
        found = circular(name, Setting())
        for axis, largest in zip(setup.AXES, found.axis_error, strict=True):
            case = f"{axis} axis, {READ}"
            if name == "I":
                note = "with the reference in the gap: as printed it runs away. I is no worse than II and III on x, and worse on y"
                yield ours("I max error", case, largest * 1e6, "um", note)
            else:
                yield printed(f"{name} max error", case, 32.6, largest * 1e6, "um", CHAOS, tells)
        yield ours(f"{name} contour error", READ, found.contour_error * 1e6, "um")
        yield ours(f"{name} switches", READ, found.switches, "", "in 9 s, both axes")
    literal = circular("I", AS_PRINTED)
    said = "eq (14) as printed follows the load in the gap, never the reference: a load without friction is left to itself"
    yield ours("I as printed", f"following error passes 50 mm after, {READ}", literal.diverged, "s", said)


def _readings() -> Iterator[Row]:
    """Where the paper is open: 25 um may be the half gap, the start may be in mid-gap, Table 2's columns may be exchanged."""
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
    why = "it would want 70 to 72 um of scheme I, which no reading gives: with K' = J_m K, 52 in place of 1000, it is the law of scheme II"
    for paper, name in ((53.6, "II"), (54.5, "III")):
        for words, setting in ((READ, Setting()), ("gains exchanged, total gap 50 um", EXCHANGED)):
            first, found = circular("I", setting), circular(name, setting)
            for what, one, other in (("axis", first.largest, found.largest), ("contour", first.contour_error, found.contour_error)):
                case = f"{name}, largest {what} error, {words}"
                yield printed("error reduction against scheme I", case, paper, 100.0 * (1.0 - other / one), "%", 5.0, reason=why)


def _feedrates() -> Iterator[Row]:
    per_min = 60.0
    yield derived("feedrate error of scheme I over the feedrate", "0.936217 m/min over 8 m/min", 11.703, 100.0 * 0.936217 / 8.0, "%", 5e-4)
    ripple = {name: circular(name, Setting()).feed_ripple * per_min for name in setup.SCHEMES}
    axis = circular("I", Setting()).axis_feed_error * per_min
    why = (
        "a free load that is caught at the other flank comes with 0.132 m/min, whatever the scheme; what the shafts swing on with is chaos"
    )
    yield printed("feedrate error of scheme I", f"largest of an axis, {READ}", 0.936217, axis, "m/min", 0.1, reason=why)
    yield printed("I feed ripple", READ, 0.25, ripple["I"], "m/min", 0.05, reason=why)
    yield ours("II feed ripple", READ, ripple["II"], "m/min")
    smooth = (
        "stiffer on the motor's rate than I, it strikes harder; without friction and shaft damping the swing of 464.7 rad/s hardly decays"
    )
    yield printed("III feed ripple", READ, 0.027, ripple["III"], "m/min", 0.005, reason=smooth)
    largest = 100.0 * max(ripple.values()) / 8.0
    yield printed(
        "feedrate fluctuation", "largest of the three: below 10 %", 10.0, largest, "%", 10.0, "the paper's figure is an upper limit"
    )
    free = per_min * setup.free_flight(Setting().gap)
    note = "v'' = w^2 v: a load that nothing holds falls back by the gap while its reference slows down, and is caught at this speed"
    yield ours("feed ripple of a free load", "total gap 25 um", free, "m/min", note)
    yield ours("feed ripple of a free load", "total gap 50 um", per_min * setup.free_flight(2.0 * Setting().gap), "m/min", note)
    for name in setup.SCHEMES:
        here = circular(name, DAMPED).feed_ripple * per_min
        yield ours(f"{name} feed ripple", "with 1 N m s/rad of damping in the shafts", here, "m/min", "the order of the paper's figures")


def _over_feeds() -> Iterator[Row]:
    for feed in FEEDS:
        for name in ("PI", *setup.SCHEMES):
            found = circular(name, Setting(), feed / 60e3, SHORT)
            yield ours(f"{name} max error over feeds", f"{feed:g} mm/min", found.largest * 1e6, "um", f"from 1 to {SHORT:g} s")


PARTS: tuple[Part, ...] = (("circular tests", _circles), ("ramps", ramp_rows), ("stability", theory_rows))
