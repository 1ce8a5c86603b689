"""Source that the program writes for itself, such as a step written out for a number of axes."""

from __future__ import annotations

import itertools
import linecache
from typing import Any

_count = itertools.count(1)


def generated(source: str, scope: dict[str, Any], name: str) -> Any:
    """Execute source, and return what it defines under a name; the translator and tracebacks can read the source later.

    Parameters
    ----------
    source : str
        Never contains text of a user.
    scope : dict
        Global names of the source; receives what it defines.
    name : str
    """
    file = f"<contourlab {name} {next(_count)}>"
    linecache.cache[file] = (len(source), None, source.splitlines(keepends=True), file)
    exec(compile(source, file, "exec"), scope)
    return scope[name]
