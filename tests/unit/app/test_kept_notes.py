"""What is said of pieces that were kept."""

from __future__ import annotations

from pathlib import Path

from contourlab.app.checkpoint import KeptFolder
from contourlab.app.kept_notes import kept_notes


def test_one_piece_is_said_as_one_and_none_not_at_all(tmp_path: Path) -> None:
    kept = KeptFolder(tmp_path, "model")
    said = [" ".join(kept_notes(kept, found, "searches", "search", "seed")) for found in (0, 1, 2)]
    assert said[0] == "" and "1 search was kept" in said[1] and "2 searches were kept" in said[2]
    kept.damaged = 1
    assert kept_notes(kept, 0, "searches", "search", "seed") == ["1 file of kept searches could not be read: its searches were made again"]
