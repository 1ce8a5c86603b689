"""The public surface: names, signatures and docstrings.

``PYTHONPATH=tests/helpers python tests/unit/test_public_surface.py`` rewrites `SURFACE` after an intended change; review its diff.
"""

from __future__ import annotations

import ast
import importlib
import inspect
import re
import sys
import textwrap
from functools import cache, cached_property
from pathlib import Path
from types import CodeType
from typing import Any

from each import each
from numpydoc.docscrape import NumpyDocString, get_doc_object
from numpydoc.validate import Validator, validate

import contourlab
from contourlab import errors
from contourlab.app.session import Answer

sys.path.append(str(Path(__file__).parents[2] / "docs"))
import api
from api import function_of, members

SURFACE = Path(__file__).with_name("public_surface.txt")
NAMES = [name for name in contourlab.__all__ if not name.startswith("__")]
TYPES = sorted(api.types())
"""Classes that public names take, return or hold."""
FORM = {"GL05", "GL06", "GL07", "GL08", "SS01", "SS02", "SS03", "SS04", "SS06", "PR02", "PR03", "PR05", "PR06"}
"""What numpydoc checks of every docstring: https://numpydoc.readthedocs.io lists the codes."""
COMPLETE = FORM | {"PR01", "PR04", "RT01"}
"""And of a function: every parameter, its type, and what it returns."""
NUMBER, ARRAY = re.compile(r"(float|ArrayLike|Array)( \| None)?"), re.compile(r"(ArrayLike|Array)( \| None)?")
WITHOUT_UNIT = {
    "alignment",
    "command",
    "curvature_step",
    "divergence",
    "factor",
    "feedrate_ripple",
    "forgetting",
    "gain",
    "growth_margin",
    "improvement",
    "index",
    "lap",
    "limited",
    "modulus",
    "norm",
    "override",
    "radius",
    "scale",
    "scale_mismatch",
    "share",
    "singular_values",
    "strength",
    "unsure",
    "width",
    "within",
    "worst_factor",
}
"""Numbers that are ratios, factors or counts."""


def thing(name: str) -> Any:
    """Return a public object by its name."""
    return getattr(contourlab, name) if "." not in name else api.types()[name]


class Docstring(Validator):  # type: ignore[misc]
    """A docstring without its place in a file: nothing is excepted by a comment there, and to find it takes most of the time."""

    source_file_name = source_file_def_line = None

    def __init__(self, obj_name: Any) -> None:
        super().__init__(obj_name)


def faults_of(target: Any, codes: set[str]) -> list[str]:
    return [f"{code} {text}" for code, text in validate(get_doc_object(target), Docstring)["errors"] if code in codes]


@cache
def docstring_of(target: Any) -> NumpyDocString:
    return NumpyDocString(inspect.getdoc(target) or "")


def documented(target: Any) -> dict[str, str]:
    """Return the type and text of each parameter and attribute in the docstring."""
    doc = docstring_of(target)
    listed = [*doc["Parameters"], *doc["Attributes"]]
    return {name.strip(" *"): f"{entry.type} {' '.join(entry.desc)}" for entry in listed for name in entry.name.split(",")}


def parameters(target: Any) -> dict[str, inspect.Parameter]:
    """Return the parameters of a function or of a class; a component documents its own with `param`; a question makes its answer."""
    if inspect.isclass(target) and issubclass(target, (Exception, contourlab.Component, Answer)):
        return {}
    return dict(inspect.signature(target).parameters)


def names_of(code: CodeType) -> set[str]:
    """Return the names that a function and those in it read from around them."""
    return set(code.co_names).union(*(names_of(inner) for inner in code.co_consts if inspect.iscode(inner)))


def raised(function: Any) -> set[str]:
    """Return the errors of contourlab that a function itself raises."""
    if not names_of(function.__code__) & set(errors.__all__):
        return set()
    tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
    calls = (node.exc for node in ast.walk(tree) if isinstance(node, ast.Raise))
    return {call.func.id for call in calls if isinstance(call, ast.Call) and isinstance(call.func, ast.Name)} & set(errors.__all__)


def allowed(function: Any) -> set[str]:
    """Return the errors that a docstring covers, those derived from them too."""
    entries = docstring_of(function)["Raises"]
    named = [name for entry in entries for name in (entry.type or entry.name).split(", ")]
    kinds = tuple(getattr(errors, name) for name in named if name in errors.__all__)
    return {name for name in errors.__all__ if issubclass(getattr(errors, name), kinds)}


@each("name", NAMES)
def test_a_name_is_at_home_where_it_is_looked_up(name: str):
    home = importlib.import_module(contourlab._WHERE[name])
    assert getattr(home, name) is thing(name)


@each("name", [*NAMES, *TYPES])
def test_a_docstring_has_numpys_form_and_is_complete(name: str):
    target = thing(name)
    if inspect.isfunction(target):
        assert not faults_of(target, COMPLETE)
        return
    assert not faults_of(target, FORM)
    assert not set(parameters(target)) - set(documented(target))
    for member, value in members(target):
        function = function_of(value)
        assert not [f"{member}: {fault}" for fault in faults_of(function, FORM)]
        if re.search(r"\b(Array|ArrayLike|Index|Flags)\b", str(function.__annotations__)):
            assert re.search(r"\((n|\d|order)", inspect.getdoc(function)), f"{member}: no shape"


@each("name", [*NAMES, *TYPES])
def test_a_physical_quantity_has_a_unit_and_an_array_a_shape(name: str):
    target = thing(name)
    entries = documented(target)
    for parameter in parameters(target).values():
        kind, text = str(parameter.annotation), entries.get(parameter.name, "")
        if ARRAY.fullmatch(kind):
            assert "(n" in text or "(2,)" in text or "(3,)" in text, parameter.name
        if NUMBER.fullmatch(kind) and parameter.name not in WITHOUT_UNIT:
            assert re.search(r"\[[^\]]+\]", text), parameter.name


@each("name", [*NAMES, *TYPES])
def test_a_docstring_names_the_errors(name: str):
    target = thing(name)
    functions = [target] if inspect.isfunction(target) else [function_of(member) for _, member in members(target)]
    for function in functions:
        assert raised(function) <= allowed(function), function.__qualname__
    if inspect.isclass(target):
        hooks = [vars(target)[hook] for hook in ("__init__", "__post_init__") if inspect.isfunction(vars(target).get(hook))]
        assert {error for hook in hooks for error in raised(hook)} <= allowed(target)


def signature(target: Any) -> str:
    """Return the parameters, and the type that comes back."""
    parts, star = [], False
    for parameter in parameters(target).values():
        if parameter.kind is inspect.Parameter.KEYWORD_ONLY and not star:
            parts.append("*")
        star |= parameter.kind in (inspect.Parameter.KEYWORD_ONLY, inspect.Parameter.VAR_POSITIONAL)
        prefix = {inspect.Parameter.VAR_POSITIONAL: "*", inspect.Parameter.VAR_KEYWORD: "**"}.get(parameter.kind, "")
        kind = "" if parameter.annotation is inspect.Parameter.empty else f": {parameter.annotation}"
        default = getattr(parameter.default, "__name__", repr(parameter.default))
        parts.append(f"{prefix}{parameter.name}{kind}" + ("" if parameter.default is inspect.Parameter.empty else f" = {default}"))
    result = "" if inspect.isclass(target) else f" -> {inspect.signature(target).return_annotation}"
    return f"({', '.join(parts)}){result}"


def surface() -> str:
    """Return every public name with its signature."""
    lines = []
    for name in NAMES:
        target = thing(name)
        lines.append(f"{'class ' if inspect.isclass(target) else ''}{name}{signature(target)}")
        for member, value in sorted(members(target)) if inspect.isclass(target) else ():
            is_value = isinstance(value, property | cached_property)
            lines.append(f"    {name}.{member}{'' if is_value else signature(function_of(value))}")
    return "\n".join(lines) + "\n"


def test_the_surface_is_as_agreed():
    agreed = SURFACE.read_text(encoding="utf-8").splitlines()
    assert surface().splitlines() == agreed, "if it should change: PYTHONPATH=tests/helpers python tests/unit/test_public_surface.py"


def test_every_type_in_a_signature_and_every_error_has_a_page():
    page = api.api_page()
    for name in [*NAMES, *TYPES]:
        target = thing(name)
        held = members(target) if inspect.isclass(target) and not issubclass(target, Answer) else ()
        for function in (target, *(function_of(member) for _, member in held)):
            scope = {**vars(sys.modules[target.__module__]), **vars(errors)}
            raises = [entry.type or entry.name for entry in docstring_of(function)["Raises"]]
            for word in re.findall(r"\b[A-Z]\w+", f"{signature(function)} {' '.join(raises)}"):
                kind = scope.get(word)
                if inspect.isclass(kind) and kind.__module__.startswith("contourlab.") and not getattr(kind, "kind", ""):
                    home = kind.__module__.removeprefix("contourlab.")
                    assert re.search(rf"^   (~{home}\.)?{word}$", page, re.MULTILINE), f"{name}: {word}"


if __name__ == "__main__":
    SURFACE.write_text(surface(), encoding="utf-8")
