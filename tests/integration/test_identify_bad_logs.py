"""Logs that show no axis, or not the requested one: every model of ``contourlab identify`` refuses or flags them."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from identified_logs import codes

from contourlab.analysis.identification.first_order import closed_loop_position, first_order_motion
from contourlab.cli.main import main

PERIOD = 1e-3
Log = dict[str, np.ndarray]
HEADS = {"t": "time [s]", "cmd": "cmd [V]", "pos": "pos x [mm]", "ref": "ref x [mm]"}
OPTIONS = {
    "closed-loop": ["--position-gain", "4 V/mm", "--velocity-gain", "0.1 V*s/mm"],
    "two-inertia": ["--gain", "10 N/V", "--lead", "10 mm"],
}
MODELS = ("rigid", "rigid-by-direction", "friction", "stiction", "first-order", "closed-loop", "frequency-response", "linear-motor")


def levels(n: int, size: float, hold: int, seed: int = 0) -> np.ndarray:
    return np.repeat(np.random.default_rng(seed).uniform(-size, size, n // hold), hold)


def moved(u: np.ndarray, friction: float = 0.0) -> np.ndarray:
    """Return the position [m] of axis 1 of Ghaffari & Ulsoy under a command in parts of full scale, on an encoder of 0.1 um."""
    return np.round(1.695 * first_order_motion(u, PERIOD, 10.1, friction, friction)[1] / 1e-7) * 1e-7


@cache
def good(model: str) -> Log:
    """Return a log that identifies the model, its command in volts, 10 V for full scale."""
    if model == "friction":
        v = np.repeat([0.01, -0.01, 0.03, -0.03, 0.06, -0.06, 0.1, -0.1], 800)
        u = 0.5 * np.sign(v) + 5.0 * v + 0.02 + 0.01 * np.random.default_rng(1).standard_normal(v.size)
        log = {"cmd": u, "pos": PERIOD * np.cumsum(v)}
    elif model == "stiction":
        ramp = np.r_[np.linspace(0.0, 0.2, 1500), np.zeros(400)]
        u = np.r_[np.zeros(50), ramp, -ramp, ramp, -ramp]
        log = {"cmd": 10.0 * u, "pos": moved(u, 0.06)}
    elif model == "closed-loop":
        ref = levels(5000, 1e-4, 250, 1)
        log = {"cmd": np.ones(ref.size), "pos": closed_loop_position(ref, PERIOD, 0.873, 19.7, 4000.0, 100.0), "ref": ref}
    elif model in ("frequency-response", "linear-motor", "two-inertia"):
        u = np.random.default_rng(3).standard_normal(8000)
        log = {"cmd": 10.0 * u, "pos": 1.695 * first_order_motion(u, PERIOD, 10.1)[1]}
    else:
        u = levels(5000, 0.6, 100)
        log = {"cmd": 10.0 * u, "pos": moved(u, 0.055)}
    return {"t": PERIOD * np.arange(log["pos"].size), **log}


def written(folder: Path, log: Log) -> str:
    file = folder / "log.csv"
    size = {"pos": 1e3, "ref": 1e3}
    columns = [log[key] * size.get(key, 1.0) for key in log]
    np.savetxt(file, np.column_stack(columns), delimiter=",", header=",".join(HEADS[key] for key in log), comments="", fmt="%.12g")
    return str(file)


def identified(folder: Path, model: str, log: Log, capsys: pytest.CaptureFixture[str]) -> tuple[int, dict, str]:  # type: ignore[type-arg]
    """Return exit code, JSON and error text; assert that there is no traceback, and a file only from a usable result."""
    out = folder / "axis.toml"
    words = ["identify", written(folder, log), "--column", "command.x=cmd", "--model", model, "--json"]
    file = [] if model in ("closed-loop", "frequency-response") else ["--write", str(out)]  # those two have no axis file
    code = main([*words, *file, *OPTIONS.get(model, ["--gain", "10 N/V"])])
    said = capsys.readouterr()
    assert code in (0, 1, 2) and "Traceback" not in said.err and "Warning" not in said.err
    assert code == 0 or not out.exists()
    return code, json.loads(said.out) if code < 2 else {}, said.err


def each(log: Log, change: Callable[[np.ndarray], np.ndarray]) -> Log:
    return {key: change(values) for key, values in log.items()}


def unrelated(log: Log) -> Log:
    """Replace the position by that of an axis that moves independently."""
    t = log["t"]
    return {**log, "pos": np.round((0.03 * np.sin(8.6 * t) + 0.01 * np.sin(2.3 * t)) / 1e-7) * 1e-7}


def back(log: Log) -> Log:
    t = log["t"].copy()
    t[600] = t[590]
    return {**log, "t": t}


def flat(log: Log) -> Log:
    return {key: values if key == "t" else np.full(values.size, 0.01) for key, values in log.items()}


def thin(log: Log) -> Log:
    kept = np.random.default_rng(0).random(log["t"].size) > 0.2
    return each(log, lambda values: values[kept])


REFUSED: dict[str, tuple[Callable[[Log], Log], str]] = {
    "one row": (lambda log: each(log, lambda v: v[:1]), "at least three are needed"),
    "five rows": (lambda log: each(log, lambda v: v[:5]), "at least"),
    "zeros": (lambda log: {**each(log, np.zeros_like), "t": log["t"]}, "must be"),
    "constants": (flat, "must be"),
    "no numbers": (lambda log: {**log, "pos": np.full(log["pos"].size, np.nan)}, "contains no numbers"),
    "time goes back": (back, "time goes back from"),
    "two records": (lambda log: each(log, lambda v: np.r_[v, v]), "two records in one file"),
    "a fifth missing": (thin, "samples of 'cmd' are missing"),
}


BY_THE_READER = ("time goes back", "two records")
"""What no model sees: without --slow, one is asked."""


@pytest.mark.parametrize(
    ("model", "case"),
    [
        pytest.param(model, case, marks=[pytest.mark.slow] if case in BY_THE_READER and model != "rigid" else [])
        for model in (*MODELS, "two-inertia") for case in REFUSED
    ],
)  # fmt: skip
def test_logs_without_information_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str, case: str) -> None:
    spoil, words = REFUSED[case]
    code, _, said = identified(tmp_path, model, spoil(good(model)), capsys)
    assert code == 2 and words in said and "log.csv: " in said


@pytest.mark.parametrize("model", MODELS)
def test_an_axis_that_moves_against_its_command_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str) -> None:
    log = good(model)
    code, found, said = identified(tmp_path, model, {**log, "pos": -log["pos"]}, capsys)
    if model in ("frequency-response", "closed-loop"):
        wanted = "CL509" if model == "frequency-response" else "CL527"
        assert code == 1 and wanted in codes(found)
    else:
        assert code == 2 and said.startswith("contourlab: ") and said.count("\n") == 1


@pytest.mark.parametrize("model", MODELS)
def test_the_log_of_another_axis_makes_no_file(tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str) -> None:
    code, found, said = identified(tmp_path, model, unrelated(good(model)), capsys)
    assert (code == 2 and len(said) > 40) or (code == 1 and found["findings"] and not found["usable"])


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.slow
def test_a_command_that_has_nothing_to_do_with_the_motion_makes_no_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str
) -> None:
    log = good(model)
    noise = np.random.default_rng(4).standard_normal(log["t"].size)
    code, found, said = identified(tmp_path, model, {**log, "cmd": noise, **({"ref": 1e-4 * noise} if "ref" in log else {})}, capsys)
    assert (code == 2 and len(said) > 40) or (code == 1 and found["findings"] and not found["usable"])
    # In any case no mass and no gain is below zero.
    for name in ("M", "a", "a'"):
        assert found.get("parameters", {}).get(name, {"value": 1.0})["value"] > 0.0


@pytest.mark.slow
@pytest.mark.parametrize("model", [model for model in MODELS if model != "closed-loop"])
@pytest.mark.parametrize(
    ("key", "factor", "words"),
    [("pos", 1e-3, "is the unit of the position right?"), ("cmd", 1e3, "unit"), ("t", 1e3, "is the unit of the time right?")],
)
def test_units_off_by_a_thousand_are_questioned(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str, key: str, factor: float, words: str
) -> None:
    log = good(model)
    code, found, said = identified(tmp_path, model, {**log, key: factor * log[key]}, capsys)
    assert (code == 2 and len(said) > 40) or any(words in one["text"] for one in found["findings"])


@pytest.mark.parametrize("model", MODELS)
def test_a_plausible_log_is_not_questioned(tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str) -> None:
    code, found, _ = identified(tmp_path, model, good(model), capsys)
    assert code == 0 and codes(found).isdisjoint({"CL401", "CL402", "CL403", "CL502", "CL509", "CL532"})


@pytest.mark.slow
@pytest.mark.parametrize("model", ["rigid", "first-order", "friction", "stiction"])
def test_nothing_is_fitted_across_a_long_gap(tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str) -> None:
    log, name = good(model), {"rigid": "M", "first-order": "a", "friction": "Fc", "stiction": "breakaway-"}[model]
    whole = identified(tmp_path, model, log, capsys)[1]["parameters"][name]
    n = log["t"].size
    kept = np.ones(n, dtype=bool)
    kept[n // 2 + 137 : n // 2 + 137 + n // 30] = False
    code, found, _ = identified(tmp_path, model, each(log, lambda values: values[kept]), capsys)
    figure = found["parameters"][name]
    assert code == 0 and figure["value"] == pytest.approx(whole["value"], rel=1e-2)
    assert [n // 30, n] in [[one["values"]["missing"], one["values"]["samples"]] for one in found["findings"] if one["code"] == "CL427"]
    assert ("CL501" in codes(found)) == (model in ("rigid", "first-order"))
    assert found["logs"] == ["log.csv"]


def test_columns_that_are_exchanged_are_no_response(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from contourlab.analysis.identification.drive_fit import held_response, linear_motor

    lap = 1000
    lines = np.arange(1, 301)
    spectrum = np.zeros(lap // 2 + 1, dtype=complex)
    spectrum[lines] = np.exp(2j * np.pi * np.random.default_rng(0).random(lines.size))
    answer = spectrum.copy()
    model = {"M": 7.0, "B": 40.0, "delay": 0.0}
    answer[lines] *= held_response(lambda s: linear_motor(model, s), lines / (lap * PERIOD), PERIOD)
    force, place = (np.tile(np.fft.irfft(part, lap), 6) for part in (spectrum, answer))
    log = {"t": PERIOD * np.arange(force.size), "cmd": 1e4 * place, "pos": 1e-3 * force}
    code, found, _ = identified(tmp_path, "frequency-response", log, capsys)
    assert code == 1 and "CL508" in codes(found)


def test_a_few_counts_of_motion_are_too_little(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A hundred newtons move the axis by a few counts: a finding says that the mass is poorly determined."""
    log = good("rigid")
    place = np.round(log["pos"] * 2e-5 / 1e-7) * 1e-7
    code, found, said = identified(tmp_path, "rigid", {**log, "pos": place}, capsys)
    assert (code == 2 and len(said) > 40) or (code == 1 and not codes(found).isdisjoint({"CL526", "CL534"}))
