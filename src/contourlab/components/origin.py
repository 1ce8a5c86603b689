"""Where a number is from, and how far it may be off."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from contourlab.errors import ComponentError, ParameterError

SOURCES = {
    "measured": "read off an instrument",
    "fitted": "worked out from a log",
    "datasheet": "printed by the maker, or in a paper",
    "assumed": "taken for want of better",
    "design": "chosen: exact",
}
"""Where a number can be from."""


@dataclass(frozen=True)
class Origin:
    """Where a number is from, and how far it may be off; in the SI unit of the number.

    Parameters
    ----------
    source : str
        Of `SOURCES`.
    deviation : float or None, > 0
        One standard deviation of a normal distribution; None where none is stated.
    span : (float, float) or None
        Lowest and highest value of a uniform distribution, in place of a deviation.
    reference : str
        The log, table or page.
    note : str

    Raises
    ------
    ParameterError
        If the source is unknown, both distributions are given, one has no width, or a number from design has an uncertainty.

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
            raise ParameterError("range", "given beside deviation", "left out: a number has one distribution")
        if self.deviation is not None and not 0.0 < self.deviation < float("inf"):
            raise ParameterError("deviation", f"{self.deviation:g}", "> 0 and finite")
        if self.span is not None and not -float("inf") < self.span[0] < self.span[1] < float("inf"):
            raise ParameterError("range", f"{list(self.span)}", "two finite values, the lower one first")
        if self.uncertain and self.source == "design":
            raise ParameterError("source", "'design'", "another one: what is chosen has no deviation")

    @property
    def uncertain(self) -> bool:
        """Whether it says how far the number may be off."""
        return self.deviation is not None or self.span is not None


class Traced:
    """What every component has besides its numbers: where these are from, as far as that was stated.

    It is no part of what a component is: two that differ in nothing else are equal and run the same.
    """

    kind: ClassVar[str] = ""
    parameters: ClassVar[Mapping[str, Any]] = {}
    _origins: Mapping[str, Origin] = {}

    @property
    def origins(self) -> Mapping[str, Origin]:
        """Where its numbers are from, by parameter."""
        return self._origins

    def values(self) -> dict[str, Any]:
        """Return every parameter with its value in SI."""
        raise NotImplementedError  # of a component

    def replace(self, **changes: Any) -> Any:
        """Return a copy with other parameters; where a changed number is from is not known any more."""
        kind: Any = type(self)
        return kind(**{**self.values(), **changes}).traced({k: v for k, v in self._origins.items() if k not in changes})

    def traced(self, origins: Mapping[str, Origin]) -> Any:
        """Return a copy whose numbers are from there.

        Raises
        ------
        ComponentError
            If one is no parameter.
        """
        unknown = [name for name in origins if name not in self.parameters]
        if unknown:
            raise ComponentError(f"{self.kind}: no parameter {unknown[0]!r}; there are: {', '.join(self.parameters) or 'none'}")
        if not origins and not self._origins:
            return self
        kind: Any = type(self)
        copy = kind(**self.values())
        object.__setattr__(copy, "_origins", dict(origins))
        return copy
