"""Commands never overwrite their inputs, nor files that contourlab did not write."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from typed_commands import CIRCLE, Finished, Refused, contents

from contourlab.app.results import LIST, staged
from contourlab.cli.main import main

IDENTIFY = ("identify", "log.csv", "--validation", "second.csv", "--columns", "columns.toml", "--write")


@pytest.fixture
def here(circle: Finished, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working folder with the results of a run and of a swap, which wrote a controller."""
    shutil.copytree(circle.folder, tmp_path / "results")
    with staged(tmp_path / "results", "swap.json") as stage:
        (stage / "controllers").mkdir()
        for name, text in {"swap.json": "{}", "controllers/shared.toml": "# of a swap\n"}.items():
            (stage / name).write_text(text, encoding="utf-8")
    for name in ("log.csv", "second.csv", "columns.toml"):
        (tmp_path / name).write_text("of the user\n", encoding="utf-8")
    (tmp_path / "link.csv").symlink_to(tmp_path / "log.csv")
    (tmp_path / "circle.toml").write_text(CIRCLE, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("out", ["log.csv", "./log.csv", "link.csv", "results/../second.csv", "columns.toml"])
def test_identify_does_not_write_over_what_it_reads(here: Path, refused: Refused, out: str) -> None:
    before = contents(here)
    assert refused(*IDENTIFY, out).startswith(f"contourlab: --write = '{Path(out)}': ")
    assert contents(here) == before


@pytest.mark.parametrize(
    "words",
    [
        ["measure", "results/signals/position-loop.nc"],
        ["measure", "results/signals/all-of-it.nc", "--out", "./results"],
        ["compare", "results/signals/all-of-it.nc", "results/signals/position-loop.nc", "--out", "results"],
    ],
)
@pytest.mark.slow
def test_a_run_that_would_be_replaced_is_not_measured_into_its_own_folder(here: Path, refused: Refused, words: list[str]) -> None:
    before = contents(here)
    said = refused(*words)
    assert "--out" in said and words[1] in said
    assert contents(here) == before


def test_the_list_of_a_folder_may_be_lost(here: Path, refused: Refused) -> None:
    (here / "results" / LIST).unlink()
    before = contents(here)
    assert "position-loop.nc" in refused("measure", "results/signals/position-loop.nc")
    assert refused("run", "circle.toml").startswith("contourlab: results/summary.json: ")
    assert contents(here) == before


@pytest.mark.slow
def test_a_measured_run_takes_the_place_of_a_run_only(here: Path) -> None:
    """A controller of a swap stays, and so does a user's file in the results folder."""
    (here / "results" / "signals" / "bench.nc").write_text("of the user", encoding="utf-8")
    (here / "run.nc").write_bytes((here / "results" / "signals" / "position-loop.nc").read_bytes())
    before = contents(here)
    assert main(["measure", "run.nc", "--plots", "svg"]) == 0
    after = contents(here / "results")
    kept = {"controllers/shared.toml", "swap.json", "signals/bench.nc"}
    assert {name: after[name] for name in kept} == {name: before[f"results/{name}"] for name in kept}
    assert {name for name in after if name.startswith("signals/")} == {"signals/run.nc", "signals/bench.nc"}
    assert main(["measure", "run.nc"]) == 0
    assert not (here / "results" / "plots").exists()


def test_a_swap_does_not_replace_the_controller_that_it_runs_under(here: Path, refused: Refused) -> None:
    from contourlab.scenario import builtin_file

    controller = here / "results" / "controllers" / "shared.toml"
    controller.write_bytes(builtin_file("ghaffari/calibrated").read_bytes())
    (here / "s.toml").write_text(CIRCLE.replace("builtin:ghaffari/calibrated", "results/controllers/shared.toml"), encoding="utf-8")
    swap = ["swap", "--axis", "3", "--with", "builtin:ghaffari/axis2"]
    before = contents(here)
    for words in (["s.toml"], ["circle.toml", "--from", "results/controllers/shared.toml"]):
        said = refused(swap[0], words[0], *swap[1:], *words[1:])
        assert "results/controllers/shared.toml" in said.replace("\\", "/")
    assert contents(here) == before


@pytest.mark.slow
def test_pictures_of_an_analysis_replace_their_namesakes_only(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (here / "two.toml").write_text(CIRCLE + '[schemes."a/b"]\n', encoding="utf-8")
    (here / "results" / "plots").mkdir()
    (here / "results" / "plots" / "mine.svg").write_text("of the user", encoding="utf-8")
    before = contents(here / "results")
    for _ in range(2):
        assert main(["analyse", "two.toml", "--plots", "svg"]) == 0
    drawn = [line for line in capsys.readouterr().out.splitlines() if line.replace("\\", "/").startswith("results/plots/")]
    assert drawn and all(Path(line).is_file() for line in drawn)
    after = contents(here / "results")
    assert after.items() >= {name: text for name, text in before.items() if name != LIST}.items()


def test_interpolate_does_not_write_over_its_signals(here: Path, refused: Refused) -> None:
    (here / "interpolated.csv").write_text("u1,u2\n", encoding="utf-8")
    before = contents(here)
    said = refused("interpolate", "interpolated.csv", "--out", ".")
    assert "--out" in said and "interpolated.csv" in said
    assert contents(here) == before
