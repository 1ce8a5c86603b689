"""Write comments into a part program, and prove that its moves stay the same."""

from __future__ import annotations

import io
import re
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from contourlab.errors import ProgramError
from contourlab.features.check.canon import Listed
from contourlab.program import Reading
from contourlab.result import write_bytes_atomic

LONGEST = 255
"""Characters in a line that LinuxCNC reads."""
_ACTIVE = re.compile(rb"[(;]\s*(msg|debug|print|log|probe|py|abort|hide)", re.IGNORECASE)
"""Comments that act: with another comment behind them they may not."""
_PLAIN = re.compile(rb"\s*([(/;%]|n\d|[a-z]\s*[-+.\d\[#]|#)", re.IGNORECASE)
_O_WORD = re.compile(rb"\s*(n\s*[\d.]+\s*)?o\s*[<\d#\[]", re.IGNORECASE)


def annotated(program: Path, texts: Iterable[tuple[int, str]]) -> tuple[bytes, int]:
    """Return a program with comments at the ends of its lines, and how many lines stay without.

    Parameters
    ----------
    program : Path
    texts : iterable of (int, str)
        Line, from 1, and its comment.

    Notes
    -----
    No line is inserted, so line numbers stay. A line that is an O-word, holds an active comment, has a comment without end, or would be
    longer than `LONGEST` stays as it is.
    """
    lines = program.read_bytes().splitlines(keepends=True)
    skipped = 0
    for number, text in texts:
        line = lines[number - 1] if 0 < number <= len(lines) else b""
        body = line.rstrip(b"\r\n")
        end, comment = line[len(body) :], f"({text})".encode("ascii")
        body = body.rstrip()
        is_open = body.count(b"(") != body.count(b")")
        longer = len(body) + 1 + len(comment) > LONGEST
        if not _PLAIN.match(body) or _O_WORD.match(body) or _ACTIVE.search(body) or is_open or longer:
            skipped += 1
            continue
        lines[number - 1] = body + b" " + comment + end
    return b"".join(lines), skipped


def write_annotated(program: Path, out: Path, texts: Iterable[tuple[int, str]], reading: Reading) -> int:
    """Write an annotated program; return how many lines stay without a comment.

    Raises
    ------
    ProgramError
        If the written program would not have the same moves; it is then not written.
    OutputError
        If the file cannot be written.
    """
    import tempfile

    content, skipped = annotated(program, texts)
    # Subprogram files lie beside the program.
    beside = replace(reading, folder=program.parent) if reading.folder is None else reading
    with tempfile.TemporaryDirectory() as folder:
        trial = Path(folder) / program.name
        trial.write_bytes(content)
        if moves_of(trial, beside) != moves_of(program, beside):
            raise ProgramError("comments would change its moves: it is not annotated", file=program)
    write_bytes_atomic(out, content)
    return skipped


def moves_of(program: Path, reading: Reading) -> str:
    """Return the moves of a program as canonical text."""
    text = io.StringIO()
    Listed(program, reading).write(text, as_json=True)
    return text.getvalue()
