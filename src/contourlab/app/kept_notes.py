"""What is said of pieces of a study that were kept from an earlier time."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from contourlab.app.checkpoint import KeptFolder


def kept_notes(kept: KeptFolder, found: int, pieces: str, piece: str, decides: str) -> list[str]:
    """Return what was taken from an earlier time, and what was not, in words.

    Parameters
    ----------
    kept : KeptFolder
    found : int
        Pieces that were taken.
    pieces : str
        What many of them are called: ``"runs"``.
    piece : str
        What one is called.
    decides : str
        What those of others may differ in.
    """
    notes = []
    if found:
        kept_ones = f"{found} {pieces} were" if found > 1 else f"1 {piece} was"
        notes.append(f"{kept_ones} kept from an earlier time in {kept.home} and not made again")
    if kept.others:
        notes.append(
            f"{kept.folder} also keeps {pieces} of another {decides}: they were left alone and not used; the folder may be deleted"
        )
    if kept.damaged:
        files, its = (f"{kept.damaged} files", "their") if kept.damaged > 1 else ("1 file", "its")
        notes.append(f"{files} of kept {pieces} could not be read: {its} {pieces} were made again")
    return notes


@contextmanager
def taken_up_again(folder: Path, pieces: str) -> Iterator[None]:
    """Say at an interrupt, whenever it comes, that the pieces in a folder are kept for the same command to go on from, if there are any."""
    try:
        yield
    except KeyboardInterrupt as stop:
        if any(folder.glob("*/*.npz")):
            stop.add_note(f"The {pieces} that had ended are kept in {folder}: the same command goes on from there.")
        raise
