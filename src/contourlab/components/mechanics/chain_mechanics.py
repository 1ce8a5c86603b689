"""Masses behind each other, joined by shafts with or without backlash, a friction on the first and on the last: one step through time.

It is `two_mass_mechanics` for any number of masses: a smooth stretch is a Runge-Kutta step of fourth order, and ends
where the first of all joints reaches or leaves a flank, or one of the two rubbing masses stops or breaks loose. The text of the step is
written for the number of masses, as compiled code knows no lists; two masses give the very numbers of the two-mass drive.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from contourlab.components.mechanics.located import first_zero, hermite
from contourlab.components.mechanics.two_mass_laws import UNKNOWN, contact_guard_of, friction_of, shaft_of, unwound
from contourlab.components.mechanics.two_mass_mechanics import CONTACT, END, LOAD, MOTOR, STRETCHES, body_event_of, ways_of
from contourlab.engine.step import record
from contourlab.primitives import select

JOINT = ("stiffness_value", "damper_value", "half_gap", "bonded", "unwinding")
"""What a joint is, each a row of the plant's parameters with the joint's number behind."""


def _even(par: Any, position: float) -> tuple[float, float]:
    return par.half_gap, 0.0


@cache
def _contact_event_of(physical: bool) -> Callable[..., Any]:
    """Return ``event(joint, number, side, flank, twist, y, a, h, found)``: `found`, or the end of a contact where that comes first.

    twist, y and a (states and accelerations on both sides of the joint) are pairs: at the start and the end of the stretch.
    """
    guard, falling = contact_guard_of(_even, physical)

    def event(joint: Any, number: float, side: float, flank: float, twist: Any, y: Any, a: Any, h: float, found: Any) -> Any:
        u, why, which = found
        last = guard(joint, side, flank, y[1], twist[1])
        if last < 0.0 and joint.bonded < 0.5:
            d0 = falling(joint, side, flank, y[0], a[0], twist[0])
            d1 = falling(joint, side, flank, y[1], a[1], twist[1])
            at = first_zero(guard(joint, side, flank, y[0], twist[0]), last, h * d0, h * d1)
            if at < u:
                u, why, which = at, CONTACT, number
        return u, why, which

    return event


def _after(joint: Any, side: float, flank: float, twist: float, theta: float, touched: bool, passed: float) -> Any:
    """Return side and twist of a joint where a stretch ends; `touched` is whether it ended by this joint."""
    left = select(joint.unwinding > 0.0, theta - side * joint.half_gap, 0.0)
    kept = select(side == 0.0, unwound(joint, twist, passed), left)
    side = select(touched, select(side == 0.0, flank, 0.0), side)
    return side, select(side == 0.0, kept, 0.0)


def _rise(joint: Any, side: float, y: Any, a: Any) -> float:
    """Return how fast what a joint transmits rises."""
    slope = joint.stiffness_value * (y[1] - y[3]) + joint.damper_value * (a[0] - a[1])
    return select(side == 0.0, 0.0, slope)


def _each(pattern: str, count: int) -> str:
    """Return the parts of a tuple: the pattern for each number, with p and v for where position and velocity stand, and the next ones."""
    parts = (pattern.format(i=i, p=2 * i, v=2 * i + 1, j=i + 1, q=2 * i + 2, w=2 * i + 3) for i in range(count))
    return "(" + ", ".join(parts) + ",)"


def _lines(pattern: str, count: int) -> str:
    return "".join(f"    {pattern.format(i=i, p=2 * i, v=2 * i + 1, j=i + 1, q=2 * i + 2, w=2 * i + 3)}\n" for i in range(count))


def _smooth_source(n: int) -> str:
    """Return the source of ``slide``, a smooth stretch of n masses, and ``between``, the states within it."""
    joints, last, end = n - 1, n - 1, 2 * n - 1
    pieces = [
        "".join(f"def joint_{j}(par):\n    return Joint({', '.join(f'par.{name}_{j}' for name in JOINT)})\n\n" for j in range(joints)),
        "def rates(par, sides, ways, push, y):\n",
        _lines("back_{i}, forth_{i} = shaft(joint_{i}(par), sides[{i}], (y[{p}], y[{v}], y[{q}], y[{w}]))", joints),
        "    a_0 = par.mobility_0 * (push[0] - back_0 - resist_motor(motor_view(par), y[1], ways[0])) - par.motor_decay * y[1]\n",
        "".join(f"    a_{i} = par.mobility_{i} * (forth_{i - 1} - back_{i})\n" for i in range(1, last)),
        f"    a_{last} = par.mobility_{last} * (push[1] + forth_{last - 1} - resist_load(load_view(par), y[{end}], ways[1]))"
        f" - par.load_decay * y[{end}]\n",
        f"    a_0, a_{last} = select(ways[0] == 0.0, 0.0, a_0), select(ways[1] == 0.0, 0.0, a_{last})\n",
        f"    return {_each('a_{i}', n)}\n\n",
        "def slide(par, sides, ways, push, y, h):\n    half, sixth = 0.5 * h, h / 6.0\n",
        "    k1 = rates(par, sides, ways, push, y)\n",
        f"    y2 = {_each('y[{p}] + half * y[{v}], y[{v}] + half * k1[{i}]', n)}\n",
        "    k2 = rates(par, sides, ways, push, y2)\n",
        f"    y3 = {_each('y[{p}] + half * y2[{v}], y[{v}] + half * k2[{i}]', n)}\n",
        "    k3 = rates(par, sides, ways, push, y3)\n",
        f"    y4 = {_each('y[{p}] + h * y3[{v}], y[{v}] + h * k3[{i}]', n)}\n",
        "    k4 = rates(par, sides, ways, push, y4)\n    end = ",
        _each(
            "y[{p}] + sixth * (y[{v}] + 2.0 * (y2[{v}] + y3[{v}]) + y4[{v}]), "
            "y[{v}] + sixth * (k1[{i}] + 2.0 * (k2[{i}] + k3[{i}]) + k4[{i}])",
            n,
        ),
        "\n    return end, k1, k4\n\ndef between(u, h, y, y1, a, a1):\n    return ",
        _each("hermite(u, y[{p}], y1[{p}], h * y[{v}], h * y1[{v}]), hermite(u, y[{v}], y1[{v}], h * a[{i}], h * a1[{i}])", n),
        "\n\n",
    ]
    return "".join(pieces)


def _stretch_source(n: int) -> str:
    """Return the source of ``stretch``: from an event to the next one, or to the end of the step."""
    joints, last, end = n - 1, n - 1, 2 * n - 1
    first_pair = "({0}[0], {0}[1], {0}[2], {0}[3])"
    last_pair = f"({{0}}[{end - 3}], {{0}}[{end - 2}], {{0}}[{end - 1}], {{0}}[{end}])"

    def nets(y: str) -> str:
        at_first, at_last = first_pair.format(y), last_pair.format(y)
        return (
            f"(push[0] - shaft(joint_0(par), sides[0], {at_first})[0], "
            f"push[1] + shaft(joint_{last - 1}(par), sides[{last - 1}], {at_last})[1])"
        )

    def rise(joint: int, pair: str, y: str, a: str) -> str:
        return f"rise(joint_{joint}(par), sides[{joint}], {pair.format(y)}, ({a}[{joint}], {a}[{joint + 1}]))"

    both = ", ".join
    risen = [(rise(0, first_pair, y, a), rise(last - 1, last_pair, y, a)) for y, a in (("y", "a"), ("y1", "a1"))]
    pair_of = "({0}[{p}], {0}[{v}], {0}[{q}], {0}[{w}])"
    states = pair_of.replace("{0}", "y") + ", " + pair_of.replace("{0}", "y1")
    pieces = [
        "def stretch(par, sides, twists, released, push, y, h):\n",
        f"    net = {nets('y')}\n",
        f"    ways = ways_at(par, net, (y[0], y[1], y[{end - 1}], y[{end}]), released)\n",
        "    y1, a, a1 = slide(par, sides, ways, push, y, h)\n",
        f"    net1 = {nets('y1')}\n",
        f"    twists1 = {_each('unwound(joint_{i}(par), twists[{i}], h)', joints)}\n",
        "    found = 1.0, END, -1.0\n",
        _lines("flank_{i} = select(y1[{p}] - y1[{q}] - twists1[{i}] > 0.0, 1.0, -1.0)", joints),
        _lines(
            "found = contact_event(joint_{i}(par), {i}.0, sides[{i}], flank_{i}, (twists[{i}], twists1[{i}]), "
            f"({states}), ((a[{{i}}], a[{{j}}]), (a1[{{i}}], a1[{{j}}])), h, found)",
            joints,
        ),
        "    u, why, which = found\n",
        f"    steep = -{risen[0][0]}, -{risen[1][0]}\n",
        "    at = motor_event(par, ways[0], (y[1], y1[1]), (a[0], a1[0]), (net[0], net1[0]), steep, h, (u, why, 0.0))\n",
        f"    steep = {both(pair[1] for pair in risen)}\n",
        f"    at = load_event(par, ways[1], (y[{end}], y1[{end}]), (a[{last}], a1[{last}]), (net[1], net1[1]), steep, h, at)\n",
        "    u, why, loose = at\n",
        "    if why == END:\n        return sides, twists1, (0.0, 0.0), y1, 0.0\n",
        "    z = between(u, h, y, y1, a, a1)\n",
        _lines(
            "side_{i}, twist_{i} = after(joint_{i}(par), sides[{i}], flank_{i}, twists[{i}], z[{p}] - z[{q}], "
            "select(why == CONTACT, which, -1.0) == {i}.0, u * h)",
            joints,
        ),
        "    released = select(why == MOTOR, loose, 0.0), select(why == LOAD, loose, 0.0)\n",
        f"    v_0, v_{last} = select(why == MOTOR, 0.0, z[1]), select(why == LOAD, 0.0, z[{end}])\n",
        "".join(f"    v_{i} = z[{2 * i + 1}]\n" for i in range(1, last)),
        f"    return {_each('side_{i}', joints)}, {_each('twist_{i}', joints)}, released, {_each('z[{p}], v_{i}', n)}, (1.0 - u) * h\n\n",
    ]
    return "".join(pieces)


def _step_source(n: int, shown: int) -> str:
    """Return the source of ``ending``, what is left without locating, and of ``step``; `shown` is the joint whose side is an output."""
    joints, last, end = n - 1, n - 1, 2 * n - 1
    inner = range(1, last)
    start = ["x.motor_position", "x.motor_velocity"]
    for i in inner:
        start += [f"x.inner_positions[{i - 1}]", f"x.inner_velocities[{i - 1}]"]
    within = [f"({''.join(f'y[{2 * i + k}], ' for i in inner)})" for k in (0, 1)] if inner else []
    moved = ", ".join(["y[0]", "y[1]", f"y[{end - 1}]", f"y[{end}]", *within, "sides", "twists"])
    theta = "y[{p}] - y[{q}]"
    located = f"select({theta} > joint_{{i}}(par).half_gap, 1.0, select({theta} < -joint_{{i}}(par).half_gap, -1.0, 0.0))"
    pieces = [
        "def ending(par, sides, push, y, h):\n",
        f"    open = {_each('select(joint_{i}(par).bonded > 0.5, 1.0, UNKNOWN)', joints)}\n",
        f"    net = push[0] - shaft(joint_0(par), open[0], (y[0], y[1], y[2], y[3]))[0], push[1] + shaft(joint_{last - 1}(par), "
        f"open[{last - 1}], (y[{end - 3}], y[{end - 2}], y[{end - 1}], y[{end}]))[1]\n",
        f"    ways = ways_at(par, net, (y[0], y[1], y[{end - 1}], y[{end}]), (0.0, 0.0))\n",
        "    y, _, _ = slide(par, open, ways, push, y, h)\n",
        "    v_0 = select(ways[0] * y[1] < 0.0, 0.0, y[1]) if motor_sticks else y[1]\n",
        f"    v_{last} = select(ways[1] * y[{end}] < 0.0, 0.0, y[{end}]) if load_sticks else y[{end}]\n",
        "".join(f"    v_{i} = y[{2 * i + 1}]\n" for i in inner),
        f"    sides = {_each(f'select(joint_{{i}}(par).bonded > 0.5, 1.0, {located})', joints)}\n",
        f"    return {_each('y[{p}], v_{i}', n)}, sides\n\n",
        "def step(par, x, inp, clock):\n",
        "    push = (par.force_value * inp.command, inp.load)\n",
        f"    sides = {_each('select(joint_{i}(par).bonded > 0.5, 1.0, x.sides[{i}])', joints)}\n",
        "    twists, released, left = x.twists, (0.0, 0.0), clock.dt\n",
        f"    y = ({', '.join(start)}, x.position, x.velocity)\n",
        f"    for _ in range({STRETCHES * joints}):\n",
        "        sides, twists, released, y, left = stretch(par, sides, twists, released, push, y, left)\n",
        "        if left <= 0.0:\n            break\n",
        "    if left > 0.0:\n        y, sides = ending(par, sides, push, y, left)\n",
        f"        twists = {_each('0.0 * twists[{i}]', joints)}\n",
        f"    force = shaft(joint_{last - 1}(par), sides[{last - 1}], (y[{end - 3}], y[{end - 2}], y[{end - 1}], y[{end}]))[1]\n",
        f"    out = (y[{end - 1}], y[{end}], (y[{end}] - x.velocity) / clock.dt, y[0], y[1], sides[{shown}], force)\n",
        f"    return ({moved}), out\n",
    ]
    return "".join(pieces)


@cache
def chain_step(n: int, shown: int, physical: bool, motor: Any, load: Any, motor_view: Any, load_view: Any) -> Callable[..., Any]:
    """Return the step of a plant of n masses.

    Parameters
    ----------
    n : int, >= 2
    shown : int
        The joint whose side is the output ``gap_state``.
    physical : bool
        Which of the two models of contact.
    motor, load : friction classes
        Of the first and the last mass; their laws are "smooth" or "sticking".
    motor_view, load_view : callable
        Pick the parameters of their frictions out of ``par``.
    """
    (resist_motor, _, motor_sticks), (resist_load, _, load_sticks) = friction_of(motor), friction_of(load)
    scope: dict[str, Any] = {
        "__name__": __name__,
        "Joint": record(JOINT),
        "shaft": shaft_of(_even),
        "contact_event": _contact_event_of(physical),
        "motor_view": motor_view,
        "load_view": load_view,
        "resist_motor": resist_motor,
        "resist_load": resist_load,
        "motor_event": body_event_of(motor, motor_view, MOTOR),
        "load_event": body_event_of(load, load_view, LOAD),
        "ways_at": ways_of(motor, load, motor_view, load_view),
        "motor_sticks": motor_sticks,
        "load_sticks": load_sticks,
        "select": select,
        "hermite": hermite,
        "unwound": unwound,
        "rise": _rise,
        "after": _after,
        "END": END,
        "CONTACT": CONTACT,
        "MOTOR": MOTOR,
        "LOAD": LOAD,
        "UNKNOWN": UNKNOWN,
    }
    exec(_smooth_source(n) + _stretch_source(n) + _step_source(n, shown), scope)
    step: Callable[..., Any] = scope["step"]
    return step
