"""Searches of a study, each kept on disk as it ends, so that what was interrupted goes on where it stopped."""

from __future__ import annotations

import hashlib
import io
from collections.abc import Callable
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from contourlab.result.atomic import write_bytes_atomic
from contourlab.studies.swap.design import Design, Own
from contourlab.studies.swap.fleet import Fleet

__all__ = ["Kept"]

Arrays = dict[str, NDArray[Any]]
Result = TypeVar("Result", Own, Design)


@dataclass(eq=False)
class Kept:
    """Searches in a folder: a file for each, named by all that decides what is in it.

    With what a search came to its file has what it left behind in the fleet: the best of each variant, and the counts of runs. So a study
    that goes on from files is the same bit by bit as one that was never interrupted.

    Parameters
    ----------
    folder : Path
        Made when the first search is kept.
    model : str
        All that decides the study.
    found : int
        Searches that were kept from an earlier time.
    damaged : int
        Files that could not be read; their searches are made again.
    """

    folder: Path
    model: str
    found: int = field(default=0, init=False)
    damaged: int = field(default=0, init=False)

    @property
    def home(self) -> Path:
        """Folder of the searches of this study."""
        return self.folder / hashlib.sha256(self.model.encode()).hexdigest()[:16]

    @property
    def others(self) -> int:
        """How many other studies have searches beside this one's."""
        return sum(path != self.home and path.is_dir() for path in self.folder.glob("?" * 16))

    def search(self, fleet: Fleet, words: str, kind: type[Result], make: Callable[[], Result]) -> Result:
        """Return what a search came to: from its file if there is one, else as `make` finds it, which is then kept.

        Parameters
        ----------
        fleet : Fleet
            Which the search moves on.
        words : str
            What is searched; with the state of the fleet before, the name of the file.
        kind : type
            `Own` or `Design`.
        make : callable
        """
        text = hashlib.sha256(f"{self.model}\n{words}\n".encode())
        for name, values in _state(fleet).items():
            text.update(f"\n{name}\n".encode() + values.tobytes())
        file = self.home / f"{text.hexdigest()[:32]}.npz"
        known = self._read(file, fleet, kind)
        if known is not None:
            self.found += 1
            return known
        made = make()
        buffer = io.BytesIO()
        np.savez(
            buffer, allow_pickle=False, **_state(fleet), **{f"result.{one.name}": _array(getattr(made, one.name)) for one in fields(made)}
        )
        write_bytes_atomic(file, buffer.getvalue())
        return made

    def _read(self, file: Path, fleet: Fleet, kind: type[Result]) -> Result | None:
        if not file.exists():
            return None
        try:
            with np.load(io.BytesIO(file.read_bytes()), allow_pickle=False) as data:  # a zip: damage fails its checksum
                state = {name: data[name] for name in _state(fleet)}
                found = {one.name: _value(data[f"result.{one.name}"]) for one in fields(kind)}
        except Exception:  # zipfile, zlib, NumPy and the system each have errors of their own for a damaged file
            self.damaged += 1
            return None
        _restore(fleet, state)
        return kind(**found)


def _state(fleet: Fleet) -> Arrays:
    """Return all of a fleet that a search moves on."""
    runs = np.array([evaluator.runs for evaluator in fleet.evaluators])
    return {"best": fleet.best.copy(), "best_points": fleet.best_points.copy(), "tried": np.array(fleet.tried), "runs": runs}


def _restore(fleet: Fleet, state: Arrays) -> None:
    fleet.best, fleet.best_points, fleet.tried = state["best"], state["best_points"], int(state["tried"])
    for evaluator, runs in zip(fleet.evaluators, state["runs"].tolist(), strict=True):
        evaluator.runs = runs


def _array(value: Any) -> NDArray[Any]:
    return np.array(sorted(value), dtype=np.str_) if isinstance(value, frozenset) else np.asarray(value)


def _value(data: NDArray[Any]) -> Any:
    if data.dtype.kind == "U":
        return frozenset(data.tolist())
    return data if data.ndim else data.item()
