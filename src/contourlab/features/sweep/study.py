"""Study files: which scenario, what varies and how, which figures to keep.

Choices, such as schemes, programs or kinds of components, change more than numbers: each combination of them is one structure.
"""

from __future__ import annotations

import hashlib
import json
import math
import pickle
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import product
from pathlib import Path
from typing import Any, Literal

import numpy as np

from contourlab.errors import ContourlabError, ParameterError, ScenarioError, UnitError, hint, refuse
from contourlab.features.check.program_check import about_planner
from contourlab.features.sweep.vary import HEADS, Variation, belongs, distribution, module_entries, read_list, read_variations
from contourlab.feed import Reference
from contourlab.findings import Finding, finding
from contourlab.loop import parameters_of
from contourlab.loop.batch import LANES
from contourlab.loop.parameters import Known, declared, matching
from contourlab.loop.simulate import UNITS as SIGNALS
from contourlab.loop.simulate import ToolPosition
from contourlab.metrics.run_figures import FIGURES
from contourlab.result.stamp import tell
from contourlab.scenario import Case, Scenario, dump
from contourlab.scenario.files import BUILTIN, shipped_hint
from contourlab.scenario.load import changed_case, load_scenario
from contourlab.scenario.tables import read_values
from contourlab.scenario.tree import Leaf, Table, from_mapping, merge, read_tree
from contourlab.scenario.values import DISTANCE
from contourlab.study import Setting
from contourlab.study.checkpoint import program_text
from contourlab.study.design import FIXED, INDEPENDENT, Design, Modules
from contourlab.study.runner import run_identity
from contourlab.study.space import Distribution
from contourlab.units import setting, si_unit, split, to_si

UNITS = {**{name: figure.unit for name, figure in FIGURES.items()}, "cycle_time": "s"}
"""SI unit of each figure that a study can keep."""
DEFAULT = ("part_error_max", "contour_error_max", "contour_error_rms", "contour_error_integral", "tracking_error_max", "cycle_time")
CHUNK = 2048
"""Variants of a chunk, unless the study says another number or keeps signals."""
SIGNAL_BYTES = 1 << 26
"""Largest memory of the kept signals of a chunk, unless the smallest chunk needs more."""
MOST, MOST_STRUCTURES = 10**12, 256
"""Largest number of variants, and of structures."""
ROOMS = ("features/sweep/chunk", "study/design", "study/space")
"""Modules besides those of a run that decide the figures."""
WORTH_SAYING = 1e-4
"""Least share of a distribution beyond the bounds of its parameter that is reported."""
EXAMPLE = '["axes.x.plant.mass", "axes.y.plant.mass", 0.8]'
Combo = tuple[int, ...]
"""The label of each choice."""


@dataclass(frozen=True)
class StudyTable:
    """The top of a study file."""

    scenario: str = field(metadata=setting(maximum=200))
    scheme: str | None = field(default=None, metadata=setting(maximum=200))
    variants: int | None = field(default=None, metadata=setting(minimum=1, maximum=MOST))
    design: Literal["random", "sobol", "latin-hypercube", "saltelli", "grid", "list"] = "random"
    seed: int = field(default=0, metadata=setting(minimum=0, maximum=2**63 - 1))
    chunk: int | None = field(default=None, metadata=setting(minimum=LANES, maximum=1 << 16))
    figures: tuple[str, ...] = field(default=DEFAULT, metadata=setting(check=str))
    signals: tuple[str, ...] = field(default=(), metadata=setting(check=str))
    tolerance: float | None = field(default=None, metadata=DISTANCE)
    listed: str | None = field(default=None, metadata=setting(maximum=200, name="list"))


@dataclass(frozen=True)
class Choice:
    """A key of the scenario file that takes one of several values.

    Attributes
    ----------
    key : str
    labels : tuple
        Distinct values, for the column: numbers [SI] or texts.
    unit : str
        SI unit of the labels.
    codes : tuple of int
        Label of each item of the study file.
    weights : tuple of float
        Relative probabilities of the items; empty for equal ones.
    dimension : int
        Its dimension of the design.
    """

    key: str
    labels: tuple[Any, ...]
    unit: str
    codes: tuple[int, ...]
    weights: tuple[float, ...]
    dimension: int = 0


@dataclass(frozen=True)
class Structure(Setting):
    """Variants that differ in numbers only.

    Attributes
    ----------
    numbers : tuple of (str, int, Distribution)
        Name, dimension of the design and distribution of each varied parameter.
    """

    numbers: tuple[tuple[str, int, Distribution], ...] = ()


@dataclass(frozen=True, eq=False)
class Varied:
    """What varies in a study.

    Attributes
    ----------
    structures : mapping of tuple of int to Structure
        By the labels of the choices.
    columns : mapping of str to str
        Varied parameters and choices, in the order of the file, each with its SI unit.
    choices : tuple of Choice
    cases : mapping of tuple of int to Case
        The cases of the structures.
    dimensions : tuple of (tuple of str, int)
        Columns that share a draw, and the number of values; 0 for a continuous distribution.
    listed : frozenset of str
        Columns whose values are those of a file.
    findings : tuple of Finding
    """

    structures: Mapping[Combo, Structure]
    columns: Mapping[str, str]
    choices: tuple[Choice, ...] = ()
    cases: Mapping[Combo, Case] = field(default_factory=dict)
    dimensions: tuple[tuple[tuple[str, ...], int], ...] = ()
    listed: frozenset[str] = frozenset()
    findings: tuple[Finding, ...] = ()

    def labels(self, combo: Combo) -> dict[str, Any]:
        """Return the label of each choice in a combination, by its key."""
        return {choice.key: choice.labels[code] for choice, code in zip(self.choices, combo, strict=True)}

    def scenario(self, combo: Combo) -> str:
        """Return the scenario of a structure as a file."""
        case = self.cases[combo]
        return dump(Scenario(case.name, Path(), replace(case, learning=None)))


@dataclass(frozen=True, eq=False, kw_only=True)
class Study(Varied):
    """A study, read and checked; a chunk needs nothing else, so it can be sent to another machine.

    Attributes
    ----------
    design : Design
    figures, signals : tuple of str
    text : str
        Content of the study file.
    tolerance : float [m] or None
    plugins : tuple of str
        Python files with components.
    identity : mapping of str to str
        What decides the results: ``program``, ``scenario`` and ``study``.
    """

    design: Design
    figures: tuple[str, ...]
    signals: tuple[str, ...] = ()
    text: str = ""
    tolerance: float | None = None
    plugins: tuple[str, ...] = ()
    identity: Mapping[str, str] = field(default_factory=dict)


def load_study(
    file: str | Path,
    plugins: Sequence[str | Path] = (),
    progress: Callable[[int, int], None] = lambda done, total: None,
    *,
    variants: int | None = None,
    machine: str | None = None,
) -> Study:
    """Read a study file, and plan the motion of each structure.

    Parameters
    ----------
    file : str or Path
    plugins : sequence of str or Path
        Python files with components.
    progress : callable, optional
        Called with the structures built and in all.
    variants : int, optional
        Counts if the file names no number.
    machine : str, optional
        In place of the machine of the scenario.

    Raises
    ------
    ScenarioError
        If the study or its scenario is invalid; gives file and key.
    """
    path = Path(file)
    refuse(path.suffix.lower() != ".toml", ScenarioError, "not a study: its name must end in .toml", file=file)
    content = read_tree(path)
    if "vary" not in content.entries and "machine" in content.entries:
        raise ScenarioError("this is a scenario: write a study that names it, with scenario = ... and [vary]", file=file)
    plain = StudyTable(**read_values(content, StudyTable, needed=("scenario",), parts=("vary", "modules", "correlations")))
    if plain.listed is not None:
        if "design" in content.entries and plain.design != "list":
            raise content.error(f"a list is no {plain.design} design: leave this out", "design")
        plain = replace(plain, design="list")
    entries, findings = module_entries(content), list[Finding]()
    variations = [*read_variations(content.table("vary"))]
    lists = [("", content.get("list")), *((name, leaf) for name, leaf in entries.items() if isinstance(leaf.value, str))]
    for modules, leaf in lists:
        if isinstance(leaf, Leaf):
            columns, remarks = read_list(leaf, path.parent, modules)
            variations += columns
            findings += remarks
    refuse(not variations, content.table("vary").error, 'write what varies, such as "axes.x.plant.mass" = { normal = ["80 kg", "4 kg"] }')
    name = plain.scenario if plain.scenario.startswith(BUILTIN) else str(path.parent / plain.scenario)
    if not name.startswith(BUILTIN) and not Path(name).exists():
        raise content.error(f"no file {plain.scenario!r} in {path.parent.as_posix()}{shipped_hint(plain.scenario)}", "scenario")
    scenario = tell(load_scenario(name, plugins, machine))
    schemes = [case.name for case in scenario.all_cases]
    asked = [(str(item), one.table, "values") for one in variations if one.key == "scheme" for item in one.items]
    for scheme, table, key in [*([(plain.scheme, content, "scheme")] if plain.scheme else []), *asked]:
        if scheme not in schemes:
            raise table.error(f"the scenario has no scheme {scheme!r}: {hint(scheme, schemes)}", key)
    base = scenario.case(plain.scheme) if plain.scheme else scenario.base

    def case_of(scheme: str, changes: Table) -> Case:
        return changed_case(name, scheme or plain.scheme or "", changes, plugins, machine)

    varied = _varied(variations, base, case_of, plain.design == "list", progress)
    left_out = tuple(repr(case.name) for case in scenario.cases() if case.name != "base") if schemes and not asked else ()
    if left_out and not plain.scheme:
        findings.insert(0, finding("CL920", schemes=left_out))
    study = Study(
        **vars(varied) | {"findings": (*findings, *varied.findings)},
        design=_design(plain, content, varied, _modules_of(entries, varied), variants),
        figures=_known(content, "figures", plain.figures, UNITS),
        signals=_known(content, "signals", plain.signals, SIGNALS),
        text=path.read_text(encoding="utf-8-sig"),
        tolerance=base.tolerance if plain.tolerance is None else plain.tolerance,
        plugins=tuple(str(Path(plugin).resolve()) for plugin in plugins),
    )
    return replace(study, identity=_identity(study))


def _known(content: Table, key: str, names: Sequence[str], known: Mapping[str, str]) -> tuple[str, ...]:
    for name in names:
        if name not in known:
            raise content.error(f"no {key.removesuffix('s')} {name!r}: {hint(name, known)}", key)
    refuse(len(set(names)) < len(names) or (key in content.entries and not names), content.error, "write one or more names, each once", key)
    return tuple(names)


def _identity(study: Study) -> dict[str, str]:
    """Return digests of all that decides the results: program, scenario, and what the study varies and keeps."""
    scenario = "\n".join(f"{combo}\n{run_identity([structure], ROOMS)}" for combo, structure in study.structures.items())
    numbers = [(combo, structure.numbers) for combo, structure in study.structures.items()]
    about = repr((study.design, study.choices, numbers, study.figures, study.signals))
    digests = {key: hashlib.sha256(text.encode()).hexdigest() for key, text in (("scenario", scenario), ("study", about))}
    return {"program": program_text(*ROOMS), **digests}


# --- choices and structures ------------------------------------------------------------------------------------------------------------


def _varied(
    variations: Sequence[Variation],
    base: Case,
    case_of: Callable[[str, Table], Case],
    listed: bool,
    progress: Callable[[int, int], None],
) -> Varied:
    """Build every combination of choices, and find the parameters that vary in each.

    Parameters
    ----------
    variations : sequence of Variation
    base : Case
    case_of : callable
        Returns the case of a scheme (empty for that of the study) with other tables and keys.
    listed : bool
        Whether the values of all variations belong together, row by row.
    progress : callable
        Called with the structures built and in all.

    Raises
    ------
    ScenarioError
        If an entry matches nothing, is out of range, or there are too many structures; gives file and key.
    """
    known = parameters_of(base.machine, base.controller)
    choosing = {i: _choice(variation) for i, variation in enumerate(variations) if _is_choice(variation, known)}
    codes = [choice.codes for choice in choosing.values()]
    counts = [len(choice.labels) for choice in choosing.values()]
    combos = sorted(set(zip(*codes, strict=True))) if listed and codes else [*product(*map(range, counts))]
    if len(combos) > MOST_STRUCTURES:
        most = max(choosing, key=lambda i: len(choosing[i].labels))
        what = f"{variations[most].key} is no parameter but a choice with {len(choosing[most].labels)} values"
        end = f"{len(combos)} combinations of choices are too many, {MOST_STRUCTURES} are the most"
        raise variations[most].table.error(f"{what}: {end}", "values")
    cases, references, motions = {}, {}, dict[bytes, Reference]()
    for i, combo in enumerate(combos):
        case = cases[combo] = _case([variations[k] for k in choosing], [*choosing.values()], combo, case_of)
        motion = hashlib.sha256(pickle.dumps((dump(case.machine), case.motion, case.feed, case.run.judge))).digest()
        if motion not in motions:
            motions[motion] = case.reference()
        references[combo] = motions[motion]
        progress(i + 1, len(combos))
    return _bound(variations, choosing, cases, references)


def _matching(variation: Variation, known: Known) -> tuple[list[str], ParameterError | None]:
    """Return the parameters that an entry names, and the error where there is none."""
    try:
        return matching(variation.key, known, "vary"), None
    except ParameterError as error:
        return [], error


def _is_choice(variation: Variation, known: Known) -> bool:
    if variation.key.partition(".")[0] not in HEADS:
        return False
    _, error = _matching(variation, known)
    if error is not None and variation.kind != "values":
        raise variation.table.error(f"must be {error.bound}; another key of the scenario takes values = [...] only") from None
    return error is not None


def _choice(variation: Variation) -> Choice:
    try:
        unit = si_unit(split(str(variation.items[0]))[1])
        labels: list[Any] = [to_si(str(item), unit) for item in variation.items]
    except (UnitError, ContourlabError):
        unit, labels = "", [item if isinstance(item, str) else json.dumps(item) for item in variation.items]
    distinct = tuple(dict.fromkeys(labels))
    return Choice(variation.key, distinct, unit, tuple(map(distinct.index, labels)), variation.weights)


def _case(choosing: Sequence[Variation], choices: Sequence[Choice], combo: Combo, case_of: Callable[[str, Table], Case]) -> Case:
    scheme, changes = "", Table()
    for variation, choice, code in zip(choosing, choices, combo, strict=True):
        words: Any = variation.items[choice.codes.index(code)]
        if variation.key == "scheme":
            scheme = str(words)
            continue
        for word in reversed(variation.key.split(".")):
            words = {word: words}
        changes = merge(changes, from_mapping(words, variation.table.file, "vary"))
    case = case_of(scheme, changes)
    if case.changes:
        raise ParameterError("scenario", "one that changes its controller during the run", "a scheme with the same controller throughout")
    return case


def _bound(
    variations: Sequence[Variation], choosing: Mapping[int, Choice], cases: Mapping[Combo, Case], references: Mapping[Combo, Reference]
) -> Varied:
    """Return what varies: the dimension of each choice, and the parameters that each other variation draws in each case."""
    choices: list[Choice] = []
    dimensions: list[tuple[tuple[str, ...], int]] = []
    columns: dict[str, str] = {}
    listed: set[str] = set()
    numbers: dict[Combo, list[tuple[str, int, Distribution]]] = {combo: [] for combo in cases}
    findings: dict[str, Finding] = {}
    known = {combo: parameters_of(case.machine, case.controller) for combo, case in cases.items()}
    matches = {i: {combo: _matching(one, known[combo])[0] for combo in cases} for i, one in enumerate(variations) if i not in choosing}
    measured = {name for i, matched in matches.items() if variations[i].listed for names in matched.values() for name in names}
    for i, variation in enumerate(variations):
        if choice := choosing.get(i):
            choices.append(replace(choice, dimension=len(dimensions)))
            dimensions.append(((choice.key,), len(choice.codes)))
            columns[choice.key] = choice.unit
            listed |= {choice.key} if variation.listed else set()
            continue
        names = tuple(dict.fromkeys(name for matched in matches[i].values() for name in matched))
        if not names and (error := _matching(variation, next(iter(known.values())))[1]):
            raise variation.table.error(f"must be {error.bound}; or a key of the scenario that begins with {', '.join(HEADS)}") from error
        if "*" in variation.key:  # a column of a file replaces what a pattern draws
            names = tuple(name for name in names if name not in measured) or names
        if twice := next((name for name in names if name in columns), None):
            raise variation.table.error(f"{twice} is varied twice: delete one")
        listed |= set(names) if variation.listed else set()
        first, count = len(dimensions), len(variation.items) if variation.kind == "values" else variation.steps
        dimensions += [(names, count)] if variation.together else [((name,), count) for name in names]
        for combo, matched in matches[i].items():
            for name in filter(names.__contains__, matched):
                part, parameter = known[combo][name]
                declaration = replace(declared(cases[combo].machine, name, part, parameter), name=name)
                drawn = distribution(variation, declaration, float(getattr(part, parameter)))
                numbers[combo].append((name, first if variation.together else first + names.index(name), drawn))
                columns[name] = declaration.unit
                if drawn.beyond > WORTH_SAYING:
                    findings.setdefault(name, finding("CL921", parameter=name, share=drawn.beyond))
    structures = {
        combo: Structure(case.machine, case.controller, references[combo], case.run.seed, case.moving, tuple(numbers[combo]))
        for combo, case in cases.items()
    }
    on_cases = {
        "CL922": any(case.learning is not None for case in cases.values()),
        "CL923": not all(ToolPosition(case.machine, 0).exact for case in cases.values()),
    }
    planned = {str(one): one for case in cases.values() for one in about_planner(case.machine)}
    remarks = (*planned.values(), *findings.values(), *(finding(code) for code, holds in on_cases.items() if holds))
    return Varied(structures, columns, tuple(choices), cases, tuple(dimensions), frozenset(listed), remarks)


# --- the design ------------------------------------------------------------------------------------------------------------------------


def _modules_of(entries: dict[str, Leaf], varied: Varied) -> tuple[Modules, ...]:
    """Return the modules of each kind, with the dimensions of the design that are theirs.

    Raises
    ------
    ScenarioError
        If nothing of a module varies, or a draw is shared with something else; gives file and key.
    """
    kinds = []
    for name, leaf in entries.items():
        mine = {i: names for i, (names, _) in enumerate(varied.dimensions) if any(belongs(one, name) for one in names)}
        if not mine:
            raise leaf.error(f"nothing varies that begins with {name}.: name the modules by the beginning of their parameters in [vary]")
        for names in mine.values():
            if other := next((one for one in names if not belongs(one, name)), None):
                raise leaf.error(f"{names[0]} and {other} share a draw: leave out together")
        listed = tuple(i for i, names in mine.items() if varied.listed.issuperset(names))
        count = varied.dimensions[listed[0]][1] if isinstance(leaf.value, str) else int(leaf.value)
        kinds.append(Modules(name, count, tuple(mine), listed))
    return tuple(kinds)


def _design(plain: StudyTable, content: Table, varied: Varied, modules: tuple[Modules, ...], default: int | None) -> Design:
    variants, drawn = plain.variants, {i for one in modules for i in one.dimensions}
    if modules and plain.design not in INDEPENDENT:
        raise content.error(f"modules are drawn: write {', '.join(INDEPENDENT)} instead of {plain.design}", "design")
    fixed = "study with modules" if modules else plain.design if plain.design in FIXED else ""
    levels = tuple(0 if i in drawn or not fixed else count for i, (_, count) in enumerate(varied.dimensions))
    if fixed:
        for i, (names, count) in enumerate(varied.dimensions):
            if not count and i not in drawn:
                other = "belongs to no module: add it to [modules], or write" if modules else f"a {fixed} needs"
                steps = "" if fixed == "list" else ", or steps = 21 beside uniform"
                raise content.error(f"{names[0]}: {other} values = [...]{steps}", "vary")
        if plain.design == "list" and len(set(levels)) > 1:
            raise content.error(f"lists of {sorted(set(levels))} values: a list needs as many of each", "vary")
        refuse(variants is not None, content.error, f"a {fixed} has as many variants as its values give: leave this out", "variants")
        variants = levels[0] if plain.design == "list" else math.prod([*(one.count for one in modules), *filter(None, levels)])
        refuse(variants > MOST, content.error, f"{variants} variants: {MOST} are the most", "modules" if modules else "vary")
    elif variants is None and (variants := default) is None:
        raise content.error("1 key is missing: variants")
    chunk, factor = _chunk(plain, content, varied), _factor(content, varied, plain.design, modules)
    return Design(plain.design, variants, chunk, levels, plain.seed, factor, modules)


def _chunk(plain: StudyTable, content: Table, varied: Varied) -> int:
    """Return the variants of a chunk: a power of two, smaller where signals are kept."""
    if plain.chunk is not None:
        if plain.chunk & (plain.chunk - 1):
            raise content.error(f"{plain.chunk} is not a power of two: write {1 << plain.chunk.bit_length()}", "chunk")
        return plain.chunk
    row = max(structure.reference.n_sample * structure.reference.n_axis for structure in varied.structures.values())
    fits = SIGNAL_BYTES // (8 * row * len(plain.signals)) if plain.signals else CHUNK
    return min(max(1 << max(fits, 1).bit_length() - 1, LANES), CHUNK)


def _factor(content: Table, varied: Varied, design: str, modules: tuple[Modules, ...]) -> tuple[tuple[float, ...], ...]:
    """Return the factor of the correlations, given as ``correlations = [["axes.x.plant.mass", "axes.y.plant.mass", 0.8]]``."""

    def refused(cure: str) -> ScenarioError:
        return content.error(cure, "correlations")

    node = content.get("correlations")
    if node is None:
        return ()
    refuse(design not in INDEPENDENT, refused, f"a {design} has none: leave this out")
    dimension = {name: i for i, (names, _) in enumerate(varied.dimensions) for name in names}
    kind = {i: one.name for one in modules for i in one.dimensions if i not in one.listed}
    matrix, items = np.eye(len(varied.dimensions)), node.plain()
    if not isinstance(items, list):
        raise refused(f"write a list: [{EXAMPLE}, ...]")
    for item in items:
        if not (isinstance(item, list) and len(item) == 3 and all(isinstance(name, str) for name in item[:2])):
            raise refused(f"{item!r:.80}: write two varied parameters and a coefficient, {EXAMPLE}")
        if isinstance(item[2], bool) or not isinstance(item[2], int | float) or not -1.0 < item[2] < 1.0:
            raise refused(f"{item[2]!r:.40} is not a coefficient: write a number between -1 and 1")
        try:
            pairs = [[dimension[name] for name in matching(word, dimension, "correlations", "[vary]")] for word in item[:2]]
        except ParameterError as error:
            raise refused(f"{error.value}: must be {error.bound}") from error
        for i, j in product(*pairs):
            refuse(i == j, refused, f"{item!r:.80}: both are one draw: name two")
            if modules and (i not in kind or kind[i] != kind.get(j)):
                raise refused(f"{item!r:.80}: only what is drawn for the same module can be correlated")
            matrix[i, j] = matrix[j, i] = item[2]
    try:
        factor = np.linalg.cholesky(matrix)
    except np.linalg.LinAlgError:
        raise refused("these correlations contradict each other: make them smaller") from None
    return tuple(tuple(row) for row in factor.tolist())
