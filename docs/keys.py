"""The page of all keys of tables in scenario, machine and controller files, made from the classes that hold them."""

from __future__ import annotations

import inspect
import json
import math
from collections.abc import Callable
from dataclasses import MISSING, Field
from pathlib import Path
from typing import Any, Literal, get_args, get_origin

from markup import plain
from numpydoc.docscrape import NumpyDocString

from contourlab.contours.reader import ContourOptions, read_contour
from contourlab.loop import Axis, AxisController, AxisError, Change, Division, Limits, Machine
from contourlab.program import Reading
from contourlab.scenario import PartProgram
from contourlab.scenario.quantities import show_bound
from contourlab.scenario.tables import keys_of, written
from contourlab.scenario.values import Contour, FeedSettings, LearningSettings, RunSettings
from contourlab.units import Setting

HEAD = """\
# Keys of tables

Every key with a fixed meaning, with unit, bounds and default. [Scenario files](scenario-files.md) shows how they are used, and
[Components](components.md) lists the keys of components.
"""
TABLES: dict[str, tuple[tuple[type, Callable[..., Any]], ...]] = {
    "`[feed]`": ((FeedSettings, FeedSettings),),
    "`[run]`": ((RunSettings, RunSettings),),
    "an item of changes in `[run]`": ((Change, Change),),
    "`[learning]`": ((LearningSettings, LearningSettings),),
    "`[program]`": ((PartProgram, PartProgram), (Reading, Reading)),
    "`[contour]` from a file": ((Contour, Contour), (ContourOptions, read_contour)),
    "`[machine]`": ((Machine, Machine),),
    "`[axes.NAME]`": ((Axis, Axis),),
    "`[axes.NAME.limits]`": ((Limits, Limits),),
    "`[axes.NAME.error]`": ((AxisError, AxisError),),
    "`[controller.axes.NAME]`": ((AxisController, AxisController),),
    "`[controller.axes.NAME.link]`": ((Division, Division),),
}
"""The classes whose fields are the keys of a table, each with what documents it."""


def keys_page() -> str:
    """Return the page of all tables."""
    parts = [HEAD]
    for table, kinds in TABLES.items():
        rows = []
        for kind, documented in kinds:
            doc = NumpyDocString(inspect.getdoc(documented) or "")
            entries = [*doc["Parameters"], *doc["Attributes"]]
            meanings = {name: " ".join(entry.desc) for entry in entries for name in entry.name.split(", ")}
            for name, (field, forms, about) in keys_of(kind).items():
                rows.append(
                    f"| `{name}` | {plain(_form(forms, about))} | {_default(field, about)} | {plain(meanings.get(field.name, ''))} |"
                )
        parts.append("\n".join([f"## {table}\n", "| key | value | default | meaning |", "|---|---|---|---|", *rows]) + "\n")
    return "\n".join(parts)


def _form(forms: tuple[Any, ...], about: Setting) -> str:
    """Describe the values that a key may have."""
    choices = about.choices or (get_args(forms[0]) if get_origin(forms[0]) is Literal else ())
    if choices or bool in forms:
        words = " or ".join(map(json.dumps, choices or (True, False)))
        return f"a list of {words}" if (str, ...) in map(get_args, forms) else words
    if (str, ...) in map(get_args, forms):
        return "a list of texts"
    bound = show_bound(about.minimum, about.maximum, about.exclusive, about.display or about.unit)
    if int in forms:
        return f"a whole number {bound}"
    if about.unit:
        what = "a quantity" if float in forms else "a list of quantities"
        return f"{what}, for example in {about.display or about.unit}" if bound == "finite" else f"{what} {bound}"
    return f"a number {bound}" if float in forms else "a file name" if Path in forms else "text"


def _default(field: Field[Any], about: Setting) -> str:
    none = (MISSING, None, (), "", math.inf, (-math.inf, math.inf))
    return "" if field.default in none else f"`{json.dumps(written(field.default, about))}`"
