"""Components with one fault each."""

from __future__ import annotations

import random
import time
from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param, text_param
from contourlab.components.coupling.laws import ModifiedReference
from contourlab.components.drive.saturation import Saturation
from contourlab.components.friction.laws import Coulomb, SmoothCoulomb
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.plant import MassDamper
from contourlab.engine.step import Port
from contourlab.primitives import lookup


class Amplifier(Component):
    """A drive that passes its command on: sound, and the pattern of the faulty ones."""

    family = "drive"
    kind = "sound"
    inputs = (Port("command"),)
    outputs = (Port("applied"),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (inp.command,)


class Shaped(Amplifier):
    """Closes over itself for a structural parameter: sound."""

    kind = "shaped"
    example = {"gain": 3.0, "bias": 1.0}
    gain: float = param(default=1.0, minimum=0.0, maximum=1e6, structural=True, doc="gain")
    bias: float = param(default=0.0, minimum=0.0, maximum=1e6, doc="offset")

    def step_function(self) -> Any:
        def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
            return (), (self.gain * inp.command + par.bias,)

        return step


class Enclosed(Amplifier):
    """Closes over itself for a parameter that may differ between variants."""

    kind = "enclosed"
    example = {"gain": 3.0}
    gain: float = param(default=1.0, minimum=0.0, maximum=1e6, doc="gain")

    def step_function(self) -> Any:
        def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
            return (), (self.gain * inp.command,)

        return step


class Worded(Amplifier):
    """Takes a structural parameter by name: sound."""

    kind = "worded"
    example = {"gain": 3.0, "sense": "back"}
    gain: float = param(default=1.0, minimum=0.0, maximum=1e6, doc="gain")
    sense: str = text_param(default="forth", choices=("forth", "back"), doc="sign")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, sense: str) -> Any:
        return (), (par.gain * inp.command if sense == "forth" else -par.gain * inp.command,)


class Named(Enclosed):
    """Takes a parameter by name that may differ between variants."""

    kind = "named"
    step_function = Component.step_function

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, gain: float) -> Any:
        return (), (gain * inp.command,)


class Nameless(Amplifier):
    """Takes by name what it does not have."""

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, shape: str) -> Any:
        return (), (inp.command,)


class WallClock(Amplifier):
    """Reads the time of day."""

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (inp.command + time.perf_counter(),)


class Dice(Amplifier):
    """Draws from a generator that keeps a state."""

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (inp.command + random.random(),)


class Loaded(Amplifier):
    """Draws a derived constant."""

    derived = ("gain",)

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (random.random(),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (par.gain * inp.command,)


CALLS = [0]


class Tired(Loaded):
    """Has a derived constant that depends on how often it was computed."""

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        CALLS[0] += 1
        return (1.0 if CALLS[0] % 5 else 0.5,)


class Branching(Loaded):
    """Derives with a function that takes no arrays, which it gets in a batch."""

    example = {"rate": 2.0}
    rate: float = param(minimum=0.0, doc="r")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (max(par.rate, 1.0),)


class Summed(Amplifier):
    """Uses `sum`, which rounds each term or none, as the version of Python says."""

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (sum((inp.command, 0.0)),)


MEMORY = [0.0]


class Hoarder(Amplifier):
    """Remembers outside its states, and forgets at tick 0, so that two whole runs agree."""

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        MEMORY[0] = inp.command if clock.k == 0.0 else MEMORY[0] + inp.command
        return (), (MEMORY[0],)


class Scribbler(Amplifier):
    """Writes into its table."""

    tables = ("scratch",)

    def table_values(self) -> dict[str, Any]:
        return {"scratch": np.array([1.0, 2.0])}

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        par.scratch[0] = lookup(par.scratch, 0.0) + 1.0
        return (), (inp.command * lookup(par.scratch, 0.0),)


class Reassigner(Amplifier):
    """Writes into its parameters."""

    example = {"gain": 2.0}
    gain: float = param(minimum=0.0, doc="g")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        par.gain = 3.0
        return (), (par.gain * inp.command,)


class Counter(Amplifier):
    """Takes its parameter for an int; parameters are floats, also where they were given as ints."""

    example = {"stages": 3}
    stages: int = param(minimum=0.0, whole=True, doc="n")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        out = inp.command
        for _ in range(par.stages):
            out = 0.5 * out
        return (), (out,)


class Idle(Amplifier):
    """Has a parameter that does nothing."""

    example = {"gain": 2.0, "trim": 1.0}
    gain: float = param(minimum=0.0, doc="g")
    trim: float = param(minimum=0.0, doc="t")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (par.gain * inp.command,)


class IdleWord(Amplifier):
    """Has a word that does nothing."""

    rule: str = text_param("left", ("left", "right"), doc="r")


class NotANumber(Amplifier):
    """Gives inf - inf."""

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        huge = (1.0 + inp.command * inp.command) * 1e308 * 10.0
        return (), (huge - huge,)


class Overflowing(Amplifier):
    """Gives infinity."""

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), ((1.0 + inp.command * inp.command) * 1e308 * 10.0,)


class RottenInside(Amplifier):
    """Keeps a NaN in a state that no output shows."""

    states = (Port("hidden"),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        huge = (1.0 + inp.command * inp.command) * 1e308 * 10.0
        return (huge - huge,), (inp.command,)


class Divider(Amplifier):
    """Divides by zero."""

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (1.0 / (inp.command - inp.command),)


class Misspelt(Amplifier):
    """Names what does not exist."""

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (nonsense(inp.command),)  # type: ignore[name-defined]  # noqa: F821


class Talkative(Amplifier):
    """Returns more than it declares."""

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (inp.command, 1.0)


class Forgetful(Amplifier):
    """Declares a state and returns none."""

    states = (Port("last"),)


class HalfVector(ModifiedReference):
    """Returns one number for a vector of two: the other would stay as it was."""

    kind = "half-vector"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), ((par.weight * inp.reference[0],),)


class WideInteger(Amplifier):
    """Counts with integers that fit a Python int but no machine word."""

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (float(int(1e6 * inp.command) ** 5 % 1000),)


class Uncompilable(Amplifier):
    """Formats text, which plain Python can and machine code cannot."""

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (float(f"{inp.command:.12f}"),)


class WrongInput(Amplifier):
    """Has an input that a drive's slot does not offer."""

    inputs = (Port("comand"),)


class WrongOutput(Amplifier):
    """Lacks the output that a drive's slot needs."""

    outputs = (Port("current"),)


class Deaf(Amplifier):
    """Lacks the input that the slot wires to it."""

    inputs = ()


class Boundless(Amplifier):
    """Has a parameter without bounds and does not declare that as intended."""

    example = {"gain": 1.0}
    gain: float = param(doc="g")


class Undocumented(Amplifier):
    """Has a parameter without a description."""

    example = {"gain": 1.0}
    gain: float = param(minimum=0.0, doc="")


class Mute(Amplifier):
    __doc__ = None


class BadDefault(Amplifier):
    """Has a default outside its own range."""

    gain: float = param(default=-1.0, minimum=0.0, doc="g")


class ExampleText(Amplifier):
    """An example that is no mapping."""

    kind = "example-text"
    example = "gain = 2"  # type: ignore[assignment]


class ReferenceTuple(Amplifier):
    """A comma too many behind its source."""

    kind = "reference-tuple"
    reference = ("a paper",)  # type: ignore[assignment]


class BadExample(Amplifier):
    """Has an example outside its own range."""

    example = {"gain": -1.0}
    gain: float = param(minimum=0.0, doc="g")


class NoExample(Amplifier):
    """Has a required parameter, and an example without it."""

    gain: float = param(minimum=0.0, doc="g")


class ForgottenDerived(Amplifier):
    """Names a derived constant and computes none."""

    derived = ("half",)


class Lawless(SmoothCoulomb):
    """A friction of a law that no plant can integrate."""

    kind = "lawless"
    law = "magic"


class Clash(SmoothCoulomb):
    """A friction with a parameter name that the plant of the check also has."""

    kind = "clash"
    example = {**SmoothCoulomb.example, "mass": 1.0}
    mass: float = param(minimum=0.0, doc="m")


class LyingGain(Saturation):
    """Has a gain of two in its linear model."""

    kind = "lying-gain"

    def linearize(self) -> LinearModel:
        return LinearModel(np.zeros((0, 0)), np.zeros((0, 1)), np.zeros((1, 0)), 2.0 * np.ones((1, 1)), ("command",), ("applied",))


class LyingName(Saturation):
    """Names a port in its linear model that it does not have."""

    kind = "lying-name"

    def linearize(self) -> LinearModel:
        return LinearModel(np.zeros((0, 0)), np.zeros((0, 1)), np.zeros((1, 0)), np.ones((1, 1)), ("current",), ("applied",))


class LyingType(Saturation):
    """Has a number for a linear model."""

    kind = "lying-type"

    def linearize(self) -> LinearModel:
        return 1.0  # type: ignore[return-value]


class LyingShape(Saturation):
    """Has matrices in its linear model that do not fit each other."""

    kind = "lying-shape"

    def linearize(self) -> LinearModel:
        return LinearModel(np.zeros((0, 0)), np.zeros((0, 2)), np.zeros((1, 0)), np.ones((1, 1)), ("command",), ("applied",))


class LyingPole(MassDamper):
    """Has 1 % less damping in its linear model."""

    kind = "lying-pole"

    def linearize(self) -> LinearModel:
        return MassDamper(**{**self.values(), "damping": 0.99 * self.damping}).linearize()


class LyingSign(DisturbanceObserver):
    """Has the wrong sign for the command in its linear model."""

    kind = "lying-sign"

    def linearize(self) -> LinearModel:
        true = super().linearize()
        return LinearModel(true.a, true.b * np.array([1.0, -1.0]), true.c, true.d, true.inputs, true.outputs)


class Pusher(SmoothCoulomb):
    """Pushes where it should resist."""

    kind = "pusher"

    @staticmethod
    def force(par: Any, v: float) -> float:
        return -par.viscous * v  # type: ignore[no-any-return]


class Puller(Coulomb):
    """Pulls the axis on once it is fast."""

    kind = "puller"

    @staticmethod
    def sliding(par: Any, speed: float) -> float:
        return par.coulomb - par.viscous * speed  # type: ignore[no-any-return]
