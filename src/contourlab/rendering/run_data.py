"""Parts of a report's data: limits, frequency responses, planned feed and trials of learning."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from contourlab.arrays import Array, Complex


@dataclass(frozen=True, eq=False)
class AxisBounds:
    """Limits of the axes.

    Parameters
    ----------
    velocity, acceleration, jerk : ndarray (n_axis,) [m/s, m/s^2, m/s^3], > 0, inf for none
    command : ndarray (n_axis,), > 0, inf for none
        Command at which the drive saturates, in the unit of the command signal.
    """

    velocity: Array
    acceleration: Array
    jerk: Array
    command: Array


@dataclass(frozen=True, eq=False)
class FrequencyResponse:
    """Closed loop of one axis, reference to position.

    Parameters
    ----------
    frequency : ndarray (n,) [Hz], > 0, ascending
    response : ndarray of complex (n,)
        Position over reference, 1 when the axis follows exactly.
    notes : mapping of str to str
        Printed figures, for example ``{"bandwidth": "42 Hz", "phase margin": "61 deg"}``.
    meant : str
        Name of the linear loop, if the axis has several: for example ``"in contact"``.
    """

    frequency: Array
    response: Complex
    notes: Mapping[str, str] = field(default_factory=dict)
    stable: bool = True
    meant: str = ""


@dataclass(frozen=True, eq=False)
class FeedRun:
    """A planned motion along its path.

    Parameters
    ----------
    arc_length : ndarray (n,) [m]
        Ascending.
    feedrate : ndarray (n,) [m/s]
    programmed : ndarray (n,) [m/s]
        inf on rapids.
    time : ndarray (n,) [s]
        Ascending.
    binding : ndarray (n,) of int
        What limits the speed up to the next point: an index into `names`.
    """

    arc_length: Array
    feedrate: Array
    programmed: Array
    time: Array
    binding: NDArray[np.int8]
    names: Sequence[str]

    def shares(self) -> dict[str, float]:
        """Return the share of time for which each cause limits the speed, the largest first."""
        lasting = np.diff(self.time)
        total = float(lasting.sum()) or 1.0
        held = {name: float(lasting[self.binding[:-1] == code].sum()) / total for code, name in enumerate(self.names)}
        return dict(sorted(((name, part) for name, part in held.items() if part > 0.0), key=lambda item: -item[1]))


@dataclass(frozen=True, eq=False)
class TrialCourse:
    """Errors from trial to trial.

    Parameters
    ----------
    contour_rms : ndarray (n_trial,) [m]
        NaN for a trial that did not finish.
    tracking_rms : ndarray (n_trial, n_axis) [m]
    best : int
        The trial that gives the scheme's figures.
    status : str
        How learning ended.
    """

    contour_rms: Array
    tracking_rms: Array
    best: int
    status: str

    @property
    def in_words(self) -> str:
        """The end of learning in a few words."""
        trials = len(self.contour_rms) - 1
        return self.status if self.status.startswith("diverged") else f"{self.status}, best trial {self.best} of {trials}"
