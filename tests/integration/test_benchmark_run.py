"""`make bench`: each row names its own reference, and does the same work as the C."""

from __future__ import annotations

import importlib
import math
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

FOLDER = Path(__file__).parents[2] / "benchmarks"


@pytest.fixture
def bench(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The benchmark as a module."""
    monkeypatch.syspath_prepend(FOLDER)
    return importlib.import_module("run")


def test_a_row_has_a_ratio_to_its_own_reference(bench: ModuleType) -> None:
    rows = bench.Bench()
    rows.add("c", 2.0, 0.0)
    rows.add("c lanes", 1.0, 0.0)
    rows.add("ours", 3.0, 0.0, reference="c lanes")
    rows.add("others", 3.0, 0.0, reference="left out without a compiler")
    assert [(row["ratio_to_c"], row["reference"], row["ratio"]) for row in rows.rows] == [
        (1.0, None, None),
        (0.5, None, None),
        (1.5, "c lanes", 3.0),
        (1.5, "left out without a compiler", None),
    ]


@pytest.mark.slow
def test_c_and_rows_do_the_same_work(bench: ModuleType, tmp_path: Path) -> None:
    if not bench.references.compiler():
        pytest.skip("no C compiler")
    contenders = [*bench.on_circle(), *bench.with_backlash(), *bench.with_five_axes(), *bench.judging(tmp_path)]
    errors = {one.name: np.abs(one.work()) for one in contenders}
    for one in contenders:
        if one.reference is None:
            assert one.name.startswith("c")
        else:
            # Counts of the encoder and contacts enlarge the rounding of the stage with backlash, to 2e-12 of the rms.
            most = 1e-9 if "backlash" in one.name else 1e-11
            assert bench.rms(errors[one.name]) == pytest.approx(bench.rms(errors[one.reference]), rel=most, abs=0.0)


@pytest.mark.slow
def test_the_row_of_a_gpu_stands_beside_the_processor(a_gpu: None, bench: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bench, "WIDE", 64)
    rows = bench.Bench()
    bench.bench_judged(rows, 1)
    processor, gpu = rows.rows
    assert gpu["reference"] == processor["name"]
    assert gpu["rms"] == processor["rms"]


@pytest.mark.slow
def test_each_estimator_and_coupling_has_its_row(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(FOLDER)
    couplings = importlib.import_module("couplings")
    rows = couplings.rows_for(2, 1)
    for row in rows:
        row.once()
    assert [row.name for row in rows] == [couplings.NOTHING, *couplings.ESTIMATORS, *couplings.COUPLINGS, *couplings.OBSERVERS]
    assert all(0.0 < row.best < math.inf for row in rows)
