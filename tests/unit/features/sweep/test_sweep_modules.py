"""Populations of modules: every pairing against a plain batch, intervals against a jackknife, lists of measured values."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from made_studies import asked, exported, made_study
from scipy import stats

from contourlab.cli.main import main
from contourlab.errors import ScenarioError
from contourlab.features.sweep.answers import _sorted_out
from contourlab.features.sweep.study import load_study
from contourlab.loop import simulate_batch
from contourlab.scenario.load import load_scenario
from contourlab.study.design import Design, Modules
from contourlab.study.statistics import effective_size, share_of, wilson

STUDY = """\
scenario = "scenario.toml"
chunk = 64
seed = 3
tolerance = "28 um"
correlations = [["axes.1.friction.coulomb", "axes.1.plant.gain", 0.5]]
[vary]
"axes.*.friction.coulomb" = { normal = ["100 %", "20 %"] }
"axes.*.plant.gain" = { uniform = ["90 %", "110 %"] }
scheme = { values = ["position loop", "all of it"] }
[modules]
axes.1 = 12
axes.3 = 10
"""


def test_every_pairing_is_that_of_a_plain_batch(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, store = made_study(tmp_path, STUDY), str(tmp_path / "store")
    assert main(["sweep", str(file), "--out", store]) == 0
    rows = asked(capsys, "query", store, "SELECT * FROM results WHERE scheme = 'all of it' ORDER BY variant")
    assert [(row["axes.1.module"], row["axes.3.module"]) for row in rows] == [(i, j) for i in range(12) for j in range(10)]
    names = [name for name in rows[0] if name.startswith("axes.") and not name.endswith(".module")]
    first = {i: next(row for row in rows if row["axes.1.module"] == i) for i in range(12)}
    second = {j: next(row for row in rows if row["axes.3.module"] == j) for j in range(10)}
    drawn = {name: [(first[i] if name.startswith("axes.1.") else second[j])[name] for i in range(12) for j in range(10)] for name in names}
    assert len(names) == 4 and all(len(set(values)) == (12 if name.startswith("axes.1.") else 10) for name, values in drawn.items())
    case = load_scenario(tmp_path / "scenario.toml").case("all of it")
    columns = {name: np.array(values) for name, values in drawn.items()}
    batch = simulate_batch(case.machine, case.controller, case.reference(), columns, part=True, moving=case.moving, seed=case.run.seed)
    error = batch.figures["part_error_max"].reshape(12, 10)
    assert [row["part_error_max"] for row in rows] == error.ravel().tolist()

    good = error <= 28e-6
    found = asked(capsys, "report", store)["answers"]
    assert found["pairings"]["choices"] == {"scheme": "all of it"} and found["pairings"]["passed"] == np.count_nonzero(good)
    assert [(kind["lowest"], kind["median"]) for kind in found["pairings"]["kinds"]] == [
        (good.mean(axis).min(), np.median(good.mean(axis))) for axis in (1, 0)
    ]
    worst = found["pairings"]["bad"][0]
    assert worst["share"] == min(good.mean(0).min(), good.mean(1).min())
    shown = asked(capsys, "show", store)["yield"]
    assert (shown["share"], shown["low"], shown["high"]) == pytest.approx((found["share"], found["low"], found["high"]), rel=1e-12)
    assert shown["low"] < wilson(found["passed"], found["judged"])[0]
    page = (tmp_path / "store/report.html").read_text(encoding="utf-8")
    assert page.count('id="matrix-') == 3


@pytest.mark.parametrize("kind", ["random", "sobol", "latin-hypercube"])
def test_a_module_is_the_same_in_all_its_pairings_and_chunks(kind: str) -> None:
    design = Design(kind, 5 * 7 * 3, 32, (0, 0, 0, 3), 1, (), (Modules("axes.x", 5, (0, 2)), Modules("axes.y", 7, (1,))))
    places = np.concatenate([design.places(k) for k in range(design.chunks)])
    members = {name: np.concatenate([design.members(k)[name] for k in range(design.chunks)]) for name in design.members(0)}
    assert len(set(zip(*members.values(), places[:, 3], strict=True))) == 105
    for column, own in ((0, "axes.x"), (2, "axes.x"), (1, "axes.y")):
        assert len(set(zip(members[f"{own}.module"], places[:, column], strict=True))) == len(set(members[f"{own}.module"]))
    if kind == "latin-hypercube":
        assert sorted((np.unique(places[:, 1]) * 7).astype(int)) == list(range(7))


def test_the_effective_size_is_that_of_a_jackknife_over_modules() -> None:
    draws = np.random.default_rng(0)
    good = draws.normal(size=(60, 1)) + draws.normal(size=(1, 40)) < 1.0
    share = good.mean()
    without = [(share * n - good.mean(1 - axis)) / (n - 1) for axis, n in enumerate(good.shape)]
    variance = sum((n - 1) / n * np.sum((left - left.mean()) ** 2) for left, n in zip(without, good.shape, strict=True))
    expected = share * (1.0 - share) / variance * (stats.norm.ppf(0.975) / stats.t.ppf(0.975, 39)) ** 2
    found = effective_size([(np.full(60, 40.0), good.sum(1)), (np.full(40, 60.0), good.sum(0))])
    assert found == pytest.approx(expected, rel=1e-9) and 10 < found < 80
    for everything in (np.zeros(60), np.full(60, 40.0)):
        assert effective_size([(np.full(60, 40.0), everything), (np.full(40, 60.0), np.full(40, everything[0] * 1.5))]) == 40.0


@pytest.mark.parametrize(
    ("draw", "truth"),
    [
        (lambda draws: draws.normal(size=(50, 1)) + draws.normal(size=(1, 40)) <= np.sqrt(2.0) * stats.norm.ppf(0.9), 0.9),
        (lambda draws: (draws.random((50, 1)) > 0.04) & (draws.random((1, 40)) > 0.02), 0.96 * 0.98),
    ],
    ids=["sum", "bad modules"],
)
def test_the_interval_covers_the_yield_of_all_modules(draw: Callable[[np.random.Generator], np.ndarray], truth: float) -> None:
    draws = np.random.default_rng(5)
    members = [member.ravel() for member in np.indices((50, 40))]
    hits = naive = 0
    for _ in range(300):
        good = draw(draws).ravel()
        _, _, low, high = share_of(good, members)
        hits += low <= truth <= high
        low, high = wilson(np.count_nonzero(good), good.size)
        naive += low <= truth <= high
    assert hits >= 0.92 * 300 > 0.5 * 300 > naive  # 95 % less two and a half deviations; pairings are not independent


def test_sorting_out_takes_the_worst_module_again_and_again() -> None:
    good = np.ones((6, 6), dtype=bool)
    good[2, :] = False
    good[0, 4] = good[1, 4] = good[5, 5] = False
    members = dict(zip(("x", "y"), (member.ravel() for member in np.indices(good.shape)), strict=True))
    bad = _sorted_out(good.ravel(), members, {"x": np.arange(6), "y": np.arange(6)})
    assert [(one.column, one.module) for one in bad] == [("x", 2), ("y", 4), ("x", 5)]
    assert [one.left for one in bad] == pytest.approx([27 / 30, 24 / 25, 1.0]) and [one.share for one in bad] == [0.0, 0.5, 5 / 6]
    alike = np.indices((6, 6)).sum(0) % 2 == 0
    for none in (np.zeros((6, 6), dtype=bool), alike):  # no module is worse than the others
        assert _sorted_out(none.ravel(), members, {"x": np.arange(6), "y": np.arange(6)}) == []


# --- lists -----------------------------------------------------------------------------------------------------------------------------

DRAWN = """\
scenario = "scenario.toml"
variants = 70
chunk = 32
seed = 4
[vary]
"axes.*.friction.coulomb" = { normal = ["100 %", "20 %"] }
scheme = { values = ["position loop", "all of it"] }
"""


@pytest.mark.slow
@pytest.mark.parametrize("suffix", [".csv", ".parquet"])
def test_an_exported_study_as_a_list_gives_the_same_figures(tmp_path: Path, capsys: pytest.CaptureFixture[str], suffix: str) -> None:
    made_study(tmp_path, DRAWN)
    assert main(["sweep", str(tmp_path / "study.toml"), "--out", str(tmp_path / "drawn")]) == 0
    assert main(["sweep", "export", str(tmp_path / "drawn"), "--to", str(tmp_path / f"measured{suffix}")]) == 0
    listed = made_study(tmp_path, f'scenario = "scenario.toml"\nchunk = 32\nlist = "measured{suffix}"\n', "listed.toml")
    left_out = [found for found in load_study(listed).findings if found.code == "CL924"]
    assert "variant" in left_out[0].values["columns"] and len(left_out[0].values["columns"]) == 10
    assert main(["sweep", str(listed), "--out", str(tmp_path / "listed")]) == 0
    assert len(exported(tmp_path / "drawn").splitlines()) == 71
    numbers = "SELECT part_error_max, contour_error_rms, scheme FROM results ORDER BY variant"
    assert asked(capsys, "query", str(tmp_path / "listed"), numbers) == asked(capsys, "query", str(tmp_path / "drawn"), numbers)


def test_measured_modules_are_paired(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "x.csv").write_text("serial;axes.1.friction.coulomb [full_scale]\nA7;0,065\nA8;0,075\nA9;0,09\n", encoding="utf-8")
    drawn = '"axes.*.friction.coulomb" = { uniform = ["90 %", "110 %"] }\n'  # of axis 1 the file says it
    text = f'scenario = "scenario.toml"\n[vary]\n{drawn}[modules]\naxes.1 = "x.csv"\naxes.3 = 4\n'
    assert main(["sweep", str(made_study(tmp_path, text)), "--out", str(tmp_path / "store")]) == 0
    sql = 'SELECT DISTINCT "axes.1.module", "axes.1.friction.coulomb" FROM results ORDER BY 1'
    found = asked(capsys, "query", str(tmp_path / "store"), sql)
    assert [tuple(row.values()) for row in found] == [(0, 0.065), (1, 0.075), (2, 0.09)]
    assert asked(capsys, "show", str(tmp_path / "store"))["done"] == 12


ONE = '"axes.*.plant.gain" = { uniform = ["90 %", "110 %"] }\n'


@pytest.mark.parametrize(
    ("top", "vary", "modules", "key"),
    [
        ("", ONE, "axes.2 = 5", "modules.axes.2"),
        ("", ONE, "axes.1 = 1", "modules.axes.1"),
        ("", ONE, "axes.1 = true", "modules.axes.1"),
        ("", ONE, "axes.1 = 'nowhere.csv'", "modules.axes.1"),
        ("", ONE, "axes.1 = 'machine.stl'", "modules.axes.1"),
        ("", ONE, "axes = 5\n'axes.1' = 5", "modules"),
        ("", ONE, "axes.1 = 5", "vary"),
        ("", ONE.replace("*", "1"), "axes.1 = 'named.csv'\naxes.3 = 5", "axes.1.plant.gain"),
        ("", ONE.replace("] }", "], together = true }"), "axes.1 = 5\naxes.3 = 5", "modules.axes.1"),
        ("variants = 5", ONE, "axes.1 = 5\naxes.3 = 5", "variants"),
        ("design = 'grid'", ONE, "axes.1 = 5\naxes.3 = 5", "design"),
        ("correlations = [['1.plant.gain', '3.plant.gain', 0.5]]", ONE, "axes.1 = 5\naxes.3 = 5", "correlations"),
        ("list = 'empty.csv'", "", "", "list"),
        ("list = 'holes.csv'", "", "", "axes.1.plant.gain"),
        ("list = 'mistyped.csv'", "", "", "vary.axes.1.plant.gian"),
        ("list = 'many.csv'", "", "", "axes.1.plant.gian"),
        ("list = 'unitless.csv'", "", "", "axes.1.plant.gain"),
        ("list = 'holes.csv'\ndesign = 'sobol'", "", "", "design"),
    ],
)
def test_a_fault_of_modules_or_lists_names_its_key(tmp_path: Path, top: str, vary: str, modules: str, key: str) -> None:
    (tmp_path / "empty.csv").write_text("serial\n1\n", encoding="utf-8")
    (tmp_path / "named.csv").write_text("axes.1.plant.gain [m/s^2/full_scale]\n1.7\n1.8\n", encoding="utf-8")
    (tmp_path / "holes.csv").write_text("axes.1.plant.gain [m/s^2/full_scale],n\n1.7,1\n,2\n", encoding="utf-8")
    (tmp_path / "mistyped.csv").write_text("axes.1.plant.gian [m/s^2/full_scale]\n1.7\n", encoding="utf-8")
    (tmp_path / "many.csv").write_text("axes.1.plant.gian [kg]\n" + "\n".join(map(str, range(300))), encoding="utf-8")
    (tmp_path / "unitless.csv").write_text("axes.1.plant.gain\n1.7\n", encoding="utf-8")
    text = f'scenario = "scenario.toml"\n{top}\n[vary]\n{vary}[modules]\n{modules}\n'
    with pytest.raises(ScenarioError) as caught:
        load_study(made_study(tmp_path, text))
    assert caught.value.key.startswith(key) and "\n" not in str(caught.value)
