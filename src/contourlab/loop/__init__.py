"""The servo loop: machines and controllers as values, and their simulation."""

from contourlab.loop.batch import BatchResult, simulate_batch
from contourlab.loop.feeding import Learned
from contourlab.loop.machine import DIVISIONS, Axis, AxisController, AxisError, Controller, Division, Limits, Machine
from contourlab.loop.parameters import parameter_names, parameters_of, with_values
from contourlab.loop.portable import PortableLoop, portable
from contourlab.loop.simulate import result_of, simulate, simulate_blocks
from contourlab.loop.stepping import Loop
from contourlab.loop.switches import Change

__all__ = [
    "DIVISIONS",
    "Axis",
    "AxisController",
    "AxisError",
    "BatchResult",
    "Change",
    "Controller",
    "Division",
    "Learned",
    "Limits",
    "Loop",
    "Machine",
    "PortableLoop",
    "parameter_names",
    "parameters_of",
    "portable",
    "result_of",
    "simulate",
    "simulate_batch",
    "simulate_blocks",
    "with_values",
]
