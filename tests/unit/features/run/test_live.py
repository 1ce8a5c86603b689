"""A report's loop: what a page computes from the message alone, against the run itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from messages import message_in, pictures
from parts_in_loops import loop_with
from wasm_host import live_in_node, live_inputs, needs_node

import contourlab as cl
from contourlab.components.registry import component
from contourlab.features.run import live
from contourlab.features.run.live import live_loop
from contourlab.features.run.outcome import run_case
from contourlab.loop import parameters_of
from contourlab.loop.portable import portable
from contourlab.rendering.charts import LiveLoop, LivePath
from contourlab.rendering.message import message
from contourlab.scenario import load_controller

BOUND = 0.25e-6
"""Half an encoder count of the machine [m]: where a last digit decides between two counts, figures differ by a part of one."""
PROGRAM = """G21 G90 G94 G17 G64 P0.1
G0 X10 Y0
G1 X14 F1200
G3 X14 Y8 I0 J4
G1 X5
Y2
X8
X8.7765 Y2.1022
X9.5 Y2.4019
X10.1213 Y2.8787
X10.5981 Y3.5
X10.8978 Y4.2235
X11 Y5
M2
"""


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    file = tmp_path_factory.mktemp("part") / "part.ngc"
    file.write_text(PROGRAM)
    return cl.run(file, machine="xyz", controller="xyz-controller", interval=False)


@pytest.fixture(scope="module")
def page(runs, tmp_path_factory):
    folder = tmp_path_factory.mktemp("out")
    runs.save(folder)
    return (folder / "report.html").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def run(page):
    return pictures(message_in(page))["live"]["runs"][0]


def figures_of(run, *commands):
    """Return the figures after some commands, and the sample of failure."""
    words = [word for _, word in run["figures"]]
    *_, figures, failed = live_in_node(run, *commands, ("judge",), ("read", words[0], len(words)), ("read", run["failed_at"], 1))
    return {name: figures[word - words[0]] for name, word in run["figures"]}, failed[0]


def test_the_motion_of_a_message_is_the_reference(runs, run):
    reference = runs.outcomes[0].reference
    wanted, n = reference.block(0, reference.n_sample).table.T, reference.n_axis
    off = np.abs(live_inputs(run) - wanted)
    assert reference.programmed is not reference.path
    assert off[:n].max() <= 1e-10 and off[n : 2 * n].max() <= 1e-8 and off[2 * n : 3 * n].max() <= 1e-4
    assert off[-2].max() <= 1e-15 and off[-1].max() <= 1e-15


@needs_node
def test_a_page_finds_the_figures_of_its_report(runs, run):
    outcome, whole = runs.outcomes[0], ("run", 0, run["motion"]["n_sample"])
    figures, failed = figures_of(run, whole)
    part, samples = outcome.metrics.part_error, outcome.metrics.judged.samples
    assert failed == -1.0
    assert figures["part_error_max"] == pytest.approx(part.max, abs=BOUND)
    assert figures["part_error_rms"] == pytest.approx(part.rms, abs=BOUND)
    assert [tuple(pair) for pair in run["judged"]] == list(outcome.metrics.judged.ranges)
    log = live_in_node(run, whole, ("read", run["log"], run["n_log"] * whole[2]))[-1].reshape(-1, run["n_log"])
    error, worst = np.abs(log[:, run["part_error"]]), samples[np.abs(outcome.result["part_error"][samples]).argmax()]
    assert run["short"][0] == max(worst - round(0.5 / run["motion"]["period"]), 0) and run["short"][1] > worst
    highest, written = outcome.lines(np.array([samples[error[samples].argmax()], worst]))
    assert highest == written
    foot = outcome.reference.programmed.position(log[samples, run["foot"]])
    np.testing.assert_allclose(np.linalg.norm(log[samples][:, run["position"]] - foot, axis=1), error[samples], rtol=0.0, atol=1e-11)


@needs_node
def test_a_changed_value_gives_the_figures_of_that_machine(runs, run):
    case, name, value = runs.outcomes[0].case, "controller.axes.x.observer.bandwidth", 150.0
    word = next(one["word"] for one in run["parameters"] if one["name"] == name)
    figures, failed = figures_of(run, ("write", word, [value]), ("prepare",), ("run", 0, run["motion"]["n_sample"]))
    batch = cl.simulate_batch(case.machine, case.controller, runs.outcomes[0].reference, {name: [value]}, part=True)
    assert failed == -1.0
    assert abs(batch.figures["contour_error_max"][0] - runs.outcomes[0].metrics.contour_error.max) > 10.0 * BOUND
    for figure in ("part_error_max", "part_error_rms", "contour_error_max"):
        assert figures[figure] == pytest.approx(batch.figures[figure][0], abs=BOUND), figure


def test_parameters_have_the_names_and_values_of_the_case(runs, run):
    case = runs.outcomes[0].case
    known = parameters_of(case.machine, case.controller)
    by_name = {one["name"]: one for one in run["parameters"]}
    assert known.keys() - by_name.keys() == {
        f"axes.{axis}.{name}" for axis in case.machine.axis_names for name in ("sensor.stream", "drive.delay")
    }
    for name, one in by_name.items():
        value = getattr(*known[name])
        assert one["value"] == (value if np.isfinite(value) else None)
    first = {name for name, one in by_name.items() if one["first"]}
    kinds = {"controller.axes.x.controller.position_gain", "controller.axes.z.observer.bandwidth", "axes.y.friction.coulomb"}
    assert kinds <= first and not any("model" in name or name.endswith("filter_bandwidth") for name in first)


def test_the_controllers_file_reads_back_with_new_values(runs, run, tmp_path):
    case, text = runs.outcomes[0].case, run["controller"]
    values = {one["name"]: (one["value"], one["unit"]) for one in run["parameters"] if one["name"].startswith("controller.")}
    changed = {"controller.axes.x.observer.bandwidth": 260.0, "controller.coupling.weight": 0.25}
    for name, (value, unit) in values.items():
        value = changed.get(name, value)
        assert text.count(f'"@{name}@"') == 1
        text = text.replace(f'"@{name}@"', f'"{value!r} {unit}"' if unit else repr(value))
    (tmp_path / "controller.toml").write_text(text)
    read = load_controller(tmp_path / "controller.toml", case.machine)
    wanted = cl.with_values(case.machine, case.controller, changed)[1]
    for name, (part, word) in parameters_of(case.machine, wanted).items():
        if name.startswith("controller."):
            assert getattr(*parameters_of(case.machine, read)[name]) == pytest.approx(getattr(part, word), rel=1e-15), name


def test_a_page_permits_a_module_and_its_worker_only_where_it_has_one(runs, page, tmp_path, monkeypatch):
    monkeypatch.setattr(live, "MOST_BYTES", 1000)
    runs.save(tmp_path)
    without = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "live" not in pictures(message_in(without)) and 'id="live"' in page and 'id="live"' not in without
    assert "'wasm-unsafe-eval'; worker-src blob:;" in page and "wasm-unsafe-eval" not in without
    assert len(page) - len(without) < 400_000


@pytest.mark.parametrize("kind", [component("feedforward", "zpetc"), component("supervisor", "pre-routed")], ids=lambda kind: kind.kind)
def test_a_message_holds_all_that_a_module_begins_with(kind):
    machine, controller = loop_with(kind)
    reference = cl.uniform(cl.contour("circle", radius=5e-3), 0.2, 1, machine.servo_period)
    reference = replace(reference, source_lines=np.array([7]))
    loop = portable(machine, controller, reference, signals=("axis_position",))
    (outcome,) = cl.run(machine, controller, reference, interval=False).outcomes
    run = pictures(message([live_loop([outcome], "")]))["live"]["runs"][0]
    memory, wanted, first = np.zeros(run["n_word"]), np.zeros(loop.n_word), loop.inputs["reference"][0]
    wanted[loop.first : loop.first + loop.start.size] = loop.start
    wanted[first : first + loop.fed().size] = loop.fed().ravel()
    for at, values in run["words"]:
        memory[at : at + values.size] = values
    inputs = live_inputs(run).ravel()
    memory[run["inputs"] : run["inputs"] + inputs.size] = inputs
    coarse = np.zeros(memory.size, dtype=bool)
    for name, (at, size) in loop.tables.items():
        coarse[at : at + size] = name.endswith("cell_clearance")
    assert memory.size == wanted.size and loop.feed.names
    made = slice(first, first + inputs.size)
    np.testing.assert_allclose(memory[made], wanted[made], rtol=0.0, atol=1e-7)
    coarse[made] = True
    assert memory[~coarse].tobytes() == wanted[~coarse].tobytes()
    coarse[made] = False
    assert np.all(memory[coarse] <= wanted[coarse]) and np.all(memory[coarse] >= 0.96 * wanted[coarse])


def reason(outcome):
    loop = live_loop([outcome], "")
    assert loop.runs == () and loop.caption.startswith(outcome.name)
    return loop.caption


def test_what_no_page_can_run_has_a_reason(runs, monkeypatch):
    outcome = runs.outcomes[0]
    tilted = replace(outcome.case.machine, squareness={("x", "y"): 1e-5})
    assert "geometry" in reason(replace(outcome, case=replace(outcome.case, machine=tilted)))
    assert "recorded" in reason(replace(outcome, reference=replace(outcome.reference, profile=None)))
    monkeypatch.setattr(live, "MOST_TICKS", outcome.reference.n_sample - 1)
    assert f"{outcome.reference.n_sample} samples" in reason(outcome)


def test_a_circle_in_closed_form_has_a_path_too():
    case = cl.load_scenario("builtin:ghaffari/demo-stage").cases()[0]
    outcome = run_case(case, explain=False)
    loop = live_loop([outcome], "contourlab run stage.toml --out here --plugin a.py")
    run = pictures(message([loop]))["live"]["runs"][0]
    wanted = outcome.reference.block(0, outcome.reference.n_sample).table.T
    assert np.abs(live_inputs(run) - wanted)[:2].max() <= 1e-12
    assert loop.command == "contourlab run stage.toml --plugin a.py"


def test_exact_numbers_keep_every_bit_in_little_space():
    odd = np.array([0.1, -0.0, 5e-324, np.inf, 1e300])
    odd = np.append(odd, np.array([0x7FF8000000000123], dtype=np.int64).view(float))
    parts = [odd, np.array([0.0, 255.0]), np.array([-1.0, 2.0**31 - 1.0]), np.array([0.5, -0.0]), np.arange(300.0).reshape(3, 100)]
    loop = LiveLoop("live", "", "", tuple(LivePath(part, np.zeros(0), False) for part in parts), "")  # type: ignore[arg-type]
    found = pictures(message([loop]))["live"]["runs"]
    for part, one in zip(parts, found, strict=True):
        assert one["start"].tobytes() == part.tobytes() and one["start"].shape == part.shape
