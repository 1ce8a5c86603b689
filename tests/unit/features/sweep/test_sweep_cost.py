"""What a study tells of its cost before it begins, and when it asks."""

from __future__ import annotations

import io
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from made_studies import STUDY, made_study

from contourlab.cli.main import main
from contourlab.features.sweep import chunk as cost
from contourlab.features.sweep import command
from contourlab.features.sweep.chunk import cost_of
from contourlab.features.sweep.study import Study, load_study
from contourlab.study.executors import Executor

TWO = Executor("threads", 2)


@pytest.fixture
def study(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return made_study(tmp_path)


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[tuple[int, int]]:
    """A processor that needs 20 ms for a batch and 1 ms for each variant and thread; returns what ran."""
    now, ran = [0.0], list[tuple[int, int]]()

    def run(study: Study, numbers: list[int], threads: int, progress: Callable[[float], None], *, gpu: bool) -> None:
        n = len(study.design.places(numbers[0]))
        ran.append((n, threads))
        for share in (0.25, 0.5, 0.75, 1.0):
            now[0] += (0.02 + 1e-3 * n / threads) / 4.0
            progress(share)

    monkeypatch.setattr(cost, "run_chunks", run)
    monkeypatch.setattr(cost, "perf_counter", lambda: now[0])
    return ran


def test_the_time_is_measured_on_a_few_variants(study: Path, clock: list[tuple[int, int]]) -> None:
    large = load_study(made_study(study.parent, STUDY.replace("variants = 100", "variants = 100000").replace("chunk = 32\n", "")))
    assert large.design.chunks == 49
    found = cost_of(large, range(49), (), TWO, None)
    assert clock[-1][1] == 2 and clock[-1][0] <= 2048 and sum(n for n, _ in clock) < 5000
    assert found.variants == 100_000 and found.seconds == pytest.approx(50.0, rel=0.1)
    part = cost_of(large, range(10, 49), (0, 10, 48), TWO, None)
    assert part.variants == 100_000 - 10 * 2048 - 2048 - (100_000 - 48 * 2048)
    assert part.seconds == pytest.approx(found.seconds * part.variants / 1e5)
    # Longer work is cut off after a fraction of a second.
    slow = replace(large, design=replace(large.design, chunk=1 << 16))
    before = len(clock)
    cost_of(slow, range(2), (), Executor("threads", 1), None)
    assert max(n for n, _ in clock[before:]) <= 512


@pytest.mark.parametrize(("in_doubt", "each"), [(False, 0.3 / 65536), (True, 1e-3)])
def test_variants_left_to_the_processor_count(study: Path, monkeypatch: pytest.MonkeyPatch, in_doubt: bool, each: float) -> None:
    now = [0.0]

    def run(study: Study, numbers: list[int], threads: int, progress: Callable[[float], None], *, gpu: bool) -> None:
        now[0] += 0.3
        progress(1.0)
        for share in np.linspace(0.0, 1.0, 4097) if in_doubt else ():
            now[0] += 1e-3 * len(study.design.places(numbers[0])) / 4097
            progress(share)

    monkeypatch.setattr(cost, "run_chunks", run)
    monkeypatch.setattr(cost, "perf_counter", lambda: now[0])
    many = load_study(made_study(study.parent, STUDY.replace("variants = 100", "variants = 100000").replace("chunk = 32\n", "")))
    assert cost_of(many, range(49), (), Executor("gpu"), None).seconds == pytest.approx(1e5 * each, rel=0.02)
    assert now[0] < 10.0


def test_motions_count_by_their_length_and_the_disk_by_its_columns(study: Path, clock: list[tuple[int, int]]) -> None:
    both = STUDY + '"feed.frequency" = { values = ["0.5 Hz", "0.25 Hz"] }\n'
    one, two = (load_study(made_study(study.parent, text)) for text in (STUDY, both))
    plain, mixed = (cost_of(made, range(4), (), TWO, None) for made in (one, two))
    assert mixed.seconds == pytest.approx(0.75 * plain.seconds)  # the clock gives each variant of the longest motion 1 ms
    assert (plain.disk, mixed.disk) == (100 * 8 * 9, 100 * 8 * 10)
    kept = load_study(made_study(study.parent, 'signals = ["position"]\n' + STUDY))
    assert cost_of(kept, range(4), (), TWO, None).disk == 100 * 8 * (9 + 2000 * 2)


@pytest.mark.slow
def test_the_disk_is_what_a_store_takes(study: Path) -> None:
    study.write_text(STUDY.replace("variants = 100", "variants = 2048").replace("chunk = 32\n", ""))
    assert main(["sweep", "study.toml", "--out", "store"]) == 0
    taken = sum(file.stat().st_size for file in Path("store").glob("part-*"))
    assert taken == pytest.approx(cost_of(load_study(study), range(1), (), TWO, None).disk, rel=0.25)


@pytest.fixture
def long(study: Path, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """A study of more than an hour that ends as soon as it begins; returns what begins."""
    study.write_text(STUDY.replace("variants = 100\nchunk = 32", "variants = 1000000000"))
    begun: list[str] = []

    def begin(*_: Any, **__: Any) -> None:
        begun.append("begun")
        raise KeyboardInterrupt

    monkeypatch.setattr(command, "run_chunks", begin)
    monkeypatch.setattr(cost, "_seconds_each", lambda *_: 1e-4)
    return begun


def test_a_long_study_begins_with_yes_or_resume_alone(long: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    for words in ([], ["--chunks", "0:100000"], ["--json"]):
        assert main(["sweep", "study.toml", "--out", "store", *words]) == 2
        assert "--yes" in capsys.readouterr().err and not Path("store").exists() and not long
    assert main(["sweep", "study.toml", "--out", "store", "--yes"]) == 130
    assert main(["sweep", "study.toml", "--out", "store", "--resume"]) == 130
    assert main(["sweep", "study.toml", "--out", "few", "--chunks", "0:2"]) == 130
    assert len(long) == 3


def test_much_disk_is_asked_for_too(long: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cost, "_seconds_each", lambda *_: 0.0)
    for variants, code in ((10**8, 130), (10**9, 2)):  # 72 B each
        Path("study.toml").write_text(STUDY.replace("variants = 100\nchunk = 32", f"variants = {variants}"))
        assert main(["sweep", "study.toml", "--out", f"store-{variants}"]) == code


@pytest.mark.parametrize(("typed", "code"), [("y\n", 130), ("yes\n", 130), ("n\n", 2), ("\n", 2), ("", 2)])
def test_at_a_terminal_it_asks(long: list[str], monkeypatch: pytest.MonkeyPatch, typed: str, code: int) -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    monkeypatch.setattr(sys, "stdin", Terminal(typed))
    monkeypatch.setattr(sys, "stderr", Terminal())
    assert main(["sweep", "study.toml", "--out", "store"]) == code
    assert bool(long) == (code == 130)
