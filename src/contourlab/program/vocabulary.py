"""The words of RS274/NGC: which are supported, in which modal group, and what the others are called.

A G-code is kept as its number times ten, so that G90.1 is the whole number 901.
"""

from __future__ import annotations

__all__ = ["G_GROUPS", "M_GROUPS", "USED_LETTERS", "g_name", "refuse_g", "refuse_letter", "refuse_m"]

G_GROUPS: dict[int, str] = {
    0: "motion", 10: "motion", 20: "motion", 30: "motion",
    40: "dwell",
    170: "plane", 180: "plane", 190: "plane",
    200: "units", 210: "units",
    900: "distance", 910: "distance",
    901: "arc_distance", 911: "arc_distance",
    940: "feed_mode",
    400: "cutter", 490: "tool_length", 800: "cycle_end", 970: "spindle_mode", 980: "return", 990: "return",
    610: "control", 611: "control",
} | dict.fromkeys((540, 550, 560, 570, 580, 590, 591, 592, 593), "system")  # fmt: skip
"""Supported G-codes (times ten) and their modal groups; at most one code of a group may stand in a block."""

M_GROUPS: dict[int, str] = {
    0: "stop", 1: "stop", 2: "stop", 30: "stop",
    3: "spindle", 4: "spindle", 5: "spindle", 6: "tool", 7: "coolant", 8: "coolant", 9: "coolant",
    48: "overrides", 49: "overrides", 50: "overrides", 51: "overrides", 52: "overrides", 53: "overrides",
}  # fmt: skip
"""Supported M-codes and their modal groups."""

USED_LETTERS = frozenset("XYZIJKRPFST@^")
"""Letters whose numbers the supported codes use (G, M and N apart)."""

_CAM = "let the CAM system write plain G0, G1, G2 and G3 moves"
_ZERO = "the program's zero is machine zero here; delete it, and shift the coordinates if its offset is not zero"
_IDLE = "it changes nothing here, delete it"
_CENTRE_PATH = "let the CAM system write the path of the tool's centre"
_TIP = "write the coordinates of the tool's tip and delete it"
_PER_MINUTE = "write F in length per minute, with G94"

_REFUSED_G: dict[int, tuple[str, str]] = {
    code: (what, cure)
    for what, cure, *codes in (
        ("cubic spline", _CAM, 50), ("quadratic spline", _CAM, 51), ("NURBS", _CAM, 52, 53, 60, 61, 62, 63),
        ("lathe diameter mode", "write X as a radius", 70), ("lathe radius mode", _IDLE, 80),
        ("offset and tool table", "write the coordinates as they are to be", 100),
        ("UV plane", "use G17", 171), ("WU plane", "use G18", 181), ("VW plane", "use G19", 191),
        ("go to home position", "write the position after G0", 280, 300), ("set home position", _IDLE, 281, 301),
        ("spindle-synchronised motion", "use G1", 330), ("rigid tapping", "use G1", 331),
        ("probing", "use G1", 382, 383, 384, 385),
        ("cutter compensation", _CENTRE_PATH, 410, 411, 420, 421), ("tool length offset", _TIP, 430, 431, 432),
        ("machine coordinates", _ZERO, 530), ("coordinate offset", _ZERO, 920, 921, 922, 923),
        ("path blending", "corners are met exactly; delete it to run the program so", 640),
        ("lathe cycle", _CAM, 700, 710, 711, 712, 720, 721, 722), ("threading cycle", _CAM, 760),
        ("drilling cycle", _CAM, 730, 810, 820, 830), ("tapping cycle", _CAM, 740, 840),
        ("boring cycle", _CAM, 850, 860, 870, 880, 890),
        ("inverse-time feed", _PER_MINUTE, 930), ("feed per revolution", _PER_MINUTE, 950),
        ("constant surface speed", "it concerns the spindle alone, delete it", 960),
    )
    for code in codes
}  # fmt: skip

_SPINDLE = "it concerns the spindle alone, delete it"
_REFUSED_M: dict[int, tuple[str, str]] = {
    19: ("spindle orientation", _SPINDLE), 60: ("pallet change", "delete it"),
    61: ("tool number", "delete it"), 70: ("save the modal state", "delete it"),
    71: ("saved modal state", "delete it"), 72: ("restore the modal state", "write the modes themselves"),
    73: ("save the modal state", "delete it"),
    98: ("subprogram", "write the moves out"), 99: ("return", "write M2 at the end"),
} | dict.fromkeys(range(62, 69), ("digital or analogue input or output", "delete it"))  # fmt: skip

_REFUSED_LETTERS: dict[str, tuple[str, str]] = {
    "A": ("rotary axis", "only X, Y and Z are read"), "B": ("rotary axis", "only X, Y and Z are read"),
    "C": ("rotary axis", "only X, Y and Z are read"), "U": ("secondary axis", "only X, Y and Z are read"),
    "V": ("secondary axis", "only X, Y and Z are read"), "W": ("secondary axis", "only X, Y and Z are read"),
    "D": ("tool diameter", "it belongs to cutter compensation, delete it"),
    "H": ("tool length", "it belongs to the tool length offset, delete it"),
    "E": ("extruder or synchronised output", "delete it; numbers take no exponent"),
    "L": ("repeats or mode", "it belongs to codes that are not supported yet"),
    "Q": ("increment of a cycle", "it belongs to codes that are not supported yet"),
    "$": ("spindle number", "delete it"),
}  # fmt: skip


def g_name(code: int) -> str:
    """Write a G-code as people do.

    >>> g_name(901), g_name(10)
    ('G90.1', 'G1')
    """
    return f"G{code // 10}" + (f".{code % 10}" if code % 10 else "")


def refuse_g(code: int) -> str:
    """Say what an unsupported G-code is and what to do.

    >>> refuse_g(281)
    'G28.1 (set home position) is not supported yet: it changes nothing here, delete it'
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
    return _refusal(letter, _REFUSED_LETTERS.get(letter), "word")


def _refusal(name: str, known: tuple[str, str] | None, kind: str) -> str:
    if known is None:
        return f"{name} is no {kind} of RS274/NGC: delete it, or correct the number"
    return f"{name} ({known[0]}) is not supported yet: {known[1]}"
