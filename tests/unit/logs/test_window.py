"""A part of a log: the same figures as of a log that holds no more; each form, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from refusals import refuses

from contourlab.errors import LogError, ParameterError
from contourlab.logs import Log, load_log
from contourlab.logs.window import parse_window

N, START = 400, 5.0
TIME = START + 1e-3 * np.arange(N)
X = 0.02 * np.sin(0.05 * np.arange(N))


def log_of(rows: slice = slice(None), window: str | None = None, **columns: np.ndarray) -> Log:
    arrays = {"time [s]": TIME, "x [m]": X, **{name.replace("_", "-"): values for name, values in columns.items()}}
    return load_log({name: values[rows] for name, values in arrays.items()}, window=window)


@pytest.mark.parametrize(
    ("window", "rows"),
    [
        ("0..99", slice(0, 100)),
        ("100..", slice(100, None)),
        ("..99", slice(100)),
        ("0.1 s..0.199 s", slice(100, 200)),
        ("100 ms ..", slice(100, None)),
        ("..0.0995 s", slice(100)),
        ("line 3..line 4", slice(60, 100)),
        ("line 3..", slice(60, None)),
        ("..line 1", slice(0, 40)),
    ],
)
def test_a_window_is_the_log_that_holds_no_more(window: str, rows: slice) -> None:
    lines = np.repeat(np.arange(20), 20).astype(float)  # line 0 is none
    part, alone = log_of(window=window, program_line=lines), log_of(rows)
    assert part.result["position"].tolist() == alone.result["position"].tolist()
    assert part.start == pytest.approx(alone.start)
    assert part.result.servo_period == alone.result.servo_period
    (stated,) = (one.values for one in part.findings if one.code == "CL416")
    assert stated["samples"] == part.result.n_sample and stated["first"] == pytest.approx(part.start - START)


def test_windows_to_type_lead_to_the_parts_of_a_log() -> None:
    """A gap of 10 samples is bridged, one of 300 is refused; both say what to type, and it works as typed."""
    kept = np.delete(np.arange(N), np.arange(250, 260))
    arrays = {"time [s]": TIME[kept], "x [m]": X[kept]}
    (gap,) = (one.values for one in load_log(arrays).findings if one.code == "CL427")
    assert gap["windows"] == ('--window "0..249"', '--window "250..389"')
    after = load_log(arrays, window="250..389")
    assert after.result["position"][:, 0].tolist() == X[260:].tolist()
    far = np.where(np.arange(N) < 250, TIME, TIME + 0.3)
    with refuses(LogError, r'with --window "0\.\.249" or --window "250\.\.399"'):
        load_log({"time [s]": far, "x [m]": X})
    back = np.where(np.arange(N) < 250, TIME, TIME - 0.25)
    with refuses(LogError, r'--window "\.\.249"'):
        load_log({"time [s]": back, "x [m]": X})
    assert load_log({"time [s]": back, "x [m]": X}, window="..249").result.n_sample == 250
    assert load_log({"time [s]": back, "x [m]": X}, window="250..").result.n_sample == 150


def test_a_window_goes_with_its_log() -> None:
    whole = log_of()
    assert whole.span(parse_window("100..199")) == (pytest.approx(0.0995), pytest.approx(0.1995))
    assert whole.span(parse_window("0.2 s..0.3 s")) == (0.2, 0.3)
    assert log_of(window="100..199").given.window == parse_window("100..199")


@pytest.mark.parametrize(
    "text", ["", "..", "5", "soon", "5..1", "2 s..1 s", "1..2 s", "line 3..4", "1 mm..2 mm", "1.5..2", "-3..4", "1 s...2 s"]
)
def test_what_is_no_window(text: str) -> None:
    with refuses(ParameterError, name="--window"):
        parse_window(text)


@pytest.mark.parametrize("window", ["400..", "1 s..2 s", "line 3..line 4"])
def test_an_empty_window(window: str) -> None:
    with refuses(LogError, "--window"):
        log_of(window=window)


def test_columns_with_times_of_their_own_have_windows_in_time(tmp_path: Path) -> None:
    rows = "\n".join(f"{k}\t{k + 0.5}\t{f'{5 * k}' if k < 20 else ' '}\t{f'{k}' if k < 20 else ' '}" for k in range(100))
    head = "Name\tActPos X\tName\tActPos Y\nSampleTime[ms]\t1\tSampleTime[ms]\t5\nUnit\tmm\tUnit\tmm"
    file = tmp_path / "scope.csv"
    file.write_text(f"Name\tscope\nFile\ta\nStart\t1\nEnd\t2\n\n\n{head}\n{rows}\n", encoding="utf-8")
    part = load_log(file, window="20 ms..40 ms")
    assert part.result["position"][[0, -1]] == pytest.approx(1e-3 * np.array([[20.5, 4.0], [40.5, 8.0]]))
    with refuses(LogError, "times", file=file):
        load_log(file, window="20..40")


def test_one_unit_for_all_columns_without_one(tmp_path: Path) -> None:
    file = tmp_path / "a.txt"
    file.write_text("".join(f"{1.0 * k:f} {2.0 * k:f} {0.5 * k:f} \n" for k in range(50)), encoding="utf-8")
    columns = ["position.x=1", "reference.x=2", "velocity.x=3"]
    with refuses(LogError, "--unit mm"):
        load_log(file, columns=columns, period=1e-3)
    log = load_log(file, columns=columns, period=1e-3, unit="mm")
    assert [log.result[name][-1, 0] for name in ("position", "reference", "velocity")] == pytest.approx([0.049, 0.098, 0.0245])
    stated = load_log(file, columns=["position.x=1 [um]", "reference.x=2"], period=1e-3, unit="inch")
    assert stated.result["reference"][-1, 0] == pytest.approx(98e-6)  # like the position beside it
    for wrong in ("kg", "yoyo"):
        with refuses(ParameterError, name="--unit"):
            load_log(file, columns=columns, period=1e-3, unit=wrong)
