"""The models of ``contourlab identify`` as typed: from logs to figures, pictures and axis files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from identified_logs import PERIOD, PLANT, SCENARIO, TIME, UBC, codes, driven, found_by, jogged, stepped, steps, written
from reference_data import reference_file
from typed_commands import Refused

from contourlab.analysis.identification.first_order import closed_loop_position, first_order_motion
from contourlab.cli.main import main
from contourlab.loop import Machine
from contourlab.scenario.load import load_axis


def test_first_order_makes_an_axis(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    u = steps()
    place = np.round(1.695e3 * first_order_motion(u, PERIOD, 10.1, 0.055, 0.055)[1] / 0.125e-3) * 0.125e-3
    log = written(tmp_path / "open.csv", "time [s],cmd [full_scale],pos x [mm]", TIME, u, place)
    out = tmp_path / "axis.toml"
    figures = found_by([log, "--column", "command.x=cmd", "--model", "first-order", "--write", str(out)], capsys)["parameters"]
    assert [figures[name]["value"] for name in ("a", "b", "friction")] == pytest.approx([1.695, 10.1, 0.055], rel=2e-3)
    assert figures["a"]["unit"] == "m/s^2/full_scale"
    axis = load_axis(out)
    assert axis.plant.values()["gain"] == pytest.approx(1.695, rel=2e-3)
    assert axis.friction.values()["coulomb"] == pytest.approx(0.055, rel=2e-3)
    assert "deviation" in out.read_text() and "open.csv" in out.read_text()


def test_closed_loop_takes_the_gains_of_the_loop(tmp_path: Path, refused: Refused, capsys: pytest.CaptureFixture[str]) -> None:
    asked = steps(1, 1e-4, 250)
    place = closed_loop_position(asked, PERIOD, 0.873, 19.7, 4000.0, 100.0)
    log = written(tmp_path / "closed.csv", "time [s],ref x [mm],pos x [mm]", TIME, 1e3 * asked, 1e3 * place)
    words = [log, "--model", "closed-loop", "--position-gain", "4 full_scale/mm"]
    gains = [*words, "--velocity-gain", "0.1 full_scale*s/mm"]
    figures = found_by(gains, capsys)["parameters"]
    assert (figures["a'"]["value"], figures["b'"]["value"]) == pytest.approx((0.873, 19.7), rel=1e-3)
    for wrong, said in (
        (words, "--velocity-gain"),
        ([*words, "--velocity-gain", "3 parsecs"], "0.1 full_scale*s/mm"),
        ([log, "--model", "closed-loop"], "no disturbance_estimate"),
        ([log, log, *gains[1:]], "a single run"),
    ):
        assert said in refused("identify", *wrong)


def test_a_log_given_twice_is_refused_and_one_of_the_same_samples_reported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, refused: Refused, capsys: pytest.CaptureFixture[str]
) -> None:
    log = Path(jogged(tmp_path, lambda v: 0.5 * np.sign(v) + 4.0 * v))
    monkeypatch.chdir(tmp_path)
    (tmp_path / "link.csv").symlink_to(log)
    words = ["--column", "command.x=cmd", "--model", "friction"]
    for again, said in ((log.name, "jog.csv: must be given once"), ("link.csv", "link.csv, the same file as jog.csv")):
        assert said in refused("identify", log.name, again, *words)
    (tmp_path / "copy.csv").write_bytes(log.read_bytes())
    (twice,) = (one for one in found_by([log.name, "copy.csv", *words], capsys)["findings"] if one["code"] == "CL500")
    assert (twice["place"], twice["values"]["other"]) == ("copy.csv", "jog.csv")


@pytest.mark.slow
def test_sines_of_the_measured_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    logs = [str(reference_file(f"data/ubc-xy-table/sine_{f}Hz.mat")) for f in (1, 4, 10, 30, 50, 70)]
    out = tmp_path / "axis.toml"
    found = found_by([*logs, *UBC, "--model", "linear-motor", "--write", str(out)], capsys)
    assert [point["frequency"] for point in found["details"]["points"]] == pytest.approx([4.0, 10.0, 30.0, 50.0, 70.0], rel=2e-3)
    places = {(one["code"], one["place"]) for one in found["findings"]}
    assert {("CL519", "sine_1Hz.mat"), ("CL524", "sine_4Hz.mat")} <= places and "CL506" not in codes(found)
    assert found["parameters"]["M"]["value"] == pytest.approx(0.347, rel=0.02) and found["fit_percent"] > 95.0
    assert found["parameters"]["M"]["unit"] == "V*s^2/m" and "CL503" in codes(found)
    assert load_axis(out).plant.values()["damping"] == pytest.approx(10.3, rel=0.05)


@pytest.mark.parametrize(
    "model", ["friction", "stiction", "first-order", "closed-loop", "frequency-response", "linear-motor", "two-inertia"]
)
def test_a_log_of_an_axis_at_rest_is_refused(tmp_path: Path, refused: Refused, model: str) -> None:
    log = written(tmp_path / "rest.csv", "time [s],cmd [V],pos x [mm],ref x [mm]", TIME, steps(), 0.0 * TIME, 0.0 * TIME)
    gains = ["--position-gain", "4 V/mm", "--velocity-gain", "0.1 V*s/mm"]
    said = refused("identify", log, "--column", "command.x=cmd", "--model", model, *gains, "--write", tmp_path / "axis.toml")
    assert "Traceback" not in said and len(said) > 40
    assert not (tmp_path / "axis.toml").exists()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("unit", "size", "more", "gain"),
    [
        ("full_scale", 1.0, [], "1.695 m/s^2/full_scale"),
        ("V", 10.0, ["--full-scale", "10 V"], "1.695 m/s^2/full_scale"),
        ("V", 10.0, [], "1.0 m/s^2/full_scale"),
        ("V", 10.0, ["--gain", "5 N/V"], "0.1695 m/s^2/A"),
    ],
)
@pytest.mark.parametrize("model", ["first-order", "linear-motor", "rigid"])
def test_the_file_of_an_axis_runs(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str, unit: str, size: float, more: list[str], gain: str
) -> None:
    out = tmp_path / "axis.toml"
    words = [stepped(tmp_path, unit, size), "--column", "command.x=cmd", "--model", model, "--write", str(out), *more]
    if model == "rigid":
        if "--gain" not in more:
            assert main(["identify", *words]) == 2 and not out.exists()
            return
        words += ["--cutoff", "100 Hz"]
    found = found_by(words, capsys)
    assert driven(tmp_path, gain) < 0.2e-3
    assert ("CL506" in codes(found)) == (model == "linear-motor")
    axis = load_axis(out)
    assert axis.correlations and axis.plant.origins["damping"].deviation
    if "--gain" in more and model == "first-order":
        assert axis.plant.values()["mass"] == pytest.approx(50.0 / 1.695, rel=1e-2)
        assert axis.disturbance.values()["force"] == pytest.approx(0.5, rel=0.05)
        # Mass is 1/a and damping b/a: their relative deviations are nearly those of a, and of b with a's share.
        a = found["parameters"]["a"]
        assert axis.plant.origins["mass"].deviation / axis.plant.values()["mass"] == pytest.approx(
            a["robust_deviation"] / a["value"], rel=0.01
        )


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (["--gain", "35 N/A"], "per V"),
        (["--full-scale", "10 A"], "in V"),
        (["--full-scale", "0 V"], "> 0"),
        (["--full-scale", "ten"], "10 V"),
        (["--full-scale", "10 V", "--gain", "35 N/V"], "one of the two"),
    ],
)
def test_a_gain_per_another_unit_is_refused(tmp_path: Path, refused: Refused, more: list[str], said: str) -> None:
    words = [stepped(tmp_path, "V", 10.0), "--column", "command.x=cmd", "--model", "first-order", *more]
    error = refused("identify", *words)
    assert said in error and "Traceback" not in error


@pytest.mark.slow
def test_deviations_are_the_spread_over_many_logs() -> None:
    """Thirty noisy logs of one axis in open loop, and thirty frequency responses of one drive by five sines."""
    from contourlab.analysis.identification.drive_fit import held_response, linear_motor
    from contourlab.analysis.identification.first_order import identify_first_order
    from contourlab.features.identify.frequency import identify_linear_motor
    from contourlab.features.identify.options import Identify
    from contourlab.features.identify.records import AxisRecord

    u, true = steps()[:4000], {"M": 0.347, "B": 3.56, "delay": 5e-4}
    place, time = 1.695 * first_order_motion(u, PERIOD, 10.1, 0.055, 0.055)[1], TIME[:3000]

    def sine(f: float, noise: np.ndarray) -> AxisRecord:
        h = held_response(lambda s: linear_motor(true, s), np.array([f]), PERIOD)[0]
        wave = np.exp(2j * np.pi * f * time)
        return AxisRecord(f"{f}", "x", PERIOD, (h * wave).imag + noise, wave.imag, "V", None, None)

    found: dict[str, list[tuple[float, float]]] = {}
    for seed in range(30):
        rng = np.random.default_rng(seed)
        fit = identify_first_order(TIME[:4000], u, place + 2e-6 * rng.standard_normal(4000))
        for name in ("a", "b", "friction"):
            found.setdefault(name, []).append((fit[name], fit.deviation(name)))
        drive = identify_linear_motor([sine(f, 2e-6 * rng.standard_normal(3000)) for f in (4.0, 10.0, 30.0, 50.0, 70.0)], Identify())
        for name, figure in drive.parameters.items():
            found.setdefault(name, []).append((figure.value, figure.robust_deviation))
    for name, rows in found.items():
        values, deviations = np.array(rows).T
        # The spread of thirty is known to 13 %; the damping's deviation is on the safe side.
        assert 0.6 < np.median(deviations) / values.std(ddof=1) < (6.0 if name == "B" else 1.6), name


@pytest.mark.parametrize("model", ["rigid", "first-order", "linear-motor"])
@pytest.mark.slow
def test_impossible_units_are_reported(tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str) -> None:
    """The same log with millimetres read as nanometres: 30 kg become 30 thousand tonnes."""
    out = tmp_path / "axis.toml"
    words = [stepped(tmp_path, "V", 10.0), "--column", "command.x=cmd", "--gain", "5 N/V", "--model", model, "--write", str(out)]
    assert "CL532" not in codes(found_by(words, capsys)) and out.exists()
    out.unlink()
    found = found_by([*words, "--column", "position.x=pos x [nm]"], capsys, code=1)
    assert "CL532" in codes(found) and not out.exists()


@pytest.mark.slow
@pytest.mark.parametrize("more", [["--gain", "5 N/V"], ["--gain", "-5 N/V", "--column", "command.x=-cmd"]])
def test_a_gain_makes_the_same_kind_of_axis_by_every_model(tmp_path: Path, capsys: pytest.CaptureFixture[str], more: list[str]) -> None:
    """An axis of 50/1.695 kg in a log in volts: force constant, limit and offset of its file do not depend on the model."""
    column = [] if "--column" in more else ["--column", "command.x=cmd"]
    log, found = stepped(tmp_path, "V", 10.0), {}
    for model in ("rigid", "first-order", "linear-motor"):
        out = tmp_path / f"{model}.toml"
        found[model] = found_by([log, *column, *more, "--model", model, "--write", str(out)], capsys)
        axis = load_axis(out)
        assert axis.plant.kind == "mass-damper" and axis.plant.values()["force_constant"] == pytest.approx(5.0), model
        # The sliding friction of an axis that turns round counts as damping over frequency, and as some mass.
        assert axis.plant.values()["mass"] == pytest.approx(50.0 / 1.695, rel=0.05 if model == "linear-motor" else 0.01)
        largest = 10.0 * float(np.abs(steps()).max())
        assert axis.drive.values()["limit"] == pytest.approx(1.5 * largest)
        assert "50 %" in axis.drive.origins["limit"].note
        assert axis.limits.velocity == pytest.approx(load_axis(tmp_path / "rigid.toml").limits.velocity, rel=0.1)
        if model != "linear-motor":  # a command of half a newton balances the constant force of the axis
            assert axis.disturbance.values()["force"] == pytest.approx(0.5, rel=0.05)
    assert found["rigid"]["parameters"]["offset"]["value"] == pytest.approx(-0.5, rel=0.05)
    assert found["first-order"]["parameters"]["offset"]["value"] == pytest.approx(-0.5, rel=0.05)


@pytest.mark.slow
@pytest.mark.parametrize("full_scale", [False, True])
@pytest.mark.parametrize("model", ["first-order", "linear-motor", "rigid"])
def test_an_identified_axis_follows_plans_at_its_limits(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str, full_scale: bool
) -> None:
    """The drive can give both limits at once, for any log: in these open-loop steps they occur separately."""
    if model == "rigid" and full_scale:
        return  # the rigid model takes forces
    out, mass = tmp_path / "axis.toml", 1.0 if full_scale else 50.0
    log = stepped(tmp_path, "full_scale" if full_scale else "N", mass)
    column = "force.x=cmd" if model == "rigid" else "command.x=cmd"
    found_by([log, "--column", column, "--model", model, "--write", str(out)], capsys)
    axis = load_axis(out)
    limits, rate = axis.limits, 10.1
    taken = mass * ((limits.acceleration + rate * limits.velocity) / 1.695 + 0.055 + 0.01)
    drive = axis.drive.values()["limit"]
    assert 0.8 * drive < taken < 0.95 * drive
    assert limits.jerk == pytest.approx(100.0 * limits.acceleration, rel=1e-4)
    assert "drive" in limits.origins["acceleration"].note
    assert limits.origins["velocity"].source == "assumed" and limits.origins["velocity"].note
    assert Machine("m", (axis,), PERIOD).planner_limits().acceleration[0] == limits.acceleration


def test_a_missing_limit_is_reported_with_its_file(tmp_path: Path, refused: Refused) -> None:
    (tmp_path / "axis.toml").write_text(PLANT + '[limits]\nvelocity = "50 mm/s"\n')
    text = SCENARIO.replace("GAIN", "1.695 m/s^2/full_scale").replace("RATE", "10.1").replace("limits =", "#")
    (tmp_path / "way.ngc").write_text("G21 G90\nG1 X20 F1800\nX0\nM2\n")
    (tmp_path / "run.toml").write_text(text)
    said = refused("run", tmp_path / "run.toml", "--out", tmp_path / "out")
    assert f"{tmp_path / 'axis.toml'}: axis x" in said and "limits.acceleration" in said


def test_logs_of_one_name_are_named_by_their_folders(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name, speeds in (("slow", [10, 20, 40]), ("fast", [80, 120, 160])):
        (tmp_path / name).mkdir()
        v = np.repeat(np.ravel(np.column_stack([speeds, np.negative(speeds)])), 600) * 1e-3
        u = 0.5 * np.sign(v) + 5.0 * v + 0.01 * np.random.default_rng(1).standard_normal(v.size)
        written(tmp_path / name / "jog.csv", "time [s],cmd [N],pos x [mm]", PERIOD * np.arange(v.size), u, 1e3 * PERIOD * np.cumsum(v))
    logs, out = [str(tmp_path / name / "jog.csv") for name in ("slow", "fast")], tmp_path / "axis.toml"
    words = [*logs, "--column", "force.x=cmd", "--model", "friction", "--write", str(out)]
    found = found_by(words, capsys)
    assert found["logs"] == ["slow/jog.csv", "fast/jog.csv"]
    assert {point["source"] for point in found["details"]["points"]} == {"slow/jog.csv", "fast/jog.csv"}
    assert 'from = "slow/jog.csv and 1 more"' in out.read_text() and str(tmp_path) not in out.read_text()
    assert main(["identify", *words]) == 0
    assert "slow/jog.csv, fast/jog.csv, " in capsys.readouterr().out
    # A finding about one log names it.
    rows = (tmp_path / "fast" / "jog.csv").read_text().splitlines()
    (tmp_path / "fast" / "jog.csv").write_text("\n".join([*rows[:700], *rows[703:]]) + "\n")
    of_one = [one["text"] for one in found_by(words, capsys)["findings"] if one["place"] == "fast/jog.csv"]
    assert any("missing" in text for text in of_one)


@pytest.mark.parametrize(
    ("model", "more", "files", "labels"),
    [
        ("friction", ["--full-scale", "10 V"], ["friction", "residual"], ["mean command [full_scale]", "residual [full_scale]"]),
        ("frequency-response", [], ["bode"], ["velocity [mm/s/V]", "phase [deg]", "coherence"]),
    ],
)
@pytest.mark.slow
def test_pictures_have_points_labels_and_a_folder(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str, more: list[str], files: list[str], labels: list[str]
) -> None:
    speeds, rates = (10, 120, 160, 200, 20, 50, 5, 80), (10, 30, 50, 70)
    names = [f"friction_{v}_mmps" for v in speeds] if model == "friction" else [f"sine_{f}Hz" for f in rates]
    logs = [str(reference_file(f"data/ubc-xy-table/{name}.mat")) for name in names]
    assert main(["identify", *logs, *UBC, "--model", model, *more, "--plots", "svg", "--out", str(tmp_path / "seen")]) == 0
    assert sorted(file.stem for file in (tmp_path / "seen" / "plots").iterdir()) == files
    drawn = "".join((tmp_path / "seen" / "plots" / f"{file}.svg").read_text() for file in files)
    assert all(f">{label}<" in drawn for label in labels) and ">measured" in drawn
    assert f"{tmp_path / 'seen' / 'plots' / files[0]}.svg" in capsys.readouterr().out


def test_a_requested_file_that_is_not_written_is_no_success(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "axis.toml"
    out.write_text("older")
    words = [stepped(tmp_path, "V", 10.0), "--column", "command.x=cmd", "--model", "frequency-response"]
    assert main(["identify", *words]) == 0
    assert main(["identify", *words, "--write", str(out)]) == 1
    assert str(out) in capsys.readouterr().out and out.read_text() == "older"
