"""Write what is made from the questions: ``python tools/surface.py`` after a change of options or public names.

``cli/lines.py`` has the line of help of each command, so that ``contourlab --help`` loads no question. ``__init__.pyi`` has the types of
all public names, for type checkers and completion.
"""

from __future__ import annotations

import collections.abc
import importlib
import inspect
import re
import sys
import typing
from pathlib import Path
from typing import Any

import contourlab
import contourlab.logs
from contourlab.cli.parse import PANEL_OF, home_of, line_of

PACKAGE = Path(contourlab.__file__).parent
LINES, STUB = PACKAGE / "cli" / "lines.py", PACKAGE / "__init__.pyi"
MADE = "made by ``python tools/surface.py``: do not edit."


def lines() -> str:
    """Return the module of the lines of help."""
    texts = {name: line_of(importlib.import_module(home_of(name)).COMMANDS[name]) for name in PANEL_OF}
    quoted = {name: "'" + text + "'" if '"' in text else f'"{text}"' for name, text in texts.items()}
    rows = "".join(f'    "{name}": {text},\n' for name, text in quoted.items())
    return f'"""Lines of help of the commands, {MADE}"""\n\nLINES = {{\n{rows}}}\n'


def stub() -> str:
    """Return the types of all public names."""
    imports, questions = {"from collections.abc import Sequence", "from pathlib import Path as File"}, []
    for home, names in contourlab._HOMES.items():
        for name in names:
            target = getattr(contourlab, name)
            if forms := getattr(target, "forms", ()):
                imports.add("from typing import overload")
                questions += [f"@overload\ndef {name}({signature(form, imports)}: ...\n" for form in forms]
            elif hasattr(target, "ask"):
                questions.append(question(name, target, imports))
            else:
                own = getattr(target, "__module__", home)
                imports.add(f"from {own if hasattr(sys.modules.get(own), name) else home} import {name} as {name}")
    names = "".join(f'    "{name}",\n' for name in contourlab.__all__)
    head = f'# ruff: noqa\n# fmt: off\n"""Types of the public names, {MADE}"""\n\n'
    return head + "\n".join(sorted(imports)) + f"\n\n__version__: str\n\n__all__ = [\n{names}]\n\n" + "\n".join(questions)


def question(name: str, target: Any, imports: set[str]) -> str:
    """Return the type of a question, and of those that are its attributes; add the imports of the types in it."""
    members = {key: member for key, member in vars(target).items() if hasattr(member, "ask")}
    if not members:
        return f"def {name}({signature(target, imports)}: ...\n"
    calls = {"__call__": target, **members}
    body = "".join(f"    def {key}(self, {signature(member, imports)}: ...\n" for key, member in calls.items())
    return f"class _{name.title()}:\n{body}\n{name}: _{name.title()}\n"


def signature(target: Any, imports: set[str]) -> str:
    """Return parameters and result of a function."""
    made, home = inspect.signature(target), sys.modules[getattr(target, "ask", target).__module__]
    parameters: list[str] = []
    for each in made.parameters.values():
        first = each.kind is each.KEYWORD_ONLY and not any(one.startswith("*") for one in parameters)
        default = "" if each.default is each.empty else " = ..."
        star = "*" if each.kind is each.VAR_POSITIONAL else ""
        parameters += [*(["*"] if first else []), f"{star}{each.name}: {each.annotation}{default}"]
    text = f"{', '.join(parameters)}) -> {made.return_annotation}"
    for word in sorted(set(re.findall(r"[A-Z]\w+", text)) - {"Path", "Sequence", "None"}):
        places = (home, contourlab, contourlab.logs)  # types alone may be imported for type checkers only
        kind = next(getattr(place, word) for place in places if hasattr(place, word))
        if inspect.isclass(kind) and kind.__module__.startswith("contourlab."):
            imports.add(f"from {kind.__module__} import {kind.__name__} as {word}")
        else:  # of Python, or the name of a type
            place = next((module for module in (typing, collections.abc) if getattr(module, word, None) is kind), home)
            where = "contourlab.features.run.source" if word == "Source" else place.__name__
            imports.add(f"from {where} import {word} as {word}")
    return re.sub(r"\bPath\b", "File", text)


if __name__ == "__main__":
    LINES.write_text(lines(), encoding="utf-8")
    STUB.write_text(stub(), encoding="utf-8")
