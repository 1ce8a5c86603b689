"""What a long study keeps on disk, so that it goes on where it was interrupted: files of arrays under all that decides them."""

from __future__ import annotations

import hashlib
import io
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from contourlab.result.atomic import write_bytes_atomic

Found = TypeVar("Found")


@dataclass(eq=False)
class KeptFolder:
    """Files of arrays in a folder, those of one model in a folder of their own.

    Parameters
    ----------
    folder : Path
        Made when the first file is kept.
    model : str
        All that decides what is kept, but what its files are named by.
    damaged : int
        Files that could not be read; what was in them is made again.
    """

    folder: Path
    model: str
    damaged: int = field(default=0, init=False)

    @property
    def home(self) -> Path:
        """Folder of the files of this model."""
        return self.folder / hashlib.sha256(self.model.encode()).hexdigest()[:16]

    @property
    def others(self) -> int:
        """How many other models have files beside this one's."""
        return sum(path != self.home and path.is_dir() for path in self.folder.glob("?" * 16))

    def named(self, *parts: bytes) -> Path:
        """Return the file of a piece: the name is a digest of the model and of what decides the piece."""
        text = hashlib.sha256(self.model.encode())
        for part in parts:
            text.update(part)
        return self.home / f"{text.hexdigest()[:32]}.npz"

    def load(self, file: Path, take: Callable[[Mapping[str, Any]], Found]) -> Found | None:
        """Return what `take` makes of the arrays of a file; None where there is none, or it is damaged, or `take` finds fault with it."""
        if not file.exists():
            return None
        try:
            with np.load(io.BytesIO(file.read_bytes()), allow_pickle=False) as data:  # a zip: damage fails its checksum
                return take(data)
        except Exception:  # zipfile, zlib, NumPy and the system each have errors of their own for a damaged file
            self.damaged += 1
            return None

    def store(self, file: Path, arrays: Mapping[str, ArrayLike]) -> Path:
        """Keep arrays in a file, whole or not at all; return it."""
        buffer = io.BytesIO()
        np.savez(buffer, allow_pickle=False, **{name: np.asarray(values) for name, values in arrays.items()})
        write_bytes_atomic(file, buffer.getvalue())
        return file
