"""Component tables: ``kind`` and the parameters that the component itself declares."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from contourlab.components.contract import Component, Parameter
from contourlab.components.origin import Origin
from contourlab.components.registry import component, components
from contourlab.errors import ComponentError, ParameterError, UnitError
from contourlab.scenario.provenance import bare, read_origins
from contourlab.scenario.quantities import read_list, read_number, show_bound
from contourlab.scenario.tree import Leaf, Node, Table, hint, located

WORKED_OUT = Origin("design", note="worked out from gains = {...}")


def parameters_of(kind: type[Component], units: tuple[str, str]) -> dict[str, Parameter]:
    """Return the parameters of a component that works with a plant whose command and force have these units."""
    return {name: parameter.for_plant(*units) for name, parameter in kind.parameters.items()}


def _as_table(node: Node, family: str) -> Table:
    """Return the table of a component; ``drive = "saturation"`` is short for a table with that kind."""
    if isinstance(node, Table):
        return node
    if not isinstance(node.value, str):
        raise node.error(f'{node.value!r} is no {family}: write a table with kind = "..." and its parameters')
    return Table({"kind": node}, node.file, node.key)


def find_kind(table: Table, family: str) -> type[Component]:
    """Return the component that a table names."""
    node = table.get("kind")
    names = [kind.kind for kind in components(family)]
    if node is None:
        raise table.error(f"key kind is missing: one of {', '.join(names)}")
    if not isinstance(node, Leaf) or not isinstance(node.value, str):
        raise table.error(f"text is wanted: one of {', '.join(names)}", "kind")
    try:
        return component(family, node.value)
    except ComponentError:
        raise node.error(f"no {family} {node.value!r}: {hint(node.value, names)}") from None


def read_component(
    node: Node, family: str, units: tuple[str, str], *, optional: bool = False, given: Mapping[str, float] | None = None
) -> Any:
    """Read a component.

    Parameters
    ----------
    node : Node
        Its table, or the name of its kind.
    family : str
    units : (str, str)
        Units of command and force of the plant it works with.
    optional : bool
        Whether ``"none"`` says that there is none.
    given : mapping, optional
        Values in SI that are worked out from elsewhere; the table's own go before.

    Returns
    -------
    Component or None

    Raises
    ------
    ScenarioError
        With file and key of what is wrong.
    """
    table = _as_table(node, family)
    kind_node = table.get("kind")
    if optional and isinstance(kind_node, Leaf) and kind_node.value == "none":
        extra = [name for name in table.entries if name != "kind"]
        if extra:
            raise table.error('kind "none" has no parameters', extra[0])
        return None
    kind = find_kind(table, family)
    own = table.without("kind")
    values = {**(given or {}), **read_values(kind, own, units)}
    declared = parameters_of(kind, units)
    origins = {name: WORKED_OUT for name in given or () if name not in own.entries} | read_origins(declared, own, values)
    missing = [name for name, parameter in declared.items() if parameter.default is None and name not in values]
    if missing:
        wanted = ", ".join(f"{name}{_wanted(declared[name])}" for name in missing)
        raise table.error(f"{kind.kind} wants {'a value' if len(missing) == 1 else 'values'} for {wanted}")
    with located(table):
        return kind(**values).traced(origins)


def _wanted(parameter: Parameter) -> str:
    return f" [{parameter.display}]" if parameter.display else ""


def read_values(kind: type[Component], table: Table, units: tuple[str, str]) -> dict[str, Any]:
    """Read the parameters that a table gives, in SI.

    Raises
    ------
    ScenarioError
        If one is unknown, has the wrong unit, or is out of range.
    """
    return _read_declared(kind.kind, parameters_of(kind, units), table)


def read_wishes(kind: type[Component], table: Table, units: tuple[str, str]) -> dict[str, float]:
    """Read ``gains = {...}``, from which a component works out its parameters: all that it asks for, in SI.

    Raises
    ------
    ScenarioError
        If one is missing, unknown, has the wrong unit, or is out of range.
    """
    declared = {name: replace(parameter, name=name).for_plant(*units) for name, parameter in kind.wishes.items()}
    given = _read_declared(f"gains of {kind.kind}", declared, table)
    missing = [f"{name}{_wanted(p)}" for name, p in declared.items() if p.default is None and name not in given]
    if missing:
        raise table.error(f"gains of {kind.kind} {'key is' if len(missing) == 1 else 'keys are'} missing: {', '.join(missing)}")
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
            raise UnitError("the list is empty")
        scalar = replace(parameter, vector=False)
        return tuple(_in_range(scalar, number, f"item {i + 1}") for i, number in enumerate(numbers))
    return _in_range(parameter, read_number(given, parameter.unit, parameter.display), repr(given))


def _in_range(parameter: Parameter, number: float, shown: str) -> float:
    try:
        return float(parameter.check(number))
    except ParameterError:
        bound = show_bound(parameter.minimum, parameter.maximum, parameter.exclusive, parameter.display)
        whole = "a whole number" + ("" if bound == "finite" else ", ") if parameter.whole else ""
        raise UnitError(f"{shown} is out of range: must be {whole}{'' if whole and bound == 'finite' else bound}") from None
