"""
Which controller keeps a circle round?
======================================

One machine runs the same circle under four controllers. The polar plot shows the deviation from the
nominal circle, as a ball bar does; *G* is the circular deviation of ISO 230-4.
"""

from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np

import contourlab as cl

# %%
# Three controllers come from the shipped scenario. In the fourth, cross-coupling takes the place of
# the modified reference: it adds a correction for the contour error to the commands. Its gain
# leaves a modulus margin of 0.5 in every direction, as the modified reference does.

scenario = cl.load_scenario("builtin:demo-part")
machine = scenario.machine
controllers = {case.name: case.controller for case in scenario.cases()}
coupling = cl.component("coupling", "cross-coupled")(gain=3e4)  # A/m
coupled = replace(scenario.controller, coupling=coupling)
controllers["with observer and cross-coupling"] = coupled
for controller in (scenario.controller, coupled):
    print(f"modulus margin {cl.contour_margins(machine, controller).modulus:.2f}")

# %%
# The motion is a part program: a run-in, one turn of 26 mm radius at 40 mm/s, and a run-out. The
# spikes come where an axis reverses and its friction changes sign.

PROGRAM = """
G17 G21 G90 G94
G0 X0 Y-26
G3 X26 Y0 J26 F2400
I-26
X0 Y26 I-26
M2
"""
route = cl.route_from_program(cl.parse_program(PROGRAM))
reference = cl.plan(route, machine.planner_limits(), machine.servo_period)

figure = plt.figure(figsize=(7, 7.5), layout="constrained")
ring = figure.add_subplot(projection="polar")
deviation = {}
for name, controller in controllers.items():
    result = cl.judge(cl.simulate(machine, controller, reference), reference)
    circle = cl.circles_of(result, reference)[0]
    deviation[name] = 1e6 * circle.circular_deviation
    label = f"{name}: G = {deviation[name]:.0f} um"
    ring.plot(circle.angle, 1e6 * circle.deviation, linewidth=1.2, label=label)

turn = np.linspace(0, 2 * np.pi, 200)
ring.plot(turn, 0 * turn, color="black", linewidth=0.8, label="nominal")
ring.set_rlim(-80, 40)
ring.set_rgrids([-40, -20, 0, 20, 40], angle=67.5)
ring.set_title("Radial deviation [um]")
figure.legend(loc="outside lower center")
plt.show()
