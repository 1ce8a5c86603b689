"""The planner beside two others: LinuxCNC's trajectory planner, and toppra's time-optimal bound.

    python benchmarks/planning.py [--quick] [--json FILE] [--only WORD]

**LinuxCNC** runs headless, the released program in simulation, and hands out its 1 kHz position commands. What was found out about it
(2.9, parts that this benchmark relies on):

- Limits: velocity and acceleration of each axis. `MAX_LINEAR_VELOCITY` caps the speed along the path too (a rapid on a diagonal keeps to
  200 mm/s of path speed, not of each axis), so our rapids get the same cap here. `MAX_LINEAR_ACCELERATION` does not cap the acceleration
  along a diagonal. There is no jerk limit; ours is set so that a ramp takes A / J = 1 ms, one of its servo periods.
- On an arc v^2 / R is at most sqrt(3)/2 of the acceleration, whatever the direction. Under G64 even a lone circle ramps with half of it.
- G61 stops at corners and drives through joints that are tangent, or so nearly that the jump of velocity is far below what the
  acceleration permits in one period: joints of 0.003 degrees at 100 mm/s, left by rounded ends of arcs, do not slow it down.
- G64 P blends corners; P is the distance of the corner itself, so at a right angle no point is further than P / sqrt(2) from the path.
  P alone also merges short lines: P and P with the same Q gave the same motion, Q0 another. Both together may exceed P by a quarter.
- Its samples have six decimals of a mm: a second difference is good to 2 mm/s^2, 0.2 % of the limit here. Under G64 it may end a
  quarter of a micrometre beside the programmed point.
- Start and end: all axes stand still before and after, so the cycle time is from the last sample at the start to the first at the end, a
  whole number of ms. Dwells before and after are not in it, and the programs here have none.
- It runs in real time, after 2.5 s of start and end: programs are cut by our duration to `SECONDS`; the tool itself stops at 60 s.
- Time is counted in servo cycles, so a busy computer does not stretch the figures. Samples carry a counter: a run with a gap, with another
  end than the program's, or with an error is done again, twice at most. Two at a time are impossible (one shared memory): a lock orders
  them.

A program is read by our reader and written anew for LinuxCNC, one line a move, with the mode in front, so that both plan the same moves
and its own G61 and G64 count for nothing. All feed moves get one feedrate, as slow ones would hide the planners.

Deviation: the largest distance of a commanded sample to the programmed path by its exact foot point, the same function for both.

**toppra** gives the least time along a path under limits of velocity and acceleration alone, on a grid; between exact stops, for every
stretch; for single lines the closed form. No planner with a jerk limit reaches it.
"""

from __future__ import annotations

import argparse
import dataclasses
import importlib.util
import json
import logging
import math
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table

import contourlab.feed
from contourlab.errors import ContourlabError, ProgramError
from contourlab.feed import AxisLimits, Reference, Route, limit_report, plan, route_from_path, route_from_program
from contourlab.geometry import Line, contour
from contourlab.geometry import Path as Curves
from contourlab.program import PLANE_AXES, Arc, Dwell, Program, Traverse, parse_program

HERE = Path(__file__).resolve().parent
SHARED = HERE.parents[1] / "shared"
TOOL = SHARED / "tools" / "planner_oracle.py"
PERIOD = 1e-3
VELOCITY, ACCELERATION, JERK = 0.2, 1.0, 1000.0  # m/s, m/s^2, m/s^3; A / J is one period
FEED = 0.1  # m/s
PATIENCE = 30.0  # s: no longer programs in a mode that took more for one
FASTER = {"circle R20": 0.2}  # m/s, where only the acceleration is to count
SECONDS = 8.0  # of a program on LinuxCNC, by our duration under G61
END = 1e-6  # m: a run that ends further from the programmed point is not complete
MODES = {"G61": None, "G64 P0.01": 1e-5, "G64 P0.1": 1e-4}  # tolerance [m]
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


# Programs.


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
    """Return a program without its own path modes; an end is added where it has none."""
    bare = OWN_MODE.sub(" ", text)
    try:
        return parse_program(bare, name)
    except ProgramError as error:
        if "no end" not in str(error):
            raise
        return parse_program(bare + "\nM2\n", name)


def programs() -> Iterator[tuple[str, Program | str]]:
    """Yield names and programs, or why one cannot be read."""
    for name, text in generated().items():
        yield name, read(text, name)
    for name, file in CORPUS.items():
        path = SHARED / "gcode" / file
        if not path.is_file():
            yield name, "not here"
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


# Both planners.


def limits(velocity: float = VELOCITY, acceleration: float = ACCELERATION, jerk: float = JERK) -> AxisLimits:
    """Return the same limits for three axes."""
    return AxisLimits([velocity] * 3, acceleration, jerk)


def feed_of(program: Program) -> float:
    """Return the one feedrate of a program [m/s]."""
    return FASTER.get(program.name, FEED)


def driven(program: Program) -> Route:
    """Return the route of a program at one feedrate, path speed capped as LinuxCNC's is."""
    route = route_from_program(program)
    return dataclasses.replace(route, feedrate=np.where(route.rapid, VELOCITY, feed_of(program)))


def in_mode(route: Route, tolerance: float | None) -> Route | None:
    """Return the route as driven in a mode: G61 for None; otherwise blended, or None where this version does not blend."""
    known = {field.name for field in dataclasses.fields(Route)}
    wanted = {"corner_tolerance": tolerance or 0.0, "merge_tolerance": tolerance or 0.0, "exact_stop": False}
    fields: dict[str, Any] = {name: value for name, value in wanted.items() if name in known}
    if tolerance is None:
        return dataclasses.replace(route, **fields)
    blended: Callable[[Route], Route] | None = getattr(contourlab.feed, "blended", None)
    return blended(dataclasses.replace(route, **fields)) if blended is not None and "corner_tolerance" in fields else None


def shortened(program: Program, seconds: float) -> tuple[Program, int]:
    """Return the program's first moves, as many as we drive in `seconds`, and how many moves it had."""
    moves = program.moves
    reference = plan(driven(program), limits(), PERIOD)
    if reference.duration <= seconds:
        return program, len(moves)
    sample = int(seconds / PERIOD)
    whole = max(int(reference.path.curve_index(reference.block(sample, sample + 1).arc_length)[0]), 1)
    # Dwells and moves of no length make no curve.
    curves = np.cumsum([not isinstance(move, Dwell) and (isinstance(move, Arc) or move.start != move.end) for move in moves])
    return dataclasses.replace(program, moves=moves[: int(np.searchsorted(curves, whole)) + 1]), len(moves)


class OracleError(Exception):
    """LinuxCNC gave no complete run; the message says why."""


def why_no_linuxcnc() -> str:
    """Say what is missing to run LinuxCNC; empty where nothing is."""
    if shutil.which("linuxcnc") is None:
        return "LinuxCNC is not installed (apt-get install --no-install-recommends linuxcnc-uspace)"
    return "" if TOOL.is_file() else "the shared oracle tools are not beside the repository"


def _oracle() -> Any:
    spec = importlib.util.spec_from_file_location("planner_oracle", TOOL)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def their_samples(text: str, end: Sequence[float], *, velocity: float = VELOCITY, acceleration: float = ACCELERATION) -> np.ndarray:
    """Return LinuxCNC's commanded positions (n, 3) [m], 1 ms apart, from the last at rest to the first at rest.

    Raises `OracleError` where three runs all had gaps, errors, or another end than `end` [m].
    """
    import fcntl  # not on Windows, nor is LinuxCNC

    tool, reason = _oracle(), ""
    with tempfile.TemporaryDirectory() as folder, (Path(tempfile.gettempdir()) / "contourlab-linuxcnc.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        file = Path(folder) / "program.ngc"
        file.write_text(text, encoding="ascii")
        Path(folder).chmod(0o755)
        for _ in range(3):
            try:
                # A line of the sampler about an overrun is no row of numbers: loadtxt refuses it.
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

    Their progress is followed from block to block by their feet, as a polygon that cuts corners is shorter than the path.
    """
    worst = progress = 0.0
    before = points[:1]
    for start in range(0, len(points), block):
        part = points[start : start + block]
        gone = np.cumsum(np.linalg.norm(np.diff(np.concatenate([before, part]), axis=0), axis=1))
        foot = path.foot_point(part, np.minimum(progress + gone, path.length), window)
        worst, progress, before = max(worst, float(foot.distance.max())), float(foot.arc_length[-1]), part[-1:]
    return worst


def all_positions(reference: Reference) -> np.ndarray:
    """Return every sample's position."""
    return np.array(reference.block(0, reference.n_sample).position)


def worst_rates(points: np.ndarray) -> dict[str, float]:
    """Return the worst velocity and acceleration of any axis as parts of the limits."""
    velocity = np.diff(points, axis=0) / PERIOD
    acceleration = np.diff(velocity, axis=0) / PERIOD
    return {"velocity": float(np.abs(velocity).max() / VELOCITY), "acceleration": float(np.abs(acceleration).max() / ACCELERATION)}


# What is measured.


def compare(program: Program, mode: str) -> dict[str, Any]:
    """Run one program in one mode on both planners."""
    route = driven(program)
    row: dict[str, Any] = {"mode": mode}
    try:
        if (ours := in_mode(route, MODES[mode])) is not None:
            start = time.process_time()
            reference = plan(ours, limits(), PERIOD)
            positions = all_positions(reference)
            row |= {"seconds": reference.duration, "planning_seconds": time.process_time() - start}
            row |= {"deviation": deviation(positions, route.path), "limits_kept": limit_report(reference, limits()).ok()}
            row |= worst_rates(positions)
    except ContourlabError as error:
        row["error"] = str(error)
    if not why_no_linuxcnc():
        try:
            theirs = their_samples(rewritten(program, mode), route.path.position([route.path.length])[0])
            row |= {"linuxcnc_seconds": (len(theirs) - 1) * PERIOD, "linuxcnc_deviation": deviation(theirs, route.path)}
            row |= {f"linuxcnc_{name}": value for name, value in worst_rates(theirs).items()}
        except OracleError as error:
            row["linuxcnc_error"] = str(error)
    if "seconds" in row and "linuxcnc_seconds" in row:
        row["ratio"] = row["seconds"] / row["linuxcnc_seconds"]
    return row


def against_linuxcnc(seconds: float, only: str) -> list[dict[str, Any]]:
    """Return the rows of all programs and modes."""
    rows: list[dict[str, Any]] = []
    for name, program in programs():
        if only not in name:
            continue
        if isinstance(program, str):
            rows.append({"name": name, "error": program})
            continue
        part, total = shortened(program, seconds)
        for mode in MODES:
            rows.append({"name": name, "moves": len(part.moves), "of": total} | compare(part, mode))
            print(".", end="", file=sys.stderr, flush=True)
    return rows


def line_time(length: float, velocity: float, acceleration: float) -> float:
    """Return the least time of a line from rest to rest."""
    if velocity**2 / acceleration >= length:
        return 2.0 * math.sqrt(length / acceleration)
    return length / velocity + velocity / acceleration


def stretch_time(route: Route, begin: float, end: float, most: AxisLimits, n_grid: int) -> float:
    """Return toppra's time for one stretch from rest to rest; the path speed is an axis of its own, without acceleration limit."""
    import toppra
    from toppra.algorithm import TOPPRA
    from toppra.constraint import JointAccelerationConstraint, JointVelocityConstraintVarying

    class Stretch(toppra.interpolator.AbstractGeometricPath):  # type: ignore[misc]
        dof = route.path.n_axis + 1
        path_interval = np.array([0.0, end - begin])

        def __call__(self, s: Any, order: int = 0) -> np.ndarray:
            where = np.minimum(np.atleast_1d(s) + begin, end - 1e-12)  # the end belongs to the next curve
            extra = (where if order == 0 else np.full(where.size, 1.0 if order == 1 else 0.0))[:, None]
            found = np.hstack([route.path.derivatives(where, max(order, 1))[order], extra])
            return np.asarray(found if np.ndim(s) else found[0])

    def speeds(s: float) -> np.ndarray:
        feed = route.feedrate[route.path.curve_index([min(s + begin, end - 1e-12)])[0]]
        top = np.append(most.velocity, min(feed, 1e3))
        return np.column_stack([-top, top])

    span = np.append(most.acceleration, 1e6)
    breaks = route.path.breaks
    inner = breaks[(breaks > begin + 1e-9) & (breaks < end - 1e-9)] - begin
    grid = np.unique(np.concatenate([np.linspace(0.0, end - begin, n_grid), inner]))
    grid = np.delete(grid, np.flatnonzero(np.diff(grid) < 1e-9) + 1) if np.any(np.diff(grid) < 1e-9) else grid
    grid[-1] = end - begin
    constraints = [JointVelocityConstraintVarying(speeds), JointAccelerationConstraint(np.column_stack([-span, span]))]
    _, speed, _ = TOPPRA(constraints, Stretch(), gridpoints=grid, solver_wrapper="seidel").compute_parameterization(0.0, 0.0)
    if speed is None:
        raise OracleError("toppra found no motion")
    return float(np.sum(2.0 * np.diff(grid) / (speed[1:] + speed[:-1])))


def least_time(route: Route, most: AxisLimits, n_grid: int) -> float:
    """Return the time-optimal bound of a route with its exact stops."""
    path, total = route.path, float(route.dwell.sum()) + route.dwell_before
    ends = path.breaks[1:-1]
    halt = np.isin(ends, path.corners) | (route.dwell[:-1] > 0.0) | (route.rapid[1:] != route.rapid[:-1])
    for begin, end in pairwise([0.0, *ends[halt].tolist(), path.length]):
        first, last = path.curve_index([begin, end - 1e-12])
        if first == last and isinstance(path.curves[first], Line):
            share = np.maximum(np.abs(path.tangent([0.5 * (begin + end)])[0]), 1e-300)
            top = min(float(route.feedrate[first]), float(np.min(most.velocity / share)))
            total += line_time(end - begin, top, float(np.min(most.acceleration / share)))
        else:
            total += stretch_time(route, begin, end, most, n_grid)
    return total


def against_bound(quick: bool) -> list[dict[str, Any]]:
    """Return our times and toppra's, at A = 2 m/s^2, with high jerk and with 40 m/s^3."""
    logging.getLogger("toppra").setLevel(logging.ERROR)
    routes = {f"circle R{r}": (route_from_path(contour("circle", radius=1e-3 * r), 0.5), 0.5, 2000) for r in (5, 20, 50)}
    routes["butterfly"] = (route_from_path(contour("butterfly"), 0.5), 0.5, 4000 if quick else 20000)
    found = dict(programs())
    for name, n_move in (("heart", 60 if quick else 10**6), ("tort", 60 if quick else 10**6), ("8x_gear", 60 if quick else 600)):
        program = found[name]
        if isinstance(program, Program):
            routes[name] = (driven(dataclasses.replace(program, moves=program.moves[:n_move])), VELOCITY, 200)
    rows = []
    for name, (route, velocity, n_grid) in routes.items():
        bound = least_time(route, AxisLimits(velocity, 2.0).for_axes(route.path.n_axis), n_grid)
        row = {"name": name, "curves": route.n_curve, "bound": bound}
        for key, jerk in (("high_jerk", 2000.0), ("jerk_40", 40.0)):
            most = AxisLimits(velocity, 2.0, jerk)
            reference = plan(route, most, PERIOD)
            row |= {key: reference.duration, f"{key}_ratio": reference.duration / bound}
            row |= {f"{key}_kept": limit_report(reference, most).ok()}
        rows.append(row)
        print(".", end="", file=sys.stderr, flush=True)
    return rows


def speed(counts: Sequence[int]) -> list[dict[str, Any]]:
    """Return the processor time to plan and sample random polylines of 1 mm lines."""
    rows: list[dict[str, Any]] = []
    for mode, tolerance in MODES.items():
        if tolerance == 1e-5:
            continue
        for n in counts:
            turns = np.random.default_rng(1).uniform(0.0, 2.0 * math.pi, n)
            points = np.cumsum(np.vstack([[0.0, 0.0], 1e-3 * np.column_stack([np.cos(turns), np.sin(turns)])]), axis=0)
            start = time.process_time()
            programmed = route_from_path(Curves([Line(a, b) for a, b in pairwise(points)]), FEED)
            made = time.process_time()
            if (route := in_mode(programmed, tolerance)) is None:
                break
            reference = plan(route, AxisLimits(VELOCITY, ACCELERATION, JERK), PERIOD)
            planned = time.process_time()
            for first in range(0, reference.n_sample, 65536):
                reference.block(first, min(first + 65536, reference.n_sample))
            done = time.process_time()
            rows.append({"mode": mode, "lines": n, "path": made - start, "plan": planned - made, "sample": done - planned})
            rows[-1] |= {"samples": reference.n_sample, "seconds": done - made}
            if done - made > PATIENCE:
                break
    return rows


def exponent(rows: Sequence[dict[str, Any]]) -> float:
    """Return the slope of log time over log lines."""
    lines, seconds = (np.log([row[key] for row in rows]) for key in ("lines", "seconds"))
    return float(np.polyfit(lines, seconds, 1)[0])


# Telling.


def shown(value: Any, form: str, scale: float = 1.0) -> str:
    """Return a number as text, "-" where there is none."""
    return "-" if value is None else format(scale * value, form)


def table(title: str, heads: Sequence[str], rows: Sequence[Sequence[str]]) -> Table:
    """Return a table, the first column to the left."""
    made = Table(title=title, title_justify="left")
    for number, head in enumerate(heads):
        made.add_column(head, justify="right" if number else "left")
    for row in rows:
        made.add_row(*row)
    return made


def tables(found: dict[str, Any]) -> Iterator[Table]:
    """Yield what was found as tables."""
    heads = ["program", "moves", "mode", "LinuxCNC s", "ours s", "ratio", "LinuxCNC dev um", "ours um", "LinuxCNC acc", "ours acc", "kept"]
    rows: list[list[str]] = []
    for row in found["linuxcnc"]:
        moves = "-" if "of" not in row else str(row["of"]) if row["moves"] == row["of"] else f"first {row['moves']} of {row['of']}"
        kept = {True: "yes", False: "NO", None: "-"}[row.get("limits_kept")]
        times = [shown(row.get(key), ".3f") for key in ("linuxcnc_seconds", "seconds", "ratio")]
        far = [shown(row.get(key), ".2f", 1e6) for key in ("linuxcnc_deviation", "deviation")]
        acc = [shown(row.get(key), ".3f") for key in ("linuxcnc_acceleration", "acceleration")]
        rows.append([row["name"], moves, row.get("mode", "-"), *times, *far, *acc, kept])
    made = table(f"LinuxCNC {found['why_no_linuxcnc']}", heads, rows)
    wrong = [(row, key) for row in found["linuxcnc"] for key in ("error", "linuxcnc_error") if key in row]
    made.caption = "\n".join(f"{row['name']} {row.get('mode', '')}: {key}: {row[key]}" for row, key in wrong)
    yield made
    heads = ["path", "curves", "bound s", "high jerk s", "ratio", "kept", "J = 40 s", "ratio", "kept"]
    lines: list[list[str]] = []
    for row in found["bound"]:
        cells = [f"{row['bound']:.4f}"]
        for key in ("high_jerk", "jerk_40"):
            cells += [f"{row[key]:.4f}", f"{row[f'{key}_ratio']:.4f}", "yes" if row[f"{key}_kept"] else "NO"]
        lines.append([row["name"], str(row["curves"]), *cells])
    yield table("toppra's time-optimal bound, A = 2 m/s^2", heads, lines)
    heads = ["mode", "lines", "path s", "plan s", "sample s", "samples", "plan + sample s"]
    lines = [
        [r["mode"], str(r["lines"]), *(f"{r[k]:.3f}" for k in ("path", "plan", "sample")), str(r["samples"]), f"{r['seconds']:.3f}"]
        for r in found["speed"]
    ]
    grown = ", ".join(f"{mode}: lines^{value:.2f}" for mode, value in found["exponent"].items())
    yield table(f"Planning, processor time; {grown}", heads, lines)


def main() -> int:
    """Run the benchmark, print the tables, write the JSON."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--quick", action="store_true", help="3 s of each program, fewer lines, coarser bound")
    parser.add_argument("--json", type=Path, default=HERE / "out" / "planning.json", help="where the figures go")
    parser.add_argument("--only", default="", help="only programs on LinuxCNC whose name has this in it")
    options = parser.parse_args()
    found: dict[str, Any] = {"platform": platform.platform(), "why_no_linuxcnc": why_no_linuxcnc()}
    found["speed"] = speed((1_000, 2_000, 4_000) if options.quick else (5_000, 10_000, 20_000, 40_000))
    by_mode = {mode: [row for row in found["speed"] if row["mode"] == mode] for mode in MODES}
    found["exponent"] = {mode: exponent(rows) for mode, rows in by_mode.items() if len(rows) > 1}
    found["bound"] = against_bound(options.quick)
    found["linuxcnc"] = against_linuxcnc(3.0 if options.quick else SECONDS, options.only)
    print(file=sys.stderr)
    for one in tables(found):
        Console(width=170).print(one)
    options.json.parent.mkdir(parents=True, exist_ok=True)
    options.json.write_text(json.dumps(found, indent=2), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
