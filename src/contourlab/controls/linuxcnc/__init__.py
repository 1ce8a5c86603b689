"""LinuxCNC: its INI file, and the HAL files, tool table and parameters that it names."""

from contourlab.controls.linuxcnc.machine import matches, read

__all__ = ["matches", "read"]
