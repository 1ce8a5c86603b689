"""Strict models of the fixed tables in scenario, machine and controller files, and their error messages."""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar, Literal, TypeVar

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field, ValidationError

from contourlab.errors import ScenarioError, UnitError, hint
from contourlab.feed.limits import RANGES
from contourlab.loop.machine import AXIS_SLOTS
from contourlab.program import Reading
from contourlab.scenario.quantities import read_list, read_number, show_bound
from contourlab.scenario.tree import Leaf, Table
from contourlab.scenario.values import checked_judge


def _number(
    unit: str, display: str = "", *, minimum: float = -math.inf, maximum: float = math.inf, exclusive: bool = False
) -> BeforeValidator:
    """Return the reader of a quantity; bounds in SI."""

    def read(value: Any) -> float:
        try:
            number = read_number(value, unit, display)
        except UnitError as error:
            raise ValueError(str(error)) from error
        if number < minimum or number > maximum or (exclusive and number == minimum):
            raise ValueError(f"{value!r} is out of range: must be {show_bound(minimum, maximum, exclusive, display or unit)}")
        return number

    return BeforeValidator(read)


def _limit(name: str, unit: str, display: str = "") -> BeforeValidator:
    """Return the reader of an axis limit that planning accepts."""
    low, high = RANGES[name]
    return _number(unit, display, minimum=low, maximum=high)


def _numbers(unit: str, display: str, *, or_one: bool = False) -> BeforeValidator:
    def read(value: Any) -> float | tuple[float, ...]:
        try:
            return (read_number if or_one and isinstance(value, str | int | float) else read_list)(value, unit, display)
        except UnitError as error:
            raise ValueError(str(error)) from error

    return BeforeValidator(read)


Period = Annotated[float, _number("s", "ms", minimum=0.0, maximum=1.0, exclusive=True)]
Moment = Annotated[float, _number("s", minimum=0.0, exclusive=True)]
Velocity = Annotated[float, _number("m/s", "mm/min", minimum=0.0, exclusive=True)]
Distance = Annotated[float, _number("m", "um", minimum=0.0, maximum=1.0, exclusive=True)]
Spread = Annotated[float, _number("m", "um", minimum=0.0)]
Mass = Annotated[float, _number("kg", minimum=0.0)]
Cosine = Annotated[float, _number("", minimum=-1.0, maximum=1.0)]
Angle = Annotated[float, _number("rad", "deg", minimum=0.0, maximum=math.pi, exclusive=True)]
Frequency = Annotated[float, _number("Hz", minimum=0.0, exclusive=True)]
Ratio = Annotated[float, _number("", minimum=0.0, exclusive=True)]
Part = Annotated[float, _number("", minimum=0.0, maximum=1.0)]
Override = Annotated[float, _number("", minimum=0.0, maximum=2.0, exclusive=True)]
Name = Annotated[str, Field(pattern=r"^[A-Za-z0-9_]{1,32}$")]
Text = Annotated[str, Field(min_length=1, max_length=200)]
Letter = Literal["x", "y", "z"]


class StrictTable(BaseModel):
    """A table of fixed shape: unknown keys and values of another type are faults."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)
    needed: ClassVar[tuple[str, ...]] = ()
    """Required keys that are read elsewhere."""
    parts: ClassVar[tuple[str, ...]] = ()
    """Optional keys that are read elsewhere."""


class ScenarioTable(StrictTable):
    """The top of a scenario."""

    needed = ("machine", "controller")
    parts = ("axes", "contour", "program", "feed", "run", "learning", "schemes")
    name: Text | None = None


class MachineTable(StrictTable):
    """``[machine]``."""

    parts = ("squareness", "correlations")
    name: Text
    servo_period: Period
    axes: Annotated[list[Name], Field(min_length=1, max_length=64)]


class LimitsTable(StrictTable):
    """``[axes.x.limits]``."""

    velocity: Annotated[float | None, _limit("velocity", "m/s", "mm/min")] = None
    acceleration: Annotated[float | None, _limit("acceleration", "m/s^2")] = None
    jerk: Annotated[float | None, _limit("jerk", "m/s^3")] = None
    following_error: Distance | None = None
    travel: Annotated[float | tuple[float, ...] | None, _numbers("m", "mm", or_one=True)] = None


class ErrorTable(StrictTable):
    """``[axes.x.error]``."""

    position: Annotated[tuple[float, ...], _numbers("m", "mm")] = ()
    lead_error: Annotated[tuple[float, ...], _numbers("m", "um")] = ()
    repeatability: Spread = 0.0


class AxisTable(StrictTable):
    """``[axes.x]``."""

    needed = AXIS_SLOTS[:1]
    parts = (*AXIS_SLOTS[1:], "limits", "error", "correlations")
    mounted_on: Name | Literal[""] = ""
    alignment: Cosine = 0.0
    stage_mass: Mass = 0.0
    substeps: Annotated[int, Field(ge=1, le=1000)] = 1


class ControllerTable(StrictTable):
    """``[controller]``."""

    needed = ("axes",)
    parts = ("estimator", "coupling")


class AxisControllerTable(StrictTable):
    """``[controller.axes.x]``."""

    needed = ("controller",)
    parts = ("velocity", "observer", "gap_observer", "predictor", "feedforward", "compensation", "supervisor", "others", "filters", "link")
    feedback: Literal["load", "motor"] = "load"
    velocity_feedback: Literal["load", "motor"] = "motor"
    local: list[str] = []


class LinkTable(StrictTable):
    """``[controller.axes.x.link]``."""

    parts = ("down", "up")
    division: Literal["drive", "observer", "controller"]


class ZeroPhaseTable(StrictTable):
    """``feedforward = {kind = "zpetc"}`` without coefficients, which are designed for the loop."""

    kind: str
    radius: Annotated[float, _number("", minimum=0.0, maximum=1.0, exclusive=True)] = 0.9


class ProgramTable(StrictTable):
    """``[program]``."""

    file: Annotated[str, Field(min_length=1)]
    letters: Annotated[list[Letter], Field(min_length=1, max_length=3)] | None = None
    require_end: bool = True
    dialect: Literal["linuxcnc", "grbl"] = "linuxcnc"
    block_delete: bool = False
    tools: Annotated[str, Field(min_length=1)] | None = None
    most_moves: Annotated[int, Field(ge=1)] = Reading.most_moves
    fit: bool = False


class ContourFileTable(StrictTable):
    """``[contour]`` with ``file``."""

    file: Annotated[str, Field(min_length=1)]
    unit: Text | None = None
    tolerance: Distance | None = None
    layer: Text | None = None
    chain: Annotated[int, Field(ge=1)] | None = None
    scale: Ratio = 1.0
    axes: Literal[2, 3] | None = None
    ignore: list[Text] = []
    corner_angle: Angle | None = None
    reverse: bool = False
    offset: Annotated[tuple[float, ...], _numbers("m", "mm")] = ()


class FeedTable(StrictTable):
    """``[feed]``."""

    law: Literal["planned", "uniform"] = "planned"
    feedrate: Velocity | None = None
    frequency: Frequency | None = None
    laps: Annotated[int, Field(ge=1, le=100_000)] = 1
    override: Override = 1.0
    path_control: Literal["program", "exact_path", "exact_stop", "blend"] = "program"
    corner_tolerance: Distance | None = None
    merge_tolerance: Spread | None = None
    curvature_step: Part = 1.0


class RunTable(StrictTable):
    """``[run]``."""

    signals: list[str] | None = None
    seed: Annotated[int, Field(ge=0, lt=2**63)] = 0
    tolerance: Distance | None = None
    judge: Annotated[str, AfterValidator(checked_judge)] = "cutting"
    start: Literal["rest", "moving"] = "rest"
    changes: list[Any] = []


class ChangeTable(StrictTable):
    """An item of ``changes`` in ``[run]``."""

    at: Moment
    controller: Annotated[str, Field(min_length=1)]
    handover_time: Annotated[float, _number("s", "ms", minimum=0.0)] = 0.01


class LearningTable(StrictTable):
    """``[learning]``."""

    needed = ("law",)
    trials: Annotated[int, Field(ge=1, le=100_000)] = 30
    improvement: Part = 0.01
    patience: Annotated[int, Field(ge=2, le=100_000)] = 10
    table: Annotated[str, Field(min_length=1)] | None = None


Model = TypeVar("Model", bound=StrictTable)


def read_table(model: type[Model], table: Table) -> Model:
    """Check a table against its model.

    Raises
    ------
    ScenarioError
        At the first fault; missing keys are listed together.
    """
    elsewhere = (*model.needed, *model.parts)
    missing = [name for name in model.needed if name not in table.entries]
    try:
        values = model.model_validate(table.without(*elsewhere).plain())
    except ValidationError as error:
        raise _explained([*elsewhere, *model.model_fields], table, error, missing) from None
    if missing:
        raise _missing(table, missing)
    return values


def _missing(table: Table, names: list[str]) -> ScenarioError:
    return table.error(f"{len(names)} {'key is' if len(names) == 1 else 'keys are'} missing: {', '.join(names)}")


def _explained(known: list[str], table: Table, error: ValidationError, missing: list[str]) -> ScenarioError:
    faults = error.errors(include_url=False, include_context=False)
    # An unknown key is often a misspelt missing one: name it first.
    faults.sort(key=lambda fault: fault["type"] != "extra_forbidden")
    name = str(faults[0]["loc"][0]) if faults[0]["loc"] else ""
    if faults[0]["type"] == "extra_forbidden":
        return table.error(f"unknown key: {hint(name, known)}", name)
    missing = [*missing, *(str(fault["loc"][0]) for fault in faults if fault["type"] == "missing")]
    if missing:
        return _missing(table, missing)
    node, kind, message = table.get(name), faults[0]["type"], faults[0]["msg"]
    if kind == "value_error":
        return table.error(message.removeprefix("Value error, "), name)
    given = repr(node.value)[:80] if isinstance(node, Leaf) else "this table"
    return table.error(f"{given}: {_CURES.get(kind, message[:1].lower() + message[1:])}", name)


_CURES = {
    "string_type": "write text in quotes",
    "int_type": "write a whole number",
    "bool_type": "write true or false",
    "list_type": 'write a list such as ["x", "y"]',
    "string_pattern_mismatch": "write a name of letters, digits and _",
    "string_too_short": "must not be empty",
    "too_short": "must not be empty",
}
