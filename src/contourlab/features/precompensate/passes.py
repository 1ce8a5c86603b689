"""What is kept from pass to pass, in memory or in a folder."""

from __future__ import annotations

import hashlib
import io
import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.errors import ParameterError, ResultError
from contourlab.features.precompensate.law import RESTS, Learned, Loop
from contourlab.features.precompensate.writing import Written
from contourlab.result.atomic import write_bytes_atomic
from contourlab.study.checkpoint import typed

HELPS = 0.02
"""Least gain of two passes over the best before them, as a share of its rms; of one pass, where the error is below `RESTS`."""
LATE = 3
"""Passes in a row that took too long after which no further one is tried."""
STATE = "passes.npz"
_FORMAT = 1


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
        Whether the cycle time is within the band.
    """

    number: int
    rms: float
    largest: float
    duration: float
    velocity: tuple[float, ...]
    acceleration: tuple[float, ...]
    in_time: bool


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
    """

    digest: str
    axes: tuple[str, ...] = ()
    loops: tuple[Loop, ...] = ()
    cutoff: float = 0.0
    figures: tuple[PassFigures, ...] = ()
    learned: Learned | None = None
    written: tuple[Written, ...] = ()
    logs: tuple[str, ...] = ()

    @property
    def best(self) -> int:
        """The pass with the smallest rms error among those within the band of cycle time."""
        return min((one for one in self.figures if one.in_time), key=lambda one: one.rms).number

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
    """Write passes into a folder, with the program of each.

    Raises
    ------
    OutputError
        If the folder cannot be written to.
    """
    folder.mkdir(parents=True, exist_ok=True)
    for number, written in enumerate(passes.written, 1):
        write_bytes_atomic(folder / f"pass-{number}.ngc", written.text.encode("utf-8", "replace"))
    about: dict[str, Any] = {
        "format": _FORMAT,
        "digest": passes.digest,
        "axes": passes.axes,
        "loops": [asdict(loop) for loop in passes.loops],
        "cutoff": passes.cutoff,
        "figures": [asdict(one) for one in passes.figures],
        "logs": passes.logs,
        "texts": [[one.text, one.n_line, one.shortest] for one in passes.written],
    }
    arrays: dict[str, Any] = {"about": np.array(json.dumps(about))}
    for number, written in enumerate(passes.written):
        arrays |= {f"corrected_{number}": written.corrected_arc, f"programmed_{number}": written.programmed_arc}
    if passes.learned is not None:
        arrays |= {f"learned_{name}": np.asarray(value) for name, value in vars(passes.learned).items()}
    content = io.BytesIO()
    np.savez_compressed(content, **arrays)
    write_bytes_atomic(folder / STATE, content.getvalue())


def load(folder: Path, none: Passes) -> Passes:
    """Read the passes of a folder; return `none` if it has none.

    Raises
    ------
    ParameterError
        If they are of another program or of other options.
    ResultError
        If the file is damaged.
    """
    file = folder / STATE
    if not file.exists():
        return none
    try:
        with np.load(file, allow_pickle=False) as arrays:
            about = json.loads(str(arrays["about"]))
            names = Learned.__dataclass_fields__
            learned: dict[str, Any] = {name: arrays[f"learned_{name}"][()] for name in names if f"learned_{name}" in arrays}
            written = tuple(
                Written(text, arrays[f"corrected_{k}"], arrays[f"programmed_{k}"], n_line, shortest)
                for k, (text, n_line, shortest) in enumerate(about["texts"])
            )
        kinds = {"axes": tuple[str, ...], "loops": tuple[Loop, ...], "figures": tuple[PassFigures, ...], "logs": tuple[str, ...]}
        read = {name: typed(about[name], kind) for name, kind in ({"digest": str, "cutoff": float} | kinds).items()}
        passes = Passes(**read, learned=Learned(**learned) if learned else None, written=written)
    except (OSError, ValueError, KeyError, TypeError, EOFError) as error:
        raise ResultError(f"{file}: is damaged: use a new folder with --passes") from error
    if passes.digest != none.digest:
        raise ParameterError("--passes", repr(str(folder)), "a new folder: this one holds passes of another program, or of other options")
    return passes
