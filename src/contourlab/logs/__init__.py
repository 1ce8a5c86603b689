"""Measured logs: read files of many formats into a `Result`, as a simulation gives."""

from contourlab.logs.formats import read_record
from contourlab.logs.load import Log, load_log, result_of
from contourlab.logs.mapping import Column, Columns, parse_columns, read_columns
from contourlab.logs.reading import Channel, Record

__all__ = ["Channel", "Column", "Columns", "Log", "Record", "load_log", "parse_columns", "read_columns", "read_record", "result_of"]
