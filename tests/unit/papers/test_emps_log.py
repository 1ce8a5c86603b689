"""Reading the log of the EMPS benchmark; a message refuses invalid files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from contourlab.errors import LogError
from contourlab.papers.emps.log import read_emps

N = 40


def held() -> dict[str, object]:
    t = 1e-3 * np.arange(N)
    return {"t": t[:, None], "qm": t[:, None] ** 2, "qg": t, "vir": 2.0 * t, "kp": 160.0, "kv": 240.0, "gtau": np.array([[35.0]])}


def saved(file: Path, values: dict[str, object]) -> Path:
    from scipy.io import savemat

    savemat(file, values)
    return file


@pytest.mark.slow
def test_signals_and_gains_are_read_unchanged(tmp_path: Path) -> None:
    log = read_emps(saved(tmp_path / "log.mat", held()))
    assert (log.position_gain, log.velocity_gain, log.drive_gain) == (160.0, 240.0, 35.0)
    assert log.period == pytest.approx(1e-3)
    np.testing.assert_allclose(log.position, log.time**2)
    np.testing.assert_allclose(log.force, 70.0 * log.time)
    assert log.pulses.shape == (N,) and not log.pulses.any()


def test_pulses_are_read_if_present(tmp_path: Path) -> None:
    pulses = np.arange(N) % 7 == 0
    log = read_emps(saved(tmp_path / "log", held() | {"pulses_N": 5.0 * pulses}))
    np.testing.assert_array_equal(log.pulses, 5.0 * pulses)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("changed", "told"),
    [
        ({"vir": np.zeros(5)}, "vir has 5 samples, not 40"),
        ({"qm": np.r_[np.zeros(N - 1), np.nan]}, "qm is not finite at sample 39"),
        ({"gtau": "35 N/V"}, "has no gtau"),
        ({"kp": np.ones(2)}, "kp has 2 samples, not 1"),
        ({"kv": 0.0}, "kv = 0 is not a valid gain"),
        ({"pulses_N": np.ones(3)}, "pulses_N has 3 samples"),
        ({"t": 0.0}, "t has 1 samples, not 2"),
    ],
)
def test_invalid_values_are_refused(tmp_path: Path, changed: dict[str, object], told: str) -> None:
    file = saved(tmp_path / "log.mat", held() | changed)
    with pytest.raises(LogError, match=told) as refused:
        read_emps(file)
    assert str(refused.value).startswith(str(file))


@pytest.mark.slow
def test_files_that_are_not_logs_name_the_requirements(tmp_path: Path) -> None:
    text, folder = tmp_path / "text.mat", tmp_path / "folder"
    text.write_text("no matrix\n" * 50, encoding="utf-8")
    folder.mkdir()
    lacking = saved(tmp_path / "lacking.mat", {name: value for name, value in held().items() if name not in ("kp", "vir")})
    for file, told in (
        (tmp_path / "nowhere.mat", "cannot be read: No such file"),
        (folder, "is a folder"),
        (text, "cannot be read"),
        (lacking, "has no vir, kp"),
    ):
        with pytest.raises(LogError, match=told) as refused:
            read_emps(file)
        assert "DATA_EMPS.mat of Janot, Gautier & Brunot" in str(refused.value)
