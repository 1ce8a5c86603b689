"""What a person gets: the changes as a diff, the circle before and after, and a page."""

from __future__ import annotations

import base64
import difflib
import io
import math
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TypeAlias

import numpy as np

from contourlab.app.results import SAFETY
from contourlab.arrays import Array
from contourlab.features.commission.hal_files import AxisSetup, Setup
from contourlab.features.commission.identification import IdentifiedAxis
from contourlab.features.commission.loop import run_lanes
from contourlab.features.commission.tuning import AxisTask
from contourlab.figures import figure
from contourlab.findings import Finding
from contourlab.rendering.style import scheme_style
from contourlab.rendering.table import Column, Table

CIRCLE = 0.01
"""Radius of the circle in the report [m]."""
Rows: TypeAlias = Mapping[str, Array]
Curves: TypeAlias = Mapping[str, tuple[Array, Array]]


def text_of(value: float) -> str:
    """Return a gain as it is written into a file."""
    return f"{value:.6g}"


def changes(setup: Setup, gains: Mapping[str, Mapping[str, float]]) -> str:
    """Return the unified diff of INI and HAL that sets gains.

    Parameters
    ----------
    setup : Setup
    gains : mapping of str to mapping of str to float
        By axis and HAL's name, in machine units. A gain that the files do not set is added only if it changes.
    """
    lines = {file: _lines(file) for file in (setup.hal, *(place.file for axis in setup.axes for place in axis.places.values()))}
    added: dict[int, list[str]] = {}
    for axis in setup.axes:
        for name, value in gains.get(axis.name, {}).items():
            entry = axis.places.get(name)
            if entry is not None and float(entry.value) != value:
                line = lines[entry.file][entry.line - 1]
                head, rest = re.match(r"([^=#]*=\s*|\s*setp\s+\S+\s+)(.*)", line, re.DOTALL).groups()  # type: ignore[union-attr]
                lines[entry.file][entry.line - 1] = head + rest.replace(entry.value, text_of(value), 1)
            elif entry is None and value != axis.gains[name]:
                added.setdefault(axis.last or len(lines[setup.hal]), []).append(f"setp {axis.pid}.{name} {text_of(value)}\n")
    for number in sorted(added, reverse=True):
        lines[setup.hal][number:number] = added[number]
    diffs = (difflib.unified_diff(_lines(file), new, f"a/{file.name}", f"b/{file.name}") for file, new in lines.items())
    text = "".join(line for diff in diffs for line in diff)
    return f"{SAFETY}\n{text}" if text else ""


def _lines(file: Path) -> list[str]:
    """Return the lines of a file, each with its end."""
    return [f"{line}\n" for line in file.read_text(encoding="utf-8", errors="replace").splitlines()]


def circle_errors(axes: Mapping[str, tuple[AxisTask, IdentifiedAxis]], gains: Mapping[str, Rows], fastest: float) -> Curves:
    """Return angle [rad] and radial error [m] on a circle of x and y, simulated with each set of gains.

    Parameters
    ----------
    axes : mapping of str to (AxisTask, IdentifiedAxis)
    gains : mapping of str to mapping of str to ndarray (7,)
        By name of the set and axis, per metre.
    fastest : float [m/s^2]
        An eighth of this acceleration is used.
    """
    period, turn, start = axes["x"][0].law.period, 0.5 * math.sqrt(0.5 * fastest / CIRCLE), 0.3
    time = period * np.arange(round((start + 4.0 * math.pi / turn) / period))
    phase = turn * np.where(time < start, time**2 / (2.0 * start), time - 0.5 * start)  # from rest, two turns
    commands, last = {"x": CIRCLE * np.cos(phase), "y": CIRCLE * np.sin(phase)}, phase > phase[-1] - 2.0 * math.pi
    curves = {}
    for label, rows in gains.items():
        places = []
        for name, command in commands.items():
            task, model = axes[name]
            run = run_lanes(command, model.noise_like(command), rows[name][None], [task.model], task.law, trace=True)
            places.append(run.position[last])
        curves[label] = (np.arctan2(*places[::-1]), np.hypot(*places) - CIRCLE)
    return curves


def circle_png(errors: Curves) -> bytes:
    """Return the picture of a circle, its radial errors magnified.

    Parameters
    ----------
    errors : mapping of str to (angle, error)
        Angle [rad] and radial error [m] of each curve, by name. Each has its own scale, which the legend states.
    """
    import matplotlib
    from matplotlib.figure import Figure

    from contourlab.rendering.matplotlib_view import LOOKS, WIDTH

    with matplotlib.rc_context(fname=LOOKS):
        canvas = Figure(figsize=(WIDTH, 4.4), layout="constrained")
        places = canvas.subplots(1, len(errors), squeeze=False)[0]
        turn = np.linspace(0.0, 2.0 * np.pi, 361)
        for i, (place, (name, (angle, error))) in enumerate(zip(places, errors.items(), strict=True)):
            largest = float(np.abs(error).max(initial=1e-9))
            drawn = 1.0 + 0.25 * error / largest
            place.plot(np.cos(turn), np.sin(turn), color="#8a949e", linewidth=0.8)
            place.plot(drawn * np.cos(angle), drawn * np.sin(angle), color=scheme_style(i, 2)[0], linewidth=1.1)
            place.set_aspect("equal")
            place.spines[:].set_visible(False)
            place.set(xticks=[], yticks=[], title=f"{name}: at most {figure(largest, 'um')}", xlim=(-1.35, 1.35), ylim=(-1.35, 1.35))
            place.set_xlabel(f"radius {figure(CIRCLE, 'mm')}, errors x {figure(0.25 * CIRCLE / largest)}")
        buffer = io.BytesIO()
        canvas.savefig(buffer, format="png")
    return buffer.getvalue()


def gain_table(axes: tuple[AxisSetup, ...], columns: Mapping[str, Mapping[str, Mapping[str, float]]]) -> Table:
    """Return a table of axis, gain, and its value in each column; gains that are zero everywhere are left out."""
    table = Table([Column("gain", left=True), *map(Column, columns)])
    for axis in axes:
        for name in axis.gains:
            values = [gains[axis.name][name] for gains in columns.values() if axis.name in gains]
            if len(values) == len(columns) and any(values):
                table.add(f"{axis.name} {name}", *map(text_of, values))
    return table


def page(
    title: str, answer: Sequence[str], tables: Mapping[str, Table], diff: str, picture: bytes | None, findings: Sequence[Finding]
) -> str:
    """Return the report as one HTML page."""
    from contourlab.rendering.html import page_template

    image = "" if picture is None else base64.b64encode(picture).decode()
    worst_first = sorted(findings, key=lambda doubt: ("error", "warning", "info").index(doubt.entry.severity))
    template = page_template("commission.html.j2")
    return str(template.render(title=title, answer=answer, tables=tables, diff=diff, picture=image, findings=worst_first))
