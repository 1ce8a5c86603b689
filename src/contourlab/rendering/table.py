"""Text tables for all commands, fitted to the width of the terminal."""

from __future__ import annotations

import os
import re
import shutil
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextvars import ContextVar, copy_context
from dataclasses import dataclass

PIPE_WIDTH = 80
"""Columns of output that goes to a file or a pipe, unless ``COLUMNS`` states others."""
_GAP = 2
_HEAD = 24
"""Longest line of a head, such as the name of a scheme, that has spaces."""


_noted: ContextVar[list[Table] | None] = ContextVar("noted", default=None)
_LATEX = {letter: f"\\{letter}" for letter in "&%$#_{}"} | {
    "\\": "\\textbackslash{}", "~": "\\textasciitilde{}", "^": "\\textasciicircum{}", "<": "$<$", ">": "$>$", "±": "$\\pm$",
    "×": "$\\times$", "\n": " ", "°": "$^\\circ$", "µ": "$\\mu$", "·": "$\\cdot$", "−": "$-$",
}  # fmt: skip
_FORMS = re.compile(r"\bum\b|\^(-?\d+)|(?<![\w)])-(?=\d)|" + "|".join(map(re.escape, _LATEX)))


def _latex(text: str) -> str:
    """Return text for LaTeX: special letters, um, powers and signs."""
    return _FORMS.sub(lambda m: "$\\mu$m" if m[0] == "um" else f"$^{{{m[1]}}}$" if m[1] else "$-$" if m[0] == "-" else _LATEX[m[0]], text)


def tables_of(write: Callable[[], str]) -> list[Table]:
    """Return the tables that are written as text in a function."""
    tables: list[Table] = []
    context = copy_context()
    context.run(_noted.set, tables)
    context.run(write)
    return tables


@dataclass(frozen=True)
class Column:
    """A column: its head, and the layout of its cells.

    Attributes
    ----------
    head : str
        With the unit in brackets: ``contour rms [um]``.
    left : bool
        Whether cells start at the left, as names do; figures end at the right.
    prose : bool
        Whether cells may be broken into lines at spaces. Names and figures stay whole.
    """

    head: str
    left: bool = False
    prose: bool = False


@dataclass
class Table:
    """Rows of text under heads. The first `keys` columns name the rows; a table wider than the page repeats them.

    >>> table = Table([Column("axis", left=True), Column("rms [um]")], rows=[("x", "12.3")])
    >>> print(table.text(40))
           rms
    axis  [um]
    ----  ----
    x     12.3
    """

    columns: Sequence[Column]
    title: str = ""
    keys: int = 1
    rows: Iterable[Sequence[str]] = ()

    def __post_init__(self) -> None:
        self.rows = list(self.rows)
        for cells in self.rows:
            if len(cells) != len(self.columns):
                raise ValueError(f"{len(cells)} cells for {len(self.columns)} columns")

    def text(self, width: int | None = None) -> str:
        """Return the table as lines of at most `width` characters, by default the width of the page.

        A wider table is cut into panels, one below the other. Each repeats the columns that name the rows. Only a name wider than the page
        exceeds it.
        """
        if (noted := _noted.get()) is not None:
            noted.append(self)
        width = page_width() if width is None else width
        panels = [self._panel(which, width) for which in self._panels(width)]
        title = paragraphs([self.title], width) if self.title else ""
        return "\n".join(filter(None, [title, "\n\n".join(panels)]))

    def latex(self) -> str:
        """Return the table as LaTeX, for the package booktabs.

        >>> print(Table([Column("axis", left=True), Column("rms [um]")], rows=[("x_1", "-2.5")]).latex())
        \\begin{tabular}{lr}
        \\toprule
        axis & rms [$\\mu$m] \\\\
        \\midrule
        x\\_1 & $-$2.5 \\\\
        \\bottomrule
        \\end{tabular}
        """
        kinds = "".join("l" if column.left or column.prose else "r" for column in self.columns)
        heads, *rows = ([*map(_latex, cells)] for cells in [[column.head for column in self.columns], *self.rows])
        body = ["\\toprule", heads, "\\midrule", *rows, "\\bottomrule"]
        lines = [line if isinstance(line, str) else " & ".join(line) + " \\\\" for line in body]
        title = [f"% {' '.join(self.title.split())}"] if self.title else []
        return "\n".join([*title, f"\\begin{{tabular}}{{{kinds}}}", *lines, "\\end{tabular}"])

    def _least(self, column: int) -> int:
        texts = [*_head_lines(self.columns[column].head), *(row[column] for row in self.rows)]
        if self.columns[column].prose:
            return max((len(word) for text in texts for word in text.split()), default=0)
        return max(map(len, texts))

    def _panels(self, width: int) -> Iterator[list[int]]:
        """Yield the columns of each panel."""
        keys = list(range(self.keys))
        first = sum(self._least(column) + _GAP for column in keys) - _GAP
        panel, taken = keys, first
        for column in range(self.keys, len(self.columns)):
            least = self._least(column) + _GAP
            if taken + least > width and len(panel) > self.keys:
                yield panel
                panel, taken = keys, first
            panel = [*panel, column]
            taken += least
        yield panel

    def _widths(self, which: Sequence[int], width: int) -> list[int]:
        """Return the width of each column of a panel: the least, and for prose a fair share of the space that is left."""
        widths = [self._least(column) for column in which]
        more = [max((len(row[column]) for row in self.rows), default=0) - own for column, own in zip(which, widths, strict=True)]
        left = max(width - sum(widths) - _GAP * (len(widths) - 1), 0)
        wide = sorted((i for i, extra in enumerate(more) if extra > 0), key=more.__getitem__)
        for place, i in enumerate(wide):
            share = min(more[i], left // (len(wide) - place))
            widths[i] += share
            left -= share
        return widths

    def _panel(self, which: Sequence[int], width: int) -> str:
        from textwrap import wrap

        widths, lines = self._widths(which, width), []
        for row in self._with_heads(which, widths):
            parts = []
            for number, own, cell in zip(which, widths, row, strict=True):
                column = self.columns[number]
                broken = [
                    part for line in cell.split("\n") for part in (wrap(line, own, break_on_hyphens=False) if len(line) > own else [line])
                ]
                parts.append([part.ljust(own) if column.left or column.prose else part.rjust(own) for part in broken])
            blank = [" " * own for own in widths]
            for i in range(max(map(len, parts))):
                cells = (part[i] if i < len(part) else space for part, space in zip(parts, blank, strict=True))
                lines.append((" " * _GAP).join(cells).rstrip())
        return "\n".join(lines).rstrip()

    def _with_heads(self, which: Sequence[int], widths: Sequence[int]) -> Iterator[list[str]]:
        heads = [_head_lines(self.columns[number].head) for number in which]
        deepest = max(map(len, heads))
        yield ["\n".join([*[""] * (deepest - len(head)), *head]) for head in heads]
        yield ["-" * min(max(map(len, head)), width) for head, width in zip(heads, widths, strict=True)]
        yield from ([row[number] for number in which] for row in self.rows)


def page_width() -> int:
    """Return the width of the page in characters: ``COLUMNS``, else that of the terminal, else `PIPE_WIDTH`."""
    terminal = shutil.get_terminal_size((PIPE_WIDTH, 0)).columns  # of the first standard output, also where another one replaces it
    return terminal if sys.stdout.isatty() or "COLUMNS" in os.environ else PIPE_WIDTH


def paragraphs(texts: Iterable[str], width: int | None = None, indent: str = "  ") -> str:
    """Return texts as paragraphs that fit the page; lines after the first of each are indented."""
    from textwrap import fill

    width = page_width() if width is None else width
    return "\n".join(fill(text, width, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False) for text in texts)


def _head_lines(head: str) -> list[str]:
    """Return a head as lines; its unit has a line of its own."""
    from textwrap import wrap

    lines = head.replace(" [", "\n[").split("\n")
    return [part for line in lines for part in wrap(line, _HEAD, break_long_words=False, break_on_hyphens=False) or [""]]
