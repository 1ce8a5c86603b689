"""What goes into global indices: figures in decades, with an honest place for runs that failed."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from contourlab.design import Space
from contourlab.errors import ParameterError
from contourlab.features.sensitivity.runs import Array

REFUSED = 0.25
"""Part of the runs that may fail before indices are refused."""
BEYOND = 10.0
"""Where there is no limit of the following error, a failed run counts as this many times the worst one that held."""


@dataclass(frozen=True, eq=False)
class Outcome:
    """Figures as an estimator takes them.

    Attributes
    ----------
    values : ndarray (n,)
        Decimal logarithm of the figure [SI] if `logarithmic`, else the figure [SI].
    logarithmic : bool
    failed : int
        Runs that failed.
    capped : float [SI]
        What a failed run counts as, and the most that any counts as.
    """

    values: Array
    logarithmic: bool
    failed: int
    capped: float

    @property
    def share(self) -> float:
        """Part of the runs that failed."""
        return self.failed / len(self.values)


def outcome(figures: Array, level: float, logarithmic: bool, space: Space, points: Array) -> Outcome:
    """Return figures as an estimator takes them.

    Parameters
    ----------
    figures : ndarray (n,) [SI]
        NaN where a run failed.
    level : float [SI]
        Of a run that is at the failure limit all the time; infinite where there is none.
    logarithmic : bool
    space : Space
    points : ndarray (n, n_number)
        Places of the runs, 0 to 1, to say where runs fail.

    Raises
    ------
    ParameterError
        If more than `REFUSED` of the runs failed, or a logarithm is wanted of what is not above 0.
    """
    bad = np.isnan(figures)
    share = float(bad.mean())
    if share > REFUSED:
        number, side = _strayed(space, points[bad])
        right = (
            f"at most {100.0 * REFUSED:.0f} %: they would say what makes the loop fail, not what makes it accurate; take narrower bounds"
        )
        raise ParameterError("runs", f"{100.0 * share:.0f} % failed", f"{right}, first those of {number} at the {side} end")
    capped = level if math.isfinite(level) else BEYOND * float(figures[~bad].max())
    values = np.minimum(np.where(bad, capped, figures), capped)
    if logarithmic:
        if not (values > 0.0).all():
            flat = values <= 0.0
            number, side = _strayed(space, points[flat])
            seen = f"a figure of {values.min():g} in {int(flat.sum())} of {flat.size} runs, first those of {number} at the {side} end"
            raise ParameterError("--transform log", seen, "above 0 in all; take --transform none, with which the runs made so far count")
        values = np.log10(values)
    return Outcome(values, logarithmic, int(bad.sum()), capped)


def _strayed(space: Space, points: Array) -> tuple[str, str]:
    """Return the number that is farthest from the middle of its range on the mean of places (n, n_number), and on which side."""
    off = points.mean(axis=0) - 0.5
    at = int(np.argmax(np.abs(off)))
    return space.numbers[at].short, "upper" if off[at] > 0.0 else "lower"
