"""
Where does the tool stray from the path, and why?
=================================================

A part program runs on a three-axis machine, and the tool's exact distance from the path is compared
with a tolerance. The verdict names the worst line of the program and says what the error there
consists of.
"""

import matplotlib.pyplot as plt

import contourlab as cl

# %%
# The shipped scenario has a machine, three controllers, and a program that cuts a circle, a diamond
# and a square. Yours is a file: ``cl.load_scenario("scenario.toml")``.

case = cl.load_scenario("builtin:demo-part").case("position loop")
reference = case.reference()  # planned, and sampled at the servo period
loop = case.machine, case.controller, reference
result = cl.judge(cl.simulate(*loop), reference)
verdict = cl.verdict(*loop, result, case.tolerance, lines=case.lines)
worst = verdict.worst
print(f"{1e6 * worst.value:.1f} um in {worst.text!r}")
print(f"tolerance {1e6 * case.tolerance:.0f} um")

# %%
# Left: where the tool is on the cutting moves, with its distance from the path drawn 200 times as
# large. Right: the four largest causes of the error at the worst place, which the ring marks.

cutting = reference.judged.samples[::5]
tool = result["tool_position"][cutting]
path = reference.programmed.position(result["foot_arc_length"][cutting])
x, y, _ = 1e3 * (path + 200 * (tool - path)).T
error = 1e6 * abs(result["part_error"][cutting])
causes = {cause.name: 1e6 * cause.contribution for cause in verdict.causes[:4]}
place = 1e3 * result["tool_position"][worst.sample]

figure = plt.figure(figsize=(10, 4.8), layout="constrained")
plan, bars = figure.subplots(1, 2, width_ratios=[3, 2])
plan.plot(*1e3 * path.T[:2], ".", color="0.8", markersize=1)
points = plan.scatter(x, y, c=error, s=2, cmap="plasma_r")
plan.set(xlabel="x [mm]", ylabel="y [mm]", aspect="equal", title="Part, errors × 200")
plan.scatter(*place[:2], s=500, c="none", edgecolor="black")
figure.colorbar(points, ax=plan, label="distance from the path [um]")
bars.barh(list(causes), list(causes.values()), height=0.5)
bars.invert_yaxis()
bars.set(xlabel="contribution [um]", title=f"Line {worst.line}")
plt.show()
