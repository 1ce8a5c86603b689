"""What an answer is made of: the stamp of its files, and BibTeX of the methods that it uses."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from os import PathLike
from pathlib import Path
from typing import Any

from contourlab import __version__
from contourlab.app.session import Answer
from contourlab.components.contract import Component
from contourlab.errors import ParameterError, refuse
from contourlab.loop import Controller, Machine
from contourlab.program import Program
from contourlab.result import Result
from contourlab.result.stamp import identity, parse_stamp, read_stamp, stamp
from contourlab.scenario import Case, Scenario

Cited = Answer | Result | Scenario | Case | Machine | Controller | str | PathLike[str]


@cache
def references() -> Mapping[str, tuple[str, frozenset[str]]]:
    """Return each reference by its key: its BibTeX, and what uses it without a component; see ``references.bib``."""
    text = (Path(__file__).parent / "references.bib").read_text(encoding="utf-8").replace("@VERSION@", __version__)
    found = {}
    for entry in re.findall(r"^@\w+\{.*?^\}", text, re.MULTILINE | re.DOTALL):
        use = re.search(r",\n  methodof = \{(.*?)\}", entry)
        found[entry.partition("{")[2].partition(",")[0]] = (
            entry.replace(use[0], "") if use else entry,
            frozenset(use[1].split() if use else ()),
        )
    return found


def cite(what: Cited) -> str:
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
        If the file does not say what made it.

    >>> import contourlab as cl
    >>> print(cl.cite(cl.load_scenario("builtin:ghaffari/demo-stage")).partition(",")[0])
    @misc{contourlab
    """
    refuse(not isinstance(what, Cited), ParameterError, "what", type(what).__name__, "an answer, a run, a machine or a file of contourlab")
    if isinstance(what, Result):
        keys = set(parse_stamp(str(what.attributes.get("made_by", "")), what.scheme).get("cites", "").split(","))
    elif isinstance(what, str | PathLike):
        keys = set(read_stamp(what).get("cites", "").split(","))
    else:
        keys = _keys(list(_objects(what)), _question(what))
    return "\n\n".join(references()[key][0] for key in sorted({"contourlab", *keys} & references().keys(), key=str.lower))


def stamp_of(what: object) -> str:
    """Return the stamp of the files of an answer, or of the runs of a case."""
    objects = list(_objects(what))
    found = list(zip(*map(_digests, objects), strict=True)) or [(), (), ()]
    digests = {
        name: ",".join(filter(None, dict.fromkeys(each))) for name, each in zip(("machine", "controller", "program"), found, strict=True)
    }
    return stamp(**digests, cites=",".join(sorted(_keys(objects, _question(what)))))


def _objects(what: Any) -> Iterator[Any]:
    """Yield the cases, machines, controllers and programs that something is about."""
    for one in (*vars(what).get("_about", ()), *vars(what).values()) if isinstance(what, Answer) else [what]:
        if isinstance(one, Scenario):
            yield from one.cases()
        elif isinstance(one, Case | Machine | Controller | Program):
            yield one


def _question(what: Any) -> set[str]:
    """Return the words of the place of an answer's class, the name of its question among them."""
    return set(type(what).__module__.split(".")) if isinstance(what, Answer) else set()


def _digests(one: Any) -> tuple[str, str, str]:
    """Return the digests of machine, controller and program."""
    if isinstance(one, Case):
        given = getattr(one, "given", None)
        program = one.lines or one.motion if given is None else given.digest
        return identity(one.machine), identity(one.controller, *one.changes), identity(program)
    kinds = (Machine, Controller, Program)
    return tuple(identity(getattr(one, "lines", one)) if isinstance(one, kind) else "" for kind in kinds)  # type: ignore[return-value]


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


def _components(value: Any) -> Iterator[Component]:
    if isinstance(value, Component):
        yield value
    elif isinstance(value, Mapping | list | tuple):
        for item in value.values() if isinstance(value, Mapping) else value:
            yield from _components(item)
    elif is_dataclass(value):
        yield from _components([getattr(value, each.name) for each in fields(value) if each.compare])
