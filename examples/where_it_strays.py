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
result = cl.judge(cl.simulate(case.machine, case.controller, reference), reference)
verdict = cl.verdict(case.machine, case.controller, reference, result, case.tolerance, lines=case.lines)
worst = verdict.worst
print(f"largest error {1e6 * worst.value:.1f} um, tolerance {1e6 * case.tolerance:.0f} um, at {worst.text!r}")
print(*(finding.text for finding in verdict.findings), sep="\n")

# %%
# Left: where the tool is on the cutting moves, with its distance from the path drawn 200 times as
# large. Right: the causes of the error at the worst place, which the ring marks. They add up to the
# error.

cutting = reference.judged.samples[::5]
tool = result["tool_position"][cutting]
path = reference.programmed.position(result["foot_arc_length"][cutting])
x, y, _ = 1e3 * (path + 200 * (tool - path)).T
causes = {cause.name: 1e6 * cause.contribution for cause in verdict.causes if abs(cause.contribution) > 0.1e-6}

figure, (plan, bars) = plt.subplots(1, 2, figsize=(10, 4.8), layout="constrained", width_ratios=[3, 2])
plan.plot(*1e3 * path.T[:2], ".", color="0.8", markersize=1)
points = plan.scatter(x, y, c=1e6 * abs(result["part_error"][cutting]), s=2, cmap="plasma_r")
plan.set(xlabel="x [mm]", ylabel="y [mm]", aspect="equal", title="Part, errors × 200")
plan.plot(1e3 * worst.position[0], 1e3 * worst.position[1], "o", markersize=22, markerfacecolor="none", color="black")
figure.colorbar(points, ax=plan, label="distance from the path [um]")
bars.barh(list(causes), list(causes.values()), height=0.5)
bars.invert_yaxis()
bars.set(xlabel="contribution [um]", title=f"Line {worst.line}: {1e6 * worst.value:.1f} um")
plt.show()
