"""FluidNC: its configuration, ``config.yaml``."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from contourlab.controls.contract import FLOATING, LARGEST, ControlFile, computed, driven_by_steps, read_from, stepping
from contourlab.errors import ScenarioError, refuse
from contourlab.findings import finding

_OWN = re.compile(rb"^\s+max_rate_mm_per_min\s*:", re.MULTILINE)
_LIMITS = {"velocity": ("max_rate_mm_per_min", "mm/min"), "acceleration": ("acceleration_mm_per_sec2", "mm/s^2")}
MOST = 1 << 20
"""Most bytes of a configuration."""


def matches(file: Path, head: bytes) -> bool:
    """Return whether a file is a configuration."""
    return file.suffix.lower() in (".yaml", ".yml") and _OWN.search(head) is not None


def read(file: Path) -> ControlFile:
    """Return the machine of a configuration.

    Raises
    ------
    ScenarioError
        If it is no YAML, a value is no number, its kinematics couple the axes, or it has none of x, y and z.
    """
    import yaml

    try:
        text = file.read_text(encoding="utf-8-sig", errors="replace")
        content = yaml.safe_load(text) if len(text) <= MOST else None
    except yaml.YAMLError as error:
        raise ScenarioError(f"is no YAML: {str(error).replace(chr(10), ' ')[:200]}", file=file) from error
    sections = {str(key).lower(): value for key, value in content.items()} if isinstance(content, Mapping) else {}
    kinematics = sections.get("kinematics")
    if kind := next((kind for kind in map(str, kinematics or ()) if kind.lower() != "cartesian"), ""):
        raise ScenarioError(f"kinematics: {kind}: motors are no axes; only Cartesian is read", file=file)
    given = sections.get("axes")
    axes = {str(name).lower(): axis for name, axis in given.items() if isinstance(axis, Mapping)} if isinstance(given, Mapping) else {}
    names = [letter for letter in "xyz" if letter in axes]
    refuse(not names, ScenarioError, "has none of the axes x, y and z under axes", file=file)
    others = [name for name in axes if name in ("a", "b", "c", "u", "v", "w")]
    findings = [finding("CL981", file.name, axis=name, why="only x, y and z are read") for name in others]
    tables = {name: dict(_axis(file, name, axes[name])) for name in names}
    keys = {"junction_deviation": "junction_deviation_mm", "arc_tolerance": "arc_tolerance_mm"}
    planner: dict[str, Any] = {
        name: read_from(f"{sections[key]} mm", f"{file.name} {key}") for name, key in keys.items() if key in sections
    }
    planner |= {"planner": "grbl", "planner_blocks": sections.get("planner_blocks", 16)}
    homed = [_homed(axes.get(name, {})) for name in "xyz"]
    return stepping(file, "FluidNC", str(sections.get("name") or file.stem), tables, planner, findings, start=", ".join(map(repr, homed)))


def _homed(axis: Mapping[str, Any]) -> float:
    """Return where an axis stands after homing [mm]."""
    homing = axis.get("homing")
    at = homing.get("mpos_mm") if isinstance(homing, Mapping) else None
    return float(at) if isinstance(at, int | float) else 0.0


def _axis(file: Path, name: str, axis: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """Yield the tables of an axis."""

    def number(table: Mapping[str, Any], key: str, above: float = 0.0) -> float | None:
        value = table.get(key)
        if value is None:
            return None
        if isinstance(value, bool) or not isinstance(value, int | float) or not above < value < LARGEST:
            raise ScenarioError(f"must be a number{' above 0' if above == 0.0 else ''}", file=file, key=f"axes.{name}.{key}")
        return float(value)

    steps = number(axis, "steps_per_mm")
    yield from driven_by_steps(1e-3, computed(f"{1e3 / steps:.12g} um", "1/steps_per_mm") if steps else None).items()
    known = [(limit, number(axis, key), key, unit) for limit, (key, unit) in _LIMITS.items()]
    limits = {limit: read_from(f"{value:.12g} {unit}", f"{file.name} axes.{name}.{key}") for limit, value, key, unit in known if value}
    given = axis.get("homing")
    homing: Mapping[str, Any] = given if isinstance(given, Mapping) else {}
    if travel := number(axis, "max_travel_mm"):
        at = number(homing, "mpos_mm", -LARGEST) or 0.0  # where the switch is
        if not isinstance(up := homing.get("positive_direction", True), bool):
            raise ScenarioError("must be true or false", file=file, key=f"axes.{name}.homing.positive_direction")
        low = at - travel if up else at
        limits["travel"] = read_from([f"{low:.12g} mm", f"{low + travel:.12g} mm"], f"{file.name} axes.{name}.max_travel_mm and homing")
    yield "limits", {**limits, **FLOATING}
