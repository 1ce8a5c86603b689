"""grbl and grblHAL: the dump of their settings, as the command ``$$`` prints it."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from contourlab.controls.contract import FLOATING, LARGEST, ControlFile, computed, driven_by_steps, read_from, stepping
from contourlab.errors import ScenarioError, refuse
from contourlab.findings import finding

_SETTING = re.compile(r"^\s*(?:[<>\[]\s*)?\$(\d+)\s*=\s*([^\s(\]]+)")
_DUMP = re.compile(rb"^\s*(?:[<>\[]\s*)?\$1[0-3]0\s*=", re.MULTILINE)
"""Steps, rate, acceleration or travel of the first axis."""
_LIMITS = (("velocity", 110, "mm/min"), ("acceleration", 120, "mm/s^2"), ("jerk", 800, "mm/s^3"))
_PLANNER = {"junction_deviation": 11, "arc_tolerance": 12}
_READ = {11, 12, 22, 23, 398, *range(100, 140), *(first + n for first in (160, 800) for n in range(3))}
"""Settings that must be numbers; others may be words."""


def matches(file: Path, head: bytes) -> bool:
    """Return whether a file is a dump of settings."""
    return len(_DUMP.findall(head)) >= 2


def read(file: Path) -> ControlFile:
    """Return the machine of a dump.

    Raises
    ------
    ScenarioError
        If a setting is no number, or none of x, y and z has a rate.
    """
    settings = dict(_settings(file))
    axes = {letter: n for n, letter in enumerate("xyz") if 110 + n in settings}
    refuse(not axes, ScenarioError, "has no $110: save all that the command $$ prints", file=file)
    tables = {letter: dict(_axis(settings, n)) for letter, n in axes.items()}
    gaps = {letter: settings.get(160 + n, (0.0, ""))[0] for letter, n in axes.items()}
    findings = [finding("CL986", f"axis {letter}", gap=1e-3 * gap) for letter, gap in gaps.items() if gap]
    control = "grblHAL" if {160, 800} & settings.keys() else "grbl"
    return stepping(file, control, file.stem, tables, _planner(settings, control), findings)


def _planner(settings: dict[int, tuple[float, str]], control: str) -> dict[str, Any]:
    """Return how the control plans: grblHAL with limits of jerk in another way than grbl, and by default with a larger buffer."""
    if any(settings.get(800 + n, (0.0, ""))[0] for n in range(3)):
        return {}
    given = {name: settings[number] for name, number in _PLANNER.items() if number in settings}
    blocks = {} if control == "grbl" else {"planner_blocks": int(settings.get(398, (100.0, ""))[0])}
    return {"planner": "grbl", **blocks, **{name: read_from(f"{value:.12g} mm", place) for name, (value, place) in given.items()}}


def _settings(file: Path) -> Iterator[tuple[int, tuple[float, str]]]:
    """Yield number, value and place of each setting; words are left out."""
    for line, text in enumerate(file.read_text(encoding="utf-8-sig", errors="replace").splitlines(), start=1):
        if match := _SETTING.match(text):
            place = f"{file.name}:{line}"
            try:
                value = float(match[2].rstrip(","))
            except ValueError:
                value = math.nan
            if abs(value) < LARGEST:
                yield int(match[1]), (value, place)
            elif int(match[1]) in _READ:
                raise ScenarioError(f"${match[1]} = {match[2]}: must be a number", file=place)


def _axis(settings: dict[int, tuple[float, str]], n: int) -> Iterator[tuple[str, Any]]:
    """Yield the tables of an axis."""

    def positive(number: int) -> tuple[float, str] | None:
        value, place = settings.get(number, (math.nan, ""))
        refuse(value <= 0.0, ScenarioError, f"${number} = {value:g}: must be a number above 0", file=place)
        return (value, place) if place else None

    steps = positive(100 + n)
    yield from driven_by_steps(1e-3, computed(f"{1e3 / steps[0]:.12g} um", f"1/${100 + n}") if steps else None).items()
    known = [(name, positive(first + n), unit) for name, first, unit in _LIMITS if name != "jerk" or settings.get(first + n, (0.0, ""))[0]]
    limits = {name: read_from(f"{value[0]:.12g} {unit}", value[1]) for name, value, unit in known if value}
    if travel := settings.get(130 + n):
        # After homing the machine zero is at the positive end; with grblHAL's flag it is where the axis homes.
        homing, directions = (int(settings.get(number, (0.0, ""))[0]) for number in (22, 23))
        low = 0.0 if homing & 8 and directions >> n & 1 else -abs(travel[0])
        limits["travel"] = read_from([f"{low:.12g} mm", f"{low + abs(travel[0]):.12g} mm"], travel[1])
    yield "limits", {**limits, **FLOATING}
