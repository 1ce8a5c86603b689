"""Study files: which scenario, what varies and how, which figures to keep."""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from itertools import product
from pathlib import Path
from typing import Literal

import numpy as np

from contourlab.errors import ParameterError, ScenarioError, hint
from contourlab.features.sweep.structures import ROOMS, Choice, Structure, Structured, structured
from contourlab.features.sweep.vary import Variation, belongs, listed_modules, module_entries, read_list, read_variations
from contourlab.findings import Finding, finding
from contourlab.loop.batch import LANES
from contourlab.loop.parameters import matching
from contourlab.loop.simulate import UNITS as SIGNALS
from contourlab.metrics.run_figures import FIGURES
from contourlab.scenario import Case
from contourlab.scenario.files import BUILTIN, shipped_hint
from contourlab.scenario.load import changed_case, load_scenario
from contourlab.scenario.tables import read_values
from contourlab.scenario.tree import Leaf, Table, read_tree
from contourlab.scenario.values import DISTANCE
from contourlab.study.checkpoint import program_text
from contourlab.study.design import FIXED, INDEPENDENT, Design, Modules
from contourlab.units import setting

UNITS = {**{name: figure.unit for name, figure in FIGURES.items()}, "cycle_time": "s"}
"""SI unit of each figure that a study can keep."""
DEFAULT = ("part_error_max", "contour_error_max", "contour_error_rms", "contour_error_integral", "tracking_error_max", "cycle_time")
JUDGED = "part_error_max"
"""The figure that a tolerance bounds, as in `contourlab run`."""
CHUNK = 2048
"""Variants of a chunk, unless the study says another number or keeps signals."""
SIGNAL_BYTES = 1 << 26
"""Largest memory of the kept signals of a chunk, unless the smallest chunk needs more."""
MOST = 10**12
"""Largest number of variants."""


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


@dataclass(frozen=True, eq=False)
class Study:
    """A study, read and checked; a chunk needs nothing else, so it can be sent to another machine.

    Attributes
    ----------
    file, text : str
        Study file and its content.
    design : Design
    choices : tuple of Choice
    structures : mapping of tuple of int to Structure
        By the chosen values of the choices.
    columns : mapping of str to str
        Varied parameters and choices, in the order of the file, each with its SI unit.
    figures, signals : tuple of str
    tolerance : float [m] or None
    plugins : tuple of str
        Python files with components.
    identity : mapping of str to str
        What decides the results: ``program``, ``scenario`` and ``study``.
    findings : tuple of Finding
    """

    file: str
    text: str
    design: Design
    choices: tuple[Choice, ...]
    structures: Mapping[tuple[int, ...], Structure]
    columns: Mapping[str, str]
    figures: tuple[str, ...]
    signals: tuple[str, ...] = ()
    tolerance: float | None = None
    plugins: tuple[str, ...] = ()
    identity: Mapping[str, str] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()


def load_study(file: str | Path, plugins: Sequence[str | Path] = (), progress: Callable[[int, int], None] | None = None) -> Study:
    """Read a study file, and plan the motion of each structure.

    Parameters
    ----------
    file : str or Path
    plugins : sequence of str or Path
        Python files with components.
    progress : callable, optional
        Called with the structures built and in all.

    Raises
    ------
    ScenarioError
        If the study or its scenario is invalid; gives file and key.
    """
    return study_of(file, plugins, progress)[0]


def study_of(
    file: str | Path,
    plugins: Sequence[str | Path] = (),
    progress: Callable[[int, int], None] | None = None,
    *,
    variants: int | None = None,
) -> tuple[Study, Structured]:
    """Read a study file; return it with the cases of its structures. See `load_study`; ``variants`` counts if the file names no number."""
    path = Path(file)
    if path.suffix.lower() != ".toml":
        raise ScenarioError("not a study: its name must end in .toml", file=file)
    content = read_tree(path)
    if "vary" not in content.entries and "machine" in content.entries:
        raise ScenarioError("this is a scenario: write a study that names it, with scenario = ... and [vary]", file=file)
    plain = StudyTable(**read_values(content, StudyTable, needed=("scenario",), parts=("vary", "modules", "correlations")))
    if plain.listed is not None:
        if "design" in content.entries and plain.design != "list":
            raise content.error(f"a list is no {plain.design} design: leave this out", "design")
        plain = replace(plain, design="list")
    variations, entries, remarks = _variations(content, path.parent)
    name = plain.scenario if plain.scenario.startswith(BUILTIN) else str(path.parent / plain.scenario)
    if not name.startswith(BUILTIN) and not Path(name).exists():
        raise content.error(f"no file {plain.scenario!r} in {path.parent.as_posix()}{shipped_hint(plain.scenario)}", "scenario")
    scenario = load_scenario(name, plugins)
    _check_schemes([case.name for case in scenario.all_cases], plain, content, variations)
    base = scenario.case(plain.scheme) if plain.scheme else scenario.base

    def case_of(scheme: str, changes: Table) -> Case:
        return changed_case(name, scheme or plain.scheme or "", changes, plugins)

    made = structured(variations, base, case_of, listed=plain.design == "list", progress=progress)
    chosen = plain.scheme or any(choice.key == "scheme" for choice in made.choices)
    left_out = () if chosen or not scenario.all_cases else tuple(repr(case.name) for case in scenario.cases() if case.name != "base")
    study = Study(
        file=str(file),
        text=path.read_text(encoding="utf-8-sig"),
        design=_design(plain, content, made, _modules_of(entries, made), variants),
        choices=made.choices,
        structures=made.structures,
        columns=made.units,
        figures=_known(content, "figures", plain.figures, UNITS),
        signals=_known(content, "signals", plain.signals, SIGNALS),
        tolerance=base.tolerance if plain.tolerance is None else plain.tolerance,
        plugins=tuple(str(Path(plugin).resolve()) for plugin in plugins),
        findings=(*([finding("CL920", schemes=left_out)] if left_out else []), *remarks, *made.findings),
    )
    return replace(study, identity=_identity(study)), made


def _variations(content: Table, folder: Path) -> tuple[tuple[Variation, ...], dict[str, Leaf], tuple[Finding, ...]]:
    """Return what varies, in the study and in the files of lists; the entries of ``[modules]``; and remarks on the files."""
    entries = module_entries(content)
    leaf = content.get("list")
    rows = read_list(leaf, folder) if isinstance(leaf, Leaf) else ((), ())
    modules = listed_modules(entries, folder)
    variations = (*read_variations(content.table("vary")), *rows[0], *modules[0])
    if not variations:
        raise content.table("vary").error('write what varies, such as "axes.x.plant.mass" = { normal = ["80 kg", "4 kg"] }')
    return variations, entries, (*rows[1], *modules[1])


def _check_schemes(known: Sequence[str], plain: StudyTable, content: Table, variations: Sequence[Variation]) -> None:
    """Raise `ScenarioError` if the study names a scheme that its scenario has not."""
    varied = [(str(item), one.table, "values") for one in variations if one.key == "scheme" for item in one.items]
    for scheme, table, key in [*([(plain.scheme, content, "scheme")] if plain.scheme else []), *varied]:
        if scheme not in known:
            raise table.error(f"the scenario has no scheme {scheme!r}: {hint(scheme, known)}", key)


def _known(content: Table, key: str, names: Sequence[str], known: Mapping[str, str]) -> tuple[str, ...]:
    for name in names:
        if name not in known:
            raise content.error(f"no {key.removesuffix('s')} {name!r}: {hint(name, known)}", key)
    if len(set(names)) < len(names) or (key in content.entries and not names):
        raise content.error("write one or more names, each once", key)
    return tuple(names)


# --- the design ------------------------------------------------------------------------------------------------------------------------


def _modules_of(entries: dict[str, Leaf], made: Structured) -> tuple[Modules, ...]:
    """Return the modules of each kind, with the dimensions of the design that are theirs.

    Raises
    ------
    ScenarioError
        If nothing of a module varies, or a draw is shared with something else; gives file and key.
    """
    found = []
    for name, leaf in entries.items():
        mine = {i: names for i, (names, _) in enumerate(made.dimensions) if any(belongs(one, name) for one in names)}
        if not mine:
            raise leaf.error(f"nothing varies that begins with {name}.: name the modules by the beginning of their parameters in [vary]")
        for names in mine.values():
            if other := next((one for one in names if not belongs(one, name)), None):
                raise leaf.error(f"{names[0]} and {other} share a draw: leave out together")
        listed = tuple(i for i, names in mine.items() if made.listed.issuperset(names))
        count = made.dimensions[listed[0]][1] if isinstance(leaf.value, str) else int(leaf.value)
        found.append(Modules(name, count, tuple(mine), listed))
    return tuple(found)


def _design(plain: StudyTable, content: Table, made: Structured, modules: tuple[Modules, ...], default: int | None) -> Design:
    counts, variants = [count for _, count in made.dimensions], plain.variants
    drawn = {i for one in modules for i in one.dimensions}
    if modules and plain.design not in INDEPENDENT:
        raise content.error(f"modules are drawn: write {', '.join(INDEPENDENT)} instead of {plain.design}", "design")
    fixed = "study with modules" if modules else plain.design if plain.design in FIXED else ""
    levels = tuple(0 if i in drawn or not fixed else count for i, count in enumerate(counts))
    if fixed:
        for i, (names, count) in enumerate(made.dimensions):
            if not count and i not in drawn:
                other = "belongs to no module: add it to [modules], or write" if modules else f"a {fixed} needs"
                raise content.error(f"{names[0]}: {other} values = [...]{_steps(fixed)}", "vary")
        if plain.design == "list" and len(set(levels)) > 1:
            raise content.error(f"lists of {sorted(set(levels))} values: a list needs as many of each", "vary")
        if variants is not None:
            raise content.error(f"a {fixed} has as many variants as its values give: leave this out", "variants")
        variants = levels[0] if plain.design == "list" else math.prod([*(one.count for one in modules), *filter(None, levels)])
        if variants > MOST:
            raise content.error(f"{variants} variants: {MOST} are the most", "modules" if modules else "vary")
    elif variants is None and (variants := default) is None:
        raise content.error("1 key is missing: variants")
    chunk = _chunk(plain, content, made)
    return Design(plain.design, variants, chunk, levels, plain.seed, _factor(content, made, plain.design, modules), modules)


def _steps(design: str) -> str:
    return "" if design == "list" else ", or steps = 21 beside uniform"


def _chunk(plain: StudyTable, content: Table, made: Structured) -> int:
    """Return the variants of a chunk: a power of two, smaller where signals are kept."""
    if plain.chunk is not None:
        if plain.chunk & (plain.chunk - 1):
            raise content.error(f"{plain.chunk} is not a power of two: write {1 << plain.chunk.bit_length()}", "chunk")
        return plain.chunk
    if not plain.signals:
        return CHUNK
    row = max(structure.reference.n_sample * structure.reference.n_axis for structure in made.structures.values())
    fits = SIGNAL_BYTES // (8 * row * len(plain.signals))
    return min(max(1 << max(fits, 1).bit_length() - 1, LANES), CHUNK)


def _factor(content: Table, made: Structured, design: str, modules: tuple[Modules, ...]) -> tuple[tuple[float, ...], ...]:
    """Return the factor of the correlations, given as ``correlations = [["axes.x.plant.mass", "axes.y.plant.mass", 0.8]]``."""
    node = content.get("correlations")
    if node is None:
        return ()
    if design not in INDEPENDENT:
        raise content.error(f"a {design} has none: leave this out", "correlations")
    dimension = {name: i for i, (names, _) in enumerate(made.dimensions) for name in names}
    kind = {i: one.name for one in modules for i in one.dimensions if i not in one.listed}
    matrix = np.eye(len(made.dimensions))
    items = node.plain()
    if not isinstance(items, list):
        raise content.error(f"write a list: [{EXAMPLE}, ...]", "correlations")
    for item in items:
        if not (isinstance(item, list) and len(item) == 3 and all(isinstance(name, str) for name in item[:2])):
            raise content.error(f"{item!r:.80}: write two varied parameters and a coefficient, {EXAMPLE}", "correlations")
        if isinstance(item[2], bool) or not isinstance(item[2], int | float) or not -1.0 < item[2] < 1.0:
            raise content.error(f"{item[2]!r:.40} is not a coefficient: write a number between -1 and 1", "correlations")
        try:
            pairs = [[dimension[name] for name in matching(word, dimension, "correlations", "[vary]")] for word in item[:2]]
        except ParameterError as error:
            raise content.error(f"{error.value}: must be {error.bound}", "correlations") from error
        for i, j in product(*pairs):
            if i == j:
                raise content.error(f"{item!r:.80}: both are one draw: name two", "correlations")
            if modules and (i not in kind or kind[i] != kind.get(j)):
                raise content.error(f"{item!r:.80}: only what is drawn for the same module can be correlated", "correlations")
            matrix[i, j] = matrix[j, i] = item[2]
    try:
        factor = np.linalg.cholesky(matrix)
    except np.linalg.LinAlgError:
        raise content.error("these correlations contradict each other: make them smaller", "correlations") from None
    return tuple(tuple(row) for row in factor.tolist())


EXAMPLE = '["axes.x.plant.mass", "axes.y.plant.mass", 0.8]'


# --- identity --------------------------------------------------------------------------------------------------------------------------


def _identity(study: Study) -> dict[str, str]:
    """Return digests of all that decides the results: program, scenario, and what the study varies and keeps."""
    scenario = hashlib.sha256()
    numbers = []
    for combo, structure in study.structures.items():
        scenario.update(f"{combo}\n{structure.identity}\n".encode())
        numbers.append([list(combo), [(name, i, asdict(drawn)) for name, i, drawn in structure.numbers]])
    choices = [asdict(choice) for choice in study.choices]
    settings = {"design": asdict(study.design), "choices": choices, "numbers": numbers, "keep": [*study.figures, *study.signals]}
    digest = hashlib.sha256(json.dumps(settings, sort_keys=True).encode()).hexdigest()
    return {"program": program_text(*ROOMS), "scenario": scenario.hexdigest(), "study": digest}
