"""Read text tables of numbers: a row per sample, with or without names and units; dates and times of day as seconds."""

from __future__ import annotations

import itertools
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.errors import LogError, refuse
from contourlab.findings import Finding, finding
from contourlab.logs import reading
from contourlab.logs.mapping import TIME, meant
from contourlab.logs.reading import COLUMNS, Channel, Record, check_limit

MARKS = (";", "\t", ",")
ENDINGS = (".csv", ".tsv", ".txt", ".dat", ".log")
NO_UNIT = ("", "-", "1")
"""Cells for no unit in a line of units."""
LOOKED_AT = 1000
"""Lines searched for the one most like a row of numbers."""
NUMBER, VALUE, WORD = range(3)
"""Kinds of cells."""
Shape = tuple[str | None, list[int]]
"""Separator of a line, and the kinds of its cells."""
_NUMBER = re.compile(r"[-+]?(\d+([.,]\d*)?|[.,]\d+)([eE][-+]?\d+)?\Z")


def matches(file: Path, head: bytes) -> bool:
    """Tell whether one of the first lines is a row of numbers."""
    if b"\0" in head or file.suffix.lower() == ".xml":
        return False
    lines = [line for line in head.decode("utf-8-sig", errors="replace").splitlines()[:50] if _bare(line)]
    shapes = [_shape(line) for line in lines]
    if any(_is_row(shape) for shape in shapes):
        return True
    # A table with words, or a faulty one: all lines have separators, and there are few or some hold numbers.
    if file.suffix.lower() not in ENDINGS or not shapes or not all(mark for mark, _ in shapes):
        return False
    return len(shapes) <= 2 or any(NUMBER in kinds for _, kinds in shapes)


def read(file: Path) -> Record:
    """Read a table of numbers.

    Lines that begin with # or % are comments. The last line before the numbers names the columns, with units in brackets; a line of
    units may follow. Without such a line, a comment that fits names them. Semicolons, tabs, commas or blanks separate the cells; the
    first two allow decimal commas. Empty cells are gaps, true and false are 1 and 0, timestamps become seconds from the first one. A
    column with words has a fault, which counts if it is needed.

    Raises
    ------
    LogError
        If there is no row of numbers, or one has another number of columns.
    """
    text = reading.text_of(file)
    lines = ((i, line) for i, line in reading.lines_in(text, file) if _bare(line))
    looked = list(itertools.islice(lines, LOOKED_AT))
    refuse(not looked, LogError, "contains no samples", file=file)
    first, mark = _first_row(looked, file)
    width = len(_cells(looked[first][1], mark))
    check_limit(width, COLUMNS, "columns", file, looked[first][0])
    above = itertools.takewhile(lambda line: line[0] < looked[first][0], reading.lines_in(text, file))
    comments = [_cells(line.strip(" \t#%"), mark) for _, line in above if not _bare(line)]
    values = _plain(itertools.chain(looked[first:], lines), width, mark)
    if values is None:
        return _read_cells(file, text, first, mark, comments)
    values, findings = (values[:-1], (reading.CUT,)) if len(values) > 1 and _is_cut(text, mark) else (values, ())
    names, units = _heads([_cells(line, mark) for _, line in looked[:first]], width, comments)
    channels = (Channel(name, column, unit) for name, column, unit in zip(names, values.T, units, strict=True))
    return Record(file, "csv", tuple(channels), findings=findings)


def _is_cut(text: str, mark: str | None) -> bool:
    """Tell whether the last line may have lost digits: it has no line break, and does not end like the lines before it."""
    point = r"\.\d+\s*\Z" if mark == "," else r"[.,]\d+\s*\Z"
    decimals = {len(end[0].rstrip()) if (end := re.search(point, line)) else 0 for line in text[-10_000:].splitlines()[-20:]}
    is_fixed = len(decimals) == 1 and 0 not in decimals
    return not (text.endswith(("\n", "\r")) or text[-1].isalpha() or is_fixed)


def _plain(rows: Iterable[tuple[int, str]], width: int, mark: str | None) -> Array | None:
    """Return the numbers (n_row, n_column) of a table without empty cells, timestamps and words; None for others."""
    # With other separators, commas are decimal; beside points they are not plain.
    lines = (line.replace(",", "words" if "." in line else ".") if mark != "," else line for _, line in rows)
    try:
        values = np.loadtxt(lines, delimiter=mark, ndmin=2, comments=None)
    except ValueError:
        return None
    return values if values.shape[1] == width else None


def _read_cells(file: Path, text: str, first: int, mark: str | None, comments: list[list[str]]) -> Record:
    """Read a table cell by cell: a column holds timestamps if its first cell that is not empty looks like one, else numbers."""
    lines = [(i, line) for i, line in reading.lines_in(text, file) if _bare(line)]
    heads, rows = lines[:first], lines[first:]
    cut = len(rows) > 1 and not text.endswith(("\n", "\r"))
    if _is_closed(heads, rows[:-1] if cut else rows, mark):
        heads, rows = ([(i, line.rstrip(" ").removesuffix(mark or "")) for i, line in part] for part in (heads, rows))
        comments = [cells[:-1] if cells and not cells[-1].strip() else cells for cells in comments]
    width = len(_cells(rows[0][1], mark))
    names, units = _heads([_cells(line, mark) for _, line in heads], width, comments)
    cut = cut and (len(_cells(rows[-1][1], mark)) != width or _is_cut(text, mark))
    rows = rows[:-1] if cut else rows
    findings: tuple[Finding, ...] = (reading.CUT,) if cut else ()
    above = {line for _, line in heads}
    repeated = [i for i, line in rows if line in above]
    rows = [(i, line) for i, line in rows if line not in above]
    comma, channels = mark != "," and any("," in line for _, line in rows), []
    numbers = [i for i, _ in rows]
    columns = reading.columns_of([(i, _cells(line, mark)) for i, line in rows], width, file)
    for name, unit, cells in zip(names, units, columns, strict=True):
        if is_timestamp(next((cell.strip('" ') for cell in cells if not reading.is_empty(cell)), "")):
            channels.append(timestamp_channel(name, cells, numbers, file))
        else:
            channels.append(reading.number_channel(name, cells, numbers, file, comma, unit))
    if repeated:
        times = [channel for channel in channels if channel.is_timestamp or meant(channel.name) == (TIME, "")]
        steps = [(np.diff(time.values), HALF_DAY if time.is_timestamp else np.inf) for time in times]
        if not times or not all(((each >= 0.0) & (each < longest)).all() for each, longest in steps):
            raise LogError(reading.REPEATED, file=file, line=repeated[0])
        findings += (finding("CL440", line=repeated[0], times=len(repeated)),)
    return Record(file, "csv", tuple(channels), findings=findings)


def _first_row(lines: list[tuple[int, str]], file: Path) -> tuple[int, str | None]:
    """Return index and separator of the first row: numbers, with a row as wide below it; some columns may hold words."""
    shapes = [_shape(line) for _, line in lines[:LOOKED_AT]]
    pairs = list(itertools.pairwise(shapes))
    # Lines above a table may hold a number too, but most lines are rows.
    usual = Counter((mark, len(kinds)) for mark, kinds in shapes if NUMBER in kinds).most_common(1)
    candidates = (
        (k for k, (a, b) in enumerate(pairs) if _is_row(a) and _is_row(b) and len(a[1]) == len(b[1])),
        (k for k, (a, b) in enumerate(pairs) if _are_alike(a, b) and _fit(a, b) and (a[0], len(a[1])) == usual[0][0]),
        (k for k, shape in enumerate(shapes) if _is_row(shape)),
    )
    first = next(itertools.chain.from_iterable(candidates), None)
    if first is None:
        raise _no_row(lines, file)
    return _top(shapes, first), shapes[first][0]


def _top(shapes: list[Shape], first: int) -> int:
    """Return the first row of a table that contains row `first`: rows above it may hold words."""
    top = first
    while top and _are_alike(shapes[top - 1], shapes[first]) and NUMBER in shapes[top - 1][1]:
        top -= 1
    if top and _are_alike(shapes[top - 1], shapes[first]):  # the names
        return top
    return next(k for k in range(top, first + 1) if k == first or _is_row(shapes[k]) or _fit(shapes[k], shapes[first]))


def _shape(line: str) -> Shape:
    """Return the separator of a line, and the kind of each cell."""
    mark = _mark(line)
    return mark, [_kind(cell.strip().strip('"')) for cell in _cells(line, mark)]


def _kind(cell: str) -> int:
    """Return whether a cell is a number or timestamp, another value (true, false or empty), or a word."""
    if _NUMBER.match(cell) or is_timestamp(cell):
        return NUMBER
    try:
        return WORD if np.isinf(reading.number(cell)) else VALUE
    except ValueError:
        return WORD


def _is_row(shape: Shape) -> bool:
    return NUMBER in shape[1] and WORD not in shape[1]


def _are_alike(a: Shape, b: Shape) -> bool:
    return a[0] == b[0] and len(a[1]) == len(b[1])


def _fit(a: Shape, b: Shape) -> bool:
    """Tell whether two lines have numbers in the same columns, and nowhere a word above or below a number."""
    kinds = set(zip(a[1], b[1], strict=True))
    return (NUMBER, NUMBER) in kinds and not kinds & {(NUMBER, WORD), (WORD, NUMBER)}


def _no_row(lines: list[tuple[int, str]], file: Path) -> LogError:
    """Return the error for a file without a row of numbers; it names the bad cell of the best line."""
    if len(lines) <= 2:
        return LogError("has column names but no rows of numbers", file=file, line=lines[0][0])
    parted = [_cells(line, _mark(line)) for _, line in lines[:LOOKED_AT]]
    right = [[_kind(cell.strip().strip('"')) != WORD for cell in cells] for cells in parted]
    k = max(range(len(right)), key=lambda k: sum(right[k]))
    if not any(right[k]) or all(right[k]):
        return LogError("contains no row of numbers", file=file, line=lines[0][0])
    j = right[k].index(False)
    name = parted[0][j].strip(' "') if k and len(parted[0]) == len(parted[k]) else str(j + 1)
    what, where = reading.shown(parted[k][j]), reading.called(reading.name_and_unit(name)[0])
    fault = f"{what} in {where} is neither a number nor a date and time such as {EXAMPLE}"
    return LogError(f"contains no row of numbers: {fault}", file=file, line=lines[k][0])


def _is_closed(heads: list[tuple[int, str]], rows: list[tuple[int, str]], mark: str | None) -> bool:
    """Tell whether a mark at the end of each line closes the last cell instead of opening an empty one."""
    if mark is None or not all(line.rstrip(" ").endswith(mark) for _, line in rows):
        return False
    above = heads[-1][1] if heads else ""
    return not above or above.rstrip(" ").endswith(mark) or len(_cells(above, mark)) < len(_cells(rows[0][1], mark))


def _bare(line: str) -> str:
    text = line.strip()
    return "" if text.startswith(("#", "%")) else text


def _mark(line: str) -> str | None:
    """Return the separator of a line; None for blanks."""
    # With other separators, commas are decimal commas.
    marks = [mark for mark in MARKS if mark in line]
    if marks == [","] and re.search(r"\d,\d+\s+-?\d", line) and "," not in re.sub(r"\d,\d", "", line):
        return None
    return marks[0] if marks else None


def _cells(line: str, mark: str | None) -> list[str]:
    if mark is None:
        return re.findall(r"[^\s\[(]+\s*(?:[\[(][^\])]*[\])])?", line.strip()) if "[" in line or "(" in line else line.split()
    return reading.cells_of(line, mark)


def _heads(lines: list[list[str]], width: int, comments: list[list[str]]) -> tuple[list[str], list[str]]:
    """Return names and units of the columns, from the last one or two lines as wide as the table, else from such comments."""
    wide = [cells if width > 1 else [" ".join(cells)] for cells in lines if len(cells) == width or width == 1]
    wide = wide or [cells for cells in comments if len(cells) == width and not any(_NUMBER.match(cell.strip()) for cell in cells)]
    if not wide:
        return [str(j + 1) for j in range(width)], [""] * width
    below = [cell.strip().strip('"').strip("[]() ") for cell in wide[-1]]
    if len(wide) > 1 and all(re.fullmatch(r"[^\d\s]?[^\s]{0,7}", cell) for cell in below):
        above = [cell.strip().strip('"').strip() for cell in wide[-2]]
        if all(re.fullmatch(r'"?\s*([\[(].*[\])])?\s*"?', cell) for cell in wide[-1]):  # units in brackets, or empty
            return above, below
        bare = [(name, cell) for name, cell in zip(above, below, strict=True) if cell not in NO_UNIT]
        if bare and all(name and name != cell and reading.is_unit(cell) for name, cell in bare):
            return above, ["" if cell in NO_UNIT else cell for cell in below]
    pairs = [reading.name_and_unit(cell.strip().strip('"')) for cell in wide[-1]]
    return [name or str(j + 1) for j, (name, _) in enumerate(pairs)], [unit for _, unit in pairs]


# --- dates and times of day --------------------------------------------------------------------------------------------------------

DAY = 86_400 * 10**9
"""A day in nanoseconds."""
HALF_DAY = 43_200.0
"""Longest pause [s] of one record: a time of day that begins again looks like the next day's."""
EXAMPLE = "2024-05-31T14:03:21.250"
CURE = f"write timestamps as {EXAMPLE}, with or without a zone (Z or +02:00), or as seconds; or give --period"

_DATE = (
    r"(\d{1,4}[-/.]\d{1,2}[-/.]\d{1,4}|\d{8}(?=T)"
    r"|\d{1,2}(\.? |[-/.])[^\W\d_]{3,}\.?[-/. ]\d{2,4}|[^\W\d_]{3,}\.? \d{1,2},? \d{4})"
)
_ZONE = r"(?P<zone>Z|[+-]\d\d(:?\d\d)?)?\Z"
_CLOCK_LIKE = r"\d{1,2}:\d\d(:\d\d([.,:]\d+)?)?\s*([AaPp][Mm])?"
_LIKE = re.compile(rf"({_CLOCK_LIKE}|{_DATE}([T ,]*{_CLOCK_LIKE}|T\d{{6}}([.,]\d+)?)?)\s*{_ZONE}")
_CLOCK = r"([01]?\d|2[0-3]):[0-5]\d:[0-5]\d(\.\d{1,9})?"
_FORMS = {
    "ISO8601": re.compile(rf"(\d{{4}}-\d\d-\d\d[T ]{_CLOCK}|\d{{8}}T\d{{6}}(\.\d{{1,9}})?){_ZONE}"),
    "mixed": re.compile(rf"(\d{{1,2}}\.\d{{1,2}}\.\d{{4}}|\d{{1,2}}[- ][A-Za-z]{{3,9}}[- ]\d{{4}}) {_CLOCK}{_ZONE}"),
    "time of day": re.compile(rf"{_CLOCK}\Z"),
}
"""Unambiguous timestamps; the first two names are formats of `pandas.to_datetime`."""


def is_timestamp(cell: str) -> bool:
    """Tell whether a cell looks like a date, a time of day or both, ambiguous or not.

    >>> is_timestamp("2024-05-31T14:03:21.250Z"), is_timestamp("31.05.2024 14:03"), is_timestamp("1.5"), is_timestamp("")
    (True, True, False, False)
    >>> is_timestamp("31-May-2024 14:03:21"), is_timestamp("31. Mai 2024"), is_timestamp("may")
    (True, True, False)
    """
    return _LIKE.match(cell.strip()) is not None


def timestamp_channel(name: str, texts: Sequence[str], lines: Sequence[int], file: Path) -> Channel:
    """Return a column of timestamps as a channel of seconds from the first one.

    Errors go to `Channel.fault`, because the column may not be needed.

    Parameters
    ----------
    texts : sequence of str
        ISO 8601 with T or a blank, day first with dots, English month names, or times of day, which continue past midnight. Time zones
        in all rows or none. Empty cells are gaps.
    lines : sequence of int
        Line of each row in the file.
    """
    rows = [row for row, text in enumerate(texts) if not reading.is_empty(text)]
    seconds = np.full(len(texts), np.nan)
    findings: tuple[Finding, ...] = ()
    try:
        ticks, is_clock = _ticks([texts[row] for row in rows], name, [lines[row] for row in rows], file)
    except LogError as fault:
        return Channel(name, seconds, "s", is_timestamp=True, fault=fault)
    if ticks.size:
        day, clock = ticks // DAY, ticks % DAY
        if is_clock:
            day = np.cumsum(np.diff(clock, prepend=clock[0]) < -DAY // 2)
            findings = (finding("CL421", column=name),) if day[-1] else ()
        seconds[rows] = (day - day[0]) * 86400.0 + (clock - clock[0]) * 1e-9
    return Channel(name, seconds, "s", is_timestamp=True, findings=findings)


def _ticks(texts: list[str], name: str, lines: Sequence[int], file: Path) -> tuple[Index, bool]:
    """Return timestamps in nanoseconds, and whether they are times of day."""
    import pandas

    cells = [text.strip(' "').replace(",", ".") for text in texts]
    forms = [_form(cell) for cell in cells]
    wrong = [not form[0] or form != forms[0] for form in forms]
    if not any(wrong) and (not forms or forms[0][0] == "time of day"):
        return pandas.to_timedelta(cells).as_unit("ns").asi8, bool(forms)
    if not any(wrong):
        stamps = pandas.to_datetime(cells, format=forms[0][0], dayfirst=True, utc=True, errors="coerce")
        # Outside these years, nanoseconds do not fit 64 bits.
        wrong = (stamps.isna() | (stamps.year < 1678) | (stamps.year > 2261)).tolist()
        if not any(wrong):
            return stamps.as_unit("ns").asi8, False
    k = wrong.index(True)
    other = ", in another format than the first," if forms[k][0] and forms[k] != forms[0] else ""
    what = f"{reading.shown(texts[k])} in column {name!r}{other}"
    raise LogError(f"{what} is not an unambiguous timestamp: {CURE}", file=file, line=lines[k])


def _form(cell: str) -> tuple[str, bool]:
    """Return the name in `_FORMS` of a cell's format, empty if ambiguous, and whether it has a time zone."""
    matches = {name: match for name, form in _FORMS.items() if (match := form.match(cell))}
    return next(((name, bool(match.groupdict().get("zone"))) for name, match in matches.items()), ("", False))
