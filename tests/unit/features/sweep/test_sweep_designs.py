"""Designs and distributions against closed forms and scipy."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from made_studies import STUDY, made_study
from scipy import stats

from contourlab.errors import ScenarioError
from contourlab.features.sweep.study import load_study
from contourlab.study.design import Design
from contourlab.study.space import Distribution, chosen
from contourlab.study.statistics import wilson

PLACES = np.linspace(0.001, 0.999, 997)


@pytest.mark.parametrize("kind", ["random", "sobol", "latin-hypercube"])
def test_a_chunk_is_the_same_alone_and_in_a_longer_study(kind: str) -> None:
    short, long = (Design(kind, n, 64, (0, 0, 0), seed=5) for n in (100, 1000))
    assert np.array_equal(short.places(0), long.places(0))
    assert np.array_equal(short.places(1), long.places(1)[:36])
    assert not np.array_equal(long.places(0), long.places(1))
    assert not np.array_equal(long.places(0), replace(long, seed=6).places(0))


def test_sobol_chunks_are_one_sequence() -> None:
    design = Design("sobol", 256, 64, (0, 0), seed=1)
    whole = np.concatenate([design.places(k) for k in range(4)])
    for column in whole.T:  # each of 256 intervals has one point
        assert sorted((column * 256).astype(int)) == list(range(256))


def test_each_chunk_is_a_latin_hypercube() -> None:
    design = Design("latin-hypercube", 256, 64, (0, 0), seed=1)
    for k in range(4):
        for column in design.places(k).T:
            assert sorted((column * 64).astype(int)) == list(range(64))


def test_a_grid_has_every_combination_once_and_a_list_its_rows() -> None:
    grid = Design("grid", 30, 8, (2, 3, 5))
    codes = [np.column_stack([chosen(grid.places(k)[:, i], n) for i, n in enumerate((2, 3, 5))]) for k in range(4)]
    assert np.concatenate(codes).tolist() == [[i, j, k] for i in range(2) for j in range(3) for k in range(5)]
    rows = Design("list", 50, 32, (50, 50)).places(1)
    assert chosen(rows[:, 0], 50).tolist() == chosen(rows[:, 1], 50).tolist() == list(range(32, 50))


def test_correlated_draws_have_the_correlation_of_the_copula() -> None:
    factor = tuple(map(tuple, np.linalg.cholesky([[1.0, 0.8], [0.8, 1.0]])))
    design = Design("random", 8192, 2048, (0, 0), seed=1, factor=factor)
    places = np.concatenate([design.places(k) for k in range(4)])
    normal = stats.norm.ppf(places)
    assert np.corrcoef(normal.T)[0, 1] == pytest.approx(0.8, abs=0.02)  # five deviations: 5 (1 - 0.8^2) / sqrt(8192)
    for column in places.T:
        assert stats.kstest(column, "uniform").pvalue > 1e-3


@pytest.mark.parametrize(
    ("made", "law"),
    [
        (Distribution("normal", (2.0, 1.0)), stats.norm(2.0, 1.0)),
        (Distribution("normal", (2.0, 1.0), low=0.0, high=3.0), stats.truncnorm(-2.0, 1.0, 2.0, 1.0)),
        (Distribution("lognormal", (2.0, 0.5)), stats.lognorm(0.5, scale=2.0)),
        (Distribution("uniform", (2.0, 5.0)), stats.uniform(2.0, 3.0)),
        (Distribution("log-uniform", (2.0, 50.0)), stats.loguniform(2.0, 50.0)),
        (Distribution("triangular", (2.0, 3.0, 7.0)), stats.triang(0.2, 2.0, 5.0)),
    ],
)
def test_distributions_are_those_of_scipy(made: Distribution, law: stats.rv_continuous) -> None:
    assert made.values(PLACES) == pytest.approx(law.ppf(PLACES), rel=1e-9)


def test_a_cut_distribution_stays_within_its_ends() -> None:
    made = Distribution("lognormal", (2.0, 0.5), low=1.0, high=3.0)
    assert made.beyond == pytest.approx(stats.lognorm(0.5, scale=2.0).cdf(1.0) + stats.lognorm(0.5, scale=2.0).sf(3.0))
    values = made.values(np.array([0.0, 0.5, 1.0]))
    assert values[0] == pytest.approx(1.0) and values[2] == pytest.approx(3.0) and (values >= 1.0).all() and (values <= 3.0).all()
    assert math.isfinite(Distribution("normal", (0.0, 1.0)).values(np.array([0.0]))[0])


def test_weights_are_shares() -> None:
    places = (np.arange(1000) + 0.5) / 1000
    assert np.bincount(chosen(places, 3, (1.0, 0.0, 3.0))).tolist() == [250, 0, 750]


@pytest.mark.parametrize(("passed", "judged"), [(0, 10), (7, 10), (9990, 10000)])
def test_the_interval_is_that_of_scipy(passed: int, judged: int) -> None:
    known = stats.binomtest(passed, judged).proportion_ci(0.95, method="wilson")
    assert wilson(passed, judged) == pytest.approx((known.low, known.high), abs=1e-12)


# --- study files -----------------------------------------------------------------------------------------------------------------------


def varied(entry: str, top: str = "") -> str:
    return f'scenario = "scenario.toml"\nvariants = 10\n{top}\n[vary]\n{entry}\n'


@pytest.mark.parametrize(
    ("text", "key"),
    [
        (varied('"axes.1.plant.gian" = { normal = ["100 %", "5 %"] }'), "vary"),
        (varied('"plant.gian" = { values = [1] }'), "vary"),
        (varied("axes.1.plant.gain = 3"), "vary"),
        (varied('"axes.1.plant.gain" = { norma = ["100 %", "5 %"] }'), "vary"),
        (varied('"axes.1.plant.gain" = { normal = ["100 %"] }'), "vary"),
        (varied('"axes.1.plant.gain" = { normal = ["100 %", "0 %"] }'), "vary"),
        (varied('"axes.1.plant.gain" = { uniform = ["2 kg", "3 kg"] }'), "vary"),
        (varied('"axes.1.plant.gain" = { uniform = ["110 %", "90 %"] }'), "vary"),
        (varied('"axes.1.plant.gain" = { uniform = ["-10 %", "90 %"] }'), "vary"),
        (varied('"axes.1.plant.gain" = { normal = ["-90 %", "0.1 %"] }'), "vary"),
        (varied('"axes.1.plant.gain" = { normal = ["100 %", "5 %"], steps = 3 }'), "vary"),
        (varied('"axes.1.plant.gain" = { normal = ["100 %", "5 %"], within = ["1 kg"] }'), "vary"),
        (varied('"axes.1.plant.gain" = { values = ["100 %"], weights = [1, 2] }'), "vary"),
        (varied('"axes.1.plant.gain" = { uniform = ["90 %", "110 %"] }\n"*.gain" = { values = ["100 %"] }'), "vary"),
        (varied('"feed.frequency" = { uniform = ["1 Hz", "2 Hz"] }'), "vary"),
        (varied('"feed.frequenzy" = { values = ["1 Hz", "2 Hz"] }'), "vary"),
        (varied(""), "vary"),
        (varied('"axes.1.plant.gain" = { values = ["100 %"] }', "figures = ['contour']"), "figures"),
        (varied('"axes.1.plant.gain" = { values = ["100 %"] }', "signals = ['positions']"), "signals"),
        (varied('"axes.1.plant.gain" = { values = ["100 %"] }', "chunk = 100"), "chunk"),
        (varied('"axes.1.plant.gain" = { values = ["100 %"] }', "design = 'grid'"), "variants"),
        (varied('"axes.1.plant.gain" = { values = ["100 %"] }', "scheme = 'none of it'"), "scheme"),
        (varied('scheme = { values = ["all of it", "none of it"] }'), "vary.scheme.values"),
        (varied('"axes.1.plant.gain" = { values = ["100 %"] }', "list = 'nowhere.csv'").replace("variants = 10\n", ""), "list"),
        (varied('"axes.1.plant.gain" = { values = ["100 %"] }', "correlations = [['1.plant.gain', '3.plant.gain', 0.5]]"), "correlations"),
        (varied('"axes.*.plant.gain" = { values = ["100 %"] }', "correlations = [['1.plant.gain', '3.plant.gain', 2]]"), "correlations"),
        (varied('"axes.1.plant.gain" = { values = ["100 %"] }').replace("scenario.toml", "nowhere.toml"), "scenario"),
        (varied('"axes.1.plant.gain" = { values = ["100 %"] }').replace("variants = 10\n", ""), ""),
        (varied('"axes.1.plant.gain" = { uniform = ["90 %", "110 %"] }', "design = 'list'").replace("variants = 10\n", ""), "vary"),
    ],
)
def test_a_fault_of_a_study_names_its_key(tmp_path: Path, text: str, key: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        load_study(made_study(tmp_path, text))
    assert caught.value.key.startswith(key)
    assert Path(caught.value.file).name == "study.toml"
    assert "\n" not in str(caught.value) and "Errno" not in str(caught.value)


def test_what_a_study_leaves_out_is_a_finding(tmp_path: Path) -> None:
    text = STUDY.replace('scheme = "all of it"\n', "").replace('"20 %"', '"50 %"')
    findings = {found.code: found for found in load_study(made_study(tmp_path, text)).findings}
    assert findings["CL921"].values["share"] == pytest.approx(stats.norm.sf(2.0))
    assert list(findings["CL920"].values["schemes"]) == ["'position loop'", "'all of it'"]
