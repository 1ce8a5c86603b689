"""Describing function of a gap, with and without shaft damping: textbook values, and stepped motion."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from contourlab.analysis.backlash.lure import contact_phases, harmonic, inverse_dead_zone_gain
from contourlab.errors import ParameterError


@settings(max_examples=30, deadline=None)
@given(amplitude=st.floats(1.001, 100.0), order=st.sampled_from([1, 3, 5, 7]))
def test_harmonics_of_a_dead_zone(amplitude: float, order: int) -> None:
    """Fourier coefficients by quadrature; the first is the textbook formula."""
    begin = math.asin(1.0 / amplitude)
    wanted, _ = quad(lambda p: (amplitude * math.sin(p) - 1.0) * math.sin(order * p), begin, math.pi - begin, epsabs=1e-13)
    found = complex(harmonic(amplitude, 0.0, order))
    assert found.real == pytest.approx(2.0 / math.pi * wanted / amplitude, abs=1e-11)
    assert found.imag == pytest.approx(0.0, abs=1e-12)


@settings(max_examples=30, deadline=None)
@given(gain=st.floats(1e-9, 1.0 - 1e-9))
def test_the_inverse(gain: float) -> None:
    assert complex(harmonic(inverse_dead_zone_gain(gain), 0.0)).real == pytest.approx(gain, rel=1e-6, abs=1e-12)


def test_no_contact_no_torque() -> None:
    assert complex(harmonic(0.99, 0.5)) == 0.0
    with pytest.raises(ParameterError, match="gain"):
        inverse_dead_zone_gain(1.0)


def followed(amplitude: float, damping: float, order: int, n: int = 100_000) -> complex:
    """Return a harmonic by stepping through Nordin's model: contact, release at zero torque, relaxation of the shaft in between."""
    step, torque, twist, side = 2.0 * math.pi / n, np.zeros(n), 0.0, 0
    fade = math.exp(-step / damping)
    for k in range(2 * n):
        p = (k % n) * step
        d, rate = amplitude * math.sin(p), amplitude * math.cos(p)
        if side == 0:
            twist *= fade
            side = 1 if d - twist > 1.0 else -1 if d - twist < -1.0 else 0
        push = (d - side + damping * rate) if side else 0.0
        if push * side < 0.0:
            twist, side, push = d - side, 0, 0.0
        torque[k % n] = push
    return complex(2j * np.mean(torque * np.exp(-1j * order * step * np.arange(n))) / amplitude)


@pytest.mark.parametrize(("amplitude", "damping"), [(1.5, 0.3), (3.0, 2.0), (1.05, 0.05)])
@pytest.mark.parametrize("order", [1, 3])
def test_a_damped_shaft(amplitude: float, damping: float, order: int) -> None:
    assert complex(harmonic(amplitude, damping, order)) == pytest.approx(followed(amplitude, damping, order), abs=1e-4)


def test_without_a_gap_it_is_a_spring_and_a_damper() -> None:
    """For large amplitudes: k + j w d."""
    assert complex(harmonic(1e9, 0.4)) == pytest.approx(1.0 + 0.4j, rel=1e-6)


def test_little_damping_is_the_dead_zone() -> None:
    begin, end = contact_phases(2.0, 1e-9)
    assert (float(begin), float(end)) == pytest.approx((math.pi / 6.0, 5.0 * math.pi / 6.0), abs=1e-8)
