"""Compare the planner with LinuxCNC's trajectory planner and with toppra's time-optimal bound.

    python benchmarks/planning.py [--quick] [--json FILE] [--only WORD]

`linuxcnc.py` describes LinuxCNC's properties. It has no jerk limit: we plan with J = 1000 m/s^3, where a ramp takes one of its servo
periods, and also without a jerk limit.

**toppra** gives the least time along a path under limits of velocity and acceleration only, on a grid, for each stretch between exact
stops. Single lines use the closed form. No planner with a jerk limit reaches this bound.
"""

from __future__ import annotations

import argparse
import dataclasses
import json
import logging
import math
import platform
import sys
import time
from collections.abc import Iterator, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from linuxcnc import (
    FEED,
    HERE,
    PERIOD,
    VELOCITY,
    OracleError,
    deviation,
    driven,
    limits,
    programs,
    rewritten,
    their_samples,
    why_no_linuxcnc,
    worst_rates,
)
from rich.console import Console
from rich.table import Table

from contourlab.app.precompile import precompile
from contourlab.errors import ContourlabError
from contourlab.feed import AxisLimits, Reference, Route, blended, limit_report, plan, route_from_path
from contourlab.feed.route import junctions
from contourlab.geometry import Line, contour
from contourlab.geometry import Path as Curves
from contourlab.program import Arc, Dwell, Program

REAL_JERK = 40.0  # m/s^3
PATIENCE = 30.0  # s: after a program that took more, skip longer ones in that mode
SECONDS = 8.0  # s of a program on LinuxCNC, by our duration under G61
MODES = {"G61": None, "G64 P0.01": 1e-5, "G64 P0.1": 1e-4}  # tolerance [m]


def in_mode(route: Route, tolerance: float | None, within: AxisLimits) -> Route:
    """Return the route as driven in a mode: G61 for None; otherwise with corners blended and lines merged within a tolerance [m]."""
    part = tolerance or 0.0
    found = dataclasses.replace(
        route,
        corner_tolerance=np.full(route.n_curve, part),
        merge_tolerance=np.full(route.n_curve, part),
        exact_stop=np.zeros(route.n_curve, bool),
    )
    return found if tolerance is None else blended(found, within)


def shortened(program: Program, seconds: float) -> tuple[Program, int]:
    """Return the program's first moves, as many as we drive in `seconds`, and how many moves it had."""
    moves = program.moves
    reference = plan(driven(program), limits(), PERIOD)
    if reference.duration <= seconds:
        return program, len(moves)
    sample = int(seconds / PERIOD)
    whole = max(int(reference.path.curve_index(reference.block(sample, sample + 1).arc_length)[0]), 1)
    # Dwells and zero-length moves make no curve.
    curves = np.cumsum([not isinstance(move, Dwell) and (isinstance(move, Arc) or move.start != move.end) for move in moves])
    return dataclasses.replace(program, moves=moves[: int(np.searchsorted(curves, whole)) + 1]), len(moves)


def all_positions(reference: Reference) -> np.ndarray:
    """Return every sample's position."""
    return np.array(reference.block(0, reference.n_sample).position)


def compare(program: Program, mode: str) -> dict[str, Any]:
    """Run one program in one mode on both planners."""
    route = driven(program)
    row: dict[str, Any] = {"mode": mode}
    try:
        ours = in_mode(route, MODES[mode], limits())
        start = time.process_time()
        reference = plan(ours, limits(), PERIOD)
        positions = all_positions(reference)
        row |= {"seconds": reference.duration, "planning_seconds": time.process_time() - start}
        row |= {"deviation": deviation(positions, route.path), "limits_kept": limit_report(reference, limits()).ok()}
        row |= worst_rates(positions) | {"seconds_without_jerk_limit": plan(ours, limits(jerk=math.inf), PERIOD).duration}
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
        row["ratio_without_jerk_limit"] = row["seconds_without_jerk_limit"] / row["linuxcnc_seconds"]
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
    from toppra.constraint import JointAccelerationConstraint, JointVelocityConstraint, JointVelocityConstraintVarying

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
    first, last = route.path.curve_index([begin, end - 1e-12])
    even = np.ptp(route.feedrate[first : last + 1]) == 0.0  # then toppra needs no call for each place
    velocity = JointVelocityConstraint(speeds(0.0)) if even else JointVelocityConstraintVarying(speeds)
    constraints = [velocity, JointAccelerationConstraint(np.column_stack([-span, span]))]
    _, speed, _ = TOPPRA(constraints, Stretch(), gridpoints=grid, solver_wrapper="seidel").compute_parameterization(0.0, 0.0)
    if speed is None:
        raise OracleError("toppra found no motion")
    return float(np.sum(2.0 * np.diff(grid) / (speed[1:] + speed[:-1])))


def least_time(route: Route, most: AxisLimits, n_grid: int) -> float:
    """Return the time-optimal bound of a route with its exact stops."""
    path, total = route.path, float(route.dwell.sum()) + route.dwell_before
    ends = path.breaks[1:-1]
    # The planner passes small jumps of direction, which rounded coordinates cause; so does the bound.
    halt = junctions(route).stop[:-1]
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
    precompile()
    for mode, tolerance in MODES.items():
        if tolerance == 1e-5:
            continue
        for n in counts:
            turns = np.random.default_rng(1).uniform(0.0, 2.0 * math.pi, n)
            points = np.cumsum(np.vstack([[0.0, 0.0], 1e-3 * np.column_stack([np.cos(turns), np.sin(turns)])]), axis=0)
            start = time.process_time()
            programmed = route_from_path(Curves([Line(a, b) for a, b in pairwise(points)]), FEED)
            made = time.process_time()
            slow = AxisLimits(VELOCITY, 2.0, REAL_JERK)
            reference = plan(in_mode(programmed, tolerance, slow), slow, PERIOD)
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


def shown(value: Any, form: str, scale: float = 1.0) -> str:
    """Return a number as text, "-" for None."""
    return "-" if value is None else format(scale * value, form)


def table(title: str, heads: Sequence[str], rows: Sequence[Sequence[str]]) -> Table:
    """Return a table; the first column is left-aligned."""
    made = Table(title=title, title_justify="left")
    for number, head in enumerate(heads):
        made.add_column(head, justify="right" if number else "left")
    for row in rows:
        made.add_row(*row)
    return made


def tables(found: dict[str, Any]) -> Iterator[Table]:
    """Yield the tables of the results."""
    heads = [
        "program",
        "moves",
        "mode",
        "LinuxCNC s",
        "ours s",
        "ratio",
        "J = inf",
        "LinuxCNC dev um",
        "ours um",
        "LinuxCNC acc",
        "ours acc",
        "kept",
    ]
    rows: list[list[str]] = []
    for row in found["linuxcnc"]:
        moves = "-" if "of" not in row else str(row["of"]) if row["moves"] == row["of"] else f"first {row['moves']} of {row['of']}"
        kept = {True: "yes", False: "NO", None: "-"}[row.get("limits_kept")]
        times = [shown(row.get(key), ".3f") for key in ("linuxcnc_seconds", "seconds", "ratio", "ratio_without_jerk_limit")]
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
    parser.add_argument("--json", type=Path, default=HERE / "out" / "planning.json", help="file for the figures")
    parser.add_argument("--only", default="", help="run only programs with this in their name on LinuxCNC")
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
