"""The result of a run: labelled signals with units."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from contourlab.arrays import BLOCK, Array, Index
from contourlab.errors import ResultError, hint, refuse
from contourlab.feed import Reference
from contourlab.notebook import Figure, Frame, Panel, curves, facts_line, facts_table, frame, svg
from contourlab.result.netcdf import FORMAT, ResultWriter, read_netcdf
from contourlab.result.signals import JUDGED, Signal, Status
from contourlab.result.stamp import current, identity, stamp
from contourlab.result.stored import Stored

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True, repr=False)
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
    motion : Reference or None
        The reference that it was simulated or judged along; not saved.
    made_by : str or tuple of Machine and Controller
        What made it; saved as its `stamp`.

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
    motion: Reference | None = field(default=None, compare=False)
    made_by: Any = field(default="", compare=False)

    def __post_init__(self) -> None:
        lengths = {len(signal.data) for signal in self.signals.values()}
        refuse(len(lengths) > 1, ResultError, f"the signals have different lengths: {sorted(lengths)}")
        for name, signal in self.signals.items():
            if signal.data.ndim == 2 and signal.data.shape[1] != len(self.axes):
                raise ResultError(f"signal {name} has {signal.data.shape[1]} columns for {len(self.axes)} axes")

    @property
    def stamp(self) -> str:
        """The line that says what made it."""
        if isinstance(self.made_by, tuple):
            return stamp(**{name: identity(part) for name, part in zip(("machine", "controller"), self.made_by, strict=True)})
        return str(self.made_by) or current()

    @property
    def source(self) -> str:
        """Name of the run in messages: its log file, if there is one, else its scheme."""
        return str(self.attributes.get("log", self.scheme))

    def __getitem__(self, name: str) -> Array:
        """Return the data of a signal.

        Raises
        ------
        ResultError
            If there is no such signal; the message names what adds it, or the nearest, or lists all.
        """
        if name not in self.signals:
            cure = "judge(result, reference) adds it" if name in JUDGED else hint(name, self.signals)
            raise ResultError(f"no signal {name!r} in {self.scheme}: {cure}")
        return self.signals[name].data

    def __contains__(self, name: object) -> bool:
        return name in self.signals

    @property
    def n_sample(self) -> int:
        """Number of samples."""
        return len(next(iter(self.signals.values())).data) if self.signals else 0

    @property
    def time(self) -> Array:
        """Time of each sample (n_sample,) [s]: index times period, never a running sum."""
        return np.asarray((self.start + np.arange(self.n_sample)) * self.servo_period)

    def with_signals(self, **signals: Signal) -> Result:
        """Return the result with signals added or replaced."""
        return replace(self, signals={**self.signals, **signals})

    def with_blocks(self, compute: Callable[[Result], Mapping[str, Signal]]) -> Result:
        """Return the result with signals added that are computed block by block, and stored as the others are."""
        if isinstance(self.signals, Stored) and self.signals.start == 0:
            more = Stored(self.n_sample, self.signals.file)
            for part in self.blocks():
                more.append(compute(part))
            return replace(self, signals=self.signals.part(columns=self.signals.columns | more.columns))
        parts = list(map(compute, self.blocks()))
        joined = {name: replace(one, data=np.concatenate([part[name].data for part in parts])) for name, one in parts[0].items()}
        return self.with_signals(**joined)

    def only(self, names: Sequence[str]) -> Result:
        """Return the result with some of its signals; ResultError if it lacks one."""
        if lacking := next((name for name in names if name not in self), None):
            self[lacking]
        if isinstance(self.signals, Stored):
            return replace(self, signals=self.signals.part(columns={name: self.signals.columns[name] for name in names}))
        return replace(self, signals={name: self.signals[name] for name in names})

    def window(self, start: int, stop: int) -> Result:
        """Return samples [start, stop) of this result."""
        if isinstance(self.signals, Stored):
            return replace(self, signals=self.signals.window(start, stop), start=self.start + start)
        cut = {name: replace(signal, data=signal.data[start:stop]) for name, signal in self.signals.items()}
        return replace(self, signals=cut, start=self.start + start)

    def at(self, name: str, samples: Index) -> Array:
        """Return a signal at some samples (n,); of one in a file, only what is near them is in memory at a time."""
        found = np.empty((len(samples), *self[name].shape[1:]))
        for block in np.unique(samples // BLOCK).tolist():
            here = samples // BLOCK == block
            found[here] = self.window(block * BLOCK, (block + 1) * BLOCK)[name][samples[here] - block * BLOCK]
        return found

    def blocks(self) -> Iterator[Result]:
        """Yield windows of `BLOCK` samples, one after another; a result without samples has one."""
        yield from (self.window(*edges) for edges in pairwise([*range(0, max(self.n_sample, 1), BLOCK), self.n_sample]))

    def to_xarray(self) -> xarray.Dataset:
        """Return the signals as a labelled data set, time and axis names as coordinates."""
        import xarray

        data = {name: (signal.dims, np.array(signal.data), {"units": signal.unit}) for name, signal in self.signals.items()}
        coordinates: dict[str, Any] = {"time": ("sample", self.time, {"units": "s"}), "axis": ("axis", list(self.axes))}
        return xarray.Dataset(data, coordinates, dict(self.header()))

    def to_pandas(self) -> Frame:
        """Return the signals in SI as a table over time [s]; a signal of the axes has a column for each, as ``reference x``."""
        columns: dict[str, Array] = {}
        for name, signal in self.signals.items():
            if signal.data.ndim == 1:
                columns[name] = signal.data
            else:
                columns |= {f"{name} {axis}": signal.data[:, i] for i, axis in enumerate(self.axes)}
        return frame(columns, self.time, "time")

    def plot(self) -> Figure:
        """Draw the path of the first two axes, and over time the contour error of a judged run, else the tracking error of each axis.

        Raises
        ------
        ResultError
            If a signal that it draws was not kept.
        """
        reference, actual = self["reference"], self["axis_position"]
        panels: list[Panel] = []
        if len(self.axes) > 1:
            ways = [(name, *1e3 * values[:, :2].T) for name, values in (("reference", reference), ("axes", actual))]
            panels.append((f"{self.axes[0]} [mm]", f"{self.axes[1]} [mm]", ways))
        if "contour_error" in self:
            panels.append(("time [s]", "contour error [um]", [("", self.time, 1e6 * self["contour_error"])]))
        else:
            off = [(name, self.time, 1e6 * column) for name, column in zip(self.axes, (reference - actual).T, strict=True)]
            panels.append(("time [s]", "tracking error [um]", off))
        return curves(panels, to_scale=len(self.axes) > 1)

    def _facts(self) -> dict[str, str]:
        """Return what identifies the run, and its error if it was judged."""
        facts = {"axes": ", ".join(self.axes), "samples": f"{self.n_sample} of {1e3 * self.servo_period:g} ms"}
        if not self.status.ok:
            facts["failed"] = f"{self.status.reason} at sample {self.status.sample}"
        if "contour_error" in self and self.n_sample:
            error = np.abs(self["contour_error"])
            rms, largest = 1e6 * np.sqrt(np.nanmean(error**2)), 1e6 * np.nanmax(error)
            facts["contour error"] = f"{rms:.3g} um rms, {largest:.3g} um largest, over all samples"
        return facts

    def __repr__(self) -> str:
        return facts_line("Result", {"run": self.scheme, **self._facts()})

    def _repr_html_(self) -> str:
        picture = svg(self.plot()) if {"reference", "axis_position"} <= set(self.signals) else ""
        return facts_table({"run": self.scheme, **self._facts(), "signals": ", ".join(self.signals)}) + picture

    def header(self) -> dict[str, str | int | float]:
        """Return everything except the signals, as a flat mapping."""
        return {
            "format": FORMAT,
            "made_by": self.stamp,
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
            for part in self.blocks():
                writer.append(part.signals)

    @staticmethod
    def load(file: str | Path) -> Result:
        """Read a file that `save` or a `ResultWriter` wrote; the result is identical to what was written.

        Raises
        ------
        ResultError
            If the file is missing or is no result of contourlab.
        """
        return Result(**read_netcdf(file))
