"""What a paper needs: what made each file, figures at the width of a column, tables for LaTeX."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas
import pytest
from matplotlib.text import Text
from typed_commands import invoke

import contourlab as cl
from contourlab.app.cite import stamp_of
from contourlab.errors import ParameterError, ResultError
from contourlab.features.export.command import export
from contourlab.features.precompensate.writing import marked
from contourlab.rendering.judgement import Interval, Spread
from contourlab.rendering.table import Column, Table
from contourlab.result.stamp import identity, parse_stamp, read_stamp, stamp

SCENARIO = """
name = "circle"
machine = "machine.toml"
[controller]
file = "builtin:xyz-controller"
coupling = "none"
[contour]
name = "circle"
radius = "5 mm"
[feed]
feedrate = "2 m/min"
[run]
tolerance = "50 um"
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("paper")
    cl.save(cl.load_scenario("builtin:demo-part").machine, made / "machine.toml")
    (made / "circle.toml").write_text(SCENARIO, encoding="utf-8")
    return made


@pytest.fixture(scope="module")
def answer(folder: Path):
    return cl.run(folder / "circle.toml", interval=False)


def test_each_file_says_what_made_it_and_the_same_run_writes_the_same_bytes(folder: Path, answer) -> None:
    case = answer.scenario.base
    expected = {"machine": identity(case.machine), "controller": identity(case.controller), "program": identity(case.motion)}
    for name, plots in (("one", ("png",)), ("two", ())):
        answer.save(folder / name, plots=plots, pdf=True)
    files = [file for file in sorted((folder / "one").rglob("*.*")) if file.name[0] != "."]
    assert {file.suffix for file in files} >= {".nc", ".json", ".html", ".png", ".pdf"} and folder / "one" / "report.pdf" in files
    for file in files:
        found = read_stamp(file)
        assert {key: found[key] for key in expected} == expected, file
        assert (found["contourlab"], found["numpy"]) == (cl.__version__, np.__version__)
        again = folder / "two" / file.relative_to(folder / "one")
        if file.suffix != ".html" and again.exists():  # the page names its folder
            assert file.read_bytes() == again.read_bytes(), file
    loaded = cl.Result.load(folder / "one" / "signals" / "base.nc")
    assert loaded.stamp.split()[8:11] == [f"{key}={digest}" for key, digest in expected.items()]
    assert json.loads(answer.to_json())["made_by"] == answer.stamp() == json.loads((folder / "one" / "summary.json").read_text())["made_by"]
    assert cl.cite(folder / "one" / "summary.json") == cl.cite(answer) == cl.cite(loaded)


def test_what_machines_differ_in_is_in_their_digest_and_nothing_else(folder: Path) -> None:
    machine = cl.load_scenario(folder / "circle.toml").machine
    assert read_stamp(folder / "machine.toml")["machine"] == identity(machine) == identity(cl.load_scenario("builtin:demo-part").machine)
    axis = machine.axes[0]
    other = replace(machine, axes=(replace(axis, limits=replace(axis.limits, velocity=0.99 * axis.limits.velocity)), *machine.axes[1:]))
    assert identity(other) != identity(machine)
    skewed = replace(machine, squareness={("x", "y"): 2e-5})
    assert identity(skewed) != identity(replace(machine, squareness={("x", "y"): 3e-5}))
    assert identity(replace(machine, origins={}, correlations=())) == identity(machine)


def test_explain_says_what_made_a_file(folder: Path, answer) -> None:
    answer.save(folder / "results")
    told = invoke(folder, "explain", "results/report.html", "--json")
    assert told.code == 0 and json.loads(told.out)["machine"] == identity(answer.scenario.machine)
    cited = invoke(folder, "explain", "results/summary.json", "--cite")
    assert cited.code == 0 and "@misc{contourlab," in cited.out and "@article{Koren1980," in cited.out
    assert invoke(folder, "explain", "circle.toml").code == 2
    assert invoke(folder, "explain", "no-file.toml").code == 2
    assert invoke(folder, "explain", "CL104", "--cite").code == 2


@pytest.mark.parametrize("to", ["c99", "st", "fmu"])
def test_exported_code_says_what_made_it(tmp_path: Path, folder: Path, to: str) -> None:
    scenario = cl.load_scenario(folder / "circle.toml")
    made = export(scenario, to=to, axis="x").save(tmp_path / "code")
    code = [file for file in made.files if file.suffix in (".c", ".h", ".st", ".xml", ".fmu", ".json") and "bench" not in file.name]
    assert len(code) > 1
    for file in code:
        found = read_stamp(file)
        assert (found["machine"], found["controller"]) == (identity(scenario.machine), identity(scenario.controller)), file


def test_a_stamp_is_found_in_any_bytes_and_ends(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"\0\xff" + stamp(machine="ab12", cites="Koren1980").encode() + b"x1 y=2;")
    assert read_stamp(tmp_path / "a") | {} == {**read_stamp(tmp_path / "a"), "machine": "ab12", "cites": "Koren1980"}
    (tmp_path / "b").write_bytes(b"made by hand")
    for name in ("b", "nowhere"):
        with pytest.raises(ResultError):
            read_stamp(tmp_path / name)


@pytest.mark.parametrize(("width", "size"), [("column", 88.9), ("page", 181.0), (60, 60.0)])
def test_a_figure_for_print_has_its_width_and_letters_of_8_pt(answer, width, size: float) -> None:
    figure = answer.plot(key="error-time", width=width).figure
    assert 25.4 * figure.get_figwidth() == pytest.approx(size)
    figure.canvas.draw()
    assert {text.get_fontsize() for text in figure.findobj(Text) if text.get_text()} == {8.0}


def test_lines_stay_apart_in_grey_and_letters_are_embedded(tmp_path: Path, answer) -> None:
    chart = next(chart for chart in answer._charts() if chart.key == "error-time")
    curve, colours = chart.panels[0].curves[0], ("#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
    panel = replace(chart.panels[0], curves=[replace(curve, name=colour, colour=colour) for colour in colours])
    from contourlab.rendering.matplotlib_view import draw_chart

    place = draw_chart([replace(chart, panels=[panel])], width="column")
    dashes = {str(line._unscaled_dash_pattern) for line in place.lines if line.get_label() in colours}
    assert len(dashes) == len(colours)
    figure = answer.plot(key="error-time", width="column").figure
    figure.savefig(tmp_path / "a.pdf")
    figure.savefig(tmp_path / "a.svg")
    assert b"/FontFile2" in (tmp_path / "a.pdf").read_bytes() and b"/Type3" not in (tmp_path / "a.pdf").read_bytes()
    assert "<text" not in (tmp_path / "a.svg").read_text(encoding="utf-8")
    assert read_stamp(tmp_path / "a.pdf") == read_stamp(tmp_path / "a.svg")
    with pytest.raises(ParameterError):
        answer.plot(place, width="column")
    for wrong in ("broad", 0.0, 1e9):
        with pytest.raises(ParameterError):
            answer.plot(width=wrong)


def grammatical(text: str) -> list[list[str]]:
    """Check a tabular of booktabs: balanced braces and mathematics, no bare special letters, rows of one length; return the rows."""
    body = re.fullmatch(r"(?:% [^\n]*\n)*\\begin\{tabular\}\{([lr]+)\}\n(.*)\n\\end\{tabular\}", text, re.DOTALL)
    assert body is not None, text
    kinds, lines = body[1], body[2].split("\n")
    assert (lines[0], lines[2], lines[-1]) == ("\\toprule", "\\midrule", "\\bottomrule")
    rows = []
    for line in (lines[1], *lines[3:-1]):
        assert line.endswith(" \\\\")
        cells = re.split(r"(?<!\\)&", line[:-3])
        assert len(cells) == len(kinds)
        for cell in cells:
            assert len(re.findall(r"(?<!\\)\$", cell)) % 2 == 0 and cell.isascii(), cell
            words = re.sub(r"(?<!\\)\$[^$]*(?<!\\)\$|\\text\w+\{\}|\\[&%$#_{}]", "", cell)
            assert not set(words) & set("&%$#_{}~^\\<>"), cell
        rows.append([cell.strip() for cell in cells])
    return rows


def test_the_tables_of_an_answer_are_latex_in_um_with_intervals(answer) -> None:
    assert answer.to_latex().startswith(f"% {answer.stamp()}\n\n") and str(answer) == answer.text
    (outcome,) = answer.outcomes
    rows = {row[0]: row[1:] for row in grammatical(answer.to_latex().strip().replace("\n\n", "\n"))}
    largest = float(rows["contour error, largest [$\\mu$m]"][0])
    assert largest == pytest.approx(1e6 * outcome.metrics.contour_error.max, rel=5e-3)
    spread = Interval(64, Spread(2e-6, 1.5e-6, 3e-6), Spread(9e-6, 8.25e-6, 10.5e-6))
    known = replace(answer, outcomes=(replace(outcome, trust=replace(outcome.trust, interval=spread)),))
    rows = {row[0]: row[1:] for row in grammatical(known.to_latex().strip().replace("\n\n", "\n"))}
    assert rows["part error, largest, 5 to 95 \\% of the machines [$\\mu$m]"][0] == "8.25 to 10.5"
    assert rows["part error, rms, 5 to 95 \\% of the machines [$\\mu$m]"][0] == "1.5 to 3"


def test_every_special_letter_is_escaped() -> None:
    odd = "a_b & 50 % of {x} #1 $2 ~ ^ \\ m/s^2 -3.5 x-y um < > ± × 90° µ ·"
    ((head,), (cell,)) = grammatical(Table([Column("h")], rows=[(odd,)]).latex())
    assert head == "h"
    assert cell == (
        r"a\_b \& 50 \% of \{x\} \#1 \$2 \textasciitilde{} \textasciicircum{} \textbackslash{} m/s$^{2}$ $-$3.5 x-y $\mu$m $<$ $>$"
        r" $\pm$ $\times$ 90$^\circ$ $\mu$ $\cdot$"
    )


def test_a_printed_batch_shows_all_its_figures() -> None:
    case = cl.load_scenario("builtin:ghaffari/demo-stage").base
    circle = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, case.machine.servo_period)
    batch = cl.simulate_batch(case.machine, case.controller, circle, {"axes.1.plant.gain": [1.0, 1.1]})
    frame, text = batch.to_pandas(), repr(batch.to_pandas())
    assert "..." not in text and max(map(len, text.splitlines())) <= 82
    assert all(f"{name} [{unit}]" in text for name, unit in batch.units.items())
    assert f"{batch.figures['contour_error_max'][1]:.4g}" in text
    assert list(frame) == [*batch.variants, *batch.figures, "failed_at"]
    assert type(frame[["failed_at"]]) is pandas.DataFrame and type(pandas.DataFrame(frame)) is pandas.DataFrame
    import pickle

    assert pickle.loads(pickle.dumps(frame)).equals(frame)
    assert len(repr(pandas.concat([frame] * 500)).splitlines()) < 400


def test_switches_are_a_plain_table(tmp_path: Path) -> None:
    case = cl.load_scenario("builtin:ghaffari/demo-stage").base
    circle = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, case.machine.servo_period)
    cl.simulate_to_file(case.machine, case.controller, circle, tmp_path / "run.nc", switches=tmp_path / "switches.csv")
    assert read_stamp(tmp_path / "run.nc")["machine"] == identity(case.machine)
    assert pandas.read_csv(tmp_path / "switches.csv").columns[0] == "time_s"


def test_questions_about_a_part_program_name_it_and_its_machine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    lines = ("G21 G90 F600", "G1 X10", "G1 Y10", "M30")
    Path("part.ngc").write_text("\n".join(lines) + "\n")
    machine, program = identity(cl.load_scenario("builtin:demo-part").machine), identity(lines)
    found = parse_stamp(cl.limits("part.ngc", machine="xyz").stamp())
    assert (found["machine"], found["program"]) == (machine, program)
    Path("corrected.ngc").write_text(marked("%\nG1 X1\n", 1, "part", lines))
    assert read_stamp("corrected.ngc")["program"] == program
    assert max(map(len, Path("corrected.ngc").read_text().splitlines())) < 256  # as LinuxCNC reads
    case = cl.run("part.ngc", machine="xyz", controller="xyz-controller", interval=False).scenario.base
    assert parse_stamp(stamp_of(case))["program"] == program
    assert {"PhamPham2018", "Koren1980"} <= set(parse_stamp(stamp_of(case))["cites"].split(","))
