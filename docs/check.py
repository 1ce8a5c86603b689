"""Check documents against the code: commands, modules, docstrings, links of the README. Sphinx checks the rest; run by ``make docs``."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
import re
import shlex
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import generate

import contourlab
from contourlab.cli.main import root

ROOT = Path(__file__).resolve().parents[1]
FENCE = re.compile(r"^```(\w*)[^\n]*\n(.*?)^```", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)\s#:]+)[)#]")
MODULE = re.compile(r"`(contourlab(?:\.[a-z_0-9]+)+)`")
SHELL = {"sh", "bash", "console", "shell"}


def documents() -> list[Path]:
    """Return every Markdown file that belongs to the project."""
    folders = (ROOT.glob("*.md"), *((ROOT / name).rglob("*.md") for name in ("docs", "benchmarks", "src", "tests")))
    return sorted(file for found in folders for file in found)


def command_lines(text: str) -> Iterator[list[str]]:
    """Yield the words of every ``contourlab`` and ``make`` command in a shell block."""
    for language, block in FENCE.findall(text):
        if language not in SHELL:
            continue
        for line in block.replace("\\\n", " ").splitlines():
            words = shlex.split(line.removeprefix("$ "), comments=True)
            # Keep the words up to a pipe or redirection, and drop folders in front of the command.
            end = next((n for n, word in enumerate(words) if word in ("|", ">", "&&", "||", ";")), len(words))
            words = words[:end]
            if words and Path(words[0]).name in ("contourlab", "make"):
                yield [Path(words[0]).name, *words[1:]]


def unknown_words(words: list[str]) -> Iterator[str]:
    """Yield commands, options and targets that the program does not have."""
    if words[0] == "make":
        rules = re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)
        yield from (f"make {word}: no such target" for word in words[1:] if "=" not in word and word not in rules)
        return
    command: Any = root()
    place = "contourlab"
    for word in words[1:]:
        options = {option for parameter in command.params for option in parameter.opts} | {"--help", "-h", "--debug"}
        if word.startswith("-"):
            if word.partition("=")[0] not in options:
                yield f"{place}: no option {word}"
        elif hasattr(command, "commands"):
            if word not in command.commands and getattr(command, "default", ""):
                command, place = command.builder(command.default), f"{place} {command.default}"
                continue
            if word not in command.commands:
                yield f"{place}: no command {word}"
                return
            command, place = command.builder(word), f"{place} {word}"


def unknown_modules(text: str) -> Iterator[str]:
    """Yield dotted names in backquotes that cannot be imported."""
    for name in sorted(set(MODULE.findall(text))):
        module, _, last = name.rpartition(".")
        try:
            importlib.import_module(name)
        except ModuleNotFoundError:
            try:
                getattr(importlib.import_module(module), last)
            except (ModuleNotFoundError, AttributeError):
                yield f"`{name}`: no such module or name"


def undocumented() -> Iterator[str]:
    """Yield public functions, classes, their members and modules without a docstring."""
    for info in pkgutil.walk_packages(contourlab.__path__, "contourlab."):
        module = importlib.import_module(info.name)
        if not module.__doc__ and Path(module.__file__ or "").stat().st_size:
            yield f"{info.name}: no docstring"
        for name in getattr(module, "__all__", ()):
            thing = getattr(module, name, None)
            if thing is None:
                yield f"{info.name}: __all__ names {name}, which does not exist"
            elif (inspect.isroutine(thing) or inspect.isclass(thing)) and thing.__module__ == info.name and not inspect.getdoc(thing):
                yield f"{info.name}.{name}: no docstring"
    for kind in filter(inspect.isclass, (getattr(contourlab, name) for name in contourlab.__all__)):
        members = inspect.getmembers(kind, lambda thing: inspect.isroutine(thing) or isinstance(thing, property))
        yield from (f"{kind.__name__}.{name}: no docstring" for name, thing in members if name[0] != "_" and not inspect.getdoc(thing))


def faults() -> Iterator[str]:
    """Yield all faults, with their place."""
    for file in documents():
        text = file.read_text(encoding="utf-8")
        found = [*unknown_modules(text), *(fault for words in command_lines(text) for fault in unknown_words(words))]
        if file.parent == ROOT:  # not all of these are pages of the site
            found += [f"link to {name}: no such file" for name in LINK.findall(text) if not (ROOT / name).exists()]
        yield from (f"{file.relative_to(ROOT)}: {fault}" for fault in found)
    yield from undocumented()


def main() -> int:
    """Print all faults; return 1 if there are any."""
    stale = generate.PORTS.read_text("utf-8") != generate.ports_page()
    generate.write()
    found = [*faults(), *([f"{generate.PORTS.relative_to(ROOT)}: was out of date: commit it"] if stale else [])]
    print(*found, f"documents: {len(documents())} read, {len(found)} faults", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
