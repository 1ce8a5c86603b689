"""The examples of the documents work as described."""

from __future__ import annotations

import json
import re
import shlex
import shutil
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pytest

import contourlab as cl
from contourlab.scenario import parse_scenario

ROOT = Path(__file__).parents[2]
FENCE = re.compile(r"^```(\w+)\n(.*?)^```", re.MULTILINE | re.DOTALL)
PART = "G21 G90 G94\nG1 X10 F600\nY10\nX0 Y0\nM2\n"


def blocks(document: str, language: str) -> list[str]:
    """Return the code blocks of a document."""
    return [text for found, text in FENCE.findall((ROOT / document).read_text(encoding="utf-8")) if found == language]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a part program, in which relative names start."""
    (tmp_path / "part.ngc").write_text(PART)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_files_of_the_manual_make_a_scenario(folder: Path) -> None:
    scenario, machine, axis, controller, _, _, program, _ = blocks("docs/reference/scenario-files.md", "toml")
    for name, text in (("scenario", scenario), ("machine", machine), ("axis1", axis), ("controller", controller)):
        (folder / f"{name}.toml").write_text(text, encoding="utf-8")
    found = cl.load_scenario("scenario.toml")
    assert [case.name for case in found.cases()] == ["position loop", "as it is"]
    assert found.base.machine.carried_mass("x") == 8.0
    assert found.base.machine.squareness == {("x", "y"): pytest.approx(2e-5)}
    assert found.base.reference().path.length == pytest.approx(0.02 + 0.01 * np.sqrt(2.0))
    # The last block replaces `program = "part.ngc"`.
    (folder / "other.toml").write_text(scenario.replace('program = "part.ngc"', "").split("[schemes")[0] + program.replace('"z"', '"y"'))
    assert cl.load_scenario("other.toml").base.reference().n_sample == found.base.reference().n_sample


def test_further_slots_of_the_manual_and_its_learning() -> None:
    further, learning = blocks("docs/reference/scenario-files.md", "toml")[4:6]
    motor = '{kind = "second-order-integrator", dc_gain = "40 mm/s/V", damping_ratio = 1.1, natural_frequency = "150 rad/s"}'
    machine = f'[machine]\nname = "stage"\nservo_period = "1 ms"\naxes = ["x", "y"]\n[axes."*"]\nplant = {motor}\n'
    drive = '[axes.y.drive]\nkind = "delayed-saturation"\ndelay = "2 ms"\n'
    rest = '[contour]\nname = "circle"\n[feed]\nlaw = "uniform"\nfrequency = "0.5 Hz"\n'
    case = parse_scenario(machine + drive + further + rest + learning).base
    parts = case.controller.axes
    assert parts["x"].predictor is None and parts["y"].predictor is not None
    assert parts["x"].feedforward is not None and parts["x"].feedforward.kind == "zpetc"
    assert case.controller.coupling is not None and case.controller.coupling.kind == "cross-coupled"
    assert case.learning is not None and (case.learning.law.kind, case.learning.trials) == ("zero-phase", 20)
    assert cl.simulate(case.machine, case.controller, case.reference()).status.ok


def test_the_drawing_of_the_manual_makes_a_scenario(folder: Path) -> None:
    import ezdxf

    drawing = ezdxf.new()  # type: ignore[attr-defined]
    drawing.header["$INSUNITS"] = 4
    drawing.modelspace().add_circle((0, 0), 10, dxfattribs={"layer": "cut"})
    drawing.modelspace().add_text("part 7", dxfattribs={"layer": "cut"})
    drawing.modelspace().add_circle((0, 0), 30, dxfattribs={"layer": "blank"})
    drawing.saveas(folder / "part.dxf")
    (folder / "scenario.toml").write_text(blocks("docs/reference/scenario-files.md", "toml")[-1], encoding="utf-8")
    reference = cl.load_scenario("scenario.toml").base.reference()
    assert reference.path.length == pytest.approx(0.02 * np.pi)
    assert reference.duration == pytest.approx(2.0)


@pytest.mark.slow
def test_the_scenario_of_the_readme_and_its_python(folder: Path) -> None:
    (folder / "scenario.toml").write_text(blocks("README.md", "toml")[0], encoding="utf-8")
    text = "\n".join(blocks("README.md", "python"))
    assert "budget=2000" in text
    scope: dict[str, object] = {}
    exec(compile(text.replace("budget=2000", 'budget=64, parameter="x.position_gain"'), "README.md", "exec"), scope)
    assert (folder / "results" / "tuned.toml").exists()
    batch = scope["batch"]
    assert isinstance(batch, cl.BatchResult)
    assert (batch.figures["contour_error_rms"] > 0.0).all()


def test_the_page_of_the_package_index_has_no_relative_links_and_its_python_runs(capsys) -> None:
    assert not re.search(r"\]\((?!https://)", (ROOT / "PYPI.md").read_text(encoding="utf-8"))
    (text,) = blocks("PYPI.md", "python")
    exec(compile(text, "PYPI.md", "exec"), {})
    assert 10e-6 < float(capsys.readouterr().out) < 100e-6


@pytest.mark.parametrize("guide", ["axis-control", *(pytest.param(name, marks=pytest.mark.slow) for name in ("learning", "network-link"))])
def test_the_scenarios_and_the_python_of_a_guide_run(guide: str, folder: Path) -> None:
    page = f"docs/how-to/{guide}.md"
    named = {name[1]: text for text in blocks(page, "toml") if (name := re.match(r"# (\S+\.toml)\n", text))}
    for name, text in named.items():
        (folder / name).write_text(text, encoding="utf-8")
    scenarios = {name: cl.load_scenario(name) for name, text in named.items() if "[feed]" in text}
    assert all(scenario.base.reference().n_sample for scenario in scenarios.values())
    case = next(iter(scenarios.values())).base
    scope: dict[str, Any] = {"machine": case.machine, "controller": case.controller, "reference": case.reference()}
    try:
        for text in blocks(page, "python"):
            exec(compile(text, page, "exec"), scope)
    finally:
        plt.close("all")


def test_every_contour_is_in_the_manual_with_its_parameters() -> None:
    from contourlab.geometry import contour_names, contour_parameters

    text = (ROOT / "docs/reference/scenario-files.md").read_text(encoding="utf-8")
    rows = dict(re.findall(r"^\| `([a-z-]+)` \| (.*) \|$", text, re.MULTILINE))
    for name in contour_names():
        assert set(re.findall(r"`([a-z_]+)`", rows[name])) == set(contour_parameters(name)), name


@pytest.mark.slow
def test_the_tutorial_reproduces_its_printed_figures(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from contourlab.cli.main import main

    answers, compare, *_ = blocks("docs/tutorials/first-hour.md", "toml")
    (python,) = blocks("docs/tutorials/first-hour.md", "python")
    text = (ROOT / "docs/tutorials/first-hour.md").read_text(encoding="utf-8")
    (part,) = re.findall(r"^```\n; part.ngc\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    for name, content in (("answers.toml", answers), ("compare.toml", compare), ("part.ngc", "; part.ngc\n" + part)):
        (folder / name).write_text(content, encoding="utf-8")
    commands = [line.split() for block in blocks("docs/tutorials/first-hour.md", "sh") for line in block.splitlines()]
    assert main(commands[0][1:]) == 0
    assert "47.37 kg (70%)" in capsys.readouterr().out
    assert main([*commands[1][1:6], "20 um", "--out", "first"]) == 1
    assert " ".join(capsys.readouterr().out.partition("\n\n")[0].split()) in text
    assert main(commands[2][1:]) == 1
    summary = json.loads((folder / "results" / "summary.json").read_text(encoding="utf-8"))
    for scheme, worst in re.findall(r"^\| ([^|`]+?) \| ([\d.]+) um \|", text, re.MULTILINE):
        assert f"{summary['schemes'][scheme]['metrics']['part_error']['max'] * 1e6:.3g}" == worst, scheme
    scope: dict[str, Any] = {}
    exec(compile(python, "tutorial.md", "exec"), scope)
    assert f"{scope['batch'].figures['contour_error_max'][-1] * 1e6:.1f} um at 40 kg" in text


@pytest.mark.slow
def test_the_tutorial_learns_as_described(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from contourlab.cli.main import main

    answers, _, learn, _ = blocks("docs/tutorials/first-hour.md", "toml")
    text = (ROOT / "docs/tutorials/first-hour.md").read_text(encoding="utf-8")
    (part,) = re.findall(r"^```\n; part.ngc\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    for name, content in (("answers.toml", answers), ("learn.toml", learn), ("part.ngc", "; part.ngc\n" + part)):
        (folder / name).write_text(content, encoding="utf-8")
    commands = [line.partition("#")[0].split() for block in blocks("docs/tutorials/first-hour.md", "sh") for line in block.splitlines()]
    main(commands[0][1:])
    analyse, compare = (command[1:] for command in commands if command[1] in ("analyse", "compare"))
    capsys.readouterr()
    main([*analyse, "--json"])
    findings = [one for scheme in json.loads(capsys.readouterr().out)["schemes"].values() for one in scheme["findings"]]
    grows = next(one["values"] for one in findings if one["code"] == "CL310")
    assert (grows["frequency"], grows["growth"]) == (pytest.approx(118.4, abs=0.05), pytest.approx(0.00453, abs=5e-5))
    assert main(compare) == 0
    schemes = json.loads((folder / "results" / "summary.json").read_text(encoding="utf-8"))["schemes"]
    rows = re.findall(r"^\| `([^`]+)`[^|]* \| ([\d.]+) um \| ([\d.]+) um \|", text, re.MULTILINE)
    assert [scheme for scheme, *_ in rows] == list(schemes)
    for scheme, worst, rms in rows:
        metrics = schemes[scheme]["metrics"]["part_error"]
        assert (f"{metrics['max'] * 1e6:.3g}", f"{metrics['rms'] * 1e6:.3g}") == (worst, rms), scheme


@pytest.mark.slow
def test_commissioning_prints_its_figures(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from contourlab.cli.main import main

    page = "docs/tutorials/commissioning.md"
    text = (ROOT / page).read_text(encoding="utf-8")
    commands = [shlex.split(line, comments=True) for block in blocks(page, "sh") for line in block.splitlines()]

    def said(first: str, number: int = 0) -> str:
        capsys.readouterr()
        main([words for words in commands if words[1] == first][number][1:])
        return " ".join(capsys.readouterr().out.split())

    said("machines", 1)
    said("run")
    (verdict,) = re.findall(r"^```\n(position-loop: FAIL .*)\n```", text, re.MULTILINE)
    assert verdict in said("measure")
    identified = said("identify")
    rows = re.findall(r"^\| (\w+) \| ([\d.]+) \| ([\d.e-]+) \| ([\d.e-]+) \|", text, re.MULTILINE)
    assert [name for name, *_ in rows] == ["a", "b", "friction"]
    assert all(" ".join(row) in identified for row in rows)
    said("machines", 2)
    shutil.copy("axis1.toml", "identified/axis1.toml")
    (verdict,) = re.findall(r"^```\n(with modified .*)\n```", text, re.MULTILINE)
    assert verdict in said("run", 1)
    row = re.search(r"part error, largest (\S+) um (\S+) um", said("tune"))
    (before, after), *_ = re.findall(r"^\| largest part error \| ([\d.]+) um \| ([\d.]+) um \|", text, re.MULTILINE)
    assert row and row[1] == before
    assert float(row[2]) == pytest.approx(float(after), rel=0.1)  # the search ends elsewhere on another processor
