"""``contourlab compare`` and ``contourlab learn``: schemes of a scenario side by side."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from contourlab.errors import ParameterError, ScenarioError
from contourlab.features.run.command import RunOptions, RunOutcome, run_session
from contourlab.file_kinds import mistaken

if TYPE_CHECKING:
    from contourlab.scenario import Case, Scenario


def compare_schemes(
    file: str | Path, options: RunOptions, *, schemes: Sequence[str] = (), trials: int | None = None, judge: str | None = None
) -> RunOutcome:
    """Run schemes of a scenario side by side and time the servo tick of each; schemes that learn run trial after trial.

    Parameters
    ----------
    file : str or Path
        A scenario.
    options : RunOptions
    schemes : sequence of str
        Schemes of the scenario, or parts joined by + (`contourlab.scenario.FEATURES`); by default all schemes of the scenario.
    trials : int, optional
        Largest number of trials; by default that of the scenario.
    judge : str, optional
        Moves to judge; by default as in the scenario.
    """
    scenario = _with_settings(loaded(file, schemes, options.plugins).judging(judge), trials)
    return run_session(scenario, options, command=options.command("compare", file, _typed(schemes, trials, judge)), costs=True)


def learn_schemes(
    file: str | Path,
    options: RunOptions,
    *,
    schemes: Sequence[str] = (),
    trials: int | None = None,
    judge: str | None = None,
    table: Path | None = None,
) -> RunOutcome:
    """Run the schemes that learn, trial after trial, beside the same without learning; write the learned tables.

    Parameters
    ----------
    file, options, schemes, trials, judge
        As in `compare_schemes`; by default all schemes that learn.
    table : Path, optional
        Learned table to start with.

    Raises
    ------
    ScenarioError
        If none of the schemes learns.
    """
    scenario = loaded(file, schemes, options.plugins).judging(judge)
    learning = tuple(case for case in scenario.cases() if case.learning is not None)
    if not learning:
        example = '[learning]\nlaw = {kind = "zero-phase", gain = 0.2, half_width = 11}\ntrials = 30'
        raise ScenarioError(f"no scheme learns: add a law, for example:\n\n{example}\n", file=scenario.file)
    scenario = _with_settings(replace(scenario, all_cases=_with_first(learning)), trials, table)
    command = options.command("learn", file, {**_typed(schemes, trials, judge), "--table": table})
    return run_session(scenario, options, command=command, foretell=True)


def _typed(schemes: Sequence[str], trials: int | None, judge: str | None) -> dict[str, Any]:
    return {"--schemes": ",".join(schemes) or None, "--trials": trials, "--judge": judge}


def _with_first(cases: Sequence[Case]) -> tuple[Case, ...]:
    """Put a copy that does not learn before each case."""
    pairs: list[Case] = []
    for case in cases:
        name = "before learning" if len(cases) == 1 else f"{case.name}, before"
        pairs += [replace(case, name=name, learning=None), case if case.name != "base" else replace(case, name="after learning")]
    return tuple(pairs)


def loaded(file: str | Path, schemes: Sequence[str], plugins: Sequence[str | Path]) -> Scenario:
    """Read a scenario with the schemes asked for, or with its own.

    Raises
    ------
    ScenarioError
        If the file is not a scenario, or has no such scheme.
    """
    from contourlab.scenario import BUILTIN, chosen, load_scenario, shipped_hint

    if not (str(file).startswith(BUILTIN) or Path(file).suffix.lower() == ".toml" or Path(file).is_dir()):
        if not Path(file).exists():
            raise ScenarioError(f"no such file{shipped_hint(file)}", file=file)
        raise ScenarioError(mistaken(file, "a scenario") or "not a scenario: its name must end in .toml", file=file)
    scenario = load_scenario(file, plugins=plugins)
    return chosen(scenario, schemes) if schemes else scenario


def _with_settings(scenario: Scenario, trials: int | None, table: Path | None = None) -> Scenario:
    """Change the number of trials and the first table, where given, in all cases that learn."""
    if trials is not None and trials < 1:
        raise ParameterError("--trials", f"{trials}", "1 or more")
    given: dict[str, Any] = {name: value for name, value in (("trials", trials), ("table", table)) if value is not None}
    cases = (case if case.learning is None else replace(case, learning=replace(case.learning, **given)) for case in scenario.cases())
    return replace(scenario, all_cases=tuple(cases)) if given else scenario
