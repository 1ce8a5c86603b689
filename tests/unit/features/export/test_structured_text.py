"""Exported Structured Text: parsed and executed from its syntax tree, it computes the commands of plain Python."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from exported_axes import CASES, REFUSED, excited, exported
from structured_text import FunctionBlock

from contourlab.engine.translate.structured_text import input_name, plain, twincat

pytest.importorskip("blark", reason="blark is not installed")


def commands(file: Path, case: str, text: str) -> tuple[np.ndarray, np.ndarray]:
    """Return the commands of the function block and of plain Python on one run."""
    file.write_text(text)
    block, run = FunctionBlock(file), excited(exported(case), 120)
    assert block(enable=False) == 0.0
    fed = (dict(zip(map(input_name, run.names), row, strict=True)) for row in run.inputs.tolist())
    return np.array([block(enable=True, **row) for row in fed]), run.command


@pytest.mark.slow
@pytest.mark.parametrize("case", [case for case in CASES if case not in REFUSED])
def test_it_computes_the_commands_of_plain_python(tmp_path: Path, case: str) -> None:
    block, python = commands(tmp_path / "axis_x.st", case, plain(exported(case).control))
    if any(op.kind == "tanh" for op in exported(case).control.operations):  # made of EXP
        np.testing.assert_allclose(block, python, rtol=0.0, atol=1e-14 * np.abs(python).max())
    else:
        np.testing.assert_array_equal(block, python)


@pytest.mark.slow
def test_twincat_holds_the_same_block(tmp_path: Path) -> None:
    made = exported("observer/disturbance-observer").control
    text = twincat(made)
    block, python = commands(tmp_path / "axis_x.TcPOU", "observer/disturbance-observer", text)
    np.testing.assert_array_equal(block, python)
    assert twincat(made) == text


@pytest.mark.slow
def test_enable_starts_from_rest(tmp_path: Path) -> None:
    file = tmp_path / "axis_x.st"
    file.write_text(plain(exported("controller/position").control))
    block = FunctionBlock(file)
    words = {"reference_position": 0.25, "reference_velocity": 0.0, "reference_acceleration": 0.0}
    first = [block(enable=True, position=0.2499, **words) for _ in range(5)]
    assert block(enable=False) == 0.0
    assert [block(enable=True, position=0.2499, **words) for _ in range(5)] == first
    assert first[0] > 0.0
