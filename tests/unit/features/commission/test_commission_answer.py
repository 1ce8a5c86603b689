"""From files and a log to gains; and logs that are not what they should be."""

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import made_commission as bench
import numpy as np
import pytest
from made_two_masses import TwoMasses

from contourlab.analysis.identification.descent import DescentSettings
from contourlab.app.json_values import json_values
from contourlab.app.results import SAFETY
from contourlab.errors import ParameterError
from contourlab.features.commission.command import Commissioned, commission
from contourlab.features.commission.loop import GAINS
from contourlab.features.commission.setup import read_setup
from contourlab.features.commission.tuning import AxisTask, TunedAxis, largest_error, shared_delay, tune_axis

Rows = dict[str, np.ndarray]


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> bench.Made:
    return bench.made(tmp_path_factory.mktemp("machine"))


@pytest.fixture(scope="module")
def answered(made: bench.Made, tmp_path_factory: pytest.TempPathFactory) -> tuple[Commissioned, Path]:
    folder = tmp_path_factory.mktemp("answer")
    return commission(made.ini, made.hal, log=[made.log(folder / "log1.csv")]).save(folder / "out"), folder / "out"


def test_first_call_writes_what_to_run(made: bench.Made, tmp_path: Path) -> None:
    before = made.ini.read_bytes(), made.hal.read_bytes()
    result = commission(made.ini, made.hal).save(tmp_path)
    assert [file.name for file in result.files] == ["excite.ngc", "sampler.hal", "steps.md"]
    assert before == (made.ini.read_bytes(), made.hal.read_bytes())
    assert result.passed


@pytest.mark.parametrize("axis", ["x", "y"])
@pytest.mark.slow
def test_axes_are_recovered(answered: tuple[Commissioned, Path], axis: str) -> None:
    true, found = bench.MODELS[axis], answered[0].models[axis]
    for name, tolerance in (("gain", 0.01), ("damping", 0.01), ("friction", 0.03)):
        assert getattr(found.model, name) == pytest.approx(getattr(true, name), rel=tolerance)
        assert found.deviations[name] < tolerance * getattr(true, name)
    assert found.model.delay == pytest.approx(true.delay, abs=5e-5)
    assert found.noise == pytest.approx(bench.NOISE / np.sqrt(3.0), rel=0.2)
    assert found.play == pytest.approx(bench.PLAY[axis], abs=max(4.0 * found.play_deviation, 3e-7))
    assert found.simulated == pytest.approx(found.measured, rel=0.02)


@pytest.mark.slow
def test_gains_do_what_is_predicted(made: bench.Made, answered: tuple[Commissioned, Path]) -> None:
    result = answered[0]
    assert result.passed
    setup = made.setup
    for factor, limit in ((1.0, 2.0), (0.75, 40.0), (1.25, 40.0)):
        rows = bench.simulated(setup, made.program, result.pid, factor)
        for axis in "xy":
            reached = 1e3 * np.abs(rows[f"{axis}_cmd [mm]"] - rows[f"{axis} [mm]"]).max()
            assert reached < limit * result.predicted[axis].after
            if factor == 1.0:
                assert reached > 0.5 * result.predicted[axis].after
                assert reached < 0.1 * result.predicted[axis].before


@pytest.mark.slow
def test_diff_leads_to_the_proposed_gains(made: bench.Made, answered: tuple[Commissioned, Path], tmp_path: Path) -> None:
    result, folder = answered
    diff = (folder / "gains.diff").read_text()
    assert all((folder / name).read_text().startswith(f"{SAFETY}\n--- ") for name in ("gains.diff", "safe.diff"))
    patched = []
    for file in (made.ini, made.hal):
        old, new = file.read_text().splitlines(), list[str]()
        at, inside = 0, False
        for line in diff.splitlines():
            if line.startswith("--- "):
                inside = line == f"--- a/{file.name}"
            elif line.startswith("@@") and inside:
                start = int(line.split()[1].split(",")[0][1:]) - 1
                new += old[at:start]
                at = start
            elif inside and line[:1] in " +-" and not line.startswith("+++"):
                new += [line[1:]] if line[0] in " +" else []
                at += line[0] in " -"
        (tmp_path / file.name).write_text("\n".join([*new, *old[at:]]) + "\n")
        patched.append(tmp_path / file.name)
    setup = read_setup(*patched)
    assert {axis.name: axis.gains for axis in setup.axes} == {axis: pytest.approx(gains) for axis, gains in result.pid.items()}


@pytest.mark.slow
def test_json_has_gains_and_prediction(answered: tuple[Commissioned, Path]) -> None:
    values = json_values(answered[0])
    assert set(values["pid"]["x"]) == {"Pgain", "Igain", "Dgain", "FF0", "FF1", "FF2", "FF3"}
    assert values["predicted"]["y"]["before"] > 10.0 * values["predicted"]["y"]["after"] > 0.0
    for axis, play in bench.PLAY.items():  # both errors are largest where the axis turns
        at_motor, at_load = values["predicted"][axis]["after"], values["predicted"][axis]["load"]
        assert max(at_motor, 0.5e6 * play) < at_load < 1.1 * (at_motor + 0.5e6 * play)
    assert values["circle"]["after"] < 0.1 * values["circle"]["before"] and values["circle"]["load"] > 0.4e6 * max(bench.PLAY.values())
    assert {"CL890", "CL892"} <= {one["code"] for one in values["findings"]}
    assert "largest error" in values["answer"][0]


@pytest.mark.slow
def test_safe_values_lie_half_way(answered: tuple[Commissioned, Path]) -> None:
    result = answered[0]
    assert result.safe["x"]["Pgain"] == pytest.approx(0.5 * (0.8 + result.pid["x"]["Pgain"]), rel=1e-4)


@pytest.mark.slow
def test_report_and_picture(answered: tuple[Commissioned, Path]) -> None:
    page = (answered[1] / "report.html").read_text()
    assert "data:image/png" in page
    assert (answered[1] / "circle.png").read_bytes()[:4] == b"\x89PNG"


# --- logs that are not what they should be --------------------------------------------------------------------------------------------


def swapped(rows: Rows) -> Rows:
    return rows | {"x [mm]": rows["y [mm]"], "y [mm]": rows["x [mm]"]}


def clipped(rows: Rows) -> Rows:
    return rows | {"x_out": np.clip(rows["x_out"], -0.3, 0.3)}


def short(rows: Rows) -> Rows:
    moves = np.flatnonzero(np.diff(rows["x_cmd [mm]"]))
    return {name: values[moves[0] - 200 : moves[0] + 120] for name, values in rows.items()}


DOCTORED: list[tuple[str, Callable[[Rows], Rows]]] = [
    ("CL876", lambda rows: rows | {"x [mm]": -rows["x [mm]"]}),
    ("CL881", lambda rows: rows | {"x_out": -rows["x_out"]}),
    ("CL878", lambda rows: rows | {"x [mm]": 2.0 * rows["x [mm]"]}),
    ("CL877", lambda rows: rows | {"x [mm]": rows["x [mm]"] / 25.4}),
    ("CL877", lambda rows: rows | {"x [mm]": 25.4 * rows["x [mm]"]}),
    ("CL883", lambda rows: rows | {"x_out": 0.1 * rows["x_out"]}),
    ("CL874", swapped),
    ("CL880", lambda rows: rows | {"x_out": rows["y_out"], "y_out": rows["x_out"]}),
    ("CL885", clipped),
    ("CL886", short),
    ("CL875", lambda rows: rows | {"x [mm]": 0.0 * rows["x [mm]"]}),
    ("CL873", lambda rows: rows | {"x_cmd [mm]": 0.0 * rows["x_cmd [mm]"]}),
    ("CL871", lambda rows: rows | {"time [s]": 2.0 * rows["time [s]"]}),
    ("CL870", lambda rows: {name: values for name, values in rows.items() if name != "x [mm]"}),
    ("CL893", lambda rows: {name: values for name, values in rows.items() if "load" not in name}),
    ("CL872", lambda rows: {name: values for name, values in rows.items() if "out" not in name}),
]


@pytest.fixture
def untuned(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave out the search."""

    def tune(task: object, **settings: object) -> None:
        raise ParameterError("margins", "none", "searched")

    monkeypatch.setattr("contourlab.features.commission.command.tune_axis", tune)


@pytest.fixture
def stiff(monkeypatch: pytest.MonkeyPatch) -> None:
    """Hardly search for a shaft: that takes most of the time."""
    monkeypatch.setattr("contourlab.features.commission.identification.SEARCHES", ((1, 1.0, DescentSettings(most_iterations=2)),))


@pytest.mark.usefixtures("untuned", "stiff")
@pytest.mark.parametrize(("code", "doctor"), DOCTORED, ids=[f"{code}-{k}" for k, (code, _) in enumerate(DOCTORED)])
@pytest.mark.slow
def test_doctored_logs_are_named(made: bench.Made, tmp_path: Path, code: str, doctor: Callable[[Rows], Rows]) -> None:
    log = made.log(tmp_path / "log.csv", doctor(made.rows))
    result = commission(made.ini, made.hal, log=[log]).save(tmp_path / "out")
    assert code in {one.code for one in result.findings}
    wrong = [one for one in result.findings if one.code == code and one.entry.severity == "error"]
    assert all(one.place.removeprefix("axis ") not in result.pid for one in wrong)


@pytest.mark.usefixtures("untuned", "stiff")
@pytest.mark.slow
def test_a_wrong_period_in_the_ini_file_shows_in_a_log_without_times(made: bench.Made, tmp_path: Path) -> None:
    ini = tmp_path / "wrong.ini"
    ini.write_text(made.ini.read_text().replace("SERVO_PERIOD = 1000000", "SERVO_PERIOD = 2000000"))
    log = tmp_path / "log.txt"
    names = ("x_cmd [mm]", "x [mm]", "x_out", "y_cmd [mm]", "y [mm]", "y_out")
    samples = np.column_stack([np.arange(len(made.rows["x_out"])), *(made.rows[name] for name in names)])
    log.write_text("".join(f"{int(row[0])} " + " ".join(f"{value:f}" for value in row[1:]) + " \n" for row in samples))
    result = commission(ini, made.hal, log=[log]).save(tmp_path / "out")
    factors = [one.values["factor"] for one in result.findings if one.code == "CL882"]
    assert factors == pytest.approx([0.5, 0.5], rel=0.05)
    assert not result.pid


@pytest.mark.usefixtures("stiff")
@pytest.mark.slow
def test_noise_is_named(made: bench.Made, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("contourlab.features.commission.tuning.BUDGET", 32)
    log = made.log(tmp_path / "log.csv", bench.simulated(made.setup, made.program, noise=5e-6, axes="x"))
    result = commission(made.ini, made.hal, log=[log]).save(tmp_path / "out")
    assert "CL891" in codes(result)


# --- machines and files that are not what they should be ------------------------------------------------------------------------------


def codes(result: Commissioned, axis: str = "axis x") -> set[str]:
    return {one.code for one in result.findings if one.place == axis}


def with_ini(made: bench.Made, folder: Path, **changes: str) -> Path:
    """Return a copy of the INI file with keys of the first joint changed or added."""
    head, joint = made.ini.read_text().split("[JOINT_0]\n")
    for key, value in changes.items():
        joint, count = re.subn(rf"(?m)^{key} = .*$", f"{key} = {value}", joint, count=1)
        joint = joint if count else f"{key} = {value}\n{joint}"
    file = folder / "rig.ini"
    file.write_text(f"{head}[JOINT_0]\n{joint}")
    return file


def without_output(rows: Rows) -> Rows:
    return {name: values for name, values in rows.items() if "out" not in name}


@pytest.mark.usefixtures("untuned", "stiff")
@pytest.mark.parametrize(
    ("code", "changes", "doctor"),
    [
        ("CL879", {"P": "0", "I": "0", "FF1": "0"}, dict),
        ("CL884", {"P": "1.1"}, dict),
        ("CL887", {"P": "-0.8", "I": "-0.5", "FF1": "-0.015"}, without_output),
        ("CL899", {"BACKLASH": "0.02"}, dict),
    ],
)
@pytest.mark.slow
def test_files_that_do_not_fit_the_log_are_named(
    made: bench.Made, tmp_path: Path, code: str, changes: dict[str, str], doctor: Callable[[Rows], Rows]
) -> None:
    log = made.log(tmp_path / "log.csv", doctor(made.rows))
    result = commission(with_ini(made, tmp_path, **changes), made.hal, log=[log]).save(tmp_path / "out")
    assert code in codes(result)
    assert code not in codes(result, "axis y")


def wavy(n: int, amplitude: float, frequency: float, start: float) -> np.ndarray:
    """Return a sine [m] from a share of the record on."""
    time = bench.PERIOD * np.arange(n)
    return amplitude * np.sin(2.0 * np.pi * frequency * time) * (time >= start * time[-1])


@pytest.mark.usefixtures("untuned", "stiff")
@pytest.mark.parametrize(
    ("code", "wave", "delay"),
    [("CL888", (2e-4, 7.0, 0.0), 0.0), ("CL889", (5e-3, 2.0, 0.9), 0.0), ("CL896", (0.0, 1.0, 0.0), 2.4e-3)],
)
@pytest.mark.slow
def test_an_axis_unlike_its_model_is_named(
    made: bench.Made, tmp_path: Path, code: str, wave: tuple[float, float, float], delay: float
) -> None:
    n = made.rows["time [s]"].size
    rows = bench.simulated(made.setup, made.program, noise=wavy(n, *wave), axes="x", delay=delay)
    result = commission(made.ini, made.hal, log=[made.log(tmp_path / "log.csv", rows)]).save(tmp_path / "out")
    assert code in codes(result)


@pytest.mark.usefixtures("stiff")
@pytest.mark.slow
def test_no_gains_within_the_margins(made: bench.Made, tmp_path: Path) -> None:
    log = made.log(tmp_path / "log.csv", {name: values for name, values in made.rows.items() if not name.startswith("y")})
    result = commission(made.ini, made.hal, log=[log], gain_margin=80.0).save(tmp_path / "out")
    assert "CL897" in codes(result)
    assert result.pid["x"]["Pgain"] == 0.8


@pytest.mark.usefixtures("stiff")
@pytest.mark.slow
def test_gains_that_depend_on_the_axis_are_named(made: bench.Made, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:

    def tune(task: AxisTask, **settings: Any) -> TunedAxis:
        return replace(tune_axis(task, **settings), spread=2e-3)

    monkeypatch.setattr("contourlab.features.commission.command.tune_axis", tune)
    log = made.log(tmp_path / "log.csv", {name: values for name, values in made.rows.items() if not name.startswith("y")})
    result = commission(made.ini, made.hal, log=[log]).save(tmp_path / "out")
    assert "CL898" in codes(result)
    assert result.predicted["x"].spread == pytest.approx(2000.0)


@pytest.mark.usefixtures("stiff")
@pytest.mark.parametrize("always", [True, False])
@pytest.mark.slow
def test_noise_while_the_control_is_off_counts_only_for_a_pid_that_is_always_enabled(
    made: bench.Made, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, always: bool
) -> None:
    tasks: list[AxisTask] = []

    def tune(task: AxisTask, **settings: object) -> None:
        tasks.append(task)
        raise ParameterError("margins", "none", "searched")

    monkeypatch.setattr("contourlab.features.commission.command.tune_axis", tune)
    hal = tmp_path / "rig.hal"
    connected, fixed = "net x-enable joint.0.amp-enable-out => pid.x.enable", "setp pid.x.enable 1"
    hal.write_text(made.hal.read_text().replace(connected, fixed if always else connected))
    noise = 1e3 * np.random.default_rng(3).uniform(-bench.NOISE, bench.NOISE, 300)
    off = {"x_cmd [mm]": noise, "x [mm]": noise}
    rows = {name: np.concatenate([off.get(name, np.zeros(300)), values]) for name, values in made.rows.items() if name[0] in "tx"}
    rows["time [s]"] = bench.PERIOD * np.arange(rows["x_out"].size)
    commission(made.ini, hal, log=[made.log(tmp_path / "log.csv", rows)]).save(tmp_path / "out")
    assert [len(task.off) > 0 for task in tasks] == [always]


# --- a delay that all axes share -------------------------------------------------------------------------------------------------------


def one_period_late(made: bench.Made, folder: Path) -> tuple[Path, dict[str, dict[str, float]]]:
    """Return an INI file whose gains follow at any speed one servo period late, and the gains."""
    sections = made.ini.read_text().split("[JOINT_")
    gains = {}
    for k, (axis, model) in enumerate(bench.MODELS.items(), start=1):
        w, gain = 60.0, 1e3 * model.gain
        short = {"P": w**2 / gain, "I": 0.0, "D": (2.0 * w - model.damping) / gain, "FF1": model.damping / gain, "FF2": 1.0 / gain}
        for key, value in short.items():
            sections[k] = re.sub(rf"(?m)^{key} = .*$", f"{key} = {value:.10g}", sections[k], count=1)
        full = {"P": "Pgain", "I": "Igain", "D": "Dgain"}
        gains[axis] = {"FF0": 0.0, "FF3": 0.0} | {full.get(key, key): float(f"{value:.10g}") for key, value in short.items()}
    file = folder / "rig.ini"
    file.write_text("[JOINT_".join(sections))
    return file, gains


def distance(rows: Rows, axis: str, late: int) -> float:
    """Return the largest distance [um] of a position from its command some samples before."""
    command, position = rows[f"{axis}_cmd [mm]"], rows[f"{axis} [mm]"]
    return 1e3 * float(np.abs(command[: command.size - late] - position[late:]).max())


@pytest.mark.slow
@pytest.mark.usefixtures("untuned", "stiff")
def test_a_delay_that_all_axes_share_is_no_error(made: bench.Made, tmp_path: Path) -> None:
    ini, gains = one_period_late(made, tmp_path)
    rows = bench.simulated(made.setup, made.program, gains)
    result = commission(ini, made.hal, log=[made.log(tmp_path / "log.csv", rows)]).save(tmp_path / "out")
    for axis in "xy":
        assert distance(rows, axis, 0) > 190.0  # a servo period at 200 mm/s
        assert distance(rows, axis, 1) < 60.0
        assert result.predicted[axis].before == pytest.approx(distance(rows, axis, 1), abs=10.0)
    alone = {name: values for name, values in rows.items() if not name.startswith("y")}
    result = commission(ini, made.hal, log=[made.log(tmp_path / "log.csv", alone)]).save(tmp_path / "out")
    assert result.predicted["x"].before == pytest.approx(distance(rows, "x", 0), rel=1e-3)


@pytest.mark.slow
@pytest.mark.usefixtures("stiff")
def test_gains_that_only_remove_a_shared_delay_are_not_proposed(made: bench.Made, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Closer to the newest command, but with too little acceleration feedforward farther from the path: the gains in use stay."""
    ini, present = one_period_late(made, tmp_path)
    rows, tried = bench.simulated(made.setup, made.program, present), dict[str, float]()

    def tune(task: AxisTask, **settings: object) -> TunedAxis:
        axis = min(bench.MODELS, key=lambda name: abs(bench.MODELS[name].gain - task.model.gain))
        gains = np.array([1e3 * present[axis][name] for name in GAINS])
        gains[GAINS.index("FF1")] += gains[0] * task.law.period
        gains[GAINS.index("FF2")] *= 0.8
        tried[axis] = 1e6 * task.largest(gains)
        return TunedAxis(gains, 1e-6 * tried[axis], 0.0)

    monkeypatch.setattr("contourlab.features.commission.command.tune_axis", tune)
    result = commission(ini, made.hal, log=[made.log(tmp_path / "log.csv", rows)]).save(tmp_path / "out")
    for axis in "xy":
        assert distance(rows, axis, 1) < 0.8 * tried[axis] < tried[axis] < 0.8 * distance(rows, axis, 0)
        assert "CL897" in codes(result, f"axis {axis}")
        assert result.pid[axis] == present[axis]
    assert result.passed and (tmp_path / "out" / "gains.diff").read_text() == ""


@pytest.mark.parametrize("delays", [(0.0, 3e-3), (1e-3, 1e-3), (1.4e-3, 5e-3), (-1e-3, 2e-3)])
def test_the_smallest_delay_is_shared(delays: tuple[float, float]) -> None:
    time, period = 1e-3 * np.arange(4000), 1e-3

    def moved(t: np.ndarray) -> np.ndarray:
        return 0.02 * (1.0 - np.cos(2.0 * np.pi * np.maximum(t - 0.1, 0.0)))

    axes = [[(moved(time - at), moved(time - at - delay)) for at in (0.0, 0.3)] for delay in delays]
    assert shared_delay(axes, period) == pytest.approx(max(min(delays), 0.0), abs=2e-6)
    assert shared_delay(axes[:1], period) == 0.0
    for runs, delay in zip(axes, delays, strict=True):
        assert largest_error(runs, 0.0, period) == pytest.approx(0.02 * 2.0 * np.pi * abs(delay), rel=1e-3, abs=1e-9)
        assert delay < 0.0 or largest_error(runs, delay, period) < 2e-7  # that of linear interpolation


# --- what a motor shows of the load ---------------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.usefixtures("untuned")
@pytest.mark.parametrize(
    ("plant", "code"),
    [
        (TwoMasses(frequency=60.0), "CL895"),
        (TwoMasses(frequency=200.0, play=20e-6), "CL862"),
        (TwoMasses(frequency=200.0, play=50e-6, frictions=(0.02, 0.006)), "CL862"),
        (TwoMasses(frequency=200.0, play=20e-6, frictions=(0.03, 3e-4)), "CL893"),
    ],
)
def test_resonance_and_play_are_seen_from_the_motor(made: bench.Made, tmp_path: Path, plant: TwoMasses, code: str) -> None:
    command, axis = 1e-3 * made.rows["x_cmd [mm]"], made.setup.axes[0]
    noise = np.random.default_rng(1).uniform(-bench.NOISE, bench.NOISE, command.size)
    position, output = plant.measured(command, axis.gains, bench.PERIOD, noise)
    rows = {"time [s]": made.rows["time [s]"], "x_cmd [mm]": 1e3 * command, "x [mm]": 1e3 * position, "x_out": output}
    result = commission(made.ini, made.hal, log=[made.log(tmp_path / "log.csv", rows)]).save(tmp_path / "out")
    values = next(one.values for one in result.findings if one.code == code)
    model = result.models["x"]
    assert model.model.gain == pytest.approx(plant.gain, rel=0.02)
    if code == "CL895":
        assert values["frequency"] == model.model.resonance == pytest.approx(plant.frequency, rel=0.03)
        assert 0.0 < values["deviation"] < 0.02 * plant.frequency
        assert model.model.share == pytest.approx(1.0, rel=0.1)
    elif code == "CL862":
        assert model.play == pytest.approx(plant.play, abs=4.0 * model.play_deviation)
        assert 0.0 < model.play_deviation < 0.1 * plant.play
    else:
        assert np.isnan(model.play)
