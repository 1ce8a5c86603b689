"""What a study varies: entries of ``[vary]``, columns of files of measured values, and populations of modules in ``[modules]``."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.components.contract import Parameter
from contourlab.errors import ScenarioError, UnitError, error_text, refuse
from contourlab.extras import extra_module
from contourlab.findings import Finding, finding
from contourlab.scenario.load import SCHEME_KEYS
from contourlab.scenario.quantities import read_number
from contourlab.scenario.tables import keys_of, read_values
from contourlab.scenario.tree import Leaf, Node, Table, located
from contourlab.study.space import Distribution
from contourlab.units import setting

FORMS = {
    "normal": '["80 kg", "4 kg"], mean and standard deviation',
    "lognormal": '["80 kg", 0.2], median and standard deviation of the logarithm',
    "uniform": '["70 kg", "90 kg"], lowest and highest value',
    "log-uniform": '["70 kg", "90 kg"], lowest and highest value, both above 0',
    "triangular": '["70 kg", "80 kg", "95 kg"], lowest, likeliest and highest value',
    "values": '["70 kg", "80 kg"]',
}
"""Kinds of distributions, each with its form in a study file."""
HEADS = ("scheme", "contour", "program", *(key for key in SCHEME_KEYS if key != "learning"))
"""First words of keys of the scenario file that a study can vary."""


@dataclass(frozen=True)
class Variation:
    """An entry of ``[vary]``, as written.

    Attributes
    ----------
    key : str
        Name or pattern of parameters, or a key of the scenario file.
    table : Table
        Kind of distribution, and options.
    kind : str
        One of `FORMS`.
    items : tuple
        Numbers of the distribution as written; choices may be tables.
    weights : tuple of float
        Relative probabilities of `items`; empty for equal ones.
    steps : int
        Number of evenly spaced values of a grid; 0 for none.
    together : bool
        Whether all parameters that a pattern matches share one draw.
    """

    key: str
    table: Table
    kind: str
    items: tuple[Any, ...]
    weights: tuple[float, ...] = field(default=(), metadata=setting())
    steps: int = field(default=0, metadata=setting(minimum=2))
    together: bool = False

    @property
    def listed(self) -> bool:
        """Whether the items are a column of a file."""
        return not self.table.entries


def read_variations(table: Table) -> tuple[Variation, ...]:
    """Read ``[vary]``; keys may be quoted, ``"axes.x.plant.mass"``, or tables in tables, as TOML reads bare dotted keys.

    Raises
    ------
    ScenarioError
        If an entry is not a distribution; gives file and key.
    """
    return tuple(_variation(key, node) for key, node in _entries(table, "", _is_distribution))


def _is_distribution(table: Table) -> bool:
    return any(isinstance(node, Leaf) or name in FORMS for name, node in table.entries.items())


def _entries(table: Table, prefix: str, is_entry: Callable[[Table], bool]) -> Iterator[tuple[str, Node]]:
    """Yield the values and entries of a table by their dotted keys; other tables are parts of keys."""
    for name, node in table.entries.items():
        key = f"{prefix}.{name}" if prefix else name
        if isinstance(node, Leaf) or is_entry(node):
            yield key, node
        else:
            yield from _entries(node, key, is_entry)


def _no_distribution(node: Leaf) -> ScenarioError:
    return node.error(f'{node.value!r:.60} is not a distribution: write {{ normal = ["80 kg", "4 kg"] }}')


def _variation(key: str, table: Node) -> Variation:
    if isinstance(table, Leaf):
        raise _no_distribution(table)
    kinds = [name for name in table.entries if name in FORMS]
    for name, node in table.entries.items():
        if name not in (*FORMS, "within", *keys_of(Variation)) and isinstance(node, Leaf) and not isinstance(node.value, list):
            raise _no_distribution(node)
    options = read_values(table, Variation, parts=(*FORMS, "within"))
    refuse(len(kinds) != 1, table.error, f"{len(kinds)} distributions: write one of {', '.join(FORMS)}")
    kind = kinds[0]
    items, count = _list(table, kind), {"values": 0, "triangular": 3}.get(kind, 2)
    if not items or (count and len(items) != count):
        raise table.error(f"write {kind} = {FORMS[kind]}", kind)
    made = Variation(key, table, kind, items, **options)
    if made.weights and (kind != "values" or len(made.weights) != len(items) or min(made.weights) < 0.0 or not sum(made.weights) > 0.0):
        raise table.error("write one weight, 0 or more, for each of the values, not all 0", "weights")
    if made.steps and kind not in ("uniform", "log-uniform"):
        raise table.error("applies to uniform and log-uniform only: leave this out", "steps")
    return made


def _list(table: Table, name: str) -> tuple[Any, ...]:
    items = table.entries[name].plain()
    if not isinstance(items, list):
        raise table.error(f"write a list: {name} = {FORMS.get(name, '[...]')}", name)
    return tuple(items)


# --- distributions of one parameter ----------------------------------------------------------------------------------------------------


def distribution(variation: Variation, parameter: Parameter, present: float) -> Distribution:
    """Return the distribution of one parameter, cut at its bounds.

    Parameters
    ----------
    variation : Variation
    parameter : Parameter
        With the units of its plant.
    present : float [SI]
        Value in the scenario, for values in ``%`` of it.

    Raises
    ------
    ScenarioError
        If a number cannot be read or is out of range; gives file and key.
    """
    table, kind = variation.table, variation.kind
    with located(table, kind):
        numbers = [_number(item, parameter, present, bare=kind == "lognormal" and i == 1) for i, item in enumerate(variation.items)]
        _check(kind, numbers)
        if kind in ("values", "uniform", "log-uniform", "triangular"):
            for number in numbers:
                parameter.check(number)
    low, high = _bounds(table, parameter, present)
    if variation.steps:
        spaced = np.linspace if kind == "uniform" else np.geomspace
        return Distribution("values", tuple(spaced(numbers[0], numbers[1], variation.steps).tolist()))
    if kind == "values":
        return Distribution(kind, tuple(numbers), weights=variation.weights)
    made = Distribution(kind, tuple(numbers), low, high)
    if made.beyond > 1.0 - 1e-9 or (kind not in ("normal", "lognormal") and (numbers[0] >= high or numbers[-1] <= low)):
        raise table.error(f"lies outside of the bounds, {parameter.bound or 'finite'} or within: move it", kind)
    return made


def _number(item: Any, parameter: Parameter, present: float, bare: bool = False) -> float:
    if bare:
        return read_number(item, "")
    if isinstance(item, str) and item.rstrip().endswith("%"):
        if present == 0.0 or not math.isfinite(present):
            raise UnitError(f"{item!r}: the scenario's value is {present:g}, which has no percentage: write a quantity")
        return present * read_number(item.rstrip()[:-1], "") / 100.0
    return read_number(item, parameter.unit, parameter.display)


def _check(kind: str, numbers: Sequence[float]) -> None:
    """Refuse numbers that make no distribution."""
    first, last = numbers[0], numbers[-1]
    refuse(kind in ("normal", "lognormal") and not last > 0.0, UnitError, "write a standard deviation above 0")
    if kind in ("lognormal", "log-uniform") and not first > 0.0:
        raise UnitError(f"write values above 0, or the distribution {kind.removeprefix('log-').removeprefix('log')}")
    if kind in ("uniform", "log-uniform", "triangular") and not (first < last and list(numbers) == sorted(numbers)):
        raise UnitError("write the values in order, the lowest first")


def _bounds(table: Table, parameter: Parameter, present: float) -> tuple[float, float]:
    low = math.nextafter(parameter.minimum, math.inf) if parameter.exclusive else parameter.minimum
    if "within" not in table.entries:
        return low, parameter.maximum
    with located(table, "within"):
        ends = [_number(item, parameter, present) for item in _list(table, "within")]
    refuse(len(ends) != 2 or not ends[0] < ends[1], table.error, 'write the lowest and the highest value: ["70 kg", "90 kg"]', "within")
    return max(low, ends[0]), min(parameter.maximum, ends[1])


_HEAD = re.compile(r"\s*(.*?)\s*(?:\[([^\]]*)\])?\s*\Z", re.DOTALL)


def read_list(leaf: Leaf, folder: Path, modules: str = "") -> tuple[tuple[Variation, ...], tuple[Finding, ...]]:
    """Return the columns of a list as entries of ``[vary]``, and what was left out.

    Parameters
    ----------
    leaf : Leaf
        Name of the file in the study.
    folder : Path
        Folder of the study.
    modules : str
        Modules that the rows are, if any.

    Raises
    ------
    ScenarioError
        If the file cannot be read, has an empty cell, no column is a parameter, or one is no part of the modules.

    Notes
    -----
    A column is a parameter if its name has a dot or is a key of the scenario, such as ``program``; its unit is in brackets. Other columns,
    such as a serial number, are left out.
    """
    table = _table(leaf, folder)
    found, others = [], []
    for head, column in zip(table.column_names, table.columns, strict=True):
        name, unit = _HEAD.match(head).groups(default="")  # type: ignore[union-attr]
        if "." not in name and name not in HEADS:
            others.append(head)
            continue
        at = Table({}, str(leaf.value), head)
        if modules and not belongs(name, modules):
            raise at.error(f"is no part of the modules {modules}: its name must begin with {modules}.")
        items = column.to_pylist()
        for row, item in enumerate(items, 1):
            if item is None or item != item or item == "":
                raise at.error(f"row {row} is empty: write a value, or delete the row")
        if unit and not any(isinstance(item, str) for item in items):
            items = [f"{item!r} {unit}" for item in items]
        found.append(Variation(name, at, "values", tuple(items)))
    if not found or not table.num_rows:
        raise leaf.error(f'{leaf.value}: no values: name each column as a parameter with its unit, such as "axes.x.plant.mass [kg]"')
    return tuple(found), ((finding("CL924", file=str(leaf.value), columns=tuple(others)),) if others else ())


def _table(leaf: Leaf, folder: Path) -> Any:
    """Return the file as an Arrow table."""
    arrow = extra_module("pyarrow")
    if not isinstance(leaf.value, str) or Path(leaf.value).suffix.lower() not in (".csv", ".parquet"):
        raise leaf.error(f"{leaf.value!r:.60}: write the name of a .csv or .parquet file")
    file = folder / leaf.value
    refuse(not file.exists(), leaf.error, f"no file {leaf.value!r} in {folder.as_posix()}")
    try:
        if file.suffix.lower() == ".csv":
            return _csv(file)
        table = extra_module("pyarrow.parquet").read_table(file)
    except (OSError, arrow.ArrowException) as error:
        raise ScenarioError(f"{leaf.value}: cannot be read: {error_text(error)}", file=leaf.file, key=leaf.key) from error
    return table.rename_columns(heads_of(table.schema))


def heads_of(schema: Any) -> list[str]:
    """Return the names of the columns of an Arrow schema, each with its unit in brackets."""
    units = [(field.metadata or {}).get(b"unit", b"").decode() for field in schema]
    return [f"{name} [{unit}]" if unit else name for name, unit in zip(schema.names, units, strict=True)]


def _csv(file: Path) -> Any:
    """Return a table with commas, or with semicolons, which allow decimal commas."""
    csv, data = extra_module("pyarrow.csv"), file.read_bytes()
    semicolons = b";" in data.partition(b"\n")[0]
    comma = semicolons and b"," in data
    options = csv.ParseOptions(delimiter=";" if semicolons else ",")
    return csv.read_csv(file, parse_options=options, convert_options=csv.ConvertOptions(decimal_point="," if comma else "."))


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
    leaves = {key: node for key, node in _entries(content.table("modules"), "", lambda table: False) if isinstance(node, Leaf)}
    for name, leaf in leaves.items():
        value = leaf.value
        if isinstance(value, bool) or not (isinstance(value, str) or (isinstance(value, int) and 2 <= value <= MOST)):
            raise leaf.error(f"{value!r:.60}: write the number of modules, 2 to {MOST}, or a .csv or .parquet file with a row for each")
        refuse(any(belongs(name, other) for other in leaves if other != name), leaf.error, "belongs to other modules as well: delete one")
    return leaves
