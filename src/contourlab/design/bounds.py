"""What a design has to keep besides a small error: margins of each axis, and drives that are not at their limits."""

from __future__ import annotations

import math
from dataclasses import dataclass

from contourlab.analysis.linear.margins import Margins
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.errors import ComponentError, ParameterError
from contourlab.loop import Controller, Machine

SLACK = (0.02, 0.05)
"""Margins of a search, read off a grid, are asked for with this much more: dB, degrees."""
ROUNDING = 1e-9


@dataclass(frozen=True)
class Bounds:
    """What has to be kept.

    Attributes
    ----------
    gain_margin : float [dB], >= 0
        Of each axis, opened at its drive.
    phase_margin : float [deg], >= 0
    limited : float, 0 to 1
        Largest part of the time that counts at which a drive does not give all it is asked for.
    command : float, > 0
        Largest command, in parts of what the drive can give.
    """

    gain_margin: float = 6.0
    phase_margin: float = 30.0
    limited: float = 0.0
    command: float = math.inf

    def __post_init__(self) -> None:
        for name, high, unit in (("gain_margin", 60.0, "dB"), ("phase_margin", 90.0, "deg"), ("limited", 1.0, "")):
            if not 0.0 <= getattr(self, name) <= high:
                raise ParameterError(name, f"{getattr(self, name):g}", f"0 to {high:g}", unit)
        if not self.command > 0.0:
            raise ParameterError("command", f"{self.command:g}", "> 0, in parts of what the drive can give")

    @property
    def words(self) -> str:
        """The bounds in words."""
        found = [f"gain margin at least {self.gain_margin:g} dB", f"phase margin at least {self.phase_margin:g} deg"]
        found.append(f"at most {100.0 * self.limited:g} % of the time at a limit of a drive")
        if math.isfinite(self.command):
            found.append(f"commands up to {100.0 * self.command:g} % of the drive")
        return ", ".join(found)

    def missing(self, margins: Margins, slack: tuple[float, float] = (0.0, 0.0)) -> float:
        """Return how far margins are from what is asked for, in parts of it: 0 where they are kept, infinite for an unstable loop."""
        if not margins.stable:
            return math.inf
        gain, phase = 20.0 * math.log10(margins.gain), math.degrees(abs(margins.phase))
        short = max(0.0, self.gain_margin + slack[0] - gain) / max(self.gain_margin, 1.0) if self.gain_margin else 0.0
        turn = max(0.0, self.phase_margin + slack[1] - phase) / max(self.phase_margin, 1.0) if self.phase_margin else 0.0
        return short + turn

    def broken(self, margins: Margins) -> str:
        """Return in words what margins fall short of; empty where they are kept."""
        if not margins.stable:
            return "unstable"
        gain, phase = 20.0 * math.log10(margins.gain), math.degrees(abs(margins.phase))
        found = [f"gain margin {gain:.2f} dB"] if gain < self.gain_margin - ROUNDING else []
        return ", ".join([*found, *([f"phase margin {phase:.1f} deg"] if phase < self.phase_margin - ROUNDING else [])])


def without_model(machine: Machine, controller: Controller) -> dict[str, str]:
    """Return the axes whose loop has no linear model, and why: their margins cannot be looked at."""
    found = {}
    for axis in machine.axes:
        try:
            sampled_loop(axis, controller.axes[axis.name], machine.servo_period, machine.carried_mass(axis.name))
        except ComponentError as error:
            found[axis.name] = str(error)
    return found
