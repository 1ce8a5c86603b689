"""A small machine, its controller and a scenario as text, for tests that change one thing at a time."""

MACHINE = """
[machine]
name = "stage"
servo_period = "1 ms"
axes = ["x", "y"]

[axes.x]
friction = "none"
[axes.x.plant]
kind = "rigid-axis"
gain = "1695 mm/s^2/full_scale"
damping = "10 1/s"
[axes.x.limits]
velocity = "150 mm/s"
acceleration = "1 m/s^2"
[axes.y]
mounted_on = "x"
[axes.y.plant]
kind = "rigid-axis"
gain = "1.1 m/s^2/full_scale"
[axes.y.friction]
kind = "coulomb"
coulomb = "0.05 full_scale"
[axes.y.sensor]
kind = "encoder"
resolution = "0.1 um"
[axes.y.limits]
velocity = "150 mm/s"
acceleration = "1 m/s^2"
"""

CONTROLLER = """
[controller.estimator]
kind = "newton"
[controller.coupling]
kind = "modified-reference"
weight = 0.5
[controller.axes."*".controller]
kind = "position"
position_gain = "4 full_scale/mm"
velocity_gain = "0.1 full_scale*s/mm"
[controller.axes.y.observer]
kind = "disturbance-observer"
model_gain = "1 m/s^2/full_scale"
"""

SCENARIO = (
    'name = "test"\n'
    + MACHINE
    + CONTROLLER
    + """
[contour]
name = "circle"
radius = "20 mm"
[feed]
law = "uniform"
frequency = "0.5 Hz"
laps = 2
[run]
tolerance = "20 um"
"""
)
