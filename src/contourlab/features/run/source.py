"""What a question is asked about: a scenario, the folder of a machine, or a part program on a machine, as a file or read; or objects."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeAlias

from contourlab.app.shared_options import Motion
from contourlab.contours import ContourReading
from contourlab.errors import ParameterError, ProgramEndError, ScenarioError
from contourlab.features.check.reading import of_control, refuse_drawing
from contourlab.features.run.changes import changed, changed_keys, check_changed
from contourlab.feed import Reference
from contourlab.file_kinds import mistaken
from contourlab.loop import Controller, Machine
from contourlab.result.stamp import tell
from contourlab.scenario import (
    BUILTIN,
    Case,
    Scenario,
    builtin_file,
    chosen,
    load_controller,
    load_scenario,
    scenario_from_parts,
    shipped_hint,
)
from contourlab.scenario.load import named_file
from contourlab.scenario.values import Contour, FeedSettings, RunSettings

Source: TypeAlias = "str | Path | Scenario | Case | Machine | Controller | Reference"
"""A scenario or part program, as a file or read; or a machine, its controller and the reference, one after the other."""


@dataclass(frozen=True, eq=False, repr=False)
class GivenCase(Case):
    """A machine under a controller along a reference that is already planned."""

    given: Reference | None = None

    def reference(self, feed_scale: float = 1.0) -> Reference:
        """Return the reference."""
        assert self.given is not None
        return self.given


def scenario_asked(inputs: Sequence[Source], settings: Any) -> Scenario:
    """Return the scenario that a question is asked about.

    Parameters
    ----------
    inputs : sequence
        See `Source`.
    settings : Options
        Those of `contourlab.app.shared_options.Motion` or `Schemes`; options that the class lacks have no effect.

    Raises
    ------
    ScenarioError, ProgramError, ParameterError
        If the file cannot be read, or an option does not fit it.
    """
    if not all(isinstance(each, str | Path) for each in inputs):
        if getattr(settings, "machine", None) is not None:
            raise ParameterError("machine", repr(settings.machine), "left out where no file is asked about")
        if keys := changed_keys(getattr(settings, "set", ())):
            raise ParameterError("set", repr(keys), "parameters of machine and controller where no file is asked about")
    match inputs:
        case [str() | Path() as file]:
            scenario = scenario_of(file, settings)
        case [Scenario() as scenario]:
            scenario = _as_asked(scenario, settings)
        case [Case() as case]:
            scenario = _as_asked(Scenario(case.name, Path(), case), settings)
        case [Machine() as machine, Controller() as controller, Reference() as reference]:
            motion = Contour("reference", axes=machine.axis_names)
            vars(motion)["reading"] = ContourReading(reference.path)  # that of a name would be drawn
            limit = settings.si("tolerance") if isinstance(settings, Motion) else None
            made = GivenCase("base", machine, controller, motion, FeedSettings("uniform"), RunSettings(limit), given=reference)
            scenario = _as_asked(Scenario(machine.name, Path(), made), replace(settings, tolerance=None) if limit else settings)
        case _:
            kinds = ", ".join(type(each).__name__ for each in inputs)
            raise ParameterError("inputs", kinds or "none", "a scenario or part program; or a machine, its controller and a reference")
    return tell(changed(scenario, getattr(settings, "set", ())).judging(getattr(settings, "judge", None)))


def case_asked(inputs: Sequence[Source], settings: Any) -> tuple[Scenario, Case]:
    """Return the scenario that a question is asked about, and its case: that of the option ``scheme``, or its base."""
    scenario = scenario_asked(inputs, settings)
    case = scenario.base if not settings.scheme else scenario.case(settings.scheme)
    check_changed([case], getattr(settings, "set", ()))
    return scenario, case


def is_scenario(file: str | Path) -> bool:
    """Return whether the name of a file is that of a scenario or a folder, not that of a part program."""
    path = Path(file)
    return (str(file).startswith(BUILTIN) and path.suffix != ".ngc") or path.suffix.lower() == ".toml" or path.is_dir()


def scenario_of(file: str | Path, settings: Any) -> Scenario:
    """Read a scenario, or make one from a part program where the options have a program's.

    Parameters
    ----------
    file : str or Path
        ``.toml``: a scenario; a folder: its ``scenario.toml``; anything else is a part program.
    settings : Options
        See `scenario_asked`. A part program needs ``machine`` and ``controller``; the folder of a machine stands for both. A scenario runs
        on the machine that is given, and under the controller that is given, then without its schemes.

    Raises
    ------
    ScenarioError, ProgramError
        If the content is invalid, or an option does not fit the file.
    """
    path, of_program = Path(file), isinstance(settings, Motion)
    planner = getattr(settings, "planner", None)
    changes = changed_keys((*getattr(settings, "set", ()), *([f"feed.planner={planner}"] if planner else ())))
    if is_scenario(file):
        try:
            scenario = load_scenario(file, settings.plugin, getattr(settings, "machine", None), changes=changes)
        except ProgramEndError as error:
            error.add_note("To run it to its last line: write require_end = false under [program] in the scenario.")
            raise
        return _as_asked(scenario, settings)
    machine, controller = (getattr(settings, name, None) for name in ("machine", "controller"))
    if of_program:
        refuse_drawing(path, machine, controller)
    if not path.exists():
        raise ScenarioError(f"no such file{shipped_hint(file)}", file=file)
    if not of_program:
        raise ScenarioError(mistaken(file, "a scenario") or "not a scenario: its name must end in .toml", file=file)
    if words := mistaken(path, "a part program"):
        raise ScenarioError(words, file=path)
    if machine is not None and controller is None and Path(machine).is_dir():
        controller = machine
    if machine is not None and controller is None and Path(machine).suffix and not Path(machine).exists():
        raise ScenarioError("no such file", file=machine)
    if machine is None or (controller is None and not of_control(machine)):
        alone = "" if machine is None else f"; {machine} is neither a folder nor a control's own file, which would give both"
        raise ScenarioError(f"a part program needs --machine and --controller{alone}; a scenario ends in .toml", file=path)
    run = {} if settings.tolerance is None else {"tolerance": settings.tolerance}
    try:
        given: dict[str, Any] = {"run": run, "options": settings.program, "changes": changes, "plugins": settings.plugin}
        return scenario_from_parts(path, machine, controller, **given)
    except ProgramEndError as error:
        error.add_note("To run it to its last line: add --no-require-end.")
        raise


def _as_asked(scenario: Scenario, settings: Any) -> Scenario:
    """Return the schemes that are asked for, or the scenario under another controller; refuse options of part programs."""
    if isinstance(settings, Motion):
        _refuse_options(scenario.file, settings)
        return scenario if settings.controller is None else _under(scenario, settings)
    schemes = getattr(settings, "schemes", ())
    return chosen(scenario, schemes) if schemes else scenario


def _under(scenario: Scenario, settings: Any) -> Scenario:
    """Return the scenario under another controller, without its schemes."""
    name = named_file(settings.controller, "controller")
    file = builtin_file(name) if name.startswith(BUILTIN) else Path(name)
    base = replace(scenario.base, controller=load_controller(file, scenario.machine, settings.plugin))
    return replace(scenario, base=base, all_cases=(), files=(*scenario.files, file))


def _refuse_options(path: Path, settings: Any) -> None:
    """Refuse the options of part programs beside a scenario; name the key to write there."""
    keys = {"--tolerance": (settings.tolerance, "tolerance under [run]")}
    for name, value in settings.program.items():
        setting = f" = {str(value).lower()}" if isinstance(value, bool) else ""
        keys[f"--{'no-' if value is False else ''}{name.replace('_', '-')}"] = value, f"{name}{setting} under [program]"
    for option, (value, key) in keys.items():
        if value is not None:
            raise ScenarioError(f"{option} is for part programs: write {key} in the scenario", file=path if path.name else "<scenario>")
