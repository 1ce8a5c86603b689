"""The primitives in compiled code: LLVM instructions, libm calls, branch-free polynomials for lanes, unrolled vectors."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import njit, types
from numba.extending import overload

from contourlab.engine.memory import NUMBER, instruction, load_ring, load_table, truncate
from contourlab.native.compile import INNER

# No nnan/ninf: a flag that assumes finite numbers would fold away every check for them.
FAST = {"contract", "nsz", "arcp"}
OPTIONS: dict[str, Any] = {"fastmath": FAST, "error_model": "numpy", "boundscheck": False}
INLINE: dict[str, Any] = {**OPTIONS, **INNER, "forceinline": True}

_DOUBLE = ir.DoubleType()
_INT = ir.IntType(64)


def _unary(name: str) -> Any:
    @instruction(NUMBER, NUMBER)
    def operation(builder: Any, x: Any) -> Any:
        return builder.call(builder.module.declare_intrinsic(f"llvm.{name}", [_DOUBLE]), [x])

    return operation


def _compare(predicate: str) -> Any:
    @instruction(NUMBER, NUMBER, NUMBER)
    def operation(builder: Any, a: Any, b: Any) -> Any:
        return builder.select(builder.fcmp_ordered(predicate, a, b), a, b)

    return operation


rint = _unary("rint")
fabs = _unary("fabs")
floor = _unary("floor")
sqrt = _unary("sqrt")
minimum = _compare("<")
maximum = _compare(">")


@instruction(NUMBER, NUMBER, NUMBER)
def copysign(builder: Any, x: Any, y: Any) -> Any:
    function = builder.module.declare_intrinsic("llvm.copysign", [_DOUBLE], ir.FunctionType(_DOUBLE, [_DOUBLE] * 2))
    return builder.call(function, [x, y])


@instruction(NUMBER, NUMBER, NUMBER, NUMBER)
def fma(builder: Any, a: Any, b: Any, c: Any) -> Any:
    """Return a*b + c in one rounding."""
    return builder.fma(a, b, c)


@instruction(NUMBER, types.boolean, NUMBER, NUMBER)
def select(builder: Any, condition: Any, a: Any, b: Any) -> Any:
    """Return one of two evaluated sides, without a branch."""
    flag = condition if condition.type == ir.IntType(1) else builder.trunc(condition, ir.IntType(1))
    return builder.select(flag, a, b)


@njit(**INLINE)
def clip(x: float, low: float, high: float) -> float:
    return minimum(maximum(x, low), high)


@njit(**INLINE)
def lookup(table: int, index: float) -> float:
    """Return an entry of the table at an address; a gather if the index differs by lane."""
    return load_table(table, truncate(index))


def make_delayed(width: int) -> Any:
    """Return `delayed` for rings whose rows are `width` doubles wide.

    A ring is a pair (address of this lane's column, length - 1); the length is a power of two, so that the index wraps by a mask.
    """

    @njit(**INLINE)
    def delayed(ring: Any, clock: Any, n: float) -> float:
        return load_ring(ring[0], (truncate(clock[0] - n) & ring[1]) * width)

    return delayed


@instruction(NUMBER, NUMBER)
def pow2(builder: Any, n: Any) -> Any:
    """Return 2**n for a whole n in [-1022, 1023], by the exponent's bits."""
    bits = builder.add(builder.fptosi(n, _INT), ir.Constant(_INT, 1023))
    return builder.bitcast(builder.shl(bits, ir.Constant(_INT, 52)), _DOUBLE)


@instruction(NUMBER, NUMBER)
def exponent_of(builder: Any, x: Any) -> Any:
    """Return the binary exponent of a positive normal number, so that x / 2**e lies in [1, 2)."""
    bits = builder.lshr(builder.bitcast(x, _INT), ir.Constant(_INT, 52))
    return builder.sitofp(builder.sub(bits, ir.Constant(_INT, 1023)), _DOUBLE)


@instruction(types.boolean, NUMBER, NUMBER)
def parity(builder: Any, n: Any, bit: Any) -> Any:
    """Tell whether a bit (1 or 2) of a whole number is set."""
    return builder.icmp_signed("!=", builder.and_(builder.fptosi(n, _INT), builder.fptosi(bit, _INT)), ir.Constant(_INT, 0))


@instruction(NUMBER, NUMBER, NUMBER, NUMBER)
def hashed_uniform(builder: Any, stream: Any, k: Any, draw: Any) -> Any:
    """Return the number of the counter-based generator `primitives.uniform`, bit for bit."""

    def times(value: Any, factor: int) -> Any:
        return builder.mul(value, ir.Constant(_INT, factor))

    def fold(value: Any, shift: int) -> Any:
        return builder.xor(value, builder.lshr(value, ir.Constant(_INT, shift)))

    whole = [builder.fptosi(number, _INT) for number in (stream, k, draw)]
    z = builder.add(times(whole[0], 0x9E3779B97F4A7C15), times(whole[1], 0xD1342543DE82EF95))
    z = builder.add(z, times(whole[2], 0x2545F4914F6CDD1D))
    z = times(fold(z, 30), 0xBF58476D1CE4E5B9)
    z = times(fold(z, 27), 0x94D049BB133111EB)
    top = builder.sitofp(builder.lshr(fold(z, 31), ir.Constant(_INT, 12)), _DOUBLE)
    return builder.fmul(builder.fadd(top, ir.Constant(_DOUBLE, 0.5)), ir.Constant(_DOUBLE, 2.0**-52))


# --- libm: fastest for one variant -------------------------------------------------------------------------------------------------


@njit(**INLINE)
def libm_exp(x: float) -> float:
    return math.exp(minimum(x, 709.0)) if x > -700.0 else 0.0


@njit(**INLINE)
def libm_log(x: float) -> float:
    return math.log(x)


@njit(**INLINE)
def libm_tanh(x: float) -> float:
    return math.tanh(x)


# --- polynomials: for lanes, since the vectoriser cannot see into libm --------------------------------------------------------------


@njit(**INLINE)
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


@njit(**INLINE)
def poly_exp(x: float) -> float:
    n, p = _expm1_reduced(clip(x, -700.0, 709.0))
    return select(x > -700.0, pow2(n) * (1.0 + p), 0.0)


@njit(**INLINE)
def poly_tanh(x: float) -> float:
    n, p = _expm1_reduced(2.0 * minimum(fabs(x), 20.0))
    s = pow2(n)
    e = fma(s, p, s - 1.0)
    return copysign(e / (e + 2.0), x)


@njit(**INLINE)
def poly_log(x: float) -> float:
    """Return log x = e ln 2 + 2 artanh((m - 1)/(m + 1)), m in [sqrt(1/2), sqrt 2): odd series to the 23rd power."""
    e = exponent_of(x)
    m = x * pow2(-e)
    high = m > 1.4142135623730951
    m = select(high, 0.5 * m, m)
    e = select(high, e + 1.0, e)
    f = (m - 1.0) / (m + 1.0)
    z = f * f
    q = 1.0 / 23.0
    q = fma(q, z, 1.0 / 21.0)
    q = fma(q, z, 1.0 / 19.0)
    q = fma(q, z, 1.0 / 17.0)
    q = fma(q, z, 1.0 / 15.0)
    q = fma(q, z, 1.0 / 13.0)
    q = fma(q, z, 1.0 / 11.0)
    q = fma(q, z, 1.0 / 9.0)
    q = fma(q, z, 1.0 / 7.0)
    q = fma(q, z, 1.0 / 5.0)
    q = fma(q, z, 1.0 / 3.0)
    q = fma(q, z, 1.0)
    return fma(e, 1.90821492927058770002e-10, 2.0 * f * q) + e * 6.93147180369123816490e-01


@njit(**INLINE)
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


@njit(**INLINE)
def poly_sin(x: float) -> float:
    n, s, c = _sincos_reduced(x)
    a = select(parity(n, 1.0), c, s)
    return select(parity(n, 2.0), -a, a)


@njit(**INLINE)
def poly_cos(x: float) -> float:
    n, s, c = _sincos_reduced(x)
    b = select(parity(n, 1.0), s, c)
    return select(parity(n + 1.0, 2.0), -b, b)


def maths(width: int) -> dict[str, Callable[..., Any]]:
    """Return the primitives for `width` variants.

    For a single variant libm's exp, log and tanh have less latency; sine and cosine together are faster as polynomials.
    """
    curves = (poly_exp, poly_log, poly_tanh) if width > 1 else (libm_exp, libm_log, libm_tanh)
    made = {**dict(zip(("exp", "log", "tanh"), curves, strict=True)), "sin": poly_sin, "cos": poly_cos, "uniform": hashed_uniform}
    rounding = {"sqrt": sqrt, "fabs": fabs, "floor": floor, "rint": rint, "copysign": copysign}
    choosing = {"minimum": minimum, "maximum": maximum, "clip": clip, "select": select}
    return {**made, **rounding, **choosing, "lookup": lookup, "delayed": make_delayed(width)}


def _written_out(arguments: str, term: str, count: int, total: bool) -> Any:
    terms = [term.replace("#", str(i)) for i in range(count)]
    body = " + ".join(terms) if total else f"({', '.join(terms)},)"
    scope: dict[str, Any] = {}
    exec(f"def implementation({arguments}):\n    return {body}\n", scope)
    return scope["implementation"]


def _length(*vectors: Any) -> int | None:
    if all(isinstance(v, types.BaseTuple) for v in vectors) and len({v.count for v in vectors}) == 1:
        return int(vectors[0].count)
    return None


def dot(a, b): ...  # type: ignore[no-untyped-def]
def add(a, b): ...  # type: ignore[no-untyped-def]
def sub(a, b): ...  # type: ignore[no-untyped-def]
def scale(factor, a): ...  # type: ignore[no-untyped-def]
def lincomb(p, a, q, b): ...  # type: ignore[no-untyped-def]


def _overloaded(operation: Any, term: str, total: bool = False) -> None:
    """Unroll an operation on two vectors for each length."""

    @overload(operation, jit_options=INLINE)
    def written(a, b):  # type: ignore[no-untyped-def]
        n = _length(a, b)
        return None if n is None else _written_out("a, b", term, n, total)


_overloaded(dot, "a[#] * b[#]", total=True)
_overloaded(add, "a[#] + b[#]")
_overloaded(sub, "a[#] - b[#]")


@overload(scale, jit_options=INLINE)
def _scale(factor, a):  # type: ignore[no-untyped-def]
    n = _length(a)
    return None if n is None else _written_out("factor, a", "factor * a[#]", n, False)


@overload(lincomb, jit_options=INLINE)
def _lincomb(p, a, q, b):  # type: ignore[no-untyped-def]
    n = _length(a, b)
    return None if n is None else _written_out("p, a, q, b", "p * a[#] + q * b[#]", n, False)


VECTOR_OPERATIONS: dict[str, Callable[..., Any]] = {"dot": dot, "add": add, "sub": sub, "scale": scale, "lincomb": lincomb}
