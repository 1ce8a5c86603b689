"""Ghaffari & Ulsoy, simulated runs: Fig 9, other readings of the paper, and the weight lambda for several shapes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import chain

import numpy as np

from contourlab.feed import Reference, uniform
from contourlab.geometry import contour
from contourlab.loop import simulate, simulate_batch
from contourlab.metrics.figures import Metrics, summarise
from contourlab.metrics.judge import judge
from contourlab.metrics.reversals import reversal_spikes
from contourlab.papers.ghaffari.setup import FITTED, TABLE_3, Gains, Reading, circle, controller, machine
from contourlab.papers.rows import INPUT, Row, derived, identity, ours, printed
from contourlab.result import Result

PRINTED = {1: 18.37, 2: 18.46}
SPIKES = (2.0, 2.5)
"""Integrals [um s] of both configurations, and times [s] of the first two error spikes, as printed; those at 3 and 3.5 s are alike."""

SLOW_OBSERVER = "w_d 30 rad/s"
WEIGHTS = np.array([0.0, 0.75])
DIGITS = 100.0 * 2.0 * 0.005 / PRINTED[1]
"""What the last printed digits leave open of the difference between the integrals [percent]."""
_MICRO = 1e6


def run_rows() -> Iterator[Row]:
    """Yield the rows on Fig 9, the readings, the fitted filters, and lambda."""
    return chain(_fig_9(), _readings(), _fitted(), _weights())


def run(first: int, table: dict[int, Gains], reading: Reading) -> tuple[Result, Reference, Metrics]:
    """Run the circle in a configuration; the second lap counts, as in Fig 9."""
    reference = circle(reading)
    judged = judge(simulate(machine(first, reading), controller(first, table, reading), reference), reference)
    return judged, reference, summarise(judged, reference)


def integral(first: int, reading: Reading, table: dict[int, Gains] = TABLE_3) -> float:
    """Return the integral of the contour error's magnitude over one period [um s]."""
    return _MICRO * run(first, table, reading)[2].contour_error.integral


def _fig_9() -> Iterator[Row]:
    integrals = {}
    for first in (1, 2):
        case = f"A3-A{first}, Table III"
        judged, reference, figures = run(first, TABLE_3, Reading())
        error = figures.contour_error
        here = integrals[first] = _MICRO * error.integral
        note = "over one period of 2 s"
        yield printed(f"contour error integral A3-A{first}", case, PRINTED[first], here, "um s", 0.05 * PRINTED[first], note)
        note = "positive to the left: the circle is too small, a radius error from the feedforward gain a', not from friction"
        yield ours("signed mean of contour error", case, _MICRO * error.signed_mean, "um", note)
        note = "from friction, mismatch and quantisation, without the radius error"
        yield ours("integral without the signed mean", case, _MICRO * error.integral_without_mean, "um s", note)
        yield from _spikes(judged, reference, case)
    for first in (1, 2):
        off = integral(first, replace(Reading(), observer=False))
        note = f"{off / integrals[first]:.1f} times as large; the paper gives no figure"
        yield ours("contour error integral, observer off", f"A3-A{first}, Table III", off, "um s", note)


def _spikes(judged: Result, reference: Reference, case: str, reading: str = "") -> Iterator[Row]:
    """Yield time and height of the contour error's peaks at the first reversal of each axis; the paper prints the times."""
    start, stop = reference.laps[-1]
    for spike, time in zip(reversal_spikes(judged, (start - 5, stop))[:2], SPIKES, strict=True):
        if not reading:
            note = f"axis {spike.axis} reverses there whatever the model; the error peaks a little later"
            yield identity(f"time of the spike at {time:g} s", case, time, spike.peak_time, "s", 0.05, note)
        note = f"axis {spike.axis} reverses; {1e3 * spike.width:.0f} ms wide at half height"
        name = f"reversal spike at {time:g} s{', fitted filters' if reading else ''}"
        yield ours(name, case, _MICRO * spike.height, "um", note, reading=reading, main=not reading)


def readings() -> dict[str, Reading]:
    """Return other readings of the paper by name, with one parameter changed at a time."""
    base = Reading()
    return {
        "low-passes by backward Euler": replace(base, discretisation="backward-euler"),
        "servo period 0.5 ms": replace(base, servo_period=5e-4),
        "servo period 0.1 ms": replace(base, servo_period=1e-4),
        SLOW_OBSERVER: replace(base, bandwidth=30.0),
        "w_d 100 rad/s": replace(base, bandwidth=100.0),
        "w_d 300 rad/s": replace(base, bandwidth=300.0),
        "w_z 1000 rad/s": replace(base, filter_bandwidth=1000.0),
        "velocity behind 400 rad/s": replace(base, velocity_bandwidth=400.0),
        "velocity behind 1600 rad/s": replace(base, velocity_bandwidth=1600.0),
        "lambda 0": replace(base, coupling=False),
    }


NOTES = {
    "low-passes by backward Euler": "pole matching at w_z T = 2 gives the observer 0.31 of the acceleration, backward Euler all of it",
    SLOW_OBSERVER: "the only one above 20.1 um s: w_d is hardly above b_hat = 20 to 25 1/s, but the paper requires b << w_d",
}


def _readings() -> Iterator[Row]:
    """Yield the integral for the readings of the paper, and the difference between the configurations."""
    gaps = []
    for words, reading in readings().items():
        values = {first: integral(first, reading) for first in (1, 2)}
        gaps.append(_gap(values))
        for first, value in values.items():
            name, case, note = "integral over what the paper leaves open", f"A3-A{first}, {words}", NOTES.get(words, "")
            yield printed(name, case, PRINTED[first], value, "um s", 0.05 * PRINTED[first], note, reading=words, main=False)
    gap = _gap({first: integral(first, Reading()) for first in (1, 2)})
    reason = f"of the integral, nearly identical as the paper states; {min(gaps):.1f} to {max(gaps):.1f} % over the other readings"
    yield derived("difference between configurations", "A3-A2 beyond A3-A1", _gap(PRINTED), gap, "%", DIGITS, reason=reason)
    yield from _raised_feedforward()


def _gap(values: Mapping[int, float]) -> float:
    """Return by how many percent the integral of A3-A2 is larger than that of A3-A1."""
    return 100.0 * (values[2] / values[1] - 1.0)


def _fitted() -> Iterator[Row]:
    """Yield the integrals under the fitted filters, and what these filters predict."""
    words, integrals = "filters fitted to the two printed integrals", {}
    for first in (1, 2):
        case = f"A3-A{first}, Table III"
        judged, reference, figures = run(first, TABLE_3, FITTED)
        here = integrals[first] = _MICRO * figures.contour_error.integral
        note = "w_d 328, w_z 2041 and velocity filter 606 rad/s: three numbers fitted to two"
        paper, most = PRINTED[first], 0.01 * PRINTED[first]
        name = "contour error integral, fitted filters"
        yield printed(name, case, paper, here, "um s", most, note, kind=INPUT, reading=words, main=False)
        yield from _spikes(judged, reference, case, words)
    name, case, note = "difference between configurations, fitted filters", "A3-A2 beyond A3-A1", "follows from the two fitted integrals"
    yield printed(name, case, _gap(PRINTED), _gap(integrals), "%", DIGITS, note, kind=INPUT, reading=words, main=False)


def _raised_feedforward() -> Iterator[Row]:
    """Yield rows on the circle with a larger a' in the feedforward only."""
    base = Reading()
    for first in (1, 2):
        made = controller(first, TABLE_3, base)
        raised = {name: replace(part, controller=part.controller.replace(model_gain=0.96)) for name, part in made.axes.items()}
        reference = circle(base)
        judged = judge(simulate(machine(first, base), replace(made, axes=raised), reference), reference)
        value = _MICRO * summarise(judged, reference).contour_error.integral
        note = "a' = 960 instead of 900 mm/s^2 on both axes: the feedforward alone determines most of the integral"
        yield ours("contour error integral with a' = 960", f"A3-A{first}", value, "um s", note)


def _weights() -> Iterator[Row]:
    """Yield contour and tracking error without lambda and with the printed one, for three shapes."""
    ellipse, lemniscate = contour("ellipse", a=0.03, b=0.015), contour("lemniscate", a=0.025)
    reading = Reading()
    made = controller(1, TABLE_3, reading)
    for shape, path in {"circle": contour("circle"), "ellipse": ellipse, "lemniscate": lemniscate}.items():
        reference = uniform(path, 0.5, 2, reading.servo_period)
        batch = simulate_batch(machine(1, reading), made, reference, {"controller.coupling.weight": WEIGHTS})
        errors = batch.figures["contour_error_rms"], batch.figures["tracking_error_rms"]
        for weight, contouring, tracking in zip(WEIGHTS, *errors, strict=True):
            case = f"A3-A1, {shape}, {60e3 * path.length * 0.5:.0f} mm/min, lambda {weight:g}"
            yield ours("contour error, rms", case, _MICRO * contouring, "um")
            yield ours("tracking error, rms", case, _MICRO * tracking, "um")
