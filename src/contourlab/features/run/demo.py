"""``contourlab demo``: the papers' modular stage, and a real part program on a three-axis machine."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from typing import Any

from contourlab.app.command_line import as_typed
from contourlab.app.json_values import write_json
from contourlab.app.results import staged
from contourlab.app.session import Answer, Session
from contourlab.features.run import options
from contourlab.features.run.command import Runs, run_schemes
from contourlab.features.run.summary import Summary
from contourlab.figures import figure, listing, number
from contourlab.rendering.one_page import write_overview
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


@dataclass(frozen=True, eq=False)
class Demonstration(Answer):
    """The parts of the demonstration: it has passed when the last (best) scheme of every part is within its tolerance."""

    parts: Mapping[str, Runs]
    page: str

    @property
    def passed(self) -> bool:
        """Whether the last scheme of every part is within its tolerance."""
        return all(_last(runs.summary)["verdict"]["passed"] for runs in self.parts.values())

    @property
    def json(self) -> Demo:
        """The summary of each part."""
        return Demo(self.passed, {name: runs.summary for name, runs in self.parts.items()})  # type: ignore[misc]

    @property
    def text(self) -> str:
        """A table of each part, the answer, and the next command."""
        tables = [_table(runs.data.title, runs.summary) for runs in self.parts.values()]
        verdict = paragraphs([f"{'PASS' if self.passed else 'FAIL'}: {_answer(self.json.parts)}"])
        return "\n\n".join([*tables, verdict, f"report: {self.page}\nnext: {NEXT}"])

    def save(self, folder: str | Path = "results") -> Demonstration:
        """Write nothing: each part was saved when it ended."""
        return self


def demo(settings: options.Demo, session: Session) -> Demonstration:
    """Run the demonstration: a folder for each part, an index page and a summary of the whole."""
    folder = session.saving["out"]
    parts: dict[str, Runs] = {}
    kept: list[str] = []
    page = folder / "report.html"
    with noted(lambda: f"Kept the parts before: {', '.join(kept)}" if kept else ""), staged(folder, "summary.json", "report.html") as stage:
        for (name, shipped), share in zip(DEMOS.items(), pairwise(SHARES), strict=True):
            one = replace(
                session, saving={"out": folder / name}, command=as_typed(["contourlab", "run", f"builtin:{shipped}", *settings.words()])
            )
            with part_of_command(*share):
                runs = run_schemes(load_scenario(builtin_file(shipped)), one, interval=settings.interval).save(folder / name)
            if runs.stopped is not None:
                raise runs.stopped
            parts[name] = runs
            kept.append(runs.files["report"])
        answer = Demonstration(parts, str(page))
        write_json(stage / "summary.json", answer.json)
        reports = {f"{name}/report.html": runs.data for name, runs in parts.items()}
        write_overview(stage / "report.html", _answer(answer.json.parts), reports, NEXT)
    return answer


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
