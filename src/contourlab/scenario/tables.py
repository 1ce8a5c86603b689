"""Tables of files that hold the fields of a class: one reader and one writer for all of them.

A key of a table is a field with `contourlab.units.setting` in its metadata, or a bool or a Literal. Its type says how it is written.
"""

from __future__ import annotations

import json
from collections.abc import Collection, Mapping
from dataclasses import Field, fields
from functools import cache
from pathlib import Path
from types import NoneType, UnionType
from typing import Any, Literal, NamedTuple, Union, get_args, get_origin, get_type_hints

import numpy as np

from contourlab.components.contract import Parameter
from contourlab.errors import UnitError, hint, refuse
from contourlab.scenario.files import named_in
from contourlab.scenario.provenance import with_origins, without_origins
from contourlab.scenario.quantities import in_range, quantity, read_list, read_number
from contourlab.scenario.tree import Table, located
from contourlab.units import Setting


class Key(NamedTuple):
    """A field, the types that its value may have besides None, and its setting."""

    field: Field[Any]
    forms: tuple[Any, ...]
    about: Setting


@cache
def keys_of(kind: type) -> Mapping[str, Key]:
    """Return the keys of the table that holds the fields of a dataclass."""
    keys, hints = {}, get_type_hints(kind)
    for field in fields(kind):
        form = hints[field.name]
        forms = tuple(item for item in get_args(form) if item is not NoneType) if get_origin(form) in (Union, UnionType) else (form,)
        if "setting" in field.metadata or forms[0] is bool or get_origin(forms[0]) is Literal:
            about = field.metadata.get("setting", Setting())
            keys[about.name or field.name] = Key(field, forms, about)
    return keys


def read_values(table: Table, *kinds: type, needed: Collection[str] = (), parts: Collection[str] = ()) -> dict[str, Any]:
    """Return the values of a table by field, in SI, files as paths; those that it leaves out are left out.

    For a class with ``origins`` they are among the values.

    Parameters
    ----------
    *kinds : type
        Dataclasses whose fields are the keys.
    needed : collection of str
        Required keys; also some that are read elsewhere.
    parts : collection of str
        Further keys that are read elsewhere.

    Raises
    ------
    ScenarioError
        At the first unknown key, for all missing keys together, or at the first value that is no value of its key.
    """
    keys = {name: key for kind in kinds for name, key in keys_of(kind).items() if name not in parts}
    known = (*needed, *parts, *keys)
    for name in table.entries:
        if name not in known:
            raise table.error(f"unknown key: {hint(name, dict.fromkeys(known))}", name)
    if missing := [name for name in needed if name not in table.entries]:
        raise table.error(f"{len(missing)} {'key is' if len(missing) == 1 else 'keys are'} missing: {', '.join(missing)}")
    values: dict[str, Any] = {}
    if any(field.name == "origins" for kind in kinds for field in fields(kind)):
        table, values["origins"] = without_origins(table, [name for name, (_, forms, _) in keys.items() if not {str, int} & {*forms}])
    for name, (field, forms, about) in keys.items():
        if name in table.entries:
            with located(table, name):
                value = read_value(table.entries[name].plain(), forms, about)
            values[field.name] = named_in(table, name) if Path in forms else value
    return values


def read_value(value: Any, forms: tuple[Any, ...], about: Setting) -> Any:
    """Return a value that has one of some types, in SI.

    Raises
    ------
    UnitError
        If it is no value of the setting.
    """
    choices = about.choices or (get_args(forms[0]) if get_origin(forms[0]) is Literal else ())
    if bool in forms:
        return _of_type(value, bool, "write true or false")
    if int in forms:
        return _whole(value, about)
    if choices and (str, ...) not in map(get_args, forms):
        return _choice(value, choices)
    if str in forms or Path in forms:
        return _text(value, about)
    if (str, ...) in map(get_args, forms):
        return tuple(_choice(item, choices) if choices else _text(item, about) for item in _of_type(value, list, _LIST))
    if float in forms and (len(forms) == 1 or not isinstance(value, list | dict)):
        return in_range(read_number(value, about.unit, about.display), about, repr(value))
    return read_list(value, about.unit, about.display)


_LIST = 'write a list such as ["x", "y"]'


def _refused(value: Any, cure: str) -> UnitError:
    return UnitError(f"{'this table' if isinstance(value, dict) else repr(value)[:80]}: {cure}")


def _of_type(value: Any, kind: type, cure: str) -> Any:
    refuse(type(value) is not kind, _refused, value, cure)
    return value


def _whole(value: Any, about: Setting) -> int:
    number: int = _of_type(value, int, "write a whole number")
    refuse(number < about.minimum, _refused, number, f"must be greater than or equal to {about.minimum}")
    refuse(number > about.maximum, _refused, number, f"must be less than or equal to {about.maximum}")
    return number


def _choice(value: Any, choices: Collection[Any]) -> Any:
    for choice in choices:
        if type(choice) is type(value) and choice == value:
            return choice
    *others, last = map(json.dumps, choices)
    raise _refused(value, f"write {', '.join(others)} or {last}")


def _text(value: Any, about: Setting) -> str:
    text: str = _of_type(value, str, "write text in quotes")
    if about.check is not None:
        try:
            return about.check(text)
        except ValueError as error:
            raise UnitError(str(error)) from error
    if not text or len(text) > about.maximum:
        raise UnitError("must not be empty" if not text else f"write at most {about.maximum:g} characters")
    return text


def table_of(value: Any, *, defaults: bool = True) -> dict[str, Any]:
    """Return the table that holds the fields of a dataclass, with their origins; no default values on request.

    What is None, infinite or empty is left out.
    """
    table = {}
    for name, (field, forms, about) in keys_of(value.__class__).items():
        item = getattr(value, field.name)
        if Path in forms and item is not None:
            item = Path(item)
        idle = item is None or item in ("", ()) or _infinite(item) if not isinstance(item, np.ndarray) else not item.size
        if not idle and (defaults or isinstance(item, np.ndarray) or item != field.default):
            table[name] = written(item, about)
    return with_origins(table, getattr(value, "origins", {}))


def _infinite(value: Any) -> bool:
    return any(isinstance(item, float) and not np.isfinite(item) for item in (value if isinstance(value, tuple) else (value,)))


def written(value: Any, about: Setting | Parameter) -> Any:
    """Return a value as in a file, with its unit."""
    if isinstance(value, tuple | np.ndarray):
        return [written(item, about) for item in value]
    if isinstance(value, Path):
        return value.resolve().as_posix()
    if not isinstance(value, float):
        return value
    return int(value) if isinstance(about, Parameter) and about.whole else quantity(float(value), about.unit, about.display)
