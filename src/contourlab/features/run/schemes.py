"""``contourlab compare`` and ``contourlab learn``: schemes of a scenario side by side."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from contourlab.errors import ParameterError, ScenarioError
from contourlab.features.run.command import RunOutcome, interval_words, run_session

if TYPE_CHECKING:
    from contourlab.scenario import Case, Scenario


def compare_schemes(
    file: str | Path,
    out: str | Path,
    *,
    schemes: Sequence[str] = (),
    trials: int | None = None,
    plugins: Sequence[str | Path] = (),
    plots: Sequence[str] = (),
    signals: Sequence[str] = (),
    progress: bool = False,
    interval: bool | None = None,
) -> RunOutcome:
    """Run schemes of a scenario side by side and time the servo tick of each; schemes that learn run trial after trial.

    Parameters
    ----------
    file : str or Path
        A scenario.
    out : str or Path
        Folder of the results.
    schemes : sequence of str
        Schemes of the scenario, or parts joined by + (`contourlab.scenario.FEATURES`); by default all schemes of the scenario.
    trials : int, optional
        Largest number of trials; by default that of the scenario.
    plugins, plots, signals, progress, interval
        As in `contourlab.features.run.command.run_scenario`.
    """
    scenario = _with_trials(loaded(file, schemes, plugins), trials)
    command = _command("compare", file, schemes, trials, plugins, interval_words(interval))
    return run_session(scenario, out, command=command, plots=plots, signals=signals, progress=progress, costs=True, interval=interval)


def learn_schemes(
    file: str | Path,
    out: str | Path,
    *,
    schemes: Sequence[str] = (),
    trials: int | None = None,
    table: str | Path | None = None,
    plugins: Sequence[str | Path] = (),
    plots: Sequence[str] = (),
    signals: Sequence[str] = (),
    progress: bool = False,
    interval: bool | None = None,
) -> RunOutcome:
    """Run the schemes that learn, trial after trial, beside the same without learning; write the learned tables.

    Parameters
    ----------
    file, out, schemes, trials, plugins, plots, signals, progress, interval
        As in `compare_schemes`; by default all schemes that learn.
    table : str or Path, optional
        Learned table to start with.

    Raises
    ------
    ScenarioError
        If none of the schemes learns.
    """
    scenario = loaded(file, schemes, plugins)
    learning = tuple(case for case in scenario.cases() if case.learning is not None)
    if not learning:
        example = '[learning]\nlaw = {kind = "zero-phase", gain = 0.2, half_width = 11}\ntrials = 30'
        raise ScenarioError(f"no scheme learns: add a law, for example:\n\n{example}\n", file=scenario.file)
    scenario = _with_trials(replace(scenario, all_cases=_with_first(learning)), trials)
    if table is not None:
        scenario = _changed(scenario, table=Path(table))
    more = [*interval_words(interval), *([] if table is None else ["--table", str(table)])]
    command = _command("learn", file, schemes, trials, plugins, more)
    return run_session(scenario, out, command=command, plots=plots, signals=signals, progress=progress, foretell=True, interval=interval)


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
    from contourlab.scenario import BUILTIN, chosen, load_scenario

    if not str(file).startswith(BUILTIN) and Path(file).suffix.lower() != ".toml":
        raise ScenarioError("not a scenario: its name must end in .toml", file=file)
    scenario = load_scenario(file, plugins=plugins)
    return chosen(scenario, schemes) if schemes else scenario


def _with_trials(scenario: Scenario, trials: int | None) -> Scenario:
    if trials is None:
        return scenario
    if trials < 1:
        raise ParameterError("--trials", f"{trials}", "1 or more")
    return _changed(scenario, trials=trials)


def _changed(scenario: Scenario, **settings: object) -> Scenario:
    """Change settings of learning in all cases that learn."""
    cases = tuple(
        case if case.learning is None else replace(case, learning=replace(case.learning, **settings))  # type: ignore[arg-type]
        for case in scenario.cases()
    )
    return replace(scenario, all_cases=cases)


def _command(
    name: str, file: str | Path, schemes: Sequence[str], trials: int | None, plugins: Sequence[str | Path], more: Sequence[str]
) -> str:
    words = ["contourlab", name, str(file), *(word for plugin in plugins for word in ("--plugin", str(plugin)))]
    words += ["--schemes", ",".join(schemes)] if schemes else []
    words += ["--trials", str(trials)] if trials is not None else []
    return shlex.join([*words, *more])
