"""Which models there are: a name, what it is in words, and the file that has it. A new model is a new file and a line here."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields
from importlib import import_module

from contourlab.errors import ParameterError
from contourlab.features.identify.finding import Finding
from contourlab.features.identify.requests.request import Request

_HERE = "contourlab.features.identify.requests"


@dataclass(frozen=True)
class Model:
    """A model: the module that has its `study`, what it is in words, and which options are its own, by their names in a request."""

    module: str
    words: str
    options: tuple[str, ...] = ()


_RIGID = ("cutoff", "slowest", "decimation", "validation")
MODELS = {
    "rigid": Model("rigid", "mass, viscous and Coulomb friction, offset, by inverse dynamics", _RIGID),
    "rigid-by-direction": Model("rigid", "the same with friction of its own each way", _RIGID),
    "friction": Model("friction", "friction curve from stretches of constant speed"),
    "stiction": Model("stiction", "breakaway each way from slow ramps of the command"),
    "first-order": Model("first_order", "gain a and damping b, friction and delay, from steps or random commands"),
    "closed-loop": Model("closed_loop", "a' and b' behind a disturbance observer", ("position_gain", "velocity_gain")),
    "frequency-response": Model("frequency", "position over command from sines, a chirp, noise or a multisine"),
    "linear-motor": Model("frequency", "mass, damping and delay fitted to the frequency response"),
    "two-inertia": Model("frequency", "motor, load and shaft fitted to the frequency response", ("motor_inertia", "side")),
}
"""By name, in the order in which they are told."""


def study_of(request: Request) -> Callable[[Request], Finding]:
    """Return the study of the model that is asked for.

    Raises
    ------
    ParameterError
        If there is no such model, or an option is another model's.
    """
    if request.model not in MODELS:
        raise ParameterError("--model", repr(request.model), f"one of {', '.join(MODELS)}")
    model = MODELS[request.model]
    for each in fields(Request):
        owners = [name for name, other in MODELS.items() if each.name in other.options]
        value = getattr(request, each.name)
        if owners and each.name not in model.options and value != each.default:
            option = f"--{each.name.replace('_', '-')}"
            raise ParameterError(option, value, f"left out: it is for {', '.join(owners)}, and the model is {request.model}")
    study: Callable[[Request], Finding] = import_module(f"{_HERE}.{model.module}").study
    return study
