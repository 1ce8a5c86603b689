"""Searches of a study, each kept on disk as it ends, so that what was interrupted goes on where it stopped."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from contourlab.app.checkpoint import KeptFolder
from contourlab.features.swap.design import Design
from contourlab.features.swap.fleet import Fleet
from contourlab.features.swap.own import Own

Arrays = dict[str, NDArray[Any]]
Result = TypeVar("Result", Own, Design)


@dataclass(eq=False)
class Kept(KeptFolder):
    """Searches in a folder: a file for each; the model is all that decides the study.

    With what a search came to its file has what it left behind in the fleet: the best of each variant, and the counts of runs. So a study
    that goes on from files is the same bit by bit as one that was never interrupted.

    Attributes
    ----------
    found : int
        Searches that were kept from an earlier time.
    """

    found: int = field(default=0, init=False)

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
        before = (f"\n{name}\n".encode() + values.tobytes() for name, values in _state(fleet).items())
        file = self.named(f"\n{words}\n".encode(), *before)

        def take(data: Mapping[str, Any]) -> tuple[Arrays, Result]:
            state = {name: data[name] for name in _state(fleet)}
            return state, kind(**{one.name: _value(data[f"result.{one.name}"]) for one in fields(kind)})

        known = self.load(file, take)
        if known is not None:
            self.found += 1
            _restore(fleet, known[0])
            return known[1]
        made = make()
        self.store(file, {**_state(fleet), **{f"result.{one.name}": _array(getattr(made, one.name)) for one in fields(made)}})
        return made


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
