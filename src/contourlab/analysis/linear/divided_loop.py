"""Stability for small errors of a machine whose controllers are divided between base and axes by message links.

The schedule is cut at the links: link outputs become inputs, link inputs become outputs, and the rest is one linear map from tick to tick.
Message period, delay and hold enter exactly, as matrices, so that one map serves every period and delay. Links repeat after a number of
ticks; the product over one repetition shows whether errors decay.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.linear.sampled_loop import linear_axis, linear_controller
from contourlab.analysis.linear.tick_map import loop_states, tick_map
from contourlab.arrays import Array
from contourlab.components.contract import Component
from contourlab.components.estimator.local import Tangent
from contourlab.components.ideal import IdealLink
from contourlab.components.link.network import Network
from contourlab.engine.step import Late, Port, Schedule
from contourlab.errors import ComponentError, ParameterError
from contourlab.geometry import Line, Path
from contourlab.loop.judging import WATCH
from contourlab.loop.machine import AxisController, Controller, Division, Machine
from contourlab.loop.template import build

LONGEST = 20_000
"""Longest repetition of the links [ticks]."""


@dataclass(frozen=True)
class LinkTiming:
    """A link without randomness: a message every `spacing` ticks, delayed by `taken` ticks."""

    spacing: int = 1
    taken: int = 0


def timing_of(link: Component | None, servo_period: float) -> LinkTiming:
    """Return the timing of a link, with every message as late as its jitter allows and none lost.

    Raises
    ------
    ComponentError
        If it extrapolates, or its kind is unknown.
    """
    if link is None or isinstance(link, IdealLink):
        return LinkTiming()
    if not isinstance(link, Network) or link.between != "hold":
        raise ComponentError(f"link {link.kind}: only links that hold the last message have a linear model")
    values = link.block(servo_period)
    return LinkTiming(int(values["spacing"]), int(values["latest"]))


@dataclass(frozen=True, eq=False)
class DividedLoop:
    """The machine cut at its links: x(k + 1) = A x(k) + B r(k) and s(k) = C x(k) + E r(k), with signals r received and s sent.

    Attributes
    ----------
    a : ndarray (n, n)
    b, c : ndarray (n, m), (m, n)
    e : ndarray (m, m)
        Nilpotent: the reply in the tick in which a message arrives.
    links : tuple of (str, str)
        Axis and direction, ``"down"`` or ``"up"``, of each signal that is part of the loop.
    """

    a: Array
    b: Array
    c: Array
    e: Array
    links: tuple[tuple[str, str], ...]

    def growth(self, down: LinkTiming, up: LinkTiming) -> float:
        """Return the largest growth factor of an error per tick; below 1 the machine is stable.

        All axes have the same links.

        Raises
        ------
        ComponentError
            If the two directions repeat jointly only after more than `LONGEST` ticks.
        """
        return self.growth_of([down if way == "down" else up for _, way in self.links])

    def growth_of(self, timings: Sequence[LinkTiming]) -> float:
        """Return the largest growth factor per tick, with a timing for each of `links`."""
        repeat = math.lcm(*(t.spacing for t in timings)) if timings else 1
        if repeat > LONGEST:
            raise ComponentError(f"the links repeat only after {repeat} ticks: choose periods with a smaller common multiple")
        product = np.eye(len(self.a) + sum(t.taken for t in timings) + len(timings))

        @cache
        def at(fresh: tuple[bool, ...]) -> Array:
            return self._tick(timings, fresh)

        for k in range(repeat):
            product = at(tuple((k - t.taken) % t.spacing == 0 for t in timings)) @ product
        return float(_radius(product) ** (1.0 / repeat))

    def _tick(self, timings: Sequence[LinkTiming], fresh: tuple[bool, ...]) -> Array:
        """Return the matrix of a tick over the states, the messages in transit, signal by signal, and the last values received."""
        n, m = len(self.a), len(timings)
        first = np.cumsum([n, *(t.taken for t in timings)])
        held = int(first[-1])
        size = held + m
        here = np.diag([float(new and t.taken == 0) for new, t in zip(fresh, timings, strict=True)])
        arrived = np.zeros((m, size))
        for i, t in enumerate(timings):
            arrived[i, first[i + 1] - 1 if fresh[i] and t.taken else held + i] = float(not (fresh[i] and t.taken == 0))
        sent = np.hstack([self.c, np.zeros((m, size - n))])
        received = np.linalg.solve(np.eye(m) - here @ self.e, here @ sent + arrived)
        matrix = np.zeros((size, size))
        matrix[:n] = self.b @ received
        matrix[:n, :n] += self.a
        entering = sent + self.e @ received
        for i, t in enumerate(timings):
            if t.taken:
                matrix[first[i]] = entering[i]
                rows = np.arange(first[i] + 1, first[i + 1])
                matrix[rows, rows - 1] = 1.0
        matrix[held:] = received
        return matrix


def _radius(matrix: Array) -> float:
    """Return the largest magnitude of `poles_of` a tick matrix; sets of states that do not act on one another go one by one."""
    from scipy.sparse.csgraph import connected_components

    kept = loop_states(matrix)
    count, sets = connected_components(matrix[np.ix_(kept, kept)] != 0.0, connection="strong")
    blocks = [kept[sets == i] for i in range(count)]
    return max((float(np.abs(np.linalg.eigvals(matrix[np.ix_(own, own)])).max()) for own in blocks), default=0.0)


def divided_loop(machine: Machine, controller: Controller, tangent: ArrayLike | None = None) -> DividedLoop:
    """Return a machine cut at its links, without friction, disturbance, quantisation and limits.

    Parameters
    ----------
    controller : Controller
        At least one axis has a link; the timing of links is ignored.
    tangent : array_like (n_axis,), optional
        Constant direction of the path, the diagonal by default. It matters for coupled axes only.

    Raises
    ------
    ParameterError
        If no axis has a link, or the direction is zero.
    ComponentError
        If a component is not linear.
    """
    names = machine.axis_names
    if all(controller.axes[name].link is None for name in names):
        raise ParameterError("controller.axes", "without a link", "one with a link at least, whose controller is divided")
    t = np.ones(len(names)) if tangent is None else np.asarray(tangent, dtype=float)
    if t.shape != (len(names),) or not np.isfinite(t).all() or not t.any():
        raise ParameterError("tangent", f"{t.tolist()}", f"{len(names)} numbers, not all zero")
    # Drop rounding, such as sin(pi), which would look nonlinear.
    t = np.where(np.abs(t) < 1e-9 * np.abs(t).max(), 0.0, t)
    path = Path([Line(tuple(np.zeros(len(names))), tuple(t / np.linalg.norm(t)))])
    axes = tuple(linear_axis(axis, machine.carried_mass(axis.name)) for axis in machine.axes)
    estimator = None if controller.coupling is None else Tangent()
    made = Controller({name: _linear(controller.axes[name]) for name in names}, estimator, controller.coupling)
    return _cut(build(Machine(machine.name, axes, machine.servo_period), made, path, np.zeros(len(names))).schedule, names)


def _linear(controller: AxisController) -> AxisController:
    """Return an axis' controller without nonlinear parts, with its links as nodes."""
    link = controller.link
    if link is not None:
        link = Division(link.division, Network(), None if link.up is None else Network())
    return replace(linear_controller(controller), feedforward=None, link=link)


def _cut(whole: Schedule, names: Sequence[str]) -> DividedLoop:
    """Replace the nodes of the links by inputs."""
    ways = {f"{name}.{way}_": (name, way) for name in names for way in ("down", "up")}
    links = {node.name: key for node in whole.nodes for head, key in ways.items() if node.name.startswith(head)}
    inputs = {f"{name}.received": f"in.received_{i}" for i, name in enumerate(links)}

    def led(wire: Any) -> Any:
        if isinstance(wire, tuple):
            return tuple(led(part) for part in wire)
        return inputs.get(wire, wire) if isinstance(wire, str) else wire

    nodes, sent = [], []
    for node in whole.nodes:
        if node.name in links:
            sent.append(led(node.wires["sent"]))
        elif node.name != WATCH:
            wires = {port: led(wire) for port, wire in node.wires.items()}
            # The path is straight: the arc length does not matter.
            nodes.append(replace(node, wires={**wires, "arc_length": 0.0} if "arc_length" in wires else wires))
    externals = (*whole.externals, *(Port(f"received_{i}") for i in range(len(links))))
    whole_map = tick_map(Schedule(tuple(nodes), externals, whole.period, len(nodes)))
    n, m = len(whole_map.a), len(links)
    b = whole_map.b[:, [whole_map.column(f"in.received_{i}") for i in range(m)]]
    c, e = np.zeros((m, n)), np.zeros((m, m))
    for i, wire in enumerate(sent):
        if isinstance(wire, Late):
            c[i, whole_map.row(wire.signal)] = 1.0
        elif wire.startswith("in.received_"):
            e[i, int(wire.removeprefix("in.received_"))] = 1.0
        elif not wire.startswith("in."):  # the reference comes from outside the loop
            row = whole_map.row(wire)
            c[i], e[i] = whole_map.a[row], b[row]
    # External signals, such as the reference, are not part of the loop.
    kept = np.flatnonzero(c.any(axis=1) | e.any(axis=1))
    return DividedLoop(whole_map.a, b[:, kept], c[kept], e[np.ix_(kept, kept)], tuple(list(links.values())[i] for i in kept))


def link_growth(machine: Machine, controller: Controller) -> float:
    """Return the largest growth factor of an error per tick, with the links of the machine.

    For coupled axes, return the largest over a few directions of the path: along each axis and along the diagonal.

    Raises
    ------
    ComponentError
        If a component or link has no linear model, or the links repeat only after more than `LONGEST` ticks.
    """
    names, period = machine.axis_names, machine.servo_period
    directions = [*np.eye(len(names)), np.ones(len(names))] if controller.coupling is not None else [np.ones(len(names))]
    growths = []
    for tangent in directions:
        loop = divided_loop(machine, controller, tangent)
        growths.append(loop.growth_of([timing_of(getattr(controller.axes[axis].link, way), period) for axis, way in loop.links]))
    return max(growths)
