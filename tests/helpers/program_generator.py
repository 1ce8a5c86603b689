"""Random part programs over the whole supported language; about one block in sixty breaks a rule."""

from __future__ import annotations

import random
from collections.abc import Callable

AXES = {"G17": "XYZ", "G18": "ZXY", "G19": "YZX"}
OFFSETS = dict(zip("XYZ", "IJK", strict=True))
SYSTEMS = ("G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3")
NUMBERS = ("0", "0.001", "1", "-1", "2.5", "-2.5", "5", "10", "-10", "3.1416", "-7.25", "[1.5 * 3]", "#7", "-#7")
ANGLES = ("0", "30", "-45", "90", "123.4", "180", "-270")
BROKEN = (
    "X1 X2", "G0 G1 X1", "G1.05 X1", "G0 X1 (a (b))", "G2 X10 I5 P0", "G4", "G4 P-1", "G0 X[1/0]", "G0 XSQRT[-1]", "G10 L2 P11 X1",
    "G10 L3 P1 X1", "G10 L2 X5", "G10 L20 P1 R5", "G53 G2 X1 I1", "G91 G53 G0 X1", "G43.1 G49", "G92", "G52", "G80 X5", "G81 X1",
    "G83 X1 Z-1 R1",
    "G17 G81 X1 Z5 R1", "G81 X1 Z-1 R1 L0", "G82 X1 Z-1 R1", "G5 X1 Y1 I1 J1 P1", "G5.1 X1 Y1", "G5.3", "G93 G1 X1", "o901 endif",
    "o902 endwhile", "o903 break", "o904 call", "o905 continue", "#0 = 5", "#5 = ", "G0 X1 R5", "G1 X1 P3", "F-5", "G38 X1", "M3 M5",
    "G17 G18",
    "G0 X#<nothing>", "G2 X1 R0.1", "G28.1 X5 G1", "G92 X1 G1", "G10 L2 P1 X1 G1", "o<broken> if", "o906 sub\no907 sub\no907 endsub",
    "G0 X1 Y", "G0 @5 X1", "G18 G0 @5 ^3", "T-1", "S-1", "G43.2", "G10 L20 P0 I5", "G55 G54", "G61 G64", "G98 G99",
)  # fmt: skip


class Writer:
    """Writes one program; some methods depend on the modes that earlier lines set."""

    def __init__(self, seed: int, *, broken: bool = True, fanuc: bool = False) -> None:
        self.dice = random.Random(seed)
        self.plane, self.broken, self.label, self.depth = "G17", broken, 100, 0
        self.subs: list[str] = []
        # In the pre-release of LinuxCNC 2.9 a break leaves a flag that ends a later do loop at once.
        self.breaks = self.dice.random() < 0.5
        self.lines = [f"{self.dice.choice(['G21', 'G20', 'G21'])} S500 M{self.dice.choice('34')} F100", "#7 = 4.5", "G1 X1 Y1"]
        self.kinds: list[tuple[int, Callable[[], list[str]]]] = [
            (30, self.straight), (14, self.arc), (6, self.modes), (6, self.system), (6, self.data), (5, self.shift), (4, self.home),
            (3, self.machine), (3, self.length), (8, self.cycle), (3, self.inverse), (4, self.spline), (3, self.polar), (6, self.flow),
            (3, self.control), (4, self.parameter), (2, self.dwell), (3 * fanuc, self.call_fanuc), (1, self.per_turn), (2, self.own),
        ]  # fmt: skip

    def program(self) -> str:
        """Return a program."""
        for _ in range(self.dice.randrange(15, 45)):
            self.lines += self.block()
        return "\n".join([*self.lines, "M2", *self.subs, ""])

    def block(self) -> list[str]:
        if self.broken and self.dice.random() < 1 / 60:
            return self.dice.choice(BROKEN).split("\n")
        made = self.dice.choices([kind for _, kind in self.kinds], [weight for weight, _ in self.kinds])[0]()
        return [self.shuffled(line) for line in made]

    def shuffled(self, line: str) -> str:
        """The order of words means nothing."""
        if line.lstrip()[:1] in ("o", "O", "#", "N") or "[" in line or "=" in line:
            return line
        words = line.split()
        self.dice.shuffle(words)
        spell = self.dice.random()
        text = " ".join(words)
        return text.lower() if spell < 0.1 else f"N10 {text} (note)" if spell < 0.15 and words[:1] != ["N10"] else text

    def number(self, start: int = 0) -> str:
        return self.dice.choice(NUMBERS[start:])

    def axes(self, chance: float = 0.5, least: int = 0) -> str:
        letters = [letter for letter in "XYZ" if self.dice.random() < chance]
        if len(letters) < least:
            letters = [self.dice.choice("XYZ")]
        return "".join(f" {letter}{self.number()}" for letter in letters)

    def straight(self) -> list[str]:
        code = self.dice.choice(["G0", "G1", "G0", "G1", "G0 G90", "G1 G91", "G0 G91", "G1 G90"])
        f = self.dice.choice(["", "", "", " F60", " F2.5"])
        system = self.dice.choice([""] * 12 + [f" {self.dice.choice(SYSTEMS)}", " G49"])
        lines = [code + self.axes() + f + system]
        return lines if self.dice.random() < 0.7 else [*lines, self.axes(least=1).strip()]

    def arc(self) -> list[str]:
        lines = []
        if self.dice.random() < 0.4:
            self.plane = self.dice.choice(list(AXES))
            lines = [self.plane]
        first, second, normal = AXES[self.plane]
        code, kind = self.dice.choice(["G2", "G3"]), self.dice.randrange(4)
        turns = f" P{self.dice.choice('1235')}" if self.dice.random() < 0.2 else ""
        rise = f" {normal}{self.number()}" if self.dice.random() < 0.4 else ""
        i, j = OFFSETS[first], OFFSETS[second]
        if kind == 0:
            radius = self.dice.choice(["9000", "-9000", "1234.567", "-1234.567"])
            return [*lines, f"G91 {code} {first}{self.number(1)} {second}{self.number(1)} R{radius}{rise}{turns}", "G90"]
        if kind == 1:  # quarters and halves about a centre that is known, seen from the start
            u, v = self.dice.choice([(2.5, 0.0), (-4.0, 3.0), (0.0, -1.25), (7.0, 24.0)])
            back = self.dice.choice([(2 * u, 2 * v), (u - v, v + u), (u + v, v - u)])
            return [*lines, f"G91 {code} {first}{back[0]} {second}{back[1]} {i}{u} {j}{v}{rise}{turns}", self.dice.choice(["G90", "G91"])]
        if kind == 2:  # the centre in the coordinates of the program
            at = {letter: f"#{5420 + 'XYZ'.index(letter)}" for letter in AXES[self.plane]}
            return [*lines, f"G90 G90.1 {code} {i}[{at[first]} + 3] {j}[{at[second]} - 1]{rise.replace('G91', '')}{turns}", "G91.1"]
        offsets = self.dice.choice([f"{i}2.5", f"{j}-4", f"{i}1 {j}2"])
        return [*lines, f"{code} {offsets}{rise}{turns}"]

    def modes(self) -> list[str]:
        if self.dice.random() < 0.25:
            # Stand-alone, the interpreter leaves a tool offset in the old units; on a machine it does not.
            return ["G49", self.dice.choice(["G20", "G21", "G90 G20", "G21 G1 X2"])]
        return [self.dice.choice(["G90", "G91", "G90", "G91",  "G98", "G99", "G94 F75", "G7", "G8", "G8", "G80", "G40", "G97 S300",
                                  "M3", "M4", "M8", "M49", "M62 P1", "M0"])]  # fmt: skip

    def system(self) -> list[str]:
        code = self.dice.choice(SYSTEMS)
        return [self.dice.choice([code, code, f"{code} G0{self.axes()}", f"{code} G91 G1{self.axes()}"])]

    def data(self) -> list[str]:
        turn = f" R{self.dice.choice(ANGLES)}" if self.dice.random() < 0.4 else ""
        if self.dice.random() < 0.6:
            # With a G92 shift in force, LinuxCNC loses its position when the rotation changes: its next incremental move is wrong.
            return (["G92.1"] if turn else []) + [f"G10 L2 P{self.dice.randrange(10)}{self.axes()}{turn}"]
        return [f"G10 L20 P{self.dice.randrange(10)}{self.axes(least=1)}"]

    def shift(self) -> list[str]:
        return [
            self.dice.choice(
                [f"G92{self.axes(least=1)}", f"G92{self.axes(least=1)}", f"G52{self.axes(least=1)}", "G92.1", "G92.2", "G92.3"]
            )
        ]

    def home(self) -> list[str]:
        which, first = self.dice.choice([("G28", 5161), ("G30", 5181)])
        kind = self.dice.randrange(4)
        if kind == 0:
            return [f"{which}.1"]
        if kind == 1:
            return [f"#{first + self.dice.randrange(3)} = {self.number()}", which]
        return [which + (self.axes() if kind == 2 else "")]

    def machine(self) -> list[str]:
        return [f"G90 G53 {self.dice.choice(['G0', 'G1'])}{self.axes()}"]

    def length(self) -> list[str]:
        return [self.dice.choice([f"G43.1{self.axes(least=1)}", f"G43.1 Z{self.number()}", "G49"])]

    def cycle(self) -> list[str]:
        plane = self.plane = self.dice.choice(list(AXES))
        first, second, normal = AXES[plane]
        code = self.dice.choice(["G73", "G74", "G81", "G82", "G83", "G84", "G85", "G86", "G88", "G89", "G81", "G83", "G82"])
        if plane != "G17" and code in ("G74", "G84"):
            code = "G81"  # there LinuxCNC feeds along another axis
        absolute = self.dice.random() < 0.6
        at = f" {first}{self.number()}" + (f" {second}{self.number()}" if self.dice.random() < 0.6 else "")
        depth = f" {normal}{self.dice.choice(['-3', '-4.25', '-10'])} R{self.dice.choice(['-1', '0', '2', '5'])}"
        rest = {
            "G82": " P0.5",
            "G86": " P0.25",
            "G88": " P1",
            "G89": " P0.75",
            "G73": " Q1.3",
            "G83": " Q0.9",
            "G84": "",
            "G74": " P0.5",
        }.get(code, "")
        repeats = f" L{self.dice.randrange(1, 5)}" if self.dice.random() < 0.3 and code != "G74" else ""
        mode = ("G90 " if absolute else "G91 ") + self.dice.choice(["G98 ", "G99 ", ""])
        spindle = ["M4"] if code == "G74" else ["M3"]
        lines = [f"{plane} G94 F120", *spindle, f"{mode}{code}{at}{depth}{rest}{repeats}"]
        for _ in range(self.dice.randrange(3)):
            sticky = self.dice.choice([f"{second}{self.number()}", f"{first}{self.number()} L2", f"{first}1 {normal}-5", f"{first}2 R1",
            "G98 " + f"{first}1",
                                       f"G91 {first}1", f"G90 {second}2", f"{code} {first}3"])  # fmt: skip
            lines.append(sticky)
        return [*lines, self.dice.choice(["G80", "G80", "G0 X1", "G1 Y2", "G80 G0 Z9"])]

    def inverse(self) -> list[str]:
        lines = ["G93"]
        for _ in range(self.dice.randrange(1, 4)):
            i = OFFSETS[AXES[self.plane][0]]
            lines.append(
                self.dice.choice([f"G1{self.axes(least=1)} F{self.dice.choice(['2', '0.5', '30'])}", f"G2 {i}3 F4", f"G0{self.axes()}"])
            )
        return [*lines, "G94 F90"]

    def per_turn(self) -> list[str]:
        return ["G95 F0.25", f"G1{self.axes(least=1)}", "S700", f"G1{self.axes(least=1)}", "G94 F80"]

    def spline(self) -> list[str]:
        self.plane = "G17"
        lines = ["G17 G94 F100 G1 X2 Y1"]
        kind = self.dice.randrange(3)
        if kind == 0:
            lines.append("G90 G5 X5 Y1 I1 J2 P-1 Q2.5")
            lines += ["G5 X9 Y3 P-2 Q-1"] * self.dice.randrange(2)
        elif kind == 1:
            lines.append(self.dice.choice(["G90 G5.1 X6 Y2 I2 J3", "G91 G5.1 X2 Y2 I0 J3"]))
        else:
            lines += [
                f"G90 G5.2 X{self.dice.randrange(3, 6)} Y2 P1{self.dice.choice(['', ' L3', ' L4'])}",
                "X6 Y5 P2",
                "X8 Y1 P0.7",
                "X10 Y4 P1",
                "G5.3",
            ]
        return [*lines, "G1 X0"]

    def polar(self) -> list[str]:
        self.plane = "G17"
        step = self.dice.choice(["@10 ^30", "^77.7", "@3", "@5 ^-100", f"@4 ^10 Z{self.number()}"])
        return ["G17 G90 G0 X3 Y4", f"{self.dice.choice(['G0', 'G1', 'G91 G1', 'G91 G0'])} {step}"]

    def dwell(self) -> list[str]:
        return [self.dice.choice(["G4 P0.5", "G4 P2", "G4 P0", "G4 P[1/4]", "G1 X1 G4 P0.1"])]

    def control(self) -> list[str]:
        return [self.dice.choice(["G61", "G61.1", "G64", "G64 P0.01", "G64 P0.02 Q0.005", "G64 P0", "G64 Q0.1"])]

    def parameter(self) -> list[str]:
        return [self.dice.choice(["#7 = [#7 + 0.5]", "#7 = 3", "#<depth> = [#5422 - 1]\nG0 Z#<depth>", "#<_far> = 8 #7 = 2",
        "G0 X#5421 #7 = 1.25 Y#7",
                                  "#5221 = 3", "#5243 = -2", "#5230 = 15\nG55\nG54", "#5211 = 1\nG92.3", "#7 = EXISTS[#<_far>]",
                                  "G1 X[#5221 + 1] Y[#5220]",
                                  "G1 X[#5161 / 2] Y#5211"])][0].split("\n")  # fmt: skip

    def own(self) -> list[str]:
        name = self.dice.choice(["_x", "_y", "_z", "_metric", "_absolute", "_plane", "_motion_mode", "_coord_system", "_tool_offset",
        "_rpm",
                                 "_spindle_on", "_retract_r_plane", "_call_level", "_incremental", "_abs_x", "_abs_z",
                                 "_ijk_absolute_mode", "_lathe_diameter_mode", "_units_per_minute", "_line"])  # fmt: skip
        return [f"G0 X[#<{name}> * 0.01]"]

    def flow(self) -> list[str]:
        if self.depth > 2:
            return self.straight()
        self.depth += 1
        label = self.fresh()
        broken, self.broken = self.broken, False  # a fault in a subprogram is reported at its call
        body = [line for _ in range(self.dice.randrange(1, 4)) for line in self.block()]
        self.broken = broken
        loop = self.while_loop if self.breaks else self.do_loop
        made = self.dice.choice([self.condition, self.while_loop, loop, self.repeat, self.call])(label, body)
        self.depth -= 1
        return made

    def fresh(self) -> str:
        self.label += 1
        return self.dice.choice([f"o{self.label}", f"o<Name {self.label}>", f"O[{self.label - 1} + 1]"])

    def condition(self, label: str, body: list[str]) -> list[str]:
        test = self.dice.choice(["[#7 GT 2]", "[1]", "[0]", "[#7 EQ 3]", "[#5420 LT 0]"])
        other = [line for _ in range(self.dice.randrange(1, 3)) for line in self.block()]
        if self.dice.random() < 0.3:
            return [f"{label} if {test}", *body, f"{label} elseif [#7 LT 4]", *other, f"{label} else", *self.straight(), f"{label} endif"]
        return [f"{label} if {test}", *body, f"{label} else", *other, f"{label} endif"]

    def while_loop(self, label: str, body: list[str]) -> list[str]:
        self.label += 1
        counter = f"#<n{self.label}>"
        leave = [
            [],
            [
                f"o{self.label} if [{counter} EQ 2]",
                f"  {label} {self.dice.choice(['break', 'continue'][not self.breaks :])}",
                f"o{self.label} endif",
            ],
        ]
        return [
            f"{counter} = 0",
            f"{label} while [{counter} LT 3]",
            f"{counter} = [{counter} + 1]",
            *self.dice.choice(leave),
            *body,
            f"{label} endwhile",
        ]

    def do_loop(self, label: str, body: list[str]) -> list[str]:
        self.label += 1
        counter = f"#<n{self.label}>"
        return [f"{counter} = 0", f"{label} do", f"{counter} = [{counter} + 1]", *body, f"{label} while [{counter} LT 2]"]

    def repeat(self, label: str, body: list[str]) -> list[str]:
        return [f"{label} repeat [{self.dice.choice(['2', '3', '0', '1.2', '#7'])}]", *body, f"{label} endrepeat"]

    def call(self, label: str, body: list[str]) -> list[str]:
        if self.depth > 1:
            return self.repeat(label, body)
        inside = self.dice.choice([["G1 X#1 Y#2"], ["G0 Z#1", "#7 = 9"], ["#1 = [#1 + 1]", "G1 Y#1"], ["#<own> = #2", "G0 X#<own>"]])
        end = self.dice.choice(["endsub", "endsub [#1 * 2]", "endsub"])
        sub = [f"{label} sub", *[line for line in body if " sub" not in line], *inside, f"{label} {end}"]
        use = (
            [f"{label} call [{self.number()}] [2]", "G0 X[#<_value> + 1]"]
            if self.dice.random() < 0.5
            else [f"{label} call", f"{label} call [#7]"]
        )
        return [*sub, *use]

    def call_fanuc(self) -> list[str]:
        self.label += 1
        self.subs += [f"O{self.label}", f"G1{self.axes(least=1)}", "#7 = 2", "M99"]
        return [f"M98 P{self.label}" + self.dice.choice(["", " L2", " L1"])]
