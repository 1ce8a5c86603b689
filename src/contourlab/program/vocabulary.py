"""The words of RS274/NGC: which are supported, in which modal group, who uses which letter, and what the others are called.

A G-code is kept as its number times ten, so that G90.1 is the whole number 901.
"""

from __future__ import annotations


class BlockError(Exception):
    """What is wrong in a block, and its column (from 1; 0 for the whole block). `Reader` adds file and line."""

    def __init__(self, message: str, column: int = 0) -> None:
        self.message, self.column = message, column
        super().__init__(message)


CYCLES = frozenset((730, 740, 810, 820, 830, 840, 850, 860, 870, 880, 890))
SPLINES = frozenset((50, 51, 52))
AXIS_WORDS = frozenset((100, 280, 300, 520, 920))
"""Codes that take the axis words of their block, so that the motion in force rests."""

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
  | dict.fromkeys((540, 550, 560, 570, 580, 590, 591, 592, 593), "system")  # fmt: skip
"""Supported G-codes (times ten) and their modal groups; at most one code of a group may stand in a block."""

M_GROUPS: dict[int, str] = {
    0: "stop", 1: "stop", 2: "stop", 30: "stop", 60: "stop", 98: "call", 99: "stop",
    3: "spindle", 4: "spindle", 5: "spindle", 19: "spindle", 6: "tool", 61: "tool", 7: "coolant", 8: "coolant", 9: "coolant",
    48: "overrides", 49: "overrides", 50: "overrides", 51: "overrides", 52: "overrides", 53: "overrides",
} | dict.fromkeys((62, 63, 64, 65, 67, 68), "output")  # fmt: skip
"""Supported M-codes and their modal groups."""

USED_LETTERS = frozenset("XYZIJKRPFST@^LQHE")
"""Letters whose numbers the supported codes use (G, M and N apart)."""

_ARCS = (20, 30)
_USERS: tuple[tuple[str, str, tuple[int | str, ...]], ...] = (
        ("I", "G2, G3, G5, G5.1 or G87", (*_ARCS, 50, 51, 870)),
        ("J", "G2, G3, G5, G5.1 or G87", (*_ARCS, 50, 51, 870)),
        ("K", "G2, G3 or G87", (*_ARCS, 870)),
        ("R", "G2, G3, G10 or a cycle", (*_ARCS, 100, *CYCLES, "M19")),
        ("P", "G2 to G5.2, G10, G64, G82 to G89, M50 to M53, M62 to M65 or M98",
         (40, *_ARCS, 50, 52, 100, 640, 740, 820, 840, 860, 880, 890,
          "M19", "M50", "M51", "M52", "M53", "M62", "M63", "M64", "M65", "M98")),
        ("L", "G10, a cycle other than G74, G5.2 or M98", (100, 52, *(CYCLES - {740}), "M98")),
        ("Q", "G5, G10, G64, G73, G83, M61, M67 or M68", (50, 100, 640, 730, 830, "M19", "M61", "M67", "M68")),
        ("H", "G43 or G43.2", (430, 432)),
        ("E", "M67 or M68 (numbers take no exponent, extruders are not read)", ("M67", "M68")),
)  # fmt: skip
USERS: dict[str, tuple[frozenset[int | str], str]] = {letter: (frozenset(codes), shown) for letter, shown, codes in _USERS}
"""Letters that stand for nothing by themselves: the codes that use them (as numbers times ten, or as "M50"), and how to say it."""

O_WORD_ALONE = "an O-word stands alone on its line, behind a line number at most: write for example O100 call on the next line"

_CAM = "let the CAM system write plain G0, G1, G2 and G3 moves"
_CENTRE_PATH = "let the CAM system write the path of the tool's centre"

_REFUSED_G: dict[int, tuple[str, str]] = {
    code: (what, cure)
    for what, cure, *codes in (
        ("NURBS by knots", _CAM, 60, 61, 62, 63),
        ("UV plane", "use G17", 171), ("WU plane", "use G18", 181), ("VW plane", "use G19", 191),
        ("spindle-synchronised motion", "use G1", 330), ("rigid tapping", "use G1", 331),
        ("probing", "use G1", 382, 383, 384, 385),
        ("cutter compensation", _CENTRE_PATH, 410, 411, 420, 421),
        ("lathe cycle", _CAM, 700, 710, 711, 712, 720, 721, 722), ("threading cycle", _CAM, 760),
        ("constant surface speed", "it concerns the spindle alone, delete it", 960),
    )
    for code in codes
}  # fmt: skip

_REFUSED_M: dict[int, tuple[str, str]] = {
    66: ("wait for an input", "delete it"), 70: ("save the modal state", "delete it"),
    71: ("saved modal state", "delete it"), 72: ("restore the modal state", "write the modes themselves"),
    73: ("save the modal state", "delete it"),
}  # fmt: skip

_REFUSED_LETTERS: dict[str, tuple[str, str]] = {
    "A": ("rotary axis", "only X, Y and Z are read"), "B": ("rotary axis", "only X, Y and Z are read"),
    "C": ("rotary axis", "only X, Y and Z are read"), "U": ("secondary axis", "only X, Y and Z are read"),
    "V": ("secondary axis", "only X, Y and Z are read"), "W": ("secondary axis", "only X, Y and Z are read"),
    "$": ("spindle number", "delete it"), "D": ("tool diameter", "it belongs to cutter compensation, delete it"),
}  # fmt: skip


def g_name(code: int) -> str:
    """Write a G-code as people do.

    >>> g_name(901), g_name(10)
    ('G90.1', 'G1')
    """
    return f"G{code // 10}" + (f".{code % 10}" if code % 10 else "")


def refuse_g(code: int) -> str:
    """Say what an unsupported G-code is and what to do.

    >>> refuse_g(410)
    "G41 (cutter compensation) is not supported yet: let the CAM system write the path of the tool's centre"
    """
    return _refusal(g_name(code), _REFUSED_G.get(code), "G-code")


def refuse_m(number: int) -> str:
    """Say what an unsupported M-code is and what to do."""
    known = _REFUSED_M.get(number)
    if 100 <= number <= 199:
        known = ("user-defined code", "delete it")
    return _refusal(f"M{number}", known, "M-code")


def refuse_letter(letter: str) -> str:
    """Say what the word of an unsupported letter is and what to do."""
    if letter == "O":
        return O_WORD_ALONE
    return _refusal(letter, _REFUSED_LETTERS.get(letter), "word")


def _refusal(name: str, known: tuple[str, str] | None, kind: str) -> str:
    if known is None:
        return f"{name} is no {kind} of RS274/NGC: delete it, or correct the number"
    return f"{name} ({known[0]}) is not supported yet: {known[1]}"
