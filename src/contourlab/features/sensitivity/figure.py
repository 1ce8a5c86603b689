"""Which figure of a run a study looks at."""

from __future__ import annotations

from dataclasses import dataclass

from contourlab.errors import ParameterError
from contourlab.feed import Reference
from contourlab.loop import Machine
from contourlab.loop.judging import counted


@dataclass(frozen=True)
class Figure:
    """A figure of a run.

    Attributes
    ----------
    name : str
        As it is asked for.
    key : str
        As `contourlab.loop.BatchResult` has it.
    unit : str
        SI.
    words : str
        As people say it.
    """

    name: str
    key: str
    unit: str
    words: str


FIGURES = {
    figure.name: figure
    for figure in (
        Figure("integral", "contour_error_integral", "m*s", "integral of the contour error"),
        Figure("rms", "contour_error_rms", "m", "contour error, rms"),
        Figure("max", "contour_error_max", "m", "largest contour error"),
    )
}


def figure_called(name: str) -> Figure:
    """Return a figure by its name.

    Raises
    ------
    ParameterError
        If there is none.
    """
    if name not in FIGURES:
        raise ParameterError("--figure", repr(name), f"one of {', '.join(FIGURES)}")
    return FIGURES[name]


def failure_level(machine: Machine, reference: Reference, figure: Figure) -> float:
    """Return the figure [SI] of a run that is at the limit of its following error all the time; infinite where no axis has a limit."""
    limit = max(axis.limits.following_error for axis in machine.axes)
    if figure.name != "integral":
        return limit
    start, stop = counted(reference, None)
    return limit * (stop - start) * machine.servo_period
