"""What an axis has of its place in a machine, where the file of the module that comes there leaves it out."""

from __future__ import annotations

from dataclasses import replace

from contourlab.loop import Axis, Limits
from contourlab.loop.machine import AXIS_SLOTS
from contourlab.scenario.tree import Table

LIMITS = ("velocity", "acceleration", "jerk", "following_error", "travel")


def in_place(table: Table, module: Axis, place: Axis) -> tuple[Axis, str]:
    """Return a module as it stands in a place, and in words what its file leaves out that the axis there has; empty if nothing.

    Stage mass, limits and substeps are then those of the place, as a machine's file often has them beside the name of the axis' file.
    Components and the axis' errors are the module's own: what its file leaves out of these it is taken without.

    Parameters
    ----------
    table : Table
        Content of the module's file.
    module : Axis
        As built of it.
    place : Axis
        That of the machine which it replaces.
    """
    kept, words = module, []
    if "stage_mass" not in table.entries and place.stage_mass:
        origins = {name: origin for name, origin in place.origins.items() if name == "stage_mass"}
        kept = replace(kept, stage_mass=place.stage_mass, origins={**module.origins, **origins})
        words.append(f"stage_mass, {place.stage_mass:g} kg")
    if "substeps" not in table.entries and place.substeps != module.substeps:
        kept = replace(kept, substeps=place.substeps)
        words.append(f"substeps, {place.substeps}")
    limits, names = _limits(table.table("limits"), module.limits, place.limits)
    said = ["; ".join([*words, *names]) + " (kept from the axis there)"] if words or names else []
    lost = [slot for slot in AXIS_SLOTS[1:] if slot not in table.entries and getattr(module, slot) != getattr(place, slot)]
    if "error" not in table.entries and (place.error.position.size or place.error.repeatability):
        lost.append("error")
    if lost:
        said.append(", ".join(lost) + " (taken without, unlike the axis there)")
    return replace(kept, limits=limits), "; ".join(said)


def _limits(table: Table, own: Limits, there: Limits) -> tuple[Limits, list[str]]:
    """Return limits, those that are left out as they are there, and the names of these."""
    plain = Limits()
    names = [name for name in LIMITS if name not in table.entries and getattr(there, name) != getattr(plain, name)]
    origins = {name: there.origins[name] for name in names if name in there.origins}
    given = {name: getattr(there, name) for name in names}
    return replace(own, **given, origins={**own.origins, **origins}), [f"limits.{name}" for name in names]
