"""What an answer is made of: the stamp of its files, and BibTeX of the methods that it uses."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path
from typing import Any

from contourlab import __version__
from contourlab.components.contract import Component
from contourlab.errors import ParameterError, ResultError, refuse
from contourlab.loop import Controller, Machine
from contourlab.program import Program
from contourlab.result import Result
from contourlab.result.stamp import identity, parse_stamp, read_stamp, stamp
from contourlab.scenario import Case, Scenario


@cache
def references() -> Mapping[str, tuple[str, frozenset[str]]]:
    """Return each reference by its key: its BibTeX, and what uses it without a component; see ``references.bib``."""
    text = (Path(__file__).parent / "references.bib").read_text(encoding="utf-8").replace("@VERSION@", __version__)
    entries = re.findall(r"^(@\w+\{(\w+),.*?)(?:,\n  methodof = \{(.*?)\})?\n\}", text, re.MULTILINE | re.DOTALL)
    return {key: (f"{entry}\n}}", frozenset(uses.split())) for entry, key, uses in entries}


def cite(what: object) -> str:
    """Return BibTeX of contourlab and of the methods that an answer uses, sorted by key.

    Parameters
    ----------
    what : answer, Result, Scenario, Case, Machine, Controller, str or Path
        A text or a path is a file that contourlab wrote.

    Returns
    -------
    str
        From the components of machine and controller, the planner, the estimate of the contour error, and the method of the question. A
        component without a published source adds none.

    Raises
    ------
    ParameterError
        If it is something else.
    ResultError
        If a file or a run does not say by which methods it was made; `simulate` and `simulate_to_file` name machine and controller only.

    >>> import contourlab as cl
    >>> "@misc{contourlab," in cl.cite(cl.load_scenario("builtin:ghaffari/demo-stage"))
    True
    """
    if isinstance(what, str | Path | Result):
        made = parse_stamp(what.stamp, what.scheme) if isinstance(what, Result) else read_stamp(what)
        refuse("cites" not in made, ResultError, "its stamp names no methods: cite the answer, or the machine and the controller")
        keys = set(made["cites"].split(","))
    else:
        known = isinstance(what, Scenario | Case | Machine | Controller) or hasattr(what, "_cited")
        refuse(not known, ParameterError, "what", type(what).__name__, "an answer, a run, a machine or a file of contourlab")
        keys = _keys(*_about(what))
    return "\n\n".join(references()[key][0] for key in sorted({"contourlab", *keys} & references().keys(), key=str.lower))


def stamp_of(what: object) -> str:
    """Return the stamp of the files of an answer, or of the runs of a case."""
    objects, words = _about(what)
    parts, keys = [_parts(one) for one in objects], ("machine", "controller", "program")
    digests = {key: ",".join(dict.fromkeys(identity(*one[key]) for one in parts if key in one)) for key in keys}
    return stamp(**digests, cites=",".join(sorted(_keys(objects, words))))


def _about(what: Any) -> tuple[list[Any], set[str]]:
    """Return the cases, machines, controllers and programs that something is about, and words for its question."""
    found, words = what._cited() if hasattr(what, "_cited") else ([what], set())
    cases = [one.cases() if isinstance(one, Scenario) else [one] for one in found]
    return [one for each in cases for one in each if isinstance(one, Case | Machine | Controller | Program)], words


def _parts(one: Any) -> dict[str, tuple[Any, ...]]:
    """Return what the digests of machine, controller and program cover."""
    if not isinstance(one, Case):
        return {type(one).__name__.lower(): (getattr(one, "lines", one),)}
    given = getattr(one, "given", None)
    program = one.lines or one.motion if given is None else given.digest
    return {"machine": (one.machine,), "controller": (one.controller, *one.changes), "program": (program,)}


def _keys(objects: Iterable[Any], uses: set[str]) -> set[str]:
    """Return the keys of what is cited."""
    texts, uses = [], set(uses)
    for one in objects:
        parts = (one.machine, one.controller, one.learning, one.changes) if isinstance(one, Case) else one
        texts += [re.sub(r"\W", "", part.reference) for part in _components(parts)]
        if isinstance(one, Case):
            uses.add("contour-error")
            uses |= {"planned"} if one.feed.law == "planned" and one.machine.planner in (None, "jerk") else set()
    return {key for key, (_, users) in references().items() if users & uses or any(key in text for text in texts)}


def _components(value: Any) -> list[Component]:
    if isinstance(value, Component):
        return [value]
    if is_dataclass(value):
        value = {each.name: getattr(value, each.name) for each in fields(value) if each.compare}
    items = value.values() if isinstance(value, Mapping) else value if isinstance(value, list | tuple) else ()
    return [part for item in items for part in _components(item)]
