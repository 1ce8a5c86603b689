"""Print code, docstring and blank lines of each room: ``python tools/size.py [FOLDER]``, by default ``src/contourlab``.

A line counts as code unless it is blank, a comment, or part of a docstring.
"""

from __future__ import annotations

import ast
import sys
from collections import Counter
from pathlib import Path


def sizes(file: Path) -> Counter[str]:
    """Count the lines of one file by kind."""
    text = file.read_text(encoding="utf-8")
    documented: set[int] = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            documented.update(range(node.lineno, (node.end_lineno or node.lineno) + 1))
    counts = Counter(files=1)
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.strip()
        kind = "docstrings" if number in documented else "blank" if not bare else "comments" if bare.startswith("#") else "code"
        counts[kind] += 1
    return counts


def main(folder: Path) -> None:
    """Print a row for each room, then the sums."""
    rooms: dict[str, Counter[str]] = {}
    for file in sorted(folder.rglob("*.py")):
        room = file.relative_to(folder).parts[0]
        rooms.setdefault(room, Counter()).update(sizes(file))
    everything: Counter[str] = sum(rooms.values(), Counter())
    rooms["total"] = everything
    rooms["without papers"] = everything - rooms.get("papers", Counter())
    columns = ("files", "code", "docstrings", "comments", "blank")
    print(f"{'room':16}" + "".join(f"{name:>12}" for name in columns))
    for room, counts in rooms.items():
        print(f"{room:16}" + "".join(f"{counts[name]:12}" for name in columns))


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[1] / "src" / "contourlab")
