"""Readers of logs: each format as its program writes it, and its detection."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
import pytest
from refusals import refuses
from scipy.io import savemat

from contourlab.errors import LogError, ParameterError
from contourlab.findings import finding
from contourlab.logs import load_log, parse_columns, read_record
from contourlab.logs.formats import FORMATS, format_of
from contourlab.result import Result, Signal

HALSAMPLER = "10 0.000000 1.500000 1 \n11 0.001000 1.501000 0 \noverrun\n14 0.004000 1.504000 1 \n"
HALSCOPE = "# Sampling period is 1000000 ns\njoint.0.pos-cmd;joint.0.pos-fb\n# Position: 0.5;0.5\n# Scale: -3;-3\n+0.1;+0.09\n+0.2;+0.19\n"
OLD_HALSCOPE = "Sampling period is 50000 nSec \n\nCHAN1 +1.25000000000000 b.out -2.00000000000000 \nCHAN1 +1.5 b.out -2.5 \n"
SINUMERIK = """<?xml version="1.0" encoding="UTF-8"?>
<traceDataRoot><traceData><dataFrame>
  <frameHeader startTime="0" stopInc="3"/>
  <dataSignal id="a" name="/Nck/!SD/nckServoDataActPos1stEnc64[u1,1]" description="X actual" units="mm" interval="0.002"/>
  <dataSignal name="/Nck/set" description="X setpoint"/>
  <rec time="0" a="1.5" f2="1.6"/>
  <rec time="0.002" a="1.7"/>
  <rec time="0.004" a="9218868437227405312" f2="2.0"/>
</dataFrame></traceData></traceDataRoot>
"""


def twincat(mark: str = "\t", comma: bool = False, timelines: str = "each", stamp: float = 0.0) -> str:
    """Return an export of two channels every millisecond and one every 5 ms, in the layout of the scope."""
    fast, slow = ["pos", "cmd"], ["load"]
    groups = {"each": [fast, slow], "all": [["pos"], ["cmd"], slow], "none": [fast, slow]}[timelines]
    heads = {
        "Name": {"pos": "pos", "cmd": "cmd", "load": "load"},
        "SymbolName": {"pos": "Axes.Axis 1.ToPlc.ActPos", "cmd": "MAIN.cmd", "load": "MAIN.load"},
        "SampleTime[ms]": {"pos": "1", "cmd": "1", "load": "5"},
        "ScaleFactor": {"pos": "1", "cmd": "-10", "load": "1"},
        "Unit": {"pos": "mm (Length)", "cmd": "(None)", "load": "(None)"},
        "Unit Offset": {"pos": "0", "cmd": "0", "load": "0"},
    }
    lines = [
        mark.join(["Name", "scope"]),
        mark.join(["File", "scope.csv"]),
        mark.join(["Starttime of export", "1"]),
        mark.join(["End", "2"]),
    ]
    lines += ["", ""]
    lines += [mark.join(cell for group in groups for cell in (key, *(table[name] for name in group))) for key, table in heads.items()]
    lines.append("")
    for k in range(10):
        cells = []
        for group in groups:
            every = 5 if group == slow else 1
            there = k % every == 0 if timelines == "none" else k < 10 // every
            time = stamp + 1e4 * k * every if stamp else float(k * every)
            cells += [] if timelines == "none" else [f"{time:g}" if not stamp and there else f"{time:.0f}" if there else " "]
            cells += [f"{(k * every if timelines != 'none' else k) + 0.5}" if there else " " for _ in group]
        lines.append(mark.join(cell.replace(".", ",") if comma else cell for cell in cells))
    return "\n".join([*lines, "EOF", ""])


def written(folder: Path, name: str, text: str, encoding: str = "utf-8") -> Path:
    file = folder / name
    file.write_bytes(text.encode(encoding))
    return file


@pytest.mark.parametrize(
    ("name", "text", "kind"),
    [
        ("a.txt", HALSAMPLER, "halsampler"),
        ("a.csv", HALSCOPE, "halscope"),
        ("a.log", OLD_HALSCOPE, "halscope"),
        ("a.xml", SINUMERIK, "sinumerik"),
        ("a.csv", twincat(), "twincat"),
        ("a.csv", "t,x\n0,1\n", "csv"),
        ("a.txt", "0 1\n0.1 2\n", "csv"),
        ("a.txt", "% made by hand\n 1 2 3 \n", "csv"),
    ],
)
def test_a_format_is_detected_from_its_content(tmp_path: Path, name: str, text: str, kind: str) -> None:
    assert format_of(written(tmp_path, name, text)).name == kind


def test_halsampler(tmp_path: Path) -> None:
    record = read_record(written(tmp_path, "a.txt", HALSAMPLER))
    assert record.names == ["sample", "1", "2", "3"]
    assert record.channel("sample").values.tolist() == [10.0, 11.0, 14.0]
    assert record.channel("2").values.tolist() == [1.5, 1.501, 1.504]
    assert record.findings == (finding("CL422", overruns=1),)
    with refuses(LogError, "lost", file=tmp_path / "a.txt", line=2):
        read_record(written(tmp_path, "a.txt", "0.1 0.2 \noverrun\n0.4 0.1 \n"))


def test_halscope_in_both_forms(tmp_path: Path) -> None:
    record = read_record(written(tmp_path, "a.csv", HALSCOPE))
    assert record.period == 1e-3
    assert record.channel("joint.0.pos-fb").values.tolist() == [0.09, 0.19]
    old = read_record(written(tmp_path, "a.log", OLD_HALSCOPE))
    assert old.period == pytest.approx(50e-6)
    assert [c.values.tolist() for c in old.channels] == [[1.25, 1.5], [-2.0, -2.5]]
    assert old.names == ["CHAN1", "b.out"]
    with refuses(LogError, r"CHAN1, b\.out", file=tmp_path / "a.log", line=5):
        read_record(written(tmp_path, "a.log", OLD_HALSCOPE + "CHAN1 +1.0 c.out -2.0\n"))
    for text in (HALSCOPE, OLD_HALSCOPE):
        comma = read_record(written(tmp_path, "a.csv", text.replace(".1", ",1").replace(".2", ",2").replace("1.5", "1,5")))
        assert [c.values.tolist() for c in comma.channels] == [c.values.tolist() for c in (record if text is HALSCOPE else old).channels]
    with pytest.raises(LogError, match="0 ns"):
        read_record(written(tmp_path, "a.csv", HALSCOPE.replace("1000000", "0")))


@pytest.mark.parametrize("mark", ["\t", ";", ":", ","])
@pytest.mark.parametrize("timelines", ["each", "all", "none"])
def test_twincat(tmp_path: Path, mark: str, timelines: str) -> None:
    record = read_record(written(tmp_path, "a.csv", twincat(mark, mark in "\t;" and timelines != "none", timelines), "utf-8-sig"))
    assert record.names == ["pos", "cmd", "load"]
    assert record.channel("pos").unit == "mm" and record.channel("pos").symbol == "Axes.Axis 1.ToPlc.ActPos"
    for name, every in (("pos", 1), ("cmd", 1), ("load", 5)):
        channel = record.channel(name)
        count = 10 // every
        assert channel.time is not None
        assert channel.time == pytest.approx(np.arange(count) * every * 1e-3)
        assert channel.values == pytest.approx(np.arange(count) * every + 0.5)
    assert record.findings == (finding("CL420", channels=["cmd"]),)


def test_twincat_with_full_time_stamps(tmp_path: Path) -> None:
    """File times count 100 ns since 1601: only their differences matter."""
    time = read_record(written(tmp_path, "a.csv", twincat(stamp=132959733843760000.0))).channel("load").time
    assert time is not None
    assert time == pytest.approx([0.0, 5e-3], abs=2e-6)


def test_sinumerik(tmp_path: Path) -> None:
    record = read_record(written(tmp_path, "a.xml", SINUMERIK))
    actual, setpoint = record.channel("X actual"), record.channel("X setpoint")
    assert actual.unit == "mm"
    assert actual.time is not None and setpoint.time is not None
    assert actual.time.tolist() == [0.0, 0.002] and actual.values.tolist() == [1.5, 1.7]  # the bits of the third are a NaN
    assert setpoint.time.tolist() == [0.0, 0.004] and setpoint.values.tolist() == [1.6, 2.0]
    with refuses(LogError, "XML", line=9):
        read_record(written(tmp_path, "a.xml", SINUMERIK[:-30]))
    with refuses(LogError, "f2 = 'high'", line=6):
        read_record(written(tmp_path, "a.xml", SINUMERIK.replace('f2="1.6"', 'f2="high"')))
    with refuses(LogError, "time", line=7):
        read_record(written(tmp_path, "a.xml", SINUMERIK.replace('time="0.002"', 'at="0.002"')))
    with refuses(LogError, "dataFrame", line=9):
        read_record(written(tmp_path, "a.xml", SINUMERIK.replace("</dataFrame>", "</dataFrame><dataFrame/>")))


TRACE = """<?xml version="1.0" encoding="utf-8" ?>
<traceSession version="01.00">
<traceCaptureSetup><signalSettings><signal key="s1" description="captured"/></signalSettings></traceCaptureSetup>
<traceDisplaySetup><signals>
  <signal key="s3" name="/Nck/!SD/set [u1, 2]" description="Setpoint (64 bit)" unitsType="posn"/>
  <signal key="s1" name="/Nck/!SD/set [u1, 1]" description="Setpoint (64 bit)" unitsType="mm"/>
  <signal key="s7" name="DB21.DBX0.1" description="started"/>
</signals></traceDisplaySetup>
<traceData dataFrames="1"><dataFrame>
  <frameHeader dropOuts="0" startTime="2024-05-31T14:03:21.250Z"/>
  <dataSignal key="s1" id="f1" interval="0.002000" datapointCount="6"/>
  <dataSignal key="s7" id="f2" interval="0.002000" datapointCount="6" unitsType="none"/>
  <dataSignal key="s3" id="f5" interval="0.004000" datapointCount="3" unitsType="posn"/>
  <dataSignal key="s9" id="f6" interval="0.002000" description="Current" unitsType="current"/>
  <dataSignal key="s8" id="f7" description="never written"/>
  <rec time="0.000000" f1="1.0" f2="false" f5="7" f6="0.5"/>
  <rec time="0.002000" f1="2.0"/>
  <rec time="0.004000" f5="7"/>
  <rec time="0.008000" f1="3.0" f2="true" f5="8"/>
</dataFrame></traceData></traceSession>
"""


def test_a_trace_stores_changes_only(tmp_path: Path) -> None:
    """Names are in the display, by key; a missing value repeats that of the previous sample; bits are words."""
    record = read_record(written(tmp_path, "a.xml", TRACE))
    assert record.names == ["Setpoint (64 bit) AX1", "started", "Setpoint (64 bit) AX2", "Current"]
    assert [channel.unit for channel in record.channels] == ["mm", "", "", "A"]
    assert record.findings == (finding("CL424", signals=["never written"]),)
    fast, bit, slow, current = record.channels
    for channel, values in (
        (fast, [1.0, 2.0, 2.0, 2.0, 3.0, 3.0]),
        (bit, [0.0, 0.0, 0.0, 0.0, 1.0, 1.0]),
        (slow, [7.0, 7.0, 8.0]),
        (current, [0.5] * 5),
    ):
        assert channel.values.tolist() == values and channel.time is not None
        assert channel.time == pytest.approx((0.004 if channel is slow else 0.002) * np.arange(len(values)))
    columns = parse_columns(["position.x=Setpoint (64 bit) AX1", "position.y=Setpoint (64 bit) AX2 [mm]"])
    assert load_log(tmp_path / "a.xml", columns=columns).result["position"][:4, 0] == pytest.approx([1e-3, 2e-3, 2e-3, 2e-3])
    with pytest.raises(LogError, match=r"AX2.*unit"):
        load_log(tmp_path / "a.xml", columns=parse_columns(["position.y=Setpoint (64 bit) AX2"]))


@pytest.mark.parametrize(
    ("written_as", "read_as"),
    [
        ('interval="0.002000" datapointCount="6"', 'interval="0.003" datapointCount="6"'),  # not the actual times
        ('interval="0.002000" datapointCount="6"', 'interval="0.002" datapointCount="3"'),  # all available samples
        ('interval="0.002000" datapointCount="6"', 'interval="fast" datapointCount="6"'),
        ('interval="0.002000" datapointCount="6"', 'interval="0.002" datapointCount="1e12"'),
    ],
)
def test_a_trace_with_an_invalid_interval_keeps_its_written_samples(tmp_path: Path, written_as: str, read_as: str) -> None:
    channel = read_record(written(tmp_path, "a.xml", TRACE.replace(written_as, read_as))).channels[0]
    assert channel.values.tolist() == [1.0, 2.0, 3.0]


def test_lost_samples_of_a_trace_are_reported(tmp_path: Path) -> None:
    record = read_record(written(tmp_path, "a.xml", TRACE.replace('dropOuts="0"', 'dropOuts="3"')))
    assert finding("CL423", drop_outs=3) in record.findings


@pytest.mark.parametrize(
    "text",
    [
        "t [s],x pos [mm]\n0,1.5\n0.001,2.5\n",
        "# from the bench\nt [s];x pos [mm]\n0;1,5\n0,001;2,5\n",
        "t;x pos\n[s];[mm]\n0;1,5\n0,001;2,5\n",
        '"t [s]"\t"x pos [mm]"\t\n0\t1.5\t\n0.001\t2.5\t\n',
        "t [s]  x pos [mm]\n0 1.5\n1e-3 2.5\n".replace("x pos", "x_pos"),
        "\r\nt (s),x pos (mm)\r\n0,1.5\r\n0.001,2.5\r\n",
    ],
)
def test_tables_of_numbers(tmp_path: Path, text: str) -> None:
    record = read_record(written(tmp_path, "a.csv", text))
    first, second = record.channels
    assert (first.name, first.unit, second.name.replace("_", " "), second.unit) == ("t", "s", "x pos", "mm")
    assert first.values.tolist() == [0.0, 0.001]
    assert second.values.tolist() == [1.5, 2.5]


def test_bits_are_numbers(tmp_path: Path) -> None:
    lines = ["x;on;y", "0,5;TRUE;1", "0,6;False;2", "0,7;1;3", ""]
    for name, head in (("a.csv", "# made by hand"), ("b.csv", "# Sampling period is 1000000 ns")):
        record = read_record(written(tmp_path, name, "\n".join([head, *lines])))
        assert record.format == ("csv" if name == "a.csv" else "halscope")
        assert record.channel("on").values.tolist() == [1.0, 0.0, 1.0] and record.channel("x").values.tolist() == [0.5, 0.6, 0.7]
    fault = read_record(written(tmp_path, "b.csv", "\n".join([head, *lines]).replace("False", "ON"))).channel("on").fault
    assert fault is not None and fault.line == 4


def test_a_table_may_have_gaps_and_no_names(tmp_path: Path) -> None:
    record = read_record(written(tmp_path, "a.csv", "1,,3\n4,NaN,6\n7,8,9\n"))
    assert record.names == ["1", "2", "3"]
    assert np.isnan(record.channel("2").values[:2]).all() and record.channel("2").values[2] == 8.0


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("t,x\n0,1\n1,2,3\n", "a.csv:3: has 3 columns"),
        ("t,x\nname,of\n", "no rows"),
        ("time [s],x [mm]\n", "no rows"),
        ("words of no table\n", "--format"),
        ("a,b\nc,d\ne,f\n", "--format"),
        ("   \n", "is empty"),
    ],
)
def test_a_faulty_table_is_refused_with_its_line(tmp_path: Path, text: str, said: str) -> None:
    with pytest.raises(LogError, match=said):
        read_record(written(tmp_path, "a.csv", text))


def test_names_may_be_numbers(tmp_path: Path) -> None:
    assert read_record(written(tmp_path, "a.csv", "time,1,2\n0,1,2\n1,2,3\n")).names == ["time", "1", "2"]


MILL = """X1_ActualPosition,X1_ActualVelocity,Y1_ActualPosition,Machining_Process
198,0,158,Starting
198.5,10.8,157.5,Prep
199,,157,"Layer 1 Up"
199.5,10.9,156.5,end
"""


@pytest.mark.parametrize(
    ("text", "words", "rows"),
    [
        (MILL, {"Machining_Process": 2}, 4),
        (MILL.replace("10.8", "fast"), {"X1_ActualVelocity": 3, "Machining_Process": 2}, 4),
        ("t,x,state\n0,1,Idle\n1,2,Idle\n2,3,\n3,4,\n", {"state": 2}, 4),  # two rows of numbers below rows with words
        ("rate,1000\nname,a,b\nchannels,2\nt,x,state\n0,1,Idle\n1,2,Run\n2,3,Run\n3,4,Run\n", {"state": 5}, 4),
        ("t,x\n0,1\n1,two\n", {"x": 3}, 2),
        ("t,x\n0,1\n1,two\n2,3\n3,4\n", {"x": 3}, 4),
        ("t,x\n0,one\n1,2\n2,3\n", {"x": 2}, 3),
        ("t;at\n0;3rd of May\n1;4th of May\n", {"at": 2}, 2),
        ("stamp;x;state\n2024-05-31T14:03:21;0,5;Run\n2024-05-31T14:03:22;0,7;Run\n", {"state": 2}, 2),
    ],
)
def test_a_column_with_words_counts_only_if_it_is_needed(tmp_path: Path, text: str, words: dict[str, int], rows: int) -> None:
    record = read_record(written(tmp_path, "a.csv", text))
    assert {c.name: c.fault.line for c in record.channels if c.fault is not None} == words
    assert {c.values.size for c in record.channels} == {rows}
    assert all(np.isfinite(c.values[0]) for c in record.channels if c.fault is None)  # the first row is there
    name, line = next(iter(words.items()))
    with refuses(LogError, name, file=tmp_path / "a.csv", line=line):
        load_log(tmp_path / "a.csv", columns=parse_columns([f"position.x={name} [mm]"]), period=1.0)


@pytest.mark.parametrize("encoding", ["utf-16", "utf-8-sig"])
@pytest.mark.parametrize(
    ("name", "text", "kind"),
    [("a.csv", "t [s]\tx [mm]\r\n0\t1,5\r\n1\t2\r\n", "csv"), ("a.csv", twincat(), "twincat"), ("a.xml", SINUMERIK, "sinumerik")],
)
def test_text_in_the_encodings_of_windows(tmp_path: Path, encoding: str, name: str, text: str, kind: str) -> None:
    file = written(tmp_path, name, text.replace('"UTF-8"', f'"{encoding[:6].upper()}"'.replace("UTF-8-", "UTF-8")), encoding)
    assert format_of(file).name == kind
    assert read_record(file).channels[0].values.size > 1


def test_a_late_decimal_comma(tmp_path: Path) -> None:
    """A drive at rest writes 0 hundreds of times."""
    record = read_record(written(tmp_path, "a.csv", "t [s];x [mm]\n" + "0;0\n" * 500 + "0,5;1,25\n"))
    assert record.channel("x").values[-1] == 1.25
    mixed = read_record(written(tmp_path, "a.csv", "t [s];x [mm]\n0.5;7\n0,5;1.234,5\n"))
    assert mixed.channel("x").values.tolist() == [7.0, 1234.5] and mixed.channel("t").values.tolist() == [0.5, 0.5]
    fault = read_record(written(tmp_path, "a.csv", "t [s];x [mm]\n0;1\n1;1,234.5\n")).channel("x").fault
    assert fault is not None and fault.line == 3


@pytest.mark.parametrize(
    ("text", "last"),
    [
        ("t,x,y\n0,1,2\n1,1,\n2,2,4\n", [2.0, np.nan, 4.0]),
        ("t,x,y,\n0,1,2,\n1,1,,\n2,2,4,\n", [2.0, np.nan, 4.0]),
        ("t,x,y\n0,1,\n1,1,\n", [np.nan, np.nan]),
        ("0;1;\n1;1;3\n", [np.nan, 3.0]),
        ("Rate, 1000, Hz\n5, 6\nt;x;y\n0;1;2,5\n1;2;3\n", [2.5, 3.0]),
    ],
)
def test_a_gap_in_the_last_column(tmp_path: Path, text: str, last: list[float]) -> None:
    """A separator at the end of a line opens an empty cell, unless all lines, the header included, end in one."""
    assert read_record(written(tmp_path, "a.csv", text)).channels[2].values == pytest.approx(last, nan_ok=True)


@pytest.mark.parametrize(
    ("name", "text", "last"),
    [
        ("a.txt", HALSAMPLER[:-4], 1.501),
        ("a.csv", HALSCOPE[:-3], 0.09),
        ("a.csv", twincat(timelines="none").removesuffix("EOF\n")[:-5], 8.5),
        ("a.csv", "t,x\n0,1\n1,2\n2", 2.0),
    ],
)
def test_a_truncated_file(tmp_path: Path, name: str, text: str, last: float) -> None:
    record = read_record(written(tmp_path, name, text))
    values = record.channel({"a.txt": "2"}.get(name, record.names[min(1, len(record.names) - 1)])).values
    assert values[np.isfinite(values)][-1] == last
    assert "CL419" in {one.code for one in record.findings}


def test_two_records_in_one_file(tmp_path: Path) -> None:
    tagged = "".join(f"{k} {k * 0.1:f} \n" for k in range(40))
    with refuses(LogError, "39 to 0", file=tmp_path / "a.txt", line=41):
        read_record(written(tmp_path, "a.txt", tagged * 2))
    counts = "".join(f"{k} {k * 0.1:f} \n" for k in [*range(40), *range(40, 0, -1)])
    assert read_record(written(tmp_path, "a.txt", counts)).names == ["1", "2"]
    grows = "".join(f"{k:f} {k * 0.1:f} \n" for k in range(40))
    assert read_record(written(tmp_path, "a.txt", grows)).names == ["1", "2"]  # a float that grows is a pin
    with refuses(LogError, "head", file=tmp_path / "a.csv", line=4):
        read_record(written(tmp_path, "a.csv", "t,x\n0,1\n1,2\n" * 2))


@pytest.mark.slow
def test_columns_of_the_same_name_are_numbered(tmp_path: Path) -> None:
    record = read_record(written(tmp_path, "a.csv", "pos [mm],t,pos [mm]\n0,1,2\n3,4,5\n"))
    assert record.names == ["pos #1", "t", "pos #2"]
    assert record.channel("pos #2").values.tolist() == [2.0, 5.0]
    arrow = pytest.importorskip("pyarrow")
    from pyarrow import parquet

    parquet.write_table(arrow.Table.from_arrays([arrow.array([1.0, 2.0])] * 2, names=["x [mm]", "x [mm]"]), tmp_path / "a.parquet")
    assert read_record(tmp_path / "a.parquet").names == ["x #1", "x #2"]


@pytest.mark.parametrize("kind", ["csv", "twincat", "halsampler", "halscope", "sinumerik"])
def test_a_file_that_is_not_a_log_is_refused_in_words(tmp_path: Path, kind: str) -> None:
    """Separators without content, a quote that never ends in a line of 300 kB, an unknown encoding."""
    foreign = b'<?xml version="1.0" encoding="foo-8"?><trace><rec/></trace>'
    for content in (b"\xef\xbb\xbf", b"\xff\xfe", b'Name "' + b"a" * 300_000 + b"\n1\n", foreign):
        file = tmp_path / "a.txt"
        file.write_bytes(content)
        try:
            read_record(file, kind)
        except LogError as error:
            assert len(str(error)) < 1000
        else:
            assert kind == "csv"


@pytest.mark.skipif(not Path("/dev/null").exists(), reason="no such device")
def test_a_device_is_not_a_file() -> None:
    with refuses(LogError, "regular file", file="/dev/null"):
        read_record(Path("/dev/null"))


@pytest.mark.slow
@pytest.mark.parametrize(
    "run",
    [
        {"X": {"Data": "text"}, "Y": {"Name": "a", "Data": np.arange(3.0)}},
        {"X": {"Data": np.arange(3.0)}, "Y": {"Name": "a"}},
        {"X": {"Data": np.arange(3.0)}, "Y": np.array([np.arange(3), np.arange(4)], dtype=object)},
        {"X": {"Data": np.arange(3.0)}, "Y": {"Name": "a", "Data": np.arange(3.0)}, "Capture": {"SamplingPeriod": "n"}},
    ],
)
def test_an_invalid_capture(tmp_path: Path, run: dict[str, object]) -> None:
    savemat(tmp_path / "a.mat", {"run": run})
    with pytest.raises(LogError, match="capture"):
        read_record(tmp_path / "a.mat")


def test_broken_links_and_references_of_version_7_3(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "a.mat", "w") as stored:
        stored["x"] = np.arange(3.0)[None, :]
        stored.create_dataset("cell", (2, 1), dtype=h5py.ref_dtype)
        stored["gone"] = h5py.SoftLink("/nowhere")
    assert read_record(tmp_path / "a.mat").names == ["x"]


def test_matlab_flat_and_in_structures(tmp_path: Path) -> None:
    t = np.arange(5.0)
    savemat(tmp_path / "a.mat", {"t": t[:, None], "gain": 35.0, "out": {"x [mm]": t * 2.0}, "both": np.column_stack([t, -t]), "who": "me"})
    record = read_record(tmp_path / "a.mat")
    assert sorted(record.names) == ["both.1", "both.2", "out.x", "t"]
    assert record.channel("out.x").unit == "mm"
    assert record.constants == {"gain": 35.0}
    assert record.channel("both.2").values.tolist() == (-t).tolist()


def test_matlab_of_version_7_3(tmp_path: Path) -> None:
    """Stored by columns, after MATLAB's own text; a structure is a group, an array of them a group of references."""
    file = tmp_path / "a.mat"
    t = np.arange(4.0)
    with h5py.File(file, "w", userblock_size=512) as stored:
        stored["t"] = t[None, :]
        stored["t"].attrs["MATLAB_class"] = np.bytes_("double")
        group = stored.create_group("out")
        group["x"] = 2.0 * t[None, :]
        text = group.create_dataset("name", data=np.array([[ord(c)] for c in "run"], dtype=np.uint16))
        text.attrs["MATLAB_class"] = np.bytes_("char")
    head = b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(128)
    with file.open("r+b") as stream:
        stream.write(head)
    record = read_record(file)
    assert sorted(record.names) == ["out.x", "t"]
    assert record.channel("out.x").values.tolist() == (2.0 * t).tolist()


def test_a_capture_names_its_channels(tmp_path: Path) -> None:
    t = np.arange(6.0) * 1e-4
    rows = np.array(
        [(f'"Model Root"/"Encoder {n}"/"{n} [mm]"', t * k) for k, n in enumerate("xy", 1)], dtype=[("Name", "O"), ("Data", "O")]
    )
    savemat(tmp_path / "a.mat", {"run": {"X": {"Data": t}, "Y": rows, "Capture": {"SamplingPeriod": 1e-4}}})
    record = read_record(tmp_path / "a.mat")
    assert record.names == ["Encoder x/x", "Encoder y/y"]
    assert record.period == 1e-4
    assert record.channels[1].unit == "mm" and record.channels[1].time is not None
    assert record.channels[1].values == pytest.approx(2.0 * t)


@pytest.mark.slow
def test_parquet(tmp_path: Path) -> None:
    arrow = pytest.importorskip("pyarrow")
    from pyarrow import parquet

    fields = [
        arrow.field("when", arrow.timestamp("ms")),
        arrow.field("x [mm]", arrow.float64()),
        arrow.field("n", arrow.int32(), metadata={b"unit": b"A"}),
        arrow.field("who", arrow.string()),
    ]
    table = arrow.table([[1000, 1001, 1002], [0.5, None, 1.5], [1, 2, 3], ["a", "b", "c"]], schema=arrow.schema(fields))
    parquet.write_table(table, tmp_path / "a.parquet")
    record = read_record(tmp_path / "a.parquet")
    assert record.names == ["when", "x", "n"]
    assert record.channel("when").values == pytest.approx([0.0, 1e-3, 2e-3]) and record.channel("when").unit == "s"
    assert np.isnan(record.channel("x").values[1]) and record.channel("x").unit == "mm"
    assert record.channel("n").unit == "A"
    assert record.findings == (finding("CL425", columns=["who"]),)
    (tmp_path / "a.parquet").write_bytes(b"PAR1 and nothing else")
    with pytest.raises(LogError, match="Parquet"):
        read_record(tmp_path / "a.parquet")


def test_a_result_of_contourlab(tmp_path: Path) -> None:
    data = np.arange(6.0).reshape(3, 2)
    result = Result(
        "base", ("x", "y"), 1e-3, {"position": Signal(data, ("sample", "axis"), "m"), "arc_length": Signal(data[:, 0], ("sample",), "m")}
    )
    result.save(tmp_path / "a.nc")
    record = read_record(tmp_path / "a.nc")
    assert record.names == ["position.x", "position.y", "arc_length"]
    assert record.channel("position.y").values.tolist() == data[:, 1].tolist()


@pytest.mark.parametrize("kind", [name for name in FORMATS if name != "contourlab"])
@pytest.mark.slow
def test_every_reader_refuses_random_bytes(tmp_path: Path, kind: str) -> None:
    file = tmp_path / "a.bin"
    for content in (b"\x00\x01\x02\x03" * 200, b"hello\nworld\n", b"MATLAB 5.0 MAT-file" + b"\xff" * 200, b"<trace><rec/>"):
        file.write_bytes(content)
        with pytest.raises(LogError):
            read_record(file, kind)


def test_an_unknown_format(tmp_path: Path) -> None:
    file = written(tmp_path, "a.csv", "t,x\n0,1\n")
    with refuses(ParameterError, "contourlab, matlab", name="format", value="'excel'"):
        read_record(file, "excel")
    with refuses(LogError, "folder", file=tmp_path):
        read_record(tmp_path)
    with refuses(LogError, "No such file", file=tmp_path / "none.csv"):
        read_record(tmp_path / "none.csv")


@pytest.mark.parametrize("mark", [";", ",", "\t"])
@pytest.mark.parametrize(
    ("heads", "names", "units"),
    [
        (["t;x;y", "s;mm;mm"], ["t", "x", "y"], ["s", "mm", "mm"]),
        (["t;x;u", "s;um;"], ["t", "x", "u"], ["s", "um", ""]),
        (["t;x;u", "ms;m;-"], ["t", "x", "u"], ["ms", "m", ""]),
        (["a scope;of;2024", "t;x;u", "s;mm;V"], ["t", "x", "u"], ["s", "mm", "V"]),
        (["t;x;u", "s;furlongs_;V"], ["s", "furlongs_", "V"], ["", "", ""]),
        (["bench;run;1", "t;x;y"], ["t", "x", "y"], ["", "", ""]),
        (["s;mm;V"], ["s", "mm", "V"], ["", "", ""]),
    ],
)
def test_a_line_of_bare_units_below_the_names(tmp_path: Path, mark: str, heads: list[str], names: list[str], units: list[str]) -> None:
    """They are units if every non-empty cell is a known unit; otherwise the line contains names."""
    file = tmp_path / "log.csv"
    file.write_text("\n".join([*heads, "0;0;1", "1;2;3", "2;4;5"]).replace(";", mark) + "\n")
    record = read_record(file)
    assert [channel.name for channel in record.channels] == names
    assert [channel.unit for channel in record.channels] == units
    assert record.channels[1].values.tolist() == [0.0, 2.0, 4.0]


def test_a_sample_time_of_the_scope_that_is_no_number(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text(twincat().replace("SampleTime[ms]\t1", "SampleTime[ms]\ts"))
    with pytest.raises(LogError, match=r"a\.csv: 's'"):
        read_record(tmp_path / "a.csv")
