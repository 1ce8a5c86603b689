"""Runs with known errors: laps of a circle with a lag and a given radial deviation, judged by the real judge."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from contourlab.analysis.linear.margins import Margins
from contourlab.components.drive.saturation import Saturation
from contourlab.components.plant.plant import RigidAxis
from contourlab.feed import Reference, uniform
from contourlab.findings import finding
from contourlab.geometry import Path, contour
from contourlab.loop import Axis, Machine
from contourlab.loop.machine import Limits
from contourlab.metrics.circles import circles_of
from contourlab.metrics.figures import summarise
from contourlab.metrics.judge import judge
from contourlab.metrics.reversals import reversal_spikes
from contourlab.rendering.data import ClosedLoop, JudgedRun, Provenance, ReportData
from contourlab.rendering.judgement import Cause, Verdict, Worst
from contourlab.result import Result, Signal

RADIUS, LAG, FREQUENCY = 0.02, 50e-6, 0.5
BOTH = ("sample", "axis")


def deviation(angle: np.ndarray, amplitude: float) -> np.ndarray:
    """Radial deviation [m]: out of round, with a spike behind each quadrant; the largest magnitude is not at a round angle."""
    behind = np.mod(angle, 0.5 * np.pi)
    return np.asarray(amplitude * (0.5 * np.cos(2.0 * angle + 0.4) + np.exp(-behind / 0.06) - 0.1))


def run(name: str, reference: Reference, amplitude: float) -> Result:
    """Return a judged run along a circle with a lag and the deviation above."""
    block = reference.block(0, reference.n_sample)
    n, n_axis = block.position.shape
    tool = np.array(block.position)
    angle = np.arctan2(tool[:, 1], tool[:, 0]) - LAG / RADIUS
    radius = RADIUS + deviation(angle, amplitude)
    tool[:, 0], tool[:, 1] = radius * np.cos(angle), radius * np.sin(angle)
    noise = np.random.default_rng(1).standard_normal((n, n_axis))
    command = 0.4 * np.sign(block.velocity) + 0.05 * noise
    signals = {
        "reference": Signal(block.position, BOTH, "m"),
        "reference_velocity": Signal(block.velocity, BOTH, "m/s"),
        "reference_acceleration": Signal(block.acceleration, BOTH, "m/s^2"),
        "arc_length": Signal(block.arc_length, ("sample",), "m"),
        "feedrate": Signal(block.feedrate, ("sample",), "m/s"),
        "position": Signal(tool, BOTH, "m"),
        "tool_position": Signal(tool, BOTH, "m"),
        "velocity": Signal(np.gradient(tool, reference.servo_period, axis=0), BOTH, "m/s"),
        "command": Signal(command, BOTH, "full_scale"),
        "applied_command": Signal(np.clip(command, -1.0, 1.0), BOTH, "full_scale"),
    }
    return judge(Result(name, ("x", "y", "z")[:n_axis], reference.servo_period, signals), reference)


def judgement(result: Result, tolerance: float, text: str = "G3 X20 Y0 I-20 J0") -> Verdict:
    """Return a verdict on the largest part error."""
    sample = int(np.argmax(np.abs(result["part_error"])))
    value = float(abs(result["part_error"][sample]))
    position, along = tuple(result["tool_position"][sample]), float(result["arc_length"][sample])
    worst = Worst(value, sample, sample * result.servo_period, position, along, 4, text)
    causes = (Cause("reversal", 0.8 * value, 0.7), Cause("servo mismatch", 0.3 * value, 0.2), Cause("lag", -0.1 * value, 0.1))
    return Verdict(value <= tolerance, tolerance, worst, causes)


def response(bandwidth: float) -> ClosedLoop:
    """Return a second-order closed loop of this bandwidth [Hz], about."""
    frequency = np.geomspace(0.1, 1000.0, 300)
    s = 1j * frequency / bandwidth
    return ClosedLoop(frequency, 1.0 / (s * s + 1.4 * s + 1.0), Margins(math.inf, math.inf, math.nan, 0.7))


def machine(axes: tuple[str, ...], limits: Limits, command: float = math.inf) -> Machine:
    """Return a machine whose axes have these limits, and drives that saturate at a command."""
    drive = Saturation(limit=command)
    return Machine("synthetic", tuple(Axis(name, RigidAxis(gain=1.0), drive=drive, limits=limits) for name in axes), 1e-3)


def scheme(name: str, reference: Reference, amplitude: float, tolerance: float = 5e-6) -> JudgedRun:
    """Return one run with every entry of a report."""
    result = run(name, reference, amplitude)
    limited = machine(result.axes, Limits(velocity=0.1, acceleration=1.0, jerk=20.0), command=1.0)
    bode = {axis: response(25.0 + 10.0 * i) for i, axis in enumerate(result.axes)}
    circles = circles_of(result, reference) if reference.n_sample < 20_000 else ()
    spikes = reversal_spikes(result, reference.judged.ranges[0])
    metrics = summarise(result, reference)
    advice = finding("CL203", change="adding a disturbance observer", before=8e-6, after=2.1e-6, time_before=4.0, time_after=4.0)
    verdict = judgement(result, tolerance)
    return JudgedRun(name, reference, result, metrics, verdict, circles, spikes, (advice,), limited, bode)


def report(
    amplitudes: tuple[float, ...] = (8e-6, 2e-6), *, laps: int = 2, servo_period: float = 1e-3, path: Path | None = None
) -> ReportData:
    """Return a report of runs round the circle, worst first."""
    path = path or contour("circle", radius=RADIUS)
    # The first half of each lap is line 3 of the program, the second half line 4.
    breaks, lines = path.length * np.array([0.0, 0.5, 1.0]), np.array([3, 4])
    reference = replace(uniform(path, FREQUENCY, laps, servo_period), line_breaks=breaks, source_lines=lines)
    names = ("independent axes", "modified reference", "cross-coupled", "observer", "everything")
    schemes = tuple(scheme(name, reference, a) for name, a in zip(names, amplitudes, strict=False))
    program = ("%", "(ring of 20 mm)", "G21 G90 F3770", "G3 X20 Y0 I-20 J0", "M30")
    source = Provenance(
        "contourlab run circle.toml",
        "contourlab report circle.toml --seed 1",
        '[machine]\nname = "two axes"\n\n[run]\ntolerance = "5 um"\nseed = 1\n',
        1,
        "0.1.0",
        "Linux x86_64, Python 3.11",
    )
    return ReportData("Circle of 20 mm at 3770 mm/min", schemes, source, program, 5e-6)


def with_result(data: ReportData, result: Result) -> ReportData:
    """Return the report with the result of its only scheme replaced."""
    return replace(data, schemes=(replace(data.schemes[0], result=result),))


def around(data: ReportData, path: Path, reference: Reference, offset: float = 4e-6) -> ReportData:
    """Return the report for a run along any path, off by a constant vector; without circles, verdict and Bode plots."""
    block = reference.block(0, reference.n_sample)
    tool = block.position + offset
    signals = {
        "reference": Signal(block.position, BOTH, "m"),
        "reference_velocity": Signal(block.velocity, BOTH, "m/s"),
        "reference_acceleration": Signal(block.acceleration, BOTH, "m/s^2"),
        "arc_length": Signal(block.arc_length, ("sample",), "m"),
        "tool_position": Signal(tool, BOTH, "m"),
    }
    axes = ("x", "y", "z", "u")[: path.n_axis]
    result = judge(Result("off by a vector", axes, reference.servo_period, signals), reference)
    only = JudgedRun("off by a vector", reference, result, summarise(result, reference))
    return replace(data, schemes=(only,), program=(), tolerance=None)
