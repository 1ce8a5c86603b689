"""Source and uncertainty of parameter values."""

from __future__ import annotations

from dataclasses import dataclass

from contourlab.errors import ParameterError

SOURCES = {
    "measured": "read from an instrument",
    "fitted": "computed from a log",
    "datasheet": "published by the maker or in a paper",
    "assumed": "for lack of better data",
    "design": "chosen, exact",
    "control": "set in the control's own file, exact",
    "computed": "computed from values of the control's own file",
}
"""Sources of a value."""


@dataclass(frozen=True)
class Origin:
    """Source and uncertainty of a value, in its SI unit.

    Parameters
    ----------
    source : str
        A key of `SOURCES`.
    deviation : float or None [unit of the value], > 0
        Standard deviation of a normal distribution; None if not stated.
    span : (float, float) or None
        Lowest and highest value of a uniform distribution, instead of a deviation.
    reference : str
        The log, table or page.
    note : str

    Raises
    ------
    ParameterError
        If the source is unknown, both distributions are given, one has no finite width, or a design value has an uncertainty.

    >>> Origin("fitted", deviation=0.11, reference="DATA_EMPS.mat").uncertain
    True
    """

    source: str
    deviation: float | None = None
    span: tuple[float, float] | None = None
    reference: str = ""
    note: str = ""

    def __post_init__(self) -> None:
        if self.source not in SOURCES:
            raise ParameterError("source", repr(self.source), f"one of {', '.join(SOURCES)}")
        if self.deviation is not None and self.span is not None:
            raise ParameterError("range", "given with deviation", "left out: a number has only one distribution")
        if self.deviation is not None and not 0.0 < self.deviation < float("inf"):
            raise ParameterError("deviation", f"{self.deviation:g}", "> 0 and finite")
        if self.span is not None and not -float("inf") < self.span[0] < self.span[1] < float("inf"):
            raise ParameterError("range", f"{list(self.span)}", "two finite values, the lower one first")
        if self.uncertain and self.source in ("design", "control"):
            raise ParameterError("source", repr(self.source), "another source: a chosen number has no deviation")

    @property
    def uncertain(self) -> bool:
        """Whether the value has an uncertainty."""
        return self.deviation is not None or self.span is not None
