"""
How many machines of a series hold the tolerance?
=================================================

No two machines of a series are alike, and each carries another workpiece. A thousand of them run
the same circle in one batch, each judged exactly, under two controllers.
"""

from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np

import contourlab as cl

# %%
# Friction spreads by a quarter between machines and axes; the workpiece weighs up to 60 kg.
# ``cl.parameter_names`` lists what a batch can vary.

TOLERANCE = 25e-6  # m
N = 1000
scenario = cl.load_scenario("builtin:demo-part")
machine = scenario.machine
random = np.random.default_rng(seed=1)
workpiece = random.uniform(0.0, 60.0, N)  # kg
variants = {}
for axis in "xy":
    friction = machine.axis(axis).friction
    factor = random.normal(1.0, 0.25, N).clip(0.2)
    variants[f"axes.{axis}.friction.coulomb"] = factor * friction.coulomb
    variants[f"axes.{axis}.friction.breakaway"] = factor * friction.breakaway
    variants[f"axes.{axis}.plant.mass"] = machine.axis(axis).plant.mass + workpiece

# %%
# Cross-coupling corrects the contour error that the observers leave.

observer = scenario.case("with disturbance observer").controller
coupling = cl.component("coupling", "cross-coupled")(gain=3e4)  # A/m
coupled = replace(scenario.controller, coupling=coupling)
controllers = {"observer": observer, "observer and cross-coupling": coupled}
program = cl.parse_program("G17 G21 G90 G94\nG0 X26 Y0\nG3 I-26 J0 F2400\nM2\n")
route = cl.route_from_program(program)
reference = cl.plan(route, machine.planner_limits(), machine.servo_period)

figure, graph = plt.subplots(figsize=(8, 4.5), layout="constrained")
within = {}
for name, controller in controllers.items():
    batch = cl.simulate_batch(machine, controller, reference, variants)
    largest = batch.figures["contour_error_max"]
    within[name] = np.mean(largest <= TOLERANCE)
    label = f"{name}: {within[name]:.0%} within"
    graph.hist(1e6 * largest, bins=np.arange(0, 42), alpha=0.7, label=label)
graph.axvline(1e6 * TOLERANCE, color="black", linestyle="--", label="tolerance")
graph.set(xlabel="largest contour error [um]", ylabel="machines")
graph.legend(framealpha=1)
plt.show()
