"""Values in place of those of a scenario: the option ``--set NAME=VALUE``."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

from contourlab.errors import ParameterError, UnitError, refuse
from contourlab.loop import Axis, parameters_of, with_values
from contourlab.loop.parameters import declared, matching, meant
from contourlab.scenario import Case, Scenario
from contourlab.scenario.quantities import in_range, read_number
from contourlab.scenario.tables import keys_of
from contourlab.scenario.tree import Table, from_mapping, merge

KEYS = ("feed", "machine", "run")
"""First words of keys of a scenario's file; keys of an axis, such as ``axes.x.limits.acceleration``, are others."""
AXIS_KEYS = ("limits", "error", *keys_of(Axis))


def _pairs(texts: Sequence[str]) -> tuple[dict[str, str], dict[str, str]]:
    """Return keys of the scenario's file, and parameters of components, with their values as written."""
    keys, parameters = dict[str, str](), dict[str, str]()
    for text in texts:
        name, _, value = (part.strip() for part in text.partition("="))
        refuse(not (name and value), ParameterError, "set", repr(text), 'NAME=VALUE, such as "axes.x.plant.mass=90 kg"')
        head, *words = name.split(".")
        pairs = keys if head in KEYS or (head == "axes" and len(words) > 1 and words[1] in AXIS_KEYS) else parameters
        pairs.pop(name, None)  # the last one counts, also where a pattern means the same parameter
        pairs[name] = value
    return keys, parameters


def changed_keys(texts: Sequence[str]) -> dict[str, Any]:
    """Return the keys of the scenario's file among the values, as tables: they may change the plan."""
    tables = Table()
    for name, text in _pairs(texts)[0].items():
        try:
            value = tomllib.loads(f"value = {text}")["value"]
        except (ValueError, RecursionError):  # a quantity or a word, which needs no quotes here
            value = text
        for word in reversed(name.split(".")):
            value = {word: value}
        tables = merge(tables, from_mapping(value, "<arguments>"))
    return tables.plain()


def changed(scenario: Scenario, texts: Sequence[str]) -> Scenario:
    """Return a scenario with other values of parameters, in each case that has them.

    Raises
    ------
    ParameterError, UnitError
        If no case that runs has the parameter, or a value cannot be read or is out of range.
    """
    _, wanted = _pairs(texts)
    if not wanted:
        return scenario
    check_changed(scenario.cases(), texts)
    base, *others = (_with(case, wanted) for case in (scenario.base, *scenario.all_cases))
    return replace(scenario, base=base, all_cases=tuple(others))


def check_changed(cases: Iterable[Case], texts: Sequence[str]) -> None:
    """Raise ParameterError for a parameter that none of the cases has."""
    known = {name: part for case in cases for name, part in parameters_of(case.machine, case.controller).items()}
    for name in _pairs(texts)[1]:
        matching(name, known, "set")


def _with(case: Case, wanted: dict[str, str]) -> Case:
    known, values = parameters_of(case.machine, case.controller), dict[str, float]()
    for pattern, text in wanted.items():
        for name in meant(pattern, known):
            about = declared(case.machine, name, *known[name])
            try:
                values[name] = in_range(read_number(text, about.unit, about.display), about, repr(text))
            except UnitError as error:
                raise UnitError(f"set {name}: {error}") from error
            if case.changes and name.startswith("controller."):
                raise ParameterError("set", repr(name), f"a parameter of the machine: {case.name} changes its controller during the run")
    machine, controller = with_values(case.machine, case.controller, values)
    return replace(case, machine=machine, controller=controller)


def of_machine(texts: Sequence[str], case: Case) -> tuple[str, ...]:
    """Return the values that still apply with another controller."""
    known, kept, (keys, parameters) = parameters_of(case.machine, case.controller), list[str](), _pairs(texts)
    for name, text in parameters.items():
        names = meant(name, known)
        of_axes = [other for other in names if other.startswith("axes.")]
        kept += [f"{other}={text}" for other in ([name] if of_axes == names else of_axes)]
    return (*kept, *(f"{name}={text}" for name, text in keys.items()))
