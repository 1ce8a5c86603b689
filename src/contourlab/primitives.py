"""The functions that a component's `step` may call, in plain Python.

A step works on floats and tuples of floats. Plain Python runs it unchanged and is the oracle. The engine compiles the same source with its
own version of each function below (libm for a single variant, branch-free polynomials for lanes).

No function raises for a number, so that compiled code and plain Python take the same path. A NaN stays a NaN in every one of them. An
argument without a result, such as the square root of -1, gives a NaN too. So do an index outside of a table and a delay longer than the
past that is kept: the run stops and names axis and time.

Conditions: `select(condition, a, b)` evaluates both sides and suits lanes; `if` is allowed too where the sides are cheap.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

__all__ = [
    "Clock",
    "add",
    "clip",
    "copysign",
    "cos",
    "delayed",
    "dot",
    "exp",
    "fabs",
    "floor",
    "lincomb",
    "log",
    "lookup",
    "maximum",
    "minimum",
    "normal",
    "rint",
    "scale",
    "select",
    "sin",
    "sqrt",
    "sub",
    "tanh",
    "uniform",
]

Vector = tuple[float, ...]


class Clock(NamedTuple):
    """Time in a step: tick index, time k*dt (never a running sum) and the step's own period."""

    k: float
    t: float
    dt: float


class Table(tuple[float, ...]):
    """A read-only table in a step: flat numbers, read with `lookup`."""


class Ring:
    """The past of one input port in a step: `delayed(ring, clock, n)` is its value n ticks ago."""

    def __init__(self, length: int, initial: float = 0.0) -> None:
        self.values = [initial] * length

    def push(self, k: int, value: float) -> None:
        """Store the value of tick `k`."""
        self.values[k % len(self.values)] = value


def exp(x: float) -> float:
    """Return e**x; exactly 0 from -700 down, to avoid denormal numbers, and e**709 from 709 up."""
    return 0.0 if x <= -700.0 else math.exp(minimum(x, 709.0))


def log(x: float) -> float:
    """Return the natural logarithm; -inf at 0, in lanes also of what is smaller than a normal number, and NaN below 0."""
    return math.log(x) if x > 0.0 else -math.inf if x == 0.0 else math.nan


def tanh(x: float) -> float:
    """Return the hyperbolic tangent."""
    return math.tanh(x)


def sin(x: float) -> float:
    """Return the sine; |x| < 1e6 for full accuracy in lanes."""
    return math.sin(x) if math.isfinite(x) else math.nan


def cos(x: float) -> float:
    """Return the cosine; |x| < 1e6 for full accuracy in lanes."""
    return math.cos(x) if math.isfinite(x) else math.nan


def sqrt(x: float) -> float:
    """Return the square root; NaN below 0."""
    return math.sqrt(x) if x >= 0.0 else math.nan


def fabs(x: float) -> float:
    """Return the magnitude."""
    return math.fabs(x)


def floor(x: float) -> float:
    """Return the largest whole number up to x; zero keeps the sign of x."""
    return math.copysign(math.floor(x), x) if math.isfinite(x) else x


def rint(x: float) -> float:
    """Return the nearest whole number; halves go to the even one, and zero keeps the sign of x."""
    return math.copysign(round(x), x) if math.isfinite(x) else x


def copysign(x: float, y: float) -> float:
    """Return the magnitude of x with the sign of y; NaN if y is."""
    return math.copysign(x, y) if y == y else y


def minimum(a: float, b: float) -> float:
    """Return the smaller of two numbers, b if they are equal; NaN if either is."""
    return (a if a < b else b) if a == a else a


def maximum(a: float, b: float) -> float:
    """Return the larger of two numbers, b if they are equal; NaN if either is."""
    return (a if a > b else b) if a == a else a


def clip(x: float, low: float, high: float) -> float:
    """Return x held between two bounds; NaN if x is. A bound that is NaN does not bound."""
    x = low if low > x else x
    return high if high < x else x


def select(condition: bool, a: float, b: float) -> float:
    """Return a where the condition holds, else b; both are evaluated."""
    return a if condition else b


def dot(a: Vector, b: Vector) -> float:
    """Return the scalar product of two vectors."""
    total = a[0] * b[0]
    for i in range(1, len(a)):
        total += a[i] * b[i]
    return total


def add(a: Vector, b: Vector) -> Vector:
    """Return a + b."""
    return tuple(p + q for p, q in zip(a, b, strict=True))


def sub(a: Vector, b: Vector) -> Vector:
    """Return a - b."""
    return tuple(p - q for p, q in zip(a, b, strict=True))


def scale(factor: float, a: Vector) -> Vector:
    """Return factor * a."""
    return tuple(factor * p for p in a)


def lincomb(p: float, a: Vector, q: float, b: Vector) -> Vector:
    """Return p*a + q*b."""
    return tuple(p * u + q * v for u, v in zip(a, b, strict=True))


def lookup(table: Sequence[float], index: float) -> float:
    """Return the entry of a read-only table at the whole part of an index, NaN outside of the table."""
    return table[int(index)] if -1.0 < index < len(table) else math.nan


def delayed(ring: Ring, clock: Clock, n: float) -> float:
    """Return the value of the ring port `n` whole ticks ago; n = 0 is now. NaN for a negative n, and beyond the oldest value kept."""
    size = len(ring.values)
    return ring.values[int(clock.k - n) % size] if -1.0 < n <= size - 1.0 else math.nan


_MASK = (1 << 64) - 1


def _mix(z: int) -> int:
    # The finaliser of splitmix64 (Steele, Lea & Flood 2014): every input bit reaches every output bit.
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & _MASK
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & _MASK
    return z ^ (z >> 31)


def uniform(stream: float, k: float, draw: float) -> float:
    """Return a number in (0, 1) that depends on stream, tick and draw alone: noise without a state.

    Parameters
    ----------
    stream : float
        Whole number below 2**53 that names seed, variant, trial, axis and signal.
    k : float
        Tick index.
    draw : float
        Index of the number within the tick.

    Returns NaN if the three do not fit into 64 bits.
    """
    if not fabs(stream) + fabs(k) + fabs(draw) < 2.0**63:
        return math.nan
    z = _mix((int(stream) * 0x9E3779B97F4A7C15 + int(k) * 0xD1342543DE82EF95 + int(draw) * 0x2545F4914F6CDD1D) & _MASK)
    return ((z >> 12) + 0.5) * 2.0**-52


def normal(stream: float, k: float) -> float:
    """Return a standard normal number that depends on stream and tick alone (Box & Muller 1958)."""
    return sqrt(-2.0 * log(uniform(stream, k, 0.0))) * cos(2.0 * math.pi * uniform(stream, k, 1.0))
