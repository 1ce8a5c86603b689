"""Two masses with a gap, moved by an independent solver: one smooth problem between two events that it locates."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

Array = NDArray[np.float64]


@dataclass
class Reference:
    """Masses [kg], stiffness [N/m], damping [N s/m], half of the free travel [m] with the load at 0, its slope, and frictions [N].

    `coulomb` and `breakaway` are pairs (motor, load). A side of 2 means a linear shaft without a gap.
    """

    motor: float
    load: float
    stiffness: float
    damping: float
    half: float
    slope: float = 0.0
    physical: bool = True
    coulomb: tuple[float, float] = (0.0, 0.0)
    breakaway: tuple[float, float] = (0.0, 0.0)

    def shaft(self, side: int, y: Any, rate_too: bool = True) -> float:
        if side == 0:
            return 0.0
        flank = side * (self.half + self.slope * y[2])
        rate = y[1] - y[3] - side * self.slope * y[3]
        return self.stiffness * (y[0] - y[2] - flank) + (self.damping * rate if rate_too else 0.0)

    def nets(self, side: int, y: Any, push: float) -> tuple[float, float]:
        force = self.shaft(side, y)
        return push - force, force * (1.0 + side * self.slope)

    def rates(self, side: int, ways: tuple[int, int], y: Any, push: float) -> list[float]:
        net = self.nets(side, y, push)
        a = [0.0 if way == 0 else (n - way * f) / m for way, n, f, m in zip(ways, net, self.coulomb, (self.motor, self.load), strict=True)]
        twist = -self.stiffness / self.damping * y[4] if side == 0 and self.damping > 0.0 else 0.0
        return [y[1], a[0], y[3], a[1], twist]

    def _slope(self, side: int, ways: tuple[int, int], push: float) -> Any:
        return lambda t, y: self.rates(side, ways, y, push)

    def _guards(self, side: int, ways: tuple[int, int], push: float) -> list[tuple[str, Any]]:
        found: list[tuple[str, Any]] = []
        if side == 0:
            for flank in (1, -1):
                found.append((f"reach {flank}", lambda t, y, s=flank: self.half + self.slope * y[2] - s * (y[0] - y[2] - y[4])))
        else:
            found.append(("leave", lambda t, y: side * self.shaft(side, y, self.physical)))
        for body, (way, at) in enumerate(zip(ways, (1, 3), strict=True)):
            if self.breakaway[body] == 0.0:
                continue
            if way:
                found.append((f"stop {body}", lambda t, y, w=way, i=at: w * y[i]))
            else:
                found.append((f"loose {body}", lambda t, y, b=body: self.breakaway[b] - abs(self.nets(side, y, push)[b])))
        for _, guard in found:
            guard.terminal, guard.direction = True, -1.0
        return found

    def _ways(self, side: int, y: Array, push: float) -> tuple[int, int]:
        ways = []
        for body, (v, net) in enumerate(zip((y[1], y[3]), self.nets(side, y, push), strict=True)):
            resting = 0 if abs(net) <= self.breakaway[body] and self.breakaway[body] > 0.0 else int(math.copysign(1.0, net))
            ways.append(int(math.copysign(1.0, v)) if v else resting)
        return ways[0], ways[1]

    def _after(self, what: str, body: int, side: int, ways: tuple[int, int], y: Array, push: float) -> tuple[int, int]:
        """Return the sliding directions after an event; a damped shaft that engages may kick a resting body loose."""
        after = list(ways)
        for b, net in enumerate(self.nets(side, y, push)):
            free = int(math.copysign(1.0, net))
            if what == "loose" and b == body:
                after[b] = free
            elif (what == "stop" and b == body) or after[b] == 0:
                after[b] = 0 if abs(net) <= self.breakaway[b] else free
        return after[0], after[1]

    def hold(self, y: Array, side: int, push: float, duration: float) -> tuple[Array, int]:
        """Carry (motor position, velocity, load position, velocity, twist) and side over a time with the push held."""
        left = duration
        ways = self._ways(side, y, push)
        while left > 1e-15:
            guards = self._guards(side, ways, push)
            options: Any = {"method": "DOP853", "rtol": 3e-14, "atol": 1e-17, "max_step": duration / 4.0}
            found = solve_ivp(self._slope(side, ways, push), (0.0, left), y, events=[guard for _, guard in guards], **options)
            left, y = left - float(found.t[-1]), found.y[:, -1].copy()
            hit = [name for (name, _), times in zip(guards, found.t_events, strict=True) if len(times)]
            if not hit:
                break
            what, number = hit[0].split() if " " in hit[0] else (hit[0], "0")
            if what == "reach":
                side, y[4] = int(number), 0.0
            elif what == "leave":
                y[4] = y[0] - y[2] - side * (self.half + self.slope * y[2]) if self.damping > 0.0 and self.physical else 0.0
                side = 0
            elif what == "stop":
                y[1 + 2 * int(number)] = 0.0
            ways = self._after(what, int(number), side, ways, y, push)
        return y, side
