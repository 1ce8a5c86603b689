"""Commands are printed so that a shell, or the Windows prompt, takes them as they are."""

import shlex

import pytest
from hypothesis import given
from hypothesis import strategies as st

from contourlab.app import command_line
from contourlab.app.command_line import as_typed


@given(st.lists(st.text(st.characters(exclude_characters="\0", exclude_categories=["Cs"]))))
def test_words_come_back(words: list[str]) -> None:
    assert shlex.split(as_typed(words)) == words


def test_the_windows_prompt_knows_double_quotes_only(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(command_line, "_SPECIAL", command_line._SPECIAL - {"\\"})
    words = ["run", r"C:\my parts\part.ngc", "--tolerance", "20 um"]
    assert as_typed(words) == r'run "C:\my parts\part.ngc" --tolerance "20 um"'
    assert shlex.split(as_typed(words)) == words
