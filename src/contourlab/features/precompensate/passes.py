"""What is kept from pass to pass, in memory or in a folder."""

from __future__ import annotations

import hashlib
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

from contourlab.errors import ParameterError, ResultError, error_text, refuse
from contourlab.features.precompensate.law import RESTS, Learned, Loop
from contourlab.features.precompensate.writing import Written
from contourlab.result.atomic import replacing
from contourlab.result.record import packed, unpacked
from contourlab.study.checkpoint import Checkpoint

HELPS = 0.02
"""Least gain of two passes over the best before them, as a share of its rms; of one pass, where the error is below `RESTS`."""
LATE = 3
"""Passes in a row that took too long after which no further one is tried."""


@dataclass(frozen=True)
class PassFigures:
    """A pass that was run.

    Attributes
    ----------
    number : int
        0 for the program itself.
    rms, largest : float [m]
        Contour error over the corrected motion.
    duration : float [s]
        From the first to the last motion of the command.
    velocity, acceleration : tuple of float [m/s, m/s^2]
        Largest values of each axis' command.
    in_time : bool
        Whether the cycle time, without added dwells, is within the band.
    dwell : float [s]
        Added dwells.
    line : int
        Of the program, in which the largest error lies.
    place : tuple of float [m]
        Axis positions there.
    share : float
        Of the summed squared error, from within the time of the filter, 1/cutoff, around it.
    """

    number: int
    rms: float
    largest: float
    duration: float
    velocity: tuple[float, ...]
    acceleration: tuple[float, ...]
    in_time: bool
    dwell: float
    line: int
    place: tuple[float, ...]
    share: float


@dataclass(frozen=True)
class AddedDwell:
    """A dwell before a cut.

    Attributes
    ----------
    block : int
        Number of the block after it.
    seconds : float [s]
        0 where it did not help.
    error : float [m]
        At the start of the cut without it.
    """

    block: int
    seconds: float
    error: float


@dataclass(frozen=True, eq=False)
class Passes:
    """All passes so far.

    Attributes
    ----------
    digest : str
        Of program and options that may not change.
    axes : tuple of str
    loops : tuple of Loop
    cutoff : float [Hz]
    figures : tuple of PassFigures
    learned : Learned or None
    written : tuple of Written
        The programs of passes 1, 2, ...
    logs : tuple of str
        Digests of the logs.
    dwells : tuple of AddedDwell
        Of the next program.
    """

    digest: str
    axes: tuple[str, ...] = ()
    loops: tuple[Loop, ...] = ()
    cutoff: float = 0.0
    figures: tuple[PassFigures, ...] = ()
    learned: Learned | None = None
    written: tuple[Written, ...] = ()
    logs: tuple[str, ...] = ()
    dwells: tuple[AddedDwell, ...] = ()

    @property
    def best(self) -> int:
        """The pass within the band of cycle time with the least sum of rms and largest error, each over that of the program itself."""
        first, kept = self.figures[0], [one for one in self.figures if one.in_time]
        return min(kept, key=lambda one: one.rms / (first.rms or 1.0) + one.largest / (first.largest or 1.0)).number

    @property
    def helps(self) -> bool:
        """Whether to go on: not after two passes in time with small gains, one where places are left as they are, or three too slow."""
        if len(self.figures) > LATE and not any(one.in_time for one in self.figures[-LATE:]):
            return False
        rms = [one.rms for one in self.figures if one.in_time]
        if len(rms) < 3:
            return True
        rests = rms[-1] <= RESTS * rms[0] and (1.0 - HELPS) * min(rms[:-1]) < rms[-1] <= min(rms[:-1])
        return not rests and min(rms[-2:]) < (1.0 - HELPS) * min(rms[:-2])


def digest_of(*parts: bytes) -> str:
    """Return a digest of some content."""
    return hashlib.sha256(b"\0".join(parts)).hexdigest()


def save(passes: Passes, folder: Path) -> None:
    """Write passes into a folder, with the program of each; all or nothing.

    Raises
    ------
    OutputError
        If the folder cannot be written to.
    """
    kept = _kept(folder, passes)
    with ExitStack() as files:
        for number, written in enumerate(passes.written, 1):
            new = files.enter_context(replacing(folder / f"pass-{number}.ngc"))
            new.write_bytes(written.text.encode("utf-8", "replace"))
        kept.store(kept.path(), packed(passes))


def load(folder: Path, none: Passes) -> Passes:
    """Read the passes of a folder; return `none` if it has none.

    Raises
    ------
    ParameterError
        If they are of another program or of other options.
    ResultError
        If they are damaged.
    """
    kept = _kept(folder, none)
    arrays, cure = kept.load(kept.path()), "use a new folder with --passes"
    if arrays is not None:
        try:
            return unpacked(arrays, Passes)
        except (KeyError, ValueError) as error:
            raise ResultError(f"{kept.home}: {error_text(error)}: {cure}") from error
    refuse(kept.damaged, ResultError, f"{kept.home}: is damaged: {cure}")
    other = "a new folder: this one holds passes of another program, of other options or of an older version"
    refuse(kept.others, ParameterError, "--passes", repr(str(folder)), other)
    return none


def _kept(folder: Path, passes: Passes) -> Checkpoint:
    return Checkpoint(folder, f"contourlab-passes/4 {passes.digest}")
