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
# Left: the error falls to less than a tenth. Right: around the circle of the part, what is left are
# small peaks at the reversals: friction jumps there, faster than the filter of the law passes.

figure = plt.figure(figsize=(10, 4.2), layout="constrained")
by_trial, in_time = figure.subplots(1, 2)
largest = [1e6 * trial.contour_max for trial in run.trials]
rms = [1e6 * trial.contour_rms for trial in run.trials]
by_trial.semilogy(largest, "o-", label="largest")
by_trial.semilogy(rms, "s-", label="rms")
by_trial.set(xlabel="trial", ylabel="contour error [um]", title="Cutting moves")
by_trial.yaxis.set_major_formatter("{x:g}")
by_trial.legend()

contour_error = {}
for name, result in {"trial 0": first, f"trial {run.best}": learned}.items():
    judged = cl.judge(result, reference)
    contour_error[name] = cl.summarise(judged, reference).contour_error
    circle = cl.circles_of(judged, reference)[0]
    time = judged.time[circle.samples]
    in_time.plot(time, 1e6 * circle.deviation, linewidth=1, label=name)
in_time.set(xlabel="time [s]", ylabel="radial deviation [um]", title="Circle")
in_time.legend()
plt.show()
