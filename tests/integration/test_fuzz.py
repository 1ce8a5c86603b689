"""The fuzz sees wrong answers, hangs, crashes and lost memory: each planted fault is found, and nothing is found without one."""

import random
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from typed_commands import POSIX

from contourlab.loop import batch
from contourlab.loop.feeding import Feed
from contourlab.loop.simulate import ToolPosition
from contourlab.program import reader, state
from contourlab.scenario import tables

TOOL = Path(__file__).parents[2] / "tools" / "fuzz"
sys.path.insert(0, str(TOOL))
import relations  # noqa: E402

Patch = pytest.MonkeyPatch
INPUTS = 4


def found(name: str, folder: Path) -> Iterator[str]:
    """Yield the faults that a relation finds in a few inputs."""
    faults = (relations.related(random.Random(f"{name} {i}"), name).fault(folder / f"{name} {i}") for i in range(INPUTS))
    return (fault for fault in faults if fault)


def wrong_inch(patch: Patch) -> None:
    """An inch of 25.39 mm."""
    patch.setattr(state.ModalState, "length", lambda self, value: value / 1000.0 if self.millimetres else value * 0.02539)


def lost_block(patch: Patch) -> None:
    """The reader skips the fifth block of a program."""
    given, seen = reader.execute, list[Any]()

    def execute(block: Any, state: Any, *rest: Any) -> Any:
        seen.append(id(state))
        return [] if seen.count(id(state)) == 5 else given(block, state, *rest)

    patch.setattr(reader, "execute", execute)


def stretched_axis(patch: Patch) -> None:
    """The first axis goes 10 um/m too far."""
    given = ToolPosition.of

    def of(self: Any, *signals: Any) -> Any:
        position = given(self, *signals).copy()
        position[:, 0] *= 1.0 + 1e-5
        return position

    patch.setattr(ToolPosition, "of", of)


def rounded_file(patch: Patch) -> None:
    """A scenario is written with four digits."""
    given = tables.quantity
    patch.setattr(tables, "quantity", lambda value, unit, shown="": given(float(f"{value:.4g}"), unit, shown))


def late_block(patch: Patch) -> None:
    """The reference of a later block begins a sample early."""
    given = Feed.block
    patch.setattr(Feed, "block", lambda self, start, stop: given(self, max(start - 1, 0), stop - min(start, 1)))


def other_mean(patch: Patch) -> None:
    """Lanes count a sample too few."""
    given = batch.error_figures

    def error_figures(sums: Any, *rest: Any) -> Any:
        return {name: value * (1.0 + 1e-4 * name.endswith("mean")) for name, value in given(sums, *rest).items()}

    patch.setattr(batch, "error_figures", error_figures)


def smooth(name: str, folder: Path) -> Iterator[str]:
    """Yield what lanes against single runs show on smooth contours."""
    scenes = (relations.related(random.Random(f"smooth {i}"), "lanes") for i in range(3 * INPUTS))
    faults = (one.fault(folder / f"smooth {i}") for i, one in enumerate(scenes) if "points.csv" in one.one.files)
    return (fault for fault in faults if fault)


PLANTED: dict[str, tuple[str, Callable[[Patch], None], Callable[[str, Path], Iterator[str]]]] = {
    "inch": ("inch", wrong_inch, found),
    "block": ("split line", lost_block, found),
    "axis": ("placed", stretched_axis, found),
    "place": ("contour", stretched_axis, found),
    "file": ("saved", rounded_file, found),
    "sample": ("blocks", late_block, found),
    "lanes": ("lanes", other_mean, smooth),
}
QUICK = "block"


@pytest.mark.parametrize("planted", [pytest.param(name, marks=[pytest.mark.slow] * (name != QUICK)) for name in PLANTED])
def test_a_planted_fault_is_found(planted: str, tmp_path: Path, monkeypatch: Patch) -> None:
    name, plant, look = PLANTED[planted]
    assert list(look(name, tmp_path / "sound")) == []
    plant(monkeypatch)
    assert any(look(name, tmp_path / "planted"))


@POSIX
@pytest.mark.parametrize(
    ("attempt", "fault"),
    [
        ("lambda number, folder: ''", ""),
        ("lambda number, folder: folder.name", "7"),
        ("lambda number, folder: 1 / 0", "ZeroDivisionError"),
        ("lambda number, folder: time.sleep(60)", "more than 0.5 s"),
        ("lambda number, folder: subprocess.run(['sleep', '60'])", "more than 0.5 s"),
        ("lambda number, folder: os.abort()", "ended with status"),
        ("lambda number, folder: (b'x' * (100 << 20))[:0].decode()", "MB"),
        ("lambda number, folder: str(len(bytearray(1 << 32)))", "MemoryError"),
    ],
)
def test_each_input_has_limits_of_its_own(attempt: str, fault: str) -> None:
    script = f"""
import os, subprocess, time, pool
pool.SECONDS, pool.BYTES = 0.5, 1 << 26
made = pool.Pool(5.0)
made.hire(range(7, 8), {attempt})
print([(found.number, found.fault) for found in made.results()])
"""
    done = subprocess.run([sys.executable, "-c", script], cwd=TOOL, capture_output=True, encoding="utf-8", timeout=60)
    assert done.returncode == 0, done.stderr
    [(number, said)] = eval(done.stdout)
    assert number == 7
    assert fault in said if fault else said == ""
