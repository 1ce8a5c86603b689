"""The next command to type after a run: judge, try the proposed controller, tune, or find what the error depends on."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from pathlib import Path

from contourlab.app.command_line import as_typed, chosen_options
from contourlab.features.run.summary import Outcome


def next_steps(outcomes: Sequence[Outcome], command: str, out: Path, proposed: Sequence[str]) -> list[tuple[str, str]]:
    """Return what to do next, and the command for it, the most useful first.

    Parameters
    ----------
    outcomes : sequence of Outcome
        At least one.
    command : str
        As typed.
    out : Path
        Folder of the results.
    proposed : sequence of str
        Files with a changed controller, relative to the folder.
    """
    file, options = _split(command)
    plugins = chosen_options(options, "--plugin")
    part = "--controller" in options or "--machine" in options
    judged = [outcome for outcome in outcomes if outcome.verdict is not None]
    if not judged:
        limit = max(2.0 * min(outcome.metrics.part_error.max for outcome in outcomes), 1e-9)  # not the rounding of a straight line
        words = [*options, "--tolerance", f"{float(f'{1e6 * limit:.1g}'):g} um"]
        explore = ("Find what the error depends on:", _typed("sensitivity", file, ["--quick", *plugins]))
        return [("Judge it against a tolerance:", _typed("run", file, words)) if part else explore]
    steps: list[tuple[str, str]] = []
    if all(any(finding.code == "CL208" for finding in outcome.findings) for outcome in judged):
        return [("Change the plan, not the gains:", as_typed(["contourlab", "explain", "CL208"]))]
    kept = [outcome for outcome in judged if outcome.verdict is not None and outcome.verdict.passed]
    if proposed and part and not kept:
        changed = _without(_without(options, "--controller"), "--out")
        words = [*changed, "--controller", str(out / proposed[0]), "--out", f"{out}-changed"]
        steps.append(("Run it with the changed controller:", _typed("run", file, words)))
    scheme = [] if outcomes[-1].name == "base" else ["--scheme", min(judged, key=lambda one: one.metrics.part_error.max).name]
    if not kept or part:
        steps.append(("Search all gains:", _typed("tune", file, [*_of_case(options), *scheme])))
    else:
        steps.append(("Find what the error depends on:", _typed("sensitivity", file, ["--quick", *scheme, *plugins])))
    return steps


def _split(command: str) -> tuple[str, list[str]]:
    """Return the file and the options of a command as typed."""
    words = shlex.split(command)[2:]
    return words[0], [word for word in words[1:] if word not in ("--interval", "--no-interval")]


def _of_case(options: Sequence[str]) -> list[str]:
    """Return the options that say what runs, with their values."""
    for name in ("--schemes", "--trials", "--table"):
        options = _without(options, name)
    return list(options)


def _without(options: Sequence[str], name: str) -> list[str]:
    if name not in options:
        return list(options)
    at = options.index(name)
    return [*options[:at], *options[at + 2 :]]


def _typed(command: str, file: str, options: Sequence[str]) -> str:
    return as_typed(["contourlab", command, file, *options])
