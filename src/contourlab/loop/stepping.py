"""A servo loop that Python steps: for controllers that plan ahead, for learning agents, and for looking inside."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array
from contourlab.engine.runner import make_group
from contourlab.engine.step import Late
from contourlab.errors import ParameterError, refuse, refused
from contourlab.feed import Reference
from contourlab.geometry.view import PathView, check_view
from contourlab.loop.feeding import LEARNED_COMMAND, LEARNED_REFERENCE, PLANNED_TIME, RATE, Feed
from contourlab.loop.judging import WATCH, watched
from contourlab.loop.machine import Controller, Machine
from contourlab.loop.parameters import with_values
from contourlab.loop.progress import followed, motion_node
from contourlab.loop.simulate import (
    ToolPosition,
    check_kinds,
    first_non_finite,
    jit_enabled,
    logged,
    planned_end,
    result_of,
    sampler,
)
from contourlab.loop.template import build
from contourlab.notebook import facts_line
from contourlab.result import Result, Status

_INPUTS = {"command": LEARNED_COMMAND, "reference": LEARNED_REFERENCE, RATE: RATE}


class Loop:
    """A machine under its controller along a reference, one tick or some at a time.

    Parameters
    ----------
    machine : Machine
    controller : Controller
    reference : Reference
        Sampled at the machine's servo period.
    values : mapping of str to float, optional
        Parameters to set first [SI], by dotted name; see `contourlab.with_values`.
    inputs : sequence of {"command", "reference", "rate"}
        What `step` will give: commands added to those of the controllers, offsets of the references, the rate of the progress.
    seed : int
        Of all noise.
    jit : bool, optional
        Compiled, or plain Python, in which a component may call whatever it likes; compiled by default.
    view : PathView, optional
        As of `simulate`.
    moving : bool
        Whether the axes start with the velocity of the reference, at rate 1, instead of at rest.

    Attributes
    ----------
    tick : int
        Ticks done.
    status : Status
        Whether the loop has failed, where and why.

    Raises
    ------
    ParameterError
        If an argument is out of its range, or a controller cannot take an input.

    Notes
    -----
    Python decides from what the last tick measured, and its inputs act in the next: a delay of one tick, as of a control computer. The
    motion of the reference is kept in memory whole, 8 (3 n_axis + 2) bytes a sample, and 8 bytes for each signal of each tick.

    >>> import contourlab as cl
    >>> case = cl.load_scenario("builtin:demo-part").base
    >>> loop = cl.Loop(case.machine, case.controller, case.reference(), inputs=("rate",))
    >>> while not loop.done:
    ...     worst = abs(loop["reference"] - loop["position"]).max() if loop.tick else 0.0
    ...     _ = loop.step(10, rate=0.5 if worst > 1e-4 else 1.0)
    >>> run = loop.result()
    >>> run.motion.duration > case.reference().duration
    True
    """

    def __init__(
        self,
        machine: Machine,
        controller: Controller,
        reference: Reference,
        values: Mapping[str, float] | None = None,
        *,
        inputs: Sequence[str] = (),
        seed: int = 0,
        jit: bool | None = None,
        view: PathView | None = None,
        moving: bool = False,
    ) -> None:
        check_kinds(machine, controller, reference)
        if values:
            machine, controller = with_values(machine, controller, values)
        check_view(view, reference.path)
        inputs = (inputs,) if isinstance(inputs, str) else inputs
        for name in inputs:
            refuse(name not in _INPUTS, ParameterError, "inputs", repr(name), "one of " + ", ".join(_INPUTS))
        compiled = jit_enabled(jit)
        feed = Feed(machine, controller, reference, None, sampler(compiled), deciding=True)
        refuse(feed.decides and RATE in inputs, ParameterError, "inputs", "'rate'", "left out: the coupling decides the rate")
        self.machine, self.controller, self.reference, self.seed = machine, controller, reference, seed
        self._varies = feed.decides or RATE in inputs
        motion = motion_node(feed, Late(f"coupling.{RATE}") if feed.decides else f"in.{RATE}" if self._varies else 1.0)
        fed = (*feed.names, *(_INPUTS[name] for name in inputs))
        first = feed.first(moving=moving)
        self._wiring = build(machine, controller, reference.path, **first, view=view, seed=seed, fed=fed, motion=motion)
        self._group = make_group(self._wiring.schedule, 1, slice(0, 1), compiled)
        schedule, n = self._wiring.schedule, len(machine.axes)
        self._rows, self._places = logged(self._wiring, self._wiring.signals)
        edges = np.cumsum([0, *(port.rows for port in schedule.externals)])
        names = {port: name for name, port in _INPUTS.items()}
        self._inputs = {names[port.name]: slice(*edges[i : i + 2]) for i, port in enumerate(schedule.externals)}
        self._idle = np.zeros(edges[-1])
        self._idle[self._inputs.get(RATE, slice(0))] = 1.0
        self._watch = self._group.state_of(WATCH)
        self._past: tuple[Any, Array] | None = None  # of each step what was logged, and what came before it
        self.tick, self.status, self._n_axis = 0, Status(ok=True), n

    @property
    def signals(self) -> tuple[str, ...]:
        """Names of the signals that can be read, as of a result of `simulate`."""
        return tuple(self._wiring.signals)

    @property
    def time(self) -> float:
        """Time of the last tick [s]."""
        return max(self.tick - 1, 0) * self.machine.servo_period

    @property
    def done(self) -> bool:
        """Whether the motion has come to its end, or the loop has failed."""
        return not self.status.ok or (self._past is not None and float(self[PLANNED_TIME]) >= planned_end(self.reference))

    def __getitem__(self, name: str) -> Any:
        """Return a signal in the last tick: ndarray (n_axis,), or a float where the loop has one; unit as of a result."""
        refuse(name not in self._wiring.signals, ParameterError, "signal", repr(name), "one of " + ", ".join(self.signals))
        refuse(self._past is None, ParameterError, "signal", repr(name), "read after the first step")
        assert self._past is not None
        return self._past[1][-1, self._places[name]]

    def step(
        self, n: int = 1, *, command: ArrayLike | None = None, reference: ArrayLike | None = None, rate: float | None = None
    ) -> Status:
        """Run some ticks, up to the end of the motion, with inputs held.

        Parameters
        ----------
        n : int, >= 1
            Ticks.
        command : array_like (n_axis,) [command unit], optional
            Added to the commands; 0 by default.
        reference : array_like (n_axis,) [m], optional
            Added to the reference positions; 0 by default.
        rate : float, >= 0, optional
            Planned time per time; 1 by default: as planned.

        Raises
        ------
        ParameterError
            If an argument is out of its range, or not one of the loop's `inputs`; or the loop is done.
        """
        refuse(int(n) != n or n < 1, ParameterError, "n", repr(n), "a whole number >= 1")
        refuse(self.done, ParameterError, "step", f"at tick {self.tick}", "left out: the loop is done; see status")
        fed = self._idle.copy()
        for name, value in (("command", command), ("reference", reference), (RATE, rate)):
            if value is None:
                continue
            refuse(name not in self._inputs, ParameterError, name, "given", f"one of the inputs of the loop: Loop(..., inputs=({name!r},))")
            wanted = f"{'one number' if name == RATE else f'{self._n_axis} numbers'}, finite{' and >= 0' if name == RATE else ''}"
            with refused(name, value, wanted):
                given = np.asarray(value, dtype=float)
            good = given.shape == (() if name == RATE else (self._n_axis,)) and bool(np.isfinite(given).all())
            refuse(not good or (name == RATE and given < 0.0), ParameterError, name, str(value), wanted)
            fed[self._inputs[name]] = given
        held, saved = fed[None] if n == 1 else np.broadcast_to(fed, (int(n), fed.size)), self._group.snapshot()
        log = self._group.run(held, self._rows)[:, :, 0]
        if self._watch[0, 0] >= 0.0:
            self.status = watched(self._group, self.machine)
        elif not self._group.finite().all():
            self.status = first_non_finite(self._group, saved, held, self.tick)
        count = min(len(log), int(np.searchsorted(log[:, self._places[PLANNED_TIME]], planned_end(self.reference))) + 1)
        if not self.status.ok and self.status.sample < self.tick + count:
            count = self.status.sample + 1 - self.tick
        else:
            self.status = Status(ok=True)
        self._past, self.tick = (self._past, log[:count]), self.tick + count
        return self.status

    def snapshot(self) -> Any:
        """Return all that the loop is and has done, for `restore`; it stays valid whatever the loop does."""
        return self._group, self.tick, self.status, self._past, self._group.snapshot()

    def restore(self, saved: Any) -> None:
        """Go back to a snapshot of this loop.

        Raises
        ------
        ParameterError
            If it is not one; that of another loop has the parameters of its machine.
        """
        own = isinstance(saved, tuple) and saved[0] is self._group
        refuse(not own, ParameterError, "saved", "another thing, or of another loop", "a snapshot of this loop")
        _, self.tick, self.status, self._past, (self._group.tick, memory) = saved
        self._group.memory[:] = memory

    def _logs(self) -> Iterator[Array]:
        past = self._past
        while past is not None:
            past, log = past
            yield log

    def result(self, scheme: str = "base") -> Result:
        """Return the signals of all ticks so far, as of `simulate`; judge it with its `motion`.

        Raises
        ------
        ParameterError
            Before the first step.
        """
        refuse(self._past is None, ParameterError, "result", "none", "asked for after the first step")
        log = np.concatenate([*self._logs()][::-1])
        kept = {name: log[:, place] for name, place in self._places.items()}
        kept["tool_position"] = ToolPosition(self.machine, self.seed).of(kept["axis_position"], kept["axis_velocity"])
        motion = followed(self.reference, kept) if self._varies else self.reference
        result = result_of(self.machine, motion, kept, self.status, scheme=scheme, seed=self.seed)
        return replace(result, made_by=(self.machine, self.controller))

    def __repr__(self) -> str:
        inputs = ", ".join(self._inputs) or "none"
        return facts_line("Loop", {"machine": self.machine.name, "tick": self.tick, "inputs": inputs, "done": self.done})
