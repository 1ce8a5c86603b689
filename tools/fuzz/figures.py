"""How the figures of an input are computed: in one run, written and read, block by block, in lanes, by threads, as a study."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

Figures = dict[str, np.ndarray]
SIGNAL = "signal "
STRICT = ("path", "feeds")
"""Figures that no plan may change."""
ERRORS = ("contour_error_rms", "contour_error_max", "contour_error_mean")


@dataclass(frozen=True)
class Side:
    """Files of one of the two inputs, how it is computed, and the order in which its axes are those of the other."""

    files: Mapping[str, str]
    how: str = "run"
    order: tuple[int, ...] = (0, 1, 2)


def write(files: Mapping[str, str], folder: Path) -> Path:
    """Write files into a new folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    return folder


def _case(folder: Path) -> tuple[Any, Any]:
    from contourlab import load_scenario

    case = load_scenario(folder / "scenario.toml").cases()[0]
    return case, case.reference()


def _summarised(result: Any, reference: Any, side: Side) -> Figures:
    from contourlab import summarise

    found = summarise(result, reference)
    figures: dict[str, Any] = {"cycle_time": found.cycle_time, "judged_time": found.judged_time, "left_out": found.left_out}
    figures |= {"path": reference.path.length, "plan": result["arc_length"]}
    for name in ("part_error", "contour_error", "planning_deviation"):
        error = getattr(found, name)
        figures[name] = [error.rms, error.max, error.mean, error.p95, error.integral]
    figures["tracking_error"] = [[found.tracking_error[k].rms, found.tracking_error[k].max] for k in side.order]
    figures["saturation"] = [found.saturation[k] for k in side.order]
    return {name: np.asarray(value, dtype=np.float64) for name, value in figures.items()}


def _signals(result: Any) -> Figures:
    return {SIGNAL + name: signal.data for name, signal in result.signals.items()}


def _run(folder: Path, side: Side) -> Figures:
    from contourlab import judge, simulate

    case, reference = _case(folder)
    result = judge(simulate(case.machine, case.controller, reference, seed=case.run.seed, moving=case.moving), reference)
    program = getattr(case.motion, "program", None)
    feeds = {float(f"{move.feedrate:.9g}") for move in program.moves if hasattr(move, "feedrate")} if program else {0.0}
    return _summarised(result, reference, side) | _signals(result) | {"feeds": np.array(sorted(feeds))}


def _saved(folder: Path, side: Side) -> Figures:
    """Write the scenario again and read it; write the result and read it."""
    from contourlab import Result, judge, load_scenario, simulate
    from contourlab.scenario.dump import dump

    again = folder / "again.toml"
    again.write_text(dump(load_scenario(folder / "scenario.toml")), encoding="utf-8")
    case = load_scenario(again).cases()[0]
    reference = case.reference()
    judge(simulate(case.machine, case.controller, reference, seed=case.run.seed), reference).save(folder / "result.nc")
    result = Result.load(folder / "result.nc")
    return _summarised(result, reference, side) | _signals(result)


def _blocks(folder: Path, side: Side) -> Figures:
    """Stop after each block, and go on."""
    from contourlab import Result, judge
    from contourlab.features.run.record import simulate_to_file

    case, reference = _case(folder)
    simulate_to_file(case.machine, case.controller, reference, folder / "result.nc", seed=case.run.seed, block=97)
    read = Result.load(folder / "result.nc")
    judged = judge(read, reference)
    # The last digits of a foot point depend on what is searched together; any more is a fault, and shows.
    near = all(np.allclose(np.abs(read[name]), np.abs(judged[name]), rtol=0.0, atol=1e-12) for name in ("contour_error", "part_error"))
    result = judged if near else read
    return _summarised(result, reference, side) | _signals(result)


def _batch(folder: Path, threads: int) -> Any:
    from contourlab import parameter_names, simulate_batch

    case, reference = _case(folder)
    gain = next(name for name in parameter_names(case.machine, case.controller) if name.endswith(("position_gain", "proportional_gain")))
    _, _, axis, *_, name = gain.split(".")
    value = getattr(case.controller.axes[axis].controller, name)
    asked = {gain: value * np.concatenate([[1.0], np.linspace(0.9, 1.1, 39)])}
    return simulate_batch(case.machine, case.controller, reference, asked, threads=threads, keep=("position",), seed=case.run.seed)


def _lanes(folder: Path, side: Side) -> Figures:
    """Return the figures of the first of 40 variants, whose parameters are those of the scenario."""
    found = _batch(folder, 1)
    return {"position": found.signals["position"][:, :, 0]} | {name: found.figures[name][:1] for name in ERRORS}


def _single(folder: Path, side: Side) -> Figures:
    """Return the same figures of a run, over all samples."""
    from contourlab import judge, simulate, summarise

    case, reference = _case(folder)
    result = judge(simulate(case.machine, case.controller, reference, seed=case.run.seed), reference)
    error = summarise(result, reference, reference.judged).contour_error
    return {"position": result["position"]} | {name: np.array([getattr(error, name.rpartition("_")[2])]) for name in ERRORS}


def _threads(folder: Path, side: Side) -> Figures:
    found = _batch(folder, 2 if side.how == "threads" else 1)
    return {**found.figures, **found.signals}


def _study(folder: Path, side: Side) -> Figures:
    """Run a study; resume it where a part of its store is lost; return its rows."""
    from contourlab.cli.main import main

    store, table = folder / "store", folder / "rows.csv"
    executor = ("--executor", "processes", "--workers", "2") if side.how == "processes" else ()
    start = ["sweep", "run", str(folder / "study.toml"), "--out", str(store)]
    codes = [main([*start, *executor])]
    if side.how == "resumed":
        sorted(store.glob("part-*"))[1].unlink()
        codes.append(main([*start, "--resume"]))
    codes.append(main(["sweep", "export", str(store), "--to", str(table)]))
    if any(codes):
        raise RuntimeError(f"exit codes {codes}")
    return {"rows": np.frombuffer(table.read_bytes(), dtype=np.uint8)}


HOWS: dict[str, Callable[[Path, Side], Figures]] = {
    "run": _run,
    "saved": _saved,
    "blocks": _blocks,
    "lanes": _lanes,
    "single": _single,
    "threads": _threads,
    "one thread": _threads,
    "study": _study,
    "resumed": _study,
    "processes": _study,
}
