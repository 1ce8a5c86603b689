"""Random machines and controllers as text, of few structures, so that their machine code is there before the first input."""

from __future__ import annotations

import random
from collections.abc import Sequence

KINDS = ("rigid", "mass", "play", "encoder")
"""Kinds of machines; `encoder` alone measures in whole counts."""
COUNT = 0.1e-6
"""Travel per count [m]."""
_HEAD = """{motion}
[machine]
name = "{kind}"
servo_period = "1 ms"
axes = {names}
[axes."*".limits]
velocity = "150 mm/s"
acceleration = "1 m/s^2"
jerk = "40 m/s^3"
travel = ["-200 mm", "200 mm"]
"""
_AXIS = {
    "rigid": """plant = {{kind = "rigid-axis", gain = "{gain} m/s^2/full_scale", damping = "{damping} 1/s"}}
friction = {{kind = "coulomb", coulomb = "{friction} full_scale", breakaway = "{friction} full_scale", viscous = "0.01 full_scale*s/m"}}
""",
    "mass": """plant = {{kind = "mass-damper", mass = "{mass} kg", damping = "100 N*s/m", force_constant = "60 N/A"}}
friction = {{kind = "lugre", coulomb = "20 N", breakaway = "25 N", stiffness = "{stiffness} N/m", bristle_damping = "300 N*s/m"}}
drive = {{kind = "delayed-saturation", limit = "10 A", delay = "{delay} ms"}}
substeps = 2
""",
    "play": """plant = {{kind = "two-inertia", motor_inertia = "2 kg*cm^2", lead = "10 mm", stiffness = "253 N*m/rad", \
shaft_damping = "0.008 N*m*s/rad", load_damping = "0.004 N*m*s/rad", backlash_gap = "{gap} um", mass = "{mass} kg"}}
friction = {{kind = "coulomb", coulomb = "40 N", breakaway = "50 N", stribeck_velocity = "2 mm/s"}}
substeps = 6
""",
}
_AXIS["encoder"] = _AXIS["rigid"] + f'sensor = {{{{kind = "encoder", resolution = "{COUNT * 1e6:g} um"}}}}\n'
_CONTROLLER = {
    "rigid": """[controller]
estimator = {kind = "newton"}
coupling = {kind = "modified-reference", weight = 0.5}
[controller.axes."*"]
controller = {kind = "position", position_gain = "4 full_scale/mm", velocity_gain = "0.1 full_scale*s/mm"}
observer = {kind = "disturbance-observer", model_gain = "1.5 m/s^2/full_scale"}
""",
    "mass": """[controller]
estimator = {kind = "newton"}
coupling = {kind = "cross-coupled", gain = "4 A/mm"}
[controller.axes."*"]
controller = {kind = "pid", proportional_gain = "8 A/mm", integral_gain = "100 A/mm/s", derivative_gain = "0.12 A*s/mm"}
""",
    "play": """[controller.axes."*"]
feedback = "motor"
controller = {kind = "cascade", position_gain = "30 1/s", velocity_gain = "0.03 N*m*s/mm", integral_time = "20 ms"}
""",
}
_CONTROLLER["encoder"] = _CONTROLLER["rigid"]


def axis_tables(kind: str, draw: random.Random, n_axis: int, equal: bool) -> list[str]:
    """Return the parts of each axis; all the same if ``equal``."""

    def table() -> str:
        return _AXIS[kind].format(
            gain=round(draw.uniform(1.2, 2.2), 3),
            damping=round(draw.uniform(2.0, 20.0), 3),
            friction=round(draw.uniform(0.005, 0.05), 4),
            mass=round(draw.uniform(30.0, 90.0), 2),
            stiffness=draw.choice((2e6, 5e6)),
            delay=draw.choice((0.3, 1.4)),
            gap=round(draw.uniform(5.0, 30.0), 2),
        )

    return [table()] * n_axis if equal else [table() for _ in range(n_axis)]


def scenario(kind: str, tables: Sequence[str], motion: str, names: str = "xyz", run: str = "") -> str:
    """Return a scenario: axes called ``names`` with these parts, and ``motion``, a line or table that says what moves."""
    key, _, contour = motion.partition("\n")
    axes = "".join(f'[axes."{name}"]\n{table}' for name, table in zip(names, tables, strict=False))
    listed = str([*names[: len(tables)]]).replace("'", '"')
    return f"{_HEAD.format(motion=key, kind=kind, names=listed)}{axes}{_CONTROLLER[kind]}{contour}\n[run]\nseed = 7\n{run}"
