"""Checkpoints: pieces are reused, damaged ones are not, and those of another study are left alone."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from contourlab.study.checkpoint import Checkpoint, resumable, said_if_interrupted


def test_a_piece_is_read_back_bit_by_bit(tmp_path: Path) -> None:
    first = Checkpoint(tmp_path, "one")
    values = np.random.default_rng(0).standard_normal(5)
    assert first.load(first.path(b"a")) is None and first.findings("runs") == ()
    first.store(first.path(b"a"), {"values": values, "names": ["x", "y"]})
    again = Checkpoint(tmp_path, "one")
    arrays = again.load(again.path(b"a"))
    assert arrays is not None and arrays["values"].tobytes() == values.tobytes() and arrays["names"].tolist() == ["x", "y"]
    assert [(one.code, one.values["count"]) for one in again.findings("runs")] == [("CL900", 1)]
    assert again.load(again.path(b"b")) is None


def test_pieces_of_another_study_are_left_alone_and_damaged_ones_not_used(tmp_path: Path) -> None:
    first, other = Checkpoint(tmp_path, "one"), Checkpoint(tmp_path, "two")
    path = first.path(b"a")
    file = first.store(path, {"values": [1.0]})
    assert other.load(other.path(b"a")) is None and [one.code for one in other.findings("runs")] == ["CL901"]
    file.write_bytes(file.read_bytes()[:-40])
    assert first.load(path) is None
    assert [(one.code, one.values["count"]) for one in first.findings("runs")] == [("CL902", 1)]


def test_an_interrupt_promises_to_continue_only_if_there_is_something_to_continue(tmp_path: Path) -> None:
    for notes in (0, 1):
        with pytest.raises(KeyboardInterrupt) as stop, resumable(tmp_path, "runs"):
            raise KeyboardInterrupt
        assert len(getattr(stop.value, "__notes__", ())) == notes
        checkpoint = Checkpoint(tmp_path, "one")
        checkpoint.store(checkpoint.path(b"a"), {"values": [1.0]})


@pytest.mark.parametrize(("results", "notes"), [("one scheme", 1), ("", 0)])
def test_an_interrupt_says_what_was_finished(results: str, notes: int) -> None:
    with pytest.raises(KeyboardInterrupt) as stop, said_if_interrupted(lambda: results):
        raise KeyboardInterrupt
    found = getattr(stop.value, "__notes__", [])
    assert len(found) == notes and all(results in note for note in found)
