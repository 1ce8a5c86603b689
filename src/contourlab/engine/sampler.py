"""Sample the reference in machine code: spans of constant jerk along lines and arcs, with consecutive samples in lanes."""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

from types import FunctionType
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.engine.translate import polynomials
from contourlab.native.calls import instruction
from contourlab.native.kernel import kernel

# No nnan/ninf: a flag that assumes finite numbers would fold away every check for them. Of the others, `contract` and `arcp` (a sixth of
# the jerk) change a last digit and `nsz` the sign of a zero: nothing here counts, jumps or divides by what they touch.
FASTMATH = "contract", "nsz", "arcp"
_REGIONS = ("parameter", "input", "scratch", "output")


def _double() -> Any:
    from llvmlite import ir

    return ir.DoubleType()


def _whole(value: int | None = None) -> Any:
    from llvmlite import ir

    return ir.IntType(64) if value is None else ir.Constant(ir.IntType(64), value)


def _tagged(builder: Any, instruction: Any, region: str) -> Any:
    """Tell the vectoriser that the regions of memory never overlap."""
    module = builder.module
    domain = module.add_metadata(["contourlab"])
    nodes = {name: module.add_metadata([f"contourlab.{name}", domain]) for name in _REGIONS}
    instruction.set_metadata("alias.scope", module.add_metadata([nodes[region]]))
    instruction.set_metadata("noalias", module.add_metadata([nodes[name] for name in _REGIONS if name != region]))
    return instruction


def _place(builder: Any, address: Any, index: Any) -> Any:
    return builder.gep(builder.inttoptr(address, _double().as_pointer()), [index], inbounds=True)


def _load(region: str) -> Any:
    """Return ``load(address, index) -> float`` for one region of memory."""

    @instruction("f8 i8 i8")
    def load_at(builder: Any, address: Any, index: Any) -> Any:
        return _tagged(builder, builder.load(_place(builder, address, index)), region)

    return load_at


def _store(region: str) -> Any:
    """Return ``store(address, index, value)`` for one region of memory."""

    @instruction("void i8 i8 f8")
    def store_at(builder: Any, address: Any, index: Any, value: Any) -> None:
        _tagged(builder, builder.store(value, _place(builder, address, index)), region)

    return store_at


load_parameter, load_input, load_scratch = _load("parameter"), _load("input"), _load("scratch")
store_scratch, store_output = _store("scratch"), _store("output")


@instruction("i8 f8")
def truncate(builder: Any, x: Any) -> Any:
    """Return the whole part of a number, as an index."""
    return builder.fptosi(x, _whole())


def _compare(predicate: str) -> Any:
    @instruction("f8 f8 f8")
    def operation(builder: Any, a: Any, b: Any) -> Any:
        return builder.select(builder.fcmp_ordered(predicate, b, a), b, a)  # a NaN in a stays

    return operation


minimum, maximum = _compare("<"), _compare(">")


@instruction("f8 f8")
def _rint(builder: Any, x: Any) -> Any:
    return builder.call(builder.module.declare_intrinsic("llvm.rint", [_double()]), [x])


@instruction("f8 f8 f8 f8")
def _fma(builder: Any, a: Any, b: Any, c: Any) -> Any:
    return builder.fma(a, b, c)


@instruction("f8 b1 f8 f8")
def _select(builder: Any, condition: Any, a: Any, b: Any) -> Any:
    from llvmlite import ir

    flag = condition if condition.type == ir.IntType(1) else builder.trunc(condition, ir.IntType(1))
    return builder.select(flag, a, b)


def _bit(mask: int) -> Any:
    @instruction("b1 f8")
    def operation(builder: Any, n: Any) -> Any:
        return builder.icmp_signed("!=", builder.and_(builder.fptosi(n, _whole()), _whole(mask)), _whole(0))

    return operation


_OPERATIONS: dict[str, Any] = {"fma": _fma, "rint": _rint, "select": _select, "odd": _bit(1), "twos": _bit(2)}


def _with_operations(function: Any) -> Any:
    """Return a polynomial that calls instructions."""
    known = function.__globals__
    called = {name: _with_operations(known[name]) for name in function.__code__.co_names if name in known and name not in _OPERATIONS}
    return FunctionType(function.__code__, {"__name__": polynomials.__name__} | _OPERATIONS | called, function.__name__)


poly_sin, poly_cos = _with_operations(polynomials.sin), _with_operations(polynomials.cos)

SPAN_FIELDS = ("first", "last", "t0", "s0", "v0", "a0", "j", "end")
"""Samples [first, last); time, progress, speed and acceleration at the start of the span; its jerk; upper bound of progress."""
CURVE_FIELDS = ("first", "last", "offset", "angle", "rate")
"""Samples [first, last); progress at the start of the curve; angle there; change of angle per progress. Four numbers for each axis follow:

position = base + d s + u cos(angle + rate s) + v sin(angle + rate s).
"""
_SPANS, _CURVES = len(SPAN_FIELDS), len(CURVE_FIELDS)
_BLOCK = 1024
"""Samples of a curve that stay in the processor's cache."""


@kernel("i8 i8 f8 i8 i8 i8 i8", FASTMATH)
def _spans(spans, n_span, period, origin, progress, speed, acceleration):
    for i in range(n_span):
        row = spans + 8 * _SPANS * i
        first, last = truncate(load_parameter(row, 0)), truncate(load_parameter(row, 1))
        t0, s0, v0, a0 = load_parameter(row, 2), load_parameter(row, 3), load_parameter(row, 4), load_parameter(row, 5)
        jerk, end = load_parameter(row, 6), load_parameter(row, 7)
        for k in range(first, last):
            dt = float(origin + k) * period - t0
            store_output(progress, k, minimum(s0 + dt * (v0 + dt * (a0 / 2.0 + dt * jerk / 6.0)), end))
            store_output(speed, k, maximum(v0 + dt * (a0 + dt * jerk / 2.0), 0.0))
            store_output(acceleration, k, a0 + dt * jerk)


@kernel(" ".join(["i8"] * 9), FASTMATH)
def _curves(curves, n_curve, n_axis, progress, speed, acceleration, out, stride, scratch):
    for i in range(n_curve):
        row = curves + 8 * (_CURVES + 4 * n_axis) * i
        last = truncate(load_parameter(row, 1))
        for first in range(truncate(load_parameter(row, 0)), last, _BLOCK):
            part = min(_BLOCK, last - first)
            _turned(row, part, progress + 8 * first, scratch)
            for j in range(n_axis):
                here = out + 8 * (stride * j + first)
                _moved(row, j, part, speed + 8 * first, acceleration + 8 * first, here, 8 * stride * n_axis, scratch)


def _turned(row, n, progress, scratch):
    """Compute progress on the curve, cosine and sine, which all axes share."""
    offset, angle, rate = load_parameter(row, 2), load_parameter(row, 3), load_parameter(row, 4)
    if rate == 0.0:  # a line
        for k in range(n):
            store_scratch(scratch, k, load_input(progress, k) - offset)
            store_scratch(scratch, _BLOCK + k, 1.0)
            store_scratch(scratch, 2 * _BLOCK + k, 0.0)
    else:
        for k in range(n):
            s = load_input(progress, k) - offset
            store_scratch(scratch, k, s)
            store_scratch(scratch, _BLOCK + k, poly_cos(angle + rate * s))
            store_scratch(scratch, 2 * _BLOCK + k, poly_sin(angle + rate * s))


def _moved(row, j, n, speed, acceleration, here, step, scratch):
    """Compute position, velocity and acceleration of one axis."""
    rate, at = load_parameter(row, 4), _CURVES + 4 * j
    base, d, u, v = load_parameter(row, at), load_parameter(row, at + 1), load_parameter(row, at + 2), load_parameter(row, at + 3)
    square = rate * rate
    for k in range(n):
        s, c, w = load_scratch(scratch, k), load_scratch(scratch, _BLOCK + k), load_scratch(scratch, 2 * _BLOCK + k)
        moved, first_derivative = u * c + v * w, d + rate * (v * c - u * w)
        pace = load_input(speed, k)
        store_output(here, k, moved + (base + s * d))
        store_output(here + step, k, pace * first_derivative)
        store_output(here + 2 * step, k, first_derivative * load_input(acceleration, k) - square * moved * (pace * pace))


def along_spans(spans: Array, period: float, origin: int, progress: Array, speed: Array, acceleration: Array) -> None:
    """Evaluate the motion along a path.

    Parameters
    ----------
    spans : ndarray (n_span, 8)
        SPAN_FIELDS of each span; samples count from `origin`.
    period : float [s]
        Of the samples.
    origin : int
        Number of the first sample.
    progress, speed, acceleration : ndarray (n,) [m, m/s, m/s^2]
        Output.
    """
    spans = np.ascontiguousarray(spans)
    _spans(spans.ctypes.data, len(spans), period, origin, progress.ctypes.data, speed.ctypes.data, acceleration.ctypes.data)


def along_curves(curves: Array, progress: Array, speed: Array, acceleration: Array, out: Array) -> None:
    """Evaluate position, velocity and acceleration of each axis.

    Parameters
    ----------
    curves : ndarray (n_curve, 5 + 4 n_axis)
        CURVE_FIELDS of each curve, and base, d, u, v for each axis.
    progress, speed, acceleration : ndarray (n,) [m, m/s, m/s^2]
        Along the path.
    out : ndarray (3 n_axis, n)
        Output at the samples of the curves: positions, velocities, accelerations; each row is contiguous.
    """
    curves = np.ascontiguousarray(curves)
    scratch = np.empty((3, _BLOCK))
    addresses = (progress.ctypes.data, speed.ctypes.data, acceleration.ctypes.data, out.ctypes.data)
    _curves(curves.ctypes.data, len(curves), len(out) // 3, *addresses, out.strides[0] // out.itemsize, scratch.ctypes.data)
