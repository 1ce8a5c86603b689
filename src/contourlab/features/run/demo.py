"""``contourlab demo``: the papers' modular stage, and a real part program on a three-axis machine."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

from contourlab.app.json_values import json_values, write_json
from contourlab.app.results import staged
from contourlab.features.run.command import RunOptions, RunOutcome, run_session
from contourlab.features.run.summary import Summary
from contourlab.figures import figure, listing, number
from contourlab.rendering.data import ReportData
from contourlab.rendering.overview import write_overview
from contourlab.rendering.stages import part_of_command
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.scenario import builtin_file, load_scenario
from contourlab.study.checkpoint import noted


@dataclass(frozen=True)
class Demo:
    """The results of ``demo``: whether the last scheme of each part passed, and the summary of each part."""

    passed: bool
    parts: Mapping[str, Summary]
    schema: str = "contourlab-demo/1"


DEMOS = {
    "stage-a3a1": "ghaffari/demo-stage",
    "stage-a3a2": "ghaffari/demo-stage-a3a2",
    "part": "demo-part",
}
"""Folder of each part of the demonstration -> the shipped scenario that it runs."""
SHARES = (0.0, 0.35, 0.55, 1.0)
"""Share of the work that is done before each part, and after the last."""
NEXT = "contourlab new machine --preset mill --out mill && contourlab run mill"


def run_demo(out: str | Path, *, progress: bool = False, interval: bool | None = None) -> RunOutcome:
    """Run the demonstration: a folder for each part, an index page and a summary of the whole.

    The outcome has passed when the last (best) scheme of every part is within its tolerance. Parameters are those of `RunOptions`.
    """
    folder = Path(out)
    reports: dict[str, ReportData] = {}
    summaries: dict[str, Any] = {}
    parts: list[str] = []
    kept: list[str] = []
    with noted(lambda: f"Kept the parts before: {', '.join(kept)}" if kept else ""), staged(folder, "summary.json", "report.html") as stage:
        for (name, shipped), share in zip(DEMOS.items(), pairwise(SHARES), strict=True):
            scenario = load_scenario(builtin_file(shipped))
            options = RunOptions(folder / name, progress=progress, interval=interval)
            with part_of_command(*share):
                outcome = run_session(scenario, options, command=options.command("run", f"builtin:{shipped}", {}))
            summaries[name] = outcome.summary
            if outcome.data is not None:
                reports[f"{name}/report.html"] = outcome.data
                parts.append(_table(outcome.data.title, outcome.summary))
                kept.append(str(folder / name / "report.html"))
        passed = all(_last(summary)["verdict"]["passed"] for summary in summaries.values())
        summary: dict[str, Any] = json_values(Demo(passed, summaries))
        write_json(stage / "summary.json", summary)
        write_overview(stage / "report.html", _answer(summaries), reports, NEXT)
    verdict = paragraphs([f"{'PASS' if passed else 'FAIL'}: {_answer(summaries)}"])
    conclusion = f"{verdict}\n\nreport: {folder / 'report.html'}\nnext: {NEXT}"
    return RunOutcome(passed, summary, "\n\n".join([*parts, conclusion]))


def _answer(summaries: Mapping[str, Any]) -> str:
    """Return the sentence on top: the largest errors with the first and with the last controller of each case, and how many pass."""

    def told(which: int) -> str:
        schemes = [list(summary["schemes"].values())[which] for summary in summaries.values()]
        sizes = listing([number(1e6 * scheme["metrics"]["part_error"]["max"]) for scheme in schemes])
        passed = sum(scheme["verdict"]["passed"] for scheme in schemes)
        return f"{sizes} um: {passed} of {len(schemes)} cases pass"

    return f"With the position loop alone the tool strays by up to {told(0)}. With the best controllers by up to {told(-1)}."


def _last(summary: dict[str, Any]) -> dict[str, Any]:
    scheme: dict[str, Any] = list(summary["schemes"].values())[-1]
    return scheme


def _table(title: str, summary: dict[str, Any]) -> str:
    """Return the part errors of all schemes of a run."""
    title = f"{title}: part error against {figure(_last(summary)['verdict']['tolerance'], 'um')}"
    keys = ("max", "rms", "mean", "signed_mean", "integral")
    heads = [Column(f"{key.replace('_', ' ')} [{'um s' if key == 'integral' else 'um'}]") for key in keys]
    table = Table([Column("scheme", left=True), *heads, Column("verdict", left=True)], title)
    for name, scheme in summary["schemes"].items():
        error, passed = scheme["metrics"]["part_error"], scheme["verdict"]["passed"]
        table.add(name, *(number(1e6 * error[key]) for key in keys), "pass" if passed else "fail")
    return table.text()
