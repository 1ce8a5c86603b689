"""``contourlab check``: everything that can be said of a part program without simulating it."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.errors import ContourlabError, ProgramError
from contourlab.program import Arc, Dwell, Feed, Program, Reading, Spline, Traverse, read_program

DEFAULT_MACHINE = "builtin:xyz"
MOST_FEEDS = 12
TRAVEL_ROUNDING = 1e-9
"""[m]"""
_KINDS = {Traverse: "traverse", Feed: "feed", Arc: "arc", Spline: "spline", Dwell: "dwell"}


@dataclass(frozen=True)
class Checked:
    """What was found.

    Parameters
    ----------
    good : bool
        Whether the program can be run as it is.
    summary : dict
        For ``--json``.
    text : str
        For people.
    """

    good: bool
    summary: dict[str, Any]
    text: str


def check_program(file: str | Path, machine: str | Path | None = None, *, reading: Reading | None = None) -> Checked:
    """Read a part program to its end, collecting its faults; work out its box, its feeds, and its cycle time on a machine.

    Parameters
    ----------
    file : str or Path
    machine : str or Path, optional
        File, or name of a shipped machine: its limits give the cycle time, and a program that leaves its travel has a fault. By default
        a shipped one, whose travel is told of only.
    reading : Reading, optional
        By default a program need not say where it ends.

    Raises
    ------
    ProgramError
        If the file cannot be read.
    ScenarioError
        If the machine cannot be read.
    """
    problems: list[ProgramError] = []
    program = read_program(file, reading=reading or Reading(require_end=False), problems=problems)
    summary: dict[str, Any] = {
        "program": str(file),
        "problems": [_problem(error) for error in problems],
        "notices": [{"line": notice.line, "column": notice.column, "message": notice.message} for notice in program.notices],
        "n_line": len(program.lines),
        "moves": dict(Counter(_KINDS[type(move)] for move in program.moves)),
        "feeds_mm_per_min": sorted({round(6e4 * move.feedrate, 6) for move in program.moves if not isinstance(move, Traverse | Dwell)}),
        "spindle_speeds": sorted({event.value for event in program.events if event.word == "S" and event.value is not None}),
        "tools": _tools(program),
    }
    if any(not isinstance(move, Dwell) for move in program.moves):
        _add_motion(summary, program, machine)
    return Checked(not summary["problems"], summary, _text(summary))


def _tools(program: Program) -> list[int]:
    changed, selected, found = [], 0.0, []
    for event in program.events:
        selected = event.value or 0.0 if event.word == "T" else selected
        if event.word in ("M6", "M61"):
            changed.append(int(event.value if event.word == "M61" and event.value is not None else selected))
    for tool in changed:
        if tool not in found:
            found.append(tool)
    return found


def _add_motion(summary: dict[str, Any], program: Program, chosen: str | Path | None) -> None:
    """Add lengths, box, cycle time, and whether the path lies within the machine's travel."""
    from contourlab.feed import blended, route_from_program
    from contourlab.feed.planner import plan_profile
    from contourlab.geometry.box import box
    from contourlab.scenario import load_machine
    from contourlab.scenario.load import named_file
    from contourlab.scenario.values import DEFAULT_CORNER_TOLERANCE

    machine_file = DEFAULT_MACHINE if chosen is None else named_file(chosen)
    machine = load_machine(machine_file)
    try:
        route = route_from_program(program, machine.axis_names, default_tolerance=DEFAULT_CORNER_TOLERANCE)
        low, high = box(route.path)
        limits = machine.planner_limits()
        profile = plan_profile(blended(route, limits), limits)
    except ContourlabError as error:
        summary["problems"].append(_problem(error))
        return
    lengths, feed = np.diff(route.path.breaks), ~route.rapid
    dwell = float(route.dwell.sum()) + route.dwell_before
    summary["length"] = {"feed": float(lengths[feed].sum()), "rapid": float(lengths[~feed].sum())}
    summary["box"] = {name: [float(a), float(b)] for name, a, b in zip(machine.axis_names, low, high, strict=True)}
    summary["cycle_time"] = profile.duration
    summary["dwell"] = dwell
    summary["feed_time_without_acceleration"] = float((lengths[feed] / route.feedrate[feed]).sum())
    summary["machine"] = {"name": machine.name, "file": str(machine_file)}
    for axis, (least, most) in zip(machine.axes, zip(low, high, strict=True), strict=True):
        if least < axis.limits.travel[0] - TRAVEL_ROUNDING or most > axis.limits.travel[1] + TRAVEL_ROUNDING:
            shown = f"{axis.limits.travel[0] * 1e3:g} to {axis.limits.travel[1] * 1e3:g} mm"
            message = f"axis {axis.name} is sent to {least * 1e3:.6g} .. {most * 1e3:.6g} mm, its travel on {machine.name} is {shown}"
            summary["notices" if chosen is None else "problems"].append({"file": "", "line": 0, "column": 0, "message": message})


def _problem(error: ContourlabError) -> dict[str, Any]:
    line, column = getattr(error, "line", 0), getattr(error, "column", 0)
    return {"file": getattr(error, "file", ""), "line": line, "column": column, "message": getattr(error, "message", str(error))}


def _text(summary: dict[str, Any]) -> str:
    """Return the summary in words."""
    lines = [f"{entry['file'] or summary['program']}:{_place(entry)} {entry['message']}" for entry in summary["problems"]]
    lines += [f"{summary['program']}:{_place(entry)} note: {entry['message']}" for entry in summary["notices"]]
    count = len(summary["problems"])
    lines.append("no fault found" if not count else f"{count} fault{'s' * (count > 1)}")
    rows = [("lines", f"{summary['n_line']}"), ("moves", ", ".join(f"{n} {kind}" for kind, n in summary["moves"].items()) or "none")]
    if "box" in summary:
        rows += [
            (f"box {name}", f"{low * 1e3:.6g} .. {high * 1e3:.6g} mm ({(high - low) * 1e3:.6g} mm)")
            for name, (low, high) in summary["box"].items()
        ]
        rows.append(("path", f"{summary['length']['feed'] * 1e3:.6g} mm feed, {summary['length']['rapid'] * 1e3:.6g} mm rapid"))
        ideal = summary["feed_time_without_acceleration"]
        rows.append(
            (
                "cycle time",
                f"{_duration(summary['cycle_time'])} on {summary['machine']['name']} (dwells {summary['dwell']:.3g} s; "
                f"feed moves alone at their feedrates {_duration(ideal)})",
            )
        )
    feeds = summary["feeds_mm_per_min"]
    shown = [f"{feed:g}" for feed in feeds] if len(feeds) <= MOST_FEEDS else [f"{len(feeds)} from {feeds[0]:g} to {feeds[-1]:g}"]
    rows.append(("feeds", (", ".join(shown) + " mm/min") if feeds else "none"))
    if summary["spindle_speeds"]:
        rows.append(("spindle", ", ".join(f"{speed:g}" for speed in summary["spindle_speeds"]) + " rpm"))
    if summary["tools"]:
        rows.append(("tools", ", ".join(f"T{tool}" for tool in summary["tools"])))
    return "\n".join([*lines, *(f"{name:<12}{value}" for name, value in rows)])


def _place(entry: dict[str, Any]) -> str:
    return f"{entry['line']}:{entry['column']}:" if entry["line"] and entry["column"] else f"{entry['line']}:" if entry["line"] else ""


def _duration(seconds: float) -> str:
    """Write a time as people read it.

    >>> _duration(4.25), _duration(3725.0)
    ('4.25 s', '1 h 2 min 5 s')
    """
    if seconds < 60.0:
        return f"{seconds:.4g} s"
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return (f"{hours} h " if hours else "") + f"{minutes} min {rest} s"
