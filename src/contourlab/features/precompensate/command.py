"""``contourlab precompensate``: correct a part program by the contour error that repeats, from logs or from a model."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from contourlab.app.results import check_file, spared
from contourlab.app.session import QUIET, Session, question
from contourlab.errors import ParameterError
from contourlab.features.check.reading import reading_of
from contourlab.features.measure.log_choice import LogChoice
from contourlab.features.precompensate.law import Run, spread
from contourlab.features.precompensate.options import Precompensate
from contourlab.features.precompensate.passes import STATE, digest_of, load
from contourlab.features.precompensate.result import Precompensated
from contourlab.features.precompensate.runs import Measured, open_run, simulated
from contourlab.features.precompensate.work import Work
from contourlab.features.run import options
from contourlab.features.run.source import scenario_of
from contourlab.findings import Finding, finding
from contourlab.loop import Machine
from contourlab.program import Reading
from contourlab.scenario.load import machine_of


@question(Precompensate)
def precompensate(part: str | Path, *, settings: Precompensate, session: Session = QUIET) -> Precompensated:
    """Correct a part program by the contour error that repeats: from the logs of one pass, or by simulating pass after pass.

    Parameters
    ----------
    part : str or Path
        The program as it was before any correction.

    Returns
    -------
    Precompensated

    Raises
    ------
    ProgramError, LogError, ResultError, FeedError
        If a file cannot be read, a log does not follow the program, or the program cannot be planned.
    DivergenceError
        If a simulated loop diverges.
    ParameterError
        If an option is out of range.
    """
    reading = reading_of(part, settings)
    choices = [LogChoice.of(log, settings) for log in settings.log]
    given = [Path(part), *(file for choice in choices for file in choice.files)]
    if session.saving:
        check_file(session.folder, given, "--out")
    if not settings.log:
        return _simulated(Path(part), settings, reading, session)
    if settings.passes is not None:
        check_file(settings.passes / STATE, given, "--passes")
    machine = None if settings.machine is None else machine_of(settings.machine, settings.plugin)
    opened = [open_run(choice, machine) for choice in choices]
    measured, axes, _ = opened[0]
    if any(other[1] != axes for other in opened):
        raise ParameterError("--log", "axes differ", f"logs of the axes {', '.join(axes)}")
    work = Work(Path(part), axes, settings, reading, machine, measured.period)
    digests = tuple(digest_of(choice.content) for choice in choices)
    if settings.passes is not None:
        work.passes = load(settings.passes, work.passes)
        if used := [log.file for log, digest in zip(choices, digests, strict=True) if digest in work.passes.logs]:
            raise ParameterError("--log", str(used[0]), "the log of the last written pass: this one was used before")
    runs = [work.run(one) for one, _, _ in opened]
    rest = spread(runs)
    reading_findings = {str(one): one for _, _, log in opened for one in log.findings}
    findings = [*reading_findings.values(), *_log_findings(measured, runs[0], rest, machine)]
    findings += work.learn(measured, runs)
    work.passes = replace(work.passes, logs=(*work.passes.logs, *digests))
    proceed = work.passes.helps
    if proceed:
        findings += work.propose()
    if settings.passes is not None:
        spared(settings.passes / f"pass-{len(work.passes.written)}.ngc", given, "--passes")
    return work.result(session.folder, measured.source, rest, findings, proceed, settings.passes)


def _log_findings(measured: Measured, run: Run, rest: float | None, machine: Machine | None) -> list[Finding]:
    findings = []
    if rest is None:
        findings.append(finding("CL905"))
    elif rest > run.rms / 3.0:
        findings.append(finding("CL906", rest=rest, rms=run.rms))
    if measured.source == "motor":
        findings.append(finding("CL907"))
    elif measured.source == "motor and model" and machine is not None:
        findings.append(finding("CL908", machine=machine.name))
    return findings


def _simulated(part: Path, settings: Precompensate, reading: Reading, session: Session) -> Precompensated:
    """Simulate pass after pass."""
    parts = {name: getattr(settings, name) for name in ("machine", "controller", "dialect", "plugin")}
    scenario = scenario_of(part, options.Run(**parts, no_require_end=True))
    machine, controller = scenario.machine, scenario.controller
    axes = tuple(axis for axis in machine.axis_names if axis in "xyz")
    work = Work(part, axes, settings, reading, machine, machine.servo_period)
    findings: list[Finding] = []
    rest: float | None = None
    stages = session.stages()
    stages.expect(settings.repeat + 1)
    for k in range(settings.repeat + 1):
        stages.begin(f"pass {k}")
        numbers = (0, 1) if k == 0 else (k + 1,)
        trials = [simulated(work.driven.source.program, machine, controller, settings.seed, trial) for trial in numbers]
        runs = [work.run(one) for one in trials]
        rest = spread(runs) if k == 0 else rest
        more = work.learn(trials[0], runs)
        if k == settings.repeat or not work.passes.helps:
            findings += more
            break
        more += work.propose()
        findings += [one for one in more if str(one) not in map(str, findings)]
    return work.result(session.folder, "model", rest, findings, proceed=False)
