"""Results: labelled signals with units, in memory and on disk."""

from contourlab.result.atomic import write_bytes_atomic, write_text_atomic
from contourlab.result.netcdf import ResultWriter
from contourlab.result.result import Result
from contourlab.result.signals import Signal, Status

__all__ = ["Result", "ResultWriter", "Signal", "Status", "write_bytes_atomic", "write_text_atomic"]
