"""Damaged input files: each command ends with an exit code that it states, or with the answer of the intact file."""

from __future__ import annotations

import contextlib
import io
import random
import shlex
import string
import sys
import tempfile
from dataclasses import dataclass, replace
from importlib.resources import files
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "tests" / "helpers"))
from linuxcnc_rig import Rig
from typed_commands import DRAG, ON_XYZ

CODES = {0, 1, 2, 3, 130}
ODD = (
    b"nan inf -inf 1e308 1e-308 -1 0 -0.0 99999999999 1e400 [ ] { } \" ' # ( ) % ; , = . \\ / ../ \0 \xff \r\n [[]] true none um 1/s"
).split(b" ")
FEW = ("--most-moves", "500")  # endless loops are frequent
PROGRAM = b"""%
o<pocket> sub
#<depth> = #1
o1 while [#<depth> GT -2]
G0 X0 Y0
G1 Z[#<depth>] F200
G2 X5 Y5 I5 J0
G64 P0.02
G5.1 X2 Y3 I1 J1
#<depth> = [#<depth> - 1]
o1 endwhile
o<pocket> endsub
G21 G90 G17 G54
o<pocket> call [0]
G81 X1 Y1 Z-1 R2 F100
G80
G20 G91
G1 X[SIN[30] * 2] F10
M30
%
"""
SHAPE = (
    b'<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100"><g transform="rotate(10)">'
    b'<path d="M 10 10 L 30 10 A 10 10 0 0 1 30 30 C 20 40 15 40 10 30 Z"/></g></svg>'
)
AROUND_SHAPE = """machine = "builtin:xyz"
controller = "builtin:xyz-controller"
contour = "{}"
[feed]
law = "planned"
feedrate = "1000 mm/min"
"""
OPEN = ("times.jsonl", "scenario.toml")
"""Files of a store that a digest need not protect."""
TOOLS = b"T1 P1 D3.0 Z+25.4 ; end mill\nT2 P2 D6.0 X0.1 Y0 Z-3 ; drill\n"
TOOLED = b"%\nG21 G90\nT1 M6 G43 H1\nG1 X1 F100\nT2 M6 G43\nG1 Z1\nM2\n%\n"
SCENARIO = """machine = "builtin:ghaffari/a3a1"
controller = "builtin:ghaffari/calibrated"
contour = {name = "circle", radius = "2 mm"}
feed = {law = "uniform", frequency = "2 Hz"}
run = {tolerance = "27.8 um", start = "moving"}
"""
DRAGGED = f'{SCENARIO}[axes.1.friction]\nkind = "open-drag"\ncoefficient = "0.1 full_scale*s/m"\n'
STUDY = """scenario = "scenario.toml"
variants = 40
chunk = 32
[vary]
"axes.*.friction.coulomb" = { normal = ["100 %", "20 %"] }
"axes.1.plant.gain" = { uniform = ["90 %", "110 %"] }
"""


@dataclass(frozen=True)
class Kind:
    """One kind of input: the file to damage and its texts; the words of its command, where FILE stands for the file; other files.

    A `protected` file has a digest, or should have: a command that ends well gives the `answer` of the intact file.
    """

    file: str
    seeds: tuple[bytes, ...]
    words: tuple[str, ...]
    weight: int
    beside: tuple[tuple[str, bytes], ...] = ()
    protected: bool = False
    answer: str = ""


@dataclass(frozen=True)
class Damaged:
    """A damaged file and its kind."""

    kind: Kind
    text: bytes

    @property
    def name(self) -> str:
        """What was damaged."""
        return f"damaged {Path(self.kind.file).name}"

    @property
    def commands(self) -> list[str]:
        """The command, to be typed after ``contourlab``."""
        return [shlex.join(self.typed)]

    @property
    def typed(self) -> list[str]:
        """The words of the command."""
        return [self.kind.file if word == "FILE" else word for word in self.kind.words]

    def write(self, folder: Path) -> None:
        """Write the file and those beside it."""
        for name, content in (*self.kind.beside, (self.kind.file, self.text)):
            file = folder / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(content)

    def fault(self, folder: Path) -> str:
        """Run the command in a folder; return what is wrong, or nothing."""
        code, out, err = self.said(folder)
        if code not in CODES:
            return f"{self.name}: exit code {code}: {err.strip()[-300:]}"
        if "not enough memory" in err:
            return f"{self.name}: {err.strip()[-300:]}"
        if self.kind.answer and code in (0, 1) and out != self.kind.answer:
            return f"{self.name}: exit code {code}, and another answer than that of the intact file"
        return ""

    def said(self, folder: Path) -> tuple[int, str, str]:
        """Run the command; return its exit code and both streams."""
        from contourlab.cli.main import main

        self.write(folder)
        out, err = io.StringIO(), io.StringIO()
        with contextlib.chdir(folder), contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = main(self.typed)
        return code, out.getvalue(), err.getvalue()


def answered(kind: Kind) -> str:
    """Return what the command prints for the intact file; a file that is refused would test nothing."""
    for seed in kind.seeds[::-1]:
        with tempfile.TemporaryDirectory() as folder:
            code, out, err = Damaged(kind, seed).said(Path(folder))
        assert code == 0, f"{kind.file}: {err}"
    return out


def _stored() -> dict[str, bytes]:
    """Return the files of a small store of variants."""
    from contourlab.cli.main import main

    with tempfile.TemporaryDirectory() as name, contextlib.redirect_stdout(io.StringIO()):
        folder = Path(name)
        (folder / "scenario.toml").write_text(SCENARIO)
        (folder / "study.toml").write_text(STUDY)
        assert main(["sweep", "run", f"{name}/study.toml", "--out", f"{name}/store"]) == 0
        return {f"store/{file.name}": file.read_bytes() for file in sorted((folder / "store").iterdir()) if file.name[0] != "."}


def _drawn() -> bytes:
    """Return a DXF drawing: lines, an arc, a bulge."""
    import ezdxf

    document = ezdxf.new("R2010")
    document.header["$INSUNITS"] = 4
    space = document.modelspace()
    space.add_line((0, 0), (10, 0))
    space.add_arc((10, 5), 5, -90, 90)
    space.add_lwpolyline([(10, 10, 0.0), (0, 10, 0.5), (0, 0, 0.0)], format="xyb")
    stream = io.StringIO()
    document.write(stream)
    return stream.getvalue().encode()


def programs() -> list[Kind]:
    """Return the kinds that a reader of part programs answers; they need few imports."""
    program = (files("contourlab") / "machines" / "programs" / "circle_diamond_square.ngc").read_bytes()
    return _tried(
        Kind("part.ngc", (PROGRAM, program[:3000]), ("canon", "FILE", *FEW), 90),
        Kind("tool.tbl", (TOOLS,), ("canon", "part.ngc", "--tools", "FILE"), 10, (("part.ngc", TOOLED),)),
    )


def _tried(*known: Kind) -> list[Kind]:
    """Return kinds with the answers of their intact files; what the commands import is there for all inputs, but no plug-in."""
    return [
        replace(kind, answer=answered(kind)) if kind.protected else kind
        for kind in known
        if kind.protected or "--plugin" in kind.words or answered(kind)
    ]


def kinds() -> list[Kind]:
    """Return the other kinds of inputs."""
    import numpy as np
    from scipy.io import savemat

    from contourlab.result import Result, Signal
    from contourlab.scenario import load_scenario
    from contourlab.scenario.dump import dump

    program = (files("contourlab") / "machines" / "programs" / "circle_diamond_square.ngc").read_bytes()
    whole = tuple(dump(load_scenario(f"builtin:{name}")).encode() for name in ("demo-part", "gecer-ulu/contour", "emps/circle"))
    t = 1e-3 * np.arange(200)
    x, y = 10.0 * np.sin(3.0 * t), 10.0 * np.cos(3.0 * t)
    names = ("time [s]", "x ref [mm]", "x pos [mm]", "y ref [mm]", "y pos [mm]")
    rows = np.column_stack([t, x, x + 1e-3, y, y - 1e-3])
    table = "\n".join([",".join(names), *(",".join(f"{v:.9g}" for v in row) for row in rows)]).encode()
    points = b"x [mm],y [mm]\n" + "\n".join(f"{a:.9g},{b:.9g}" for a, b in zip(x, y, strict=True)).encode()
    stream = io.BytesIO()
    savemat(stream, {"time": t, "x_ref": x, "x_pos": x, "y_ref": y, "y_pos": y})
    mat = b"MATLAB 5.0 MAT-file".ljust(116) + stream.getvalue()[116:]  # without the present time
    with tempfile.TemporaryDirectory() as folder:
        both = {"reference": np.column_stack([x, y]) / 1e3, "position": np.column_stack([x, y + 1e-3]) / 1e3}
        signals = {name: Signal(data, ("sample", "axis"), "m") for name, data in both.items()}
        Result("base", ("x", "y"), 1e-3, signals).save(f"{folder}/run.nc")
        result = Path(folder, "run.nc").read_bytes()
    measure, check = ("measure", "FILE", "--out", "out", "--json"), ("run", "scenario.toml", "--check")
    named = [f"{signal}.{axis}={axis}_{short} [mm]" for axis in "xy" for signal, short in (("reference", "ref"), ("position", "pos"))]
    columns = [word for name in named for word in ("--column", name)]
    store, rig, commission = _stored(), Rig(), ("commission", "linuxcnc", "rig.ini", "rig.hal", "--out", "out", "--json")
    ini, hal = ("rig.ini", rig.ini_text().encode()), ("rig.hal", rig.hal_text().encode())

    def around(shape: str) -> tuple[tuple[str, bytes], ...]:
        return (("scenario.toml", AROUND_SHAPE.format(shape).encode()),)

    def of_store(file: str) -> Kind:
        return Kind(file, (store[file],), ("sweep", "show", "store", "--json"), 8, tuple(store.items()), protected=True)

    return _tried(
        Kind("part.ngc", (PROGRAM, program[:3000]), ("check", "FILE", *FEW), 10),
        Kind("part.ngc", (PROGRAM, program[:3000]), ("run", "FILE", *ON_XYZ, *FEW, "--check"), 10),
        Kind("scenario.toml", whole, ("run", "FILE", "--check"), 60),
        Kind("shape.svg", (SHAPE,), check, 10, around("shape.svg")),
        Kind("shape.csv", (points,), check, 10, around("shape.csv")),
        Kind("shape.dxf", (_drawn(),), check, 10, around("shape.dxf")),
        Kind("log.csv", (table,), measure, 20),
        Kind("log.mat", (mat,), (*measure, *columns), 3),
        Kind("run.nc", (result,), measure, 3, protected=True),
        Kind("plugin.py", (DRAG.encode(),), ("components", "--plugin", "FILE"), 10),
        Kind("plugin.py", (DRAG.encode(),), (*check, "--plugin", "FILE"), 5, (("scenario.toml", DRAGGED.encode()),)),
        Kind("study.toml", (STUDY.encode(),), ("sweep", "run", "FILE", "--chunks", "0:1"), 5, (("scenario.toml", SCENARIO.encode()),)),
        *[of_store(file) for file in store if not file.endswith(OPEN)],
        Kind(ini[0], (ini[1],), commission, 10, (hal,)),
        Kind(hal[0], (hal[1],), commission, 10, (ini,)),
    )


def damaged(seed: bytes, draw: random.Random) -> bytes:
    """Return a text after one to six changes: of bytes, tokens, numbers or lines."""
    text = bytearray(seed)
    for _ in range(draw.choice((1, 1, 2, 3, 6))):
        at = draw.randrange(len(text) + 1)
        how = draw.randrange(7)
        if how == 0 and text:
            text[min(at, len(text) - 1)] ^= 1 << draw.randrange(8)
        elif how == 1:
            del text[at : at + draw.choice((1, 2, 8, 64))]
        elif how == 2:
            text[at:at] = draw.choice(ODD)
        elif how == 3:
            text[at:at] = draw.choice(string.printable).encode() * draw.choice((1, 1, 1, 50))
        elif how == 4:
            end = at
            while end < len(text) and chr(text[end]) in string.digits + ".-e":
                end += 1
            text[at:end] = draw.choice(ODD)
        else:
            lines = bytes(text).split(b"\n")
            one, other = draw.randrange(len(lines)), draw.randrange(len(lines))
            if how == 5:
                lines[one], lines[other] = lines[other], lines[one]
            else:
                lines[one:one] = lines[other : other + 1] * draw.choice((1, 1, 3))
            text = bytearray(b"\n".join(lines))
    return bytes(text)
