"""Rows of a reproduction: agreement, bands, and their effect on the command."""

from __future__ import annotations

import json
import math
import re
from dataclasses import replace

import pytest

from contourlab.app.json_values import json_values
from contourlab.cli.main import main
from contourlab.papers import rows as rows_module
from contourlab.papers.ghaffari import study as ghaffari
from contourlab.papers.rows import Row, asked, banded, derived, identity, measured, ours, printed
from contourlab.papers.run import conclusion, text_of

BAND = (1.9, 2.3)
AGREES = printed("gain", "axis 1", 2.0, 2.08, "1/s", 0.1, "as printed", reason="unused")
DIFFERS = printed("gain", "axis 2", 2.0, 2.2, "1/s", 0.1, "as printed", reason="other parameters")
DERIVED = derived("gain", "axis 3", 2.0, 2.2, "1/s", 0.1, "by eq 1")
OURS = ours("gain", "axis 4", 2.0, "1/s", "nobody else")
INPUT = printed("mass", "axis 1", 2.0, 2.0, "kg", 0.0, kind="input")
IDENTITY = identity("eq 1", "axis 1", 0.0, 1e-13, "", 1e-9)
FAR = printed("gain", "axis 5", 2.0, 4.0, "1/s", 0.1, reason="another drive")
ALL = (AGREES, DIFFERS, DERIVED, OURS, INPUT, IDENTITY, FAR)
BANDS = {(row.name, row.case): BAND for row in ALL} | {("eq 1", "axis 1"): (0.0, 1e-9), ("gain", "axis 5"): (3.9, 4.1)}


def test_a_row_agrees_or_differs_inside_its_band_and_fails_outside() -> None:
    found = [(row.verdict, row.passed, row.note) for row in banded((AGREES, DIFFERS, DERIVED, OURS), BANDS)]
    assert found == [
        ("agrees", True, "as printed"),
        ("differs", None, "other parameters"),
        ("differs", None, "by eq 1"),
        ("", None, "nobody else"),
    ]
    assert [row.passed for row in banded((AGREES, DIFFERS, OURS), {})] == [True, False, None]


@pytest.mark.parametrize("row", ALL, ids=lambda row: f"{row.name}, {row.case}")
def test_a_figure_ten_times_off_fails_whatever_its_kind(row: Row) -> None:
    (whole,) = banded([row], BANDS)
    assert whole.passed is not False and whole.band is not None
    assert replace(whole, here=10.0 * max(abs(row.here), *map(abs, whole.band))).passed is False


def test_a_figure_without_a_value_has_a_band_without_one() -> None:
    none, bands = ours("limit", "", math.nan, ""), {("limit", ""): (math.nan, math.nan)}
    assert [row.passed for row in banded([none, replace(none, here=math.inf), replace(none, here=1.0)], bands)] == [None, None, False]
    assert banded([none], {("limit", ""): (0.0, 1.0)})[0].passed is False
    assert json_values(none)["here"] is None


def test_a_lower_limit_is_not_met_from_below() -> None:
    above, below = (printed("fit", "", 95.0, here, "%", 5.0, at_least=True) for here in (99.0, 94.9))
    assert (above.agrees, above.off) == (True, 0.0)
    assert (below.agrees, below.off) == (False, pytest.approx(-0.1 / 95.0))


def test_an_upper_limit_is_not_met_from_above() -> None:
    below, above = (printed("ripple", "", 10.0, here, "%", 10.0, at_most=True) for here in (2.0, 10.1))
    assert (below.agrees, below.off) == (True, 0.0)
    assert (above.agrees, above.off) == (False, pytest.approx(0.01))
    assert banded([below], {})[0].band == (0.0, 10.0)


def figures(text: str) -> list[int]:
    return [int(digits) for digits in re.findall(r"\d+", text)]


def test_only_computed_figures_of_the_stated_reading_are_counted() -> None:
    other = printed("gain", "another reading", 2.0, 2.0, "1/s", 0.1, main=False)
    rows = banded((*ALL, other), BANDS | {("gain", "another reading"): BAND})
    # Of 2.08, 2.2 and 4.0 for 2.0: within 2, 5 and 20 %, and beyond.
    assert figures(conclusion(rows)) == [3, 0, 2, 1, 5, 2, 20, 1, 8]
    text = text_of(rows)
    assert "another drive" in text and "other parameters" not in text


def test_logged_figures_are_counted_and_limits_by_themselves() -> None:
    beside = measured("rms", "seen", 84.8, 84.6, "um", 1.0), measured("rms", "unseen", 84.8, 60.0, "um", None)
    rows = (*beside, asked("explained", "x", 80.0, 98.7, "%", 100.0), asked("explained", "y", 80.0, 79.9, "%", 100.0))
    assert [row.agrees for row in rows] == [True, False, True, False]
    # 84.6 for 84.8, and 60 for 84.8; a limit that is kept is not near.
    assert figures(conclusion(rows)) == [2, 1, 2, 1, 5, 1, 20, 1, 4]
    text = text_of(rows)
    assert "1 of 2 limits kept" in text and "explained: no reason known" in " ".join(text.split())


@pytest.mark.parametrize(("rows", "code"), [((AGREES, DIFFERS, OURS), 0), ((AGREES, replace(DERIVED, here=2.4)), 1)])
@pytest.mark.parametrize("words", [[], ["--all"], ["--json"]])
def test_only_a_row_outside_its_band_changes_the_exit_code(
    rows: tuple[Row, ...], code: int, words: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(ghaffari, "PARTS", (("rows", lambda: rows),))
    monkeypatch.setattr(rows_module, "read_bands", lambda paper: BANDS)
    assert main(["reproduce", "ghaffari", *words]) == code
    shown, complete = capsys.readouterr().out, banded(rows, BANDS)
    if words == ["--json"]:
        assert json.loads(shown) == json_values(complete)
        return
    assert ("2.4" in shown) == bool(code)
    for row in complete if words else ():  # each line contains the verdict and note of its case
        (line, *_) = (line for line in shown.splitlines() if line.strip().startswith(row.case))
        assert row.verdict in line and row.note in shown
