"""What runs, and columns in, figures out: many candidates in chunks, in threads, on a GPU or in workers; finished chunks may be stored."""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array
from contourlab.engine.gpu import LANES as GPU_LANES
from contourlab.feed import Reference
from contourlab.geometry.view import PathView, view_of
from contourlab.loop import BatchResult, Controller, Machine, parameters_of, simulate, simulate_batch
from contourlab.loop.batch import checked_variants, lanes_each
from contourlab.metrics.run_figures import needs
from contourlab.result import Result
from contourlab.study.checkpoint import Checkpoint, program_identity

if TYPE_CHECKING:
    from contourlab.scenario import Case
    from contourlab.study.executors import Workers


@dataclass(frozen=True)
class Setting:
    """A machine under its controller along a motion.

    Attributes
    ----------
    machine : Machine
    controller : Controller
    reference : Reference
    seed : int
        Of all noise.
    moving : bool
        Whether the axes start with the velocity of the reference.
    """

    machine: Machine
    controller: Controller
    reference: Reference
    seed: int = 0
    moving: bool = False

    @staticmethod
    def of(case: Case) -> Setting:
        """Plan the motion of a case of a scenario, and return what runs."""
        return Setting(case.machine, case.controller, case.reference(), case.run.seed, case.moving)

    @cached_property
    def view(self) -> PathView:
        """View of the path for estimator and judge."""
        return view_of(self.reference.path)

    def single(self) -> Result:
        """Run once; raise `DivergenceError`, with the place and time of the failure, if the run fails."""
        return simulate(self.machine, self.controller, self.reference, seed=self.seed, moving=self.moving)

    def batch(self, columns: Mapping[str, ArrayLike], figures: Iterable[str] = (), **options: Any) -> BatchResult:
        """Run many candidates.

        Parameters
        ----------
        columns : mapping of str to array_like (n,)
            Values [SI] by dotted names.
        figures : iterable of str
            Names of figures that are needed besides those of contour error and tracking error.
        **options : Any
            See `contourlab.loop.simulate_batch`; `seed` replaces that of the setting.
        """
        given = {"seed": self.seed, "moving": self.moving, "view": self.view, **needs(figures), **options}
        return simulate_batch(self.machine, self.controller, self.reference, columns, **given)

    def as_it_is(self, n: int = 1) -> dict[str, Array]:
        """Return the columns of n candidates without a change: one parameter at its own value."""
        name, (part, parameter) = next(iter(parameters_of(self.machine, self.controller).items()))
        return {name: np.full(n, float(getattr(part, parameter)))}


Columns: TypeAlias = Mapping[str, Array]
"""Values [SI] by parameter name, each (n,)."""
Judge: TypeAlias = Callable[[Columns], Array]
"""One figure [SI] of candidates, nan where a run failed."""
CHUNK = 1024
"""Candidates that are simulated and stored together."""


@dataclass(eq=False)
class Runner:
    """Run a setting with many sets of parameters, and return the figures of each run.

    The same values give the same figures bit for bit, independent of the other candidates and of where they run.

    Attributes
    ----------
    setting : Setting
    figures : tuple of str
        Names of figures that are needed besides those of contour error and tracking error.
    threads : int, optional
        One per processor by default.
    gpu : bool
        Whether a GPU runs the candidates.
    pool : Workers, optional
        Where to run; by default in this process.
    store : Checkpoint, optional
        Keeps finished chunks, which are then not run again; its study is that of the setting.
    progress : callable, optional
        Called with the candidates done and in all, for each call.
    runs, reused : int
        Number of new runs, and of runs read from the store.
    """

    setting: Setting
    figures: tuple[str, ...] = ()
    threads: int | None = None
    gpu: bool = False
    pool: Workers | None = None
    store: Checkpoint | None = None
    progress: Callable[[int, int], None] = lambda done, total: None
    runs: int = 0
    reused: int = 0
    _seen: set[Path] = field(init=False, repr=False, default_factory=set)
    _key: str = field(init=False, repr=False, default="")

    def judge(self, name: str) -> Judge:
        """Return the function that computes one figure of candidates."""
        return lambda columns: self(columns)[name]

    def __call__(self, columns: Columns, threads: int | None = None) -> dict[str, Array]:
        """Return figures and ``failed_at`` of `contourlab.loop.BatchResult`, each (n,); figures of a failed run are nan.

        Parameters
        ----------
        columns : mapping of str to ndarray (n,)
        threads : int, optional
            By default `threads` of the runner.

        Raises
        ------
        ParameterError
            If a name is unknown or a value out of range.
        """
        n = len(next(iter(columns.values())))
        size = GPU_LANES if self.gpu and self.store is None else CHUNK
        parts = []
        for first in range(0, n, size):
            parts.append(self._chunk(_cut(columns, first, size), threads or self.threads))
            self.progress(min(first + size, n), n)
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}

    def _chunk(self, columns: Columns, threads: int | None) -> dict[str, Array]:
        """Return the figures of a chunk, from the store if it has them."""
        n = len(next(iter(columns.values())))
        if self.store is None:
            self.runs += n
            return self.run(columns, threads)
        keys = [f"\n{name}\n".encode() + values.astype("<f8").tobytes() for name, values in columns.items()]
        path = self.store.path(*keys, *(name.encode() for name in self.figures))
        figures, was_there = self.store.once(path, lambda: self.run(columns, threads))
        if not was_there:
            self.runs += n
        elif path not in self._seen:  # several parts of a study need the run with the present values: count it once
            self.reused += n
        self._seen.add(path)
        return figures

    def run(self, columns: Columns, threads: int | None = None) -> dict[str, Array]:
        """Run candidates, whatever is stored."""
        if self.pool is None:
            return _run(self.setting, columns, self.figures, threads=threads, gpu=self.gpu)
        checked_variants(self.setting.machine, self.setting.controller, columns)
        self._key = self._key or self.pool.shared(self.setting)
        n = len(next(iter(columns.values())))
        size = lanes_each(n, self.pool.count)
        pieces = [(_cut(columns, first, size), self.figures) for first in range(0, n, size)]
        parts = self.pool.map(_run_elsewhere, self._key, pieces)
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def _cut(columns: Columns, first: int, size: int) -> dict[str, Array]:
    return {name: np.asarray(values)[first : first + size] for name, values in columns.items()}


def _run(setting: Setting, columns: Columns, figures: tuple[str, ...], **options: Any) -> dict[str, Array]:
    batch = setting.batch(columns, figures, **options)
    return {**batch.figures, "failed_at": batch.failed_at.astype(float)}


def _run_elsewhere(setting: Setting, item: tuple[Columns, tuple[str, ...]]) -> dict[str, Array]:
    return _run(setting, *item, threads=1)


# --- what figures depend on ---


def run_identity(settings: Sequence[Setting], rooms: Iterable[str] = ()) -> str:
    """Return as text everything that affects runs, except the parameters that a study varies.

    This includes machines, controller, motion, noise, plugins, and the version and source of the program.

    Parameters
    ----------
    settings : sequence of Setting
        They differ in their machines only.
    rooms : iterable of str
        Further rooms of the program that affect the result, such as ``"features/swap"``.
    """
    from contourlab.scenario.dump import dump

    first, machines = settings[0], [setting.machine for setting in settings]
    texts = [dump(machine) for machine in machines]
    texts += [dump(first.controller, first.machine), first.reference.digest, f"seed {first.seed}, moving {first.moving}"]
    return "\n".join([*texts, *_plugins(machines, first.controller), *program_identity(tuple(rooms))])


def _plugins(machines: Iterable[Machine], controller: Controller) -> list[str]:
    """Return name and digest of the file of each plugin component in use; files that it imports are ignored."""
    from contourlab.loop.machine import AXIS_SLOTS

    parts = [getattr(axis, slot) for machine in machines for axis in machine.axes for slot in AXIS_SLOTS]
    for axis in controller.axes.values():
        parts += axis.parts.values()
        parts += [] if axis.link is None else [axis.link.down, axis.link.up]
    parts += [controller.estimator, controller.coupling]
    modules = {type(part).__module__ for part in parts if part is not None}
    files = [sys.modules[name].__file__ for name in sorted(modules) if name.partition(".")[0] != "contourlab"]
    return [f"{Path(file).name} {hashlib.sha256(Path(file).read_bytes()).hexdigest()}" for file in files if file is not None]
