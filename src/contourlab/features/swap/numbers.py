"""Controllers of a division: with numbers in place of theirs, some of which move with their axis."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from contourlab.design.values import controller_with
from contourlab.loop import Controller


def divided_controller(controller: Controller, values: Mapping[str, float], local: Sequence[str] = ()) -> Controller:
    """Return a controller with values [SI] in place of its own, by dotted names; `local` are those that move with their axis."""
    made = controller_with(controller, values)
    axes = {}
    for name, axis in made.axes.items():
        head = f"controller.axes.{name}."
        axes[name] = replace(axis, local=tuple(dotted.removeprefix(head) for dotted in local if dotted.startswith(head)))
    return replace(made, axes=axes)
