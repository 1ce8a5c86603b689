"""Controllers that take over while a scenario runs: ``changes`` in ``[run]``."""

from __future__ import annotations

from dataclasses import replace

from contourlab.loop import Change, Machine
from contourlab.scenario.build import build_controller
from contourlab.scenario.components import located
from contourlab.scenario.files import Reader, join
from contourlab.scenario.tables import ChangeTable, RunTable, read_table
from contourlab.scenario.tree import Leaf, Table, from_mapping, settle


def read_changes(run: Table, machine: Machine, reader: Reader) -> tuple[Change, ...]:
    """Return the changes that a table ``run`` asks for, their controllers read and checked.

    Raises
    ------
    ScenarioError
        With file and key.
    """
    given = read_table(RunTable, run).changes
    node = run.get("changes")
    found = []
    for i, item in enumerate(given):
        assert isinstance(node, Leaf)  # what the table's own check has read
        if not isinstance(item, dict):
            raise node.error(f'{item!r}: {{at = "2 s", controller = "other.toml"}} is wanted')
        table = from_mapping(item, node.file, f"{node.key}[{i}]")
        plain = read_table(ChangeTable, table)
        leaf = table.entries["controller"]
        assert isinstance(leaf, Leaf)
        content = replace(reader, names=machine.axis_names).include(leaf, Reader.controller_file)
        controller = build_controller(settle(join(content, Table({}, content.file, content.key), machine.axis_names)), machine)
        with located(table):
            found.append(Change(plain.at, controller, plain.handover_time, content.file))
    return tuple(found)
