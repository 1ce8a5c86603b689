"""Scenarios: TOML files to typed values and back, strictly.

Modules: `tree` (raw content with the place of each value), `files` (included files), `quantities` (values with units), `tables` (the fields
of a class as a table), `provenance` (sources and correlations), `build` (machines and controllers), `values` (settings, cases, schemes),
`load` (motion, scenario; entry points), `dump` and `toml_text` (writers).
"""

from contourlab.scenario.dump import dump, save
from contourlab.scenario.files import BUILTIN, builtin_file, builtin_names, shipped_hint
from contourlab.scenario.load import load_axis, load_controller, load_machine, load_scenario, parse_scenario, scenario_from_parts
from contourlab.scenario.values import Case, PartProgram, Scenario, chosen

__all__ = [
    "BUILTIN",
    "Case",
    "PartProgram",
    "Scenario",
    "builtin_file",
    "builtin_names",
    "chosen",
    "dump",
    "load_axis",
    "load_controller",
    "load_machine",
    "load_scenario",
    "parse_scenario",
    "save",
    "scenario_from_parts",
    "shipped_hint",
]
