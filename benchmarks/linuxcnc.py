"""LinuxCNC's trajectory planner on the programs of the benchmark: the same moves, the same limits, its 1 kHz commands.

**LinuxCNC** is the released program, headless and in simulation; it outputs its position commands at 1 kHz. Properties of version 2.9 that
this benchmark relies on:

- Limits: velocity and acceleration of each axis. `MAX_LINEAR_VELOCITY` also caps the speed along the path (a rapid on a diagonal keeps to
  200 mm/s of path speed, not of each axis), so our rapids get the same cap here. `MAX_LINEAR_ACCELERATION` does not cap the acceleration
  along a diagonal. There is no jerk limit; ours makes a ramp take A / J = 1 ms, one of its servo periods.
- On an arc v^2 / R is at most sqrt(3)/2 of the acceleration, in any direction. Under G64 even a lone circle ramps with half of it.
- G61 stops at corners. It drives through joints that are tangent, or so nearly tangent that the velocity jump is far below what the
  acceleration permits in one period: joints of 0.003 degrees at 100 mm/s, from rounded ends of arcs, do not slow it down.
- G64 P blends corners. P is the distance of the corner itself, so at a right angle no point is further than P / sqrt(2) from the path.
  P alone also merges short lines: P alone, and P with the same Q, gave the same motion; Q0 gave another. Both together may exceed P by a
  quarter.
- Samples have six decimals of a mm, so a second difference is good to 2 mm/s^2, 0.2 % of the limit here. Under G64 the motion may end a
  quarter of a micrometre from the programmed point.
- Start and end: all axes stand still before and after. The cycle time is from the last sample at the start to the first at the end, a
  whole number of ms. It excludes dwells before and after; the programs here have none.
- It runs in real time, plus 2.5 s for start and end. We cut programs to `SECONDS` of our duration; the tool itself stops at 60 s.
- It counts time in servo cycles, so a busy computer does not stretch the figures. Samples carry a counter: a run with a gap, an error, or
  another end than the program's is repeated, twice at most. Two runs at a time are impossible (one shared memory), so a lock orders them.

Our reader reads each program and rewrites it for LinuxCNC, one line per move, with the mode in front. So both plan the same moves, and the
program's own G61 and G64 have no effect. All feed moves get one feedrate, because slow ones would hide the planners.

Deviation: the largest distance of a commanded sample from the programmed path, by exact foot point, with one function for both.
"""

from __future__ import annotations

import dataclasses
import importlib.util
import math
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.errors import ContourlabError, ProgramError
from contourlab.feed import AxisLimits, Route, route_from_program
from contourlab.geometry import Path as Curves
from contourlab.program import Arc, Dwell, Program, Traverse, parse_program
from contourlab.program.moves import PLANE_AXES

HERE = Path(__file__).resolve().parent
SHARED = HERE.parents[1] / "shared"
TOOL = SHARED / "tools" / "planner_oracle.py"
PERIOD = 1e-3
VELOCITY, ACCELERATION, JERK = 0.2, 1.0, 1000.0  # m/s, m/s^2, m/s^3; A / J is one period
FEED = 0.1  # m/s
FASTER = {"circle R20": 0.2}  # m/s, so that only the acceleration matters
END = 1e-6  # m: a run that ends further from the programmed point is not complete
CORPUS = {
    "3D_Chips": "linuxcnc__nc_files_3D_Chips.ngc",
    "3dtest": "linuxcnc__nc_files_3dtest.ngc",
    "arcspiral": "linuxcnc__nc_files_arcspiral.ngc",
    "tort": "linuxcnc__nc_files_tort.ngc",
    "heart": "CAMotics__examples_heart_heart.ngc",
    "vcarve": "CAMotics__examples_vcarve_vcarve.ngc",
    "8x_gear": "grbl__test_gcode_8x_gear_test.nc",
    "HSM": "grbl__test_gcode_HSM_test.nc",
}
OWN_MODE = re.compile(r"\([^)]*\)|G6[14](?:\.1)?(?![0-9])(?:\s*[PQ]\s*[0-9.]+)*|^\s*%\s*$", re.IGNORECASE | re.MULTILINE)


def lines_through(points: Sequence[Sequence[float]]) -> str:
    """Return a program of lines through points [mm]."""
    return "\n".join(["G21 G90 G17 F6000", *(f"G1 X{x:.6f} Y{y:.6f}" for x, y in points), "M2", ""])


def generated() -> dict[str, str]:
    """Return the short programs: a circle, a square, short zigzags, dust along a curve, a star."""
    angle = np.linspace(0.0, 2.0 * math.pi, 601)[1:]
    dust = np.column_stack([20.0 - 20.0 * np.cos(angle), 10.0 * np.sin(angle)])
    star = [(25.0 * math.sin(k * 0.8 * math.pi), 25.0 * math.cos(k * 0.8 * math.pi) - 25.0) for k in range(6)]
    return {
        "circle R20": "G21 G90 G17 F12000\nG2 X0 Y0 I20 J0\nM2\n",
        "square 20": lines_through([(20, 0), (20, 20), (0, 20), (0, 0)]),
        "zigzag 2 mm": lines_through([(1.5 * k, 1.3 * (k % 2)) for k in range(1, 31)]),
        "dust 0.16 mm": lines_through(dust.tolist()),
        "star": lines_through(star[1:]),
    }


def read(text: str, name: str) -> Program:
    """Return a program without its own path modes; an end is added if it has none."""
    bare = OWN_MODE.sub(" ", text)
    try:
        return parse_program(bare, name)
    except ProgramError as error:
        if "no end" not in str(error):
            raise
        return parse_program(bare + "\nM2\n", name)


def programs() -> Iterator[tuple[str, Program | str]]:
    """Yield names and programs, or the reason why one cannot be read."""
    for name, text in generated().items():
        yield name, read(text, name)
    for name, file in CORPUS.items():
        path = SHARED / "gcode" / file
        if not path.is_file():
            yield name, "file not found"
            continue
        try:
            yield name, read(path.read_text(encoding="latin-1"), name)
        except ContourlabError as error:
            yield name, str(error)


def rewritten(program: Program, mode: str) -> str:
    """Return a program for LinuxCNC: the mode, then one line for each move, at one feedrate."""

    def at(letters: str, values: Sequence[float]) -> str:
        return " ".join(f"{letter}{1e3 * value:.9f}" for letter, value in zip(letters, values, strict=True))

    lines = ["G21 G90 G94 G91.1 G17", mode]
    for move in program.moves:
        if isinstance(move, Dwell):
            lines.append(f"G4 P{move.seconds:.6f}")
        elif isinstance(move, Traverse):
            lines.append(f"G0 {at('XYZ', move.end)}")
        else:
            speed = f"F{6e4 * feed_of(program):.6f}"
            if isinstance(move, Arc):
                i, j, _ = PLANE_AXES[move.plane]
                offset = at("IJK"[i] + "IJK"[j], [move.centre[i] - move.start[i], move.centre[j] - move.start[j]])
                plane = {"XY": "G17", "ZX": "G18", "YZ": "G19"}[move.plane]
                lines.append(f"{plane} G{2 if move.turns < 0 else 3} {at('XYZ', move.end)} {offset} P{abs(move.turns)} {speed}")
            else:
                lines.append(f"G1 {at('XYZ', move.end)} {speed}")
    return "\n".join([*lines, "M2", ""])


def limits(velocity: float = VELOCITY, acceleration: float = ACCELERATION, jerk: float = JERK) -> AxisLimits:
    """Return the same limits for three axes."""
    return AxisLimits([velocity] * 3, acceleration, jerk)


def feed_of(program: Program) -> float:
    """Return the one feedrate of a program [m/s]."""
    return FASTER.get(program.name, FEED)


def driven(program: Program) -> Route:
    """Return the route of a program at one feedrate, with path speed capped as in LinuxCNC."""
    route = route_from_program(program)
    return dataclasses.replace(route, feedrate=np.where(route.rapid, VELOCITY, feed_of(program)))


class OracleError(Exception):
    """LinuxCNC gave no complete run; the message says why."""


def why_no_linuxcnc() -> str:
    """Return what is missing to run LinuxCNC; empty if nothing is."""
    if shutil.which("linuxcnc") is None:
        return "LinuxCNC is not installed (apt-get install --no-install-recommends linuxcnc-uspace)"
    return "" if TOOL.is_file() else "the shared oracle tools are not next to the repository"


def _oracle() -> Any:
    spec = importlib.util.spec_from_file_location("planner_oracle", TOOL)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def their_samples(text: str, end: Sequence[float], *, velocity: float = VELOCITY, acceleration: float = ACCELERATION) -> np.ndarray:
    """Return LinuxCNC's commanded positions (n, 3) [m], 1 ms apart, from the last at rest to the first at rest.

    Raises `OracleError` if three runs all had gaps, errors, or another end than `end` [m].
    """
    import fcntl  # missing on Windows, as is LinuxCNC

    tool, reason = _oracle(), ""
    with tempfile.TemporaryDirectory() as folder, (Path(tempfile.gettempdir()) / "contourlab-linuxcnc.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        file = Path(folder) / "program.ngc"
        file.write_text(text, encoding="ascii")
        Path(folder).chmod(0o755)
        for _ in range(3):
            try:
                # The sampler writes a text line about an overrun, which loadtxt refuses.
                rows = tool.samples(str(file), 1e3 * velocity, 1e3 * acceleration)
            except (RuntimeError, ValueError, OSError, subprocess.TimeoutExpired) as error:
                reason = f"{type(error).__name__}: {error}"
                continue
            moving = np.flatnonzero(np.any(np.diff(rows[:, 1:4], axis=0) != 0.0, axis=1)) if len(rows) > 1 else np.zeros(0, int)
            if not moving.size:
                reason = "nothing moved"
            elif np.any(np.diff(rows[:, 0]) != 1):
                reason = "samples are missing"
            elif np.abs(1e-3 * rows[-1, 1:4] - end).max() > END:
                reason = f"it ended at {rows[-1, 1:4].tolist()} mm"
            else:
                return np.asarray(1e-3 * rows[moving[0] : moving[-1] + 2, 1:4])
    raise OracleError(reason)


def deviation(points: np.ndarray, path: Curves, window: float = 2e-3, block: int = 32) -> float:
    """Return the largest distance of points (n, n_axis) in the order of travel from a path [m].

    Foot points give the progress from block to block, because a polygon that cuts corners is shorter than the path.
    """
    worst = progress = 0.0
    before = points[:1]
    for start in range(0, len(points), block):
        part = points[start : start + block]
        gone = np.cumsum(np.linalg.norm(np.diff(np.concatenate([before, part]), axis=0), axis=1))
        foot = path.foot_point(part, np.minimum(progress + gone, path.length), window)
        worst, progress, before = max(worst, float(foot.distance.max())), float(foot.arc_length[-1]), part[-1:]
    return worst


def worst_rates(points: np.ndarray) -> dict[str, float]:
    """Return the worst velocity and acceleration of any axis as parts of the limits."""
    velocity = np.diff(points, axis=0) / PERIOD
    acceleration = np.diff(velocity, axis=0) / PERIOD
    return {"velocity": float(np.abs(velocity).max() / VELOCITY), "acceleration": float(np.abs(acceleration).max() / ACCELERATION)}
