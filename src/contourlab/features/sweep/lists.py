"""Lists of measured values: a CSV or Parquet file whose columns are parameters, one row for each machine or module."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from contourlab.errors import ScenarioError, error_text
from contourlab.extras import extra_module
from contourlab.features.sweep.distributions import Variation
from contourlab.features.sweep.structures import HEADS
from contourlab.findings import Finding, finding
from contourlab.scenario.tree import Leaf, Table

_HEAD = re.compile(r"\s*(.*?)\s*(?:\[([^\]]*)\])?\s*\Z", re.DOTALL)


def read_list(leaf: Leaf, folder: Path) -> tuple[tuple[Variation, ...], tuple[Finding, ...]]:
    """Return the columns of a list as entries of ``[vary]``, and what was left out.

    Parameters
    ----------
    leaf : Leaf
        Name of the file in the study.
    folder : Path
        Folder of the study.

    Raises
    ------
    ScenarioError
        If the file cannot be read, has an empty cell, or no column is a parameter.

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
        items = column.to_pylist()
        for row, item in enumerate(items, 1):
            if item is None or item != item or item == "":
                raise at.error(f"row {row} is empty: write a value, or delete the row")
        if unit and not any(isinstance(item, str) for item in items):
            items = [f"{item!r} {unit}" for item in items]
        found.append(Variation(name, at, "values", tuple(items), listed=True))
    if not found or not table.num_rows:
        raise leaf.error(f'{leaf.value}: no values: name each column as a parameter with its unit, such as "axes.x.plant.mass [kg]"')
    return tuple(found), ((finding("CL924", file=str(leaf.value), columns=tuple(others)),) if others else ())


def _table(leaf: Leaf, folder: Path) -> Any:
    """Return the file as an Arrow table."""
    arrow = extra_module("pyarrow")
    if not isinstance(leaf.value, str) or Path(leaf.value).suffix.lower() not in (".csv", ".parquet"):
        raise leaf.error(f"{leaf.value!r:.60}: write the name of a .csv or .parquet file")
    file = folder / leaf.value
    if not file.exists():
        raise leaf.error(f"no file {leaf.value!r} in {folder.as_posix()}")
    try:
        if file.suffix.lower() == ".csv":
            return _csv(file)
        table = extra_module("pyarrow.parquet").read_table(file)
    except (OSError, arrow.ArrowException) as error:
        raise ScenarioError(f"{leaf.value}: cannot be read: {error_text(error)}", file=leaf.file, key=leaf.key) from error
    units = [(one.metadata or {}).get(b"unit", b"").decode() for one in table.schema]
    return table.rename_columns([f"{name} [{unit}]" if unit else name for name, unit in zip(table.column_names, units, strict=True)])


def _csv(file: Path) -> Any:
    """Return a table with commas, or with semicolons, which allow decimal commas."""
    csv, data = extra_module("pyarrow.csv"), file.read_bytes()
    semicolons = b";" in data.partition(b"\n")[0]
    comma = semicolons and b"," in data
    options = csv.ParseOptions(delimiter=";" if semicolons else ",")
    return csv.read_csv(file, parse_options=options, convert_options=csv.ConvertOptions(decimal_point="," if comma else "."))
