"""The text of components that are not contourlab's own: what is kept of a run holds only as long as a plugin says the same."""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from contourlab.loop import Controller, Machine


def plugin_digests(machines: Iterable[Machine], controller: Controller) -> list[str]:
    """Return name and SHA-256 of the file of each component of machines and their controller that comes from a plugin or another package.

    What such a file imports of its own is not looked at.
    """
    from contourlab.loop.machine import AXIS_SLOTS, CONTROLLER_SLOTS

    parts = [getattr(axis, slot) for machine in machines for axis in machine.axes for slot in AXIS_SLOTS]
    for mine in controller.axes.values():
        parts += [*(getattr(mine, slot) for slot in CONTROLLER_SLOTS), *(part for _, part in mine.others)]
        parts += [] if mine.link is None else [mine.link.down, mine.link.up]
    parts += [controller.estimator, controller.coupling]
    modules = {type(part).__module__ for part in parts if part is not None}
    files = [sys.modules[name].__file__ for name in sorted(modules) if name.partition(".")[0] != "contourlab"]
    return [f"{Path(file).name} {hashlib.sha256(Path(file).read_bytes()).hexdigest()}" for file in files if file is not None]
