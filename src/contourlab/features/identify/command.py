"""``contourlab identify``: the model of an axis from measured logs; and the table of models."""

from __future__ import annotations

from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path

import numpy as np

from contourlab.app.session import QUIET, Session, question
from contourlab.errors import ParameterError, refuse
from contourlab.features.identify.options import Identify
from contourlab.features.identify.records import AxisRecord, Request
from contourlab.features.identify.result import Identification
from contourlab.logs.load import Log, about


@dataclass(frozen=True)
class Model:
    """A model.

    Attributes
    ----------
    study : str
        Module beside this one and its function, from records of the axis to the model; the last record is that for validation, if given.
        It is imported where it is used: one of them simulates.
    options : tuple of str
        Options that not all models have.
    single : str
        How many logs it takes, if not any number.
    pieces : bool
        Whether it takes all stretches of a log between long gaps, not only the longest.
    together : bool
        Whether it takes several axes of a log at once.
    """

    study: str
    options: tuple[str, ...] = ()
    single: str = ""
    pieces: bool = False
    together: bool = False


_RIGID = Model("rigid:identify_rigid", ("cutoff", "slowest", "decimation", "validation"), "one run, and one with --validation")
POSITION_LOOP = "position-loop"
MODELS = {
    "rigid": _RIGID,
    "rigid-by-direction": _RIGID,
    "friction": Model("friction:identify_friction", pieces=True),
    "stiction": Model("friction:identify_stiction", pieces=True),
    "first-order": Model("rigid:identify_open_loop", single="a single run"),
    "closed-loop": Model("rigid:identify_behind_observer", ("position_gain", "velocity_gain"), "a single run"),
    "frequency-response": Model("frequency:identify_response", ("excitation",)),
    "linear-motor": Model("frequency:identify_linear_motor", ("excitation",)),
    "two-mass": Model("frequency:identify_two_mass", ("side", "excitation")),
    "two-inertia": Model("frequency:identify_two_inertia", ("motor_inertia", "side", "excitation")),
    "resonance": Model("frequency:identify_ringing", single="a single run"),
    POSITION_LOOP: Model("position_loop:identify_position_loop", ("validation",), "one run, and one with --validation", together=True),
}
"""Models by name, in the order of the messages."""


@question(Identify)
def identify(*logs: str | Path | Log, settings: Identify, session: Session = QUIET) -> Identification:
    """Identify a model of an axis from logs.

    Parameters
    ----------
    *logs : str, Path or Log
        Logs of runs that excite the axis.

    Returns
    -------
    Identification

    Raises
    ------
    LogError, ResultError
        If a log cannot be read or lacks a signal, or the axis cannot be identified; names the log.
    ParameterError
        If an option is out of range.
    """
    request = Request(settings, logs)
    inputs = settings.files(*request.files)
    session.will_write(inputs, pictures_only=True)
    opened = None
    if logs and settings.model in (None, POSITION_LOOP):
        with about(*request.names.values(), options=list(Identify.PARTS)):
            opened = request.log(0)
        logs = (opened, *logs[1:])  # read once
        settings = replace(settings, model=settings.model or _usual_model(opened, settings))
    name = settings.model or "rigid"
    refuse(name not in MODELS, ParameterError, "--model", repr(name), f"one of {', '.join(MODELS)}")
    model = MODELS[name]
    for option, part in Identify.PARTS.items():
        owners = [owner for owner, other in MODELS.items() if option in other.options]
        value = getattr(settings, option)
        if owners and option not in model.options and value != part.default:
            raise ParameterError(part.typed, value, f"omitted: it applies to {', '.join(owners)}, and the model is {name}")
    with about(*request.names.values(), options=list(Identify.PARTS)):
        refuse(model.single and len(logs) > 1, ParameterError, "LOG", f"{len(logs)} logs", f"one: model {name} takes {model.single}")
        axes = axes_of(opened, settings.axis) if model.together and opened is not None else [settings.axis]
        requests = [Request(replace(settings, axis=axis), logs) for axis in axes]
        records: list[AxisRecord] = []
        for one in requests:
            records += one.records(model.pieces)
            records += one.read() if settings.validation is not None else []
        module, _, function = model.study.partition(":")
        identified: Identification = getattr(import_module(f"contourlab.features.identify.{module}"), function)(records, settings)
    on_logs = {str(doubt): doubt for one in requests for doubt in one.findings()}
    return replace(identified, findings=(*identified.findings, *on_logs.values()), inputs=inputs)


def _usual_model(log: Log, options: Identify) -> str:
    """Return the model where none is named.

    A position loop for a log without force and command, if no option speaks of them; a resonance for accelerations alone.
    """
    if not {"position", "reference", "velocity"} & log.result.signals.keys() and "acceleration" in log.result:
        return "resonance"
    of_others = {option for model in MODELS.values() for option in model.options} - {*MODELS[POSITION_LOOP].options}
    typed = {name for name, part in Identify.PARTS.items() if getattr(options, name) != part.default}
    driven = any(log.result.signals[name].unit != "m" for name in ("command", "force", "torque") if name in log.result)
    return "rigid" if driven or "reference" not in log.result or typed & {*of_others, "gain", "full_scale", "lead"} else POSITION_LOOP


def axes_of(log: Log, asked: str | None) -> list[str]:
    """Return the axes that are asked for, or all whose reference moves."""
    if asked is not None:
        return list(dict.fromkeys(axis.strip() for axis in asked.split(",")))
    references = {axis: log.signal(axis, "reference") for axis in log.result.axes}
    return [axis for axis, values in references.items() if values is not None and np.ptp(values) > 0.0] or list(references)
