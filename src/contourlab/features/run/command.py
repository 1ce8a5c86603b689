"""``contourlab run``, ``compare`` and ``learn``: a scenario, or a part program on a machine, through to its report."""

from __future__ import annotations

import shlex
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import chain, count
from pathlib import Path
from typing import Any, ClassVar

from contourlab import __version__
from contourlab.app.cite import stamp_of
from contourlab.app.command_line import as_typed, chosen_options, without_options
from contourlab.app.json_values import json_values, write_json
from contourlab.app.results import proposed, staged
from contourlab.app.session import QUIET, Answer, Session, interrupt, question
from contourlab.components.friction.laws import NoFriction
from contourlab.errors import DivergenceError, ScenarioError
from contourlab.features.check.program_check import origin_of
from contourlab.features.learn import LearnedTable
from contourlab.features.learn import learn as learn_machine
from contourlab.features.run.changes import of_machine
from contourlab.features.run.options import Compare, Learn, Run
from contourlab.features.run.outcome import Outcome, run_case
from contourlab.features.run.record import write_switches
from contourlab.features.run.source import Source, is_scenario, scenario_asked
from contourlab.features.run.trust import NOTABLE
from contourlab.figures import figure, limit_to_propose
from contourlab.findings import Finding
from contourlab.metrics.figures import judged_part
from contourlab.rendering.data import JudgedRun
from contourlab.rendering.origins import numbers_of
from contourlab.rendering.stages import begin_stage
from contourlab.rendering.table import paragraphs
from contourlab.result import Status, write_text_atomic
from contourlab.scenario import Case, Scenario

SCHEMA = "contourlab-summary/1"
FIRST, LEARNING = ("planning", 1.0), (("analysing", 4.0), ("learning", 30.0))
DRAWING, WRITING = ("drawing", 20.0), (("writing signals", 1.5), ("writing the report", 2.5))
"""First words of stages and their work, roughly as measured."""


@dataclass(frozen=True)
class DivergedScheme:
    """A scheme that diverged."""

    status: Status


class JudgedRuns(Answer):
    """Judged runs, simulated or measured: `schemes` has them by name, `data` is their report."""

    ROW: ClassVar = "scheme"
    schemes: Any
    data: Any

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The figures of all runs, as in ``summary.json``."""
        values: dict[str, Any] = json_values(self)
        return values

    @property
    def json(self) -> dict[str, Any]:
        """The summary."""
        return self.summary

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The findings of all runs, each once."""
        return tuple({str(each): each for run in self.schemes.values() for each in getattr(run, "findings", ())}.values())

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The figures of each run, one run a row."""
        return [{self.ROW: name, **figures} for name, figures in self.summary["schemes"].items()]

    def _latex_tables(self) -> Sequence[Any]:
        from contourlab.rendering.comparison import comparison_table, with_intervals

        return [comparison_table(with_intervals(self.data), self.data.title)]

    def _charts(self) -> Iterator[Any]:
        from contourlab.rendering.plots import charts_of

        yield from charts_of(self.data)

    def _pictures(self) -> Iterator[Any]:
        from contourlab.rendering.html import picture_groups

        yield from chain.from_iterable(picture_groups(self._of_page()).values())

    def _of_page(self) -> Any:
        """Return the data of the report's page."""
        return self.data

    def _write(self, stage: Path, plots: Sequence[str]) -> None:
        """Write summary.json, report.html and plots into a temporary folder."""
        from contourlab.rendering.html import write_html
        from contourlab.rendering.plots import write_plots

        write_json(stage / "summary.json", self.summary)
        write_html(self.data, stage / "report.html")
        write_plots(self.data, stage / "plots", tuple(plots))


@dataclass(frozen=True, eq=False)
class Runs(JudgedRuns):
    """Judged runs of the schemes of a scenario.

    Attributes
    ----------
    scenario : Scenario
    outcomes : tuple of Outcome
        Of the schemes that ended, in their order.
    diverged : dict of str to DivergenceError
        Schemes that ran away.
    name : str
        Of the scenario.
    command : str
        The command that does the same.
    version : str
        Of contourlab.
    interrupted : bool
        Whether Ctrl-C ended the work before the last scheme.
    files : dict of str to str
        What was saved, and where.
    steps : tuple of (str, str)
        What to do next, and the command for it; empty before it is saved.
    """

    SILENT = True
    json_form: ClassVar = {"name": "scenario.name"} | {
        name: name for name in ("command", "machine", "notes", "passed", "schemes", "schema", "version")
    }

    scenario: Scenario
    outcomes: tuple[Outcome, ...]
    diverged: Mapping[str, DivergenceError]
    command: str
    interrupted: bool = False
    files: Mapping[str, str] = field(default_factory=dict)
    steps: tuple[tuple[str, str], ...] = ()
    schema: str = SCHEMA
    version: str = __version__

    @property
    def schemes(self) -> dict[str, Outcome | DivergedScheme]:
        """The schemes by name; of those that diverged the status only."""
        lost = {name: DivergedScheme(Status(False, error.sample, error.axis, str(error))) for name, error in self.diverged.items()}
        return {outcome.name: outcome for outcome in self.outcomes} | lost

    @property
    def machine(self) -> dict[str, Any]:
        """Name of the base's machine; of a control's own file also the control, and the origin of each number."""
        return {"name": self.scenario.machine.name, **origin_of(self.scenario.machine)}

    @property
    def notes(self) -> tuple[str, ...]:
        """On the motion: leniency of the program's reader, scaling, contours from files."""
        return self.outcomes[0].case.motion.notes if self.outcomes else ()

    @property
    def passed(self) -> bool | None:
        """Whether every verdict passed; None without a tolerance."""
        verdicts = [outcome.verdict.passed for outcome in self.outcomes if outcome.verdict is not None]
        return False if self.diverged else all(verdicts) if verdicts else None

    @property
    def stopped(self) -> BaseException | None:
        """The interrupt, or the error of the first scheme that diverged."""
        if not self.interrupted:
            return next(iter(self.diverged.values()), None)
        kept = f"Kept {len(self.outcomes)} of {len(self.scenario.cases())} schemes: {self.files.get('report')}"
        return interrupt(kept if "report" in self.files else "")

    @cached_property
    def data(self) -> Any:
        """The data of the report."""
        from contourlab.features.run.report import report_data
        from contourlab.scenario.dump import dump

        from_file = getattr(self.scenario.base, "given", None) is None  # a planned reference has no text
        text = dump(self.scenario) if from_file else ""
        data = report_data(self.scenario.name, self.outcomes, scenario=text, command=self.command)
        return replace(data, next_steps=self.steps)

    def _of_page(self) -> Any:
        """Return the data of the report with the loops that its page runs."""
        from contourlab.features.run.live import live_loop

        return replace(self.data, live=self.data.live or live_loop(self.outcomes, self.command))

    @property
    def text(self) -> str:
        """Tables, verdicts and findings; files and the next command once it is saved."""
        from contourlab.rendering.comparison import comparison_text
        from contourlab.rendering.lead import answer
        from contourlab.rendering.learning_pictures import trials_text
        from contourlab.rendering.page_tables import reversal_text
        from contourlab.rendering.switching import switch_lines

        data, outcomes = self.data, self.outcomes
        axes = [axis for outcome in outcomes for axis in outcome.case.machine.axes]
        # Friction, backlash and hysteresis show at reversals.
        shows = any(not isinstance(axis.friction, NoFriction) or axis.error.repeatability + axis.error.backlash > 0.0 for axis in axes)
        reversals = reversal_text(data) if shows or any(axis.plant.two_sided and axis.plant.linear() != axis.plant for axis in axes) else ""
        shared = [finding for finding in outcomes[0].findings if all(finding in other.findings for other in outcomes)]
        answers = [f"{outcome.name}: {answer(outcome)}" for outcome in outcomes if outcome.verdict is not None]
        endings = [line for outcome in outcomes for line in ending(outcome, shared)]
        ends = paragraphs([*endings, *map(str, shared)])
        written = [f"{what}: {file}" for what, file in self.files.items()]
        files = "\n".join([*written, *(f"next: {step}" for _, step in self.steps[:1])])
        texts = [paragraphs(answers), comparison_text(data), trials_text(data), reversals, "\n".join(switch_lines(data)), ends, files]
        return "\n\n".join(filter(None, texts))

    def save(self, folder: str | Path = "results", *, plots: Sequence[str] = (), pdf: bool = False, signals: Sequence[str] = ()) -> Runs:
        """Write signals, summary.json, report.html, plots and proposed controllers into a folder.

        Parameters
        ----------
        folder : str or Path
        plots : sequence of str
            Formats of further plots: png, svg, pdf.
        pdf : bool
            Whether to write ``report.pdf``, one page to print.
        signals : sequence of str
            Signals to write; by default those of the scenario, or all.

        Returns
        -------
        Runs
            With the names of its files.

        Raises
        ------
        OutputError
            If the folder cannot be written.
        """
        from contourlab.scenario.dump import dump

        out, names = Path(folder), file_names([case.name for case in self.scenario.cases()])
        with staged(out, *_outputs(self.scenario, pdf), inputs=self.scenario.inputs) as stage:
            begin_stage("writing signals")
            files: dict[str, str] = {}
            for outcome in self.outcomes:
                name = names[outcome.name]
                judged = judged_part(outcome.result, outcome.reference).text  # for a comparison of finished runs
                attributes = {**outcome.result.attributes, "judged": judged}
                result = replace(outcome.result, attributes=attributes, made_by=stamp_of(outcome.case))
                if wanted := signals or outcome.case.run.signals:
                    result = result.only(wanted)
                result.save(stage / "signals" / f"{name}.nc")
                if outcome.learning is not None:
                    outcome.learning.table.save(stage / "learned" / f"{name}.nc")
                if outcome.verdict is not None and outcome.verdict.proposed is not None:
                    text = proposed(f"Proposed for {outcome.name}.", dump(outcome.verdict.proposed, outcome.case.machine))
                    write_text_atomic(stage / "proposed" / f"{name}.toml", text)
                    files[f"{outcome.name}, changed controller"] = f"proposed/{name}.toml"
                if outcome.switches is not None:
                    write_switches(stage / "switches" / f"{name}.csv", outcome.switches)
            begin_stage("writing the report")
            steps = tuple(next_steps(self.outcomes, self.command, out, list(files.values())))
            files |= {"report": "report.html"} | ({"to print": "report.pdf"} if pdf else {})
            saved = replace(self, steps=steps, files={what: str(out / file) for what, file in files.items()})
            vars(saved)["summary"] = self.summary  # computed once
            vars(saved)["data"] = saved._of_page()
            saved._write(stage, plots)
            if pdf:
                from contourlab.rendering.one_page import write_page

                write_page(saved.data, stage / "report.pdf")
        return saved


@dataclass(frozen=True)
class Planned(Answer):
    """A scenario that was read and planned, and not simulated.

    Attributes
    ----------
    checked : str
        Name of the scenario.
    schemes : dict of str to dict
        Samples, duration [s] and length of the path [m] of each scheme.
    """

    checked: str
    schemes: Mapping[str, Mapping[str, float]]

    @property
    def text(self) -> str:
        """The motion of each scheme."""
        lines = [f"{self.checked}: no fault"]
        for name, motion in self.schemes.items():
            length, duration = figure(motion["path_length"], "mm", 6), figure(motion["duration"], "s", 6)
            lines.append(f"{name}: path {length}, {duration}, {motion['n_sample']} samples")
        return "\n".join(lines)

    def save(self, folder: str | Path = "results", **_: Any) -> Planned:
        """Write nothing."""
        return self


@question(Run)
def run(*source: Source, settings: Run, session: Session = QUIET) -> Runs | Planned:
    """Simulate every scheme of a scenario, or a part program on a machine, and judge it.

    A scheme that diverges is named in the answer; the others run on. Ctrl-C keeps the schemes that ended.

    Parameters
    ----------
    *source : str, Path, Scenario, Case, or a Machine, its Controller and a Reference
        A scenario (``.toml``, or a folder with a ``scenario.toml``) or a part program, as a file or read; or what a scenario consists of.

    Returns
    -------
    Runs or Planned
        `Planned` for ``check``.

    Raises
    ------
    ScenarioError, ProgramError, ParameterError
        If an input cannot be read, or an option does not fit it.
    DivergenceError
        If every scheme diverges.
    """
    scenario = scenario_asked(source, settings)
    if not settings.check:
        return run_schemes(scenario, session, interval=settings.interval)
    schemes = {}
    for case in scenario.cases():
        reference = case.reference()
        duration = (reference.n_sample - 1) * reference.servo_period
        schemes[case.name] = {"n_sample": reference.n_sample, "duration": duration, "path_length": reference.path.length}
    return Planned(scenario.name, schemes)


def run_schemes(
    scenario: Scenario, session: Session = QUIET, *, interval: bool | None = None, costs: bool = False, foretell: bool = False
) -> Runs:
    """Run every scheme of a scenario. `costs` times the servo tick, `foretell` analyses learning beforehand.

    Raises
    ------
    OutputError
        If the answer cannot be saved as the session says; checked before anything is simulated.
    DivergenceError
        If every scheme diverges.
    """
    session.will_write(scenario.inputs, *_outputs(scenario, bool(session.saving.get("pdf"))))
    cases, outcomes = scenario.cases(), list[Outcome]()
    for file in {case.learning.table for case in cases if case.learning is not None and case.learning.table is not None}:
        LearnedTable.load(file)  # refuse one that cannot be read before anything runs
    diverged: dict[str, DivergenceError] = {}
    stages, stopped = session.stages(), False
    stages.expect(_work(cases, interval))
    for case in cases:
        try:
            outcomes.append(run_case(case, stages, costs=costs, foretell=foretell, interval=interval))
        except DivergenceError as error:
            diverged[case.name] = error
        except KeyboardInterrupt:
            if not outcomes:
                raise
            stopped = True
        learned = outcomes[-1].learning if outcomes else None
        stopped = stopped or (learned is not None and learned.status.startswith("interrupted"))
        if stopped:
            break
    if diverged and not outcomes:
        raise next(iter(diverged.values()))
    return Runs(scenario, tuple(outcomes), diverged, session.command, stopped)


def _outputs(scenario: Scenario, pdf: bool) -> list[str]:
    """Return the files of a saved answer, the summary first."""
    cases = scenario.cases()
    names = file_names([case.name for case in cases])
    outputs = ["summary.json", "report.html", *(["report.pdf"] if pdf else []), *(f"signals/{name}.nc" for name in names.values())]
    return outputs + [f"learned/{names[case.name]}.nc" for case in cases if case.learning is not None]


def _work(cases: Sequence[Case], interval: bool | None) -> list[tuple[str, float]]:
    """Return first word and work of each stage of a run, see `contourlab.rendering.stages.Stages.expect`."""
    work: list[tuple[str, float]] = []
    for case in cases:
        work += [FIRST, *(LEARNING if case.learning is not None else ()), ("simulating", 0.5), ("judging", 1.0)]
        work += [("looking", 12.0)] if case.learning is None and case.tolerance is not None else []
        drawn = interval is not False and any(number.drawn for number in numbers_of(case.machine, case.controller))
        work += [*([DRAWING] if drawn else []), ("checking", 0.5)]
    return [*work, *((words, amount * len(cases)) for words, amount in WRITING)]


def file_names(names: Sequence[str]) -> dict[str, str]:
    """Return a portable file name for each scheme; no two differ in case only."""
    chosen: dict[str, str] = {}
    taken: set[str] = set()
    for name in names:
        words = "".join(c if c.isalnum() or c in "-_." else " " for c in name).split()
        stem = "-".join(words).strip("-.") or "scheme"
        candidates = (stem if number == 1 else f"{stem}-{number}" for number in count(1))
        chosen[name] = next(file for file in candidates if file.casefold() not in taken)
        taken.add(chosen[name].casefold())
    return chosen


def ending(outcome: JudgedRun, shared: Sequence[Finding] = ()) -> Iterator[str]:
    """Yield causes and findings of a scheme or a log, but for those that all schemes share."""
    if outcome.verdict is not None:
        main = [f"{cause.name} {cause.contribution * 1e6:+.3g} um" for cause in outcome.verdict.causes if cause.share >= NOTABLE]
        if main:
            yield f"{outcome.name}: causes there: {', '.join(main)}"
    yield from (f"{outcome.name}: {finding}" for finding in outcome.findings if finding not in shared)


def next_steps(outcomes: Sequence[Outcome], command: str, out: Path, proposed: Sequence[str]) -> list[tuple[str, str]]:
    """Return what to do next, and the command for it, the most useful first; nothing where a scheme keeps its tolerance.

    Parameters
    ----------
    outcomes : sequence of Outcome
        At least one.
    command : str
        As typed; empty for objects, of which no command can be told.
    out : Path
        Folder of the results.
    proposed : sequence of str
        Files with a changed controller, relative to the folder.
    """
    if not command:
        return []
    file, *options = (word for word in shlex.split(command)[2:] if word not in ("--interval", "--no-interval"))
    part = not is_scenario(file)

    def step(title: str, *words: str) -> tuple[str, str]:
        return title, as_typed(["contourlab", words[0], file, *words[1:]])

    gains = not all(axis.plant.takes_position for outcome in outcomes for axis in outcome.case.machine.axes)
    about = [] if gains else ["--parameter", "axes.*.plant.damping_ratio"]
    quick = ["sensitivity", "--quick", *about, *chosen_options(options, "--plugin", "--machine", "--set")]
    judged = [outcome for outcome in outcomes if outcome.verdict is not None]
    if not judged:
        limit = limit_to_propose(2.0 * min(outcome.metrics.part_error.max for outcome in outcomes))
        if part:
            return [step("Judge it against a tolerance:", "run", *options, "--tolerance", limit)]
        return [step("Find what the error depends on:", *quick)]
    for code in ("CL208", "CL209"):
        if all(any(finding.code == code for finding in outcome.findings) for outcome in judged):
            return [("Change the plan, not the gains:", as_typed(["contourlab", "explain", code]))]
    steps: list[tuple[str, str]] = []
    if any(outcome.verdict is not None and outcome.verdict.passed for outcome in judged):
        return steps
    if proposed and (part or "--controller" in options):
        given, values = without_options(options, "--controller", "--out", "--set"), chosen_options(options, "--set")[1::2]
        given += [word for text in of_machine(values, judged[0].case) for word in ("--set", text)]
        changed = ["--controller", str(out / proposed[0]), "--out", f"{out}-changed"]
        steps.append(step("Run it with the changed controller:", "run", *given, *changed))
    scheme = [] if outcomes[-1].name == "base" else ["--scheme", min(judged, key=lambda one: one.metrics.part_error.max).name]
    if not gains and part:
        return steps
    if not part and not gains:
        return [*steps, step("Find what the error depends on:", *quick[:2], *scheme, *quick[2:])]
    # A command may not write into the folder that it reads from.
    elsewhere = ["--out", f"{out}-tuned"] if any(Path(word).parent == out for word in options) else []
    return [*steps, step("Search all gains:", "tune", *without_options(options, "--schemes", "--trials", "--table"), *scheme, *elsewhere)]


# --- schemes side by side, and schemes that learn ---


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
