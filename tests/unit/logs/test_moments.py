"""Dates and times of day as the times of a log."""

from __future__ import annotations

from datetime import datetime, timedelta
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from contourlab.errors import LogError
from contourlab.logs import load_log, parse_columns
from contourlab.logs.moments import moments_of

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
        (["20240531T235959.998", "20240531T235959.999", "20240601T000000.000", "20240601T000000.001"], ";"),
        (["2024-05-31 23:59:59:998", "2024-05-31 23:59:59:999", "2024-06-01 00:00:00:000", "2024-06-01 00:00:00:001"], ";"),
        (["31.05.2024 23:59:59,998", "31.05.2024 23:59:59,999", "01.06.2024 00:00:00", "1.6.2024 00:00:00,001"], ";"),
        (["31/05/2024 23:59:59.998", "31/05/2024 23:59:59.999", "01/06/2024 00:00:00.000", "01/06/2024 00:00:00.001"], ","),
        (["05/31/2024 11:59:59.998 PM", "05/31/2024 11:59:59.999 PM", "06/01/2024 12:00:00.000 AM", "06/01/2024 12:00:00.001 AM"], ";"),
        # One day is one day, whichever of its numbers is the month.
        (["05/06/2024 14:03:21.250", "05/06/2024 14:03:21.251", "05/06/2024 14:03:21.252", "05/06/2024 14:03:21.253"], ";"),
        (["31-May-2024 23:59:59.998", "31-May-2024 23:59:59.999", "01-Jun-2024 00:00:00", "01-Jun-2024 00:00:00.001"], ";"),
        (["31 May 2024 23:59:59,998", "31 may 2024 23:59:59,999", "1 June 2024 00:00:00", "1. Jun. 2024 00:00:00,001"], ";"),
        (['"Sep 30, 2024 23:59:59.998"', '"Sept. 30, 2024 23:59:59.999"', '"Oct 1, 2024 0:00:00"', '"October 1, 2024 0:00:00.001"'], ","),
        (["23:59:59.998", "23:59:59.999", "00:00:00.000", "00:00:00.001"], ";"),
        (["23:59:59.998+02:00", "23:59:59.999+02:00", "00:00:00.000+02:00", "22:00:00.001Z"], ";"),
    ],
)
def test_moments_become_seconds_from_the_first(tmp_path: Path, cells: list[str], mark: str) -> None:
    found = load_log(log(tmp_path, cells, mark))
    assert found.result.servo_period == pytest.approx(1e-3, rel=1e-9)
    assert found.result["position"][:, 0] == pytest.approx(1e-4 * np.arange(4.0))
    assert found.start == 0.0


def test_times_of_day_past_midnight_are_told(tmp_path: Path) -> None:
    log_of = [f"23:59:{59 - k}" for k in (2, 1, 0)] + ["00:00:00", "00:00:01"]
    assert "times of day in 'stamp' run past midnight, and are counted on" in load_log(log(tmp_path, log_of)).notes


@given(
    st.datetimes(datetime(1990, 1, 13), datetime(2060, 1, 1)).filter(lambda start: start.day in range(13, 28)),
    st.sampled_from(
        [
            "%Y-%m-%dT%H:%M:%S.%f",
            "%Y%m%dT%H%M%S.%f",
            "%d.%m.%Y %H:%M:%S,%f",
            "%m/%d/%Y %I:%M:%S.%f %p",
            "%d-%m-%Y %H:%M:%S.%f",
            "%d-%b-%Y %H:%M:%S.%f",
        ]
    ),
    st.integers(1, 10**10),
)
def test_moments_are_those_of_the_calendar(start: datetime, form: str, microseconds: int) -> None:
    """Held against the standard library."""
    moments = [start + k * timedelta(microseconds=microseconds) for k in range(5)]
    found = moments_of({0: [moment.strftime(form) for moment in moments]}, ["stamp"], range(2, 7), Path("log.csv"))[0]
    assert found.fault is None
    assert found.seconds == pytest.approx([(moment - start).total_seconds() for moment in moments], abs=1e-10)


def test_nanoseconds_are_kept(tmp_path: Path) -> None:
    cells = [f"2024-05-31T14:03:21.2500{k:05d}Z" for k in range(0, 50000, 12500)]
    assert load_log(log(tmp_path, cells)).result.servo_period == pytest.approx(12.5e-6, rel=1e-9)


@pytest.mark.parametrize(
    ("cells", "mark", "said"),
    [
        (["05/06/2024 23:59:59", "06/06/2024 00:00:00", "06/06/2024 00:00:01"], ";", "csv:2: .*told for sure: write times as 2024-05-31T"),
        (["05/31/2024 23:59:59", "05/31/2024 23:59:59", "31/05/2024 23:59:59"], ";", "csv:4: .*the day first and the month first"),
        (["31.05.24 14:03:21", "31.05.24 14:03:22", "31.05.24 14:03:23"], ";", "told for sure"),
        (
            ["31-Mai-2024 14:03:21", "31-Mai-2024 14:03:22"],
            ";",
            "csv:2: '31-Mai-2024 14:03:21' in column 'stamp' .*: write times as 2024-05",
        ),
        (["31-May-24 14:03:21", "31-May-24 14:03:22"], ";", "csv:2: .*told for sure"),
        (["31-May-2024 14:03:21", "31.05.2024 14:03:22"], ";", "csv:3: .*in another way than those before"),
        (["31-Jun-2024 14:03:21", "31-Jun-2024 14:03:22"], ";", "csv:2: 2024-06-31 in column 'stamp' is no day of the calendar"),
        (["2024-05-31 14:03:21:5", "2024-05-31 14:03:22:5", "2024-05-31 14:03:23:5"], ";", "told for sure"),
        (["2024-05-31T14:03:21", "31.05.2024 14:03:22", "31.05.2024 14:03:23"], ";", "csv:3: .*in another way than those before"),
        (["14:03:21", "2:03:22 PM", "2:03:23 PM"], ";", "csv:3: .*in another way than those before"),
        (["14:03", "14:04", "14:05"], ";", "told for sure"),
        (["24:03:21", "24:03:22", "24:03:23"], ";", "csv:2: .*told for sure"),
        (["2024-05-31", "2024-06-01", "2024-06-02"], ";", "'stamp' holds dates without times of day"),
        (["2024-05-31T14:03:21 PM", "2024-05-31T14:03:22 PM", "2024-05-31T14:03:23 PM"], ";", "told for sure"),
        (["2024-05-31T14:03:21Z", "2024-05-31T14:03:22", "2024-05-31T14:03:23"], ";", "csv:3: .*only some of its times say their zone"),
        (["2024-02-30T14:03:21", "2024-02-30T14:03:22", "2024-02-30T14:03:23"], ";", "csv:2: .*is no day of the calendar"),
        (["2024-05-31T14:03:21", "yesterday", "2024-05-31T14:03:23"], ";", "csv:3: 'yesterday' in column 'stamp' is no date"),
        (["2024-05-31T14:03:21", "2024-05-31T14:03:22;7", "2024-05-31T14:03:23"], ";", "csv:3: has 3 columns where 2"),
        (["2024-05-31T14:03:21"] * 40 + ["2024-05-31T14:03:22"] * 40 + ["2024-05-31T14:03:23"], ";", "are written too coarsely"),
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


def in_two(folder: Path, rows: list[str], heads: str = "Date;Time") -> Path:
    file = folder / "log.csv"
    lines = [f"{row};{0.1 * i:.1f}" for i, row in enumerate(rows)]
    file.write_text("\n".join([f"{heads};x pos [mm]", *lines]) + "\n", encoding="utf-8")
    return file


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        (["2024-05-31;23:59:59.998", "2024-05-31;23:59:59.999", "2024-06-01;00:00:00.000", "2024-06-01;00:00:00.001"], "taken together"),
        (["31.05.2024;23:59:59,998", "31.05.2024;23:59:59,999", "01.06.2024;00:00:00,000", "01.06.2024;00:00:00,001"], "taken together"),
        # The dates may be days or months apart; the times of day leave no doubt.
        (
            ["05/06/2024;23:59:59.998", "05/06/2024;23:59:59.999", "06/06/2024;00:00:00.000", "06/06/2024;00:00:00.001"],
            "without their dates",
        ),
        (
            ["2024-02-30;23:59:59.998", "2024-02-30;23:59:59.999", "2024-02-30;00:00:00.000", "2024-02-30;00:00:00.001"],
            "without their dates",
        ),
    ],
)
def test_a_date_and_a_time_of_day_in_two_columns_are_one_moment(tmp_path: Path, rows: list[str], said: str) -> None:
    found = load_log(in_two(tmp_path, rows))
    assert found.result.servo_period == pytest.approx(1e-3, rel=1e-9)
    assert said in " ".join(found.notes)


@pytest.mark.parametrize("date", ["22.11.26", "22-Nov-26", "22-SEPT-26", "22-Okt-2026", "22/11/26"])
def test_a_date_that_cannot_be_told_is_passed_over_with_its_reason(tmp_path: Path, date: str) -> None:
    times = ["23:59:59.998", "23:59:59.999", "00:00:00.000", "00:00:00.001"]
    found = load_log(in_two(tmp_path, [f"{date};{time}" for time in times]))
    assert found.result.servo_period == pytest.approx(1e-3, rel=1e-9)
    why = f"'{date}' in column 'Date' is no date and time that can be told for sure"
    assert f"the times of day in 'Time' are taken without their dates: {why}" in found.notes
    assert "times of day in 'Time' run past midnight, and are counted on" in found.notes


def test_of_two_columns_of_dates_neither_goes_with_the_times_and_that_is_said(tmp_path: Path) -> None:
    rows = [f"2024-05-31;2024-05-30;14:03:21.{k:03d}" for k in range(4)]
    found = load_log(in_two(tmp_path, rows, "run;made;Time"))
    assert "the times of day in 'Time' are taken without their dates: they are in 'run' or 'made'" in found.notes


SPLIT = ["31.05.2024;23:59:59;998", "31.05.2024;23:59:59;999", "01.06.2024;00:00:00;000", "01.06.2024;00:00:00;001"]


@pytest.mark.parametrize("name", ["ms", "Milliseconds", "msec", "[ms]"])
def test_milliseconds_in_a_column_of_their_own(tmp_path: Path, name: str) -> None:
    found = load_log(in_two(tmp_path, SPLIT, f"Datum;Uhrzeit;{name}"))
    assert found.result.servo_period == pytest.approx(1e-3, rel=1e-9)
    assert f"the times of day in 'Uhrzeit' and the milliseconds in {name!r} are taken together" in found.notes
    assert found.result["position"][:, 0] == pytest.approx(1e-4 * np.arange(4.0))


def test_milliseconds_beside_whole_moments_and_of_the_time_to_their_left(tmp_path: Path) -> None:
    rows = [f"2024-05-31 14:03:2{k // 2};{500 * (k % 2) + 0.25};15:00:00" for k in range(6)]
    found = load_log(in_two(tmp_path, rows, "stamp;ms;until"), columns=parse_columns(["time=stamp"]))
    assert found.result.servo_period == pytest.approx(0.5, rel=1e-9)


def test_a_row_without_its_milliseconds_has_no_time(tmp_path: Path) -> None:
    rows = [f"14:03:{20 + k // 10};{'' if k == 30 else 100 * (k % 10)}" for k in range(60)]
    assert "1 of 60 rows say no time, and are left out" in load_log(in_two(tmp_path, rows, "time;ms")).notes


def test_what_cannot_be_milliseconds_is_not_joined(tmp_path: Path) -> None:
    rows = [f"14:03:{20 + k // 10};{100 * k}" for k in range(60)]
    said = "too coarsely; column 'ms' is not joined to the times in 'time' as milliseconds: '1000' in line 12 is none of 0 to 999"
    with pytest.raises(LogError, match=said):
        load_log(in_two(tmp_path, rows, "time;ms"))
    with pytest.raises(LogError, match="written too coarsely, and no column beside it is called ms or milliseconds: write times as"):
        load_log(in_two(tmp_path, rows, "time;thousandths"))
    none = [f"14:03:{20 + k};" for k in range(10)]
    assert load_log(in_two(tmp_path, none, "time;ms")).result.servo_period == pytest.approx(1.0)
    fine = [f"14:03:21.{k:03d};{100 * k}" for k in range(60)]
    assert load_log(in_two(tmp_path, fine, "time;ms")).result.servo_period == pytest.approx(1e-3)


def test_days_between_are_counted_where_the_date_says_so(tmp_path: Path) -> None:
    rows = [f"2024-05-{day};12:00:00" for day in (28, 29, 30, 31)]
    assert load_log(in_two(tmp_path, rows)).result.servo_period == 86400.0


def test_dates_and_times_in_columns_parted_by_blanks(tmp_path: Path) -> None:
    file = tmp_path / "log.txt"
    file.write_text("Date Time x_pos\n" + "".join(f"2024-05-31 14:03:2{k} {k}\n" for k in range(4)))
    assert load_log(file, columns=parse_columns(["position.x=x_pos [mm]"])).result.servo_period == pytest.approx(1.0)


def test_of_two_times_of_day_the_one_that_is_called_so(tmp_path: Path) -> None:
    rows = [f"2024-05-31;14:00:00;14:03:2{k}" for k in range(4)]
    assert load_log(in_two(tmp_path, rows, "Date;Begin;Time")).result.servo_period == pytest.approx(1.0)
    file = in_two(tmp_path, rows, "Date;Begin;Stamp")
    with pytest.raises(LogError, match="time may be 'Begin' or 'Stamp': none is taken, say which with --column; says no sample times"):
        load_log(file)
    assert load_log(file, columns=parse_columns(["time=Stamp"])).result.servo_period == pytest.approx(1.0)
    with pytest.raises(LogError, match=r"'Date' holds dates without times of day.*are in 'Begin'"):
        load_log(file, columns=parse_columns(["time=Date"]))


@pytest.mark.parametrize("cells", ["31.05.24;14:03:21", "2024-05-31;14:03:21", "05/06/2024;14:03:60", ";", "2024-05-31;"])
def test_dates_that_nobody_needs_are_no_fault(tmp_path: Path, cells: str) -> None:
    timed = in_two(tmp_path, [f"{cells};{0.002 * k:.3f}" for k in range(4)], "Date;Written at;t [s]")
    assert load_log(timed).result.servo_period == pytest.approx(2e-3)
    counted = load_log(in_two(tmp_path, [cells] * 4, "Date;Written at"), period=1e-3)
    assert counted.result.servo_period == 1e-3


@pytest.mark.parametrize(
    ("cells", "why"),
    [
        (["2024-05-31T14:03:21"] * 30 + ["2024-05-31T14:03:22"] * 30, "written too coarsely"),
        (["31.05.24 14:03:21", "31.05.24 14:03:22", "31.05.24 14:03:23"], "csv:2: .*told for sure"),
        (["14:03:21", "14:03:22", "noon"], "csv:4: 'noon'"),
        (["", "", ""], "holds no times"),
    ],
)
def test_a_period_counts_samples_that_their_column_does_not(tmp_path: Path, cells: list[str], why: str) -> None:
    """It is said why the column is not used; a column that the user has named for it has to be right."""
    file = log(tmp_path, cells, name="timestamp")
    counted = load_log(file, period=1e-3)
    assert counted.result.servo_period == 1e-3
    assert any("samples are counted by the period" in note and "write times as" not in note for note in counted.notes)
    with pytest.raises(LogError, match=why):
        load_log(file)
    with pytest.raises(LogError, match=why):
        load_log(file, columns=parse_columns(["time=timestamp"]), period=1e-3)


@pytest.mark.parametrize("stamps", [[f"2024-05-31T14:03:{k}" for k in range(10, 60)], [str(k) for k in range(50)]])
def test_rows_without_a_time_are_gaps(tmp_path: Path, stamps: list[str]) -> None:
    stamps[0] = stamps[20] = ""
    found = load_log(log(tmp_path, stamps, name="timestamp"))
    assert "2 of 50 rows say no time, and are left out" in found.notes
    assert any("1 of 49 samples are missing, in 1 gap" in note for note in found.notes)
    assert found.result["position"][19, 0] == pytest.approx(20e-4)  # between the rows beside it


def test_rows_without_a_time_in_parquet_are_gaps(tmp_path: Path) -> None:
    arrow = pytest.importorskip("pyarrow")
    from pyarrow import parquet

    stamps = [None if k in (0, 30) else datetime(2024, 5, 31, 23, 59, 59) + timedelta(milliseconds=k) for k in range(60)]
    parquet.write_table(arrow.table({"stamp": stamps, "x pos [mm]": [1e-3 * k for k in range(60)]}), tmp_path / "log.parquet")
    found = load_log(tmp_path / "log.parquet")
    assert found.result.servo_period == pytest.approx(1e-3)
    assert "2 of 60 rows say no time, and are left out" in found.notes
