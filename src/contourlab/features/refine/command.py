"""``contourlab refine``: machines and controllers out of scenarios, brought to what logs have measured."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from contourlab.app.folder import check_file, spared, staged
from contourlab.errors import ParameterError, UnitError
from contourlab.features.measure.likely import same_column, unlikely_motion
from contourlab.features.measure.log_choice import LogChoice, open_log, told_apart
from contourlab.features.refine.log_run import Agreement, LogRun, log_run
from contourlab.features.refine.remarks import shown, size_left, worse_than_before
from contourlab.features.refine.study import Refined, RefineSettings, Window, refine
from contourlab.features.run.command import check_plots
from contourlab.logs.error_context import about
from contourlab.result import write_text_atomic

if TYPE_CHECKING:
    from contourlab.scenario import Scenario


@dataclass(frozen=True)
class Refinement:
    """What the command prints: whether the figures can be used, a summary, and text."""

    usable: bool
    summary: dict[str, Any]
    text: str


def refine_logs(
    scenarios: Sequence[str | Path],
    choices: Sequence[LogChoice],
    parameters: Sequence[str],
    *,
    windows: Sequence[str] = (),
    validation: LogChoice | None = None,
    starts: int = 3,
    plugins: Sequence[str | Path] = (),
    out: str | Path | None = None,
    plots: Sequence[str] = (),
    folder: str | Path = "results",
    progress: Callable[[str], None] | None = None,
) -> Refinement:
    """Refine the parameters of scenarios against logs; write the machine, and the controllers where they were refined.

    Parameters
    ----------
    scenarios : sequence of str or Path
        One for all logs, or one for each.
    choices : sequence of LogChoice
    parameters : sequence of str
        Dotted names or their ends, ``*`` for any axis; with a range as ``"axes.x.friction.coulomb=50 N..200 N"``.
    windows : sequence of str
        Times that are fitted, as ``"0.8 s..1.6 s"``: one for all logs, or one for each; what moves outside of them shows what the fit is
        worth.
    validation : LogChoice, optional
        Of a log that is not fitted; the first scenario drives along it.
    starts : int
        Descents.
    plugins : sequence of str or Path
    out : str or Path, optional
        The machine's file; controllers get names of their own beside it. None is written where the figures are unusable.
    plots : sequence of str
        png, svg or pdf, into ``plots`` in `folder`; what else is there stays.
    folder : str or Path
    progress : callable, optional
        Told in words how far it is.

    Raises
    ------
    LogError, ResultError, ScenarioError
        If a file cannot be read or lacks something.
    ParameterError
        If an option is out of range, or the run diverges as it begins.
    OutputError
        If `out` or `folder` cannot be written; found before anything is simulated.
    """
    check_plots(plots)
    if len(scenarios) not in (1, len(choices)):
        raise ParameterError("--also", f"{len(scenarios)} scenarios for {len(choices)} logs", "one scenario, or one for each log")
    read = _read(scenarios, plugins)
    several = len(scenarios) > 1
    labels = _labels(scenarios if several else [choice.file for choice in choices])
    runs = [_run(read[i if several else 0], choice, label) for i, (choice, label) in enumerate(zip(choices, labels, strict=True))]
    spans = _windows(windows, len(runs))
    # Ahead of the work, so that a log that cannot be read is told at once.
    held_out = None if validation is None else _run(read[0], validation, *_labels([validation.file]))
    inputs = [file for one in read for file in one.inputs] + [file for choice in choices for file in choice.files]
    inputs += [*(() if validation is None else validation.files), *map(Path, plugins)]
    if out is not None:
        check_file(out, inputs)
        for run in runs:
            spared(_beside(Path(out), run), inputs)
    with staged(folder, inputs=inputs, option="--folder") if plots else nullcontext() as stage:
        found = refine(runs, parameters, windows=spans, settings=RefineSettings(starts=starts), progress=progress)
        checked = _Validation((), ()) if held_out is None else _held_out(found, runs, held_out)
        on_second = worse_than_before("on the log for validation", checked.before, checked.after)
        found = replace(found, remarks=(*found.remarks, *on_second, *_on_validation(runs, held_out)))
        text = _text(found, checked)
        if stage is not None:
            from contourlab.features.refine.pictures import draw

            text += "".join(f"\nplot: {Path(folder) / file.relative_to(stage)}" for file in draw(found, stage / "plots", plots))
    sources = told_apart([choice.file for choice in choices])
    if out is not None:
        text += "".join(f"\n{line}" for line in _write(found, sources, Path(out)))
    return Refinement(found.usable, _summary(found, checked, sources), text)


def _read(files: Sequence[str | Path], plugins: Sequence[str | Path]) -> list[Scenario]:
    from contourlab.scenario import load_scenario

    return [load_scenario(file, plugins=plugins) for file in files]


def _labels(files: Sequence[str | Path]) -> list[str]:
    """Return what runs are called: the files' names, with the folders that tell those of one name apart; files of theirs have it too."""
    names = [Path(name).with_suffix("").as_posix().replace("/", "-") for name in told_apart(files)]
    return names if len(set(names)) == len(names) else [f"{name} {i + 1}" for i, name in enumerate(names)]


def _run(scenario: Scenario, choice: LogChoice, label: str) -> LogRun:
    log = open_log(choice)
    with about(choice.file):
        run = log_run(scenario.machine, scenario.controller, log.result, label)
    notes = [f"{label}: {line}" for line in log.clock_notes()]
    notes += unlikely_motion(run.position, run.machine.servo_period, f"an axis in {label}")
    notes += same_column(run.machine.axis_names, run.asked, run.position, f" in {label}")
    return replace(run, notes=(*run.notes, *notes))


def _windows(texts: Sequence[str], count: int) -> list[Window | None]:
    if len(texts) not in (0, 1, count):
        raise ParameterError("--window", f"{len(texts)} of them", f"one for all logs, or one for each of the {count}")
    from contourlab.units import to_si

    found: list[Window | None] = []
    for text in texts:
        low, dots, high = text.partition("..")
        try:
            span = to_si(low.strip(), "s"), to_si(high.strip(), "s")
        except UnitError as error:
            raise ParameterError("--window", repr(text), 'two times, as "0.8 s..1.6 s"') from error
        if not dots or not span[0] < span[1]:
            raise ParameterError("--window", repr(text), 'two times, the earlier one first, as "0.8 s..1.6 s"')
        found.append(span)
    return found * count if len(found) == 1 else found


@dataclass(frozen=True)
class _Validation:
    """How well the first run's machine and controller follow a log that was not fitted, as they were and as they are."""

    before: tuple[Agreement, ...]
    after: tuple[Agreement, ...]


def _held_out(found: Refined, runs: Sequence[LogRun], run: LogRun) -> _Validation:
    told = [replace(run, machine=like.machine, controller=like.controller) for like in (runs[0], found.runs[0])]
    before, after = (one.agreement(one.once()) for one in told)
    return _Validation(before, after)


def _on_validation(runs: Sequence[LogRun], run: LogRun | None) -> list[str]:
    """Remark on a log for validation that is one of those that were fitted."""
    if run is None or not any(np.array_equal(run.measured, one.measured) for one in runs):
        return []
    return [f"{run.label} has the samples of a log that was fitted: it validates nothing but what --window left out"]


def _table(rows: Sequence[Sequence[str]], left: tuple[int, ...]) -> list[str]:
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return [
        "  ".join(c.ljust(w) if i in left else c.rjust(w) for i, (c, w) in enumerate(zip(r, widths, strict=True))).rstrip() for r in rows
    ]


def _groups(found: Refined, checked: _Validation) -> dict[str, tuple[Agreement, ...]]:
    """Return how well runs were followed before and after: over what was fitted, what was not, and the log for validation."""
    fitted = {"before": found.before, "fitted": found.after}
    unseen = {"unseen before": found.unseen_before, "unseen": found.unseen}
    return {**fitted, **unseen, "validation before": checked.before, "validation": checked.after}


def _text(found: Refined, checked: _Validation) -> str:
    rows = [("parameter", "began at", "is", "deviation", "if white")]
    for one, value, deviation, white in zip(found.sought, found.values, found.deviations, found.white_deviations, strict=True):
        rows.append((one.label, shown(one, one.number.value), shown(one, value), shown(one, deviation, 2), shown(one, white, 2)))
    lines = _table(rows, (0,))
    agreed = [("", "run", "axis", "signal", "explained", "fit", "left, rms")]
    for words, group in _groups(found, checked).items():
        for a in group:
            agreed.append((words, a.run, a.axis, a.signal, f"{100.0 * a.explained:.3f} %", f"{a.fit:.2f} %", size_left(a)))
    lines += ["", *_table(agreed, (0, 1, 2, 3))]
    lines += [f"note: {remark}" for remark in found.remarks]
    return "\n".join(lines)


def _summary(found: Refined, checked: _Validation, sources: Sequence[str]) -> dict[str, Any]:
    def rows(group: Sequence[Agreement]) -> list[dict[str, Any]]:
        return [
            {"run": a.run, "axis": a.axis, "signal": a.signal, "explained": a.explained, "fit_percent": a.fit, "rms": a.rms} for a in group
        ]

    figures = zip(found.sought, found.values, found.deviations, found.white_deviations, found.at_bound, strict=True)
    return {
        "logs": list(sources),
        "parameters": {
            one.label: {
                "value": float(value),
                "unit": one.number.unit,
                "deviation": float(deviation),
                "white_deviation": float(white),
                "start": one.number.value,
                "range": [one.number.low, one.number.high],
                "at_bound": bool(bound),
            }
            for one, value, deviation, white, bound in figures
        },
        **{words.replace(" ", "_"): rows(group) for words, group in _groups(found, checked).items()},
        "correlation": found.knowledge.correlation.tolist(),
        "correlation_of": [one.label for one, bound in zip(found.sought, found.at_bound, strict=True) if not bound],
        "descents": found.descents,
        "descents_agreeing": found.agreeing,
        "usable": found.usable,
        "remarks": list(found.remarks),
    }


def _beside(machine: Path, run: LogRun) -> Path:
    """Return the file of a run's controller."""
    return machine.with_name(f"{machine.stem}-{run.label}-controller.toml".replace(" ", "-"))


def _write(found: Refined, sources: Sequence[str], out: Path) -> list[str]:
    """Write the machine, and the controllers of which something was refined; return what is to be said."""
    from contourlab.features.refine.files import controller_text, machine_text

    if not found.usable:
        return [f"{out} is not written: the figures cannot be used as they stand"]
    files = [("machine", out, machine_text(found, sources))]
    for i, run in enumerate(found.runs):
        if any(one.name.startswith("controller.") and i in one.runs for one in found.sought):
            files.append(("controller", _beside(out, run), controller_text(found, i, sources)))
    for _, file, text in files:
        write_text_atomic(file, text)
    return [f"{kind}: {file}" for kind, file, _ in files]
