"""The work of the benchmark's rows, written by hand in C: functions that run once and return the error of the nominal variant [mm].

Each makes one row of `run.py`. The C files say what they do and name the numbers that they take.
"""

from __future__ import annotations

import ctypes
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import contourlab as cl
from contourlab.arrays import Array, aligned
from contourlab.geometry.table import PathTable
from contourlab.metrics.judge import furthest, reach

HERE = Path(__file__).resolve().parent
FLAGS = ("-O3", "-march=native", "-fPIC", "-shared")
VECTORS = ("-fopenmp-simd", "-fno-math-errno", "-fno-trapping-math")
"""They let a compiler use vectors, and change no figure."""
SIZE, NUMBER, ADDRESS = ctypes.c_ssize_t, ctypes.c_double, ctypes.c_void_p
Work = Callable[[], Array]


def compiler() -> str | None:
    """Return the C compiler of this machine, or None."""
    return next((found for name in ("cc", "gcc", "clang") if (found := shutil.which(name))), None)


def compiled(source: str, *flags: str) -> ctypes.CDLL:
    """Compile a file of this folder."""
    with tempfile.TemporaryDirectory() as folder:
        library = Path(folder) / "reference.so"
        subprocess.run([str(compiler()), *FLAGS, *flags, "-o", str(library), str(HERE / source), "-lm"], check=True)
        return ctypes.CDLL(str(library))


def at(array: Array) -> ctypes.c_void_p:
    """Return the address of an array; the caller keeps the array."""
    return ADDRESS(array.ctypes.data)


def circle(numbers: Array, n: int, dt: float) -> Work:
    """Return one variant of two axes on a circle: reference.c."""
    simulate, log = compiled("reference.c").simulate, np.zeros((n, 5))

    def work() -> Array:
        simulate(at(numbers), SIZE(n), NUMBER(dt), at(log))
        return log[:, 4]

    return work


class Pieces(ctypes.Structure):
    """`path_t` of lanes.c with TABLE."""

    _fields_ = [("start", ADDRESS), ("coefficients", ADDRESS), ("cell", ADDRESS), ("inverse_cell", NUMBER), ("length", NUMBER)]
    _fields_ += [("last_cell", ctypes.c_int), ("last_piece", ctypes.c_int)]

    def __init__(self, table: PathTable) -> None:
        assert table.halvings == 0, "lanes.c looks up tables with at most one start of a piece in a cell"
        scale = 1e3 ** (1.0 - np.arange(6))
        self.kept = 1e3 * table.start, np.ascontiguousarray(scale * table.coefficients), table.cell.astype(np.intc)
        last = len(table.cell) - 2, len(table.coefficients) - 1
        super().__init__(*(array.ctypes.data for array in self.kept), 1e-3 * table.inverse_cell, 1e3 * table.length, *last)


def lanes(axes: Array, weight: Array, n: int, dt: float, path: PathTable | float, reference: Array | tuple[float, float]) -> Work:
    """Return variants in lanes: lanes.c.

    Parameters
    ----------
    axes : ndarray (n_axis, 16, n_variant)
        The numbers of reference.c.
    weight : ndarray (n_variant,)
    n, dt
        Number of samples, and the time between two [s].
    path : PathTable or float
        Pieces [m], or the radius of a circle [mm].
    reference : ndarray (n, 3 n_axis + 1) or tuple of float
        Position, velocity, acceleration and arc length in mm and s; or radius and angular frequency of a circle, sampled in each run.
    """
    n_axis, _, width = axes.shape
    numbers, log = aligned((n_axis, 17, width)), aligned((n, 2 * n_axis + 1, width))
    for row, given in zip(numbers, axes, strict=True):
        *plant, stribeck, smoothing, limit, bandwidth, cutoff, model_gain, model_damping, kv, kp, ki, forward_gain, forward_damping = given
        weights = [rate * dt / (1.0 + rate * dt) for rate in (bandwidth, cutoff)]
        row[:7] = *plant, 1.0 / stribeck, 1.0 / smoothing, limit
        row[7:12] = *weights, cutoff, 1.0 / model_gain, model_damping
        row[12:] = kv, kp, kp * ki, 1.0 / forward_gain, forward_damping / forward_gain
    in_pieces = isinstance(path, PathTable)
    line: Any = Pieces(path) if in_pieces else (NUMBER * 2)(path, 1.0 / path)
    library = compiled("lanes.c", *VECTORS, f"-DAXES={n_axis}", f"-DWIDTH={width}", *(["-DTABLE"] if in_pieces else []))
    samples = reference if isinstance(reference, np.ndarray) else np.zeros((n, 3 * n_axis + 1))

    def work() -> Array:
        if isinstance(reference, tuple):
            library.sample_circle(SIZE(n), NUMBER(dt), *map(NUMBER, reference), at(samples))
        library.simulate(at(numbers), at(weight), ctypes.byref(line), at(samples), SIZE(n), NUMBER(dt), NUMBER(1e3), at(log))
        return log[:, -1, 0]

    return work


def samples_of(reference: cl.Reference) -> Array:
    """Return the samples of a reference in mm and s, as `lanes` takes them."""
    block = reference.block(0, reference.n_sample)
    return np.ascontiguousarray(1e3 * np.column_stack([block.position, block.velocity, block.acceleration, block.arc_length]))


def backlash(machine: cl.Machine, controller: cl.Controller, radius: float, rate: float, n: int) -> Work:
    """Return one variant of a stage with backlash on a circle of `radius` [m] at `rate` [rad/s]: backlash.c."""
    simulate, log, dt = compiled("backlash.c").simulate, np.zeros((n, 5)), machine.servo_period
    numbers: list[float] = []
    for axis in machine.axes:
        servo = controller.axes[axis.name]
        for part, names in (
            (axis.plant, "force_value motor_mobility load_mobility motor_decay load_decay stiffness_value damper_value half_gap unwinding"),
            (axis.friction, "coulomb breakaway inverse_stribeck viscous"),
            (servo.velocity, "weight"),
            (servo.observer, "velocity_weight filter_bandwidth estimate_weight inverse_gain"),
            (servo.controller, "position_gain velocity_gain integral_rate velocity_feedforward acceleration_feedforward"),
        ):
            block = part.block(dt)
            numbers += [float(block[name]) for name in names.split()]
    window, resolution = controller.estimator.window, machine.axes[0].sensor.resolution
    given = np.array([*numbers, radius, rate, controller.coupling.weight, window, resolution])

    def work() -> Array:
        simulate(at(given), SIZE(n), NUMBER(dt), ctypes.c_int(machine.axes[0].substeps), at(log))
        return 1e3 * log[:, 4]

    return work


def nearest(judged: cl.Result, reference: cl.Reference) -> Work:
    """Return the distance of the tool from a programmed path of lines, in the window of the judge: nearest.c."""
    path, tool = reference.programmed, np.ascontiguousarray(judged["tool_position"])
    corners, along = np.ascontiguousarray(path.position(path.breaks)), np.ascontiguousarray(path.breaks)
    places = reference.programmed_arc_length(judged["arc_length"])
    window = reach(path, furthest(judged["reference"] - tool)) + float(np.abs(judged["planning_deviation"]).max())
    function, found = compiled("nearest.c").nearest, np.zeros((2, len(tool)))

    def work() -> Array:
        line, samples = (at(corners), at(along), SIZE(len(corners) - 1)), (at(tool), at(places))
        function(*line, *samples, NUMBER(window), SIZE(len(tool)), at(found[0]), at(found[1]))
        return 1e3 * found[0]

    return work
