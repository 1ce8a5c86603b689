"""A circle on two rigid axes, each described by `plain.toml`."""

SCENARIO = """\
name = "circle"
machine = "stage.toml"
[controller.axes."*".controller]
kind = "position"
velocity_gain = "0.06 full_scale*s/mm"
position_gain = "3 full_scale/mm"
integral_gain = "10 1/s"
model_gain = "1050 mm/s^2/full_scale"
[contour]
name = "circle"
radius = "10 mm"
[feed]
law = "uniform"
frequency = "1 Hz"
laps = 2
[run]
start = "moving"
"""
STAGE = """\
[machine]
name = "stage"
servo_period = "1 ms"
axes = ["x", "y"]
[axes]
x.file = "plain.toml"
y.file = "plain.toml"
"""
