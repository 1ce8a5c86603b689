"""Read component tables: ``kind`` and the parameters that the component declares."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from contourlab.components.contract import Component, Parameter
from contourlab.components.origin import Origin
from contourlab.components.registry import component, components
from contourlab.errors import ComponentError, UnitError, hint
from contourlab.scenario.provenance import bare, read_origins
from contourlab.scenario.quantities import in_range, read_list, read_number
from contourlab.scenario.tree import Leaf, Node, Table, located

WORKED_OUT = Origin("design", note="computed from gains = {...}")


def parameters_of(kind: type[Component], units: tuple[str, str]) -> dict[str, Parameter]:
    """Return the parameters of a component for a plant with these units of command and force."""
    return {name: parameter.for_plant(*units) for name, parameter in kind.parameters.items()}


def _as_table(node: Node, family: str) -> Table:
    """Return the table of a component; ``drive = "saturation"`` is short for a table with that kind."""
    if isinstance(node, Table):
        return node
    if not isinstance(node.value, str):
        raise node.error(f'{node.value!r} is not a valid {family}: write a table with kind = "..." and parameters')
    return Table({"kind": node}, node.file, node.key)


def find_kind(table: Table, family: str) -> type[Component]:
    """Return the component that a table names."""
    node = table.get("kind")
    if not isinstance(node, Leaf) or not isinstance(node.value, str):
        names = ", ".join(kind.kind for kind in components(family))
        raise table.error(f"{'key kind is missing: ' if node is None else ''}write one of {names}", "" if node is None else "kind")
    try:
        return component(family, node.value)
    except ComponentError as error:
        raise node.error(str(error)) from None


def read_component(
    node: Node, family: str, units: tuple[str, str], *, optional: bool = False, given: Mapping[str, float] | None = None
) -> Any:
    """Read a component.

    Parameters
    ----------
    node : Node
        Table, or name of the kind.
    units : (str, str)
        Units of the plant's command and force.
    optional : bool
        Whether ``"none"`` is allowed.
    given : mapping, optional
        Computed values in SI; the table's own have priority.

    Raises
    ------
    ScenarioError
        If the content is invalid; gives file and key.
    """
    table = _as_table(node, family)
    kind_node = table.get("kind")
    if optional and isinstance(kind_node, Leaf) and kind_node.value == "none":
        extra = [name for name in table.entries if name != "kind"]
        if extra:
            raise table.error('kind "none" has no parameters: delete this one', extra[0])
        return None
    kind = find_kind(table, family)
    own = table.without("kind")
    values = {**(given or {}), **read_parameters(kind, own, units)}
    declared = parameters_of(kind, units)
    origins = {name: WORKED_OUT for name in given or () if name not in own.entries} | read_origins(declared, own, values)
    if missing := _missing(declared, values):
        raise table.error(f"{kind.kind} needs values for {missing}")
    with located(table):
        return kind(**values).traced(origins)


def _missing(declared: Mapping[str, Parameter], values: Mapping[str, Any]) -> str:
    """Return names and units of the parameters that have neither value nor default."""
    missing = {name: parameter for name, parameter in declared.items() if parameter.default is None and name not in values}
    return ", ".join(f"{name} [{parameter.display}]" if parameter.display else name for name, parameter in missing.items())


def read_parameters(kind: type[Component], table: Table, units: tuple[str, str]) -> dict[str, Any]:
    """Read the parameters of a table in SI.

    Raises
    ------
    ScenarioError
        If one is unknown, has the wrong unit, or is out of range.
    """
    return _read_declared(kind.kind, parameters_of(kind, units), table)


def read_wishes(kind: type[Component], table: Table, units: tuple[str, str]) -> dict[str, float]:
    """Read ``gains = {...}``, from which a component computes its parameters, in SI.

    Raises
    ------
    ScenarioError
        If one is missing, unknown, has the wrong unit, or is out of range.
    """
    declared = {name: replace(parameter, name=name).for_plant(*units) for name, parameter in kind.wishes.items()}
    given = _read_declared(f"gains of {kind.kind}", declared, table)
    if missing := _missing(declared, given):
        raise table.error(f"gains of {kind.kind} need values for {missing}")
    return {name: given.get(name, parameter.default) for name, parameter in declared.items()}


def _read_declared(what: str, declared: Mapping[str, Parameter], table: Table) -> dict[str, Any]:
    values: dict[str, Any] = {}
    for name, node in table.entries.items():
        if name not in declared:
            raise table.error(f"{what} has no parameter {name!r}: {hint(name, declared)}", name)
        with located(table, name):
            values[name] = _value(declared[name], bare(node).plain())
    return values


def _value(parameter: Parameter, given: Any) -> Any:
    if parameter.choices:
        if not isinstance(given, str) or given not in parameter.choices:
            raise UnitError(f"{given!r}: must be {parameter.bound}")
        return given
    if parameter.vector:
        numbers = read_list(given, parameter.unit, parameter.display)
        if not numbers:
            raise UnitError("the list is empty: write at least one value")
        scalar = replace(parameter, vector=False)
        return tuple(in_range(number, scalar, f"item {i + 1}") for i, number in enumerate(numbers))
    return in_range(read_number(given, parameter.unit, parameter.display), parameter, repr(given))
