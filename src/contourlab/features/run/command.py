"""``contourlab run``: a scenario, or a part program on a machine, through to its report."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from contourlab.app.command_line import as_typed
from contourlab.app.json_values import write_json
from contourlab.app.results import proposed, staged
from contourlab.components.friction.laws import NoFriction
from contourlab.errors import DivergenceError, ParameterError
from contourlab.features.run.inputs import of_program, scenario_of
from contourlab.features.run.next_step import next_steps
from contourlab.features.run.outcome import run_case
from contourlab.features.run.record import switch_file
from contourlab.features.run.summary import Outcome, summary_of
from contourlab.features.run.trust.provenance import numbers_of
from contourlab.figures import figure
from contourlab.findings import Finding
from contourlab.metrics import judged_part
from contourlab.rendering.stages import shown
from contourlab.rendering.table import paragraphs
from contourlab.result import write_text_atomic

if TYPE_CHECKING:
    from contourlab.rendering.data import ReportData
    from contourlab.scenario import Case, Scenario

FIRST, LEARNING = ("planning", 1.0), (("analysing", 4.0), ("learning", 30.0))
DRAWING, WRITING = ("drawing", 20.0), (("writing signals", 1.5), ("writing the report", 2.5))
"""First words of stages and their work, roughly as measured."""


@dataclass(frozen=True)
class RunOutcome:
    """What a command prints: whether every verdict passed, the summary, the text; the first scheme that diverged; the data of the page."""

    passed: bool
    summary: dict[str, Any]
    table: str
    runaway: DivergenceError | None = None
    data: ReportData | None = None


@dataclass(frozen=True)
class RunOptions:
    """Options that run, compare and learn share.

    Attributes
    ----------
    out : Path
        Folder of the results.
    plugins : tuple of Path
        Python files with components.
    plots : tuple of str
        Formats of further plots: png, svg, pdf.
    signals : tuple of str
        Signals to write; by default those of the scenario, or all.
    progress : bool
        Whether to show a bar.
    interval : bool or None
        Whether to compute the interval of the part error from the stated deviations; None, for no option given, computes it.
    pdf : bool
        Whether to write the page ``report.pdf``.
    """

    out: Path
    plugins: tuple[Path, ...] = ()
    plots: tuple[str, ...] = ()
    signals: tuple[str, ...] = ()
    progress: bool = False
    interval: bool | None = None
    pdf: bool = False

    def command(self, name: str, file: str | Path, options: Mapping[str, Any]) -> str:
        """Return the command as typed; options that are None are left out."""
        words = ["contourlab", name, str(file), *(word for plugin in self.plugins for word in ("--plugin", str(plugin)))]
        for option, value in options.items():
            words += [] if value is None else [option] if isinstance(value, bool) else [option, str(value)]
        if self.interval is not None:
            words.append("--interval" if self.interval else "--no-interval")
        return as_typed(words)


def run_scenario(
    file: str | Path,
    options: RunOptions,
    *,
    machine: str | Path | None = None,
    controller: str | Path | None = None,
    tolerance: str | None = None,
    judge: str | None = None,
    program: Mapping[str, Any] | None = None,
    check: bool = False,
) -> RunOutcome:
    """Run a scenario file, or a part program with a machine and a controller.

    Parameters
    ----------
    file : str or Path
        ``.toml``: a scenario; a folder: its ``scenario.toml``; anything else is a part program.
    options : RunOptions
    machine, controller : str or Path, optional
        Files, or names of shipped ones; a part program needs both. The folder of a machine stands for its two files.
    tolerance : str, optional
        Largest part error of a part program that passes, as ``"25 um"``.
    judge : str, optional
        Moves to judge, as in `contourlab.scenario.RunSettings`; by default as in the scenario.
    program : mapping, optional
        Further keys of the table ``program``, as ``{"fit": True}``.
    check : bool
        Read and check everything and plan the motion, without simulating.
    """
    parts: dict[str, Any] = {"machine": machine, "controller": controller, "tolerance": tolerance}
    scenario = scenario_of(file, **parts, program=program, plugins=options.plugins).judging(judge)
    typed = {f"--{name}": value for name, value in {**parts, "judge": judge}.items()} | of_program(program or {})
    command = options.command("run", file, typed)
    return _checked(scenario) if check else run_session(scenario, options, command=command)


def _checked(scenario: Scenario) -> RunOutcome:
    lines, schemes = [f"{scenario.name}: no fault"], {}
    for case in scenario.cases():
        reference = case.reference()
        length, duration = reference.path.length, (reference.n_sample - 1) * reference.servo_period
        schemes[case.name] = {"n_sample": reference.n_sample, "duration": duration, "path_length": length}
        lines.append(f"{case.name}: path {figure(length, 'mm', 6)}, {figure(duration, 's', 6)}, {reference.n_sample} samples")
    return RunOutcome(True, {"checked": scenario.name, "schemes": schemes}, "\n".join(lines))


def run_session(scenario: Scenario, options: RunOptions, *, command: str, costs: bool = False, foretell: bool = False) -> RunOutcome:
    """Run every scheme of a scenario; write signals, summary.json, report.html, plots and proposed controllers into a folder.

    A scheme that diverges is named in the summary; the others run on. Ctrl-C keeps the schemes that ended. `costs` times the servo tick,
    `foretell` analyses learning beforehand.

    Raises
    ------
    OutputError
        If the folder cannot be written; checked before anything is simulated.
    DivergenceError
        If every scheme diverges; nothing is written then.
    """
    out, signals = options.out, options.signals
    _check_choices(options.plots, signals)
    cases = scenario.cases()
    names = file_names([case.name for case in cases])
    outputs = ["summary.json", "report.html", *(["report.pdf"] if options.pdf else []), *(f"signals/{name}.nc" for name in names.values())]
    outputs += [f"learned/{names[case.name]}.nc" for case in cases if case.learning is not None]
    from contourlab.scenario.dump import dump

    with staged(out, *outputs, inputs=scenario.inputs) as folder:
        outcomes: list[Outcome] = []
        diverged: dict[str, DivergenceError] = {}
        stopped = False
        with shown(options.progress) as stages:
            stages.expect(_work(cases, options.interval))
            for case in cases:
                try:
                    asked: dict[str, Any] = {"costs": costs, "foretell": foretell, "interval": options.interval}
                    outcomes.append(run_case(case, progress=stages.advance, stage=stages.begin, **asked))
                except DivergenceError as error:
                    diverged[case.name] = error
                except KeyboardInterrupt:
                    if not outcomes:
                        raise
                    stopped = True
                stopped = stopped or (bool(outcomes) and _interrupted(outcomes[-1]))
                if stopped:
                    break
            first = next(iter(diverged.values()), None)
            if first is not None and not outcomes:
                raise first
            stages.begin("writing signals")
            for outcome in outcomes:
                _write_signals(outcome, folder / "signals" / f"{names[outcome.name]}.nc", signals or outcome.case.signals)
                if outcome.learning is not None:
                    outcome.learning.table.save(folder / "learned" / f"{names[outcome.name]}.nc")
                if outcome.verdict is not None and outcome.verdict.proposed is not None:
                    text = proposed(f"Proposed for {outcome.name}.", dump(outcome.verdict.proposed, outcome.case.machine))
                    write_text_atomic(folder / "proposed" / f"{names[outcome.name]}.toml", text)
                if outcome.switches is not None:
                    with switch_file(folder / "switches" / f"{names[outcome.name]}.csv") as listed:
                        listed.append(outcome.switches)
            summary = summary_of(scenario.name, outcomes, command, diverged)
            write_json(folder / "summary.json", summary)
            stages.begin("writing the report")
            written_for = [name for name in names if (folder / "proposed" / f"{names[name]}.toml").exists()]
            steps = next_steps(outcomes, command, out, [f"proposed/{names[name]}.toml" for name in written_for])
            text, data = _write_report(scenario, outcomes, folder, command, options, steps)
            files = {f"{name}, changed controller": f"proposed/{names[name]}.toml" for name in written_for} | {"report": "report.html"}
            files |= {"to print": "report.pdf"} if options.pdf else {}
    if stopped:
        end = KeyboardInterrupt()
        end.add_note(f"Kept {len(outcomes)} of {len(cases)} schemes: {out / 'report.html'}")
        raise end
    written = "\n".join(f"{what}: {out / file}" for what, file in files.items())
    written += "".join(f"\nnext: {step}" for _, step in steps[:1])
    return RunOutcome(summary["passed"] is not False, summary, f"{text}\n\n{written}", first, data)


def _work(cases: Sequence[Case], interval: bool | None) -> list[tuple[str, float]]:
    """Return first word and work of each stage of a run, see `contourlab.rendering.stages.Stages.expect`."""
    work: list[tuple[str, float]] = []
    for case in cases:
        work += [FIRST, *(LEARNING if case.learning is not None else ()), ("simulating", 0.5), ("judging", 1.0)]
        work += [("looking", 12.0)] if case.learning is None and case.tolerance is not None else []
        drawn = interval is not False and any(number.drawn for number in numbers_of(case.machine, case.controller))
        work += [*([DRAWING] if drawn else []), ("checking", 0.5)]
    return [*work, *((words, amount * len(cases)) for words, amount in WRITING)]


def _interrupted(outcome: Outcome) -> bool:
    return outcome.learning is not None and outcome.learning.status.startswith("interrupted")


def _check_choices(plots: Sequence[str], signals: Sequence[str]) -> None:
    """Refuse unknown formats and signals before anything is simulated."""
    from contourlab.loop.simulate import UNITS
    from contourlab.scenario.motion import JUDGED

    check_plots(plots)
    _check_known("--signals", signals, (*UNITS, *JUDGED))


def check_plots(plots: Sequence[str]) -> None:
    """Refuse an unknown format of pictures.

    Raises
    ------
    ParameterError
        If there is one.
    """
    from contourlab.rendering.plots import FORMATS

    _check_known("--plots", plots, FORMATS)


def _check_known(option: str, names: Sequence[str], known: Sequence[str]) -> None:
    for name in names:
        if name not in known:
            raise ParameterError(option, repr(name), f"one of {', '.join(known)}")


def _write_signals(outcome: Outcome, file: Path, wanted: Sequence[str]) -> None:
    judged = judged_part(outcome.result, outcome.reference).text  # so that a comparison of finished runs judges the same samples
    result = replace(outcome.result, attributes={**outcome.result.attributes, "judged": judged})
    if wanted:
        # Asking for the data says clearly which signals there are, if one is not.
        result = replace(result, signals={name: result.signals[name] for name in wanted if result[name] is not None})
    result.save(file)


def file_names(names: Sequence[str]) -> dict[str, str]:
    """Return a portable file name for each scheme; no two differ in case only."""
    chosen: dict[str, str] = {}
    taken: set[str] = set()
    for name in names:
        words = "".join(c if c.isalnum() or c in "-_." else " " for c in name).split()
        stem = file = "-".join(words).strip("-.") or "scheme"
        number = 1
        while file.casefold() in taken:
            number += 1
            file = f"{stem}-{number}"
        taken.add(file.casefold())
        chosen[name] = file
    return chosen


def _write_report(
    scenario: Scenario, outcomes: Sequence[Outcome], folder: Path, command: str, options: RunOptions, steps: Sequence[tuple[str, str]]
) -> tuple[str, ReportData]:
    from contourlab.features.run.report import report_data
    from contourlab.rendering.html import write_html
    from contourlab.rendering.page_tables import reversal_text
    from contourlab.rendering.switching import switch_lines
    from contourlab.rendering.tables import comparison_text, trials_text
    from contourlab.scenario.dump import dump

    data = replace(report_data(scenario.name, outcomes, scenario=dump(scenario), command=command), next_steps=steps)
    write_html(data, folder / "report.html")
    if options.plots:
        from contourlab.rendering.plots import write_plots

        write_plots(data, folder / "plots", options.plots)
    if options.pdf:
        from contourlab.rendering.one_page import write_page

        write_page(data, folder / "report.pdf")
    reversals = reversal_text(data) if any(map(_shows_reversals, outcomes)) else ""
    shared = [finding for finding in outcomes[0].findings if all(finding in other.findings for other in outcomes)]
    endings = [line for outcome in outcomes for line in _ending(outcome, shared)]
    ends = paragraphs([*endings, *map(str, shared)])
    texts = [comparison_text(data), trials_text(data), reversals, "\n".join(switch_lines(data)), ends]
    return "\n\n".join(filter(None, texts)), data


def _shows_reversals(outcome: Outcome) -> bool:
    """Tell whether an axis has friction, backlash or hysteresis, which show at reversals."""
    return any(
        axis.plant.linear() != axis.plant or not isinstance(axis.friction, NoFriction) or axis.error.repeatability > 0.0
        for axis in outcome.case.machine.axes
    )


def _ending(outcome: Outcome, shared: Sequence[Finding]) -> Iterator[str]:
    """Yield verdict, causes and findings of a scheme, but for those that all schemes share."""
    verdict = outcome.verdict
    if verdict is not None:
        worst = verdict.worst
        where = f"line {worst.line}" if worst.line else "(" + ", ".join(f"{x * 1e3:.3f}" for x in worst.position) + ") mm"
        # An error within the tolerance alone would not explain the verdict.
        skips = f"the tool skips {figure(verdict.left_out, 'mm')} of the path, " if verdict.left_out else ""
        yield (
            f"{outcome.name}: {'PASS' if verdict.passed else 'FAIL'}, {skips}largest part error {figure(worst.value, 'um')} against "
            f"{figure(verdict.tolerance, 'um')}, at {where}, t = {worst.time:.3f} s"
        )
        main = [f"{cause.name} {cause.contribution * 1e6:+.3g} um" for cause in verdict.causes if cause.share >= 0.02]
        if main:
            yield f"{outcome.name}: causes there: {', '.join(main)}"
    yield from (f"{outcome.name}: {finding}" for finding in outcome.findings if finding not in shared)
