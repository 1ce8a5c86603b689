"""Request for an identification: model, logs and options as typed; and the table of models."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

from contourlab.analysis.identification.inverse_dynamics import InverseDynamicsSettings
from contourlab.errors import ParameterError, UnitError
from contourlab.features.identify.frequency import (
    identify_linear_motor,
    identify_response,
    identify_two_inertia,
    identify_two_mass,
)
from contourlab.features.identify.friction import identify_friction, identify_stiction
from contourlab.features.identify.options import Identify
from contourlab.features.identify.records import AxisRecord, axis_pieces, longest_piece, newtons_per, samples_digest
from contourlab.features.identify.result import Identified, join_names
from contourlab.features.identify.rigid import MODELS as RIGID
from contourlab.features.identify.rigid import identify_behind_observer, identify_open_loop, identify_rigid
from contourlab.features.measure.log_choice import LogChoice, distinct_names, open_log
from contourlab.findings import Finding, finding
from contourlab.logs import Log
from contourlab.logs.load import about
from contourlab.units import split, to_si


@dataclass(frozen=True)
class Request:
    """An identification.

    Attributes
    ----------
    options : Identify
    choices : tuple of LogChoice
        One or several logs, read with the same options.
    """

    options: Identify
    choices: tuple[LogChoice, ...]
    _on_logs: list[tuple[Finding, list[str]]] = field(default_factory=list)
    _doubts: list[Finding] = field(default_factory=list)

    @property
    def inputs(self) -> tuple[str | Path, ...]:
        """The files to read."""
        second = () if self.options.validation is None else (self.options.validation,)
        return (*(file for choice in self.choices for file in choice.files), *second)

    def identify(self) -> Identified:
        """Run the study of the model.

        Raises
        ------
        ResultError, LogError, ParameterError
            From the study; with the names of the logs.
        """
        study = self._model().study
        with about(*self._names.values(), options=list(Identify.PARTS)):
            identified = study(self)
        return replace(identified, findings=(*identified.findings, *self._doubts, *self._reading()))

    def check(self) -> None:
        """Check model and options.

        Raises
        ------
        ParameterError
            If the model is unknown, or an option belongs to other models.
        """
        own = self._model().options
        for name, part in Identify.PARTS.items():
            owners = [owner for owner, model in MODELS.items() if name in model.options]
            value = getattr(self.options, name)
            if owners and name not in own and value != part.default:
                raise ParameterError(
                    part.typed, value, f"omitted: it applies to {', '.join(owners)}, and the model is {self.options.model}"
                )

    def records(self, *, pieces: bool = False) -> list[AxisRecord]:
        """Return the signals of the axis in all logs: the longest stretch of each, or with `pieces` all stretches between long gaps."""
        if self.options.gain is not None and self.options.full_scale is not None:
            raise ParameterError(
                "--full-scale", f"{self.options.full_scale} with --gain", "one of the two: newtons, or shares of full scale"
            )
        self._check_once()
        logs = [self._read(choice, pieces) for choice in self.choices]
        by_samples: dict[str, str] = {}
        for records in logs:
            first = by_samples.setdefault(samples_digest(records), records[0].source)
            if first != records[0].source:
                self._doubts.append(finding("CL500", records[0].source, other=first))
        return [record for records in logs for record in records]

    def record(self) -> AxisRecord:
        """Return the signals of the axis in the only log.

        Raises
        ------
        ParameterError
            If there are several logs.
        """
        if len(self.choices) > 1:
            raise ParameterError("LOG", f"{len(self.choices)} logs", f"one: model {self.options.model} takes a single run")
        return self.records()[0]

    def second(self) -> AxisRecord | None:
        """Return the signals of the axis in the log for validation, if given."""
        if self.options.validation is None:
            return None
        return self._read(replace(self.choices[0], file=self.options.validation))[0]

    def travel(self) -> float | None:
        """Return the travel per turn [m], or None."""
        travel: float | None = self.options.si("lead")
        return travel

    def _model(self) -> Model:
        if self.options.model not in MODELS:
            raise ParameterError("--model", repr(self.options.model), f"one of {', '.join(MODELS)}")
        return MODELS[self.options.model]

    @cached_property
    def _names(self) -> dict[Path, str]:
        """The names of the logs by file."""
        files = [choice.file for choice in self.choices] + ([] if self.options.validation is None else [self.options.validation])
        return dict(zip(map(Path, files), distinct_names(files), strict=True))

    def _reading(self) -> list[Finding]:
        """Return the findings on reading the logs; a finding that holds for some logs only names them."""
        count = len(self.choices) + (self.options.validation is not None)
        places = ("" if len(names) == count else join_names(names) for _, names in self._on_logs)
        return [replace(one, place=": ".join(filter(None, (at, one.place)))) for (one, _), at in zip(self._on_logs, places, strict=True)]

    def _check_once(self) -> None:
        """Raise if a log is given twice, also by different paths."""
        seen: dict[Path, str | Path] = {}
        for choice in self.choices:
            place = Path(choice.file).resolve()
            if place in seen:
                same = "" if Path(seen[place]) == Path(choice.file) else f", the same file as {seen[place]}"
                raise ParameterError("LOG", f"{choice.file}{same}", "given once: its samples would count twice")
            seen[place] = choice.file

    def _read(self, choice: LogChoice, pieces: bool = False) -> list[AxisRecord]:
        log = open_log(choice)
        self._check_unit(log)
        name = self._names[Path(choice.file)]
        gain = self.options.gain
        force = None if gain is None else _per_command("--gain", gain, "N", 'a force per command, such as "35.15 N/V"')
        records = axis_pieces(log, name, self.options.axis, force, self._full_scale(), self.travel())
        self._check_lead(records[0])
        if not pieces:
            records = [longest_piece(log, records)]
        for on_reading in log.findings:
            names = next((names for other, names in self._on_logs if other == on_reading), None)
            if names is None:
                self._on_logs.append((on_reading, names := []))
            names.append(name)
        for doubt in (doubt for record in records for doubt in record.doubts()):
            if doubt not in self._doubts:
                self._doubts.append(doubt)
        return records

    def _check_lead(self, record: AxisRecord) -> None:
        """Raise if a travel per turn is given but not needed."""
        if self.options.lead is None or self.options.model == "two-inertia" or (record.logged, record.unit) == ("N*m", "N"):
            return
        if record.unit == "full_scale" and self.options.full_scale is not None:
            raise ParameterError("--lead", f"{self.options.lead} with --full-scale", "one of the two: newtons, or shares of full scale")
        seen = f"the command of {record.source} is in {record.unit}" if record.unit else f"{record.source} has no command"
        raise ParameterError("--lead", self.options.lead, f"omitted, or used with a command in N*m, for model {self.options.model}: {seen}")

    def _full_scale(self) -> float | None:
        if self.options.full_scale is None:
            return None
        try:
            number, unit = split(self.options.full_scale)
            value = number * to_si(f"1 {unit}", unit)
        except UnitError as error:
            raise ParameterError("--full-scale", repr(self.options.full_scale), 'a command, such as "10 V"') from error
        if not 0.0 < value < 1e12:
            raise ParameterError("--full-scale", self.options.full_scale, "> 0")
        return value

    def _check_unit(self, log: Log) -> None:
        """Raise if the unit of gain or full scale does not match the command in the log."""
        logged = next((log.result.signals[name].unit for name in ("command", "torque") if name in log.result), "")
        for option, text in (("--gain", self.options.gain), ("--full-scale", self.options.full_scale)):
            if text is None or not logged:
                continue
            try:
                unit = split(text)[1]
                to_si(f"1 {(unit.partition('/')[2] if option == '--gain' else unit).strip()}", logged)
            except UnitError as error:
                wanted = f'per {logged}, as "35 {newtons_per(logged)}"' if option == "--gain" else f'in {logged}, as "10 {logged}"'
                raise ParameterError(option, text, f"{wanted}: the command of {log.record.file.name} is in {logged}") from error


def _per_command(option: str, text: str, top: str, wanted: str) -> float:
    """Read a quantity per command, as ``"35.15 N/V"``, in SI; `top` is the unit of the numerator, `wanted` the expected form."""
    try:
        number, unit = split(text)
        above, _, below = unit.partition("/")
        value = number * to_si(f"1 {above.strip()}", top) / to_si(f"1 {below.strip()}", below.strip())
    except UnitError as error:
        raise ParameterError(option, repr(text), wanted) from error
    if not 0.0 < abs(value) < 1e12:
        raise ParameterError(option, text, "other than 0, and below 1e12 in magnitude")
    return value


# --- models --------------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Model:
    """A model: its study, a description, and the options that only it has, by their names in a request."""

    study: Callable[[Request], Identified]
    description: str
    options: tuple[str, ...] = ()


def _rigid(request: Request) -> Identified:
    friction = next(friction for friction, model in RIGID.items() if model == request.options.model)
    cutoff, slowest = request.options.si("cutoff"), request.options.si("slowest") or 0.0
    if request.options.full_scale is not None:
        raise ParameterError("--full-scale", request.options.full_scale, f"omitted: model {request.options.model} needs forces, see --gain")
    if len(request.choices) > 1:
        raise ParameterError(
            "LOG", f"{len(request.choices)} logs", f"one: model {request.options.model} takes one run, and one with --validation"
        )
    # Settings are named like their options, so that an error can name the option.
    settings = InverseDynamicsSettings(friction, cutoff=cutoff, decimation=request.options.decimation, slowest=slowest)
    return identify_rigid(request.record(), settings, request.second())


def _closed_loop(request: Request) -> Identified:
    return identify_behind_observer(request.record(), _loop_gains(request))


def _loop_gains(request: Request) -> tuple[float, float, str] | None:
    """Return K_P and K_V in SI, and the unit of the command, taken from K_P."""
    position, velocity = request.options.position_gain, request.options.velocity_gain
    if position is None and velocity is None:
        return None
    if position is None or velocity is None:
        option = "--position-gain" if position is None else "--velocity-gain"
        raise ParameterError(option, "missing", "given with the other one: eq 18 needs both K_P and K_V")
    option, text, wanted = "--position-gain", position, 'command per length, such as "4 full_scale/mm"'
    try:
        unit = split(position)[1].partition("/")[0].strip()
        proportional = to_si(position, f"{unit}/m")
        option, text, wanted = "--velocity-gain", velocity, f'command per speed, such as "0.1 {unit}*s/mm"'
        damping = to_si(velocity, f"{unit}*s/m")
    except UnitError as error:
        raise ParameterError(option, repr(text), wanted) from error
    return proportional, damping, unit


def _two_inertia(request: Request) -> Identified:
    lead, inertia = request.travel(), request.options.si("motor_inertia")
    return identify_two_inertia(request.records(), request.options.side, lead, inertia, request.options.excitation)


_OF_RIGID = ("cutoff", "slowest", "decimation", "validation")
MODELS = {
    "rigid": Model(_rigid, "mass, viscous and Coulomb friction, offset, by inverse dynamics", _OF_RIGID),
    "rigid-by-direction": Model(_rigid, "like rigid, with separate friction for each direction", _OF_RIGID),
    "friction": Model(lambda request: identify_friction(request.records(pieces=True)), "friction curve from stretches of constant speed"),
    "stiction": Model(lambda request: identify_stiction(request.records(pieces=True)), "breakaway each way from slow ramps of the command"),
    "first-order": Model(
        lambda request: identify_open_loop(request.record()),
        "gain a and damping b, friction and delay, from steps or random commands",
    ),
    "closed-loop": Model(_closed_loop, "a' and b' behind a disturbance observer", ("position_gain", "velocity_gain")),
    "frequency-response": Model(
        lambda request: identify_response(request.records(), request.options.excitation),
        "position over command from sines, a chirp, noise or a multisine",
        ("excitation",),
    ),
    "linear-motor": Model(
        lambda request: identify_linear_motor(request.records(), request.options.excitation),
        "mass, damping and delay fitted to the frequency response",
        ("excitation",),
    ),
    "two-mass": Model(
        lambda request: identify_two_mass(request.records(), request.options.side, request.options.excitation),
        "mass and one structural resonance fitted to the frequency response",
        ("side", "excitation"),
    ),
    "two-inertia": Model(_two_inertia, "motor, load and shaft fitted to the frequency response", ("motor_inertia", "side", "excitation")),
}
"""Models by name, in the order of the messages."""
