"""Schemes by their parts: ``fb``, ``ccc``, ``mr``, ``me`` and ``ilc``, joined by +, made of what a scenario holds.

A scenario says once how it would cross-couple and how it would learn, in its base or in any scheme; from that every combination follows.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import Any

from contourlab.components.registry import component
from contourlab.errors import ScenarioError
from contourlab.loop import Controller
from contourlab.scenario.case import Case, Scenario
from contourlab.scenario.learning import LearningSettings

FEATURES = {
    "fb": "the axes' own controllers alone",
    "ccc": "cross-coupled control",
    "mr": "modified reference",
    "me": "modified error",
    "ilc": "learning from trial to trial",
}
"""Parts of a scheme's name, and what they stand for."""

_KINDS = {"ccc": ("cross-coupled", "cross-coupled-filter"), "mr": ("modified-reference",), "me": ("modified-error",)}
_WANTED = {
    "ccc": '[controller]\nestimator = "tangent"\ncoupling = {kind = "cross-coupled", gain = ...}',
    "ilc": '[learning]\nlaw = {kind = "zero-phase", gain = 0.2, half_width = 11}',
}


def chosen(scenario: Scenario, names: Iterable[str]) -> Scenario:
    """Return the scenario with these schemes and no others.

    Parameters
    ----------
    scenario : Scenario
    names : iterable of str
        Schemes of the scenario, or parts joined by +: see `FEATURES`. A scheme of the scenario goes before. One whose name has commas may
        come in the pieces between them, as a list with commas is taken apart.

    Raises
    ------
    ScenarioError
        If a name is neither, is given twice, or asks for a part that the scenario does not hold.
    """
    own = {case.name: case for case in scenario.all_cases}
    wanted = _whole([name.strip() for name in names], own)
    twice = [name for name in wanted if wanted.count(name) > 1]
    if twice:
        raise ScenarioError(f"scheme {twice[0]!r} is asked for twice", file=scenario.file)
    cases = tuple(own[name] if name in own else _composed(scenario, name) for name in wanted)
    if not cases:
        raise ScenarioError("no scheme is asked for: give names such as fb,ccc,ilc,ccc+ilc", file=scenario.file)
    return replace(scenario, all_cases=cases, schemes={name: scenario.schemes.get(name, {}) for name in wanted})


def _whole(words: list[str], own: Iterable[str]) -> list[str]:
    """Return names, those of schemes put together again of pieces that follow one another; of several the longest."""
    pieces = {tuple(part.strip() for part in name.split(",")): name for name in own}
    found = []
    while words:
        n = next((n for n in range(len(words), 1, -1) if tuple(words[:n]) in pieces), 1)
        found.append(pieces[tuple(words[:n])] if n > 1 else words[0])
        words = words[n:]
    return found


def _composed(scenario: Scenario, name: str) -> Case:
    parts = name.split("+")
    unknown = [part for part in parts if part not in FEATURES]
    if unknown:
        known = ", ".join([*(repr(case.name) for case in scenario.all_cases), *FEATURES])
        raise ScenarioError(f"no scheme {name!r}: there are {known}, and these parts joined by +", file=scenario.file)
    couplings = [part for part in parts if part in _KINDS]
    if len(couplings) > 1 or len(set(parts)) < len(parts):
        raise ScenarioError(f"scheme {name!r}: one coupling at most, and each part once: ccc+ilc, mr+ilc", file=scenario.file)
    controller = _coupled(scenario, couplings[0]) if couplings else replace(scenario.base.controller, estimator=None, coupling=None)
    learning = _learning(scenario) if "ilc" in parts else None
    return replace(scenario.base, name=name, controller=controller, learning=learning)


def _coupled(scenario: Scenario, part: str) -> Controller:
    """Return the base's controller with a coupling, as it stands in the base or in the first scheme that has one of its kind."""
    base, kinds = scenario.base.controller, _KINDS[part]
    held = _first(scenario, lambda case: case.controller if case.controller.coupling and case.controller.coupling.kind in kinds else None)
    estimator: Any
    if held is not None:
        estimator, coupling = held.estimator, held.coupling
    elif part in _WANTED:
        raise ScenarioError(_missing(part), file=scenario.file)
    else:
        estimator, coupling = base.estimator or component("estimator", "newton")(), component("coupling", kinds[0])()
    return replace(base, estimator=estimator, coupling=coupling)


def _learning(scenario: Scenario) -> LearningSettings:
    found: LearningSettings | None = _first(scenario, lambda case: case.learning)
    if found is None:
        raise ScenarioError(_missing("ilc"), file=scenario.file)
    return found


def _first(scenario: Scenario, of: Callable[[Case], Any]) -> Any:
    cases: Iterator[Case] = iter((scenario.base, *scenario.all_cases))
    return next((found for found in map(of, cases) if found is not None), None)


def _missing(part: str) -> str:
    said = f"{part} stands for {FEATURES[part]}, of which neither the base nor a scheme says anything"
    return f"{said}; write, for example:\n\n{_WANTED[part]}\n"
