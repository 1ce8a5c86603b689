"""How far loops as WebAssembly are from the native lanes, over random scenarios with all shipped plants and controllers, by cause.

    python benchmarks/portable.py [--scenarios N] [--seed N]

Each plant runs under position control with gains placed for it. Controllers run on the rigid axis; those of the contact and the gap zone
run on shafts with backlash, under a supervisor. Friction, sensor, coupling, contour and parameters (within 15 %) are drawn; a loop that
does not follow its contour is drawn again. The module runs in node; it rounds each product before it is added, the lanes do not. A
decision can turn on that last digit: a count of an encoder, an axis that sticks or slips, a contact or a switch between controllers.
Rows: which of these a scenario has, how many scenarios, and the largest difference of a position and of the largest part error. The
figures go to benchmarks/out/portable.json too. Takes some minutes.
"""

from __future__ import annotations

import argparse
import sys
from collections import defaultdict
from dataclasses import replace
from pathlib import Path
from typing import Any

import figures_file
import numpy as np

import contourlab as cl
from contourlab.engine.runner import CompiledGroup
from contourlab.errors import ContourlabError
from contourlab.loop import parameters_of
from contourlab.loop.portable import portable

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "helpers"))
from component_rig import make
from parts_in_loops import KINDS, loop_with
from wasm_host import in_node, log_of

PARTS = [kind for kind in KINDS if kind.family in ("plant", "controller")]
SHAPES = ("circle", "ellipse", "lemniscate", "butterfly")
RESISTANCE, FOLLOWS, TRIES = 0.06, 1e-2, 20
"""Deceleration by friction [m/s^2], largest contour error [m] of a loop that follows, and draws of a part before it is given up."""
Difference = tuple[float, float]


def friction(name: str, coulomb: float) -> Any:
    """Return friction of a size in the unit of a plant."""
    sizes = {"coulomb": coulomb, "breakaway": 1.3 * coulomb, "stribeck_velocity": 2e-3}
    more: dict[str, Any] = {
        "smooth-coulomb": {"smoothing_velocity": 1e-3},
        "lugre": {"stiffness": 2e5 * coulomb, "bristle_damping": 200.0 * coulomb},
    }
    return make("friction", name, **({} if name == "none" else sizes | more.get(name, {})))


def in_zones(kind: Any) -> tuple[cl.Machine, cl.Controller]:
    """Return the shipped machine with backlash, and its controllers of the zones with one of them exchanged for `kind`."""
    case = next(case for case in cl.load_scenario("builtin:backlash/part").cases() if case.name == "scheme III")

    def exchanged(part: Any) -> Any:
        if part.kind.split("-")[0] != kind.kind.split("-")[0]:
            return part
        own = {name: value for name, value in part.values().items() if name in kind.parameters}
        per_inertia = [name for name in own if kind.parameters[name].unit != part.parameters[name].unit]
        return kind(**own | {name: own[name] / own["motor_inertia"] for name in per_inertia})

    axes = {
        name: replace(axis, controller=exchanged(axis.controller), others=tuple((other, exchanged(part)) for other, part in axis.others))
        for name, axis in case.controller.axes.items()
    }
    return case.machine, replace(case.controller, axes=axes)


def loop_of(kind: Any, numbers: np.random.Generator) -> tuple[cl.Machine, cl.Controller, set[str]]:
    """Return a random loop with a part in each axis, and what in it decides on a last digit."""
    if "zone" in kind.kind:
        return *in_zones(kind), {"counts", "sticking", "contact or switching"}
    machine, controller = loop_with(kind)
    if machine.axes[0].plant.takes_position:
        return machine, controller, {"counts"}
    name, is_counted = str(numbers.choice(["none", "smooth-coulomb", "lugre", "coulomb"])), bool(numbers.integers(2))
    plant = machine.axes[0].plant
    parts = {
        "sensor": make("sensor", "encoder", resolution=125e-9, noise=5e-8) if is_counted else make("sensor", "ideal"),
        "friction": friction(name, RESISTANCE / plant.mobilities()[-1]),
    }
    if kind.family == "plant":
        own = type(controller.axes["x"].controller)
        placed = own(**own.place(55.0, 0.9, 15.0, *plant.rigid_model()))
        parts["drive"] = make("drive", "delayed-saturation", limit=50.0 / plant.rigid_model()[0], delay=1.5e-3)
        controller = replace(
            controller, axes={axis: replace(each, controller=placed, observer=None) for axis, each in controller.axes.items()}
        )
    axes = tuple(replace(axis, **parts, substeps=max(axis.substeps, 2 if name == "smooth-coulomb" else 1)) for axis in machine.axes)
    traits = {"counts": is_counted, "sticking": name == "coulomb", "contact or switching": plant.linear() != plant}
    controller = controller if numbers.integers(2) else cl.Controller(controller.axes)
    return replace(machine, axes=axes), controller, {trait for trait, has in traits.items() if has}


def is_whole(part: Any, name: str) -> bool:
    """Return whether a parameter is a whole number."""
    return bool(getattr(getattr(part, "parameters", {}).get(name), "whole", False))


def moved(machine: cl.Machine, controller: cl.Controller, numbers: np.random.Generator) -> tuple[cl.Machine, cl.Controller]:
    """Return a loop with half of its parameters moved by up to 15 %."""
    declared = parameters_of(machine, controller)
    ends = ("delay", "limit", "stream", "resolution", "pitch", "lead", "pulse", "profile_start", "profile_step")
    chosen = [name for name in declared if not name.endswith(ends) and not is_whole(*declared[name]) and numbers.random() < 0.5]
    values = {name: float(getattr(*declared[name])) * numbers.uniform(0.85, 1.15) for name in chosen}
    return cl.with_values(machine, controller, values)


def difference(machine: cl.Machine, controller: cl.Controller, shape: str, seed: int) -> Difference | None:
    """Return the largest differences of a position and of the largest part error [m]; None if the loop does not follow."""
    path = cl.contour("lissajous", axes=3) if len(machine.axes) == 3 else cl.contour(shape)
    loop = portable(machine, controller, cl.uniform(path, 0.5, 1, machine.servo_period), seed=seed)
    group = CompiledGroup(loop.schedule, 1, slice(0, 1), like_lanes=True)
    log = group.run(loop.fed().T, list(loop.rows))[:, :, 0]
    columns, (error,) = list(loop.signals["axis_position"]), loop.signals["part_error"]
    if not np.isfinite(log[:, columns]).all() or not np.abs(log[:, error]).max() < FOLLOWS:
        return None
    _, found = in_node(loop, ("run", 0, len(log)), log_of(loop))
    other = found.reshape(log.shape)
    sizes = [float(np.abs(one[:, error]).max()) for one in (log, other)]
    return float(np.abs(other - log)[:, columns].max()), abs(sizes[1] - sizes[0])


def main() -> int:
    """Print the rows, and write them to benchmarks/out/portable.json."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenarios", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    found: dict[str, list[Difference]] = defaultdict(list)
    lost: list[str] = []
    for i in range(given.scenarios):
        kind = PARTS[i % len(PARTS)]
        for attempt in range(TRIES):
            numbers = np.random.default_rng([given.seed, i, attempt])
            try:
                *loop, traits = loop_of(kind, numbers)
                sizes = difference(*moved(*loop, numbers), SHAPES[numbers.integers(4)], i)
            except ContourlabError:
                continue
            if sizes is not None:
                causes = ", ".join(sorted(traits)) or "rounding alone"
                found[causes].append(sizes)
                print(f"{kind.family}/{kind.kind}: {sizes[0]:.3g} m, {sizes[1]:.3g} m; {causes}", file=sys.stderr)
                break
        else:
            lost.append(f"{kind.family}/{kind.kind}")
    rows = [
        {
            "decides": name,
            "scenarios": len(each),
            "position_m": max(one for one, _ in each),
            "part_error_max_m": max(one for _, one in each),
        }
        for name, each in sorted(found.items())
    ]
    print(f"{'decides on a last digit':44}{'scenarios':>10}{'position [nm]':>16}{'largest part error [nm]':>26}")
    for row in rows:
        print(f"{row['decides']:44}{row['scenarios']:>10}{1e9 * row['position_m']:>16.3g}{1e9 * row['part_error_max_m']:>26.3g}")
    if lost:
        print(f"no loop of them follows within {1e3 * FOLLOWS:g} mm: {', '.join(sorted(set(lost)))}")
    figures_file.write("portable.json", rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
