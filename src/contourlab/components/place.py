"""Where a fault of a component is: file, line and class."""

from __future__ import annotations

import inspect
import sys
import traceback
from typing import Any

from contourlab.engine.translate.outer import TYPED
from contourlab.errors import ComponentError, error_text


def file_of_class(kind: type) -> str:
    """Return the file of a class; that of a plug-in as the user typed it."""
    module = sys.modules.get(kind.__module__)
    return str(getattr(module, TYPED, None) or getattr(module, "__file__", None) or kind.__module__)


def line_in(file: str, error: BaseException) -> int:
    """Return the line of a file at which an error was raised, 0 if none; `file` as from `file_of_class`."""
    frames = traceback.walk_tb(error.__traceback__)
    lines = [line for frame, line in frames if file in (frame.f_globals.get(TYPED), frame.f_code.co_filename)]
    return lines[-1] if lines else 0


def raised_in_plugin(error: BaseException) -> str:
    """Return place and text of an error raised by the code of a plug-in; empty for all others."""
    for frame, line in reversed([*traceback.walk_tb(error.__traceback__)]):
        file = frame.f_globals.get(TYPED)
        if file is not None:
            return f"{file}:{line}: {frame.f_code.co_qualname}: {error_text(error)}"
    return ""


def fault(kind: type, message: str, function: Any = None, line: int = 0) -> ComponentError:
    """Return the error about a class: file, line (of a function in that file, or else of the class), name, message."""
    file, code = file_of_class(kind), getattr(function, "__code__", None)
    if not line and code is not None and file in (function.__globals__.get(TYPED), code.co_filename):
        line = code.co_firstlineno
    if not line:
        try:
            line = inspect.getsourcelines(kind)[1]
        except (OSError, TypeError):  # a class without a source, made by type()
            line = 0
    return ComponentError(f"{file}{f':{line}' if line else ''}: {kind.__name__}: {message}")
