"""Results: labelled signals with units, in memory and on disk."""

from contourlab.result.atomic import write_bytes_atomic, write_text_atomic
from contourlab.result.netcdf import ResultWriter
from contourlab.result.signals import Result, Signal, Status

__all__ = ["Result", "ResultWriter", "Signal", "Status", "write_bytes_atomic", "write_text_atomic"]
