"""A recorded run for the bench of an exported controller: inputs and commands, computed in plain Python."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array
from contourlab.engine.runner import InterpretedGroup
from contourlab.engine.step import rows
from contourlab.features.export.axis_controller import AxisControl, loop_of
from contourlab.loop import Axis
from contourlab.loop.template import EXTERNALS

SAMPLES = 2000
"""Most samples of a recorded run."""


@dataclass(frozen=True)
class Recorded:
    """A run of the servo loop of one axis.

    Attributes
    ----------
    names : tuple of str
        Inputs of the controller, as in its `Control`.
    inputs : ndarray (n_sample, n_input)
    command : ndarray (n_sample,)
        Of the controller alone, in plain Python.
    in_loop : ndarray (n_sample,)
        Of the whole servo loop: the same numbers.
    """

    names: tuple[str, ...]
    inputs: Array
    command: Array
    in_loop: Array

    @property
    def text(self) -> str:
        """The run as CSV; all numbers read back identical."""
        head = ",".join((*self.names, "command"))
        lines = (",".join(map(repr, row)) for row in np.column_stack([self.inputs, self.command]).tolist())
        return "\n".join([head, *lines, ""])


def there_and_back(axis: Axis, period: float, n_sample: int = SAMPLES) -> Array:
    """Return two smooth strokes within the limits of an axis: position, velocity and acceleration (n_sample, 3)."""
    w = 4.0 * math.pi / (n_sample * period)
    speed, rate = (value if math.isfinite(value) else 0.1 for value in (axis.limits.velocity, axis.limits.acceleration))
    stroke = 0.5 * min(speed / w, rate / w**2)
    angle = w * period * np.arange(n_sample)
    return np.column_stack([stroke * (1.0 - np.cos(angle)), stroke * w * np.sin(angle), stroke * w**2 * np.cos(angle)])


def record(found: AxisControl, motion: Array) -> Recorded:
    """Run the servo loop of an axis, and its controller alone on what the loop measured.

    Parameters
    ----------
    found : AxisControl
    motion : ndarray (n_sample, 3)
        Position, velocity and acceleration of the reference.
    """
    loop = loop_of(found.machine, found.controller, float(motion[0, 0]))
    ports = [port.name for port in found.schedule.externals]
    fed = np.zeros((len(motion), rows(loop.externals)))
    fed[:, :3] = motion
    wanted = [loop.row(f"in.{name}" if name in EXTERNALS else found.measured[name]) for name in ports]
    log = InterpretedGroup(loop, 1, slice(0, 1)).run(fed, [*wanted, loop.row(found.signal)])[:, :, 0]
    return replayed(found, log[:, :-1], log[:, -1])


def replayed(found: AxisControl, inputs: Array, in_loop: Array) -> Recorded:
    """Run the controller of an axis alone, in plain Python.

    Parameters
    ----------
    found : AxisControl
    inputs : ndarray (n_sample, n_port)
        All inputs of its schedule.
    in_loop : ndarray (n_sample,)
        Commands of the servo loop.
    """
    columns = {port.name: inputs[:, k] for k, port in enumerate(found.schedule.externals)}
    names = tuple(field.name for field in found.control.inputs.values())
    group = found.at_rest(float(columns[found.control.feedback][0]))
    command = group.run(inputs, [found.schedule.row(found.signal)])[:, 0, 0]
    return Recorded(names, np.column_stack([columns[name] for name in names]), command, in_loop)
