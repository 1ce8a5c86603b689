"""Which axes a number has to do with, by its dotted name."""

from __future__ import annotations

from contourlab.loop import Machine


def axes_of(name: str, machine: Machine) -> tuple[str, ...]:
    """Return the axes that a number has to do with: its own, or all where it belongs to what couples them."""
    words = name.split(".")
    return (words[words.index("axes") + 1],) if "axes" in words[:-1] else machine.axis_names
