"""``contourlab demo``: the papers' modular stage, and a real part program on a three-axis machine."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from typing import ClassVar

from contourlab.app.command_line import as_typed
from contourlab.app.json_values import write_json
from contourlab.app.results import staged
from contourlab.app.session import Answer, Session
from contourlab.features.run import options
from contourlab.features.run.command import Runs, run_schemes
from contourlab.features.run.outcome import Outcome
from contourlab.figures import figure, listing, number
from contourlab.rendering.one_page import write_overview
from contourlab.rendering.stages import part_of_command
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.scenario import builtin_file, load_scenario
from contourlab.study.checkpoint import noted

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
    """The parts of the demonstration, each judged by its last (best) scheme."""

    json_form: ClassVar = {"passed": "passed", "parts": "parts", "schema": "schema"}

    parts: dict[str, Runs]
    page: str
    schema: str = "contourlab-demo/1"

    @property
    def passed(self) -> bool:
        """Whether the last scheme of every part is within its tolerance."""
        return all(_passes(runs.outcomes[-1]) for runs in self.parts.values())

    @property
    def sentence(self) -> str:
        """The largest errors with the first and with the last controller of each case, and how many pass."""

        def sizes(which: int) -> str:
            outcomes = [runs.outcomes[which] for runs in self.parts.values()]
            largest = listing([number(1e6 * outcome.metrics.part_error.max) for outcome in outcomes])
            return f"{largest} um: {sum(map(_passes, outcomes))} of {len(outcomes)} cases pass"

        return f"With the position loop alone the tool strays by up to {sizes(0)}. With the best controllers by up to {sizes(-1)}."

    @property
    def text(self) -> str:
        """A table of each part, the answer, and the next command."""
        tables = [_table(runs) for runs in self.parts.values()]
        verdict = paragraphs([f"{'PASS' if self.passed else 'FAIL'}: {self.sentence}"])
        return "\n\n".join([*tables, verdict, f"report: {self.page}\nnext: {NEXT}"])


def demo(settings: options.Demo, session: Session) -> Demonstration:
    """Run the demonstration: a folder for each part, an index page and a summary of the whole."""
    folder = session.saving["out"]
    answer = Demonstration({}, str(folder / "report.html"))

    def kept() -> str:
        return f"Kept the parts before: {', '.join(runs.files['report'] for runs in answer.parts.values())}" if answer.parts else ""

    with noted(kept), staged(folder, "summary.json", "report.html") as stage:
        for (name, shipped), share in zip(DEMOS.items(), pairwise(SHARES), strict=True):
            command = as_typed(["contourlab", "run", f"builtin:{shipped}", *settings.words()])
            own = replace(session, saving={"out": folder / name}, command=command)
            with part_of_command(*share):
                runs = run_schemes(load_scenario(builtin_file(shipped)), own, interval=settings.interval).save(folder / name)
            if runs.stopped is not None:
                raise runs.stopped
            answer.parts[name] = runs
        write_json(stage / "summary.json", answer)
        reports = {f"{name}/report.html": runs.data for name, runs in answer.parts.items()}
        write_overview(stage / "report.html", answer.sentence, reports, NEXT)
    return answer


def _passes(outcome: Outcome) -> bool:
    return outcome.verdict is not None and outcome.verdict.passed


def _table(runs: Runs) -> str:
    """Return the part errors of all schemes of a run."""
    keys = ("max", "rms", "mean", "signed_mean", "integral")
    heads = [Column(f"{key.replace('_', ' ')} [{'um s' if key == 'integral' else 'um'}]") for key in keys]
    title = f"{runs.data.title}: part error against {figure(runs.data.tolerance, 'um')}"
    rows = (
        (one.name, *(number(1e6 * getattr(one.metrics.part_error, key)) for key in keys), "pass" if _passes(one) else "fail")
        for one in runs.outcomes
    )
    return Table([Column("scheme", left=True), *heads, Column("verdict", left=True)], title, rows=rows).text()
