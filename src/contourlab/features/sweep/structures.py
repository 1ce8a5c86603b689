"""Choices that change more than numbers, such as schemes, programs or kinds of components: each combination is one structure."""

from __future__ import annotations

import hashlib
import json
import pickle
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

from contourlab.errors import ContourlabError, ParameterError, UnitError
from contourlab.features.sweep.vary import HEADS, Variation, distribution
from contourlab.feed import Reference
from contourlab.findings import Finding, finding
from contourlab.loop import parameters_of
from contourlab.loop.parameters import declared, matching
from contourlab.scenario import Case, dump
from contourlab.scenario.tree import Table, from_mapping, merge
from contourlab.study import Setting
from contourlab.study.checkpoint import run_identity
from contourlab.study.space import Distribution
from contourlab.units import si_unit, split, to_si

MOST = 256
"""Largest number of structures."""
ROOMS = ("features/sweep/chunk", "study/design", "study/space")
"""Modules besides those of a run that decide the figures."""
WORTH_SAYING = 1e-4
"""Least share of a distribution beyond the bounds of its parameter that is reported."""


@dataclass(frozen=True)
class Choice:
    """A key of the scenario file that takes one of several values.

    Attributes
    ----------
    key : str
    dimension : int
        Its dimension of the design.
    labels : tuple
        Distinct values, for the column: numbers [SI] or texts.
    unit : str
        SI unit of the labels.
    codes : tuple of int
        Label of each item of the study file.
    weights : tuple of float
        Relative probabilities of the items; empty for equal ones.
    """

    key: str
    dimension: int
    labels: tuple[Any, ...]
    unit: str
    codes: tuple[int, ...]
    weights: tuple[float, ...]


@dataclass(frozen=True)
class Structure(Setting):
    """Variants that differ in numbers only.

    Attributes
    ----------
    numbers : tuple of (str, int, Distribution)
        Name, dimension of the design and distribution of each varied parameter.
    """

    numbers: tuple[tuple[str, int, Distribution], ...] = ()

    @property
    def identity(self) -> str:
        """Everything that decides the results, but for the varied values."""
        return run_identity([self], ROOMS)


@dataclass(frozen=True)
class Structured:
    """All structures of a study.

    Attributes
    ----------
    choices : tuple of Choice
    structures : mapping of tuple of int to Structure
        By the labels of the choices.
    cases : mapping of tuple of int to Case
    dimensions : tuple of (tuple of str, int)
        Columns that share a draw, and the number of values; 0 for a continuous distribution.
    units : mapping of str to str
        SI unit of each column.
    listed : frozenset of str
        Columns whose values are those of a file.
    findings : tuple of Finding
    """

    choices: tuple[Choice, ...]
    structures: Mapping[tuple[int, ...], Structure]
    cases: Mapping[tuple[int, ...], Case]
    dimensions: tuple[tuple[tuple[str, ...], int], ...]
    units: Mapping[str, str]
    listed: frozenset[str]
    findings: tuple[Finding, ...]


def structured(
    variations: Sequence[Variation],
    base: Case,
    case_of: Callable[[str, Table], Case],
    *,
    listed: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> Structured:
    """Build every combination of choices, and find the parameters that vary in each.

    Parameters
    ----------
    variations : sequence of Variation
    base : Case
    case_of : callable
        Returns the case of a scheme (empty for that of the study) with other tables and keys.
    listed : bool
        Whether the values of all variations belong together, row by row.
    progress : callable, optional
        Called with the structures built and in all.

    Raises
    ------
    ScenarioError
        If an entry matches nothing, is out of range, or there are too many structures; gives file and key.
    """
    known = parameters_of(base.machine, base.controller)
    choosing = [variation for variation in variations if _is_choice(variation, known)]
    read = [_labels(variation) for variation in choosing]
    counts = [len(labels) for labels, _, _ in read]
    combos = sorted(set(zip(*(codes for _, _, codes in read), strict=True))) if listed and read else list(product(*map(range, counts)))
    if len(combos) > MOST:
        most = max(choosing, key=lambda one: counts[choosing.index(one)])
        what = f"{most.key} is no parameter but a choice with {max(counts)} values"
        raise most.table.error(f"{what}: {len(combos)} combinations of choices are too many, {MOST} are the most", "values")
    cases, references, motions = {}, {}, dict[bytes, Reference]()
    for i, combo in enumerate(combos):
        cases[combo] = _case(choosing, read, combo, case_of)
        references[combo] = _planned(cases[combo], motions)
        if progress is not None:
            progress(i + 1, len(combos))
    return _bound(variations, choosing, read, cases, references)


def _is_choice(variation: Variation, known: Mapping[str, Any]) -> bool:
    if variation.key.partition(".")[0] not in HEADS:
        return False
    try:
        matching(variation.key, known, "vary")
    except ParameterError as error:
        if variation.kind == "values":
            return True
        raise variation.table.error(f"must be {error.bound}; another key of the scenario takes values = [...] only") from None
    return False


def _labels(variation: Variation) -> tuple[tuple[Any, ...], str, tuple[int, ...]]:
    """Return the distinct labels of the items of a choice, their unit, and the label of each item."""
    try:
        unit = si_unit(split(str(variation.items[0]))[1])
        labels: list[Any] = [to_si(str(item), unit) for item in variation.items]
    except (UnitError, ContourlabError):
        unit, labels = "", [item if isinstance(item, str) else json.dumps(item) for item in variation.items]
    distinct = tuple(dict.fromkeys(labels))
    return distinct, unit, tuple(distinct.index(label) for label in labels)


def _case(
    choosing: Sequence[Variation],
    read: Sequence[tuple[tuple[Any, ...], str, tuple[int, ...]]],
    combo: tuple[int, ...],
    case_of: Callable[[str, Table], Case],
) -> Case:
    scheme, changes = "", Table()
    for variation, (_, _, codes), code in zip(choosing, read, combo, strict=True):
        item = variation.items[codes.index(code)]
        if variation.key == "scheme":
            scheme = str(item)
            continue
        words: Any = item
        for word in reversed(variation.key.split(".")):
            words = {word: words}
        changes = merge(changes, from_mapping(words, variation.table.file, "vary"))
    case = case_of(scheme, changes)
    if case.changes:
        raise ParameterError("scenario", "one that changes its controller during the run", "a scheme with the same controller throughout")
    return case


def _planned(case: Case, known: dict[bytes, Reference]) -> Reference:
    """Return the reference of a case; plan each motion once."""
    key = hashlib.sha256(pickle.dumps((dump(case.machine), case.motion, case.feed, case.run.judge))).digest()
    if key not in known:
        known[key] = case.reference()
    return known[key]


def _bound(
    variations: Sequence[Variation],
    choosing: Sequence[Variation],
    read: Sequence[tuple[tuple[Any, ...], str, tuple[int, ...]]],
    cases: Mapping[tuple[int, ...], Case],
    references: Mapping[tuple[int, ...], Reference],
) -> Structured:
    choices: list[Choice] = []
    dimensions: list[tuple[tuple[str, ...], int]] = []
    units: dict[str, str] = {}
    listed: set[str] = set()
    numbers: dict[tuple[int, ...], list[tuple[str, int, Distribution]]] = {combo: [] for combo in cases}
    findings: dict[str, Finding] = {}
    measured = {name for one in variations if one.listed and one not in choosing for case in cases.values() for name in _matches(one, case)}
    for variation in variations:
        if variation in choosing:
            labels, unit, codes = read[choosing.index(variation)]
            choices.append(Choice(variation.key, len(dimensions), labels, unit, codes, variation.weights))
            dimensions.append(((variation.key,), len(codes)))
            units[variation.key] = unit
            listed |= {variation.key} if variation.listed else set()
            continue
        matches = {combo: _matches(variation, case) for combo, case in cases.items()}
        names = tuple(dict.fromkeys(name for some in matches.values() for name in some))
        if not names:
            _refuse_unknown(variation, next(iter(cases.values())))
        if "*" in variation.key and (others := tuple(name for name in names if name not in measured)) and others != names:
            names = others  # a column of a file replaces what a pattern draws
            matches = {combo: [name for name in some if name in names] for combo, some in matches.items()}
        for name in names:
            if name in units:
                raise variation.table.error(f"{name} is varied twice: delete one")
        listed |= set(names) if variation.listed else set()
        first, count = len(dimensions), len(variation.items) if variation.kind == "values" else variation.steps
        dimensions += [(names, count)] if variation.together else [((name,), count) for name in names]
        for combo, some in matches.items():
            machine, known = cases[combo].machine, parameters_of(cases[combo].machine, cases[combo].controller)
            for name in some:
                part, parameter = known[name]
                declaration = replace(declared(machine, name, part, parameter), name=name)
                drawn = distribution(variation, declaration, float(getattr(part, parameter)))
                numbers[combo].append((name, first if variation.together else first + names.index(name), drawn))
                units[name] = declaration.unit
                if drawn.beyond > WORTH_SAYING:
                    findings.setdefault(name, finding("CL921", parameter=name, share=drawn.beyond))
    structures = {
        combo: Structure(case.machine, case.controller, references[combo], case.seed, case.moving, tuple(numbers[combo]))
        for combo, case in cases.items()
    }
    remarks = (*findings.values(), *_on_cases(cases.values()))
    return Structured(tuple(choices), structures, cases, tuple(dimensions), units, frozenset(listed), remarks)


def _matches(variation: Variation, case: Case) -> list[str]:
    try:
        return matching(variation.key, parameters_of(case.machine, case.controller), "vary")
    except ParameterError:
        return []


def _refuse_unknown(variation: Variation, case: Case) -> None:
    try:
        matching(variation.key, parameters_of(case.machine, case.controller), "vary")
    except ParameterError as error:
        raise variation.table.error(f"must be {error.bound}; or a key of the scenario that begins with {', '.join(HEADS)}") from error


def _on_cases(cases: Any) -> list[Finding]:
    known = list(cases)
    errors = any(
        case.machine.squareness or any(axis.error.position.size or axis.error.repeatability for axis in case.machine.axes) for case in known
    )
    learns = any(case.learning is not None for case in known)
    return [finding(code) for code, found in (("CL922", learns), ("CL923", errors)) if found]
