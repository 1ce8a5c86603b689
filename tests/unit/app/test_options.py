"""Options: read, checked and written by one class each; the command and the function of a question have the same."""

from __future__ import annotations

import importlib
import inspect
from pathlib import Path
from typing import Any

import pytest

import contourlab as cl
from contourlab.app.options import REQUIRED, Options, option, options
from contourlab.app.session import Command
from contourlab.cli.main import root
from contourlab.cli.parse import PANEL_OF, home_of
from contourlab.errors import ParameterError


@options
class Some(Options):
    """One option of each kind."""

    budget: int = option(6000, "Runs.", least=32, most=10_000)
    share: float = option(0.5, "Share.", above=0.0, most=1.0)
    method: str = option("both", "Method.", choices=("one", "both"))
    tolerance: str | None = option(None, 'Largest error, e.g. "25 um".', unit="m")
    axes: tuple[str, ...] = option((), "Axes.", listed=True)
    plugin: tuple[Path, ...] = option((), "Plug-ins.")
    quick: bool = option(False, "Be quick.")
    interval: bool | None = option(None, "Interval.")
    with_: str = option("", "Modules.")


@options
class Needed(Options):
    """An option without a default."""

    log: tuple[Path, ...] = option(REQUIRED, "Log.")


def test_values_get_the_type_of_their_option() -> None:
    made = Some(budget=100, share=1, axes="x, y", plugin="a.py", tolerance="25 um", interval=False)
    assert (made.budget, made.share, made.axes, made.plugin, made.quick) == (100, 1.0, ("x", "y"), (Path("a.py"),), False)
    assert made.si("tolerance") == pytest.approx(25e-6) and Some().si("tolerance") is None
    assert Some(axes=["x", "y"]).axes == ("x", "y") == Some(axes="x,y").axes
    assert Some(budget=None, method=None) == Some()
    assert Needed(log=["a.csv", Path("b.csv")]).log == (Path("a.csv"), Path("b.csv"))
    with pytest.raises(TypeError):
        Needed()


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("budget", 31), ("budget", 10_001), ("budget", 3.5), ("budget", True and "many"), ("share", 0.0), ("share", float("nan")),
        ("method", "two"), ("tolerance", "25"), ("tolerance", "25 kg"), ("tolerance", "-1 um"), ("tolerance", 25e-6), ("quick", 1),
        ("axes", [1]), ("axes", 1), ("plugin", 1),
    ],
)  # fmt: skip
def test_a_value_out_of_bounds_names_its_option(name: str, value: Any) -> None:
    with pytest.raises(ParameterError) as refused:
        Some(**{name: value})
    assert refused.value.name == name


def test_the_words_of_options_give_them_back() -> None:
    made = Some(budget=100, axes="x,y", plugin=["a.py", "b.py"], quick=True, interval=False, with_="m.toml")
    words = made.words()
    assert words.count("--plugin") == 2 and {"--quick", "--no-interval", "--with"} <= set(words) and "--method" not in words
    assert words[words.index("--axes") + 1] == "x,y" and Some().words() == []
    assert "--budget" not in made.words("budget")


def commands() -> dict[str, Command]:
    """Return every command by its words."""
    found = {}
    for name in PANEL_OF:
        entry = importlib.import_module(home_of(name)).COMMANDS[name]
        members = {name: entry} if isinstance(entry, Command) else {f"{name} {key}": one for key, one in entry.members.items()}
        found |= members
    return found


def test_commands_and_functions_have_the_options_of_their_class() -> None:
    groups = root().whole()
    public = 0
    for words, command in commands().items():
        name, _, member = words.partition(" ")
        typed = groups[name].whole()[member] if member else groups[name]
        known = {each for parameter in typed.params for each in parameter.opts}
        wanted = {part.typed for kind in (command.settings, command.files) for part in kind.PARTS.values() if not part.option.argument}
        assert wanted <= known, words
        target = getattr(cl, name, None)
        target = getattr(target, member, target) if member not in ("", "run") else target
        if hasattr(target, "ask") and name != "reproduce":
            public += 1
            keywords = {key for key, one in inspect.signature(target).parameters.items() if one.kind is one.KEYWORD_ONLY}
            assert set(command.settings.PARTS) == keywords - ({"control"} if name == "commission" else set()), words
    assert public == 30


def test_every_option_has_a_line_of_help() -> None:
    for words, command in commands().items():
        for kind in (command.settings, command.files):
            bare = [name for name, part in kind.PARTS.items() if not part.option.help.endswith((".", "."))]
            assert not bare, (words, bare)
