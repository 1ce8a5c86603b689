"""What to run and to record: a program that excites friction, inertia and delay of each axis, HAL lines for the sampler, and the steps."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from contourlab.app.results import filled
from contourlab.controls.linuxcnc.files import sampler_lines
from contourlab.errors import ScenarioError
from contourlab.features.commission.setup import AxisSetup, Setup

SHARE = 0.35
"""Part of the travel to either side of the middle that the program uses at most."""
LONGEST = 60.0
"""Longest way to either side [mm]."""
SPEEDS = (0.02, 0.1, 0.4, 1.0)
"""Speeds of the reversals, relative to the axis' limit."""
SLOW_STROKE = 0.2
"""Stroke [mm] and speed [mm/s] of the reversals in which the load stops before the motor has crossed the play."""
TURN_TIME = 0.4
"""Time of a reversal at constant speed [s]."""
SIGNALS = {"command": "_cmd", "feedback": "", "output": "_out"}
"""Pins of the pid that the sampler records, with the ends of their columns' names."""


def excitation(setup: Setup) -> str:
    """Return the program: each axis back and forth at several speeds, then circles both ways in the first two axes.

    Raises
    ------
    ScenarioError
        If the travel of an axis is too short.
    """
    mm = 1e-3 / setup.unit  # machine units per mm
    lines = [
        "(Excitation for contourlab commission. It moves the axes to be commissioned around the middle of its travel.)",
        f"{'G20' if setup.unit_name == 'inch' else 'G21'} G90 G17 G40 G49 G61 G94",
    ]
    reach = {axis.name: _reach(axis, mm, setup.ini.file.name) for axis in setup.closed}
    for axis in setup.closed:
        middle = 0.5 * (axis.limits["low"] + axis.limits["high"])
        lines.append(f"G53 G1 {axis.name.upper()}{_text(middle)} F{_text(60.0 * 0.3 * axis.limits['velocity'])}")
    lines += ["G91", "G4 P0.5"]
    for axis in setup.closed:
        lines += _strokes(axis, reach[axis.name], mm)
    pair = [axis for axis in setup.closed if axis.name in "xy"]
    if len(pair) == 2:
        lines += _circles(pair, reach)
    return "\n".join([*lines, "G90", "M2", ""])


def _text(value: float) -> str:
    return f"{value:.4f}".rstrip("0").rstrip(".") or "0"


def _reach(axis: AxisSetup, mm: float, file: str) -> float:
    """Return the way to either side of the middle in machine units."""
    travel = axis.limits["high"] - axis.limits["low"]
    if not travel > 2.0 * mm:
        raise ScenarioError(f"axis {axis.name} may move {travel / mm:g} mm: the excitation needs at least 2 mm", file=file)
    return min(SHARE * travel, LONGEST * mm)


def _strokes(axis: AxisSetup, reach: float, mm: float) -> list[str]:
    """Return the reversals of one axis: two of each length and speed, slow ones, and short ones at the acceleration limit."""
    letter, fastest, strongest = axis.name.upper(), axis.limits["velocity"], axis.limits["acceleration"]
    lines = [f"(axis {letter}: reversals at {len(SPEEDS)} speeds, very slow ones, then at the acceleration limit)"]
    for share in SPEEDS:
        speed = share * fastest
        way = min(speed * TURN_TIME + speed**2 / strongest, reach)
        first, *others = (f"G1 {letter}{_text(factor * way)}" for factor in (1.0, -2.0, 2.0, -1.0))
        lines += [f"{first} F{_text(60.0 * speed)}", *others, "G4 P0.1"]
    slow = min(SLOW_STROKE * mm, reach)
    lines += [f"G1 {letter}{_text(sign * slow)} F{_text(60.0 * SLOW_STROKE * mm)}" for sign in (1, -1) * 4]
    for time in (0.04, 0.08, 0.15):
        way = min(max(strongest * (0.5 * time) ** 2, 0.05 * mm), reach)
        lines += [f"G1 {letter}{_text(sign * way)} F{_text(60.0 * fastest)}" for sign in (1, -1, -1, 1) * 2]
    return [*lines, "G4 P0.2"]


def _circles(pair: Sequence[AxisSetup], reach: dict[str, float]) -> list[str]:
    """Return a circle each way at a moderate and at a fast feed, from the middle and back."""
    radius = 0.25 * min(reach[axis.name] for axis in pair)
    fastest = min(min(axis.limits["velocity"], (0.4 * axis.limits["acceleration"] * radius) ** 0.5) for axis in pair)
    lines, (x, y) = ["(circles both ways)", "G64"], (axis.name.upper() for axis in pair)
    for share in (0.25, 0.7):
        lines += [f"G1 {x}{_text(radius)} F{_text(60.0 * share * fastest)}"]
        lines += [f"{word} {x}0 {y}0 I{_text(-radius)} J0" for word in ("G3", "G2")]
        lines += [f"G1 {x}{_text(-radius)}", "G4 P0.1"]
    return lines


def sampler_columns(setup: Setup) -> list[str]:
    """Return the columns in the order of the sampler's pins, as ``x_cmd``, ``x``, ``x_out``."""
    return [f"{axis.name}{end}" for axis in setup.axes for end in SIGNALS.values()]


def sampler(setup: Setup) -> str:
    """Return HAL lines that record every axis at each servo period."""
    columns = sampler_columns(setup)
    wired = [(axis, signal) for axis in setup.axes for signal in axis.signals.values()]
    sources = [
        signal if not signal.startswith(f"{axis.pid}.") else f"commission-{column} {signal}"
        for column, (axis, signal) in zip(columns, wired, strict=True)
    ]
    load, add, *nets = sampler_lines(sources, "f" * len(columns))
    named = [f"{net}  # {column}" for net, column in zip(nets, columns, strict=True)]
    head = "# Lines for contourlab commission. Load them after your own HAL files; remove them when done."
    return "\n".join([head, load, add, *named, ""])


def steps(setup: Setup, out: Path) -> str:
    """Return the page with the steps, in Markdown."""
    columns = sampler_columns(setup)
    named = (column if column.endswith("_out") else f"{column} [{setup.unit_name}]" for column in columns)
    rows = [
        f"| {axis.name} | joint {axis.joint} | `{axis.pid}` | "
        f"{axis.limits['low']:g} to {axis.limits['high']:g} {setup.unit_name} | {axis.limits['velocity']:g} {setup.unit_name}/s |"
        for axis in setup.axes
    ]
    values = {"INI": setup.ini.file.name, "HAL": setup.hal.name, "OUT": str(out), "AXES": "\n".join(rows)}
    values |= {"COLUMNS": ", ".join(columns), "HEADER": ",".join(["time [s]", "sample", *named])}
    return filled(Path(__file__).with_name("steps.md"), values)
