"""A machine's files and a log of its excitation, simulated without LinuxCNC."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from linuxcnc_rig import Rig
from made_circles import behind

from contourlab.features.commission import identification
from contourlab.features.commission.command import planned_commands
from contourlab.features.commission.excitation import excitation
from contourlab.features.commission.loop import GAINS, AxisModel, Law, run_lanes
from contourlab.features.commission.setup import Setup, read_setup

PERIOD = 1e-3
MODELS = {
    "x": AxisModel(gain=3.0, damping=18.0, friction=0.035, offset=0.004, delay=0.0),
    "y": AxisModel(gain=1.2, damping=45.0, friction=0.012, delay=1.3e-3),
}
PLAY = {"x": 14e-6, "y": 33e-6}
NOISE = 2e-7
COLUMNS = ("time [s]", "x_cmd [mm]", "y_cmd [mm]", "x [mm]", "y [mm]", "x_load [mm]", "y_load [mm]", "x_out", "y_out")


@dataclass(frozen=True)
class Made:
    """Files of a machine, what they say, its excitation, and the columns of its log."""

    ini: Path
    hal: Path
    setup: Setup
    program: Path
    rows: dict[str, np.ndarray]

    def log(self, file: Path, rows: dict[str, np.ndarray] | None = None) -> Path:
        """Write the log, or changed rows of it."""
        rows = rows or self.rows
        np.savetxt(file, np.column_stack(list(rows.values())), fmt="%.6f", delimiter=",", header=",".join(rows), comments="")
        return file


def simulated(
    setup: Setup,
    program: Path,
    gains: dict[str, dict[str, float]] | None = None,
    factor: float = 1.0,
    noise: float | np.ndarray = NOISE,
    axes: str = "xy",
    delay: float | None = None,
) -> dict[str, np.ndarray]:
    """Return the columns of a log of a program: with other gains or axes, with noise uniform up to a number or as given, in some axes."""
    rows: dict[str, np.ndarray] = {}
    commands = planned_commands(program, setup)
    n = commands["x"].size
    rows["time [s]"] = PERIOD * np.arange(n)
    for axis in (axis for axis in setup.axes if axis.name in axes):
        values = axis.gains if gains is None else gains[axis.name]
        row = np.array([[values[name] / setup.unit for name in GAINS]])
        model = MODELS[axis.name]
        model = replace(model, gain=factor * model.gain, delay=model.delay if delay is None else delay)
        drawn = noise if isinstance(noise, np.ndarray) else np.random.default_rng(ord(axis.name)).uniform(-noise, noise, n)
        run = run_lanes(commands[axis.name], drawn, row, [model], Law(PERIOD), trace=True)
        a = axis.name
        rows |= {f"{a}_cmd [mm]": 1e3 * commands[a], f"{a} [mm]": 1e3 * run.position, f"{a}_out": run.command_output}
        rows[f"{a}_load [mm]"] = 1e3 * behind(run.position, PLAY[a])
    return {name: rows[name] for name in COLUMNS if name in rows}


def made(folder: Path) -> Made:
    """Write INI and HAL, and simulate the excitation."""
    ini, hal = Rig().write(folder)
    setup = read_setup(ini, hal)
    program = folder / "excite.ngc"
    program.write_text(excitation(setup))
    return Made(ini, hal, setup, program, simulated(setup, program))


def fitted_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fit a motor once: its model does not depend on what a log shows of the load."""
    fit, fits = identification._refined, dict[bytes, object]()

    def once(logs, *more, **options):  # type: ignore[no-untyped-def]
        key = b"".join(values.tobytes() for log in logs for values in (log.output, log.measured))
        if key not in fits:
            fits[key] = fit(logs, *more, **options)
        return fits[key]

    monkeypatch.setattr(identification, "_refined", once)
