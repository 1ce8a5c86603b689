"""What a reader of a control's own file returns."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from contourlab.findings import Finding, finding

LARGEST = 1e9
"""Limit of what a control's file may say; beyond it a number stands for no limit."""
PERIOD = {"value": "1 ms", "source": "assumed", "note": "the control makes steps, and has no servo period"}
"""Servo period of a machine whose control has none."""
FLOATING = {"floating": True}
"""Limits of an axis: a control's file has its travel in machine coordinates, in which the zero of a program is not known yet."""


@dataclass(frozen=True, eq=False)
class ControlFile:
    """What a control's own file says of a machine.

    Attributes
    ----------
    file : Path
    control : str
        Name of the control, as ``"LinuxCNC"``.
    tables : mapping
        ``machine`` and ``axes`` as in a machine file; also ``controller`` and ``program`` as far as the file sets them: what a scenario
        says comes first. A number that the file does not hold itself is `computed` or `guessed`.
    unmodelled : mapping of str to str
        Axes whose answer the file leaves open, and why. Their plant is a stand-in for planning; nothing is simulated with it.
    findings : tuple of Finding
    files : tuple of Path
        Further files that were read.
    """

    file: Path
    control: str
    tables: Mapping[str, Any]
    unmodelled: Mapping[str, str] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()
    files: tuple[Path, ...] = ()


def read_from(value: Any, place: str) -> dict[str, Any]:
    """Return a value as the file holds it, such as ``"133 mm/s"`` of ``router.ini:54``."""
    return {"value": value, "source": "control", "from": place}


def computed(value: Any, how: str) -> dict[str, Any]:
    """Return a value computed from what the file holds."""
    return {"value": value, "source": "computed", "note": how}


def guessed(value: str, low: str, high: str, why: str) -> dict[str, Any]:
    """Return a value that the file does not hold, with the range in which it lies."""
    return {"value": value, "source": "assumed", "range": [low, high], "note": why}


def driven_by_steps(period: float, pulse: dict[str, Any] | None) -> dict[str, Any]:
    """Return the tables of an axis that follows step pulses, with the travel per pulse, if it is known.

    Parameters
    ----------
    period : float [s]
        Servo period.
    pulse : dict or None
    """
    frequency = guessed("150 Hz", "60 Hz", "300 Hz", "rotor and axis on the stiffness of a stepper of usual size")
    damping = {"value": 0.15, "source": "assumed", "range": [0.05, 0.6], "note": "a stepper on usual drives"}
    ahead = {"value": 1.0, "source": "assumed", "range": [0.7, 1.0], "note": "a stepper is damped relative to its count, guides little"}
    plant = {"kind": "step-drive", "natural_frequency": frequency, "damping_ratio": damping, "velocity_feedforward": ahead}
    return {"substeps": substeps(300.0, period), "plant": plant if pulse is None else {**plant, "pulse": pulse}}


def position_drive(period: float, pulse: Any = None) -> dict[str, Any]:
    """Return the tables of an axis whose drive takes positions, or steps with a travel per pulse, and closes all loops.

    Parameters
    ----------
    period : float [s]
        Servo period.
    pulse : optional
        As a table holds it.
    """
    frequency = guessed("40 Hz", "15 Hz", "100 Hz", "position loop of a servo drive of usual size")
    ahead = {"value": 0.5, "source": "assumed", "range": [0.0, 1.0], "note": "drives differ"}
    damping = {"value": 1.0, "source": "assumed", "range": [0.6, 1.4], "note": "drives differ"}
    plant = {"kind": "step-drive", "natural_frequency": frequency, "damping_ratio": damping, "velocity_feedforward": ahead}
    return {"substeps": substeps(100.0, period), "plant": {**plant, "pulse": pulse} if pulse else plant}


def substeps(frequency: float, period: float) -> int:
    """Return the sub-steps that a plant needs which oscillates at a frequency [Hz]."""
    return max(1, math.ceil(8.0 * math.pi * frequency * period))


def steps_controller(axes: Iterable[str]) -> dict[str, Any]:
    """Return the controller of axes that take positions."""
    return {"axes": {axis: {"controller": "steps"} for axis in axes}}


def stepping(
    file: Path, control: str, name: str, tables: dict[str, Any], planner: dict[str, Any], findings: Iterable[Finding] = (), **program: str
) -> ControlFile:
    """Return the machine of a control of the family of grbl, which counts its steps, from the tables of its axes.

    Parameters
    ----------
    control : str
        Its name; that of a descendant ends in HAL.
    name : str
        Of the machine.
    planner : dict
        Keys of the table ``machine`` that say how the control plans.
    findings : iterable of Finding
        Further ones.
    **program : str
        How it reads a part program, beside the dialect.
    """
    axes = list(tables)
    machine = {"name": name[:200], "servo_period": PERIOD, "axes": axes, **planner}
    program = {"dialect": "grbl" if control == "grbl" else "grblhal", **program}
    every = {"machine": machine, "axes": tables, "controller": steps_controller(axes), "program": program}
    counts = finding("CL984", axes=axes, why=f"{control.removesuffix('HAL')} counts its steps")
    return ControlFile(file, control, every, findings=(counts, *findings))
