"""
How much backlash does a circle reveal?
=======================================

A machine with worn nuts measures position at its motors and runs a circle in both senses. The steps
at the quadrants give the backlash of each axis; the control compensates what was found, and a
second test shows what it is worth.
"""

from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np

import contourlab as cl

# %%
# A run-in, a turn and a run-out, then the same clockwise. The nuts have a gap of 20 um. The
# friction of the guides winds up the screws by a few um more, which the motors do not see either.

PROGRAM = """
G17 G21 G90 G94
G0 X0 Y-40
G3 X40 Y0 J40 F1200
I-40
X0 Y40 I-40
G4 P0.5
G2 X40 Y0 J-40
I-40
X0 Y-40 I-40
M2
"""
case = cl.load_scenario("builtin:backlash/part").case("PI cascade")
machine, controller = case.machine, case.controller
route = cl.route_from_program(cl.parse_program(PROGRAM))
reference = cl.plan(route, machine.planner_limits(), machine.servo_period)


def circles(controller):
    """Return the counter-clockwise and the clockwise turn."""
    result = cl.judge(cl.simulate(machine, controller, reference), reference)
    return cl.circles_of(result, reference)


before = circles(controller)
found = cl.backlash_of_runs(before)
for axis, gap, sigma in zip("xy", found.backlash, found.deviation, strict=True):
    print(f"{axis}: {1e6 * gap:.1f} um ± {1e6 * sigma:.1f} um")

# %%
# The compensation of a CNC shifts the reference by the gap when an axis reverses. The steps vanish;
# the spikes are friction, and the time in which the motors cross the gap.

offset = cl.component("compensation", "backlash-offset")
axes = dict(controller.axes)
for axis, gap in zip("xy", found.backlash, strict=True):
    axes[axis] = replace(axes[axis], compensation=offset(backlash_gap=gap))
after = circles(replace(controller, axes=axes))

figure = plt.figure(figsize=(7, 7.5), layout="constrained")
ring = figure.add_subplot(projection="polar")
tests = {"without compensation": before, "with compensation": after}
for name, (turn, _) in tests.items():
    label = f"{name}: G = {1e6 * turn.circular_deviation:.0f} um"
    ring.plot(turn.angle, 1e6 * turn.deviation, linewidth=1.2, label=label)
turn = np.linspace(0, 2 * np.pi, 200)
ring.plot(turn, 0 * turn, color="black", linewidth=0.8, label="nominal")
ring.set_rlim(-150, 80)
ring.set_title("Radial deviation [um], counter-clockwise turn")
figure.legend(loc="outside lower center")
plt.show()
