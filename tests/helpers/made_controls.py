"""Files of controls that describe the same two axes."""

from pathlib import Path

LINUXCNC = """[EMC]
MACHINE = a router
[EMCMOT]
SERVO_PERIOD = 1000000
[KINS]
KINEMATICS = trivkins coordinates=XY
[TRAJ]
LINEAR_UNITS = inch
[HAL]
HALCMD = net x-cmd joint.0.motor-pos-cmd => stepgen.0.position-cmd
HALCMD = net y-cmd joint.1.motor-pos-cmd => stepgen.1.position-cmd
[RS274NGC]
RS274NGC_STARTUP_CODE = G64 P0.001
[AXIS_X]
MIN_LIMIT = -1
MAX_LIMIT = 9
[JOINT_0]
MAX_VELOCITY = 2
MAX_ACCELERATION = 20
STEP_SCALE = 4000
[AXIS_Y]
MIN_LIMIT = 0
MAX_LIMIT = 5
[JOINT_1]
MAX_VELOCITY = 3
MAX_ACCELERATION = 20
STEP_SCALE = 4000
"""
GRBL = """Grbl 1.1h ['$' for help]
$11=0.010
$12=0.002
$13=0
$100=250.000 (x, step/mm)
$101=250.000 (y, step/mm)
$110=3048.000
$111=4572.000
$120=508.000
$121=508.000
$130=254.000
$131=127.000
ok
"""
FLUIDNC = """name: a router
axes:
  x:
    steps_per_mm: 250
    max_rate_mm_per_min: 3048
    acceleration_mm_per_sec2: 508
    max_travel_mm: 254
    homing:
      positive_direction: false
      mpos_mm: -25.4
  y:
    steps_per_mm: 250
    max_rate_mm_per_min: 4572
    acceleration_mm_per_sec2: 508
    max_travel_mm: 127
    homing:
      positive_direction: true
      mpos_mm: 0
"""
FILES = {"linuxcnc": ("m.ini", LINUXCNC), "grbl": ("grbl.txt", GRBL), "fluidnc": ("config.yaml", FLUIDNC)}


def made_control(folder: Path, reader: str, *pairs: tuple[str, str]) -> Path:
    name, text = FILES[reader]
    for old, new in pairs:
        assert old in text
        text = text.replace(old, new)
    file = folder / name
    file.write_text(text)
    return file
