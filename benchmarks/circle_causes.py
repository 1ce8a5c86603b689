"""Does `contourlab circle` name the cause that a machine has?

    python benchmarks/circle_causes.py [--machines N] [--seed N] [--json FILE]

Simulates machines with one or two dominant errors on a circle in both senses, measures them with noise and counts, and compares the largest
cause reported with the one injected, and the estimates with their stated deviations. README.md explains the tables.
"""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

from contourlab.arrays import Array
from contourlab.components.registry import component
from contourlab.features.circle.command import Cause, causes_of
from contourlab.features.circle.fit import fit_circle
from contourlab.features.circle.runs import CircleRun, find_circle, runs_of
from contourlab.feed import Reference, uniform
from contourlab.geometry import Path as Contour
from contourlab.geometry import backwards, contour
from contourlab.loop import Axis, AxisController, AxisError, Controller, Limits, Machine, simulate

CAUSES = ("backlash", "reversal spikes", "servo mismatch", "squareness", "scaling mismatch", "cyclic error", "vibration")
RADIUS, TURNS, PERIOD = 0.05, 0.16, 1e-3
FEED = 2.0 * math.pi * RADIUS * TURNS
LEAD, TURN = 0.01, 2.0 * math.pi / 0.01
INERTIA, MASS = 2e-4, 40.0
KV, FORWARD = 25.0, 0.8
LIMITS = Limits(following_error=1.0)


@dataclass(frozen=True)
class Made:
    """A machine with its errors.

    Attributes
    ----------
    dominant : dict of str to (str, float)
        Axis, and size [m] in the circle, of each injected cause; of friction and vibration their torque [N m] until simulated.
    pitch, frequency : float [m, Hz]
        Of cyclic error and vibration.
    noise, count : float [m]
        Root mean square of the measuring noise, and the step of the counter.
    """

    dominant: Mapping[str, tuple[str, float]]
    pitch: float
    frequency: float
    noise: float
    count: float


def drawn(random: np.random.Generator) -> Made:
    """Draw a machine: one cause of 5 to 20 um, in half of the machines a second one of 30 to 80 % of its size."""
    names = random.choice(CAUSES, 2 if random.random() < 0.5 else 1, replace=False).tolist()
    first = random.uniform(5e-6, 20e-6)
    sizes = [first, first * random.uniform(0.3, 0.8)]
    dominant = {
        name: (str(random.choice(["x", "y"])), size * float(random.choice([-1.0, 1.0]))) for name, size in zip(names, sizes, strict=False)
    }
    return Made(dominant, random.uniform(4e-3, 12e-3), random.uniform(35.0, 90.0), random.uniform(0.05e-6, 0.3e-6), 0.1e-6)


def machine(made: Made, torques: Mapping[str, float]) -> tuple[Machine, Controller]:
    """Return two axes of motor, screw and table under a P-PI cascade on the motor's encoder, with the errors of a machine."""
    size = {name: value for name, (_, value) in made.dominant.items()}
    of = {name: axis for name, (axis, _) in made.dominant.items()}
    axes, loops = [], {}
    for name in ("x", "y"):
        gap = abs(size["backlash"]) if of.get("backlash") == name else 0.0
        plant = component("plant", "two-inertia")(
            motor_inertia=INERTIA, mass=MASS, lead=LEAD, stiffness=500.0, shaft_damping=0.02, load_damping=0.004, backlash_gap=gap
        )
        friction = component("friction", "coulomb")(
            coulomb=torques.get(f"reversal spikes {name}", 0.0), breakaway=torques.get(f"reversal spikes {name}", 0.0)
        )
        shake = component("disturbance", "sine")(amplitude=torques.get(f"vibration {name}", 0.0), frequency=made.frequency)
        position = np.linspace(-0.06, 0.06, 12001)
        error = np.zeros_like(position)
        if "scaling mismatch" in size:
            error += 0.5 * size["scaling mismatch"] / RADIUS * position * (1.0 if name == "x" else -1.0)
        if of.get("cyclic error") == name:
            error += 0.5 * size["cyclic error"] * np.cos(2.0 * math.pi * position / made.pitch)
        axes.append(
            Axis(name, plant, motor_friction=friction, disturbance=shake, error=AxisError(position, error), limits=LIMITS, substeps=6)
        )
        gain = KV
        if "servo mismatch" in size and name == "x":
            gain = 1.0 / (1.0 / KV + size["servo mismatch"] / FEED / (1.0 - FORWARD))
        cascade = component("controller", "cascade")
        total = INERTIA + MASS / TURN**2
        gains = cascade.tune(150.0, 0.9, 1.0 / total / TURN, 0.0, gain) | {"velocity_feedforward": FORWARD}
        velocity = component("velocity", "filtered-difference")(bandwidth=1500.0)
        loops[name] = AxisController(cascade(**gains), velocity=velocity, feedback="motor")
    square = {("x", "y"): size["squareness"] / RADIUS} if "squareness" in size else {}
    return Machine("made", tuple(axes), PERIOD, square), Controller(loops)


@cache
def references() -> tuple[Reference, Reference]:
    """Return two turns of the circle in each sense."""
    circle = contour("circle", radius=RADIUS)
    other = Contour([backwards(curve) for curve in reversed(circle.curves)], closed=True)
    return uniform(circle, TURNS, 2, PERIOD), uniform(other, TURNS, 2, PERIOD)


def tool(made: Made, torques: Mapping[str, float]) -> list[tuple[Array, Array]]:
    """Return command and tool position (n, 2) [m] of the second turn in each sense."""
    built, controller = machine(made, torques)
    pairs = []
    for reference in references():
        result = simulate(built, controller, reference)
        assert result.status.ok, result.status
        half = result.n_sample // 2
        pairs.append((result["reference"][half:], result["tool_position"][half:]))
    return pairs


def torques_of(made: Made) -> tuple[dict[str, float], dict[str, float]]:
    """Return the torques [N m] that give friction and vibration their sizes, and the sizes [m] that a noise-free run then shows."""
    torques, sizes = {}, {}
    for cause in ("reversal spikes", "vibration"):
        if cause not in made.dominant:
            continue
        axis, wanted = made.dominant[cause]
        alone = replace(made, dominant={})
        torque = 0.2
        for _ in range(2):  # friction is almost proportional
            calm, moved = tool(alone, {}), tool(alone, {f"{cause} {axis}": torque})
            size = np.mean([_size(cause, axis, ref, there - here) for (ref, here), (_, there) in zip(calm, moved, strict=True)])
            torque, last = torque * abs(wanted) / float(size), torque
        torques[f"{cause} {axis}"], sizes[cause] = last, float(size)
    return torques, sizes


def _size(cause: str, axis: str, reference: Array, change: Array) -> float:
    """Return the mean height of the spikes, or the peak to peak value of the vibration [m], from the change of the path."""
    angle = np.arctan2(reference[:, 1], reference[:, 0])
    radial = change[:, 0] * np.cos(angle) + change[:, 1] * np.sin(angle)
    if cause == "vibration":
        return float(np.ptp(change[:, "xy".index(axis)]))
    near = np.abs(np.sin(angle) if axis == "x" else np.cos(angle)) < math.sin(math.radians(15.0))
    side = (np.cos(angle) if axis == "x" else np.sin(angle)) > 0.0
    return float(np.mean([radial[near & side].max(), radial[near & ~side].max()]))


def measured(made: Made, torques: Mapping[str, float], seed: int) -> list[CircleRun]:
    """Return the runs of a machine as a grid encoder with noise and counts sees them."""
    random, runs = np.random.default_rng(seed), []
    for reference, position in tool(made, torques):
        seen = made.count * np.rint((position + made.noise * random.standard_normal(position.shape)) / made.count)
        circle = find_circle(reference)
        runs += runs_of("made", seen, PERIOD, replace(circle, radius=RADIUS), reference)
    return runs


def cases(count: int, seed: int) -> Iterator[dict[str, Any]]:
    """Yield for each machine what was injected and what was reported."""
    random = np.random.default_rng(seed)
    for k in range(count):
        made = drawn(random)
        torques, sizes = torques_of(made)
        causes = causes_of(fit_circle(measured(made, torques, seed + k), ("x", "y")))
        injected = {name: sizes.get(name, abs(value)) for name, (_, value) in made.dominant.items()}
        axis = {name: axis if name in ("backlash", "reversal spikes", "cyclic error") else "" for name, (axis, _) in made.dominant.items()}
        found = {name: next((c for c in causes if (c.cause, c.axis) == (name, axis[name])), None) for name in injected}
        yield {
            "injected": injected,
            "reported": [(c.cause, c.contribution, c.deviation) for c in causes],
            "found": {n: _row(c) for n, c in found.items()},
        }


def _row(cause: Cause | None) -> tuple[float, float] | None:
    if cause is None:
        return None
    # The amplitude is injected; what it adds depends on its phase along the circle.
    is_wave = cause.cause in ("cyclic error", "vibration")
    return (2.0 * cause.value, 2.0 * cause.value_deviation) if is_wave else (cause.contribution, cause.deviation)


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--machines", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", type=Path)
    options = parser.parse_args()
    rows = list(track(cases(options.machines, options.seed), total=options.machines, description="machines"))
    if options.json:
        options.json.parent.mkdir(parents=True, exist_ok=True)
        options.json.write_text(json.dumps(rows, indent=1), encoding="utf-8")
    show(rows, Console())


def show(rows: list[dict[str, Any]], console: Console) -> None:
    """Print the confusion matrix, and errors of the estimates."""
    columns = [*CAUSES, "lateral play"]
    matrix = Table("largest injected \\ reported", *columns)
    right = 0
    for name in CAUSES:
        of = [row for row in rows if max(row["injected"], key=row["injected"].get) == name]
        counts = [sum(row["reported"][0][0] == other for row in of) for other in columns]
        right += counts[columns.index(name)]
        matrix.add_row(name, *(str(n) if n else "." for n in counts))
    console.print(matrix)
    console.print(f"largest reported = largest injected: {right} of {len(rows)}")
    table = Table(
        "cause",
        "n",
        "found",
        "error rms [um]",
        "error rms [%]",
        "stated deviation, median [um]",
        "within 3 deviations",
        "within 3 deviations + 2 %",
    )
    for name in CAUSES:
        pairs = [(row["injected"][name], row["found"][name]) for row in rows if name in row["injected"]]
        seen = [(true, *got) for true, got in pairs if got is not None]
        if not seen:
            table.add_row(name, str(len(pairs)), "0", *["-"] * 5)
            continue
        true, value, deviation = np.array(seen).T
        error = np.abs(value - true)
        near, nearly = np.mean(error < 3.0 * deviation), np.mean(error < 3.0 * deviation + 0.02 * true)
        figures = [1e6 * np.sqrt(np.mean(error**2)), 100.0 * np.sqrt(np.mean((error / true) ** 2)), 1e6 * np.median(deviation)]
        table.add_row(
            name, str(len(pairs)), str(len(seen)), *(f"{figure:.2g}" for figure in figures), f"{100 * near:.0f} %", f"{100 * nearly:.0f} %"
        )
    console.print(table)


if __name__ == "__main__":
    main()
