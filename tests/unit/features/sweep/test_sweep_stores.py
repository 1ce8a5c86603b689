"""Stores as typed: resumed, divided, damaged, foreign, locked, full; and questions to them."""

from __future__ import annotations

import contextlib
import csv
import errno
import io
import itertools
import json
import math
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from each import each
from made_studies import STUDY, as_older, asked, exported, forged, made_study
from once import once

from contourlab import load_scenario, simulate_batch
from contourlab.cli.main import main
from contourlab.features.sweep.query import spreads
from contourlab.features.sweep.store import read_store
from contourlab.result import Result

Capture = pytest.CaptureFixture[str]


@pytest.fixture
def study(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return made_study(tmp_path)


@pytest.fixture(scope="session")
def finished(tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> Path:
    """A finished store, made once for all workers; nobody changes it."""

    def run() -> Path:
        folder = tmp_path_factory.mktemp("study")
        made_study(folder)
        with contextlib.chdir(folder):
            assert main(["sweep", "study.toml", "--out", "whole"]) == 0
        return folder / "whole"

    store: Path = once(tmp_path_factory, worker_id, "finished study", run)
    return store


@pytest.fixture
def whole(study: Path, finished: Path) -> Path:
    """A copy of the finished store, to damage."""
    shutil.copytree(finished, "whole")
    return Path("whole")


def test_a_study_has_the_figures_of_a_batch(whole: Path, capsys: Capture) -> None:
    rows = list(csv.DictReader(io.StringIO(exported(whole).decode())))
    assert [int(row["variant"]) for row in rows] == list(range(100))
    case = load_scenario("scenario.toml").case("all of it")
    names = {name.partition(" [")[0]: name for name in rows[0]}
    columns = {name: [float(row[names[name]]) for row in rows] for name in names if name.startswith("axes.")}
    assert set(columns) == {"axes.1.friction.coulomb", "axes.3.friction.coulomb", "axes.1.plant.gain"}
    batch = simulate_batch(case.machine, case.controller, case.reference(), columns, moving=case.moving)
    largest = np.array([float(row["contour_error_max [m]"]) for row in rows])
    assert np.array_equal(largest, batch.figures["contour_error_max"])
    shown = asked(capsys, "show", "whole")
    assert shown["statuses"] == {"ok": 100, "unsure": int(np.count_nonzero(batch.unsure))}
    assert shown["figures"]["contour_error_max"]["median"] == pytest.approx(np.median(largest), rel=1e-12)
    passed = int(np.count_nonzero(largest <= 27.8e-6))
    assert (shown["yield"]["passed"], shown["yield"]["judged"]) == (passed, 100) and 0 < passed < 100
    (row,) = asked(capsys, "worst", "whole", "1", "--figure", "contour_error_max")
    assert main(["sweep", "worst", "whole"]) == 0 and capsys.readouterr().err == ""
    assert row["variant"] == int(np.argmax(largest))


def test_parts_make_the_whole(whole: Path, capsys: Capture) -> None:
    words = ["study.toml", "--out", "half", "--chunks"]
    first = asked(capsys, *words, "0:2")
    assert (first["done"], first["chunks_made"]) == (64, 2) and "CL931" in {found["code"] for found in first["findings"]}
    assert main(["sweep", "show", "half"]) == 0 and "0 of 4" not in capsys.readouterr().out
    for words in (["worst", "half"], ["query", "half", "SELECT count(*) FROM results"]):
        assert main(["sweep", *words]) == 0 and "CL931" in capsys.readouterr().err
    assert asked(capsys, "study.toml", "--out", "rest", "--chunks", "1:")["done"] == 68
    assert asked(capsys, "merge", "half", "rest", "--out", "both")["done"] == 100
    rest = asked(capsys, "study.toml", "--out", "half", "--resume")
    assert (rest["chunks_made"], rest["chunks_done"]) == (2, 4)
    assert exported(Path("half")) == exported(Path("both")) == exported(whole)
    assert asked(capsys, "study.toml", "--out", "new", "--resume", "--workers", "1")["chunks_made"] == 4
    assert asked(capsys, "study.toml", "--out", "new", "--resume")["chunks_made"] == 0
    assert {path.name for path in Path("new").glob("part-*")} == {path.name for path in whole.glob("part-*")}


def test_a_damaged_file_is_found_and_computed_again(whole: Path, capsys: Capture) -> None:
    rows = exported(whole)
    file = sorted(whole.glob("part-*"))[2]
    data = bytearray(file.read_bytes())
    data[len(data) // 2] ^= 1
    file.write_bytes(data)
    for words in (["show", "whole"], ["export", "whole", "--to", "a.csv"], ["merge", "whole", "--out", "other"]):
        assert main(["sweep", *words]) == 2
        assert capsys.readouterr().err.startswith(f"contourlab: {file}")
    again = asked(capsys, "study.toml", "--out", "whole", "--resume")
    assert again["chunks_made"] == 1 and "CL930" in {found["code"] for found in again["findings"]}
    assert exported(whole) == rows


def test_a_chunk_under_another_number_is_found_and_computed_again(whole: Path, capsys: Capture) -> None:
    rows = exported(whole)
    for older in (False, True):  # by its digest; by its variants
        if older:
            as_older(whole)
        first, second = (next(whole.glob(f"part-{number:06d}-*")) for number in (1, 2))
        second.unlink()
        moved = whole / first.name.replace("000001", "000002")
        first.replace(moved)
        for words in (["show", "whole"], ["worst", "whole"], ["export", "whole", "--to", "a.csv"], ["merge", "whole", "--out", "other"]):
            assert main(["sweep", *words]) == 2
            told = capsys.readouterr().err
            assert told.startswith(f"contourlab: {moved}") and ("--resume" in told) is not older  # an older store is only read
        if older:
            break
        again = asked(capsys, "study.toml", "--out", "whole", "--resume")
        assert again["chunks_made"] == 2 and "CL930" in {found["code"] for found in again["findings"]}
        assert exported(whole) == rows and sorted(read_store(whole).parts) == [0, 1, 2, 3]


def test_a_chunk_of_another_study_is_found(whole: Path, capsys: Capture) -> None:
    rows = exported(whole)
    Path("study.toml").write_text(STUDY.replace("seed = 3", "seed = 4"))
    assert main(["sweep", "study.toml", "--out", "other", "--chunks", "1:2"]) == 0
    (stranger,) = Path("other").glob("part-*")
    (whole / stranger.name).write_bytes(stranger.read_bytes())
    next(file for file in whole.glob("part-000001-*") if file.name != stranger.name).unlink()
    capsys.readouterr()
    assert main(["sweep", "show", "whole"]) == 2
    assert capsys.readouterr().err.startswith(f"contourlab: {whole / stranger.name}")
    Path("study.toml").write_text(STUDY)
    assert asked(capsys, "study.toml", "--out", "whole", "--resume")["chunks_made"] == 1
    assert exported(whole) == rows


def test_an_older_store_is_read_merged_and_named_as_such(whole: Path, capsys: Capture) -> None:
    rows, passed = exported(whole), asked(capsys, "show", "whole")["yield"]
    as_older(whole)
    shown = asked(capsys, "show", "whole")
    assert shown["yield"] == passed and "CL935" in {found["code"] for found in shown["findings"]}
    for words in (["worst", "whole"], ["query", "whole", "SELECT 1"]):
        assert main(["sweep", *words]) == 0 and "CL935" in capsys.readouterr().err
    assert "CL935" in {found["code"] for found in asked(capsys, "report", "whole")["answers"]["findings"]}
    assert asked(capsys, "merge", "whole", "--out", "both")["done"] == 100
    assert exported(whole) == exported(Path("both")) == rows
    assert main(["sweep", "study.toml", "--out", "whole", "--resume"]) == 2


WRONG = (None, True, -1, 0, 7, 1.5, "x", [], [7], ["x"], {}, {"x": None}, {"x": "m"}, 10**30)
READERS = (
    ["show", "whole"],
    ["query", "whole", "SELECT * FROM results"],
    ["worst", "whole"],
    ["worst", "whole", "--rerun", "5"],
    ["report", "whole", "--out", "page.html"],
    ["merge", "whole", "--out", "merged"],
    ["export", "whole", "--to", "a.csv"],
    ["study.toml", "--out", "whole", "--resume"],
    ["optimise", "study.toml", "--out", "whole", "--resume"],
)


def edits(fields: dict[str, object]) -> Iterator[dict[str, object]]:
    """Yield a manifest without each of its keys, and with each wrong."""
    for key, value in fields.items():
        yield {name: other for name, other in fields.items() if name != key}
        yield from ({**fields, key: wrong} for wrong in WRONG if wrong != value)
    yield {**fields, "more": 1}


def test_an_edited_manifest_is_refused_by_every_command(whole: Path, capsys: Capture) -> None:
    fields = json.loads((whole / "manifest.json").read_text())
    texts = [json.dumps(edited) for edited in edits(fields)]
    texts += [json.dumps(fields).replace("1695", "1696"), "", "{", "[]", "null", "[" * 100_000, '{"schema": NaN}', "\x00"]
    assert len(texts) > 200
    for number, text in enumerate(texts):  # each key by all commands, each text by two of them
        (whole / "manifest.json").write_text(text)
        for words in [READERS[(number + step) % len(READERS)] for step in (0, 4)] if number < len(texts) - 8 else READERS:
            assert main(["sweep", *words]) == 2, (words, text[:300])
            assert "manifest.json" in capsys.readouterr().err


@pytest.mark.slow
def test_whatever_the_manifest_of_an_older_store_says_no_command_breaks(whole: Path, capsys: Capture) -> None:
    as_older(whole)
    fields = json.loads((whole / "manifest.json").read_text())
    (one,) = fields["structures"]
    deep = [{**fields, "structures": [{**one, key: wrong}]} for key in ("choices", "scenario") for wrong in WRONG]
    read = 0
    for number, edited in enumerate((*edits(fields), *deep)):  # each key by all commands, each text by two of them
        (whole / "manifest.json").write_text(json.dumps(edited))
        for words in [READERS[(number + step) % 7] for step in (0, 3)]:
            shutil.rmtree("merged", ignore_errors=True)
            code = main(["sweep", *words])
            assert code in (0, 1, 2), (words, edited)
            read += code == 0
            capsys.readouterr()
    assert read > 20  # a seed, tolerance or text is any


CHANGES = [("seed = 3", "seed = 4"), ('"20 %"', '"21 %"'), ("chunk = 32", "chunk = 64"), ("all of it", "position loop")]


@pytest.mark.slow
@pytest.mark.parametrize("change", CHANGES)
def test_the_store_of_another_study_is_refused(whole: Path, capsys: Capture, change: tuple[str, str]) -> None:
    Path("study.toml").write_text(STUDY.replace(*change))
    before = {path.name for path in whole.iterdir()}
    assert main(["sweep", "study.toml", "--out", "whole", "--resume"]) == 2
    assert main(["sweep", "study.toml", "--out", "other", "--chunks", "0:1"]) == 0
    assert main(["sweep", "merge", "whole", "other", "--out", "both"]) == 2
    assert {path.name for path in whole.iterdir()} == before


def test_a_comment_or_another_tolerance_is_the_same_study(whole: Path, capsys: Capture) -> None:
    assert main(["sweep", "merge", "whole", "--out", "before"]) == 0
    Path("study.toml").write_text('# Which are perfect?\ntolerance = "1 nm"\n' + STUDY)
    again = asked(capsys, "study.toml", "--out", "whole", "--resume")
    assert (again["chunks_made"], again["yield"]["tolerance"], again["yield"]["passed"]) == (0, pytest.approx(1e-9), 0)
    assert asked(capsys, "report", "whole")["answers"]["question"] == "Which are perfect?"
    assert asked(capsys, "show", "before")["yield"]["passed"] > 0
    assert main(["sweep", "merge", "before", "whole", "--out", "both"]) == 2 and not Path("both").exists()


def test_folders_that_are_no_store_of_this_study_stay(whole: Path, capsys: Capture) -> None:
    Path("full").mkdir()
    Path("full/notes.txt").write_text("mine")
    for words in (["--out", "whole"], ["--out", "full"], ["--out", "full", "--resume"], ["--out", "full/notes.txt"]):
        assert main(["sweep", "study.toml", *words]) == 2
    assert [path.name for path in Path("full").iterdir()] == ["notes.txt"]
    assert main(["sweep", "show", "full"]) == 2


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such locks")
def test_two_writers_at_once_are_refused(whole: Path, capsys: Capture) -> None:
    hold = "import fcntl, sys; s = open('whole/.lock', 'ab'); fcntl.flock(s, fcntl.LOCK_EX); print(flush=True); sys.stdin.read()"
    with subprocess.Popen([sys.executable, "-c", hold], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as other:
        assert other.stdout is not None
        other.stdout.readline()
        assert main(["sweep", "study.toml", "--out", "whole", "--resume"]) == 2
        other.communicate()
    assert main(["sweep", "study.toml", "--out", "whole", "--resume"]) == 0


def test_a_full_disk_keeps_what_is_finished(study: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    write, written = Path.write_bytes, []

    def full(path: Path, data: bytes) -> int:
        if "part-000002" in path.name:
            write(path, data[: len(data) // 2])
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        written.append(path.name)
        return write(path, data)

    with monkeypatch.context() as patch:
        patch.setattr(Path, "write_bytes", full)
        assert main(["sweep", "study.toml", "--out", "store"]) == 2
    assert os.strerror(errno.ENOSPC) in capsys.readouterr().err
    assert sorted(read_store("store").parts) == [0, 1] and not list(Path("store").glob(".*.part"))
    assert asked(capsys, "study.toml", "--out", "store", "--resume")["chunks_made"] == 2


def test_an_interrupt_keeps_what_is_finished(study: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    from contourlab.features.sweep import command

    run = command.run_chunks

    def interrupted(study: object, numbers: Sequence[int], *rest: object, **more: object) -> object:
        if 2 in numbers:
            raise KeyboardInterrupt
        return run(study, numbers, *rest, **more)  # type: ignore[arg-type]

    with monkeypatch.context() as patch:
        patch.setattr(command, "run_chunks", interrupted)
        assert main(["sweep", "study.toml", "--out", "store"]) == 130
    assert "--resume" in capsys.readouterr().err
    assert asked(capsys, "study.toml", "--out", "store", "--resume")["chunks_made"] == 2


def test_sql_reads_the_results_and_nothing_else(whole: Path, capsys: Capture) -> None:
    (row,) = asked(capsys, "query", "whole", "SELECT count(*) AS n, min(variant) AS first FROM results")
    assert row == {"n": 100, "first": 0}
    assert main(["sweep", "query", "whole", "SELECT * FROM range(10000000) t(a), results ORDER BY random()", "--memory", "50 MB"]) == 2
    assert not Path(".tmp").exists()
    secret = Path("secret.csv")
    secret.write_text("a\n1\n")
    for sql in (
        f"SELECT * FROM '{secret}'",
        f"SELECT * FROM read_csv('{secret.resolve()}')",
        "COPY (SELECT 1) TO 'out.csv'",
        "SET enable_external_access = true",
        "ATTACH 'other.db'",
        "INSTALL httpfs",
        "SELECT * FROM nothing",
        "DROP VIEW results; SELECT * FROM found",
    ):
        assert main(["sweep", "query", "whole", sql]) == 2, sql
    assert not Path("out.csv").exists() and not Path("other.db").exists()


@pytest.mark.parametrize(
    ("sql", "option", "limit"),
    [
        ("SELECT list(a) FROM range(1000000000) t(a)", "--memory", "100 MB"),  # in DuckDB
        ("SELECT * FROM range(1000000000)", "--memory", "20 MB"),  # as rows
        ("SELECT max(sin(a)) FROM range(1000000000000) t(a)", "--time", "0.3 s"),
        ("SELECT * FROM range(1000000000)", "--time", "0.3 s"),
    ],
)
def test_a_query_beyond_its_limit_names_the_option(whole: Path, capsys: Capture, sql: str, option: str, limit: str) -> None:
    assert main(["sweep", "query", "whole", sql, option, limit]) == 2
    assert option in capsys.readouterr().err
    assert main(["sweep", "query", "whole", "SELECT 1", option, limit]) == 0


@each("option, limit", itertools.product(["--memory", "--time"], ["0", "2", "2 zz", "-3 s", "2 mm", "-1 GB"]), "{} {}".format)
def test_a_limit_of_a_query_that_is_none_names_its_option(whole: Path, capsys: Capture, option: str, limit: str) -> None:
    assert main(["sweep", "query", "whole", "SELECT 1", option, limit]) == 2
    assert option in capsys.readouterr().err


STRUCTURES = """\
scenario = "scenario.toml"
design = "grid"
chunk = 32
signals = ["command", "position"]
figures = ["contour_error_max", "command_energy", "cycle_time"]
[vary]
scheme = { values = ["position loop", "all of it"] }
"feed.frequency" = { values = ["0.5 Hz", "0.25 Hz"] }
"controller.axes.*.velocity" = { values = [{ kind = "filtered-difference", bandwidth = "3000 rad/s" }, "true"] }
"axes.*.plant.gain" = { uniform = ["90 %", "110 %"], steps = 3, together = true }
"axes.1.friction.coulomb" = { values = ["0 full_scale", "100 %"] }
"""


def test_schemes_motions_and_kinds_of_components_vary_with_numbers(study: Path, capsys: Capture) -> None:
    study.write_text(STRUCTURES)
    assert asked(capsys, "study.toml", "--out", "store")["variants"] == 2 * 2 * 2 * 3 * 2
    names = 'scheme, "axes.3.plant.gain", "feed.frequency" AS f, cycle_time AS t'
    sql = f"SELECT count(*) AS n, {names} FROM results GROUP BY ALL"
    found = asked(capsys, "query", "store", f"{sql} ORDER BY ALL")
    assert {row["n"] for row in found} == {4} and len(found) == 12
    assert {(row["f"], round(row["t"], 6)) for row in found} == {(0.5, 2.0), (0.25, 4.0)}
    import xarray

    with xarray.open_dataset(next(Path("store").glob("signals-000000-*.nc"))) as kept:
        assert kept["position"].shape == (32, 4000, 2)
        ends = np.isfinite(kept["position"].values[:, :, 0]).sum(axis=1)  # each motion at its own length
        assert ends.tolist() == [2000] * 12 + [4000] * 12 + [2000] * 8


def test_variants_that_diverge_or_are_refused_are_rows(study: Path, capsys: Capture) -> None:
    limits = '"axes.1.limits.following_error" = { values = ["10 mm", "1 um"] }'
    structure = '"controller.axes.1.controller.structure" = { values = ["ipv"] }'
    gains = '"controller.axes.1.controller.integral_gain" = { values = ["100 %", "0 1/s"] }'
    text = STUDY.replace("variants = 100\n", 'design = "grid"\n').partition("[vary]")[0]
    study.write_text(f"{text}[vary]\n{limits}\n{structure}\n{gains}\n")
    result = asked(capsys, "study.toml", "--out", "store")
    rows = asked(capsys, "query", "store", "SELECT status, failed_at, contour_error_max FROM results ORDER BY variant")
    assert [row["status"] for row in rows] == ["ok", "refused", "diverged", "refused"]
    assert result["yield"]["judged"] == 2 and "CL932" in {found["code"] for found in result["findings"]}
    for row in rows:
        assert (row["contour_error_max"] is not None) == (row["status"] == "ok")
        assert (row["failed_at"] is not None) == (row["status"] == "diverged")


def test_a_variant_runs_again_into_a_report(whole: Path, capsys: Capture) -> None:
    (row,) = asked(capsys, "worst", "whole", "1")
    words = ["worst", "whole", "--rerun", str(row["variant"]), "--out", "report"]
    summary = asked(capsys, *words, code=1)
    assert summary["passed"] is False and Path("report/report.html").exists()
    again = load_scenario(f"report/variant-{row['variant']}.toml").base
    assert again.machine.axis("1").plant.gain == row["axes.1.plant.gain"]
    signals = Result.load(next(Path("report/signals").glob("*.nc")))
    assert np.abs(signals["contour_error"]).max() == pytest.approx(row["contour_error_max"], rel=1e-6)
    assert json.loads(Path("report/summary.json").read_text())["passed"] is False
    assert main(["sweep", "worst", "whole", "--rerun", "100"]) == 2


def test_a_run_again_is_compared_with_the_stored_row(whole: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    from contourlab.features.sweep import command

    def found() -> list[dict[str, Any]]:
        words = ["sweep", "worst", "whole", "--rerun", "5", "--out", "again", "--json"]
        assert main(words) in (0, 1)
        summary = json.loads(capsys.readouterr().out)
        assert summary == json.loads(Path("again/summary.json").read_text())
        return [one for one in summary["schemes"]["base"]["findings"] if one["code"] == "CL934"]

    capsys.readouterr()
    with monkeypatch.context() as patch:
        patch.setattr(command, "SAME", 0.0)
        assert found() == []  # bit for bit
    forged(whole, lambda text: text.replace("1116 mm/s^2", "1120 mm/s^2"))  # axis 3, which the study does not vary
    (differs,) = found()
    assert differs["values"]["variant"] == 5 and differs["values"]["stored"] != differs["values"]["now"]
    forged(whole, lambda text: text.replace('following_error = "50 mm"', 'following_error = "1 um"'))
    assert main(["sweep", "worst", "whole", "--rerun", "5", "--out", "again"]) == 3
    assert "CL934" in capsys.readouterr().err


def test_equal_rows_in_another_order_have_the_same_bits() -> None:
    import pyarrow
    import pyarrow.dataset

    rows = np.random.default_rng(1).lognormal(size=1000)
    orders = (rows, rows[::-1], np.random.default_rng(2).permutation(rows))
    tables = [pyarrow.dataset.dataset(pyarrow.table({"a": [*order, None]})) for order in orders]
    found = [spreads(SimpleNamespace(manifest=SimpleNamespace(figures={"a": "m"}), dataset=table))["a"] for table in tables]  # type: ignore[arg-type]
    assert found == [found[0]] * 3
    assert found[0].mean == pytest.approx(math.fsum(rows) / len(rows), rel=1e-15)
    assert (found[0].minimum, found[0].maximum) == (min(rows), max(rows))
