"""``contourlab commission linuxcnc`` as typed."""

import json
from pathlib import Path

import made_commission as bench
import pytest

from contourlab.cli.main import main


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> bench.Made:
    return bench.made(tmp_path_factory.mktemp("machine"))


def test_first_call_says_what_to_type_next(made: bench.Made, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["commission", "linuxcnc", str(made.ini), str(made.hal), "--out", str(tmp_path)]) == 0
    assert "--log log1.txt" in capsys.readouterr().out
    assert main(["check", str(tmp_path / "excite.ngc")]) == 0


def test_errors_set_the_exit_code_and_leave_no_gains(made: bench.Made, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rows = made.rows | {f"{axis} [mm]": -made.rows[f"{axis} [mm]"] for axis in "xy"}
    log = made.log(tmp_path / "log.csv", rows)
    assert main(["commission", "linuxcnc", str(made.ini), str(made.hal), "--log", str(log), "--out", str(tmp_path / "out"), "--json"]) == 1
    result = json.loads(capsys.readouterr().out)
    assert result["pid"] == {}
    assert [one["place"] for one in result["findings"] if one["code"] == "CL876"] == ["axis x", "axis y"]


def test_inputs_are_not_replaced(made: bench.Made, tmp_path: Path) -> None:
    hal = tmp_path / "sampler.hal"
    hal.write_text(made.hal.read_text())
    assert main(["commission", "linuxcnc", str(made.ini), str(hal), "--out", str(tmp_path)]) == 2
    assert hal.read_text() == made.hal.read_text()


@pytest.mark.parametrize("missing", ["machine.ini", "machine.hal"])
def test_missing_files_are_named(made: bench.Made, tmp_path: Path, capsys: pytest.CaptureFixture[str], missing: str) -> None:
    files = {"machine.ini": made.ini, "machine.hal": made.hal} | {missing: tmp_path / missing}
    assert main(["commission", "linuxcnc", *map(str, files.values()), "--out", str(tmp_path)]) == 2
    assert missing in capsys.readouterr().err


def test_unknown_control_is_refused_before_any_work(made: bench.Made, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = made.log(tmp_path / "log.csv")
    out = tmp_path / "out"
    assert main(["commission", "linuxcnc", str(made.ini), str(made.hal), "--log", str(log), "--for", "fanuc", "--out", str(out)]) == 2
    assert "sinumerik" in capsys.readouterr().err
    assert not out.exists()
