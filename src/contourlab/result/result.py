"""The result of a run: labelled signals with units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ResultError
from contourlab.result.netcdf import FORMAT, ResultWriter, read_netcdf
from contourlab.result.signals import Signal, Status

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class Result:
    """Signals of one run, simulated or measured.

    Parameters
    ----------
    scheme : str
        Name of the run.
    axes : tuple of str
        Names of the axes, in the order of the columns.
    servo_period : float [s]
        Time between samples.
    signals : mapping of str to Signal
        All of one length.
    status : Status
    attributes : mapping of str to str, int or float
        Further data: machine, seed, digest of the path.
    start : int
        Index of the first sample in the run: not 0 for a window.

    Raises
    ------
    ResultError
        If the signals differ in length or number of axes.
    """

    scheme: str
    axes: tuple[str, ...]
    servo_period: float
    signals: Mapping[str, Signal]
    status: Status = field(default_factory=Status)
    attributes: Mapping[str, str | int | float] = field(default_factory=dict)
    start: int = 0

    def __post_init__(self) -> None:
        lengths = {len(signal.data) for signal in self.signals.values()}
        if len(lengths) > 1:
            raise ResultError(f"the signals have different lengths: {sorted(lengths)}")
        for name, signal in self.signals.items():
            if signal.data.ndim == 2 and signal.data.shape[1] != len(self.axes):
                raise ResultError(f"signal {name} has {signal.data.shape[1]} columns for {len(self.axes)} axes")

    @property
    def source(self) -> str:
        """Name of the run in messages: its log file, if there is one, else its scheme."""
        return str(self.attributes.get("log", self.scheme))

    def __getitem__(self, name: str) -> Array:
        """Return the data of a signal.

        Raises
        ------
        ResultError
            If there is no such signal; the message lists the known ones.
        """
        if name not in self.signals:
            raise ResultError(f"no signal {name!r} in {self.scheme}; the signals are: {', '.join(self.signals)}")
        return self.signals[name].data

    def __contains__(self, name: object) -> bool:
        return name in self.signals

    @property
    def n_sample(self) -> int:
        """Number of samples."""
        return len(next(iter(self.signals.values())).data) if self.signals else 0

    @property
    def time(self) -> Array:
        """Time of each sample [s]: index times period, never a running sum."""
        return np.asarray((self.start + np.arange(self.n_sample)) * self.servo_period)

    def with_signals(self, **signals: Signal) -> Result:
        """Return the result with signals added or replaced."""
        return replace(self, signals={**self.signals, **signals})

    def window(self, start: int, stop: int) -> Result:
        """Return samples [start, stop) of this result."""
        cut = {name: replace(signal, data=signal.data[start:stop]) for name, signal in self.signals.items()}
        return replace(self, signals=cut, start=self.start + start)

    def to_xarray(self) -> xarray.Dataset:
        """Return the signals as a labelled data set, time and axis names as coordinates."""
        import xarray

        data = {name: (signal.dims, np.array(signal.data), {"units": signal.unit}) for name, signal in self.signals.items()}
        coordinates: dict[str, Any] = {"time": ("sample", self.time, {"units": "s"}), "axis": ("axis", list(self.axes))}
        return xarray.Dataset(data, coordinates, dict(self.header()))

    def header(self) -> dict[str, str | int | float]:
        """Return everything except the signals, as a flat mapping."""
        return {
            "format": FORMAT,
            "scheme": self.scheme,
            "axes": " ".join(self.axes),
            "servo_period": self.servo_period,
            "start": self.start,
            **self.status.header(),
            **{f"attribute_{name}": value for name, value in self.attributes.items()},
        }

    def save(self, file: str | Path) -> None:
        """Write a NetCDF-4 file, whole or not at all.

        Raises
        ------
        OutputError
            If it cannot be written.
        """
        with ResultWriter(file, self.header(), self.axes, self.n_sample) as writer:
            writer.append(self.signals)

    @staticmethod
    def load(file: str | Path) -> Result:
        """Read a file that `save` or a `ResultWriter` wrote; the result is identical to what was written.

        Raises
        ------
        ResultError
            If the file is missing or is no result of contourlab.
        """
        return Result(**read_netcdf(file))
