"""The types of what the commands print with ``--json``: those that their questions return."""

from __future__ import annotations

import inspect
from functools import reduce
from importlib import import_module
from operator import or_
from pathlib import Path
from typing import Any, get_type_hints

from contourlab.app.session import Command
from contourlab.app.shared_options import Shown
from contourlab.cli.parse import PANEL_OF, home_of


def results() -> dict[str, Any]:
    """Return the type of the result of each command that has ``--json``."""
    from contourlab.features.check.canon import Canon
    from contourlab.features.components.description import ComponentDescription
    from contourlab.features.machines.command import Shipped
    from contourlab.findings import Entry

    of_lists = {
        "canon": Canon,
        "components": tuple[ComponentDescription, ...],
        "explain": tuple[Entry, ...],
        "machines": Shipped | tuple[Shipped, ...] | tuple[Path, ...],
    }
    types = {name: of_lists.get(name) or _printed(import_module(home_of(name)).COMMANDS[name]) for name in PANEL_OF if name != "schema"}
    return {name: kind for name, kind in sorted(types.items()) if kind is not None}


def _printed(command: Any) -> Any:
    """Return the type that a command or group prints; None without ``--json``."""
    members = [command] if isinstance(command, Command) else command.members.values()
    kinds: list[Any] = []
    for member in members:
        if issubclass(member.files, Shown):
            module, _, function = member.ask.partition(":")
            home = import_module(module)
            ask = inspect.unwrap(getattr(home, function))
            ask = getattr(ask, "func", ask)  # the question of one paper is part of another
            kinds += [getattr(home, word) for word in ask.__annotations__["return"].split(" | ")]
    own = [get_type_hints(kind.json.fget)["return"] if "json" in vars(kind) else kind for kind in kinds]
    return reduce(or_, dict.fromkeys(own)) if own else None
