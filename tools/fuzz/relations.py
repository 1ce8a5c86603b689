"""Two inputs whose figures must agree, or one input computed in two ways: the oracle for answers that are wrong but look right."""

from __future__ import annotations

import contextlib
import math
import random
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from figures import HOWS, SIGNAL, STRICT, Figures, Side, write
from machines import COUNT, KINDS, axis_tables, scenario
from motions import MODES, Motion, Placing, Point, made_motions, placed, written

SAME, CLOSE, ANEW = 0.0, 1e-6, 0.2
"""Largest relative difference of a figure: none, bit for bit; rounding; a motion that is planned anew on the same path.

The planner of curves corrects a motion in rounds until it is within the limits. A split arc has other samples, and a last digit may decide
where it corrects. Both motions are within the limits and near the least time. Measured over 150 split arcs in motions of a second: cycle
time 1.3 %, largest contour error 4 %, tracking error 8 %, the piece left out 12 %. Drawings under the law "uniform" need no planner.
"""
PLACE = 1e-9
"""Two plans are the same if they differ by less at each sample [m]."""
COUNTS = 1.0
"""Largest difference of a length [counts] behind quantised encoders: a last digit flips a count. Measured: 0.3."""
TINY = 1e-13
"""Lengths [m] and times [s] below this are rounding."""
STUDY = """scenario = "scenario.toml"
variants = {variants}
chunk = 32
seed = 5
[vary]
"axes.x.plant.gain" = {{uniform = ["90 %", "110 %"]}}
"""


@dataclass(frozen=True)
class Related:
    """Two sides, and how far their figures may differ."""

    name: str
    one: Side
    other: Side
    bound: float = CLOSE
    counts: float = 0.0

    def fault(self, folder: Path) -> str:
        """Compute both sides in a folder; return the first figure that differs, or nothing."""
        figures = {}
        for name, side in (("one", self.one), ("other", self.other)):
            place = write(side.files, folder / name)
            try:
                figures[name] = HOWS[side.how](place, side)
            except Exception as error:  # a sound input was refused
                return f"{self.name}: {name}: {type(error).__name__}: {error}"
        return difference(figures["one"], figures["other"], self)

    @property
    def commands(self) -> list[str]:
        """Words of commands that show the figures, in a folder with both sides."""
        return [f"run {name}/scenario.toml --json --out {name}/results" for name in ("one", "other")]

    def write(self, folder: Path) -> None:
        """Write both sides."""
        write(self.one.files, folder / "one")
        write(self.other.files, folder / "other")


def difference(one: Figures, other: Figures, related: Related) -> str:
    """Return the first figure that differs by more than the bound, or nothing."""
    names = sorted(one.keys() & other.keys())
    if not names:
        return f"{related.name}: no figure in common: {sorted(one)}, {sorted(other)}"
    bound = related.bound
    if bound == SAME:
        differing = [name for name in names if one[name].shape != other[name].shape or one[name].tobytes() != other[name].tobytes()]
    else:
        names = [name for name in names if not name.startswith(SIGNAL)]
        if "plan" in names:
            names.remove("plan")
            same = one["plan"].shape == other["plan"].shape and np.allclose(one["plan"], other["plan"], rtol=0.0, atol=PLACE)
            bound = bound if same else ANEW
        bounds = {name: CLOSE if name in STRICT else bound for name in names}
        differing = [name for name in names if _differ(one[name], other[name], bounds[name], related.counts * COUNT)]
    if not differing:
        return ""
    values = " against ".join(str(part.tolist() if part.size < 9 else part.shape) for part in (one[differing[0]], other[differing[0]]))
    return f"{related.name}: {differing[0]}: {values}; {len(differing)} of {len(names)} figures differ, bound {bound:g}"


def _differ(one: np.ndarray, other: np.ndarray, bound: float, length: float) -> bool:
    """Return whether values differ by more than a share of the largest and a length [m]."""
    if one.shape != other.shape:
        return True
    size = max(np.abs(one).max(initial=0.0), np.abs(other).max(initial=0.0))
    return bool((np.abs(one - other) > TINY + bound * size + length).any())


@dataclass(frozen=True)
class Scene:
    """A random machine and program; each relation changes one thing of it."""

    draw: random.Random
    kind: str
    mode: str
    tables: list[str]
    motions: list[Motion]

    def side(self, text: str = "", how: str = "run", **changes: Any) -> Side:
        """Return a side whose program is ``text``, by default that of the scene."""
        program = text or written(self.motions, self.mode)
        files = {"scenario.toml": scenario(self.kind, self.tables, 'program = "part.ngc"'), "part.ngc": program}
        return replace(Side(files, how), **changes)


def _split(scene: Scene, arc: bool) -> Related | None:
    able = [k for k, motion in enumerate(scene.motions) if motion.feed and (motion.centre is not None) == arc]
    if not able or scene.mode == "G61.1" or (arc and scene.mode != "G61"):  # it stops at each end; a blend takes at most half of an arc
        return None
    k = scene.draw.choice(able)
    parts = scene.motions[k].halves(scene.draw.uniform(0.2, 0.8))
    motions = [*scene.motions[:k], *parts, *scene.motions[k + 1 :]]
    return Related("split arc" if arc else "split line", scene.side(), scene.side(written(motions, scene.mode)))


def _inch(scene: Scene) -> Related:
    return Related("inch", scene.side(), scene.side(written(scene.motions, scene.mode, inch=True)))


def _steps(scene: Scene) -> Related:
    return Related("incremental", scene.side(), scene.side(written(scene.motions, scene.mode, steps=True)))


def _moved(scene: Scene) -> Related:
    """Move the program by its words, and by G10 or G92: the moves of the machine are the same."""
    x, y, z = (round(scene.draw.uniform(-20.0, 20.0), 3) for _ in range(3))
    first = scene.draw.choice((f"G10 L2 P1 X{x} Y{y} Z{z}", f"G92 X{-x} Y{-y} Z{-z}"))
    one, other = (written(scene.motions, scene.mode, **how) for how in ({"shift": (x, y, z)}, {"first": first}))
    return Related(f"moved by {first[:3]}", scene.side(one), scene.side(other))


def _placed(scene: Scene) -> Related:
    """Turn, mirror or exchange axes, with their drives: each axis does what it did before, under another name or sign."""
    order = [0, 1, 2]
    scene.draw.shuffle(order)
    placing: Placing = tuple((axis, scene.draw.choice((-1.0, 1.0))) for axis in order)
    if scene.kind == "play":  # the load begins in the middle of the gap, and may touch either flank
        placing = tuple((axis, 1.0) for axis in order)
    other = written(placed(scene.motions, placing), scene.mode)
    tables = [scene.tables[axis] for axis in order]
    files = {"scenario.toml": scenario(scene.kind, tables, 'program = "part.ngc"'), "part.ngc": other}
    back = tuple(order.index(k) for k in range(3))
    return Related("turned, mirrored or renamed", scene.side(), Side(files, order=back))


def _contour(scene: Scene) -> Related:
    """Move, turn and rename a contour of points in the plane."""
    draw = scene.draw
    t = [math.tau * k / 60 for k in range(61)]
    a, b, phase = draw.uniform(2.0, 8.0), draw.uniform(2.0, 8.0), draw.uniform(0.0, 3.0)
    points: list[Point] = [(a * math.cos(u), b * math.sin(u) + 0.5 * math.sin(3.0 * u + phase), 0.0) for u in t]
    points[-1] = points[0]
    turn = draw.choice(((0, 1), (1, 0)))
    sign, shift = [draw.choice((-1.0, 1.0)) for _ in turn], [draw.uniform(-30.0, 30.0) for _ in turn]
    names = draw.choice(("xy", "pq", "zx"))
    if scene.kind == "play":
        sign = [1.0, 1.0]
    moved = [tuple(sign[i] * p[turn[i]] + shift[i] for i in (0, 1)) for p in points]

    def side(rows: Any, tables: list[str], names: str, order: tuple[int, ...]) -> Side:
        table = "x [mm],y [mm]\n" + "\n".join(f"{p[0]:.12f},{p[1]:.12f}" for p in rows) + "\n"
        motion = '\n[contour]\nfile = "points.csv"\n[feed]\nfeedrate = "1500 mm/min"\n'
        return Side({"scenario.toml": scenario(scene.kind, tables, motion, names), "points.csv": table}, order=order)

    tables = scene.tables[:2]
    other = side(moved, [tables[k] for k in turn], names, (turn.index(0), turn.index(1)))
    return Related("contour moved, turned or renamed", side(points, tables, "xy", (0, 1)), other)


def _drawing(scene: Scene) -> Related:
    """Split lines and arcs of a drawing, or give its size in inch, and follow it at constant speed."""
    draw = scene.draw
    r, side, at = round(draw.uniform(1.0, 4.0), 3), round(draw.uniform(2.0, 8.0), 3), draw.uniform(0.3, 2.8)
    middle = f"{20.0 + side + r * math.sin(at):.12f} {20.0 + r - r * math.cos(at):.12f}"
    turn, end = f"A {r} {r} 0 0 1", f"{20.0 + side} {20.0 + 2.0 * r} H 20 A {r} {r} 0 0 1 20 20 Z"
    whole, parts = f"M 20 20 H {20.0 + side} {turn} {end}", f"M 20 20 H 21 H {20.0 + side} {turn} {middle} {turn} {end}"
    name, text, size = draw.choice((("split drawing", parts, "100mm"), ("drawing in inch", whole, f"{100.0 / 25.4:.15f}in")))

    def drawn(path: str, size: str) -> Side:
        svg = f'<svg xmlns="http://www.w3.org/2000/svg" width="{size}" height="{size}" viewBox="0 0 100 100"><path d="{path}"/></svg>'
        motion = '\n[contour]\nfile = "part.svg"\n[feed]\nlaw = "uniform"\nfrequency = "1 Hz"\n'
        return Side({"scenario.toml": scenario(scene.kind, scene.tables[:2], motion), "part.svg": svg}, order=(0, 1))

    return Related(name, drawn(whole, "100mm"), drawn(text, size))


def _saved_again(scene: Scene) -> Related:
    return Related("saved and loaded", scene.side(), scene.side(how="saved"), SAME)


def _in_blocks(scene: Scene) -> Related:
    return Related("stopped and resumed", scene.side(), scene.side(how="blocks"), SAME)


def _in_lanes(scene: Scene) -> Related:
    side = scene.draw.choice((scene.side(), _contour(scene).one))  # with corners, and smooth
    return Related("lanes and single", replace(side, how="single"), replace(side, how="lanes"))


def _in_threads(scene: Scene) -> Related:
    return Related("threads", scene.side(how="one thread"), scene.side(how="threads"), SAME)


def _as_study(scene: Scene, how: str) -> Related:
    scene = replace(scene, kind="rigid", tables=axis_tables("rigid", scene.draw, 3, False))
    files = {**scene.side().files, "study.toml": STUDY.format(variants=scene.draw.randint(40, 90))}
    return Related(f"study, {how}", Side(files, "study"), Side(files, how), SAME)


RELATIONS: dict[str, tuple[Callable[[Scene], Related | None], int]] = {
    "split line": (lambda scene: _split(scene, arc=False), 20),
    "split arc": (lambda scene: _split(scene, arc=True), 20),
    "inch": (_inch, 20),
    "incremental": (_steps, 20),
    "moved": (_moved, 20),
    "placed": (_placed, 20),
    "contour": (_contour, 20),
    "drawing": (_drawing, 20),
    "saved": (_saved_again, 15),
    "blocks": (_in_blocks, 15),
    "lanes": (_in_lanes, 20),
    "threads": (_in_threads, 10),
    "resumed": (lambda scene: _as_study(scene, "resumed"), 3),
    "processes": (lambda scene: _as_study(scene, "processes"), 1),
}
"""Each relation by name, with how often it is drawn."""


def related(draw: random.Random, name: str = "") -> Related:
    """Return two random inputs that belong together: by the relation ``name``, or any."""
    weights = [weight for _, weight in RELATIONS.values()]
    while True:
        chosen = name or draw.choices([*RELATIONS], weights)[0]
        kind, equal, mode = draw.choice(KINDS), draw.random() < 0.5, draw.choice(MODES)
        scene = Scene(draw, kind, mode, axis_tables(kind, draw, 3, equal), made_motions(draw))
        if (found := RELATIONS[chosen][0](scene)) is not None:
            exact = found.bound == SAME or scene.kind != "encoder"
            return found if exact else replace(found, counts=COUNTS)


def warm(folder: Path) -> None:
    """Compile what the relations run, so that no input has to."""
    draw = random.Random("warm")
    for kind in KINDS:
        scene = Scene(draw, kind, "G64 P0.05", axis_tables(kind, draw, 3, True), made_motions(draw))
        for side in (scene.side(), scene.side(how="saved"), scene.side(how="blocks"), scene.side(how="lanes"), _contour(scene).other):
            place = write(side.files, folder / f"{kind}-{side.how}-{len(side.files['scenario.toml'])}")
            with contextlib.suppress(Exception):
                HOWS[side.how](place, side)
