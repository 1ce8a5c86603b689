"""Sample the reference in machine code: spans of constant jerk along lines and arcs, with consecutive samples in lanes."""

from __future__ import annotations

import inspect
import sys
from functools import cache
from typing import Any

import numpy as np
from numba import njit

from contourlab.arrays import Array
from contourlab.engine import intrinsics
from contourlab.engine.intrinsics import (
    INLINE,
    OPTIONS,
    load_input,
    load_parameter,
    load_scratch,
    maximum,
    minimum,
    poly_cos,
    poly_sin,
    store_output,
    store_scratch,
    truncate,
)
from contourlab.engine.translate import polynomials
from contourlab.native.compile import compiled

SPAN_FIELDS = ("first", "last", "t0", "s0", "v0", "a0", "j", "end")
"""Samples [first, last); time, progress, speed and acceleration at the start of the span; its jerk; upper bound of progress."""
CURVE_FIELDS = ("first", "last", "offset", "angle", "rate")
"""Samples [first, last); progress at the start of the curve; angle there; change of angle per progress. Four numbers for each axis follow:

position = base + d s + u cos(angle + rate s) + v sin(angle + rate s).
"""
_SPANS, _CURVES = len(SPAN_FIELDS), len(CURVE_FIELDS)
_BLOCK = 1024
"""Samples of a curve that stay in the processor's cache."""


def _spans(spans, n_span, period, origin, progress, speed, acceleration):  # type: ignore[no-untyped-def]
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


def _curves(curves, n_curve, n_axis, progress, speed, acceleration, out, stride, scratch):  # type: ignore[no-untyped-def]
    for i in range(n_curve):
        row = curves + 8 * (_CURVES + 4 * n_axis) * i
        last = truncate(load_parameter(row, 1))
        for first in range(truncate(load_parameter(row, 0)), last, _BLOCK):
            part = min(_BLOCK, last - first)
            _turned(row, part, progress + 8 * first, scratch)
            for j in range(n_axis):
                here = out + 8 * (stride * j + first)
                _moved(row, j, part, speed + 8 * first, acceleration + 8 * first, here, 8 * stride * n_axis, scratch)


@njit(**INLINE)
def _turned(row, n, progress, scratch):  # type: ignore[no-untyped-def]
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


@njit(**INLINE)
def _moved(row, j, n, speed, acceleration, here, step, scratch):  # type: ignore[no-untyped-def]
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


@cache
def compiled_kernels() -> tuple[Any, Any]:
    """Return the loops over spans and curves in machine code."""
    sources = [inspect.getsource(part) for part in (sys.modules[__name__], intrinsics, polynomials)]
    signatures = {_spans: "i8 i8 f8 i8 i8 i8 i8", _curves: " ".join(["i8"] * 9)}
    spans, curves = (compiled(function, words, sources=sources, options=OPTIONS) for function, words in signatures.items())
    return spans, curves


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
    compiled_kernels()[0](spans.ctypes.data, len(spans), period, origin, progress.ctypes.data, speed.ctypes.data, acceleration.ctypes.data)


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
    compiled_kernels()[1](curves.ctypes.data, len(curves), len(out) // 3, *addresses, out.strides[0] // out.itemsize, scratch.ctypes.data)
