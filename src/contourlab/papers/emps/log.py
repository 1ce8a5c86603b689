"""Log of the EMPS benchmark: a linear axis at 1 kHz, moved back and forth with bang-bang accelerations."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import LogError
from contourlab.logs import read_record

WANTED = (
    "give DATA_EMPS.mat of Janot, Gautier & Brunot, 'Data set and reference models of EMPS', 2019 nonlinear benchmark "
    "(nonlinearbenchmark.org); for validation also DATA_EMPS_PULSES.mat. They are not part of contourlab"
)
SIGNALS, GAINS = ("t", "qm", "qg", "vir"), ("kp", "kv", "gtau")


@dataclass(frozen=True, eq=False)
class EmpsLog:
    """A record of the axis under its position controller.

    Attributes
    ----------
    time : ndarray (n,) [s]
    position, reference : ndarray (n,) [m]
        Travel of the table, measured at the motor, and its reference.
    voltage : ndarray (n,) [V]
        Voltage at the drive: controller and pulses.
    pulses : ndarray (n,) [V]
        Added to the controller's output; zero in the record for estimation.
    position_gain, velocity_gain, drive_gain : float [1/s, V s/m, N/V]
    """

    time: Array
    position: Array
    reference: Array
    voltage: Array
    pulses: Array
    position_gain: float
    velocity_gain: float
    drive_gain: float

    @property
    def period(self) -> float:
        """Mean servo period [s]."""
        return float(self.time[-1] - self.time[0]) / (self.time.size - 1)

    @property
    def force(self) -> Array:
        """Force of the drive (n,) [N]."""
        return self.drive_gain * self.voltage


def read_emps(file: str | Path) -> EmpsLog:
    """Read a log of the EMPS benchmark.

    Parameters
    ----------
    file : str or Path
        DATA_EMPS.mat, or DATA_EMPS_PULSES.mat with pulses. The description of the data set gives newtons; the voltage shows volts.

    Raises
    ------
    LogError
        If the file cannot be read or lacks a signal or a gain, signals differ in length or are not finite, or a gain is not above zero.
    """
    held = _variables(Path(file))
    absent = [name for name in (*SIGNALS, *GAINS) if name not in held]
    if absent:
        raise LogError(f"has no {', '.join(absent)}: {WANTED}", file=file)
    signal = {name: np.asarray(held[name], dtype=float).ravel() for name in (*SIGNALS, *GAINS, "pulses_N") if name in held}
    n = signal["t"].size
    pulses = signal.pop("pulses_N", np.zeros(n))
    for name, values in (*signal.items(), ("pulses_N", pulses)):
        wanted = 1 if name in GAINS else max(n, 2)
        if values.size != wanted:
            raise LogError(f"{name} has {values.size} samples, not {wanted}", file=file)
        if not np.isfinite(values).all():
            raise LogError(f"{name} is not finite at sample {int(np.flatnonzero(~np.isfinite(values))[0])}", file=file)
        if name in GAINS and not values[0] > 0.0:
            raise LogError(f"{name} = {values[0]:g} is not a valid gain: it must be above zero", file=file)
    kp, kv, gtau = (float(signal[name][0]) for name in GAINS)
    return EmpsLog(signal["t"], signal["qm"], signal["qg"], signal["vir"], pulses, kp, kv, gtau)


def _variables(file: Path) -> dict[str, Any]:
    try:
        record = read_record(file, "matlab")
    except LogError as error:
        raise LogError(f"{error.message}; {WANTED}", file=file) from error
    return {channel.name: channel.values for channel in record.channels} | dict(record.constants)
