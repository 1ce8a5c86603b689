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
# The four largest causes of the error at the worst place.

causes = {cause.name: 1e6 * cause.contribution for cause in verdict.causes[:4]}
figure, bars = plt.subplots(figsize=(7, 2.4), layout="constrained")
bars.barh(list(causes), list(causes.values()), height=0.5)
bars.invert_yaxis()
bars.set(xlabel="contribution [um]", title=f"Line {worst.line}")
plt.show()

# %%
# The path of the tool, its distance from the programmed path magnified. Turn it, move the slider,
# click on the path. In a notebook, ``cl.show`` shows the same.

program = case.motion.program
cl.show(result, "path-space", "error-time", tolerance=case.tolerance, program=program)
