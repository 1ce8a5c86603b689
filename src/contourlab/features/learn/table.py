"""The learned table, in memory and on disk, with its program, machine and controller."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import zip_longest
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.learning.law import LearningLaw
from contourlab.errors import ResultError, refuse
from contourlab.feed import Reference
from contourlab.loop import Controller, Learned, Machine
from contourlab.result.atomic import replacing
from contourlab.result.stamp import current
from contourlab.scenario.dump import component_table, dump
from contourlab.scenario.provenance import unstated
from contourlab.scenario.toml_text import toml

FORMAT = "contourlab-learned/1"
_TEXTS = ("target", "path", "reference", "machine", "controller", "law", "scheme", "content")


@dataclass(frozen=True, eq=False)
class LearnedTable:
    """A learned table.

    Attributes
    ----------
    values : ndarray (n_sample, n_axis) [command unit, or m]
    target : {"command", "reference"}
    axes : tuple of str
    servo_period : float [s]
    path, reference : str
        Digests of the planned path and of the motion along it.
    machine, controller, law : str
        Their text in a file.
    figures : mapping of str to ndarray (n_trial,) or (n_trial, n_axis)
        Figures of each trial, for information only.
    """

    values: Array
    target: str
    axes: tuple[str, ...]
    servo_period: float
    path: str
    reference: str
    machine: str
    controller: str
    law: str
    figures: Mapping[str, Array] = field(default_factory=dict)

    @classmethod
    def of(
        cls,
        values: Array,
        machine: Machine,
        controller: Controller,
        reference: Reference,
        law: LearningLaw,
        figures: Mapping[str, Array] | None = None,
    ) -> LearnedTable:
        """Return a table of learned values (n_sample, n_axis) for a motion of a machine under its controller."""
        plant = machine.axes[0].plant
        return cls(
            values=values,
            target=law.target,
            axes=machine.axis_names,
            servo_period=machine.servo_period,
            path=reference.path.digest,
            reference=reference.digest,
            **_texts(machine, controller),
            law=toml({"law": component_table(law, (plant.command_unit, plant.force_unit))}),
            figures=figures or {},
        )

    @property
    def scheme(self) -> str:
        """Digest of machine, controller and law."""
        return hashlib.sha256("\n".join((self.machine, self.controller, self.law)).encode()).hexdigest()

    @property
    def content(self) -> str:
        """Digest of the values."""
        return hashlib.sha256(np.ascontiguousarray(self.values, dtype="<f8").tobytes()).hexdigest()

    @property
    def learned(self) -> Learned:
        """The table as an argument of `simulate`."""
        return Learned(command=self.values) if self.target == "command" else Learned(reference=self.values)

    def check(self, machine: Machine, controller: Controller, reference: Reference) -> None:
        """Check that the table belongs to this motion, machine and controller; the law may differ.

        Raises
        ------
        ResultError
            If it does not; the message names the difference and the remedy.
        """
        names = ", ".join(self.axes)
        if self.axes != machine.axis_names:
            raise _refused(f"axes {names}", f"a machine with axes {', '.join(machine.axis_names)}", f"use a machine with axes {names}")
        periods = [period for period in (machine.servo_period, reference.servo_period) if period != self.servo_period]
        if periods:
            mine = f"{self.servo_period:g} s"
            raise _refused(f"a servo period of {mine}", f"one of {periods[0]:g} s", f"run at {mine}, or learn again")
        if self.path != reference.path.digest:
            raise _refused(f"path {self.path[:12]}", f"path {reference.path.digest[:12]}", "use the program of the learning run")
        if self.reference != reference.digest or len(self.values) != reference.n_sample:
            mine = f"a motion of {len(self.values)} samples ({self.reference[:12]})"
            other = f"one of {reference.n_sample} ({reference.digest[:12]}) along the same path"
            raise _refused(mine, other, "use the feed, limits and blending of the learning run")
        for part, text in _texts(machine, controller).items():
            if getattr(self, part) != text:
                was, has = _first_difference(getattr(self, part), text)
                raise _refused(f"a {part} with {was}", f"one with {has}", f"use the {part} of the learning run, or learn again")

    def save(self, file: str | Path) -> None:
        """Write a NetCDF-4 file atomically.

        Raises
        ------
        OutputError
            If it cannot be written.
        """
        import h5netcdf
        import h5py

        text = h5py.string_dtype("utf-8")
        with replacing(file) as temporary, h5netcdf.File(temporary, "w") as data:
            n_trial = len(next(iter(self.figures.values()))) if self.figures else 0
            data.attrs["made_by"] = current()
            data.dimensions = {"sample": len(self.values), "axis": len(self.axes), **({"trial": n_trial} if n_trial else {})}
            data.create_variable("axis", ("axis",), dtype=text)[:] = np.array(self.axes, dtype=object)
            # Texts are variables, because an attribute holds at most 64 kB.
            for name, value in (*((name, getattr(self, name)) for name in _TEXTS), ("format", FORMAT)):
                data.create_variable(name, (), dtype=text)[...] = value
            data.create_variable("servo_period", (), float)[...] = self.servo_period
            data.create_variable("values", ("sample", "axis"), float)[...] = self.values
            for name, figures in self.figures.items():
                dims = ("trial",) if figures.ndim == 1 else ("trial", "axis")
                data.create_variable(f"figure_{name}", dims, float)[...] = figures

    @classmethod
    def load(cls, file: str | Path) -> LearnedTable:
        """Read a file written by `save`.

        Raises
        ------
        ResultError
            If it cannot be read, is no learned table, or is damaged.
        """
        import h5py

        try:
            with h5py.File(file, "r") as data:
                form = _text(data["format"][()]) if "format" in data else None
                refuse(form != FORMAT, ResultError, f"{file}: not a contourlab learned table (format = {form!r})")
                texts = {name: _text(data[name][()]) for name in _TEXTS}
                axes = tuple(_text(name) for name in data["axis"][:])
                period, values = float(data["servo_period"][()]), np.array(data["values"][...])
                figures = {name.removeprefix("figure_"): np.array(data[name][...]) for name in data if name.startswith("figure_")}
        except (OSError, KeyError, RuntimeError, TypeError, ValueError) as error:
            raise ResultError(f"{file}: cannot be read as a learned table: {error}") from error
        scheme, content = texts.pop("scheme"), texts.pop("content")
        table = cls(values=values, axes=axes, servo_period=period, figures=figures, **texts)
        sound = values.ndim == 2 and values.shape[1] == len(axes) and bool(np.isfinite(values).all())
        if not sound or (table.scheme, table.content) != (scheme, content):
            raise ResultError(f"{file}: damaged: its contents do not match its digests; learn again")
        return table


def _refused(mine: str, other: str, remedy: str) -> ResultError:
    return ResultError(f"the learned table belongs to {mine}, not to {other}: {remedy}")


def _text(value: Any) -> str:
    return value.decode("utf-8") if isinstance(value, bytes) else str(value)


def _texts(machine: Machine, controller: Controller) -> dict[str, str]:
    """Return machine and controller as text, without the sources of their values."""
    plain = unstated(machine)
    return {"machine": dump(plain), "controller": dump(unstated(controller), plain)}


def _first_difference(mine: str, other: str) -> tuple[str, str]:
    """Return the first pair of lines in which two files differ, each with its heading."""
    heading = ""
    for pair in zip_longest(mine.splitlines(), other.splitlines(), fillvalue="nothing more"):
        if pair[0] != pair[1]:
            plain = (line.partition("#")[0].strip() for line in pair)
            was, has = (f"[{heading}] {line}" if heading and not line.startswith("[") else line for line in plain)
            return was, has
        if pair[0].startswith("["):
            heading = pair[0].strip("[] ")
    return "other text", "this text"
