"""What is said of pieces of a study that were kept from an earlier time."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from contourlab.studies.space.kept import KeptFolder

__all__ = ["kept_notes"]


def kept_notes(kept: KeptFolder, found: int, pieces: str, decides: str) -> list[str]:
    """Return what was taken from an earlier time, and what was not, in words.

    Parameters
    ----------
    kept : KeptFolder
    found : int
        Pieces that were taken.
    pieces : str
        What they are called: ``"runs"``.
    decides : str
        What those of others may differ in.
    """
    notes = []
    if found:
        notes.append(f"{found} {pieces} were kept from an earlier time in {kept.home} and not made again")
    if kept.others:
        notes.append(
            f"{kept.folder} also keeps {pieces} of another {decides}: they were left alone and not used; the folder may be deleted"
        )
    if kept.damaged:
        notes.append(f"{kept.damaged} files of kept {pieces} could not be read; their {pieces} were made again")
    return notes
