"""Request for an identification: model, logs and options as typed; and the table of models."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from pathlib import Path

from contourlab.analysis.identification.inverse_dynamics import InverseDynamicsSettings
from contourlab.errors import ParameterError, UnitError
from contourlab.features.identify.frequency import (
    EXCITATIONS,
    identify_linear_motor,
    identify_response,
    identify_two_inertia,
    identify_two_mass,
)
from contourlab.features.identify.friction import identify_friction, identify_stiction
from contourlab.features.identify.records import AxisRecord, axis_pieces, longest_piece, newtons_per, samples_digest
from contourlab.features.identify.result import Identified, join_names
from contourlab.features.identify.rigid import MODELS as RIGID
from contourlab.features.identify.rigid import identify_behind_observer, identify_open_loop, identify_rigid
from contourlab.features.measure.log_choice import LogChoice, distinct_names, open_log, positive
from contourlab.findings import Finding, finding
from contourlab.logs import Log
from contourlab.logs.load import about
from contourlab.units import split, to_si


@dataclass(frozen=True)
class Request:
    """An identification as typed.

    Attributes
    ----------
    model : str
        A name in `MODELS`.
    choices : tuple of LogChoice
        One or several logs, read with the same options.
    gain : str or None
        Force per command, as ``"35.15 N/V"``.
    full_scale : str or None
        Full scale of the command, as ``"10 V"``.
    slowest : str or None
        Speed below which samples are dropped, as ``"1 mm/s"``.
    validation : str, Path or None
        A second log.
    position_gain, velocity_gain : str or None
        Gains of the recorded loop, as ``"4 full_scale/mm"``.
    lead : str or None
        Travel per turn, as ``"10 mm"``: for two inertias, and for a command in newton metres.
    motor_inertia : str or None
        Inertia of motor and screw, as ``"2 kg*cm^2"``.
    side : str
        Where the position is measured, ``"motor"`` or ``"load"``.
    excitation : str
        ``"reference"`` or ``"command"``, for a frequency response.
    """

    model: str
    choices: tuple[LogChoice, ...]
    axis: str | None = None
    gain: str | None = None
    full_scale: str | None = None
    cutoff: str = "100 Hz"
    decimation: int = 10
    slowest: str | None = None
    validation: str | Path | None = None
    position_gain: str | None = None
    velocity_gain: str | None = None
    lead: str | None = None
    motor_inertia: str | None = None
    side: str = "motor"
    excitation: str = EXCITATIONS[0]
    _on_logs: list[tuple[Finding, list[str]]] = field(default_factory=list)
    _doubts: list[Finding] = field(default_factory=list)

    @property
    def inputs(self) -> tuple[str | Path, ...]:
        """The files to read."""
        second = () if self.validation is None else (self.validation,)
        return (*(file for choice in self.choices for file in choice.files), *second)

    def identify(self) -> Identified:
        """Run the study of the model.

        Raises
        ------
        ResultError, LogError, ParameterError
            From the study; with the names of the logs.
        """
        study = self._model().study
        with about(*self._names.values(), options=[option.name for option in fields(self)]):
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
        for option in fields(self):
            owners = [name for name, model in MODELS.items() if option.name in model.options]
            value = getattr(self, option.name)
            if owners and option.name not in own and value != option.default:
                typed = f"--{option.name.replace('_', '-')}"
                raise ParameterError(typed, value, f"omitted: it applies to {', '.join(owners)}, and the model is {self.model}")

    def records(self, *, pieces: bool = False) -> list[AxisRecord]:
        """Return the signals of the axis in all logs: the longest stretch of each, or with `pieces` all stretches between long gaps."""
        if self.gain is not None and self.full_scale is not None:
            raise ParameterError("--full-scale", f"{self.full_scale} with --gain", "one of the two: newtons, or shares of full scale")
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
            raise ParameterError("LOG", f"{len(self.choices)} logs", f"one: model {self.model} takes a single run")
        return self.records()[0]

    def second(self) -> AxisRecord | None:
        """Return the signals of the axis in the log for validation, if given."""
        if self.validation is None:
            return None
        return self._read(replace(self.choices[0], file=self.validation))[0]

    def travel(self) -> float | None:
        """Return the travel per turn [m], or None."""
        return None if self.lead is None else positive("--lead", self.lead, "m", 'travel per turn, such as "10 mm"')

    def _model(self) -> Model:
        if self.model not in MODELS:
            raise ParameterError("--model", repr(self.model), f"one of {', '.join(MODELS)}")
        return MODELS[self.model]

    @cached_property
    def _names(self) -> dict[Path, str]:
        """The names of the logs by file."""
        files = [choice.file for choice in self.choices] + ([] if self.validation is None else [self.validation])
        return dict(zip(map(Path, files), distinct_names(files), strict=True))

    def _reading(self) -> list[Finding]:
        """Return the findings on reading the logs; a finding that holds for some logs only names them."""
        count = len(self.choices) + (self.validation is not None)
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
        gain = None if self.gain is None else _per_command("--gain", self.gain, "N", 'a force per command, such as "35.15 N/V"')
        records = axis_pieces(log, name, self.axis, gain, self._full_scale(), self.travel())
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
        if self.lead is None or self.model == "two-inertia" or (record.logged, record.unit) == ("N*m", "N"):
            return
        if record.unit == "full_scale" and self.full_scale is not None:
            raise ParameterError("--lead", f"{self.lead} with --full-scale", "one of the two: newtons, or shares of full scale")
        seen = f"the command of {record.source} is in {record.unit}" if record.unit else f"{record.source} has no command"
        raise ParameterError("--lead", self.lead, f"omitted, or used with a command in N*m, for model {self.model}: {seen}")

    def _full_scale(self) -> float | None:
        if self.full_scale is None:
            return None
        try:
            number, unit = split(self.full_scale)
            value = number * to_si(f"1 {unit}", unit)
        except UnitError as error:
            raise ParameterError("--full-scale", repr(self.full_scale), 'a command, such as "10 V"') from error
        if not 0.0 < value < 1e12:
            raise ParameterError("--full-scale", self.full_scale, "> 0")
        return value

    def _check_unit(self, log: Log) -> None:
        """Raise if the unit of gain or full scale does not match the command in the log."""
        logged = next((log.result.signals[name].unit for name in ("command", "torque") if name in log.result), "")
        for option, text in (("--gain", self.gain), ("--full-scale", self.full_scale)):
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
    friction = next(friction for friction, model in RIGID.items() if model == request.model)
    cutoff = positive("--cutoff", request.cutoff, "Hz", 'a frequency, such as "100 Hz"')
    slowest = 0.0 if request.slowest is None else positive("--slowest", request.slowest, "m/s", 'a speed, such as "1 mm/s"')
    if request.full_scale is not None:
        raise ParameterError("--full-scale", request.full_scale, f"omitted: model {request.model} needs forces, see --gain")
    if len(request.choices) > 1:
        raise ParameterError("LOG", f"{len(request.choices)} logs", f"one: model {request.model} takes one run, and one with --validation")
    # Settings are named like their options, so that an error can name the option.
    settings = InverseDynamicsSettings(friction, cutoff=cutoff, decimation=request.decimation, slowest=slowest)
    return identify_rigid(request.record(), settings, request.second())


def _closed_loop(request: Request) -> Identified:
    return identify_behind_observer(request.record(), _loop_gains(request))


def _loop_gains(request: Request) -> tuple[float, float, str] | None:
    """Return K_P and K_V in SI, and the unit of the command, taken from K_P."""
    position, velocity = request.position_gain, request.velocity_gain
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
    lead, inertia = request.travel(), None
    if request.motor_inertia is not None:
        inertia = positive("--motor-inertia", request.motor_inertia, "kg*m^2", 'of motor and screw, such as "2 kg*cm^2"')
    return identify_two_inertia(request.records(), request.side, lead, inertia, request.excitation)


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
        lambda request: identify_response(request.records(), request.excitation),
        "position over command from sines, a chirp, noise or a multisine",
        ("excitation",),
    ),
    "linear-motor": Model(
        lambda request: identify_linear_motor(request.records(), request.excitation),
        "mass, damping and delay fitted to the frequency response",
        ("excitation",),
    ),
    "two-mass": Model(
        lambda request: identify_two_mass(request.records(), request.side, request.excitation),
        "mass and one structural resonance fitted to the frequency response",
        ("side", "excitation"),
    ),
    "two-inertia": Model(_two_inertia, "motor, load and shaft fitted to the frequency response", ("motor_inertia", "side", "excitation")),
}
"""Models by name, in the order of the messages."""
