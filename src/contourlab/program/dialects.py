"""What controls read differently from LinuxCNC 2.9: the `Rules` of each dialect, and which dialect a program seems to be written for.

grbl 1.1 is read as its parser does (``gcode.c`` and ``protocol.c`` of gnea/grbl), grblHAL and FluidNC as theirs, as far as they share its
rules. Neither a Fanuc nor Mach3, nor their manuals, have been compared.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import NamedTuple

from contourlab.program.vocabulary import G_GROUPS, M_GROUPS, USED_LETTERS


class Rules(NamedTuple):
    """How a control reads a program; the defaults are LinuxCNC's.

    Parameters
    ----------
    title : str
        The control, as messages name it.
    manual, assumed : str
        Its manual, if no control has been compared, and what its configuration decides otherwise.
    marks : str
        Regular expression of what names the control in a program or its file name.
    g, m : mapping of int to str
        Modal groups of the codes that it has.
    letters : frozenset of str
        Letters that it has, besides G, M and N.
    meanings : mapping of str to str
        Codes that it has, but that are not read.
    last_counts : frozenset of str
        Modal groups in which the last of several codes of a block counts; of other groups a block has one.
    needs_end : bool
        Whether a program without M2, M30 or % at its end is refused.
    lone_g80 : bool
        Whether G80 cannot share a block with another motion.
    paths_apart : bool
        Whether G0 to G3 are a group of their own: in force again after G80, and beside G28 and G30, where they only set the mode.
    keeps_feedrate : bool
        Whether a repeated G94 or G95 keeps F.
    new_units : bool
        Whether F has the units that its own block sets.
    stray_offsets : bool
        Whether an arc may name the offset along the normal of its plane, without effect.
    plain_arcs : bool
        Whether an arc needs an axis of its plane, and has no P.
    spiral : (float, float) [m]
        Allowed difference of the radii at start and end of an arc in mm and in inch programs.
    radius_slack : float [m]
        Amount by which R may be too small.
    g53_motions : tuple of int
        Motions that G53 can have.
    incremental_g53 : bool
        Whether G53 is absolute in G91, too.
    stops_at_g61 : bool
        Whether the motion stops after every move in G61.
    dwell : float [s]
        Unit of P.
    dwell_x : bool
        Whether G4 takes X, in seconds.
    own_cycles : bool
        Whether canned cycles are Fanuc's: in G98 from the start, with data that hold until they are cancelled, and repeated with K.
    o_words : tuple of str, or None
        Keywords of its O-words, empty for ``O100`` alone; None for all.
    blend : str or None
        Letters that a written G64 has; None where the control, or its usual build, has no G64.
    decimals : (int, int)
        Digits behind the point to write of a length, in mm and in inch programs.
    """

    title: str = "LinuxCNC"
    manual: str = ""
    assumed: str = ""
    marks: str = "(?!)"
    g: Mapping[int, str] = G_GROUPS
    m: Mapping[int, str] = M_GROUPS
    letters: frozenset[str] = USED_LETTERS
    meanings: Mapping[str, str] = {}
    last_counts: frozenset[str] = frozenset()
    needs_end: bool = True
    lone_g80: bool = False
    paths_apart: bool = False
    keeps_feedrate: bool = False
    new_units: bool = False
    stray_offsets: bool = False
    plain_arcs: bool = False
    spiral: tuple[float, float] = (0.02 * math.sqrt(2.0) * 1e-3, 0.002 * math.sqrt(2.0) * 0.0254)
    radius_slack: float = 50e-6 * 0.0254
    g53_motions: tuple[int, ...] = (0, 10)
    incremental_g53: bool = False
    stops_at_g61: bool = False
    dwell: float = 1.0
    dwell_x: bool = False
    own_cycles: bool = False
    o_words: tuple[str, ...] | None = None
    blend: str | None = "PQ"
    decimals: tuple[int, int] = (6, 8)


LINUXCNC = Rules()


def _groups(table: Mapping[int, str], codes: str, scale: int = 1) -> dict[int, str]:
    """Return the modal groups of codes; a code that LinuxCNC has not gets its own: it switches off what is never on."""
    numbers = [round(scale * float(code)) for code in codes.split()]
    return {number: table.get(number, f"off {number}") for number in numbers}


_COMMON = "0 1 2 3 4 10 17 18 19 20 21 28 30 40 49 53 54 55 56 57 58 59 61 80 90 91 92 93 94 "
_MILL = _COMMON + "15 43 50 64 69 73 81 82 83 85 86 88 89 95 98 99 "
_MILL_M = "0 1 2 3 4 5 6 7 8 9 30 48 49 98 99 "
_MEANINGS = {
    "G16": "polar coordinates", "G51": "scaling", "G68": "rotation", "G65": "macro call", "G76": "fine boring", "G87": "back boring",
}  # fmt: skip
_MILL_LETTERS = frozenset("XYZIJKRPFSTLQH")

GRBL = Rules(
    title="grbl 1.1",
    marks=r"\b(grbl|carbide ?(motion|create|3d)|easel|shapeoko|x-?carve|openbuilds|lightburn|laserweb)(?![a-z])",
    g=_groups(G_GROUPS, _COMMON + "28.1 30.1 43.1 91.1 92.1", 10),
    m=_groups(M_GROUPS, "0 1 2 3 4 5 7 8 9 30"),
    letters=frozenset("FIJKLPRSTXYZ"),
    needs_end=False,
    lone_g80=True,
    keeps_feedrate=True,
    new_units=True,
    stray_offsets=True,
    plain_arcs=True,
    spiral=(5e-6, 5e-6),
    radius_slack=1e-9,  # its own numbers have 7 digits
    incremental_g53=True,
    o_words=(),
    blend=None,
)
GRBLHAL = GRBL._replace(
    title="grblHAL",
    marks=r"\b(grblHAL|FluidNC)\b",
    g={code: group for code, group in G_GROUPS.items() if code != 901},
    m=M_GROUPS,
    letters=USED_LETTERS,
    o_words=None,
    plain_arcs=False,
)
FANUC = Rules(
    title="a Fanuc",
    manual="the operator's manual of Series 30i-MODEL B, machining centres (B-64484EN-2)",
    assumed="G0 on a straight line (parameter 1401), machine zero as reference point (1240), pecks that retract 0.254 mm (5114, 5115)",
    marks=r"\b(fanuc|haas)\b|^\s*[O:][0-9]{4,5}\b",
    g=_groups(G_GROUPS, _MILL + "50.1 67 74 84 97", 10),
    m=_groups(M_GROUPS, _MILL_M + "19"),
    letters=_MILL_LETTERS,
    meanings=_MEANINGS | {"G52": "local coordinates", "M29": "rigid tapping"} | dict.fromkeys(("G5", "G5.1", "G8", "G9"), "speed control"),
    last_counts=frozenset(G_GROUPS.values()) - {"motion", "other"},
    paths_apart=True,
    keeps_feedrate=True,
    g53_motions=(0,),
    stops_at_g61=True,
    dwell=1e-3,
    dwell_x=True,
    own_cycles=True,
    o_words=("",),
    blend="",
    decimals=(3, 4),  # increment system IS-B
)
MACH3 = Rules(
    title="Mach3",
    manual="Using Mach3Mill (ArtSoft), chapter 10",
    assumed="P in seconds; I, J and K relative to the start before any G90.1; pecks that retract 0.254 mm",
    marks=r"\bmach ?3|^[^(\n]*G0*71 ?G91\.1|\.tap$",
    g=_groups(G_GROUPS, _MILL + "52 90.1 91.1 92.1 92.2 92.3", 10) | {700: "units", 710: "units"},
    m=_groups(M_GROUPS, _MILL_M),
    letters=_MILL_LETTERS,
    meanings=_MEANINGS | {"G12": "circular pocket", "G13": "circular pocket", "G84": "tapping"},
    last_counts=frozenset(("arc_distance",)),
    paths_apart=True,
    keeps_feedrate=True,
    stops_at_g61=True,
    o_words=("",),
    blend="",
)
DIALECTS = {"linuxcnc": LINUXCNC, "grbl": GRBL, "grblhal": GRBLHAL, "fanuc": FANUC, "mach3": MACH3}


def named_in(head: str) -> list[str]:
    """Return the dialects that the beginning of a program names, with its file name as first line, as in a comment of its post-processor.

    >>> named_in("part.nc\\n(Post Processor: grbl_post)")
    ['grbl']
    """
    return [name for name, rules in DIALECTS.items() if re.search(rules.marks, head, re.IGNORECASE | re.MULTILINE)]
