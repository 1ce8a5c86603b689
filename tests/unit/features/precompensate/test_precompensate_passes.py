"""When passes stop, and what a folder keeps of them."""

from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import pytest

from contourlab.errors import ParameterError, ResultError
from contourlab.features.precompensate.law import Learned, Loop
from contourlab.features.precompensate.passes import AddedDwell, Passes, PassFigures, load, save
from contourlab.features.precompensate.writing import Written


def figures(number: int, rms: float, in_time: bool) -> PassFigures:
    return PassFigures(number, rms, rms, 1.0, (), (), in_time, 0.0, 1, (), 0.1)


@pytest.mark.parametrize(
    ("rms", "in_time", "helps", "best"),
    [
        ((9, 5, 4), "yyy", True, 2),
        ((9, 5, 4.99), "yyy", True, 2),
        ((99, 5, 4.99), "yyy", False, 2),
        ((9, 5, 4, 5.2), "yyyy", True, 2),
        ((9, 5, 4, 5.2, 4.1), "yyyyy", False, 2),
        ((9, 5, 4), "ynn", True, 0),
        ((9, 5, 4, 3), "ynnn", False, 0),
        ((9, 5, 4, 3, 3.5), "ynnyn", True, 3),
    ],
)
def test_passes_stop_when_they_no_longer_help(rms: tuple[float, ...], in_time: str, helps: bool, best: int) -> None:
    passes = Passes("", figures=tuple(figures(k, one, sign == "y") for k, (one, sign) in enumerate(zip(rms, in_time, strict=True))))
    assert passes.helps == helps
    assert passes.best == best


@pytest.mark.parametrize(
    ("largest", "best"),
    [((9, 9, 9), 2), ((9, 3, 8), 1), ((9, 3, 5), 2), ((9, 20, 14), 2), ((9, 20, 15), 0)],
)
def test_the_best_pass_has_the_least_sum_of_both_errors(largest: tuple[float, ...], best: int) -> None:
    rms = (10, 7, 4)
    passes = Passes("", figures=tuple(replace(figures(k, one, True), largest=largest[k]) for k, one in enumerate(rms)))
    assert passes.best == best


def test_a_folder_gives_back_what_was_saved_and_refuses_anything_else(tmp_path: Path) -> None:
    rows, one = np.random.default_rng(0).normal(size=(5, 2)), np.array([0.0, np.nan, np.inf, -1.0, 1e-300])
    learned = Learned(rows, -rows, one, one, rows, one, 1e-6)
    ran = PassFigures(0, 1e-5, 2e-5, 1.0, (0.1, 0.2), (1.0, 2.0), True, 0.3, 7, (0.01, -0.02), 0.125)
    written, loops = (Written("G1 X1", one, one, 3),), (Loop(), Loop(1e-3, bandwidth=40.0))
    passes = Passes(
        "mine", ("x", "y"), loops, 30.0, (ran,), learned, written, ("a",), (AddedDwell(4, 0.25, 4e-5), AddedDwell(9, 0.01, 1e-6))
    )
    assert load(tmp_path / "none", passes) is passes
    for kept in (passes, replace(passes, cutoff=20.0, learned=None)):  # the second replaces the first
        save(kept, tmp_path)
        again = load(tmp_path, Passes("mine"))
        np.testing.assert_equal(asdict(again), asdict(kept))
    assert (tmp_path / "pass-1.ngc").read_text(encoding="utf-8") == "G1 X1"
    with pytest.raises(ParameterError):
        load(tmp_path, Passes("of another program"))
    (part,) = tmp_path.glob("*/part-*.npz")
    data = bytearray(part.read_bytes())
    data[len(data) // 2] ^= 1
    part.write_bytes(data)
    with pytest.raises(ResultError):
        load(tmp_path, Passes("mine"))
