"""``contourlab compare`` and ``contourlab learn``: schemes of a scenario side by side."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from contourlab.app.session import QUIET, Session, question
from contourlab.errors import ScenarioError
from contourlab.features.learn import learn as learn_machine
from contourlab.features.run.command import Runs, run_schemes
from contourlab.features.run.options import Compare, Learn
from contourlab.features.run.source import scenario_asked
from contourlab.scenario import Case, Scenario


def compare_schemes(source: Sequence[Any], settings: Compare, session: Session) -> Runs:
    """Run schemes of a scenario side by side and time the servo tick of each; schemes that learn run trial after trial."""
    scenario = _with_settings(scenario_asked(source, settings), settings.trials)
    return run_schemes(scenario, session, interval=settings.interval, costs=True)


@question(Learn, "learn")
def learn_schemes(*source: str | Path | Scenario, settings: Learn, session: Session = QUIET) -> Runs:
    """Run the schemes that learn, trial after trial, beside the same without learning.

    Parameters
    ----------
    *source : str, Path or Scenario
        A scenario, as a file or read; by default all of its schemes that learn.

    Returns
    -------
    Runs

    Raises
    ------
    ScenarioError
        If none of the schemes learns.
    """
    scenario = scenario_asked(source, settings)
    learning = tuple(case for case in scenario.cases() if case.learning is not None)
    if not learning:
        example = '[learning]\nlaw = {kind = "zero-phase", gain = 0.2, half_width = 11}\ntrials = 30'
        raise ScenarioError(f"no scheme learns: add a law, for example:\n\n{example}\n", file=scenario.file)
    scenario = _with_settings(replace(scenario, all_cases=_with_first(learning)), settings.trials, settings.table)
    return run_schemes(scenario, session, interval=settings.interval, foretell=True)


def learn(*source: Any, **options: Any) -> Any:
    """Learn from trial to trial: the schemes of a scenario that learn, or one machine with a law.

    Parameters
    ----------
    *source : str, Path or Scenario; or Machine, Controller, Reference and LearningLaw
        A scenario, as a file or read; or what `contourlab.features.learn.learn` takes.
    **options : object
        Those of ``contourlab learn``; or the keywords of `contourlab.features.learn.learn`.

    Returns
    -------
    Runs or LearningRun
        `LearningRun` of a machine.

    Raises
    ------
    ScenarioError
        If none of the schemes learns.
    """
    if source and isinstance(source[0], str | Path | Scenario):
        return learn_schemes(*source, **options)
    return learn_machine(*source, **options)


learn.forms = (learn_schemes, learn_machine)  # type: ignore[attr-defined]  # for type checkers


def _with_first(cases: Sequence[Case]) -> tuple[Case, ...]:
    """Put a copy that does not learn before each case."""
    pairs: list[Case] = []
    for case in cases:
        name = "before learning" if len(cases) == 1 else f"{case.name}, before"
        pairs += [replace(case, name=name, learning=None), case if case.name != "base" else replace(case, name="after learning")]
    return tuple(pairs)


def _with_settings(scenario: Scenario, trials: int | None, table: Path | None = None) -> Scenario:
    """Change the number of trials and the first table, where given, in all cases that learn."""
    given: dict[str, Any] = {name: value for name, value in (("trials", trials), ("table", table)) if value is not None}
    cases = (case if case.learning is None else replace(case, learning=replace(case.learning, **given)) for case in scenario.cases())
    return replace(scenario, all_cases=tuple(cases)) if given else scenario
