"""``contourlab precompensate``: correct a part program by the contour error that repeats, from logs or from a model."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from contourlab.app.results import check_file, spared
from contourlab.errors import ParameterError
from contourlab.features.measure.log_choice import LogChoice, positive
from contourlab.features.precompensate.law import Run, spread
from contourlab.features.precompensate.passes import STATE, digest_of, load, save
from contourlab.features.precompensate.result import Precompensated
from contourlab.features.precompensate.runs import Measured, open_run, simulated
from contourlab.features.precompensate.work import Settings, Work
from contourlab.findings import Finding, finding
from contourlab.loop import Controller, Machine
from contourlab.program import Reading
from contourlab.rendering.stages import shown

NODE_TIME = 1e-3
"""Least time between nodes at the programmed feed [s]."""


@dataclass(frozen=True)
class Options:
    """Options as typed.

    Attributes
    ----------
    tolerance : str
        Of the short lines.
    cap : str
        Of the displacement.
    band : str
        Of the cycle time and of the speed at a place, as a share.
    repeat : int
        Passes to simulate.
    """

    tolerance: str = "0.5 um"
    cap: str = "1 mm"
    band: str = "2 %"
    repeat: int = 5


def _settings(options: Options) -> Settings:
    tolerance = positive("--tolerance", options.tolerance, "m", 'a length with its unit, such as "0.5 um"')
    cap = positive("--cap", options.cap, "m", 'a length with its unit, such as "1 mm"')
    band = positive("--band", options.band, "", 'a share, such as "2 %"')
    if options.repeat < 1:
        raise ParameterError("--repeat", str(options.repeat), "1 or more")
    return Settings(tolerance, cap, band)


def precompensate_from_logs(
    part: str | Path,
    logs: Sequence[LogChoice],
    out: str | Path,
    *,
    passes: str | Path | None = None,
    machine: Machine | None = None,
    options: Options | None = None,
    reading: Reading | None = None,
) -> Precompensated:
    """Learn from the logs of one pass, and write the program of the next, if a pass helps.

    Parameters
    ----------
    part : str or Path
        The program as it was before any correction.
    logs : sequence of LogChoice
        Runs of the same pass, with commanded and measured positions.
    out : str or Path
        Program to write.
    passes : str or Path, optional
        Folder that keeps what was learned; without it, the logs are of `part` itself.
    machine : Machine, optional
        For play behind the motors, and for the limits of the axes.
    options : Options, optional
    reading : Reading, optional

    Raises
    ------
    ProgramError, LogError, ResultError
        If a file cannot be read, or a log does not follow the program.
    ParameterError, OutputError
        If an option is out of range, or a file cannot be written.
    """
    options, reading = options or Options(), reading or Reading(require_end=False)
    settings, part, out = _settings(options), Path(part), Path(out)
    given = [part, *(file for log in logs for file in log.files)]
    check_file(out, given, "--out")
    if passes is not None:
        check_file(Path(passes) / STATE, given, "--passes")
    opened = [open_run(log, machine) for log in logs]
    measured, axes, _ = opened[0]
    if any(other[1] != axes for other in opened):
        raise ParameterError("--log", "axes differ", f"logs of the axes {', '.join(axes)}")
    work = Work(part, axes, settings, reading, machine, max(NODE_TIME, measured.period))
    digests = tuple(digest_of(Path(log.file).read_bytes()) for log in logs)
    if passes is not None:
        work.passes = load(Path(passes), work.passes)
        if used := [log.file for log, digest in zip(logs, digests, strict=True) if digest in work.passes.logs]:
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
    if passes is not None:
        spared(Path(passes) / f"pass-{len(work.passes.written)}.ngc", given, "--passes")
    result = work.result(out, measured.source, rest, findings, proceed)
    work.write(result)
    if passes is not None:
        save(work.passes, Path(passes))
    return result


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


def precompensate_from_model(
    part: str | Path,
    machine: Machine,
    controller: Controller,
    out: str | Path,
    *,
    options: Options | None = None,
    reading: Reading | None = None,
    seed: int = 0,
    progress: bool = False,
) -> Precompensated:
    """Simulate pass after pass, and write the best program, if it is better than the given one.

    Parameters
    ----------
    part, out, options, reading
        See `precompensate_from_logs`.
    machine : Machine
    controller : Controller
    seed : int
        Of all noise, which differs from pass to pass.
    progress : bool
        Whether to show a bar.

    Raises
    ------
    ProgramError, FeedError
        If the program cannot be read or planned.
    DivergenceError
        If a loop diverges.
    ParameterError, OutputError
        If an option is out of range, or the file cannot be written.
    """
    options, reading = options or Options(), reading or Reading(require_end=False)
    settings, part, out = _settings(options), Path(part), Path(out)
    check_file(out, [part], "--out")
    axes = tuple(axis for axis in machine.axis_names if axis in "xyz")
    work = Work(part, axes, settings, reading, machine, max(NODE_TIME, machine.servo_period))
    findings: list[Finding] = []
    rest: float | None = None
    with shown(progress) as stages:
        stages.expect(options.repeat + 1)
        for k in range(options.repeat + 1):
            stages.begin(f"pass {k}")
            trials = [simulated(work.driven.source.program, machine, controller, seed, trial) for trial in ((0, 1) if k == 0 else (k + 1,))]
            runs = [work.run(one) for one in trials]
            rest = spread(runs) if k == 0 else rest
            more = work.learn(trials[0], runs)
            if k == options.repeat or not work.passes.helps:
                findings += more
                break
            more += work.propose()
            findings += [one for one in more if str(one) not in map(str, findings)]
    result = work.result(out, "model", rest, findings, proceed=False)
    work.write(result)
    return result
