"""Dates and times of day as the times of a log."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from contourlab.errors import LogError
from contourlab.logs import load_log, parse_columns

HOUR, MINUTE = "2024-05-31T14:03:21.250+02:00", "14:03:21.250"


def log(folder: Path, cells: list[str], mark: str = ";", name: str = "stamp") -> Path:
    file = folder / "log.csv"
    rows = [f"{cell}{mark}{0.1 * i:.1f}" for i, cell in enumerate(cells)]
    file.write_text("\n".join([f"{name}{mark}x pos [mm]", *rows]) + "\n", encoding="utf-8")
    return file


@pytest.mark.parametrize(
    ("cells", "mark"),
    [
        (["2024-05-31T23:59:59.998", "2024-05-31T23:59:59.999", "2024-06-01T00:00:00.000", "2024-06-01T00:00:00.001"], ";"),
        (["2024-05-31 14:03:21.250", "2024-05-31 14:03:21.251", "2024-05-31 14:03:21.252", "2024-05-31 14:03:21.253"], ","),
        (["2024-05-31 14:03:21,250", "2024-05-31 14:03:21,251", "2024-05-31 14:03:21,252", "2024-05-31 14:03:21,253"], ";"),
        (["2024-05-31T14:03:21.250Z", "2024-05-31T14:03:21.251Z", "2024-05-31T14:03:21.252Z", "2024-05-31T14:03:21.253Z"], "\t"),
        # The clocks are put back an hour: the offset says so, and no time is lost.
        (
            ["2024-10-27T02:59:59.999+02:00", "2024-10-27T02:00:00.000+01:00", "2024-10-27T02:00:00.001+0100", "2024-10-27T01:00:00.002Z"],
            ";",
        ),
        (["14:03:21.2500", "14:03:21.2510", "14:03:21.2520", "14:03:21.2530"], ";"),
    ],
)
def test_moments_become_seconds_from_the_first(tmp_path: Path, cells: list[str], mark: str) -> None:
    found = load_log(log(tmp_path, cells, mark))
    assert found.result.servo_period == pytest.approx(1e-3, rel=1e-9)
    assert found.result["position"][:, 0] == pytest.approx(1e-4 * np.arange(4.0))
    assert found.start == 0.0


def test_nanoseconds_are_kept(tmp_path: Path) -> None:
    cells = [f"2024-05-31T14:03:21.2500{k:05d}Z" for k in range(0, 50000, 12500)]
    assert load_log(log(tmp_path, cells)).result.servo_period == pytest.approx(12.5e-6, rel=1e-9)


@pytest.mark.parametrize(
    ("cells", "mark", "said"),
    [
        (["05/06/2024 14:03:21", "05/06/2024 14:03:22", "05/06/2024 14:03:23"], ";", "told for sure: write times as 2024-05-31T"),
        (["31.05.2024 14:03:21", "31.05.2024 14:03:22", "31.05.2024 14:03:23"], ";", "told for sure"),
        (["14:03", "14:04", "14:05"], ";", "told for sure"),
        (["2024-05-31", "2024-06-01", "2024-06-02"], ";", "told for sure"),
        (["2024-05-31T14:03:21 PM", "2024-05-31T14:03:22 PM", "2024-05-31T14:03:23 PM"], ";", "told for sure"),
        (["2024-05-31T14:03:21Z", "2024-05-31T14:03:22", "2024-05-31T14:03:23"], ";", "csv:3: .*only some of its times say their zone"),
        (["2024-02-30T14:03:21", "2024-02-30T14:03:22", "2024-02-30T14:03:23"], ";", "csv:2: .*is no day and time"),
        (["2024-05-31T14:03:21", "yesterday", "2024-05-31T14:03:23"], ";", "csv:3: 'yesterday' in column 1"),
        (["2024-05-31T14:03:21", "2024-05-31T14:03:22;7", "2024-05-31T14:03:23"], ";", "csv:3: has 3 columns where 2"),
        (["2024-05-31 14:03:21", "2024-05-31 14:03:22", "2024-05-31 14:03:23"], " ", "part columns by semicolons"),
        (["2024-05-31T14:03:21"] * 40 + ["2024-05-31T14:03:22"] * 40 + ["2024-05-31T14:03:23"], ";", "times are written too coarsely"),
        (["2024-05-31T14:03:21", "2024-05-31T14:03:20", "2024-05-31T14:03:23"], ";", "time goes back"),
    ],
)
def test_what_is_not_told_for_sure_is_refused(tmp_path: Path, cells: list[str], mark: str, said: str) -> None:
    with pytest.raises(LogError, match=said):
        load_log(log(tmp_path, cells, mark))


def test_a_column_that_is_named_goes_before_one_of_dates(tmp_path: Path) -> None:
    file = tmp_path / "log.csv"
    rows = [f"2024-05-31T14:03:2{i};{0.002 * i:.3f};{i}" for i in range(4)]
    file.write_text("\n".join(["written at;t [s];x pos [mm]", *rows]) + "\n")
    assert load_log(file).result.servo_period == pytest.approx(2e-3)
    named = parse_columns(["time=written at"])
    assert load_log(file, columns=named).result.servo_period == pytest.approx(1.0)
    with pytest.raises(LogError, match="holds dates and times of day: name it without ms"):
        load_log(file, columns=parse_columns(["time=written at [ms]"]))
