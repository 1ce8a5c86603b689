"""Print code lines and statements of each room: ``python tools/size.py [FOLDER]``; ``--check`` compares the lines with the budgets.

A line counts as code unless it is blank, a comment, or part of a docstring. A statement counts unless it imports or is a docstring.
"""

from __future__ import annotations

import ast
import sys
from collections import Counter
from pathlib import Path

BUDGETS = {
    "analysis": 4865,
    "app": 1026,
    "cli": 503,
    "components": 5810,
    "contours": 1553,
    "controls": 692,
    "engine": 3668,
    "features": 19338,
    "feed": 3154,
    "findings": 55,
    "geometry": 2220,
    "logs": 1922,
    "loop": 2767,
    "metrics": 1108,
    "native": 320,
    "papers": 3451,
    "program": 2601,
    "rendering": 2628,
    "result": 610,
    "scenario": 2064,
    "study": 1405,
    "without papers": 59073,
}
"""Most code lines of each room. A budget may only fall; a commit that raises one names the capability that pays for it."""


def is_docstring(node: ast.AST) -> bool:
    """Return whether a node is text that stands as a statement."""
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def sizes(file: Path) -> Counter[str]:
    """Count the lines of one file by kind, and its statements."""
    text = file.read_text(encoding="utf-8")
    documented: set[int] = set()
    counts = Counter(files=1)
    for node in ast.walk(ast.parse(text)):
        if is_docstring(node):
            documented.update(range(node.lineno, (node.end_lineno or node.lineno) + 1))
        elif isinstance(node, ast.stmt) and not isinstance(node, ast.Import | ast.ImportFrom):
            counts["statements"] += 1
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.strip()
        kind = "docstrings" if number in documented else "blank" if not bare else "comments" if bare.startswith("#") else "code"
        counts[kind] += 1
    return counts


def rooms_of(folder: Path) -> dict[str, Counter[str]]:
    """Count each room of a package, then their sum, and the sum without papers."""
    rooms: dict[str, Counter[str]] = {}
    for file in sorted(folder.rglob("*.py")):
        room = file.relative_to(folder).parts[0]
        rooms.setdefault(room, Counter()).update(sizes(file))
    everything: Counter[str] = sum(rooms.values(), Counter())
    return {**rooms, "total": everything, "without papers": everything - rooms.get("papers", Counter())}


def show(rooms: dict[str, Counter[str]]) -> None:
    """Print a row for each room, then the sums."""
    columns = ("files", "code", "statements", "docstrings", "comments", "blank")
    print(f"{'room':16}" + "".join(f"{name:>12}" for name in columns))
    for room, counts in rooms.items():
        print(f"{room:16}" + "".join(f"{counts[name]:12}" for name in columns))


def check(rooms: dict[str, Counter[str]]) -> int:
    """Print each room beyond its budget; return the exit code."""
    parts = {room: counts["code"] for room, counts in rooms.items() if not room.endswith(".py") and room != "total"}
    beyond = [room for room, code in parts.items() if code > BUDGETS.get(room, 0)]
    for room in beyond:
        print(f"{room}: {parts[room]} code lines, its budget is {BUDGETS.get(room, 0)}: make it smaller, or raise BUDGETS and say why")
    return 1 if beyond else 0


if __name__ == "__main__":
    given = [word for word in sys.argv[1:] if word != "--check"]
    counted = rooms_of(Path(given[0]) if given else Path(__file__).parents[1] / "src" / "contourlab")
    sys.exit(check(counted) if "--check" in sys.argv else show(counted))
