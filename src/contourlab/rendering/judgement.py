"""The verdict on a run, and how far to trust its figures: sources of the numbers, interval of the part error."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from contourlab.arrays import Array
from contourlab.findings import Finding
from contourlab.loop import Controller
from contourlab.units import from_si

FEED = "feed 80 %"
"""Name of the change that takes the feed down by a fifth."""
NOT_STATED = "not stated"
MOST_ITEMS = 4
"""Items of a list that are printed."""


@dataclass(frozen=True)
class Number:
    """A number of a machine or controller, and its source.

    Attributes
    ----------
    name : str
        Dotted, as ``axes.x.plant.mass``.
    value : float or tuple of float
        In SI.
    unit, display : str
        SI unit and display unit.
    source : str
        One of `contourlab.components.origin.SOURCES`, or ``not stated``.
    deviation : float or None
        Standard deviation.
    range : (float, float) or None
        Bounds of a uniform distribution.
    drawn : bool
        Whether it differs between the sampled machines.
    simulated : bool
        Whether it belongs to the simulated machine; the numbers of a controller are exact.
    """

    name: str
    value: float | tuple[float, ...]
    unit: str
    display: str = field(metadata={"json": False})
    source: str = NOT_STATED
    deviation: float | None = None
    range: tuple[float, float] | None = None
    reference: str = ""
    note: str = ""
    drawn: bool = False
    simulated: bool = field(default=False, metadata={"json": False})

    @property
    def is_stated(self) -> bool:
        """Whether its source is stated."""
        return self.source != NOT_STATED

    @property
    def value_text(self) -> str:
        """The value in its display unit."""
        if not isinstance(self.value, tuple):
            return self._shown(self.value)
        rest = f", ... ({len(self.value)})" if len(self.value) > MOST_ITEMS else ""
        return ", ".join(map(self._shown, self.value[:MOST_ITEMS])) + rest

    @property
    def deviation_text(self) -> str:
        """The deviation or range in the display unit; empty for none."""
        if self.deviation is not None:
            share = f" ({100.0 * self.deviation / abs(self.value):.2g} %)" if isinstance(self.value, float) and self.value else ""
            return f"± {self._shown(self.deviation, 3)}{share}"
        return f"{self._shown(self.range[0])} to {self._shown(self.range[1])}" if self.range is not None else ""

    def _shown(self, value: float, digits: int = 6) -> str:
        return f"{from_si(value, self.display):.{digits}g}"


@dataclass(frozen=True)
class Spread:
    """Median, 5 % and 95 % of a figure [m]; infinite where too many samples failed."""

    median: float
    low: float
    high: float


@dataclass(frozen=True)
class Rank:
    """Rank correlation of a sampled number with rms and maximum of the part error, over the samples that did not fail."""

    name: str
    rms: float
    max: float


@dataclass(frozen=True, eq=False)
class Interval:
    """Part error of machines sampled from the stated deviations.

    Attributes
    ----------
    samples : int
        0 without an interval; the findings give the reason.
    rms, max : Spread or None [m]
    failed : int
        Samples that left a following-error limit or produced a non-finite command.
    beyond_tolerance : int or None
        Samples that failed or whose largest part error exceeds the tolerance; None without one.
    ranks : tuple of Rank
        Strongest first.
    noticeable : float
        Least magnitude of a rank correlation that is not chance.
    main : str
        The number that contributes most; empty if none dominates.
    values : mapping of str to ndarray (n,)
        The sampled numbers, in SI.
    figures : mapping of str to ndarray (n,) [m]
        ``rms`` and ``max`` of each sample; NaN where it failed.
    """

    samples: int = 0
    rms: Spread | None = None
    max: Spread | None = None
    failed: int = 0
    beyond_tolerance: int | None = None
    ranks: tuple[Rank, ...] = ()
    noticeable: float = 0.0
    main: str = ""
    findings: tuple[Finding, ...] = field(default=(), metadata={"json": False})
    values: Mapping[str, Array] = field(default_factory=dict, metadata={"json": False})
    figures: Mapping[str, Array] = field(default_factory=dict, metadata={"json": False})


@dataclass(frozen=True)
class Trust:
    """Sources of one scheme's numbers, names of the numbers without a source, and the interval (None if not requested)."""

    provenance: tuple[Number, ...]
    not_stated: tuple[str, ...]
    interval: Interval | None = None


@dataclass(frozen=True, slots=True)
class Cause:
    """One cause of the error at the worst place.

    Attributes
    ----------
    name : str
    contribution : float [m]
        Along the direction of the error; negative where it makes the error smaller.
    share : float, 0 to 1
        Share of the sum of all contributions' magnitudes.
    """

    name: str
    contribution: float
    share: float

    @property
    def words(self) -> str:
        """The cause in plain words."""
        return {"reversal": "friction at the reversal", "breakaway": "friction at the start"}.get(self.name, self.name)


@dataclass(frozen=True, slots=True)
class Worst:
    """Where the part error is largest.

    Attributes
    ----------
    value : float [m]
        The error.
    sample : int
    time : float [s]
    position : tuple of float, one for each axis [m]
    arc_length : float [m]
    line : int
        Source line; 0 for none.
    text : str
        Text of the line.
    """

    value: float
    sample: int
    time: float
    position: tuple[float, ...]
    arc_length: float
    line: int
    text: str


@dataclass(frozen=True, slots=True)
class Change:
    """A change that was run alone.

    Attributes
    ----------
    name : str
    part_error : float [m]
        The largest.
    added_time : float [s]
        Time by which the motion is longer.
    """

    name: str
    part_error: float
    added_time: float


@dataclass(frozen=True, slots=True)
class Verdict:
    """Pass or fail against a tolerance.

    Attributes
    ----------
    passed : bool
        Whether the largest part error is within the tolerance, and the tool traces the whole path. The longest skipped piece may reach ten
        tolerances (two at the end), or three steps of the reference if these are longer.
    tolerance : float [m]
    worst : Worst
    causes : tuple of Cause
        Largest first.
    left_out : float [m]
        Longest piece of the path that the tool skips, if it is too long to pass; else 0.
    findings : tuple of Finding
        Skipped path, causes that could not be separated, the best changes.
    proposed : Controller or None
        With the best changes; None if they leave the controller as it is.
    changes : tuple of Change
        Those that lower the error each by itself, the best first.
    """

    passed: bool
    tolerance: float
    worst: Worst
    causes: tuple[Cause, ...] = ()
    left_out: float = 0.0
    findings: tuple[Finding, ...] = field(default=(), metadata={"json": False})
    proposed: Controller | None = field(default=None, metadata={"json": False})
    changes: tuple[Change, ...] = ()
