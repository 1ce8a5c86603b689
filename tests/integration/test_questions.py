"""Questions asked in Python: the same answers as the commands, and no file."""

from __future__ import annotations

import json
from pathlib import Path

import made_circles
import matplotlib as mpl
import numpy as np
import pandas as pd
import pytest
from typed_commands import CIRCLE, PART, SCHEMES, AsJson, write

import contourlab as cl
from contourlab.app.json_values import json_values
from contourlab.scenario import dump

mpl.use("agg")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def names(folder: Path) -> set[str]:
    """Return the names of all files."""
    return {file.name for file in folder.rglob("*") if file.is_file()}


@pytest.mark.slow
def test_a_circle_has_the_same_answer_as_the_command(folder: Path, as_json: AsJson) -> None:
    made_circles.write_log(Path("log.csv"), x=8e-6, lag=1e-4)
    answer = cl.circle("log.csv", tolerance="5 um")
    assert names(folder) == {"log.csv"} and answer.passed is False
    typed = as_json("circle", "log.csv", "--tolerance", "5 um", code=1)
    told = json.loads(answer.to_json())
    assert told.pop("made_by") and told == typed
    assert list(answer.to_pandas()["cause"])[:2] == ["backlash", "servo mismatch"]
    assert answer.plot().get_xlabel() == "angle [deg]" and "backlash x" in answer._repr_html_()
    saved = answer.save("out")
    assert Path(saved.report).exists() and json.loads(Path("out/summary.json").read_text(encoding="utf-8"))["causes"] == typed["causes"]


@pytest.mark.slow
def test_files_and_objects_give_the_same_answer(folder: Path) -> None:
    write(folder, CIRCLE, "circle.toml")
    case = cl.load_scenario("circle.toml").base
    options = {"method": "sequential", "parameter": "1.position_gain", "lanes": 8}
    first = cl.tune("circle.toml", **options)
    second = cl.tune(case.machine, case.controller, case.reference(), **options)
    assert first.result.values == second.result.values and names(folder) == {"circle.toml"}
    # What JSON has under a key is an attribute too.
    assert (first.name, first.scheme) == (first.scenario.name, first.case.name) == tuple(map(json_values(first).get, ("name", "scheme")))
    with pytest.raises(AttributeError):
        _ = first.colour
    assert first.to_pandas()["after"].tolist() == list(first.result.values.values())
    kept = first.save("out").controller_file
    assert first.result.after.violations or (kept is not None and kept.exists())
    ran = cl.run(case.machine, case.controller, case.reference(), interval=False)
    assert ran.outcomes[0].metrics == cl.run("circle.toml", interval=False).outcomes[0].metrics


def test_a_log_may_come_from_arrays(folder: Path) -> None:
    write(folder, CIRCLE, "circle.toml")
    case = cl.load_scenario("circle.toml").base
    result = cl.simulate(case.machine, case.controller, case.reference())
    cells = {"time [s]": result.time}
    for j, axis in enumerate(result.axes):
        cells |= {f"position.{axis} [mm]": 1e3 * result["position"][:, j], f"reference.{axis} [m]": result["reference"][:, j]}
        cells |= {f"command.{axis} [N]": result["command"][:, j]}
    np.savetxt("log.csv", np.column_stack(list(cells.values())), delimiter=",", header=",".join(cells), comments="", fmt="%.17g")
    log = cl.load_log(pd.DataFrame(cells), name="log.csv")
    before = names(folder)
    for ask in (
        lambda log: cl.measure(log, tolerance="40 um"),
        lambda log: cl.limits(log, velocity="1 m/s"),
        lambda log: cl.circle(log),
        lambda log: cl.identify(log, model="rigid", axis=result.axes[0]),
    ):
        of_arrays, of_file = (ask(given).to_pandas().drop(columns="format", errors="ignore") for given in (log, "log.csv"))
        pd.testing.assert_frame_equal(of_arrays, of_file, rtol=1e-9)
    told, typed = (cl.measure(given, tolerance="40 um") for given in (log, "log.csv"))
    assert (told.command, told.data.next_steps) == (typed.command, typed.data.next_steps)
    other = cl.load_log(cells, name="other", columns=["position.3=-position.3"])
    assert cl.compare(log, other).runs[1].log.columns == other.columns
    assert names(folder) == before


@pytest.mark.parametrize(
    "arrays", [{"x [mm]": [[1.0]]}, {"x [mm]": ["a"]}, {"x [mm]": [1.0, 2.0], "t [s]": [0.0]}, {}, {"x": [0.0, 1.0], "t [s]": [0.0, 1.0]}]
)
def test_arrays_that_are_no_log_are_refused(arrays: dict[str, list[float]]) -> None:
    with pytest.raises(cl.ContourlabError):
        cl.load_log(arrays)


def test_what_python_built_is_saved_for_the_shell(folder: Path, as_json: AsJson) -> None:
    write(folder, CIRCLE, "circle.toml")
    case = cl.load_scenario("circle.toml").base
    machine, controller = cl.with_values(case.machine, case.controller, {"1.position_gain": 3.0, "axes.*.plant.damping": 4.0})
    assert [axis.plant.values()["damping"] for axis in machine.axes] == [4.0, 4.0]
    cl.save(machine, "m.toml")
    cl.save(controller, "c.toml", machine)
    head = 'name = "again"\nmachine = "m.toml"\ncontroller = "c.toml"\n'
    (folder / "again.toml").write_text(head + '[contour]\nname = "circle"\nradius = "1 mm"\n[feed]\nfeedrate = "600 mm/min"\n')
    again = cl.load_scenario("again.toml").base
    assert dump(again.machine) == dump(machine) and dump(again.controller, again.machine) == dump(controller, machine)
    values = {"axes.1.plant.damping": 4.0}
    alone = cl.simulate(case.machine, case.controller, case.reference(), values)
    lanes = cl.simulate_batch(
        case.machine, case.controller, case.reference(), {name: [value] for name, value in values.items()}, keep=["position"]
    )
    assert np.abs(alone["position"] - lanes.signals["position"][:, :, 0]).max() < 1e-9
    for bad in ((controller, "c.toml"), (machine, "m.csv"), (case.reference(), "r.toml")):
        with pytest.raises(cl.ContourlabError):
            cl.save(*bad)
    with pytest.raises(cl.ContourlabError):
        cl.with_values(machine, controller, {"1.postion_gain": 3.0})


@pytest.mark.slow
def test_a_failed_verdict_is_an_answer_and_bad_input_an_error(folder: Path) -> None:
    write(folder, CIRCLE.replace("16 um", "0.01 um"), "circle.toml")
    assert cl.run("circle.toml", interval=False).passed is False
    with pytest.raises(cl.ContourlabError):
        cl.run("nowhere.toml")
    with pytest.raises(cl.ContourlabError):
        cl.tune("circle.toml", budget=3)
    with pytest.raises(TypeError):
        cl.tune("circle.toml", bugdet=100)
    assert names(folder) == {"circle.toml"}


def test_what_is_read_already_has_the_options_of_a_file(folder: Path) -> None:
    write(folder, CIRCLE.replace('tolerance = "16 um"', "") + SCHEMES, "circle.toml")
    scenario = cl.load_scenario("circle.toml")
    objects = scenario.machine, scenario.controller, scenario.base.reference()
    for tolerance, passed in (("1 um", False), ("1 mm", True)):
        answer = cl.run(*objects, tolerance=tolerance, interval=False)
        assert answer.passed is passed and answer.command == ""
    assert Path(answer.save("objects").files["report"]).exists() and Path(cl.run(scenario).save("read").files["report"]).exists()
    assert list(cl.compare(scenario, schemes="all of it").schemes) == ["all of it"]
    for source, options in (([scenario], {"tolerance": "1 um"}), ([scenario.base], {"fit": True}), (objects, {"machine": "xyz"})):
        with pytest.raises(cl.ContourlabError):
            cl.run(*source, **options)


def test_code_and_fits_may_be_of_objects(folder: Path) -> None:
    write(folder, CIRCLE + SCHEMES, "circle.toml")
    scenario = cl.load_scenario("circle.toml")
    case, scheme = scenario.case("position loop"), {"scheme": "position loop"}
    wanted = cl.export("circle.toml", to="st", axis="1", **scheme)
    objects = case.machine, case.controller, case.reference()
    for source, options in (([scenario], scheme), (objects, {})):
        made = cl.export(*source, to="st", axis="1", **options)
        assert (made.hash, made.contents) == (wanted.hash, wanted.contents)
    for options in ({"machine": "xyz"}, scheme):
        with pytest.raises(cl.ContourlabError):
            cl.export(*objects, to="st", **options)
    run = cl.simulate(scenario.machine, scenario.controller, case.reference())
    columns = {f"{signal}.{axis} [m]": run[signal][:, j] for signal in ("position", "reference") for j, axis in enumerate(run.axes)}
    log = cl.load_log({"time [s]": run.time} | columns)
    sources = [scenario.file], [scenario], [scenario.machine, scenario.controller, case.reference()]
    fits = [cl.refine(*source, log=log, parameter="controller.axes.1.controller.position_gain") for source in sources]
    values = {fit.result.parameters[0].value for fit in fits}
    assert len(values) == 1 and values != {scenario.controller.axes["1"].controller.position_gain}


@pytest.mark.parametrize(("name", "inputs"), [("circle", []), ("identify", []), ("compare", []), ("check", [3]), ("measure", [None])])
def test_inputs_of_no_use_are_refused(name: str, inputs: list[object]) -> None:
    with pytest.raises(cl.ContourlabError):
        getattr(cl, name)(*inputs)


def test_a_program_is_checked_and_its_limits_are(folder: Path, as_json: AsJson) -> None:
    write(folder, PART)
    checked = cl.check("part.ngc")
    assert checked.faults == 0 and json_values(checked) == as_json("check", "part.ngc")
    with pytest.raises(cl.ContourlabError):
        checked.plot()  # it has no picture
    assert (checked.save("out"), names(folder)) == (checked, {"part.ngc"})
    test = cl.limits("part.ngc", velocity="1 mm/s")
    assert test.passed is not None and set(test.to_pandas()["axis"]) == {"x", "y", "z"}
    bars = test.plot()
    assert bars.get_xlabel() == "use of the limit [%]"
    assert [bar.get_width() for bar in bars.patches] == pytest.approx([100.0 * use for use in test.to_pandas()["use"].dropna()])
    annotated = test.save(annotate="annotated.ngc")
    assert annotated.annotated == "annotated.ngc" and Path("annotated.ngc").exists()
