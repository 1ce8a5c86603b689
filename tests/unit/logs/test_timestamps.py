"""Dates and times of day as the times of a log."""

from __future__ import annotations

from datetime import datetime, timedelta
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from contourlab.errors import LogError
from contourlab.findings import finding
from contourlab.logs import load_log, parse_columns
from contourlab.logs.delimited import timestamp_channel


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
        # The clocks go back one hour: the offset shows it, and no time is lost.
        (
            ["2024-10-27T02:59:59.999+02:00", "2024-10-27T02:00:00.000+01:00", "2024-10-27T02:00:00.001+0100", "2024-10-27T01:00:00.002Z"],
            ";",
        ),
        (["14:03:21.2500", "14:03:21.2510", "14:03:21.2520", "14:03:21.2530"], ";"),
        (["20240531T235959.998", "20240531T235959.999", "20240601T000000.000", "20240601T000000.001"], ";"),
        (["31.05.2024 23:59:59,998", "31.05.2024 23:59:59,999", "01.06.2024 00:00:00", "1.6.2024 00:00:00,001"], ";"),
        (["31-May-2024 23:59:59.998", "31-May-2024 23:59:59.999", "01-Jun-2024 00:00:00", "01-Jun-2024 00:00:00.001"], ";"),
        (["23:59:59.998", "23:59:59.999", "00:00:00.000", "00:00:00.001"], ";"),
    ],
)
def test_timestamps_become_seconds_from_the_first(tmp_path: Path, cells: list[str], mark: str) -> None:
    found = load_log(log(tmp_path, cells, mark))
    assert found.result.servo_period == pytest.approx(1e-3, rel=1e-9)
    assert found.result["position"][:, 0] == pytest.approx(1e-4 * np.arange(4.0))
    assert found.start == 0.0


def test_times_of_day_past_midnight_are_recognised(tmp_path: Path) -> None:
    log_of = [f"23:59:{59 - k}" for k in (2, 1, 0)] + ["00:00:00", "00:00:01"]
    assert finding("CL421", column="stamp") in load_log(log(tmp_path, log_of)).findings


@given(
    st.datetimes(datetime(1990, 1, 13), datetime(2060, 1, 1)).filter(lambda start: start.day in range(13, 28)),
    st.sampled_from(
        [
            "%Y-%m-%dT%H:%M:%S.%f",
            "%Y%m%dT%H%M%S.%f",
            "%d.%m.%Y %H:%M:%S,%f",
            "%d-%b-%Y %H:%M:%S.%f",
        ]
    ),
    st.integers(1, 10**10),
)
def test_timestamps_agree_with_the_calendar(start: datetime, form: str, microseconds: int) -> None:
    """Compared with the standard library."""
    moments = [start + k * timedelta(microseconds=microseconds) for k in range(5)]
    found = timestamp_channel("stamp", [moment.strftime(form) for moment in moments], range(2, 7), Path("log.csv"))
    assert found.fault is None
    assert found.values == pytest.approx([(moment - start).total_seconds() for moment in moments], abs=1e-10)


def test_nanoseconds_are_kept(tmp_path: Path) -> None:
    cells = [f"2024-05-31T14:03:21.2500{k:05d}Z" for k in range(0, 50000, 12500)]
    assert load_log(log(tmp_path, cells)).result.servo_period == pytest.approx(12.5e-6, rel=1e-9)


@pytest.mark.parametrize(
    ("cells", "line"),
    [
        (["05/06/2024 23:59:59", "06/06/2024 00:00:00", "06/06/2024 00:00:01"], 2),
        (["31/05/2024 23:59:58", "31/05/2024 23:59:59", "01/06/2024 00:00:00"], 2),
        (["31.05.24 14:03:21", "31.05.24 14:03:22", "31.05.24 14:03:23"], 2),
        (["31-Mai-2024 14:03:21", "31-Mai-2024 14:03:22"], 2),
        (["31-Jun-2024 14:03:21", "31-Jun-2024 14:03:22"], 2),
        (["2024-05-31T14:03:21", "31.05.2024 14:03:22", "31.05.2024 14:03:23"], 3),
        (["14:03:21", "2:03:22 PM", "2:03:23 PM"], 3),
        (["14:03", "14:04", "14:05"], 2),
        (["24:03:21", "24:03:22", "24:03:23"], 2),
        (["2024-05-31", "2024-06-01", "2024-06-02"], 2),
        (["2024-05-31T14:03:21Z", "2024-05-31T14:03:22", "2024-05-31T14:03:23"], 3),
        (["2024-02-28T14:03:21", "2024-02-30T14:03:22", "2024-02-30T14:03:23"], 3),
        (["2024-05-31T14:03:21", "2824-05-31T14:03:22", "2024-05-31T14:03:23"], 3),
        (["2024-05-31T14:03:21", "yesterday", "2024-05-31T14:03:23"], 3),
    ],
)
def test_an_ambiguous_timestamp_is_refused_with_its_line_and_advice(tmp_path: Path, cells: list[str], line: int) -> None:
    with pytest.raises(LogError, match="--period") as refused:
        load_log(log(tmp_path, cells))
    assert refused.value.line == line


@pytest.mark.parametrize(
    ("cells", "said"),
    [
        (["2024-05-31T14:03:21", "2024-05-31T14:03:22;7", "2024-05-31T14:03:23"], "csv:3: has 3 columns"),
        (["2024-05-31T14:03:21"] * 40 + ["2024-05-31T14:03:22"] * 40 + ["2024-05-31T14:03:23"], "repeat"),
        (["2024-05-31T14:03:21", "2024-05-31T14:03:20", "2024-05-31T14:03:23"], "time goes back"),
    ],
)
def test_invalid_times_are_refused(tmp_path: Path, cells: list[str], said: str) -> None:
    with pytest.raises(LogError, match=said):
        load_log(log(tmp_path, cells))


def test_a_named_column_has_priority_over_dates(tmp_path: Path) -> None:
    file = tmp_path / "log.csv"
    rows = [f"2024-05-31T14:03:2{i};{0.002 * i:.3f};{i}" for i in range(4)]
    file.write_text("\n".join(["written at;t [s];x pos [mm]", *rows]) + "\n")
    assert load_log(file).result.servo_period == pytest.approx(2e-3)
    named = parse_columns(["time=written at"])
    assert load_log(file, columns=named).result.servo_period == pytest.approx(1.0)
    with pytest.raises(LogError, match=r"\bms\b"):
        load_log(file, columns=parse_columns(["time=written at [ms]"]))


def in_two(folder: Path, rows: list[str], heads: str = "Date;Time") -> Path:
    file = folder / "log.csv"
    lines = [f"{row};{0.1 * i:.1f}" for i, row in enumerate(rows)]
    file.write_text("\n".join([f"{heads};x pos [mm]", *lines]) + "\n", encoding="utf-8")
    return file


@pytest.mark.parametrize("date", ["2024-05-31", "31.05.2024", "22.11.26", "22-SEPT-26", "22/11/26"])
def test_with_a_date_column_only_times_of_day_count(tmp_path: Path, date: str) -> None:
    times = ["23:59:59.998", "23:59:59.999", "00:00:00.000", "00:00:00.001"]
    found = load_log(in_two(tmp_path, [f"{date};{time}" for time in times]))
    assert found.result.servo_period == pytest.approx(1e-3, rel=1e-9)


def test_dates_and_times_in_columns_separated_by_blanks(tmp_path: Path) -> None:
    file = tmp_path / "log.txt"
    file.write_text("Date Time x_pos\n" + "".join(f"2024-05-31 14:03:2{k} {k}\n" for k in range(4)))
    assert load_log(file, columns=parse_columns(["position.x=x_pos [mm]"])).result.servo_period == pytest.approx(1.0)


def test_of_two_times_of_day_the_one_named_time_counts(tmp_path: Path) -> None:
    rows = [f"2024-05-31;14:00:00;14:03:2{k}" for k in range(4)]
    assert load_log(in_two(tmp_path, rows, "Date;Begin;Time")).result.servo_period == pytest.approx(1.0)
    file = in_two(tmp_path, rows, "Date;Begin;Stamp")
    with pytest.raises(LogError, match=r"'Begin'.*'Stamp'.*--column"):
        load_log(file)
    assert load_log(file, columns=parse_columns(["time=Stamp"])).result.servo_period == pytest.approx(1.0)
    with pytest.raises(LogError, match="'Date'"):
        load_log(file, columns=parse_columns(["time=Date"]))


@pytest.mark.parametrize("cells", ["31.05.24;14:03:21", "2024-05-31;14:03:21", "05/06/2024;14:03:60", ";", "2024-05-31;"])
def test_faults_in_unused_dates_are_ignored(tmp_path: Path, cells: str) -> None:
    timed = in_two(tmp_path, [f"{cells};{0.002 * k:.3f}" for k in range(4)], "Date;Written at;t [s]")
    assert load_log(timed).result.servo_period == pytest.approx(2e-3)
    counted = load_log(in_two(tmp_path, [cells] * 4, "Date;Written at"), period=1e-3)
    assert counted.result.servo_period == 1e-3


@pytest.mark.parametrize(
    ("cells", "why"),
    [
        (["2024-05-31T14:03:21"] * 30 + ["2024-05-31T14:03:22"] * 30, "repeat"),
        (["31.05.24 14:03:21", "31.05.24 14:03:22", "31.05.24 14:03:23"], "csv:2: .*timestamp"),
        (["14:03:21", "14:03:22", "noon"], "csv:4: 'noon'"),
        (["", "", ""], "no times"),
    ],
)
def test_a_period_replaces_an_unusable_time_column(tmp_path: Path, cells: list[str], why: str) -> None:
    """The finding says why the column is not used; a column named by the user must be valid."""
    file = log(tmp_path, cells, name="timestamp")
    counted = load_log(file, period=1e-3)
    assert counted.result.servo_period == 1e-3
    assert ["2024-05-31T14:03:21.250" in one.text for one in counted.findings if one.code == "CL432"] == [False]
    with pytest.raises(LogError, match=why):
        load_log(file)
    with pytest.raises(LogError, match=why):
        load_log(file, columns=parse_columns(["time=timestamp"]), period=1e-3)


@pytest.mark.parametrize("stamps", [[f"2024-05-31T14:03:{k}" for k in range(10, 60)], [str(k) for k in range(50)]])
def test_rows_without_a_time_are_gaps(tmp_path: Path, stamps: list[str]) -> None:
    stamps[0] = stamps[20] = ""
    found = load_log(log(tmp_path, stamps, name="timestamp"))
    assert finding("CL434", missing=2, rows=50) in found.findings
    assert [(one.values["missing"], one.values["samples"]) for one in found.findings if one.code == "CL427"] == [(1, 49)]
    assert found.result["position"][19, 0] == pytest.approx(20e-4)  # between its neighbouring rows


@pytest.mark.slow
def test_rows_without_a_time_in_parquet_are_gaps(tmp_path: Path) -> None:
    arrow = pytest.importorskip("pyarrow")
    from pyarrow import parquet

    stamps = [None if k in (0, 30) else datetime(2024, 5, 31, 23, 59, 59) + timedelta(milliseconds=k) for k in range(60)]
    parquet.write_table(arrow.table({"stamp": stamps, "x pos [mm]": [1e-3 * k for k in range(60)]}), tmp_path / "log.parquet")
    found = load_log(tmp_path / "log.parquet")
    assert found.result.servo_period == pytest.approx(1e-3)
    assert finding("CL434", missing=2, rows=60) in found.findings
