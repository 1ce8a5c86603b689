"""O-words: follow the lines of a program through subprograms, conditions and loops; M98 and M99.

A loop or condition that is not executed is skipped up to the closing line with the same label: a number, a name in <>, or an expression
in []. Lines are kept only while a loop or call may return to them.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

from contourlab.errors import ProgramError, refuse
from contourlab.program.block import NUMBER, Cursor, Parameters, read_value, without_blanks
from contourlab.program.vocabulary import BlockError

KEYWORDS = (
    "elseif", "else", "endif", "endsub", "endwhile", "endrepeat", "sub", "call", "return", "do", "while", "if", "break", "continue",
    "repeat",
)  # fmt: skip
_KEYWORD = re.compile("|".join(KEYWORDS))
starts_o_word = re.compile(r"[ \t]*(?:/[ \t]*)?(?:[nN][ \t0-9.]*)?[oO]").match
_COMMENT_INSIDE = re.compile(r"[^;(]*(?:\([^)]*\)[ \t]*)+[^;(\s]")
_DIGITS = re.compile(r"[0-9]+")
_CONDITIONS = ("if", "elseif", "while", "repeat")
_VALUES = ("return", "endsub")
MOST_ARGUMENTS = 30
LONGEST_LINE = 100_000
"""Most characters of a line."""
BATCH = 1024
"""Least number of lines to drop at once."""


class OWord(NamedTuple):
    """An O-word.

    Parameters
    ----------
    label : str
        Number without leading zeros, or name in lower case.
    keyword : str
        One of `KEYWORDS`; empty for ``O100`` alone, a subprogram of M98.
    values : tuple of float
        Arguments of a call; the condition, number of repeats, or returned value.
    """

    label: str
    keyword: str
    values: tuple[float, ...]
    column: int


def read_o_word(line: str, parameters: Parameters, *, skipping: bool = False) -> OWord:
    """Read a line with an O-word.

    Parameters
    ----------
    skipping : bool
        Whether to read only label and keyword, because conditions on skipped lines may be undefined.

    Raises
    ------
    BlockError
        If the line is no O-word, or an expression has no value.
    """
    cursor = Cursor(*without_blanks(line))
    if cursor.next == "/":
        cursor.at += 1
    if cursor.next == "n":
        cursor.at += 1
        cursor.take(NUMBER)
    column = cursor.column
    cursor.at += 1  # the O
    label, keyword = _label(cursor, parameters), cursor.take(_KEYWORD)
    if not keyword and cursor.next:
        raise BlockError(f"CL840 O{label} needs a keyword: write one of {', '.join(KEYWORDS)}", cursor.column)
    if skipping:
        return OWord(label, keyword, (), column)
    if _COMMENT_INSIDE.match(line):
        raise BlockError("CL802 a comment cannot stand inside an O-word: move it to the end of the line", line.index("(") + 1)
    values = []
    while cursor.next == "[":
        values.append(read_value(cursor, parameters))
    if cursor.next:
        raise BlockError(f"CL840 '{cursor.next}' cannot follow an O-word: write it on its own line", cursor.column)
    _check_values(keyword, len(values), column)
    return OWord(label, keyword, tuple(values), column)


def _check_values(keyword: str, count: int, column: int) -> None:
    if keyword in _CONDITIONS and count != 1:
        raise BlockError(f"CL840 {keyword} takes one expression: write it in brackets, as in [#1 LT 5]", column)
    refuse(keyword in _VALUES and count > 1, BlockError, f"CL840 {keyword} takes at most one value in brackets: delete the others", column)
    if keyword == "call" and count > MOST_ARGUMENTS:
        raise BlockError(f"CL840 a call takes at most {MOST_ARGUMENTS} arguments: pass the rest in #31 and up", column)
    if keyword not in (*_CONDITIONS, *_VALUES, "call") and count > 0:
        raise BlockError(f"CL840 {keyword or 'O'} takes no value: delete the brackets", column)


def _label(cursor: Cursor, parameters: Parameters) -> str:
    if cursor.next == "<":
        return cursor.name("O-word")
    column, digits = cursor.column, cursor.take(_DIGITS)
    if digits:
        refuse(len(digits) > 9, BlockError, "CL840 the number of an O-word has at most 9 digits: shorten it", column)
        return str(int(digits))
    value = read_value(cursor, parameters)
    if abs(value - round(value)) > 1e-4 or not 0 <= value <= 1e9:
        raise BlockError(f"CL840 the label of an O-word must be a whole number: correct {value:g}", column)
    return str(round(value))


class Tape:
    """The lines of a file, kept from the first line that a loop or call may return to.

    Parameters
    ----------
    name : str
        The file's name, for errors.
    """

    def __init__(self, lines: Iterator[str], name: str) -> None:
        self._lines, self.name = lines, name
        self._kept: list[str] = []
        self._first = 0
        self._pinned: int | None = None
        self.ended = False

    @classmethod
    def of(cls, lines: list[str], first: int, name: str) -> Tape:
        """Return a tape that keeps all its lines; the first line has the index `first`."""
        tape = cls(iter(()), name)
        tape._kept, tape._first, tape._pinned, tape.ended = lines, first, first, True
        return tape

    def line(self, index: int) -> str | None:
        """Return a line by its index from 0; None after the end; raise ProgramError for a line longer than `LONGEST_LINE`."""
        while index >= self._first + len(self._kept):
            following = None if self.ended else next(self._lines, None)
            if following is None:
                self.ended = True
                return None
            if len(following) > LONGEST_LINE:
                fault = f"CL805 the line has more than {LONGEST_LINE} characters: divide it"
                raise ProgramError(fault, file=self.name, line=self._first + len(self._kept) + 1, column=LONGEST_LINE + 1)
            self._kept.append(following)
        return self._kept[index - self._first]

    def pin(self, index: int) -> None:
        """Keep the lines from an index on permanently."""
        self._pinned = index if self._pinned is None else min(self._pinned, index)

    def forget(self, before: int) -> None:
        """Drop the lines before an index that are not pinned."""
        stop = before if self._pinned is None else min(before, self._pinned)
        # In batches, because dropping the first item of a list moves all others.
        if stop - self._first >= BATCH:
            del self._kept[: stop - self._first]
            self._first = stop

    def __len__(self) -> int:
        """Number of kept lines."""
        return len(self._kept)


DEEPEST_CALL = 9
"""LinuxCNC has ten levels, including the main program."""
LONG_LINE = 32
"""A line counts once more for each so many characters."""
MOST_REPEATS = 1e9
_ENDS = {"while": "endwhile", "do": "while", "repeat": "endrepeat"}


@dataclass(slots=True)
class _Loop:
    label: str
    kind: str
    start: int
    remaining: int = 0
    ifs: int = 0
    mark: object = None


@dataclass(slots=True)
class _Frame:
    """A running subprogram, or the main program."""

    tape: Tape
    index: int
    label: str = ""
    fanuc: bool = False
    repeats: int = 1
    start: int = 0
    loops: list[_Loop] = field(default_factory=list)
    ifs: list[str] = field(default_factory=list)


@dataclass(slots=True)
class _Seen:
    """Starts of subprograms in a file, by label and keyword, up to a line."""

    reached: int = 0
    places: dict[tuple[str, str], list[int]] = field(default_factory=dict)


class Walker:
    """Yield the lines in the order of execution.

    Parameters
    ----------
    find : callable
        Returns the tape of a subprogram file by name, or None.
    most : int
        See `Reading.most_moves`.
    """

    def __init__(self, tape: Tape, parameters: Parameters, find: Callable[[str], Tape | None], most: int) -> None:
        self.parameters, self._find, self._left, self._most = parameters, find, most, most
        self.main = tape
        self._frames = [_Frame(tape, 0)]
        self._subs: dict[str, tuple[Tape, int]] = {}
        self._seen: dict[str, _Seen] = {}
        self._begun: dict[tuple[str, str], tuple[str, int]] = {}
        self._repeated = False
        self.keywords: tuple[str, ...] | None = None
        """Keywords of O-words that the dialect has; None for all."""
        self.on_region: Callable[[bool, int], None] | None = None
        """Called where an outermost loop or call begins (True) and after it (False), with the number of its first or last line."""

    @property
    def frame(self) -> _Frame:
        """The innermost subprogram, or the main program."""
        return self._frames[-1]

    @property
    def place(self) -> tuple[str, int]:
        """File and line number (from 1) of the line yielded last."""
        return self.frame.tape.name, self.frame.index

    @property
    def main_line(self) -> int:
        """Line number in the main file; while a subprogram in another file runs, the line of the call."""
        return next(frame.index for frame in reversed(self._frames) if frame.tape.name == self.main.name)

    @property
    def in_subprogram(self) -> bool:
        """Whether a subprogram is running."""
        return len(self._frames) > 1

    @property
    def repeating(self) -> bool:
        """Whether a loop or a subprogram is running."""
        return bool(self.frame.loops) or self.in_subprogram

    def lines(self) -> Iterator[str]:
        """Yield lines until the end of the text; execute O-words."""
        while True:
            frame, repeating = self.frame, self.repeating
            if repeating != self._repeated:
                self._repeated = repeating
                if self.on_region is not None:
                    self.on_region(repeating, self._frames[0].index)
            line = frame.tape.line(frame.index)
            if line is None:
                self._at_end(frame)
                return
            frame.index += 1
            if repeating:
                self.spend(1 + len(line) // LONG_LINE)
            else:
                frame.tape.forget(frame.index - 1)
            if starts_o_word(line):
                word = read_o_word(line, self.parameters)
                if self.keywords is not None and word.keyword not in self.keywords:
                    raise BlockError(f"CL840 O{word.label} {word.keyword} is LinuxCNC's: write plain moves, or M98 with M99", word.column)
                getattr(self, f"_{word.keyword or 'plain'}")(word)
            else:
                yield line

    def spend(self, work: int) -> None:
        """Count repeated lines and additional moves; refuse more than the limit."""
        self._left -= work
        if self._left < 0:
            cure = "check for an endless loop, or raise the limit with --most-moves (in a scenario most_moves)"
            raise BlockError(f"CL845 loops, subprograms and cycles make more than {self._most} lines and moves: {cure}", 0)

    def _at_end(self, frame: _Frame) -> None:
        if self.in_subprogram:
            raise BlockError(f"CL841 the subprogram O{frame.label} has no end: write O{frame.label} endsub, or M99 if M98 calls it", 0)
        if frame.loops:
            loop = frame.loops[-1]
            raise BlockError(f"CL841 O{loop.label} {loop.kind} has no end: write O{loop.label} {_ENDS[loop.kind]}", 0)

    def _begin(self, word: OWord) -> None:
        """Refuse a label that another condition or loop of the same subprogram uses."""
        place = self.place
        first = self._begun.setdefault((self.frame.label, word.label), place)
        if first != place:
            raise BlockError(
                f"CL843 O{word.label} {word.keyword}: line {first[1]} already uses this label; choose another one", word.column
            )

    # Conditions

    def _if(self, word: OWord) -> None:
        self._begin(word)
        while word.values[0] == 0.0:
            branch = self._skip_to(word.label, ("elseif", "else", "endif"), word)
            if branch.keyword == "endif":
                return
            if branch.keyword == "else":
                break
            line = self.frame.tape.line(self.frame.index - 1)
            assert line is not None  # it has just been read
            word = read_o_word(line, self.parameters)
        self.frame.ifs.append(word.label)

    def _elseif(self, word: OWord) -> None:
        # The branch before it has been executed.
        self._endif(word)
        self._skip_to(word.label, ("endif",), word)

    _else = _elseif

    def _endif(self, word: OWord) -> None:
        ifs, loops = self.frame.ifs, self.frame.loops
        if len(ifs) <= (loops[-1].ifs if loops else 0) or ifs[-1] != word.label:
            raise BlockError(f"CL842 O{word.label} {word.keyword} has no if: write O{word.label} if before it", word.column)
        ifs.pop()

    # Loops

    def _while(self, word: OWord) -> None:
        frame, loop = self.frame, self._innermost(word.label)
        if loop is not None and loop.kind == "do":
            if word.values[0] != 0.0:
                self._turn(loop, word)
                frame.index = loop.start
            else:
                frame.loops.pop()
            return
        if loop is None:
            self._begin(word)
            self._enter_loop(word, "while", frame.index - 1)
        if word.values[0] == 0.0:
            frame.loops.pop()
            self._skip_to(word.label, ("endwhile",), word)

    def _enter_loop(self, word: OWord, kind: str, start: int, remaining: int = 0) -> None:
        self.frame.loops.append(_Loop(word.label, kind, start, remaining, len(self.frame.ifs)))

    def _endwhile(self, word: OWord) -> None:
        loop = self._wanted(word, "while")
        self._turn(loop, word)
        self.frame.index = loop.start

    def _turn(self, loop: _Loop, word: OWord) -> None:
        """Refuse a loop whose condition cannot change: a pass sets no parameter and ends at the same position."""
        mark = self.parameters.changes, self.parameters.position()
        if mark == loop.mark:
            raise BlockError(f"CL845 O{word.label} {loop.kind} never ends: change a parameter or the position in the loop", word.column)
        loop.mark = mark

    def _do(self, word: OWord) -> None:
        self._begin(word)
        self._enter_loop(word, "do", self.frame.index)

    def _repeat(self, word: OWord) -> None:
        if abs(word.values[0]) > MOST_REPEATS:
            raise BlockError(f"CL806 repeat [{word.values[0]:g}]: keep the number of repeats below {MOST_REPEATS:g}", word.column)
        count = round(word.values[0])
        self._begin(word)
        if count < 1:
            self._skip_to(word.label, ("endrepeat",), word)
        else:
            self._enter_loop(word, "repeat", self.frame.index, count)

    def _endrepeat(self, word: OWord) -> None:
        loop = self._wanted(word, "repeat")
        loop.remaining -= 1
        if loop.remaining > 0:
            self.frame.index = loop.start
        else:
            self.frame.loops.pop()

    def _break(self, word: OWord) -> None:
        loop = self._leave_inner(word)
        self.frame.loops.pop()
        self._skip_to(word.label, (_ENDS[loop.kind],), word)

    def _continue(self, word: OWord) -> None:
        self._skip_to(word.label, (_ENDS[self._leave_inner(word).kind],), word)
        self.frame.index -= 1  # execute the closing line

    def _innermost(self, label: str) -> _Loop | None:
        loops = self.frame.loops
        return loops[-1] if loops and loops[-1].label == label else None

    def _wanted(self, word: OWord, kind: str) -> _Loop:
        loop = self._innermost(word.label)
        if loop is None or loop.kind != kind:
            raise BlockError(f"CL842 O{word.label} {word.keyword} has no {kind}: write O{word.label} {kind} before it", word.column)
        return loop

    def _leave_inner(self, word: OWord) -> _Loop:
        """Leave the loops inside the loop with this label, and return that loop."""
        loops = self.frame.loops
        if not any(loop.label == word.label and loop.kind != "repeat" for loop in loops):
            cure = "correct the label, or write a while in place of a repeat"
            raise BlockError(f"CL842 O{word.label} {word.keyword} is not inside a while or do with this label: {cure}", word.column)
        while loops[-1].label != word.label:
            loops.pop()
        del self.frame.ifs[loops[-1].ifs :]
        return loops[-1]

    # Subprograms

    def _sub(self, word: OWord) -> None:
        refuse(
            self.in_subprogram, BlockError, f"CL843 O{word.label} sub is inside another subprogram: move it before or after", word.column
        )
        if word.label in self._subs:
            cure = "move it before the first call, or after M2"
            raise BlockError(f"CL843 O{word.label} sub is defined twice, or the program runs into it after a call: {cure}", word.column)
        self.parameters.defining = True
        try:
            self._subs[word.label] = self._body(self.frame.tape, self.frame.index, word)
            self._skip_to(word.label, ("endsub",), word)
        finally:
            self.parameters.defining = False

    def _body(self, tape: Tape, start: int, word: OWord) -> tuple[Tape, int]:
        """Keep the lines of a subprogram from `start` to its endsub, or the end of the text."""
        end, lines = start, []
        while (line := tape.line(end)) is not None:
            lines.append(line)
            end += 1
            o_word = self._ahead_of_time(line)
            if o_word and o_word.keyword == "endsub" and o_word.label == word.label:
                break
        return Tape.of(lines, start, tape.name), start

    def _ahead_of_time(self, line: str) -> OWord | None:
        """Return the O-word of a line ahead of its execution; only the execution reports faults."""
        try:
            return read_o_word(line, self.parameters, skipping=True) if starts_o_word(line) else None
        except BlockError:
            return None

    def _call(self, word: OWord) -> None:
        self.enter(word.label, list(word.values), word.column)

    def enter(self, label: str, arguments: list[float] | None, column: int, repeats: int = 1) -> None:
        """Enter a subprogram: by an O-call with arguments, or by M98 (None) with repeats.

        Raises
        ------
        BlockError
            If there is no such subprogram, or calls are nested too deep.
        """
        if len(self._frames) > DEEPEST_CALL:
            raise BlockError(f"CL845 calls are nested more than {DEEPEST_CALL} deep: check for a subprogram that calls itself", column)
        if repeats < 1:
            return
        fanuc = arguments is None
        if label not in self._subs:
            file = self._find(label)
            place = (self.frame.tape, self.frame.index) if file is None else (file, 0)
            self._subs[label] = self._ahead(*place, label, fanuc, column)
        tape, start = self._subs[label]
        self.parameters.enter(arguments)
        self._frames.append(_Frame(tape, start, label, fanuc, repeats, start))

    def _ahead(self, tape: Tape, start: int, label: str, fanuc: bool, column: int) -> tuple[Tape, int]:
        """Search for a subprogram from a line onwards; remember the lines searched."""
        seen = self._seen.setdefault(tape.name, _Seen())
        wanted = (label, "" if fanuc else "sub")
        while True:
            places = seen.places.get(wanted, [])
            at = bisect_left(places, start)
            if at < len(places):
                tape.pin(places[at])
                return tape, places[at]
            seen.reached = max(seen.reached, start)
            line = tape.line(seen.reached)
            if line is None:
                break
            seen.reached += 1
            o_word = self._ahead_of_time(line)
            if o_word and o_word.keyword in ("", "sub"):
                seen.places.setdefault((o_word.label, o_word.keyword), []).append(seen.reached)
        missing = f"no subprogram O{label} in the program, and no file {label}.ngc next to it"
        raise BlockError(f"CL844 {missing}: correct the label, or add the subprogram", column)

    def _endsub(self, word: OWord) -> None:
        frame = self.frame
        # A return may have the label of its condition.
        if not self.in_subprogram or frame.fanuc or (word.keyword == "endsub" and frame.label != word.label):
            cure = f"write O{word.label} sub before it, or delete it"
            raise BlockError(f"CL842 O{word.label} {word.keyword} is not inside a subprogram with this label: {cure}", word.column)
        self.parameters.give_back(word.values[0] if word.values else None)
        self._leave()

    _return = _endsub

    def _leave(self) -> None:
        self._frames.pop()
        self.parameters.leave()

    def _plain(self, word: OWord) -> None:
        # O100 alone names a subprogram for M98 and has no effect.
        if self.in_subprogram and not self.frame.fanuc:
            raise BlockError(
                f"CL843 O{word.label} (a subprogram for M98) is inside another subprogram: move it before or after", word.column
            )

    def back(self) -> bool:
        """Return from M98 at M99, or repeat; False in the main program, which ends there."""
        frame = self.frame
        if not self.in_subprogram:
            return False
        if not frame.fanuc:
            raise BlockError(f"CL842 M99 only ends subprograms that M98 calls: write O{frame.label} endsub instead", 0)
        frame.repeats -= 1
        if frame.repeats > 0:
            frame.index = frame.start
        else:
            self._leave()
        return True

    # Looking for a line

    def _skip_to(self, label: str, keywords: tuple[str, ...], word: OWord) -> OWord:
        """Skip past the next line with a label and one of the keywords."""
        frame, begun = self.frame, self.frame.index
        while (line := frame.tape.line(frame.index)) is not None:
            frame.index += 1
            if starts_o_word(line):
                o_word = read_o_word(line, self.parameters, skipping=True)
                if o_word.label == label and o_word.keyword in keywords:
                    return o_word
                if o_word.keyword == "sub" and keywords == ("endsub",):
                    raise BlockError(f"CL843 O{o_word.label} sub is inside O{label} sub: move it before or after", o_word.column)
            if self.repeating:
                self.spend(1 + len(line) // LONG_LINE)
            else:
                frame.tape.forget(frame.index)
        frame.index = begun  # report the line without an end
        raise BlockError(f"CL841 O{label} {word.keyword} has no end: write O{label} {keywords[-1]}", word.column)
