"""What kind of file is this? Every command refuses a file of another kind by its kind."""

from __future__ import annotations

from pathlib import Path

import pytest
from typed_commands import Run

from contourlab.file_kinds import kind_of, mistaken

CONTENTS = {
    "a PNG picture": b"\x89PNG\r\n\x1a\n\0\0",
    "a web page": b"\n<!DOCTYPE html>\n<html></html>\n",
    "a file of zero bytes only": bytes(5000),
    "an empty file": b"",
    "a scenario": b'machine = "xyz.toml"\ncontroller = "c.toml"\nprogram = "part.ngc"\n',
    "a machine": b'[machine]\nname = "m"\naxes = ["x"]\n[axes.x]\n',
    "a controller": b'[controller.axes."*"]\n',
    "an axis": b'plant = {kind = "mass-damper"}\n',
    "a file of answers": b'axes = "x, y"\nservo_period = "1 ms"\n',
    "a part program": b"%\n(part)\nN10 G21 G1 X10 F600\nM2\n",
    "a program for a Heidenhain control": b"0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S3000\n2 L X+10 Y+5 R0 FMAX\n",
    "a program for a Sinumerik": b"N10 G54 G64 G90\nN20 TRANS X10\nN50 G3 X30 Y10 CR=10\n",
    "a program for a 3D printer": b"G21\nM82\nM104 S200\nG1 X10 E0.5 F1800\n",
    "a log": b"time,x\n0,1\n0.001,2\n0.002,3\n",
    "": b"# a comment alone\n",
}


@pytest.mark.parametrize("kind", CONTENTS)
def test_a_file_is_known_by_its_content(kind: str, tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_bytes(CONTENTS[kind])
    assert kind_of(file) == kind
    assert mistaken(file) == mistaken(file, "a log", kind) == ""
    wanted = "a scenario" if kind == "a log" else "a log"
    assert bool(mistaken(file, wanted)) == bool(kind)


def test_lines_that_end_in_a_blank_are_a_log(tmp_path: Path) -> None:
    file = tmp_path / "halsampler.txt"
    file.write_text("0 272.500000 0.000000 \n1 272.500000 0.000300 \n")
    assert kind_of(file) == "a log"


@pytest.mark.parametrize(
    "words",
    [
        ("run", "FILE", "--machine", "xyz", "--controller", "xyz-controller"),
        ("run", "part.ngc", "--machine", "FILE", "--controller", "xyz-controller"),
        ("run", "part.ngc", "--machine", "xyz", "--controller", "FILE"),
        ("check", "FILE"),
        ("compare", "FILE"),
        ("tune", "FILE"),
        ("notch", "FILE"),
        ("swap", "builtin:ghaffari/demo-stage", "--axis", "1", "--with", "FILE"),
        ("export", "FILE", "--to", "c99"),
        ("measure", "FILE"),
        ("interpolate", "FILE"),
        ("new", "machine", "--answers", "FILE", "--out", "made"),
        ("commission", "linuxcnc", "FILE", "x.hal"),
    ],
    ids=lambda words: " ".join(words[:1]),
)
def test_every_command_names_the_kind_in_one_line(words: tuple[str, ...], contourlab: Run, tmp_path: Path) -> None:
    (tmp_path / "part.ngc").write_bytes(CONTENTS["a part program"])
    for kind, file in (("a PNG picture", "picture.ngc"), ("a web page", "page.toml"), ("a file of zero bytes only", "zeros.csv")):
        (tmp_path / file).write_bytes(CONTENTS[kind])
        said = contourlab(*(file if word == "FILE" else word for word in words))
        assert said.code == 2, said
        assert said.err.startswith(f"contourlab: {file}: is {kind}, not "), said.err
        assert len(said.err.splitlines()) == 1


def test_a_file_of_the_wrong_kind_says_what_it_is_for(contourlab: Run, tmp_path: Path) -> None:
    for kind in ("a machine", "a controller", "a log"):
        (tmp_path / "it.toml").write_bytes(CONTENTS[kind])
        assert f"is {kind}, not a scenario" in contourlab("run", "it.toml").err
        assert f"is {kind}, not a part program" in contourlab("canon", "it.toml").err
    (tmp_path / "folder").mkdir()
    assert "is a folder, not an axis" in contourlab("swap", "builtin:ghaffari/demo-stage", "--axis", "1", "--with", "folder").err


@pytest.mark.parametrize(
    "text",
    [
        b"(TRANS) G0 X1\nM190 P2 (M82)\n", b"; CR=10 in G500\nG0 X1\n", b"; M104 S200\nG0 X1\n", b"N1 MSG1\nG0 X1\n",
        b"M67 E0 Q2\nG0 X1\n", b"(MSG, hello)\nG0 X1\n",
    ],
)  # fmt: skip
def test_words_of_another_language_in_a_comment_are_none(text: bytes, tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_bytes(text)
    assert kind_of(file) == "a part program"
