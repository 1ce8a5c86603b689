"""Populations of modules in a study file: ``[modules]`` says how many are drawn, or which file lists them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from contourlab.features.sweep.distributions import Variation
from contourlab.features.sweep.lists import read_list
from contourlab.features.sweep.structures import Structured
from contourlab.findings import Finding
from contourlab.scenario.tree import Leaf, Table
from contourlab.study.design import Modules

MOST = 10**6
"""Largest number of modules of a kind."""


def belongs(name: str, modules: str) -> bool:
    """Return whether a parameter or key belongs to the modules of a kind.

    >>> belongs("axes.x.plant.mass", "axes.x")
    True
    """
    return name == modules or name.startswith(modules + ".")


def module_entries(content: Table) -> dict[str, Leaf]:
    """Return the entries of ``[modules]``, by name; bare dotted keys are tables in tables.

    Raises
    ------
    ScenarioError
        If an entry is neither a number nor a file, or one is part of another; gives file and key.
    """
    found = dict(_flat(content.table("modules"), ""))
    for name, leaf in found.items():
        value = leaf.value
        if isinstance(value, bool) or not (isinstance(value, str) or (isinstance(value, int) and 2 <= value <= MOST)):
            raise leaf.error(f"{value!r:.60}: write the number of modules, 2 to {MOST}, or a .csv or .parquet file with a row for each")
        if any(belongs(name, other) for other in found if other != name):
            raise leaf.error("belongs to other modules as well: delete one")
    return found


def _flat(table: Table, prefix: str) -> Iterator[tuple[str, Leaf]]:
    for name, node in table.entries.items():
        key = f"{prefix}.{name}" if prefix else name
        if isinstance(node, Table):
            yield from _flat(node, key)
        else:
            yield key, node


def listed_modules(entries: dict[str, Leaf], folder: Path) -> tuple[tuple[Variation, ...], tuple[Finding, ...]]:
    """Return what the files of modules vary; each row of a file is a module.

    Raises
    ------
    ScenarioError
        If a file cannot be read, or varies what is no part of its modules.
    """
    variations: list[Variation] = []
    findings: list[Finding] = []
    for name, leaf in entries.items():
        if isinstance(leaf.value, str):
            found, others = read_list(leaf, folder)
            for one in found:
                if not belongs(one.key, name):
                    raise one.table.error(f"is no part of the modules {name}: its name must begin with {name}.")
            variations += found
            findings += others
    return tuple(variations), tuple(findings)


def modules_of(entries: dict[str, Leaf], made: Structured) -> tuple[Modules, ...]:
    """Return the modules of each kind, with the dimensions of the design that are theirs.

    Raises
    ------
    ScenarioError
        If nothing of a module varies, or a draw is shared with something else; gives file and key.
    """
    found = []
    for name, leaf in entries.items():
        mine = {i: names for i, (names, _) in enumerate(made.dimensions) if any(belongs(one, name) for one in names)}
        if not mine:
            raise leaf.error(f"nothing varies that begins with {name}.: name the modules by the beginning of their parameters in [vary]")
        for names in mine.values():
            if other := next((one for one in names if not belongs(one, name)), None):
                raise leaf.error(f"{names[0]} and {other} share a draw: leave out together")
        listed = tuple(i for i, names in mine.items() if made.listed.issuperset(names))
        count = made.dimensions[listed[0]][1] if isinstance(leaf.value, str) else int(leaf.value)
        found.append(Modules(name, count, tuple(mine), listed))
    return tuple(found)
