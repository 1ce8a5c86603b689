"""For any text, the reader soon returns a program or a ProgramError; written moves are read back."""

import itertools
import math
import random
import time
from dataclasses import replace
from importlib.resources import files
from pathlib import Path

import pytest
from each import each
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from contourlab.errors import ProgramError
from contourlab.program import (
    Arc,
    Dwell,
    Feed,
    Move,
    Plane,
    Point,
    Reader,
    Reading,
    Spline,
    Traverse,
    parse_program,
    read_program,
)  # fmt: skip
from contourlab.program.moves import PLANE_AXES

CORPUS = [(file.read_text(encoding="utf-8")) for file in sorted((Path(__file__).parents[1] / "golden" / "programs").glob("*.ngc"))]
SHIPPED = (files("contourlab") / "machines" / "programs" / "circle_diamond_square.ngc").read_text(encoding="utf-8")
CORPUS.append(SHIPPED)
MODERATE = settings(max_examples=150, deadline=2000, suppress_health_check=[HealthCheck.too_slow])

# --- any text -------------------------------------------------------------------------------------------------------


def answer(text: str) -> None:
    """Read `text`; expect a sound program, or an error with a place inside the text."""
    answer_within(text, 200_000)


def answer_within(text: str, most: int) -> None:
    """Do the same for at most `most` moves: damage may make a loop endless."""
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    made: list[Move] = []
    try:
        made += itertools.islice(Reader(lines, "fuzz", Reading(most_moves=50_000)).moves(), most)
    except ProgramError as error:
        assert error.file == "fuzz"
        assert 0 <= error.line <= len(lines)
        if error.column:
            assert 1 <= error.column <= len(lines[error.line - 1])
        return
    place: Point = (0.0, 0.0, 0.0)
    for move in made:
        assert 1 <= move.source_line <= len(lines)
        if isinstance(move, Dwell):
            assert 0.0 < move.seconds < math.inf
            continue
        assert move.start == place
        assert all(map(math.isfinite, move.end))
        place = move.end
        if isinstance(move, Spline):
            assert len(move.knots) == len(move.points) + move.degree + 1
            assert all(math.isfinite(v) for point in move.points for v in point)
        elif isinstance(move, Arc):
            assert 0.0 < move.radius < math.inf
            assert 0.0 < abs(move.sweep) < math.inf
        else:
            assert move.start != move.end
        if not isinstance(move, Traverse):
            assert 0.0 < move.feedrate < math.inf


@MODERATE
@given(st.text(max_size=200))
def test_any_text(text: str) -> None:
    answer(text)


@MODERATE
@given(content=st.binary(max_size=300))
def test_any_bytes(tmp_path_factory: pytest.TempPathFactory, content: bytes) -> None:
    file = tmp_path_factory.getbasetemp() / "fuzz.ngc"
    file.write_bytes(content)
    with pytest.raises(ProgramError):  # random bytes are no program: it needs an end and a motion
        read_program(file)


VOCABULARY = (
    "G0 G1 G2 G3 G4 G17 G18 G19 G20 G21 G90 G91 G90.1 G91.1 G94 M2 M30 F100 F0 P1 P2 I5 J5 K5 I-5 J0 R5 R-8 R0 "
    "X0 Y0 Z0 X10 Y10 Z10 X-5 Y2.5 Z.1 N10 (c) ; % ( ) G41 S100 #1 [1] O1 "
    "G5 G5.1 G5.2 G5.3 G7 G8 G10 G28 G28.1 G30 G43 G43.1 G43.2 G49 G52 G53 G54 G55 G59.3 G61 G61.1 G64 G73 G74 G80 G81 G82 G83 G84 G85 "
    "G86 G87 G88 G89 G92 G92.1 G92.2 G92.3 G93 G95 G98 G99 L1 L2 L20 L3 Q1 Q-1 H1 E1 @5 ^30 M3 M4 M5 M6 M19 M61 M62 M67 M98 M99 T1 D1 "
    "P0 P999999999 L999999999 R999999999 X999999999 Q0.0000001 #5221=3 #1=[#1+1] #<a>=2 #<_x> [1/0] /"
)
WORDS = st.one_of(
    st.sampled_from(VOCABULARY.split()),
    st.builds(lambda letter, value: f"{letter}{value:.4f}", st.sampled_from("XYZIJKRFPGMN"), st.floats(-2e3, 2e3)),
)


@MODERATE
@given(st.lists(st.lists(WORDS, max_size=6).map(" ".join), max_size=12).map("\n".join))
def test_any_words(text: str) -> None:
    answer("F100 G1 X1\n" + text + "\nM2")


FLOW = st.sampled_from(
    [
        "o1 sub", "o1 endsub", "o1 call", "o1 call [2] [3]", "o1 return", "o1 return [4]", "o2 if [1]", "o2 if [0]", "o2 elseif [1]",
        "o2 else",
        "o2 endif", "o3 while [1]", "o3 while [#1 LT 3]", "o3 endwhile", "o4 do", "o4 while [0]", "o4 while [1]", "o5 repeat [3]",
        "o5 endrepeat",
        "o3 break", "o3 continue", "o4 break", "o5 continue", "o5 break", "o6", "M98 P6", "M98 P6 L3", "M98 P1", "M99", "#1 = [#1 + 1]",
        "G91 G0 X1",
        "o<a> call", "o[#1] if [1]", "o1", "o1 while", "/o2 endif", "o5 repeat [999999999]", "G1 Y2", "M2", "G81 X1 Z-1 R1 L3",
    ]
)  # fmt: skip


@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.lists(FLOW, max_size=14))
def test_any_flow(lines: list[str]) -> None:
    """Endless loops end at a limit; this test stops after a thousand moves."""
    begun = time.perf_counter()
    moves = Reader(["F100", *lines, "G1 X1", "M2"]).moves()
    try:
        for _ in itertools.islice(moves, 1000):
            pass
    except ProgramError as error:
        assert 0 <= error.line <= len(lines) + 3
    assert time.perf_counter() - begun < 20.0


@each(
    "text",
    [
        "o1 sub\no1 call\no1 call\no1 endsub\no1 call",
        "o1 repeat [999999999]\no1 endrepeat",
        "o1 while [1]\no2 while [1]\no2 endwhile\no1 endwhile",
        "M98 P1 L999999999\nM2\nO1\nM99",
        "M98 P1\nM2\nO1\nM98 P1\nM99",
        "G2 I1 P999999999",
        "G81 X1 Z-1 R1 L999999999",
        "G83 X1 Z-1 R1 Q0.0000001",
        "G91 G81 X900000 Z-1 R1 L10000",
        "#1 = 1\n" + "#1 = [#1 * 10]\n" * 400 + "G0 X#1",
        "G0 X" + "[" * 100_000,
        "G0 X" + "#" * 100_000 + "1",
        "G0 X" + "-" * 100_000 + "1",
        "o" + "[" * 100_000,
        "o1 call" + " [1]" * 50_000,
        "o" + "1" * 100_000 + " call",
        "G10 L2 P1 X999999999\nG0 X1",
        "G10 L2 P1 R999999999\nG0 X1",
        "G92 X999999999\nG0 X1",
        "G43.1 Z999999999\nG0 X1",
        "#5221 = 999999999 #5220 = 77\nG55\nG54\nG0 X[#<_coord_system>]",
        "#5161 = 999999999\nG28",
        "G93 G1 X1 F999999999",
        "G95 S999999999 F99999 G1 X1",
        "G7\nG0 X999999",
    ],
)
def test_absurd_programs_end_soon(text: str) -> None:
    begun = time.perf_counter()
    answer(f"F100 S10 M3\n{text}\nM2")
    assert time.perf_counter() - begun < 10.0


@MODERATE
@given(st.data())
def test_damaged_programs(data: st.DataObject) -> None:
    text = data.draw(st.sampled_from(CORPUS))
    for _ in range(data.draw(st.integers(1, 4))):
        at = data.draw(st.integers(0, len(text)))
        cut = data.draw(st.integers(0, 3))
        new = data.draw(st.sampled_from(["", "-", ".", "9", " ", "\n", "G", "X", "(", ")", "%", "é", "o", "[", "]", "#", "/", "1"]))
        text = text[:at] + new + text[at + cut :]
    answer_within(text, 3000)


@pytest.mark.parametrize(
    "line",
    ["G0 X1" + " " * 10**6, "(" * 10**6, ")" * 10**6, "X" + "1" * 10**6, "X" + "1 " * 10**6, "()" * 10**6, "X1" * 10**6,
     "G0 X1 (" + "c" * 10**6, ";" * 10**6, "%" * 10**6, "+" * 10**6, "X" + "." * 10**6],
    ids=lambda line: repr(line[:12]),
)  # fmt: skip
def test_endless_lines_do_not_hang(line: str) -> None:
    answer(f"{line}\nM2")  # a quadratic scan of a million characters would not finish


# --- written moves are read back ------------------------------------------------------------------------------------

DIRECTIONS = [(1, 0), (0, 1), (-1, 0), (0, -1)]


class Writer:
    """Writes moves as blocks, carelessly, in both units and both distance modes."""

    def __init__(self, rng: random.Random) -> None:
        self.rng, self.lines, self.place = rng, [""], (0.0, 0.0, 0.0)
        self.inch, self.incremental = rng.random() < 0.3, rng.random() < 0.3
        self.block(["G20" if self.inch else "G21", "G91" if self.incremental else "G90"])

    def number(self, metres: float) -> str:
        value = metres / 0.0254 if self.inch else metres * 1000.0
        return f"{value:.{self.rng.choice([14, 15])}f}"

    def axes(self, end: Point) -> list[str]:
        words = []
        for axis, letter in enumerate("XYZ"):
            if end[axis] != self.place[axis] or self.rng.random() < 0.2:
                words.append(letter + self.number(end[axis] - (self.place[axis] if self.incremental else 0.0)))
        self.place = end
        return words

    def block(self, words: list[str]) -> int:
        self.rng.shuffle(words)
        text = ""
        for word in words:
            spaced = "".join(c + " " * (self.rng.random() < 0.1) for c in word)
            text += (spaced.lower() if self.rng.random() < 0.5 else spaced) + self.rng.choice(["", " ", "\t", "(c)"])
        number = f"N{len(self.lines)} " if self.rng.random() < 0.5 else ""
        self.lines.append(number + text + self.rng.choice(["", "", " ; the rest"]))
        return len(self.lines)

    def write(self, move: Move) -> Move:
        """Write one move; return it with its line."""
        if isinstance(move, Dwell):
            return replace(move, source_line=self.block(["G4", f"P{move.seconds}"]))
        words = []
        if not isinstance(move, Traverse):
            words.append("F" + self.number(move.feedrate * 60.0))
        if isinstance(move, Arc):
            words += [{"XY": "G17", "YZ": "G19", "ZX": "G18"}[move.plane], "G3" if move.turns > 0 else "G2"]
            words += self.arc_words(move)
        else:
            words.append("G0" if isinstance(move, Traverse) else "G1")
        return replace(move, source_line=self.block(words + self.axes(move.end)))

    def arc_words(self, move: Arc) -> list[str]:
        first, second, _ = PLANE_AXES[move.plane]
        words = [f"P{abs(move.turns)}"] if abs(move.turns) > 1 or self.rng.random() < 0.2 else []
        quarters = round(abs(move.sweep) / (math.pi / 2)) % 4
        if quarters in (1, 3) and self.rng.random() < 0.5:
            return [*words, "R" + self.number(move.radius if quarters == 1 else -move.radius)]
        return [*words, *("IJK"[axis] + self.number(move.centre[axis] - move.start[axis]) for axis in (first, second))]


@st.composite
def move_lists(draw: st.DrawFn) -> list[Move]:
    """Connected moves from machine zero on a grid of micrometres; the last one is a feed."""
    place: Point = (0.0, 0.0, 0.0)
    moves: list[Move] = []
    micrometres = st.integers(-300_000, 300_000)
    for kind in [*draw(st.lists(st.sampled_from(["traverse", "feed", "arc", "dwell"]), max_size=8)), "feed"]:
        feedrate = draw(st.integers(1, 20_000)) / 60_000.0
        if kind == "dwell":
            moves.append(Dwell(draw(st.integers(1, 5000)) / 1000.0, 0))
            continue
        if kind == "arc":
            moves.append(draw(arcs(place, feedrate)))
        else:
            end = tuple(draw(micrometres) * 1e-6 for _ in range(3))
            if math.dist(end, place) < 1e-9:
                continue
            straight = (end[0], end[1], end[2])
            moves.append(Traverse(place, straight, 0) if kind == "traverse" else Feed(place, straight, feedrate, 0))
        place = moves[-1].end  # type: ignore[union-attr]
    return moves


@st.composite
def arcs(draw: st.DrawFn, start: Point, feedrate: float) -> Arc:
    """An arc of whole quarter turns from `start`, or a helix."""
    plane: Plane = draw(st.sampled_from(["XY", "YZ", "ZX"]))
    first, second, normal = PLANE_AXES[plane]
    radius = draw(st.integers(50, 200_000)) * 1e-6
    out, there = draw(st.sampled_from(DIRECTIONS)), draw(st.sampled_from(DIRECTIONS))
    centre, end = list(start), list(start)
    for axis, begin, finish in ((first, out[0], there[0]), (second, out[1], there[1])):
        centre[axis] = start[axis] - radius * begin
        end[axis] = centre[axis] + radius * finish if out != there else start[axis]
    end[normal] += draw(st.sampled_from([0.0, 0.0, 1e-3, -2.5e-3]))
    turns = draw(st.sampled_from([1, 1, 1, 2, 5])) * draw(st.sampled_from([-1, 1]))
    return Arc(start, (end[0], end[1], end[2]), (centre[0], centre[1], centre[2]), plane, turns, feedrate, 0)


def figures(move: Move) -> list[float]:
    if isinstance(move, Dwell):
        return [move.seconds]
    numbers = [*move.start, *move.end]
    if not isinstance(move, Traverse):
        numbers.append(move.feedrate)
    if isinstance(move, Arc):
        numbers += [*move.centre, move.sweep]
    return numbers


@MODERATE
@given(moves=move_lists(), seed=st.integers(0, 2**32))
def test_written_moves_are_read_back(moves: list[Move], seed: int) -> None:
    writer = Writer(random.Random(seed))
    expected = [writer.write(move) for move in moves]
    if not any(not isinstance(move, Dwell) for move in expected):
        return
    program = parse_program("\n".join([*writer.lines, "M2"]))
    assert len(program.moves) == len(expected)
    for read, wanted in zip(program.moves, expected, strict=True):
        assert type(read) is type(wanted)
        assert read.source_line == wanted.source_line
        if isinstance(read, Arc) and isinstance(wanted, Arc):
            assert (read.plane, read.turns) == (wanted.plane, wanted.turns)
        assert figures(read) == pytest.approx(figures(wanted), rel=1e-9, abs=1e-12)
