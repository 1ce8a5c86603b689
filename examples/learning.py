"""
What can a machine learn from one part for the next?
====================================================

The same part is cut again and again. After each trial, what the controllers had to correct is fed
forward into the next one: most of the error that repeats disappears.
"""

import matplotlib.pyplot as plt

import contourlab as cl

# %%
# The law smooths the feedback of a trial without a shift in time, advances it by the lag of the
# loop, and adds it to the commands of the next trial. ``cl.learning_analysis`` tells beforehand
# whether it converges.

case = cl.load_scenario("builtin:demo-part").case("position loop")
reference = case.reference()
loop = case.machine, case.controller, reference
law = cl.component("learning", "zero-phase")(gain=0.5, half_width=11, lead=8e-3)
run = cl.learn(*loop, law, trials=15)
print(f"{run.status}; best trial {run.best}")

# %%
# ``run.table`` holds what was learned, and can be saved. A simulation takes it, as the control does
# for every further part.

first = cl.simulate(*loop)
learned = cl.simulate(*loop, learned=run.table.learned)

# %%
# The error falls to less than a tenth.

figure, by_trial = plt.subplots(figsize=(7, 4), layout="constrained")
largest = [1e6 * trial.contour_max for trial in run.trials]
rms = [1e6 * trial.contour_rms for trial in run.trials]
by_trial.semilogy(largest, "o-", label="largest")
by_trial.semilogy(rms, "s-", label="rms")
by_trial.set(xlabel="trial", ylabel="contour error [um]", title="Cutting moves")
by_trial.yaxis.set_major_formatter("{x:g}")
by_trial.legend()
plt.show()

# %%
# What is left around the circle of the part are small peaks at the reversals: friction jumps there,
# faster than the filter of the law passes.

judged = {"trial 0": first, f"trial {run.best}": learned}
judged = {name: cl.judge(result, reference) for name, result in judged.items()}
figures = {name: cl.summarise(result, reference) for name, result in judged.items()}
contour_error = {name: each.contour_error for name, each in figures.items()}
cl.show(judged, "circle-0", "error-time")
