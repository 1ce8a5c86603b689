"""Zero-phase-error tracking: a filter that passes the reference through an inverse of the closed loop.

The response of position to the reference is z^-d B(z^-1)/A(z^-1). B is split into B+, whose zeros can be cancelled, and B-, whose zeros
lie outside the unit circle, or so near to it on the left that cancelling them would make the command ring. Then

    F(z) = A(z^-1) B-(z) z^d / (B+(z^-1) B-(1)^2)

gives position over reference F(z) G(z) = B-(z) B-(z^-1)/B-(1)^2, which is real at all frequencies, so without phase, and 1 at rest.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Complex
from contourlab.components.feedforward.laws import MAX_ORDER, ZPETC
from contourlab.errors import ComponentError, refuse

if TYPE_CHECKING:
    from contourlab.analysis.linear.sampled_loop import SampledLoop


RESIDUAL = 1e-6
"""Largest relative error of the polynomials of a loop."""


def zpetc_design(loop: SampledLoop, *, radius: float = 0.9) -> ZPETC:
    """Return the zero-phase filter of a closed loop, transport delays and hold included.

    The filter shifts the reference position, not its velocity and acceleration. A controller that feeds those forward is therefore refused.

    Parameters
    ----------
    loop : SampledLoop
        Of `contourlab.analysis.linear.sampled_loop`; stable.
    radius : float, in (0, 1)
        Zeros in the left half plane farther out than this are not cancelled.

    Raises
    ------
    ComponentError
        If the loop is unstable, feeds derivatives of the reference forward, does not reach the reference at rest, has more zeros to cancel
        than the component allows, or the relative error of its polynomials exceeds `RESIDUAL`.
    """
    refuse(not loop.stable, ComponentError, "the loop is unstable: no zero-phase filter can be made for it")
    a = _real_polynomial(loop.poles)
    n = 1 << max(6, (4 * a.size - 1).bit_length())
    # Half-way between the usual points of a Fourier transform, which avoids 0 and the Nyquist frequency.
    angle = math.pi * (2.0 * np.arange(n // 2) + 1.0) / n
    response = loop.response(angle / loop.servo_period)
    g, z = response.modified, np.exp(1j * angle)
    if np.abs(response.closed_loop - g).max() > 1e-9 * np.abs(g).max():
        raise ComponentError(
            "the controller feeds velocity or acceleration of the reference forward, which zpetc cannot shift: "
            "set that feedforward to zero, or leave zpetc out"
        )
    delay, b = _numerator(g * _value(a, z), angle, n)
    fitted = z**-delay * _value(b, z) / _value(a, z)
    residual = float((np.abs(fitted - g) / np.maximum(np.abs(g), 1e-3 * np.abs(g).max())).max())
    if not residual <= RESIDUAL:
        raise ComponentError(f"the polynomials of the loop have a relative error of {residual:.2g}: too many poles lie near each other")
    return zero_phase_filter(b, a, delay, radius)


def zero_phase_filter(numerator: ArrayLike, denominator: ArrayLike, delay: int = 0, radius: float = 0.9) -> ZPETC:
    """Return the zero-phase filter of z^-delay (b_0 + b_1 z^-1 + ...)/(a_0 + a_1 z^-1 + ...).

    Parameters
    ----------
    numerator, denominator : array_like
        b and a, with b_0 and a_0 other than zero; a's zeros inside the unit circle; b(1) = a(1).
    delay : int, >= 0
        Servo periods.
    radius : float, in (0, 1)
        Zeros in the left half plane farther out than this are not cancelled.

    >>> made = zero_phase_filter([0.06, 0.04], [1.0, -0.9], 1)
    >>> made.lead, np.round(made.denominator, 6).tolist(), np.round(made.numerator, 6).tolist()
    (1.0, [1.0, 0.666667], [16.666667, -15.0])
    """
    b, a = (np.trim_zeros(np.atleast_1d(np.asarray(values, dtype=float)), "b") for values in (numerator, denominator))
    steady = b.sum() / a.sum()
    refuse(not abs(steady - 1.0) <= 1e-6, ComponentError, f"at rest the position is {steady:.9g} of the reference: it has to be 1")
    zeros = np.roots(b)
    cancel = (np.abs(zeros) < 1.0) & ((zeros.real > 0.0) | (np.abs(zeros) <= radius))
    cancelled, kept = zeros[cancel], zeros[~cancel]
    if cancelled.size > MAX_ORDER:
        raise ComponentError(f"the loop has {cancelled.size} zeros to cancel; the filter takes {MAX_ORDER} at most")
    below, mirrored = _real_polynomial(cancelled), _real_polynomial(kept)
    above = np.convolve(a, mirrored[::-1])
    # Scaled to exactly 1 at rest.
    above *= below.sum() / above.sum()
    return ZPETC(numerator=tuple(above.tolist()), denominator=tuple(below.tolist()), lead=float(delay + kept.size))


def _value(coefficients: Array, z: Complex) -> Complex:
    """Return c_0 + c_1 z^-1 + ... at each z."""
    return np.asarray(np.polyval(coefficients[::-1], 1.0 / z))


def _real_polynomial(roots: Complex) -> Array:
    """Return the coefficients of the product of 1 - root z^-1; roots at zero drop out.

    Computed from its values on the unit circle: root by root, the many poles of a delay would lose all digits.
    """
    n = 1 << max(4, (2 * roots.size).bit_length())
    around = np.exp(2j * math.pi * np.arange(n) / n)
    values = np.ones(n, dtype=complex)
    for root in roots:
        values *= 1.0 - root / around
    coefficients = np.real(np.fft.ifft(values))[: roots.size + 1]
    last = np.flatnonzero(np.abs(coefficients) > 1e-15 * np.abs(coefficients).max())[-1]
    return np.asarray(coefficients[: last + 1], dtype=float)


def _numerator(values: Complex, angle: Array, n: int) -> tuple[int, Array]:
    """Return delay and coefficients of a polynomial in z^-1 known at the upper half of n points of the unit circle.

    Its degree is far below n: the coefficients of high powers measure the rounding.
    """
    # The points are half a step off those of the transform: rotate each power to correct this.
    powers = np.real(np.exp(1j * angle[0] * np.arange(n)) * np.fft.ifft(np.concatenate([values, values[::-1].conj()])))
    floor = max(10.0 * np.abs(powers[n // 2 :]).max(), 1e-13 * np.abs(powers).max())
    kept = np.flatnonzero(np.abs(powers) > floor)
    if kept.size == 0 or kept[-1] >= n // 2:
        raise ComponentError("the response to the reference is not an invertible rational function of z")
    return int(kept[0]), np.asarray(powers[kept[0] : kept[-1] + 1], dtype=float)
