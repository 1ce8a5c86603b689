"""``contourlab backlash`` and scenarios with backlash, as typed."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from typed_commands import Refused

import contourlab as cl
from contourlab.app import quick
from contourlab.cli.main import main
from contourlab.scenario import dump, load_scenario

DRIVE = """
name = "loose"

[machine]
name = "loose stage"
servo_period = "1 ms"
axes = ["x", "y"]

[axes."*"]
substeps = 4
friction = {kind = "coulomb", coulomb = "40 N"}
motor_sensor = {kind = "encoder", resolution = "0.125 um"}
limits = {velocity = "20 m/min", acceleration = "5 m/s^2"}

[axes."*".plant]
kind = "two-inertia"
motor_inertia = "52 kg*cm^2"
load_inertia = "44 kg*cm^2"
lead = "16 mm"
stiffness = "950 N*m/rad"
backlash_gap = "GAP"

[controller.axes."*"]
feedback = "motor"
controller = {kind = "cascade", gains = {bandwidth = "150 rad/s", damping = 0.9, position_gain = "30 1/s"}}

[contour]
name = "circle"
radius = "25 mm"

[feed]
feedrate = "8000 mm/min"
"""


def output(capsys: pytest.CaptureFixture[str], *words: str, code: int = 0) -> str:
    assert main(list(words)) == code
    return capsys.readouterr().out


@pytest.fixture
def written(tmp_path: Path) -> Callable[..., str]:
    def write(text: str, name: str = "s.toml", gap: str = "50 um") -> str:
        (tmp_path / name).write_text(text.replace("GAP", gap))
        return str(tmp_path / name)

    return write


@pytest.mark.slow
def test_gap_and_cure_of_a_loose_stage(written: Callable[..., str], capsys: pytest.CaptureFixture[str]) -> None:
    found = json.loads(output(capsys, "backlash", written(DRIVE), "--json"))["schemes"]["base"]
    for axis in "xy":
        seen = found["axes"][axis]
        assert seen["backlash_gap"] == pytest.approx(50e-6)
        # 2 F_c/k on top: 80 N over 950 N m/rad (2 pi/16 mm)^2.
        assert seen["lost_motion"] == pytest.approx(50e-6 + 80.0 / (950.0 * (2.0 * np.pi / 0.016) ** 2))
        alone = seen["from_motor_alone"]
        assert alone["gap"] == pytest.approx(50e-6, rel=0.1)
        assert abs(alone["gap"] - 50e-6) <= 3.0 * alone["deviation"]
    trials = {trial["name"]: trial["part_error_rms"] for trial in found["trials"]}
    assert found["recommended"] in trials
    assert trials[found["recommended"]] <= trials["as it is"]


@pytest.mark.slow
def test_a_quick_answer_follows_the_beginning_within_its_own_deviation(
    written: Callable[..., str], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    file = written(DRIVE.replace("8000 mm/min", "2000 mm/min"))
    whole = json.loads(output(capsys, "backlash", file, "--json"))["schemes"]["base"]
    monkeypatch.setattr(quick, "PLANNED", 0.5)
    found = json.loads(output(capsys, "backlash", file, "--quick", "--json"))["schemes"]["base"]
    assert "CL387" in {one["code"] for one in found["findings"]}
    for axis in "xy":
        few, all_samples = found["axes"][axis], whole["axes"][axis]
        assert few["limit_cycles"] is None and few["describing_function"] == all_samples["describing_function"]
        alone = few["from_motor_alone"]
        assert abs(alone["gap"] - all_samples["from_motor_alone"]["gap"]) <= 2.0 * alone["deviation"]


@pytest.mark.slow
def test_the_recommendation_can_be_put_into_the_scenario(written: Callable[..., str], capsys: pytest.CaptureFixture[str]) -> None:
    rubbing = DRIVE.replace('"40 N"', '"250 N"').replace("8000 mm/min", "2000 mm/min")
    found = json.loads(output(capsys, "backlash", written(rubbing), "--json"))["schemes"]["base"]
    assert found["recommended"] != "as it is"
    trials = {trial["name"]: trial["part_error_rms"] for trial in found["trials"]}
    text = rubbing + "\n" + found["toml"]
    case = load_scenario(written(text, "with.toml")).cases()[0]
    assert all(case.controller.axes[axis].compensation is not None for axis in "xy")
    report = json.loads(
        output(capsys, "run", written(text, "with.toml"), "--json", "--out", str(Path(written(text, "with.toml")).parent / "o"))
    )
    here = report["schemes"]["base"]["metrics"]["part_error"]["rms"]
    # The recommendation is printed with three digits.
    assert here == pytest.approx(trials[found["recommended"]], rel=0.02)
    assert here < 0.8 * trials["as it is"]


def test_a_machine_without_backlash_is_refused(written: Callable[..., str], refused: Refused) -> None:
    assert "backlash" in refused("backlash", written(DRIVE, gap="0 um"))
    assert "backlash" in refused("backlash", "builtin:demo-part.toml")


MOTOR = 'feedback = "motor"'
OTHER = 'others.gap = {kind = "cascade", position_gain = "1 1/s", velocity_gain = "1 N*m*s/mm"}'


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('"50 um"', '"-1 um"', "backlash_gap"),
        ("substeps = 4", "substeps = 1", "at least"),
        (MOTOR, 'feedback = "table"', "feedback"),
        (MOTOR, f'{MOTOR}\nsupervisor = {{kind = "performance", thresholds = ["1 um"]}}', "supervisor"),
        (MOTOR, f"{MOTOR}\n{OTHER}", "supervisor"),
        (MOTOR, f'{MOTOR}\nsupervisor = {{kind = "estimator-based"}}\n{OTHER}', "gap_observer"),
    ],
)
def test_an_invalid_value_is_refused_with_its_key(
    old: str, new: str, said: str, written: Callable[..., str], refused: Refused, tmp_path: Path
) -> None:
    text = DRIVE.replace("GAP", "50 um").replace(old, new)
    message = refused("run", written(text), "--out", tmp_path / "o")
    assert said in message and "Traceback" not in message


def test_a_moving_start_and_a_change_on_the_way_are_read_and_written_back(written: Callable[..., str], refused: Refused) -> None:
    Path(written(DRIVE)).with_name("other.toml").write_text(
        '[controller.axes."*"]\nfeedback = "motor"\n'
        'controller = {kind = "cascade", gains = {bandwidth = "80 rad/s", position_gain = "15 1/s"}}\n'
    )
    text = DRIVE + '\n[run]\nstart = "moving"\n'
    text += 'changes = [{at = "0.5 s", controller = "other.toml", handover_time = "5 ms"}]\n'
    case = load_scenario(written(text)).cases()[0]
    assert case.moving and [c.time for c in case.changes] == [0.5] and case.changes[0].handover_time == 5e-3
    again = load_scenario(written(dump(load_scenario(written(text))), "again.toml")).cases()[0]
    assert again.changes[0].controller == case.changes[0].controller and again.moving
    for wrong, said in (('at = "0.5 mm"', "at"), ('controller = "none.toml"', "none.toml"), ("at = -1", "at")):
        key = wrong.partition(" ")[0]
        broken = text.replace('at = "0.5 s"', wrong) if key == "at" else text.replace('controller = "other.toml"', wrong)
        assert said in refused("run", written(broken), "--check")
    learning = text + '\n[learning]\nlaw = {kind = "p-type", gain = 1}\n'
    assert "learning" in refused("run", written(learning), "--check")


@pytest.mark.slow
def test_the_shipped_part_ranks_schemes_as_documented() -> None:
    """The figures of ``compare``, without its search for causes: that runs the observed scheme thirty times, five seconds each."""
    rms = {}
    for name in ("PI cascade", "CNC compensation", "scheme III", "scheme III, observed"):
        case = load_scenario("builtin:backlash/part").case(name)
        reference = case.reference()
        run = cl.simulate(case.machine, case.controller, reference)
        rms[name] = cl.summarise(cl.judge(run, reference), reference).part_error.rms
    assert rms["scheme III"] < rms["CNC compensation"] < rms["PI cascade"]
    assert rms["scheme III, observed"] < 1.2 * rms["scheme III"]
    assert rms["PI cascade"] > 20e-6 > 10e-6 > rms["scheme III, observed"]  # as in docs/how-to/backlash.md


@pytest.mark.slow
def test_settings_without_effect_or_with_the_wrong_one_are_reported(
    written: Callable[..., str], capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    offset = (
        'compensation = {kind = "backlash-offset", backlash_gap = "50 um", backlash_velocity = "5 mm/s", backlash_acceleration = "1 m/s^2"}'
    )
    text = DRIVE.replace(MOTOR, f'velocity_feedback = "motor"\n{offset}').replace("30 1/s", "8 1/s")
    text += '\n[run]\nchanges = [{at = "100 s", controller = "other.toml"}]\n'
    Path(written(DRIVE)).with_name("other.toml").write_text(
        '[controller.axes."*"]\ncontroller = {kind = "cascade", gains = {bandwidth = "80 rad/s"}}\n'
    )
    out = output(capsys, "run", written(text), "--out", str(tmp_path / "o"))
    assert "CL101" in out and "CL104" in out
    route = f'{MOTOR}\n{OTHER}\nsupervisor = {{kind = "pre-routed", places = ["1 m"], numbers = [1]}}'
    assert "CL103" in output(capsys, "run", written(DRIVE.replace(MOTOR, route)), "--out", str(tmp_path / "o"))
    lines = f'{MOTOR}\n{OTHER}\nsupervisor = {{kind = "pre-routed", by = "line", lines = [3], numbers = [1]}}'
    assert "CL102" in output(capsys, "run", written(DRIVE.replace(MOTOR, lines)), "--out", str(tmp_path / "o"))


def test_a_supervisor_without_a_kind_is_the_performance_based_one(written: Callable[..., str]) -> None:
    text = DRIVE.replace(MOTOR, f'{MOTOR}\n{OTHER}\nsupervisor = {{thresholds = ["25 um"]}}')
    supervisor = load_scenario(written(text)).cases()[0].controller.axes["x"].supervisor
    assert supervisor is not None and supervisor.kind == "performance"


@pytest.mark.slow
def test_a_confident_but_wrong_observer_is_reported(written: Callable[..., str], capsys: pytest.CaptureFixture[str]) -> None:
    """33 kg on a lead of 10 mm with 103 N at 1 ms: friction holds the load while the motor crosses, and the gap is estimated too small."""
    text = DRIVE.replace('lead = "16 mm"', 'lead = "10 mm"').replace('motor_inertia = "52 kg*cm^2"', 'motor_inertia = "2 kg*cm^2"')
    text = (
        text.replace('load_inertia = "44 kg*cm^2"', 'mass = "33 kg"').replace('"950 N*m/rad"', '"253 N*m/rad"').replace('"40 N"', '"103 N"')
    )
    text = text.replace("substeps = 4", "substeps = 8").replace("150 rad/s", "100 rad/s").replace("30 1/s", "25 1/s")
    found = json.loads(output(capsys, "backlash", written(text.replace("8000 mm/min", "4000 mm/min"), gap="80 um"), "--json"))
    places = {one["place"] for one in found["schemes"]["base"]["findings"] if one["code"] == "CL382"}
    for name, axis in found["schemes"]["base"]["axes"].items():
        alone = axis["from_motor_alone"]
        wrong = abs(alone["gap"] - 80e-6) > max(3.0 * alone["deviation"], 20e-6) and alone["confidence"] >= 0.9
        assert wrong == (f"axis {name}" in places)
