"""The words of RS274/NGC: supported codes with their modal groups, the codes that use each letter, and unsupported words.

G-codes are numbers times ten: G90.1 is 901.
"""

from __future__ import annotations

from collections.abc import Mapping

from contourlab.errors import ProgramEndError, ProgramError


class BlockError(Exception):
    """A fault in a block, with its column (from 1; 0 for the whole block). `Reader` re-raises it as a `raised`, with file and line."""

    raised: type[ProgramError] = ProgramError

    def __init__(self, message: str, column: int = 0) -> None:
        self.message, self.column = message, column
        super().__init__(message)


class EndMarkError(BlockError):
    """A % at the end of a program without a % at its beginning."""

    raised = ProgramEndError


CYCLES = frozenset((730, 740, 810, 820, 830, 840, 850, 860, 870, 880, 890))
SPLINES = frozenset((50, 51, 52))
SYSTEMS = (540, 550, 560, 570, 580, 590, 591, 592, 593)
AXIS_WORDS = frozenset((100, 280, 300, 520, 920))
"""Codes that use the axis words of their block instead of the modal motion."""

G_GROUPS: dict[int, str] = {
    170: "plane", 180: "plane", 190: "plane",
    200: "units", 210: "units",
    70: "diameter", 80: "diameter",
    900: "distance", 910: "distance",
    901: "arc_distance", 911: "arc_distance",
    930: "feed_mode", 940: "feed_mode", 950: "feed_mode",
    400: "cutter",
    430: "tool_length", 431: "tool_length", 432: "tool_length", 490: "tool_length",
    970: "spindle_mode", 980: "return", 990: "return",
    610: "control", 611: "control", 640: "control",
} | dict.fromkeys((0, 10, 20, 30, 800, *SPLINES, *CYCLES), "motion") \
  | dict.fromkeys((40, 53, 100, 280, 281, 300, 301, 520, 530, 920, 921, 922, 923), "other") \
  | dict.fromkeys(SYSTEMS, "system")  # fmt: skip
"""Modal groups of the supported G-codes (times ten); a block has at most one code of a group."""

M_GROUPS: dict[int, str] = {
    0: "stop", 1: "stop", 2: "stop", 30: "stop", 60: "stop", 98: "call", 99: "stop",
    3: "spindle", 4: "spindle", 5: "spindle", 19: "spindle", 6: "tool", 61: "tool", 7: "coolant", 8: "coolant", 9: "coolant",
    48: "overrides", 49: "overrides", 50: "overrides", 51: "overrides", 52: "overrides", 53: "overrides",
} | dict.fromkeys((62, 63, 64, 65, 67, 68), "output")  # fmt: skip
"""Modal groups of the supported M-codes."""

USED_LETTERS = frozenset("XYZIJKRPFST@^LQHE")
"""Letters that the supported codes use, besides G, M and N."""

ARCS = (20, 30)
_USERS: tuple[tuple[str, str, tuple[int | str, ...]], ...] = (
        ("I", "G2, G3, G5, G5.1 or G87", (*ARCS, 50, 51, 870)),
        ("J", "G2, G3, G5, G5.1 or G87", (*ARCS, 50, 51, 870)),
        ("K", "G2, G3 or G87", (*ARCS, 870)),
        ("R", "G2, G3, G10, M19 or a cycle", (*ARCS, 100, *CYCLES, "M19")),
        ("P", "G2 to G5, G5.2, G10, G64, G74, G82, G84, G86, G88, G89, M19, M50 to M53, M62 to M65 or M98",
         (40, *ARCS, 50, 52, 100, 640, 740, 820, 840, 860, 880, 890,
          "M19", "M50", "M51", "M52", "M53", "M62", "M63", "M64", "M65", "M98")),
        ("L", "G5.2, G10, M98 or a cycle other than G74", (100, 52, *(CYCLES - {740}), "M98")),
        ("Q", "G5, G10, G64, G73, G83, M19, M61, M67 or M68", (50, 100, 640, 730, 830, "M19", "M61", "M67", "M68")),
        ("H", "G43 or G43.2", (430, 432)),
        ("E", "M67 or M68; exponents and extruders are not supported", ("M67", "M68")),
)  # fmt: skip
USERS: dict[str, tuple[frozenset[int | str], str]] = {letter: (frozenset(codes), shown) for letter, shown, codes in _USERS}
"""Codes that use a letter (numbers times ten, or "M50"), and their names for messages."""

O_WORD_ALONE = "CL840 an O-word must be alone on its line, apart from a line number: write for example O100 call on the next line"

_CAM = "let the CAM system write plain G0, G1, G2 and G3 moves"
_CENTRE_PATH = "let the CAM system write the path of the tool's centre"

_REFUSED: dict[str, tuple[str, str]] = {
    name: (what, cure)
    for what, cure, *names in (
        ("NURBS with explicit knots", _CAM, "G6", "G6.1", "G6.2", "G6.3"),
        ("UV plane", "use G17", "G17.1"), ("WU plane", "use G18", "G18.1"), ("VW plane", "use G19", "G19.1"),
        ("spindle-synchronised motion", "use G1", "G33"), ("rigid tapping", "use G1", "G33.1"),
        ("probing", "use G1", "G38.2", "G38.3", "G38.4", "G38.5"),
        ("cutter compensation", _CENTRE_PATH, "G41", "G41.1", "G42", "G42.1"),
        ("lathe cycle", _CAM, "G70", "G71", "G71.1", "G71.2", "G72", "G72.1", "G72.2"), ("threading cycle", _CAM, "G76"),
        ("constant surface speed", "delete it; it affects only the spindle", "G96"),
        ("wait for an input", "delete it", "M66"), ("save the modal state", "delete it", "M70", "M73"),
        ("invalidate the saved modal state", "delete it", "M71"), ("restore the modal state", "write the codes themselves", "M72"),
        ("user-defined code", "delete it", *(f"M{number}" for number in range(100, 200))),
        ("rotary axis", "use X, Y and Z only", *"ABC"), ("secondary axis", "use X, Y and Z only", *"UVW"),
        ("tool diameter", "delete it; only cutter compensation uses it", "D"),
    )
    for name in names
}  # fmt: skip


def g_name(code: int) -> str:
    """Return the common name of a G-code.

    >>> g_name(901), g_name(10)
    ('G90.1', 'G1')
    """
    return f"G{code // 10}" + (f".{code % 10}" if code % 10 else "")


def refusal(name: str, kind: str, title: str = "", meanings: Mapping[str, str] | None = None) -> str:
    """Return the message for an unsupported code or word: what it is, and what to do.

    Parameters
    ----------
    title : str
        Control of another dialect.
    meanings : mapping of str to str
        Codes that it has, but that are not read.

    >>> refusal("G41", "G-code")
    "CL808 G41 (cutter compensation) is not supported yet: let the CAM system write the path of the tool's centre"
    """
    if name == "O":
        return O_WORD_ALONE
    if meanings and name in meanings:
        return f"CL808 {name} ({meanings[name]}) is not supported yet: {_CAM}"
    if title and name not in _REFUSED:
        return f"CL807 {title} has no {name} that is read: delete it, or let the CAM system post for this control"
    if name not in _REFUSED:
        return f"CL807 {name} is not a known {kind}: delete it, or correct the number"
    what, cure = _REFUSED[name]
    return f"CL808 {name} ({what}) is not supported yet: {cure}"
