"""Exponential, logarithm and trigonometry as polynomials without branches, for lanes; in plain Python too.

`fma` and the functions on the bits of a number become single operations of a graph.
"""

from __future__ import annotations

import math
from fractions import Fraction

from contourlab.primitives import clip, copysign, fabs, floor, minimum, rint, select, sqrt


def fma(a: float, b: float, c: float) -> float:
    """Return a*b + c in one rounding."""
    if not all(map(math.isfinite, (a, b, c))):
        return c if math.isfinite(a) and math.isfinite(b) else a * b + c
    exact = Fraction(a) * Fraction(b) + Fraction(c)
    try:
        return float(exact) if exact else a * b + c  # with the sign of zero
    except OverflowError:
        return math.inf if exact > 0 else -math.inf


def pow2(n: float) -> float:
    """Return 2**n for a whole n in [-1022, 1023]."""
    return math.ldexp(1.0, int(n))


def exponent(x: float) -> float:
    """Return the binary exponent of a positive normal number, so that x / 2**e lies in [1, 2)."""
    return float(math.frexp(x)[1] - 1)


def odd(n: float) -> bool:
    """Return whether a whole number is odd."""
    return bool(int(n) & 1)


def twos(n: float) -> bool:
    """Return whether the second bit of a whole number is set."""
    return bool(int(n) & 2)


def _expm1_reduced(x: float) -> tuple[float, float]:
    """Return n and e**r - 1 for x = n ln 2 + r with |r| <= ln 2 / 2.

    (e**r - 1 - r) / r**2 is the polynomial that interpolates it at ten Chebyshev points: e**r to 1.3e-17. Estrin's scheme (pairs, then
    pairs of pairs) lets terms run in parallel, unlike Horner's.
    """
    n = rint(x * 1.4426950408889634074)
    r = fma(-n, 6.93147180369123816490e-01, x)
    r = fma(-n, 1.90821492927058770002e-10, r)
    r2 = r * r
    r4 = r2 * r2
    a = fma(r, 0.16666666666666669, 0.5000000000000001)
    b = fma(r, 0.008333333333330008, 0.041666666666624115)
    c = fma(r, 0.0001984126986320094, 0.001388888891721834)
    d = fma(r, 2.7557268299267734e-06, 2.4801521290566992e-05)
    e = fma(r, 2.5100445462573073e-08, 2.7620090550614496e-07)
    q = fma(fma(e, r4, fma(d, r2, c)), r4, fma(b, r2, a))
    return n, fma(q, r2, r)


def exp(x: float) -> float:
    n, p = _expm1_reduced(clip(x, -700.0, 709.0))
    return select(x <= -700.0, 0.0, pow2(n) * (1.0 + p))


def expm1(x: float) -> float:
    """Return e**x - 1 without cancellation."""
    n, p = _expm1_reduced(clip(x, -700.0, 709.0))
    s = pow2(n)
    return fma(s, p, s - 1.0)


def tanh(x: float) -> float:
    e = expm1(2.0 * minimum(fabs(x), 20.0))
    return copysign(e / (e + 2.0), x)


def log(x: float) -> float:
    """Return log x = e ln 2 + 2 artanh((m - 1)/(m + 1)), m in [sqrt(1/2), sqrt 2): odd series to the 23rd power."""
    e = exponent(x)
    m = x * pow2(-e)
    high = m > 1.4142135623730951
    m = select(high, 0.5 * m, m)
    e = select(high, e + 1.0, e)
    f = (m - 1.0) / (m + 1.0)
    z = f * f
    q = 1.0 / 23.0
    for n in (21.0, 19.0, 17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0, 1.0):
        q = fma(q, z, 1.0 / n)
    found = fma(e, 1.90821492927058770002e-10, 2.0 * f * q) + e * 6.93147180369123816490e-01
    return select(2.2250738585072014e-308 <= x < math.inf, found, select(x >= 0.0, copysign(math.inf, x - 1.0), math.nan))


def _sincos_reduced(x: float) -> tuple[float, float, float]:
    """Return n, sin r and cos r for x = n pi/2 + r, by Cody-Waite in three parts."""
    n = rint(x * 0.63661977236758134308)
    r = fma(-n, 1.57079632673412561417e00, x)
    r = fma(-n, 6.07710050630396597660e-11, r)
    r = fma(-n, 2.02226624879595063154e-21, r)
    z = r * r
    z2 = z * z
    s = fma(z, 1.58969099521155010221e-10, -2.50507602534068634195e-08)
    s = fma(s, z2, fma(z, 2.75573137070700676789e-06, -1.98412698298579493134e-04))
    s = fma(s, z2, fma(z, 8.33333333332248946124e-03, -1.66666666666666324348e-01))
    s = fma(s * z, r, r)
    c = fma(z, -1.13596475577881948265e-11, 2.08757232129817482790e-09)
    c = fma(c, z2, fma(z, -2.75573143513906633035e-07, 2.48015872894767294178e-05))
    c = fma(c, z2, fma(z, -1.38888888888741095749e-03, 4.16666666666666019037e-02))
    c = fma(c, z2, fma(-0.5, z, 1.0))
    return n, s, c


def sin(x: float) -> float:
    n, s, c = _sincos_reduced(x)
    a = select(odd(n), c, s)
    return select(twos(n), -a, a)


def cos(x: float) -> float:
    n, s, c = _sincos_reduced(x)
    b = select(odd(n), s, c)
    return select(twos(n + 1.0), -b, b)


def tan(x: float) -> float:
    return sin(x) / cos(x)


def atan(x: float) -> float:
    """Return the arc tangent: one of five intervals is moved to 0, as in fdlibm."""
    a = fabs(x)
    near, middle, far = a < 0.4375, a < 0.6875, a < 1.1875
    t = select(far, (a - 1.0) / (a + 1.0), select(a < 2.4375, (a - 1.5) / (1.0 + 1.5 * a), -1.0 / a))
    t = select(near, a, select(middle, (2.0 * a - 1.0) / (2.0 + a), t))
    high = select(far, 0.7853981633974483, select(a < 2.4375, 0.982793723247329, 1.5707963267948966))
    low = select(far, 3.061616997868383e-17, select(a < 2.4375, 1.3903311031230998e-17, 6.123233995736766e-17))
    high = select(near, 0.0, select(middle, 0.46364760900080609, high))
    low = select(near, 0.0, select(middle, 2.2698777452961687e-17, low))
    z = t * t
    s = fma(z, 1.62858201153657823623e-02, -3.65315727442169155270e-02)
    s = fma(s, z, 4.97687799461593236017e-02)
    s = fma(s, z, -5.83357013379057348645e-02)
    s = fma(s, z, 6.66107313738753120669e-02)
    s = fma(s, z, -7.69187620504482999495e-02)
    s = fma(s, z, 9.09088713343650656196e-02)
    s = fma(s, z, -1.11111104054623557880e-01)
    s = fma(s, z, 1.42857142725034663711e-01)
    s = fma(s, z, -1.99999999998764832476e-01)
    s = fma(s, z, 3.33333333333329318027e-01)
    return copysign(high - ((t * (z * s) - low) - t), x)


def atan2(y: float, x: float) -> float:
    a, b = fabs(y), fabs(x)
    ratio = select(a == b, select(a == 0.0, 0.0, 1.0), a / select(b > 0.0, b, 1e-300 * minimum(a, 1.0)))
    angle = atan(ratio)
    angle = select(copysign(1.0, x) < 0.0, 3.141592653589793 - (angle - 1.2246467991473532e-16), angle)
    return select(x == x, copysign(angle, y), x)


def asin(x: float) -> float:
    return atan2(x, sqrt((1.0 - x) * (1.0 + x)))


def acos(x: float) -> float:
    return atan2(sqrt((1.0 - x) * (1.0 + x)), x)


def fmod(a: float, b: float) -> float:
    """Return the remainder with the sign of a: exact while the quotient is below 2**53, else NaN."""
    x, y = fabs(a), fabs(b)
    n = floor(x / y)
    r = fma(-n, y, x)
    r = select(r < 0.0, r + y, r)
    r = select(r >= y, r - y, r)
    r = select(n < 9007199254740992.0, r, math.nan)
    return copysign(select(x < y == math.inf, x, r), a)


def unbounded_exp(x: float) -> float:
    """Return e**x, and infinity where `exp` stays at e**709."""
    return select(x > 709.0, math.inf, exp(x))


def power(a: float, b: float) -> float:
    """Return a**b, |b log a| eps off."""
    x = fabs(a)
    made = select(b == 0.0 or a == 1.0 or (a == -1.0 and fabs(b) == math.inf), 1.0, unbounded_exp(b * log(x)))
    large = fabs(b) >= 9007199254740992.0  # and even
    whole = select(large, 0.0, floor(b))
    turned = select(large or x == math.inf or whole == b, select(odd(whole) and whole == b, -made, made), math.nan)
    return select(a < 0.0, turned, made)
