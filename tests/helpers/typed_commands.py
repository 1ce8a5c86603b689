"""The command as a user types it, and the files that the tests give it."""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
import subprocess
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from contourlab.cli.main import main
from contourlab.components import registry
from contourlab.scenario import load

COMMAND = Path(sys.executable).with_name("contourlab" + (".exe" if os.name == "nt" else ""))

CIRCLE = """\
name = "circle"
machine = "builtin:ghaffari/a3a1"
controller = "builtin:ghaffari/calibrated"
[contour]
name = "circle"
radius = "20 mm"
[feed]
law = "uniform"
frequency = "0.5 Hz"
laps = 2
[run]
tolerance = "16 um"
"""
SCHEMES = """
[schemes."position loop"]
controller.axes."*".observer = "none"
controller.estimator = "none"
controller.coupling = "none"
[schemes."all of it"]
"""
PART = """\
%
(A line and half a circle)
G17 G21 G90 G94
G0 X0 Y0 Z0
G1 X5 F1000
G3 X5 Y10 I0 J5
M30
%
"""
DRAG = """from contourlab.components.contract import Component, param

class Drag(Component):
    'Drag.'
    family, kind, law = 'friction', 'open-drag', 'smooth'
    example = {'coefficient': 40.0}
    reference = 'none'
    coefficient: float = param(unit='{force}*s/m', minimum=0.0, doc='c')

    @staticmethod
    def force(par, v):
        return par.coefficient * v
"""
POSIX = pytest.mark.skipif(os.name == "nt", reason="signals, pipes and limits of a POSIX system")
ON_XYZ = ("--machine", "xyz", "--controller", "xyz-controller")


@dataclass(frozen=True)
class Said:
    """The outcome of a command: its exit code and both streams."""

    code: int
    out: str
    err: str

    @property
    def answer(self) -> str:
        """What a command prints that has no fault."""
        assert (self.code, self.err) == (0, ""), self
        return self.out

    @property
    def refusal(self) -> str:
        """What a command says that is refused."""
        assert (self.code, self.out) == (2, ""), self
        return self.err


Run = Callable[..., Said]
AsJson = Callable[..., Any]
Refused = Callable[..., str]


def environment(changes: Mapping[str, str] | None = None) -> dict[str, str]:
    """Return the user's environment without the variables that change the output; the cache of compiled code stays."""
    dropped = {"NO_COLOR", "FORCE_COLOR", "COLUMNS", "LINES", "CONTOURLAB_JIT"}
    return {**{name: value for name, value in os.environ.items() if name not in dropped}, **(changes or {})}


def invoke(
    folder: Path, *words: str | Path, typed: str = "", env: Mapping[str, str] | None = None, before: Callable[[], None] | None = None
) -> Said:
    """Run the command in a folder, as typed; standard input, output and error are pipes.

    It runs in this process, which saves two seconds of imports, unless the test changes the environment or limits the process.
    """
    if env is not None or before is not None:
        return _in_its_own_process(folder, words, typed, env, before)
    streams = io.TextIOWrapper(io.BytesIO(typed.encode())), io.StringIO(), io.StringIO()
    was = sys.stdin, sys.stdout, sys.stderr, dict(os.environ), dict(registry._plugins), set(load._loaded)
    chosen = environment()
    try:
        sys.stdin, sys.stdout, sys.stderr = streams
        os.environ.clear()
        os.environ.update(chosen)
        with contextlib.chdir(folder):
            code = main([str(word) for word in words])
    finally:
        sys.stdin, sys.stdout, sys.stderr = was[:3]
        os.environ.clear()
        os.environ.update(was[3])
        # Drop the plugins of this test.
        for mine, theirs in ((registry._plugins, was[4]), (load._loaded, was[5])):
            mine.clear()
            mine.update(theirs)  # type: ignore[arg-type]
    return Said(code, streams[1].getvalue(), streams[2].getvalue())


def _in_its_own_process(
    folder: Path, words: Sequence[str | Path], typed: str, env: Mapping[str, str] | None, before: Callable[[], None] | None
) -> Said:
    done = subprocess.run(
        [str(COMMAND), *map(str, words)],
        cwd=folder,
        input=typed,
        capture_output=True,
        encoding="utf-8",
        env=environment(env),
        preexec_fn=before,
        timeout=300,
    )
    return Said(done.returncode, done.stdout, done.stderr)


def drag(kind: str, factor: float = 1.0) -> str:
    """Return the text of a friction plugin: `factor` times its coefficient times the speed."""
    return f'''
from contourlab.components.contract import Component, param


class Drag(Component):
    family = "friction"
    kind = "{kind}"
    law = "smooth"
    example = {{"coefficient": 1.0}}
    reference = "F = c v"
    coefficient: float = param(unit="{{force}}*s/m", minimum=0.0, doc="force at unit speed")

    @staticmethod
    def force(par, v):
        return {factor} * par.coefficient * v
'''


def write(folder: Path, text: str, name: str = "part.ngc") -> str:
    """Write a file, by default a part program; return its name."""
    (folder / name).write_text(text, encoding="utf-8")
    return name


def contents(folder: Path) -> dict[str, str]:
    """Return a hash of every file in a folder, hidden ones too."""
    files = [path for path in sorted(folder.rglob("*")) if path.is_file()]
    return {path.relative_to(folder).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest() for path in files}


@dataclass(frozen=True)
class Finished:
    """A finished run: its folder of results and its output."""

    folder: Path
    said: Said
