"""Spectra have the amplitudes of what is in the signals, and mark no noise."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import synthetic
from scipy.signal import welch
from scipy.special import gammaincinv

from contourlab.components.plant.two_sided import TwoMass
from contourlab.feed import uniform
from contourlab.feed.reference import Judged
from contourlab.geometry import contour
from contourlab.loop import Axis, Machine
from contourlab.metrics.judge import judge
from contourlab.rendering.data import ReportData
from contourlab.rendering.spectrum import _quantile, spectrum_charts
from contourlab.result import Signal

PERIOD, HERTZ = 1e-3, 62.5


def shaken(size: float = 0.0, noise: float = 0.0, laps: int = 10) -> ReportData:
    """Return a run around a circle whose tool and command x are shaken by a sine of `size` [m] and white noise."""
    reference = uniform(contour("circle", radius=synthetic.RADIUS), synthetic.FREQUENCY, laps, PERIOD)
    data = synthetic.around(synthetic.report(), reference.path, reference, 0.0)
    (scheme,) = data.schemes
    tool = np.array(scheme.result["tool_position"])
    away = size * np.sin(2.0 * np.pi * HERTZ * scheme.result.time) + noise * np.random.default_rng(7).standard_normal(len(tool))
    tool[:, 0] += away
    command = np.column_stack([1e6 * away, np.ones(len(away))])
    signals = {"tool_position": Signal(tool, synthetic.BOTH, "m"), "command": Signal(command, synthetic.BOTH, "A")}
    result = judge(scheme.result.with_signals(**signals), reference)
    return replace(data, schemes=(replace(scheme, result=result),))


def test_a_sine_has_its_amplitude_and_is_marked_with_its_cause():
    data = shaken(3e-6, 1e-7)
    plant = TwoMass(mass=20.0, damping=0.0, force_constant=60.0, resonance=61.0)
    axes = tuple(Axis(name, plant.replace(resonance=f), substeps=4) for name, f in (("x", 61.0), ("y", 100.0)))
    run = replace(data.schemes[0], machine=Machine("shaky", axes, PERIOD))
    (chart,) = spectrum_charts(replace(data, schemes=(run,)), 4000)
    error, command = chart.panels  # a constant has no spectrum
    (curve,), (mark,) = error.curves, error.ticks
    assert curve.x[0] == pytest.approx(0.5) and curve.x[-1] == 500.0
    assert mark.x == HERTZ and "resonance of x" in mark.label and "of y" not in mark.label
    # Away from the circle the tool is by s cos(a) (cos(a), sin(a)) at an angle a: half of s at its frequency, the rest beside it.
    assert curve.y[curve.x == HERTZ][0] == pytest.approx(1.5, rel=0.02)
    assert command.curves[0].y[command.curves[0].x == HERTZ][0] == pytest.approx(3.0, rel=0.02)
    assert [tick.x for tick in command.ticks] == [HERTZ]


def test_noise_has_no_peaks_and_few_segments_prove_little():
    for laps in (2, 10):
        data = shaken(noise=1e-6, laps=laps)
        (chart,) = spectrum_charts(data, 4000)
        assert chart.panels[1].ticks == ()
        command = data.schemes[0].result["command"][:, 0]
        start, stop = data.schemes[0].metrics.judged.ranges[0]
        _, power = welch(command[start:stop], 1.0 / PERIOD, nperseg=2000, scaling="spectrum")
        np.testing.assert_allclose(chart.panels[1].curves[0].y[:-1], np.sqrt(2.0 * power[1:-1]), rtol=1e-9)
        level = np.sqrt(np.mean(np.square(chart.panels[1].curves[0].y[5:-5])))
        assert level == pytest.approx(np.sqrt(2.0 * 2.0 * 1.5 * PERIOD / 2.0), rel=0.1)  # two-sided, as power of a sine, Hann


def test_short_stretches_and_gaps_in_a_signal_have_no_spectrum():
    data = shaken(3e-6)
    run = data.schemes[0]
    brief = replace(run, metrics=replace(run.metrics, judged=Judged(((0, 200), (300, 500)), "cutting moves")))
    assert spectrum_charts(replace(data, schemes=(brief,)), 4000) == ()
    command = np.array(run.result["command"])
    command[run.metrics.judged.samples[50], 0] = np.nan
    holed = replace(run, result=run.result.with_signals(command=Signal(command, synthetic.BOTH, "A")))
    (chart,) = spectrum_charts(replace(data, schemes=(holed,)), 4000)
    assert [panel.y_label for panel in chart.panels] == ["part error [um]"]


def test_quantiles_are_those_of_the_gamma_distribution():
    for count in (1, 2, 7, 60):
        for probability in (1e-4, 0.5, 1.0 - 1e-4):
            assert _quantile(count, probability) == pytest.approx(gammaincinv(count, probability), rel=1e-9)
