"""The scenario that a command is given: a file, the folder of a machine, or a part program with machine and controller."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from contourlab.errors import ProgramEndError, ScenarioError
from contourlab.features.check.reading import refuse_drawing
from contourlab.file_kinds import mistaken

if TYPE_CHECKING:
    from contourlab.scenario import Scenario


def scenario_of(
    file: str | Path,
    *,
    machine: str | Path | None = None,
    controller: str | Path | None = None,
    tolerance: str | None = None,
    program: Mapping[str, Any] | None = None,
    plugins: Sequence[str | Path] = (),
) -> Scenario:
    """Read a scenario, or make one from a part program.

    Parameters
    ----------
    file : str or Path
        ``.toml``: a scenario; a folder: its ``scenario.toml``; anything else is a part program.
    machine, controller : str or Path, optional
        Files, or names of shipped ones; a part program needs both. The folder of a machine stands for its two files. A scenario then runs
        under this controller, without its schemes.
    tolerance : str, optional
        Largest part error of a part program that passes, as ``"25 um"``.
    program : mapping, optional
        Further keys of the table ``program``, as ``{"fit": True}``.
    plugins : sequence of str or Path
        Python files with components.

    Raises
    ------
    ScenarioError, ProgramError
        If the content is invalid, or an option does not fit the file.
    """
    from contourlab.scenario import BUILTIN, load_scenario, scenario_from_parts, shipped_hint

    path, keys = Path(file), program or {}
    if (str(file).startswith(BUILTIN) and path.suffix != ".ngc") or path.suffix.lower() == ".toml" or path.is_dir():
        try:
            scenario = load_scenario(file, plugins=plugins)
        except ProgramEndError as error:
            error.add_note("To run it to its last line: write require_end = false under [program] in the scenario.")
            raise
        _refuse_options(path, {"--machine": machine, "--tolerance": tolerance}, keys)
        return scenario if controller is None else _under(scenario, controller, plugins)
    refuse_drawing(path, machine, controller)
    if machine is not None and Path(machine).is_dir():
        controller = machine if controller is None else controller
    if not path.exists():
        raise ScenarioError(f"no such file{shipped_hint(path)}", file=path)
    if words := mistaken(path, "a part program"):
        raise ScenarioError(words, file=path)
    if machine is None or controller is None:
        alone = "" if machine is None else f"; {machine} is not a folder, which would give both"
        raise ScenarioError(f"a part program needs --machine and --controller{alone}; a scenario ends in .toml", file=path)
    run = {} if tolerance is None else {"tolerance": tolerance}
    try:
        return scenario_from_parts(path, machine, controller, run=run, options=keys, plugins=plugins)
    except ProgramEndError as error:
        error.add_note("To run it to its last line: add --no-require-end.")
        raise


def _under(scenario: Scenario, controller: str | Path, plugins: Sequence[str | Path]) -> Scenario:
    """Return the scenario under another controller, without its schemes."""
    from contourlab.scenario import BUILTIN, builtin_file, load_controller
    from contourlab.scenario.load import named_file

    name = named_file(controller, "controller")
    file = builtin_file(name) if name.startswith(BUILTIN) else Path(name)
    base = replace(scenario.base, controller=load_controller(file, scenario.machine, plugins))
    return replace(scenario, base=base, all_cases=(), files=(*scenario.files, file))


def _refuse_options(path: Path, parts: Mapping[str, Any], program: Mapping[str, Any]) -> None:
    """Refuse the options of part programs beside a scenario; name the key to write there."""
    keys = {option: "tolerance under [run]" if option == "--tolerance" else option.removeprefix("--") for option in parts}
    for name, value in program.items():
        setting = f" = {str(value).lower()}" if isinstance(value, bool) else ""
        keys[_option(name, value)] = f"{name}{setting} under [program]"
    for option, value in {**parts, **of_program(program)}.items():
        if value is not None:
            raise ScenarioError(f"{option} is for part programs: write {keys[option]} in the scenario", file=path)


def of_program(keys: Mapping[str, Any]) -> dict[str, Any]:
    """Return keys of the table ``program`` as command-line options, with their values."""
    return {_option(name, value): value for name, value in keys.items()}


def _option(name: str, value: Any) -> str:
    return f"--{'no-' if value is False else ''}{name.replace('_', '-')}"


def loaded(file: str | Path, schemes: Sequence[str], plugins: Sequence[str | Path]) -> Scenario:
    """Read a scenario with the schemes asked for, or with its own.

    Raises
    ------
    ScenarioError
        If the file is not a scenario, or has no such scheme.
    """
    from contourlab.scenario import BUILTIN, chosen, load_scenario, shipped_hint

    if not (str(file).startswith(BUILTIN) or Path(file).suffix.lower() == ".toml" or Path(file).is_dir()):
        if not Path(file).exists():
            raise ScenarioError(f"no such file{shipped_hint(file)}", file=file)
        raise ScenarioError(mistaken(file, "a scenario") or "not a scenario: its name must end in .toml", file=file)
    scenario = load_scenario(file, plugins=plugins)
    return chosen(scenario, schemes) if schemes else scenario
