"""What editors, spreadsheets and full disks do to text logs: the numbers stay, or one line says what is wrong."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from test_formats import SINUMERIK, twincat

from contourlab.errors import LogError
from contourlab.logs import Record, read_record

N = 40
ROWS = [(k, 0.125 * k, 0.5 * k - 3.0) for k in range(N)]
CSV = "t [s],x [mm],y [mm]\n" + "".join(f"{1e-3 * k:.3f},{x:.4f},{y:.3f}\n" for k, x, y in ROWS)
SCOPE = "# Sampling period is 1000000 ns\njoint.0.pos-cmd;joint.0.pos-fb\n# Scale: -3;-3\n" + "".join(
    f"{x:+.4f};{y:+.4f}\n" for _, x, y in ROWS
)
GOOD = {
    "csv": CSV,
    "tabs": CSV.replace(",", "\t"),
    "blanks": CSV.replace(",", " "),
    "halsampler": "".join(f"{x:f} {y:f} {k % 2} \n" for k, x, y in ROWS),
    "halsampler -t": "".join(f"{k} {x:f} {y:f} \n" for k, x, y in ROWS),
    "halscope": SCOPE,
    "old halscope": "Sampling period is 50000 nSec \n\n" + "".join(f"CHAN1 {x:+.14f} b.out {y:+.14f} \n" for _, x, y in ROWS),
    "twincat": twincat(),
    "sinumerik": SINUMERIK,
}
MARKS = {"csv": ",", "tabs": "\t", "twincat": "\t"}


def decimal_commas(text: str) -> str:
    return re.sub(r"(?<=\d)\.(?=\d)", ",", text)


def semicolons(text: str, kind: str) -> str:
    return text.replace(MARKS[kind], ";") if kind in MARKS else text.replace(" \n", "\n").replace(" ", ";")


def spreadsheet(text: str, kind: str) -> str:
    return "\ufeff" + decimal_commas(semicolons(text, kind)).replace("\n", "\r\n")


HEADED = ("csv", "tabs", "blanks", "old halscope", "twincat")
TABLES = ("csv", "tabs", "twincat", "halsampler")
DAMAGES: dict[str, tuple[tuple[str, ...], Callable[[str, str], str]]] = {
    "a header behind #": (HEADED, lambda text, kind: f"# {text}"),
    "a header behind # without a blank": (HEADED, lambda text, kind: f"#{text}"),
    "blanks stripped at line ends": (tuple({**GOOD}.keys() - {"halsampler -t"}), lambda text, kind: re.sub(r"[ \t]+\n", "\n", text)),
    "decimal commas": (tuple(GOOD.keys() - {"csv", "halsampler -t", "sinumerik"}), lambda text, kind: decimal_commas(text)),
    "semicolons": (TABLES, semicolons),
    "saved by a spreadsheet": (TABLES, spreadsheet),
    "a byte order mark": (tuple(GOOD), lambda text, kind: f"\ufeff{text}"),
    "line ends of Windows": (tuple(GOOD), lambda text, kind: text.replace("\n", "\r\n")),
}


def read(folder: Path, text: str, kind: str) -> Record:
    file = folder / ("a.xml" if kind == "sinumerik" else "a.csv")
    file.write_bytes(text.encode())
    return read_record(file)


def numbers(record: Record) -> list[tuple[str, str, list[float]]]:
    assert all(channel.fault is None for channel in record.channels)
    return [(channel.name, channel.unit, np.nan_to_num(channel.values, nan=-99.0).tolist()) for channel in record.channels]


@pytest.mark.parametrize(("kind", "damage"), [(kind, damage) for damage, (kinds, _) in DAMAGES.items() for kind in sorted(kinds)])
def test_the_numbers_stay(tmp_path: Path, kind: str, damage: str) -> None:
    good = read(tmp_path, GOOD[kind], kind)
    damaged_text = DAMAGES[damage][1](GOOD[kind], kind)
    assert damaged_text != GOOD[kind] or damage.startswith(("blanks", "decimal"))
    damaged = read(tmp_path, damaged_text, kind)
    assert numbers(damaged) == numbers(good)
    assert (damaged.format, damaged.period, damaged.findings) == (good.format, good.period, good.findings)


@pytest.mark.parametrize("damage", ["blanks stripped at line ends", "decimal commas", "semicolons", "saved by a spreadsheet"])
def test_a_numbered_log_whose_columns_could_be_counted_two_ways(tmp_path: Path, damage: str) -> None:
    """With its blanks gone, a log of halsampler -t is a table whose first column may be anything: its columns count from another one."""
    text = DAMAGES[damage][1](GOOD["halsampler -t"], "halsampler")
    text = text if damage != "decimal commas" else text.replace(" \n", "\n")
    with pytest.raises(LogError, match="--format halsampler"):
        read(tmp_path, text, "halsampler -t")
    good = read(tmp_path, GOOD["halsampler -t"], "halsampler -t")
    (tmp_path / "a.csv").write_bytes(text.encode())
    assert numbers(read_record(tmp_path / "a.csv", "halsampler")) == numbers(good)
    assert read_record(tmp_path / "a.csv", "csv").names == ["1", "2", "3"]


@pytest.mark.parametrize(
    ("kind", "line"), [("csv", N + 2), ("tabs", N + 2), ("blanks", N + 2), ("halscope", N + 4), ("old halscope", N + 3)]
)
def test_two_records_one_after_the_other(tmp_path: Path, kind: str, line: int) -> None:
    with pytest.raises(LogError) as refusal:
        read(tmp_path, GOOD[kind] * 2, kind)
    assert refusal.value.line == line


@pytest.mark.parametrize("kind", sorted(MARKS.keys() - {"twincat"} | {"blanks"}))
def test_a_header_repeated_in_one_record(tmp_path: Path, kind: str) -> None:
    head, *rows = GOOD[kind].splitlines(keepends=True)
    good, record = read(tmp_path, GOOD[kind], kind), read(tmp_path, "".join([head, *rows[:9], head, *rows[9:20], head, *rows[20:]]), kind)
    assert numbers(record) == numbers(good)
    assert [(one.code, one.values) for one in record.findings] == [("CL440", {"line": 11, "times": 2})]


def test_times_of_day_that_begin_again_are_two_records(tmp_path: Path) -> None:
    text = "time,x [mm]\n" + "".join(f"12:00:0{k}.000,{k}.5\n" for k in range(9))
    with pytest.raises(LogError) as refusal:
        read(tmp_path, text * 2, "csv")
    assert refusal.value.line == 11


@pytest.mark.parametrize("kind", ["halsampler -t", "twincat", "sinumerik"])
def test_two_records_in_formats_with_an_end(tmp_path: Path, kind: str) -> None:
    with pytest.raises(LogError) as refusal:
        read(tmp_path, GOOD[kind] * 2, kind)
    assert refusal.value.line > GOOD[kind].count("\n") - 1


@pytest.mark.parametrize("lost", [2, 3, 5])
@pytest.mark.parametrize("kind", sorted(GOOD.keys() - {"sinumerik"}))
def test_a_last_line_cut_in_two(tmp_path: Path, kind: str, lost: int) -> None:
    """A number may have lost digits and still be one: the line is left out, however much of it is there."""
    text = GOOD[kind].removesuffix("EOF\n")
    whole, cut = read(tmp_path, text, kind), read(tmp_path, text[:-lost], kind)
    assert "CL419" in {one.code for one in cut.findings}
    for (name, unit, values), (cut_name, cut_unit, left) in zip(numbers(whole), numbers(cut), strict=True):
        assert (cut_name, cut_unit) == (name, unit)
        assert left == values[: len(left)] and len(values) - len(left) <= 1


@pytest.mark.parametrize(
    ("rows", "last"),
    [
        (["0,1.50,2.25"] * 30 + ["1,2.50,3.75"], 3.75),  # as many digits as all others
        (["0,1.50,2.25"] * 30 + ["1,2.50,3.7"], 2.25),
        (["0,1.50,2.25"] * 30 + ["1,2.50"], 2.25),
        (["0,1,152"] * 30 + ["1,2,15"], 152.0),
        (["0,1,152"] * 30 + ["1,2,152"], 152.0),
        (["0,1.5,2.5e-03"] * 30 + ["1,2,2.5e-0"], 2.5e-3),
        (["0,1.5,2.5e-03"] * 30 + ["1,2,2.5"], 2.5e-3),
        (["0;1,5;2,5"] * 30 + ["1;2,5;3"], 2.5),
        (["12:00:00;1,5;2,5"] * 30 + ["12:00:01;2,5;3,5"], 3.5),
        (["0,1.5,nan"] * 30 + ["1,2.5,nan"], float("nan")),
    ],
)
def test_a_last_line_without_a_line_break(tmp_path: Path, rows: list[str], last: float) -> None:
    record = read(tmp_path, "\n".join(rows), "csv")
    assert record.channels[2].values[-1] == pytest.approx(last, nan_ok=True)


def test_a_trace_cut_in_two(tmp_path: Path) -> None:
    with pytest.raises(LogError) as refusal:
        read(tmp_path, SINUMERIK[:-30], "sinumerik")
    assert refusal.value.line > 1
