"""The line that a command prints while it works: stage, share and time left."""

from __future__ import annotations

import re
import time

import pytest

from contourlab.rendering import stages
from contourlab.rendering.stages import Stages, heartbeat, shown


def test_the_time_left_follows_from_the_share_that_is_done(monkeypatch: pytest.MonkeyPatch) -> None:
    now = 100.0
    monkeypatch.setattr(stages, "monotonic", lambda: now)
    beat = Stages("tune")
    assert beat.line() == "tune, 0 s"
    beat.advance(1, 100)
    assert beat.line() == "tune, 1 % of this step, 0 s"
    now = 104.0
    beat.begin("searching")
    now = 109.0
    assert beat.line() == "tune: searching, 9 s"
    beat.advance(1, 5)
    assert beat.line() == "tune: searching, 20 % of this step, 20 s left"
    beat.advance(5, 5)
    assert beat.line() == "tune: searching, 9 s"
    beat.expect([("searching", 1.0), ("looking", 1.0), ("writing", 2.0)])
    beat.begin("writing")  # leaves out two stages
    now = 119.0
    assert beat.line() == "tune: writing, 50 %, 10 s left"
    beat.advance(1, 2)
    assert beat.progress()[0] == 0.75
    beat.advance(1, 4)  # of another run beside it
    assert beat.progress()[0] == 0.75


def test_the_share_of_a_command_in_parts_never_shrinks(monkeypatch: pytest.MonkeyPatch) -> None:
    beat, shares = Stages("demo"), []
    for start, stop in ((0.0, 0.2), (0.2, 1.0)):
        beat.take_part(start, stop)
        beat.expect(2)
        for words in ("planning", "simulating"):
            beat.begin(words)
            for done in (1, 4):
                beat.advance(done, 4)
                shares.append(beat.progress()[0])
    assert shares == pytest.approx([0.025, 0.1, 0.125, 0.2, 0.3, 0.6, 0.7, 1.0])


def test_a_working_command_prints_lines_and_a_quick_one_none(monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(stages, "INTERVAL", 0.05)
    with heartbeat("silenced"):
        time.sleep(0.2)
    monkeypatch.delenv("CONTOURLAB_PROGRESS")
    with heartbeat("quick"):
        pass
    assert capfd.readouterr().err == ""
    with heartbeat("slow"), shown(False) as steps:
        steps.begin("waiting")
        steps.advance(1, 2)
        time.sleep(0.2)
    lines = capfd.readouterr().err.splitlines()
    assert lines and all(re.fullmatch(r"slow: waiting, 50 % of this step, \d+ s left", line) for line in lines)
    Stages().advance(1, 2)  # outside a command: nothing to show
    time.sleep(0.1)
    assert capfd.readouterr().err == ""
