"""One number at a time: a line of values over its range, run in lanes, then finer ones around the best that the guards let pass."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.sampled_loop import SampledLoop
from contourlab.design import DesignVariable
from contourlab.design.guards import Guards
from contourlab.errors import ParameterError
from contourlab.features.tune.objective import Objective

Array = NDArray[np.float64]
PLATEAUS = ("robust", "best", "largest")
NEVER = math.inf


@dataclass(frozen=True)
class LineRule:
    """How a number is searched.

    Attributes
    ----------
    lanes : int, >= 8
        Values of a line; 32 fill the lanes of one thread.
    refinements : int, >= 0
        Finer lines, each between the neighbours of the best value so far.
    plateau : str
        Which of the values that are as good as the best, within `within`, is taken: "robust" the one whose loop stays farthest from -1,
        "largest" the largest ("as large as feasible"), "best" the best itself.
    within : float, >= 0
        Part by which a value may be worse than the best and still counts as good.
    """

    lanes: int = 32
    refinements: int = 2
    plateau: str = "robust"
    within: float = 0.01

    def __post_init__(self) -> None:
        if self.plateau not in PLATEAUS:
            raise ParameterError("plateau", repr(self.plateau), f"one of {', '.join(PLATEAUS)}")
        if not 8 <= self.lanes <= 1024:
            raise ParameterError("lanes", f"{self.lanes}", "8 to 1024")
        if not 0 <= self.refinements <= 8:
            raise ParameterError("refinements", f"{self.refinements}", "0 to 8")
        if not 0.0 <= self.within < 1.0:
            raise ParameterError("within", f"{self.within:g}", ">= 0 and < 1")


@dataclass(frozen=True, eq=False)
class Step:
    """One number calibrated while all others stay.

    Attributes
    ----------
    stage : str
        "repair", or "pass 1" and so on.
    number : DesignVariable
    before, after : float [SI]
        Its value.
    objective_before, objective_after : float
    bound : str
        What kept it from a value at which the objective would be smaller, and the end of its range that it stands on; empty where nothing
        did.
    values, objectives : ndarray (k,)
        All that was tried, values rising.
    allowed : ndarray (k,) of bool
        Whether the guards let a value pass, as far as it was asked.
    """

    stage: str
    number: DesignVariable
    before: float
    after: float
    objective_before: float
    objective_after: float
    bound: str
    values: Array
    objectives: Array
    allowed: NDArray[np.bool_]


def line_search(
    objective: Objective, guards: Guards, number: DesignVariable, values: Mapping[str, float], rule: LineRule, stage: str = "pass 1"
) -> Step:
    """Return the best value of one number, all others as in `values` [SI].

    Parameters
    ----------
    objective : Objective
    guards : Guards
    number : DesignVariable
    values : mapping of str to float [SI]
        Of all numbers, this one's among them.
    rule : LineRule
    stage : str
        What the step is called.

    Notes
    -----
    The value that it has is among those tried, so the objective never rises. Where the present values already cross a bound, a value may
    not cross it further.
    """
    line = _Line(objective, guards, number, values)
    line.add(np.append(np.linspace(0.0, 1.0, rule.lanes - 1), number.normalise(values[number.name])), keep_present=True)
    for _ in range(rule.refinements):
        low, high = line.around(line.best())
        if not high > low:
            break
        line.add(np.linspace(low, high, rule.lanes + 2)[1:-1])
    best = line.best()
    found = line.settled(best, rule)
    return Step(
        stage,
        number,
        float(values[number.name]),
        float(line.values[found]),
        float(line.value[line.present]),
        float(line.value[found]),
        line.bound(best, found),
        line.values.copy(),
        line.value.copy(),
        np.array([line.asked.get(v, (0.0, 0.0))[0] <= line.allowance for v in line.values.tolist()]) & line.within_limits(),
    )


class _Line:
    """All values of one number that were tried, rising, and what is known of them."""

    def __init__(self, objective: Objective, guards: Guards, number: DesignVariable, values: Mapping[str, float]) -> None:
        self.objective, self.guards, self.number, self.given = objective, guards, number, dict(values)
        self.axes = guards.concerned(number.name)
        self.values = self.value = self.limited = self.largest = np.zeros(0)
        self.own = float(values[number.name])
        self.asked: dict[float, tuple[float, float]] = {}
        self.loops: dict[float, list[SampledLoop]] = {}
        self.allowance = 0.0

    @property
    def present(self) -> int:
        """Index of the value that the number has."""
        return int(np.flatnonzero(self.values == self.own)[0])

    def add(self, places: Array, keep_present: bool = False) -> None:
        """Run values at places from 0 to 1."""
        tried = np.asarray(self.number.physical(places))
        if keep_present:
            tried[-1] = self.own
        tried = np.setdiff1d(np.unique(tried), self.values)
        if not tried.size:
            return
        columns = {name: np.full(tried.size, value) for name, value in self.given.items()} | {self.number.name: tried}
        found = self.objective(columns)
        self.loops |= dict(zip(tried.tolist(), self.guards.loops(columns, self.axes), strict=True))
        order = np.argsort(np.concatenate([self.values, tried]), kind="stable")
        for name in ("value", "limited", "largest"):
            setattr(self, name, np.concatenate([getattr(self, name), getattr(found, name)])[order])
        self.values = np.concatenate([self.values, tried])[order]
        self.allowance = self.margins(self.present)[0] if not self.asked else self.allowance

    def margins(self, i: int) -> tuple[float, float]:
        """Return how far margins fall short with a value, and how far its loops stay from -1."""
        value = float(self.values[i])
        if value not in self.asked:
            self.asked[value] = self.guards.missing(self.loops[value])
        return self.asked[value]

    def within_limits(self) -> NDArray[np.bool_]:
        """Tell of each value whether its run went well and kept to the limits of the drives, as far as the present one does."""
        bounds, here = self.guards.bounds, self.present
        limited = self.limited <= max(bounds.limited, self.limited[here] if np.isfinite(self.limited[here]) else 0.0)
        largest = self.largest <= max(bounds.command, self.largest[here] if np.isfinite(self.largest[here]) else 0.0)
        return np.asarray(np.isfinite(self.value) & limited & largest)

    def allowed(self, i: int) -> bool:
        """Tell whether the guards let a value pass."""
        return bool(self.within_limits()[i]) and self.margins(i)[0] <= self.allowance

    def best(self) -> int:
        """Return the index of the best value that may be taken; the present one where none may."""
        fine = self.within_limits()
        for i in np.argsort(self.value, kind="stable").tolist():
            if fine[i] and self.margins(i)[0] <= self.allowance:
                return int(i)
        return self.present

    def around(self, i: int) -> tuple[float, float]:
        """Return the places of the neighbours of a value."""
        place = self.number.normalise(self.values)
        return float(place[max(i - 1, 0)]), float(place[min(i + 1, len(place) - 1)])

    def settled(self, best: int, rule: LineRule) -> int:
        """Return the index of the value that is taken of all that are as good as the best."""
        if rule.plateau == "best" or not np.isfinite(self.value[best]):
            return best
        limit = min(self.value[best] * (1.0 + rule.within), max(self.value[best], self.value[self.present]))
        good = [i for i in np.flatnonzero(self.value <= limit).tolist() if self.allowed(i)]
        if not good:
            return best
        if rule.plateau == "largest":
            return int(max(good))
        # Feedforward moves no pole: there all are alike, and the best is taken.
        far = max(self.margins(i)[1] for i in good)
        alike = [i for i in good if self.margins(i)[1] >= far * (1.0 - 1e-6)]
        return int(min(alike, key=lambda i: self.value[i]))

    def bound(self, best: int, found: int) -> str:
        """Return in words what stands between the value taken and a smaller objective, an end of the range included."""
        end, barred = self.number.end(float(self.values[found])), self.barred(best)
        if barred or end:
            return "; ".join(filter(None, (barred, end)))
        return "" if found == best else "as good as the best"

    def barred(self, best: int) -> str:
        """Return in words which bound a value with a smaller objective than the best that may be taken would cross."""
        lower = int(np.argmin(self.value))
        if self.value[lower] < self.value[best] and lower != best:
            if not self.within_limits()[lower]:
                return "limit of a drive"
            margins = self.margins(lower)[0]
            return "stability" if math.isinf(margins) else "margins"
        return ""
