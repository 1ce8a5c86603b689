"""From a log to a result: column names, units and clocks."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from contourlab.errors import LogError, ParameterError
from contourlab.findings import finding
from contourlab.logs import Channel, Columns, Log, Record, load_log, parse_columns, read_columns, result_of
from contourlab.logs.clock import look_at_clock
from contourlab.logs.mapping import guessed

FILE = Path("bench.csv")


def record(*channels: Channel, period: float | None = None) -> Record:
    return Record(FILE, "csv", channels, period)


def table(tmp_path: Path, heads: str, rows: np.ndarray) -> Path:
    file = tmp_path / "a.csv"
    file.write_text("\n".join([heads, *(",".join(f"{v:.12g}" for v in row) for row in rows)]) + "\n")
    return file


def codes(log: Log) -> set[str]:
    return {one.code for one in log.findings}


def test_columns_become_signals_in_si(tmp_path: Path) -> None:
    t = np.arange(5) * 1e-3
    file = table(tmp_path, "t [ms],enc [mm],cmd [V]", np.column_stack([t * 1e3, t * 20.0, t]))
    log = load_log(file, columns=parse_columns(["position.x=enc", "command.x=-cmd"]))
    assert log.result.servo_period == 1e-3
    assert log.result["position"][:, 0] == pytest.approx(t * 0.02, abs=1e-18)
    assert log.result["command"][:, 0] == pytest.approx(-t) and log.result.signals["command"].unit == "V"
    assert log.findings == ()


def test_ambiguous_columns_are_not_used() -> None:
    channels = [Channel(name, np.arange(3.0), "mm") for name in ("x pos", "x encoder", "y pos")]
    log = result_of(record(*channels, period=1e-3), Columns())
    assert log.result.axes == ("y",)
    assert finding("CL431", signal="position.x", columns="'x pos' or 'x encoder'") in log.findings
    with pytest.raises(LogError, match=r"position\.x.*'x pos'.*'x encoder'"):
        result_of(record(*channels[:2], period=1e-3), Columns())
    # One of the two is the reference, so the other is unambiguous.
    log = result_of(record(*channels, period=1e-3), Columns(parse_columns(["reference.x=x pos"])))
    assert log.result.axes == ("x", "y") and "CL431" not in codes(log)


def test_the_path_in_the_control_completes_an_ambiguous_name() -> None:
    twice = [Channel(f"ActPos #{n}", np.arange(3.0), "mm", symbol=f"Axes.Axis {n}.ToPlc.ActPos") for n in (1, 2)]
    said = Channel("Y raw encoder", np.arange(3.0), "mm", symbol="Axes.Axis 3.ToPlc.ActPos")
    assert guessed(record(*twice)) == {("position", "x"): ["ActPos #1"], ("position", "y"): ["ActPos #2"]}
    assert guessed(record(said)) == {("position", "y"): ["Y raw encoder"]}


def test_an_exact_signal_name_has_priority_over_similar_ones() -> None:
    names = ("reference.x", "reference_acceleration.x", "position.x", "axis_position.x")
    assert guessed(record(*(Channel(name, np.arange(3.0)) for name in names)))["reference", "x"] == ["reference.x"]


def test_a_date_is_the_time_only_without_another_time_column() -> None:
    date, time = Channel("timestamp", np.arange(3.0), "s", is_timestamp=True), Channel("time", np.arange(3.0), "s")
    assert guessed(record(date, time))["time", ""] == ["time"]
    assert guessed(record(date))["time", ""] == ["timestamp"]


def test_faults_in_unused_times_are_ignored() -> None:
    """Channels with their own times do not need the constant time column."""
    even = np.arange(50) * 1e-3
    log = result_of(record(Channel("time", np.zeros(50), "s", even), Channel("x pos", even, "m", even)), Columns())
    assert log.result.servo_period == 1e-3
    with pytest.raises(LogError, match=r"'time'.*repeat"):
        result_of(record(Channel("time", np.zeros(50), "s"), Channel("x pos", even, "m")), Columns())


def test_user_settings_have_priority() -> None:
    channels = Channel("x pos", np.arange(3.0), "mm"), Channel("raw", 2.0 * np.arange(3.0), "mm")
    log = result_of(record(*channels, period=1e-3), Columns(parse_columns(["position.x=raw"])))
    assert log.result["position"][:, 0] == pytest.approx(2e-3 * np.arange(3.0))


@pytest.mark.parametrize(
    ("texts", "said"),
    [
        (["position.x"], "write for example position.x=NAME"),
        (["place.x=a"], "'place.x' is not a signal"),
        (["position=a"], "write the axis"),
        (["time.x=a"], "no axis"),
        (["position.x=a [kg]"], "kg.*position"),
        (["position.x=a [beans]"], "unknown unit"),
        (["position.x=a [-]"], "unknown unit"),
        (["position.x=a", "position.x=b"], "position.x.*'a'.*'b'"),
    ],
)
def test_an_unknown_column_is_refused(texts: list[str], said: str) -> None:
    with pytest.raises(LogError, match=said):
        parse_columns(texts)


def test_a_column_file(tmp_path: Path) -> None:
    file = tmp_path / "map.toml"
    text = 'period = "0.5 ms"\n[columns]\n"position.x" = "enc [mm]"\n"command.x" = {column = "u", unit = "N*m", factor = -2}\n'
    file.write_text(text)
    found = read_columns(file)
    assert found.period == 0.5e-3
    assert [(c.signal, c.axis, c.column, c.unit, c.factor) for c in found.columns] == [
        ("position", "x", "enc", "mm", 1.0),
        ("command", "x", "u", "N*m", -2.0),
    ]
    for line, said in [
        ("speed = 3", "speed: unknown key"),
        ('period = "3 mm"', "period: "),
        ("columns = 3", "columns: .*table"),
        ('[columns]\n"position.x" = {colum = "a"}', "columns.position.x: write"),
        ('[columns]\n"position.x" = {column = "a", factor = 0}', "factor = 0"),
        ("[columns", "not valid TOML"),
    ]:
        file.write_text(line)
        with pytest.raises(LogError, match=said):
            read_columns(file)


@pytest.mark.parametrize(
    ("channels", "columns", "said"),
    [
        ([Channel("a", np.arange(3.0))], [], "matches a signal"),
        ([Channel("a", np.arange(3.0))], ["position.x=b [mm]"], "'b'.*'a'"),
        ([Channel("a", np.arange(3.0))], ["position.x=a"], "'a'.*no unit"),
        ([Channel("a", np.arange(3.0), "kg")], ["position.x=a"], "kg.*position"),
        ([Channel("a", 1e5 * np.arange(3.0), "mm")], ["position.x=a"], "2e[+]05 mm|200 m"),
        ([Channel("a", np.full(3, np.nan), "mm")], ["position.x=a"], "no numbers"),
    ],
)
def test_contradictory_columns_are_refused(channels: list[Channel], columns: list[str], said: str) -> None:
    with pytest.raises(LogError, match=said):
        result_of(record(*channels, period=1e-3), Columns(parse_columns(columns)))


def test_without_times_a_period_is_required() -> None:
    channel = Channel("a", np.arange(4.0), "mm")
    with pytest.raises(LogError, match="--period"):
        result_of(record(channel), Columns(parse_columns(["position.x=a"])))
    log = result_of(record(channel), Columns(parse_columns(["position.x=a"]), 2e-3))
    assert log.result.servo_period == 2e-3
    with pytest.raises(ParameterError, match="period"):
        load_log(FILE, period=-1.0)


def look(time: np.ndarray, period: float | None = None) -> list[str]:
    return [one.text for one in look_at_clock(time, "a", FILE, period)[0].findings()]


def test_a_uniform_clock_gives_no_finding() -> None:
    time = np.arange(1000) * 1e-4
    assert look(np.round(time, 7)) == []
    assert look_at_clock(np.float32(time).astype(float), "a", FILE)[0].period == 1e-4


def test_gaps_are_counted_and_located() -> None:
    time = np.delete(np.arange(200) * 1e-3, [50, 51, 52, 120])
    report, _ = look_at_clock(time, "a", FILE)
    assert [(round(gap.time, 6), gap.missing) for gap in report.gaps] == [(0.049, 3), (0.119, 1)]
    assert report.period == pytest.approx(1e-3)
    assert re.findall(r"\d+(?:\.\d+)?", report.findings()[0].text)[:6] == ["4", "200", "2", "3", "0.049", "0.053"]


def test_too_large_a_gap_is_refused_with_its_place() -> None:
    time = np.arange(400) * 1e-3
    with pytest.raises(LogError, match=r"40 of 400.*'a'.*1000 us.*0\.099 s to 0\.14 s.*cut"):
        look(np.delete(time, range(100, 140)))
    with pytest.raises(LogError, match=r"80 gaps.*0 s to 0\.002 s.*period"):
        look(np.delete(time, range(1, 400, 5)))


def test_an_interpolated_channel_is_reported_with_its_clock() -> None:
    t = np.arange(101) * 1e-3
    fast, slow = (Channel(name, time, "mm", time) for name, time in (("x act", t), ("x ref", t[::2])))
    log = result_of(record(fast, slow), Columns())
    assert log.result.servo_period == 1e-3 and log.result.n_sample == 101
    assert log.findings[-1] == finding("CL429", "'x ref'", own=pytest.approx(2e-3), clock=1e-3)


@pytest.mark.parametrize(
    ("time", "said"),
    [
        (np.array([0.0, 1.0, 0.5, 2.0]), "1 s to 0.5 s at sample 2"),
        (np.array([0.0, 1.0, np.nan, 2.0]), "not finite at sample 2"),
        (np.zeros(5), "'a' at different times, 1"),
        (np.cumsum(np.append(np.full(30, 1e-3), np.full(20, 7e-3))), "missing"),
    ],
)
def test_invalid_times(time: np.ndarray, said: str) -> None:
    with pytest.raises(LogError, match=said):
        look(time)


@given(st.floats(1e-5, 1e-1), st.floats(0.0, 0.2), st.integers(0, 2**31))
def test_the_planted_jitter_is_measured(period: float, size: float, seed: int) -> None:
    off = size * period * np.random.default_rng(seed).uniform(-1.0, 1.0, 400)
    report, _ = look_at_clock(np.arange(400) * period + off, "a", FILE)
    assert report.period == pytest.approx(period, rel=2.0 * size / 399.0 + 1e-6)
    assert report.jitter_rms == pytest.approx(off.std(), abs=0.02 * size * period + 1e-4 * period)
    assert not report.gaps


def jittering(size: float, lost: list[int] | np.ndarray, seed: int = 1, n: int = 5000) -> tuple[np.ndarray, np.ndarray]:
    """Return written and true times of samples every millisecond, some lost."""
    true = np.delete(np.arange(n) * 1e-3, lost)
    return np.sort(true + size * 1e-3 * np.random.default_rng(seed).uniform(-1.0, 1.0, true.size)), true


@settings(max_examples=30)
@given(st.floats(0.1, 0.4), st.integers(0, 2**31))
@pytest.mark.slow
def test_jitter_is_not_taken_for_gaps(size: float, seed: int) -> None:
    """Steps of up to 1.8 periods, one lost sample and a gap of 40."""
    time, _ = jittering(size, [1200, *range(3000, 3040)], seed)
    report, _ = look_at_clock(time, "a", FILE)
    assert report.missing == 41 and max(gap.missing for gap in report.gaps) >= 39
    assert report.period == pytest.approx(1e-3, rel=1e-5)
    assert report.jitter_rms == pytest.approx(size * 1e-3 / np.sqrt(3.0), rel=0.05)


@pytest.mark.slow
@pytest.mark.parametrize("n", [100, 200, 1000, 5000, 100_000])
@pytest.mark.parametrize("size", [0.13, 0.2, 0.4, 0.45])
@pytest.mark.parametrize("share", [0.0, 0.01, 0.05])
def test_scattered_losses_are_counted_under_jitter(n: int, size: float, share: float) -> None:
    lost = np.random.default_rng(7).choice(np.arange(1, n - 1), round(share * n), replace=False)
    report, _ = look_at_clock(jittering(size, lost, n=n)[0], "a", FILE)
    assert report.missing == lost.size
    assert report.period == pytest.approx(1e-3, rel=4.0 * size / n**1.5)  # of a fitted line: 2 size / n^1.5 is one standard deviation
    assert report.jitter_rms == pytest.approx(size * 1e-3 / np.sqrt(3.0), rel=0.1 if n < 500 else 0.04)


@pytest.mark.parametrize("n", [200, 5000])
@pytest.mark.parametrize("share", [0.06, 0.1, 0.2, 0.5])
def test_more_scattered_losses_are_refused_under_jitter(n: int, share: float) -> None:
    lost = np.random.default_rng(7).choice(np.arange(1, n - 1), round(share * n), replace=False)
    with pytest.raises(LogError, match="are missing"):
        look(jittering(0.4, lost, n=n)[0])


def test_a_drifting_clock_is_followed_under_jitter_and_losses() -> None:
    """The period changes by 300 ppm, over the record by several samples."""
    time, true = jittering(0.4, np.arange(7, 20_000, 25), n=20_000)
    report, _ = look_at_clock(time + 3e-4 * np.sin(true) + 3e-4 * np.sin(true / 10.0) * 10.0, "a", FILE)
    assert report.missing == 800


def test_times_without_a_clock_are_refused() -> None:
    for seed in range(3):
        with pytest.raises(LogError, match="period"):
            look(np.cumsum(np.random.default_rng(seed).exponential(1e-3, 3000)))


def test_the_error_of_resampling_is_stated() -> None:
    """The slope is 50 mm/s, the jitter 0.4 ms: positions on the even clock are off by at most 20 um."""
    time, true = jittering(0.4, [1200])
    log = result_of(record(Channel("x pos", 50.0 * true, "mm", time)), Columns())
    off = log.result["position"][:, 0] - 0.05 * (log.start + log.result.time)
    stated = next(one.values for one in log.findings if one.code == "CL437")
    assert np.sqrt(np.mean(off**2)) < stated["rms"] < 15e-6
    assert np.abs(off).max() < stated["largest"] < 41e-6


def test_a_given_period_counts_samples_whose_times_jitter() -> None:
    time, true = jittering(0.4, list(range(3000, 3040)))
    noise = np.random.default_rng(2).standard_normal(true.size)
    log = result_of(record(Channel("x pos", noise, "mm", time)), Columns(period=1e-3))
    assert "CL437" not in codes(log) and {"CL426", "CL427"} <= codes(log)
    there = np.setdiff1d(np.arange(5000), np.arange(3000, 3040))
    assert log.result["position"][there, 0] == pytest.approx(1e-3 * noise, abs=1e-9)


def test_columns_that_are_not_needed_may_lack_a_unit() -> None:
    names = ("X1_ActualPosition", "X1_ActualVelocity", "X1_CommandPosition", "Z1_ActualPosition")
    channels = [Channel(name, np.arange(4.0)) for name in names]
    spoilt = Channel("Y1_ActualVelocity", np.full(4, np.nan), "mm/s", fault=LogError("words", file=FILE))
    log = result_of(record(*channels, spoilt, period=0.1), Columns(parse_columns(["position.x=X1_ActualPosition [mm]"])))
    assert log.result.axes == ("x",) and set(log.result.signals) == {"position", "reference"}
    assert finding("CL436", columns=["X1_ActualVelocity", "Z1_ActualPosition", "Y1_ActualVelocity"]) in log.findings
    with pytest.raises(LogError, match=r"'position\.x=X1_ActualPosition \[mm\]' .*'position\.z=Z1_ActualPosition \[mm\]'"):
        result_of(record(*channels, spoilt, period=0.1), Columns())
    needed = ["position.x=X1_ActualPosition [mm]", "velocity.x=X1_ActualVelocity"]
    with pytest.raises(LogError, match=r"'velocity\.x=X1_ActualVelocity \[mm/s\]'"):
        result_of(record(*channels, spoilt, period=0.1), Columns(parse_columns(needed)))


def test_columns_that_are_not_used_are_named() -> None:
    """A rotary axis is no fault of a log; nor is a temperature."""
    time = np.arange(4.0)
    heads = ("time [s]", "x_pos [mm]", "b_ref [deg]", "b_vel [rad/s]", "temperature [degC]", "line", "load")
    log = load_log(dict.fromkeys(heads, time))
    assert log.result.axes == ("x",) and set(log.result.signals) == {"position"}
    assert finding("CL441", columns=["temperature", "load"]) in log.findings
    assert finding("CL442", columns=["b_ref", "b_vel"]) in log.findings
    with pytest.raises(LogError):
        load_log({"time [s]": time, "b_pos [deg]": time})
    many = load_log(dict.fromkeys(("time [s]", "x_pos [mm]", *(f"channel {i} value {i}" for i in range(40))), time))
    (named,) = (one.values["columns"] for one in many.findings if one.code == "CL441")
    assert len(named) == 31 and named[-1] == "10 more"


def test_all_missing_columns_are_named() -> None:
    with pytest.raises(LogError, match=r"'b', 'c'.*'a'"):
        columns = parse_columns(["position.x=a [mm]", "position.y=b [mm]", "reference.x=c [mm]"])
        result_of(record(Channel("a", np.arange(4.0)), period=0.1), Columns(columns))


def test_channels_of_different_rates_meet_on_the_fastest_clock() -> None:
    """A line equals its interpolation; where either channel has no samples there is no result."""
    fast, slow = np.arange(2, 40) * 1e-3, np.arange(0, 8) * 5e-3
    channels = Channel("a", fast * 3.0, "m", fast), Channel("b", slow * 2.0, "m", slow)
    log = result_of(record(*channels), Columns(parse_columns(["position.x=a", "position.y=b"])))
    time = 2e-3 + log.result.time
    assert log.result.n_sample == 34
    assert log.result["position"] == pytest.approx(np.column_stack([time * 3.0, time * 2.0]))
    assert "CL429" in codes(log)


def test_uniform_samples_are_not_changed() -> None:
    """No interpolation: noise is kept to the last bit."""
    noise = 1e-4 * np.random.default_rng(1).standard_normal(500)
    time = np.round(np.arange(500) * 1e-4, 9) + 3.0
    log = result_of(
        record(Channel("a", noise, "m", time), Channel("b", noise[5:], "m", time[5:])),
        Columns(parse_columns(["position.x=a", "position.y=b"])),
    )
    assert np.array_equal(log.result["position"][:, 0], noise[5:]) and np.array_equal(log.result["position"][:, 1], noise[5:])


@pytest.mark.parametrize(
    ("values", "unit"),
    [
        (20.0 * np.sin(np.arange(2000) * 5e-3), "m"),  # millimetres read as metres
        (np.where(np.arange(2000) > 900, -32.768, 32.767), "mm"),  # a 16-bit counter that wraps
        (np.append(np.linspace(0.0, 300.0, 1000), np.linspace(0.0, 300.0, 1000)), "mm"),  # two records end to end
        (np.append(np.zeros(1999), 1e3), "mm"),
    ],
)
def test_a_position_that_jumps_is_refused(values: np.ndarray, unit: str) -> None:
    columns = Columns(parse_columns(["position.x=a"]), 1e-3)
    with pytest.raises(LogError, match="m/s, faster"):
        result_of(record(Channel("a", values, unit)), columns)
    assert result_of(record(Channel("a", values / 40.0, "mm")), columns).result.n_sample == 2000
    steps = Columns(parse_columns(["reference.x=a", "position.x=b"]), 1e-3)  # a reference may step
    result_of(record(Channel("a", np.append(np.zeros(10), np.ones(10)), "m"), Channel("b", np.zeros(20), "m")), steps)


def test_a_time_without_a_unit_is_reported(tmp_path: Path) -> None:
    rows = np.column_stack([np.arange(5.0), np.arange(5.0)])
    assert "CL433" in codes(load_log(table(tmp_path, "t,x pos [mm]", rows)))
    assert "CL433" not in codes(load_log(table(tmp_path, "t [ms],x pos [mm]", rows)))


def test_a_period_that_contradicts_the_times(tmp_path: Path) -> None:
    file = table(tmp_path, "t [ms],x pos [mm]", np.column_stack([np.arange(50.0), np.arange(50.0)]))
    for period in (2e-3, 0.5e-3):
        with pytest.raises(LogError, match=r"1000 us|500 us"):
            load_log(file, period=period)


def test_the_channels_that_have_a_gap_at_a_time() -> None:
    there = np.ones(100, dtype=bool)
    there[40:43] = False
    time = 7.0 + np.arange(100) * 1e-3
    values = np.where(there, np.arange(100) * 1e-3, np.nan)
    log = result_of(record(Channel("x pos", values, "mm", time), Channel("y pos", time, "mm", time)), Columns())
    assert log.start == 7.0
    assert [log.gaps_at(at) for at in (0.039, 0.0405, 0.042, 0.043)] == [[], ["x pos"], ["x pos"], []]


def test_with_a_unit_bare_letters_are_positions(tmp_path: Path) -> None:
    """``x`` beside ``x_ref`` is plain; beside another position it is not asked for, and two of a letter are ambiguous."""
    file = tmp_path / "log.csv"
    rows = "".join(f"{k}e-3,{k}e-2,{2 * k}e-2,{3 * k}e-2,{4 * k}e-2\n" for k in range(9))
    for head, names in {
        "time,x,y,x_ref,y_ref": ["x", "y"],
        "time,x,y,x_pos,y_ref": ["x_pos", "y"],
        "time,x,X,y,y_ref": ["y"],
    }.items():
        file.write_text(f"{head}\n{rows}")
        log = load_log(file, unit="cm")
        assert [column.column for column in log.columns if column.signal == "position"] == names
        assert ("CL431" in [one.code for one in log.findings]) == ("X" in head)
        assert log.result["position"][1, -1] == pytest.approx({"y": 1e-2, "x": 1e-2}[names[-1]] * (3e-2 if "X" in head else 2e-2))
    file.write_text(f"time,x,y,q,p\n{rows}")
    with pytest.raises(LogError, match="--unit mm"):
        load_log(file)
