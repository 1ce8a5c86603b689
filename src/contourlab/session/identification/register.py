"""Which models there are: a name, what it is in words, and the file that has it. A new model is a new file and a line here."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module

from contourlab.errors import ParameterError
from contourlab.session.identification.request import Request
from contourlab.studies.identification.finding import Finding

__all__ = ["MODELS", "Model", "study_of"]

_HERE = "contourlab.session.identification"


@dataclass(frozen=True)
class Model:
    """A model: the module that has its `study`, and what it is in words."""

    module: str
    words: str


MODELS = {
    "rigid": Model("rigid", "mass, viscous and Coulomb friction, offset, by inverse dynamics"),
    "rigid-by-direction": Model("rigid", "the same with friction of its own each way"),
    "friction": Model("friction", "friction curve from stretches of constant speed"),
    "stiction": Model("stiction", "breakaway each way from slow ramps of the command"),
    "first-order": Model("first_order", "gain a and damping b, friction and delay, from steps or random commands"),
    "closed-loop": Model("closed_loop", "a' and b' behind a disturbance observer"),
    "frequency-response": Model("frequency", "position over command from sines, a chirp, noise or a multisine"),
    "linear-motor": Model("frequency", "mass, damping and delay fitted to the frequency response"),
    "two-inertia": Model("frequency", "motor, load and shaft fitted to the frequency response"),
}
"""By name, in the order in which they are told."""


def study_of(name: str) -> Callable[[Request], Finding]:
    """Return the study of a model.

    Raises
    ------
    ParameterError
        If there is no such model.
    """
    if name not in MODELS:
        raise ParameterError("--model", repr(name), f"one of {', '.join(MODELS)}")
    study: Callable[[Request], Finding] = import_module(f"{_HERE}.{MODELS[name].module}").study
    return study
