"""What a calibration makes small: figures of the run, one or a weighted sum, of one machine or of the worst of several."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from contourlab.design import Evaluator
from contourlab.errors import ParameterError

Array = NDArray[np.float64]

FIGURES = {
    "integral": ("contour_error_integral", "m*s", "um*s"),
    "max": ("contour_error_max", "m", "um"),
    "rms": ("contour_error_rms", "m", "um"),
    "tracking": ("tracking_error_rms", "m", "um"),
    "energy": ("command_energy", "s", "s"),
}
"""What may be asked for: figure of a batch, its unit, and the unit in which it is shown."""


@dataclass(frozen=True)
class Goal:
    """Figures and their weights.

    Attributes
    ----------
    weights : tuple of (str, float)
        Of `FIGURES`, each > 0. With more than one, each figure counts in parts of what it is at the start.
    """

    weights: tuple[tuple[str, float], ...] = (("integral", 1.0),)

    def __post_init__(self) -> None:
        names = [name for name, _ in self.weights]
        for name, weight in self.weights:
            if name not in FIGURES:
                raise ParameterError("objective", repr(name), f"of {', '.join(FIGURES)}, or a sum such as integral=1,energy=0.1")
            if not (weight > 0.0 and math.isfinite(weight)):
                raise ParameterError("objective", f"{name}={weight:g}", "a weight > 0")
        if not names or len(set(names)) < len(names):
            raise ParameterError("objective", ",".join(names) or "none", "at least one figure, each once")

    @staticmethod
    def parse(text: str) -> Goal:
        """Return the goal of a text: ``integral``, or ``integral=1,energy=0.1``.

        Raises
        ------
        ParameterError
            If a figure is unknown, or a weight is no positive number.

        >>> Goal.parse("integral=1, energy=0.1").weights
        (('integral', 1.0), ('energy', 0.1))
        """
        found = []
        for part in text.split(","):
            name, given, weight = part.partition("=")
            try:
                found.append((name.strip(), float(weight) if given else 1.0))
            except ValueError as error:
                raise ParameterError("objective", repr(part), "a figure and its weight, as energy=0.1") from error
        return Goal(tuple(found))

    @property
    def single(self) -> str | None:
        """The only figure; None for a sum."""
        return self.weights[0][0] if len(self.weights) == 1 else None

    @property
    def words(self) -> str:
        """The goal in words."""
        return self.weights[0][0] if self.single else " + ".join(f"{weight:g} {name}" for name, weight in self.weights)


@dataclass(frozen=True, eq=False)
class Judged:
    """What runs came to, arrays (n,).

    Attributes
    ----------
    value : ndarray (n,)
        The objective: the worst over all machines; infinite where a run failed.
    limited, largest : ndarray (n,)
        Part of the time at a limit of a drive, and the largest command in parts of it: the worst.
    figures : tuple of mapping
        All figures, for each machine.
    """

    value: Array
    limited: Array
    largest: Array
    figures: tuple[Mapping[str, Array], ...]


@dataclass(eq=False)
class Objective:
    """A goal on one machine, or on several at once, of which the worst counts.

    Attributes
    ----------
    evaluators : sequence of Evaluator
        Machines that know the same dotted names.
    goal : Goal
    start : mapping of str to float
        Values [SI] that the figures of a sum are taken in parts of.
    """

    evaluators: Sequence[Evaluator]
    goal: Goal
    start: Mapping[str, float]
    _scales: tuple[dict[str, float], ...] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self._scales = ()
        if self.goal.single is None:
            found = self({name: np.array([value]) for name, value in self.start.items()})
            keys = [FIGURES[name][0] for name, _ in self.goal.weights]
            scales = tuple({key: float(one[key][0]) for key in keys} for one in found.figures)
            if not all(math.isfinite(value) and value > 0.0 for one in scales for value in one.values()):
                raise ParameterError("objective", self.goal.words, "a single figure: at the start the run fails, so a sum has no scale")
            self._scales = scales

    @property
    def runs(self) -> int:
        """How many runs it has made."""
        return sum(one.runs for one in self.evaluators)

    def __call__(self, columns: Mapping[str, Array]) -> Judged:
        """Return what runs with these values [SI], each (n,), come to."""
        figures = tuple(one(columns) for one in self.evaluators)
        values = np.max([self._value(one, i) for i, one in enumerate(figures)], axis=0)
        limited, largest = (np.max([one[key] for one in figures], axis=0) for key in ("limited_share", "command_largest"))
        failed = np.any([one["failed_at"] >= 0.0 for one in figures], axis=0) | ~np.isfinite(values)
        return Judged(np.where(failed, np.inf, values), limited, largest, figures)

    def _value(self, figures: Mapping[str, Array], machine: int) -> Array:
        if not self._scales:
            return figures[FIGURES[self.goal.weights[0][0]][0]]
        scale = self._scales[machine]
        parts = [weight * figures[FIGURES[name][0]] / scale[FIGURES[name][0]] for name, weight in self.goal.weights]
        return np.asarray(np.sum(parts, axis=0))
