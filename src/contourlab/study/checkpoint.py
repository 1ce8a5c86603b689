"""Interrupted work: finished pieces stay on disk, and the same command continues; or they are printed."""

from __future__ import annotations

import hashlib
import io
import sys
import zipfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass, field
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.findings import Finding, finding
from contourlab.result.atomic import write_bytes_atomic
from contourlab.result.digest import DIGEST_SIZE, append_digest, is_intact

if TYPE_CHECKING:
    from contourlab.loop import Controller, Machine
    from contourlab.study.cases import Setting

_ROOMS = ("native", "primitives", "geometry", "feed", "engine", "components", "metrics", "loop")
"""Rooms whose source affects the figures of a run."""


@dataclass(eq=False)
class Checkpoint:
    """Arrays of finished pieces in a folder, one file each, in one sub-folder per study.

    Parameters
    ----------
    folder : Path
        Created with the first piece.
    study : str
        Everything that affects the pieces, except the key of each piece. Pieces of another study are never used.
    reused, damaged : int
        Number of pieces read from disk, and of damaged files, whose pieces are computed again.
    """

    folder: Path
    study: str
    reused: int = field(default=0, init=False)
    damaged: int = field(default=0, init=False)

    @property
    def home(self) -> Path:
        """The sub-folder of this study."""
        return self.folder / hashlib.sha256(self.study.encode()).hexdigest()[:16]

    @property
    def others(self) -> int:
        """Number of other studies with pieces in the folder."""
        return sum(path != self.home and path.is_dir() for path in self.folder.glob("?" * 16))

    def path(self, *key: bytes) -> Path:
        """Return the file of a piece, named by a digest of the study and of the key of the piece."""
        digest = hashlib.sha256(self.study.encode())
        for part in key:
            digest.update(part)
        return self.home / f"{digest.hexdigest()[:32]}.npz"

    def load(self, file: Path) -> dict[str, NDArray[Any]] | None:
        """Return the arrays of a piece; None if there is no file, or it is damaged or another piece."""
        if not file.exists():
            return None
        try:
            stream = io.BytesIO(file.read_bytes())
        except OSError:
            stream = io.BytesIO()
        # From a damaged file NumPy may return wrong values: it does not check all that it reads.
        try:
            if not is_intact(stream, file.name.encode()):
                raise ValueError
            with np.load(io.BytesIO(stream.getvalue()[:-DIGEST_SIZE]), allow_pickle=False) as data:
                arrays = dict(data)
        except (ValueError, OSError, EOFError, zipfile.BadZipFile):  # the last ones: not written by us, with a digest nonetheless
            self.damaged += 1
            return None
        self.reused += 1
        return arrays

    def store(self, file: Path, arrays: Mapping[str, ArrayLike]) -> None:
        """Write the arrays of a piece, completely or not at all, and a digest of them and of the name of the file."""
        buffer = io.BytesIO()
        np.savez(buffer, allow_pickle=False, **{name: np.asarray(values) for name, values in arrays.items()})
        append_digest(buffer, file.name.encode())
        write_bytes_atomic(file, buffer.getvalue())

    def findings(self, pieces: str, reused: int | None = None) -> tuple[Finding, ...]:
        """Return the findings on reused, damaged and other studies' pieces; `reused` replaces the number of files read."""
        count = self.reused if reused is None else reused
        found = [finding("CL900", pieces=pieces, count=count, folder=str(self.home))] if count else []
        found += [finding("CL901", pieces=pieces, folder=str(self.folder))] if self.others else []
        found += [finding("CL902", pieces=pieces, count=self.damaged)] if self.damaged else []
        return tuple(found)


@contextmanager
def noted(note: Callable[[], str]) -> Iterator[None]:
    """If the block is interrupted, add a note, if there is one, to the interrupt."""
    try:
        yield
    except KeyboardInterrupt as stop:
        if text := note():
            stop.add_note(text)
        raise


def said_if_interrupted(results: Callable[[], str]) -> AbstractContextManager[None]:
    """If the block is interrupted, add the text of the results so far, if any, to the interrupt."""
    return noted(lambda: f"Finished before; no file is written:\n\n{text}" if (text := results()) else "")


def resumable(folder: Path, pieces: str) -> AbstractContextManager[None]:
    """If the block is interrupted and `folder` has pieces, add a note to the interrupt: the same command continues."""
    kept = f"The finished {pieces} are kept in {folder}. Run the same command again to continue."
    return noted(lambda: kept if any(folder.glob("*/*.npz")) else "")


def run_identity(settings: Sequence[Setting], rooms: Iterable[str] = ()) -> str:
    """Return as text everything that affects runs, except the parameters that a study varies.

    This includes machines, controller, motion, noise, plugins, and the version and source of the program.

    Parameters
    ----------
    settings : sequence of Setting
        They differ in their machines only.
    rooms : iterable of str
        Further rooms of the program that affect the result, such as ``"features/swap"``.
    """
    from contourlab.scenario.dump import dump

    first, machines = settings[0], [setting.machine for setting in settings]
    texts = [dump(machine) for machine in machines]
    texts += [dump(first.controller, first.machine), first.reference.digest, f"seed {first.seed}, moving {first.moving}"]
    return "\n".join([*texts, *_plugins(machines, first.controller), *program_identity(tuple(rooms))])


def _plugins(machines: Iterable[Machine], controller: Controller) -> list[str]:
    """Return name and digest of the file of each plugin component in use; files that it imports are ignored."""
    from contourlab.loop.machine import AXIS_SLOTS

    parts = [getattr(axis, slot) for machine in machines for axis in machine.axes for slot in AXIS_SLOTS]
    for axis in controller.axes.values():
        parts += axis.parts.values()
        parts += [] if axis.link is None else [axis.link.down, axis.link.up]
    parts += [controller.estimator, controller.coupling]
    modules = {type(part).__module__ for part in parts if part is not None}
    files = [sys.modules[name].__file__ for name in sorted(modules) if name.partition(".")[0] != "contourlab"]
    return [f"{Path(file).name} {hashlib.sha256(Path(file).read_bytes()).hexdigest()}" for file in files if file is not None]


def program_text(*rooms: str) -> str:
    """Return `program_identity` and the version of scipy as one line."""
    return "; ".join([*program_identity(rooms), f"scipy {version('scipy')}"])


@cache
def program_identity(rooms: tuple[str, ...]) -> list[str]:
    """Return the versions of contourlab, cma and numpy, and a digest of the source of a run's rooms and of further ones."""
    import contourlab

    root, digest = Path(contourlab.__file__).parent, hashlib.sha256()
    for room in (*_ROOMS, *rooms):
        single = root / f"{room}.py"
        for file in [single] if single.exists() else sorted((root / room).rglob("*.py")):
            digest.update(file.relative_to(root).as_posix().encode() + b"\0" + file.read_bytes())
    return [f"contourlab {contourlab.__version__} {digest.hexdigest()}", *(f"{name} {version(name)}" for name in ("cma", "numpy"))]
