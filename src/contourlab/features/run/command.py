"""``contourlab run``: a scenario, or a part program on a machine, through to its report."""

from __future__ import annotations

import json
import shlex
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from contourlab.app.folder import staged
from contourlab.app.stages import Stages, shown
from contourlab.components.friction.laws import NoFriction
from contourlab.errors import DivergenceError, ParameterError, ProgramError, ScenarioError
from contourlab.features.run.compare import Case, Outcome, run_case
from contourlab.features.run.summary import summary_of
from contourlab.features.run.switch_file import switch_file
from contourlab.result import write_text_atomic

if TYPE_CHECKING:
    from contourlab.scenario import Scenario


@dataclass(frozen=True)
class RunOutcome:
    """What a command prints: whether every verdict passed, the summary, and the table as text; and the first scheme that ran away."""

    passed: bool
    summary: dict[str, Any]
    table: str
    runaway: DivergenceError | None = None


def run_scenario(
    file: str | Path,
    out: str | Path,
    *,
    machine: str | Path | None = None,
    controller: str | Path | None = None,
    tolerance: str | None = None,
    options: Mapping[str, Any] | None = None,
    plugins: Sequence[str | Path] = (),
    check: bool = False,
    plots: Sequence[str] = (),
    signals: Sequence[str] = (),
    progress: bool = False,
    interval: bool | None = None,
) -> RunOutcome:
    """Run a scenario file, or a part program with a machine and a controller.

    Parameters
    ----------
    file : str or Path
        ``.toml``: a scenario; anything else is a part program.
    out : str or Path
        Folder of the results.
    machine, controller : str or Path, optional
        Files, or names of shipped ones; both are wanted with a part program.
    tolerance : str, optional
        Largest part error of a part program that passes, as ``"25 um"``.
    options : mapping, optional
        Further keys of a part program's table ``program``, such as ``{"fit": True}``.
    plugins : sequence of str or Path
        Python files with components.
    check : bool
        Read and check everything, plan the motion, simulate nothing.
    plots : sequence of str
        Formats of plots besides the report: png, svg, pdf.
    signals : sequence of str
        Signals to write; by default those of the scenario, or all.
    progress : bool
        Whether to show a bar.
    interval : bool, optional
        Whether the deviations that are stated make an interval of the contour error; by default where that does not take long.
    """
    from contourlab.scenario import BUILTIN

    path = Path(file)
    options = options or {}
    parts: dict[str, Any] = {"--machine": machine, "--controller": controller, "--tolerance": tolerance}
    parts |= {_option(name, value): value for name, value in options.items()}
    shipped = str(file).startswith(BUILTIN) and path.suffix != ".ngc"
    if shipped or path.suffix.lower() == ".toml":
        scenario = _from_scenario(path, parts, options, plugins)
    else:
        scenario = _from_program(path, machine, controller, tolerance, options, plugins)
    if check:
        return _checked(scenario)
    words = ["contourlab", "run", str(file)]
    words += [word for file in plugins for word in ("--plugin", str(file))]
    for option, value in parts.items():
        words += [] if value is None else [option] if isinstance(value, bool) else [option, str(value)]
    words += interval_words(interval)
    rest: dict[str, Any] = {"plots": plots, "signals": signals, "progress": progress, "interval": interval}
    return run_session(scenario, out, command=shlex.join(words), **rest)


def interval_words(interval: bool | None) -> list[str]:
    """Return what is typed for an interval of the contour error, for none, or to leave it open."""
    return [] if interval is None else ["--interval" if interval else "--no-interval"]


def _option(name: str, value: Any) -> str:
    """Return the option of the command line that gives a key of the table ``program``."""
    return f"--{'no-' if value is False else ''}{name.replace('_', '-')}"


def _from_scenario(path: Path, parts: Mapping[str, Any], options: Mapping[str, Any], plugins: Sequence[str | Path]) -> Scenario:
    from contourlab.scenario import load_scenario

    of_program = {_option(name, value): name for name, value in options.items()}
    for option, value in parts.items():
        if value is None:
            continue
        if option in of_program:
            said = f" = {str(value).lower()}" if isinstance(value, bool) else ""
            key = f"{of_program[option]}{said} under [program]"
        else:
            key = "tolerance under [run]" if option == "--tolerance" else option.removeprefix("--")
        raise ScenarioError(f"a scenario names its own: write {key} in the file, and leave {option} out", file=path)
    try:
        return load_scenario(path, plugins=plugins)
    except ProgramError as error:
        _say_how_it_may_end(error, "write require_end = false under [program] in the scenario")
        raise


def _from_program(
    path: Path,
    machine: str | Path | None,
    controller: str | Path | None,
    tolerance: str | None,
    options: Mapping[str, Any],
    plugins: Sequence[str | Path],
) -> Scenario:
    from contourlab.scenario import scenario_from_parts

    refuse_drawing(path, machine, controller)
    if machine is None or controller is None:
        raise ScenarioError("a part program needs --machine and --controller; a scenario ends in .toml", file=path)
    run = {} if tolerance is None else {"tolerance": tolerance}
    try:
        return scenario_from_parts(path, machine, controller, run=run, options=options, plugins=plugins)
    except ProgramError as error:
        _say_how_it_may_end(error, "add --no-require-end")
        raise


def _say_how_it_may_end(error: ProgramError, cure: str) -> None:
    if any(words in error.message for words in ("the program has no end", "a % that closes has none that opens")):
        error.add_note(f"To run it as it is, to its last line: {cure}.")


def refuse_drawing(file: str | Path, machine: str | Path | None = None, controller: str | Path | None = None) -> None:
    """Refuse a drawing, or points, where a part program is wanted; say what to write.

    Parameters
    ----------
    file : str or Path
    machine, controller : str or Path, optional
        What the scenario is to name.

    Raises
    ------
    ScenarioError
        If the name ends as that of a drawing or of points.
    """
    path = Path(file)
    what = {".dxf": "a drawing", ".svg": "a drawing", ".csv": "a list of points"}.get(path.suffix.lower())
    if what is None:
        return
    from contourlab.scenario.load import named_file

    lines = [
        f"machine = {json.dumps(named_file(machine or 'xyz'))}",
        f"controller = {json.dumps(named_file(controller or 'xyz-controller'))}",
        "[contour]",
        f"file = {json.dumps(str(path), ensure_ascii=False)}",
        "[feed]",
        'feedrate = "1000 mm/min"',
    ]
    raise ScenarioError(
        f"{what}, no part program: name it under [contour] in a scenario, say {path.stem}.toml, and run that:\n\n"
        + "\n".join(lines)
        + "\n",
        file=path,
    )


def _checked(scenario: Scenario) -> RunOutcome:
    lines, found = [], {}
    for case in scenario.cases():
        reference = case.reference()
        duration = (reference.n_sample - 1) * reference.servo_period
        found[case.name] = {"n_sample": reference.n_sample, "duration": duration, "path_length": reference.path.length}
        lines.append(f"{case.name}: {reference.path.length * 1e3:.6g} mm of path, {duration:.6g} s, {reference.n_sample} samples")
    return RunOutcome(True, {"checked": scenario.name, "schemes": found}, "\n".join([f"{scenario.name}: no fault found", *lines]))


def run_session(
    scenario: Scenario,
    out: str | Path,
    *,
    command: str,
    plots: Sequence[str] = (),
    signals: Sequence[str] = (),
    progress: bool = False,
    costs: bool = False,
    foretell: bool = False,
    interval: bool | None = None,
) -> RunOutcome:
    """Run every scheme of a scenario; write signals, summary.json, report.html and plots into a folder.

    A scheme that runs away is named in the summary and takes nothing from the others. With `costs` the servo tick of each scheme is timed;
    with `foretell` an analysis says beforehand how learning will go; with `interval` the stated deviations make an interval of the contour
    error.

    Raises
    ------
    OutputError
        If the folder cannot be made or written to; found before anything is simulated.
    DivergenceError
        If every scheme runs away; nothing is written then.
    """
    _check_choices(plots, signals)
    cases: Sequence[Case] = scenario.cases()
    names = file_names([case.name for case in cases])
    sure = ["summary.json", "report.html", *(f"signals/{name}.nc" for name in names.values())]
    sure += [f"learned/{names[case.name]}.nc" for case in cases if case.learning is not None]
    with staged(out, *sure, inputs=scenario.inputs) as folder:
        outcomes: list[Outcome] = []
        runaways: dict[str, DivergenceError] = {}
        with shown(progress) as stages:
            _run_each(cases, stages, outcomes, runaways, {"costs": costs, "foretell": foretell, "interval": interval})
            first = next(iter(runaways.values()), None)
            if first is not None and not outcomes:
                raise first
            stages.begin("writing signals")
            for outcome in outcomes:
                _write_signals(outcome, folder / "signals" / f"{names[outcome.name]}.nc", signals or outcome.case.signals)
                if outcome.learning is not None:
                    outcome.learning.table.save(folder / "learned" / f"{names[outcome.name]}.nc")
                if outcome.switches is not None:
                    with switch_file(folder / "switches" / f"{names[outcome.name]}.csv") as listed:
                        listed.append(outcome.switches)
            summary = summary_of(scenario.name, outcomes, command, runaways)
            write_text_atomic(folder / "summary.json", json.dumps(summary, indent=2, allow_nan=False) + "\n")
            stages.begin("writing the report")
            table = _write_report(scenario, outcomes, folder, command, plots)
    if any(_interrupted(outcome) for outcome in outcomes):
        stopped = KeyboardInterrupt()
        stopped.add_note(f"What was learned until then is kept: {Path(out) / 'report.html'}, {Path(out) / 'learned'}")
        raise stopped
    return RunOutcome(summary["passed"] is not False, summary, f"{table}\nreport: {Path(out) / 'report.html'}", first)


def _run_each(
    cases: Sequence[Case],
    stages: Stages,
    outcomes: list[Outcome],
    runaways: dict[str, DivergenceError],
    asked: Mapping[str, Any],
) -> None:
    for case in cases:
        try:
            outcomes.append(run_case(case, progress=stages.advance, stage=stages.begin, **asked))
        except DivergenceError as error:
            runaways[case.name] = error
        if outcomes and _interrupted(outcomes[-1]):
            return


def _interrupted(outcome: Outcome) -> bool:
    return outcome.learning is not None and outcome.learning.status.startswith("interrupted")


def _check_choices(plots: Sequence[str], signals: Sequence[str]) -> None:
    """Refuse what cannot be written before anything is simulated."""
    from contourlab.loop.simulate import UNITS
    from contourlab.scenario.motion import JUDGED

    check_plots(plots)
    _check_known("--signals", signals, (*UNITS, *JUDGED))


def check_plots(plots: Sequence[str]) -> None:
    """Refuse a format that no picture is written in.

    Raises
    ------
    ParameterError
        If there is one.
    """
    from contourlab.report.plots import FORMATS

    _check_known("--plots", plots, FORMATS)


def _check_known(option: str, names: Sequence[str], known: Sequence[str]) -> None:
    for name in names:
        if name not in known:
            raise ParameterError(option, repr(name), f"one of {', '.join(known)}")


def _write_signals(outcome: Outcome, file: Path, wanted: Sequence[str]) -> None:
    result = outcome.result
    if wanted:
        # Asking for the data says clearly which signals there are, if one is not.
        result = replace(result, signals={name: result.signals[name] for name in wanted if result[name] is not None})
    result.save(file)


def file_name(name: str) -> str:
    """Return a scheme's name as a file name that every system takes, one dash for whatever stands between words."""
    words = "".join(c if c.isalnum() or c in "-_." else " " for c in name).split()
    return "-".join(words).strip("-.") or "scheme"


def file_names(names: Sequence[str]) -> dict[str, str]:
    """Return a file name for each scheme; they differ also where a file system does not tell a from A."""
    found: dict[str, str] = {}
    taken: set[str] = set()
    for name in names:
        stem = chosen = file_name(name)
        number = 1
        while chosen.casefold() in taken:
            number += 1
            chosen = f"{stem}-{number}"
        taken.add(chosen.casefold())
        found[name] = chosen
    return found


def _write_report(scenario: Scenario, outcomes: Sequence[Outcome], folder: Path, command: str, plots: Sequence[str]) -> str:
    from contourlab.features.run.page import report_data
    from contourlab.report.html import write_html
    from contourlab.report.page_tables import reversal_text, trust_lines
    from contourlab.report.switching import switch_lines
    from contourlab.report.tables import comparison_text, trials_text
    from contourlab.scenario.dump import dump

    data = report_data(scenario.name, outcomes, scenario=dump(scenario), command=command)
    write_html(data, folder / "report.html")
    if plots:
        from contourlab.report.plots import write_plots

        write_plots(data, folder / "plots", tuple(plots))
    trials = trials_text(data)
    turns = reversal_text(data) if any(_turns_hard(outcome) for outcome in outcomes) else ""
    lines = [comparison_text(data).rstrip(), *([f"{trials}\n"] if trials else []), *([f"\n{turns}\n"] if turns else [])]
    return "\n".join([*lines, *switch_lines(data), *verdict_lines(outcomes), *trust_lines(data)])


def _turns_hard(outcome: Outcome) -> bool:
    """Tell whether an axis has what makes reversals show: friction, or backlash."""
    return any(
        axis.plant.two_sided or not isinstance(axis.friction, NoFriction) or axis.error.repeatability > 0.0
        for axis in outcome.case.machine.axes
    )


def verdict_lines(outcomes: Sequence[Outcome]) -> list[str]:
    """Return the verdicts in words."""
    lines = []
    for outcome in outcomes:
        found = outcome.verdict
        lines += [f"{outcome.name}: note: {warning}" for warning in outcome.warnings]
        if outcome.learning is not None:
            lines.append(f"{outcome.name}: {outcome.learning.status}: {outcome.learning.reason}")
        if found is None:
            continue
        worst = found.worst
        where = f"line {worst.line}" if worst.line else "(" + ", ".join(f"{x * 1e3:.3f}" for x in worst.position) + ") mm"
        lines.append(
            f"{outcome.name}: {'PASS' if found.passed else 'FAIL'}, largest part error {worst.value * 1e6:.3g} um against "
            f"{found.tolerance * 1e6:.3g} um, at {where}, t = {worst.time:.3f} s"
        )
        if found.left_out:
            lines.append(f"    the tool never came to a piece of the path {found.left_out * 1e3:.3g} mm long")
        if found.causes:
            main = [f"{c.name} {c.contribution * 1e6:+.3g} um" for c in found.causes if c.share >= 0.02]
            lines.append(f"    causes there: {', '.join(main)}; {found.advice}")
        shaky = [axis for axis, bode in outcome.bode.items() if not bode.margins.stable]
        if shaky:
            named = [f"{axis} ({meant})" if (meant := outcome.loop_meant(axis)) else axis for axis in shaky]
            hiding = "backlash, friction" if any(map(outcome.loop_meant, shaky)) else "friction"
            lines.append(
                f"    the servo loop of {', '.join(named)} is unstable by itself: {hiding} or a short run may hide it; lower its gains"
            )
        if found.untold:
            lines.append(f"    not told apart, as the loop runs away without it: {', '.join(found.untold)}")
    return lines
