"""Assert a refusal by its type and attributes: a test survives a better sentence."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest


@contextmanager
def refuses(kind: type[Exception], match: str | None = None, **attributes: Any) -> Iterator[pytest.ExceptionInfo[Exception]]:
    """Expect an exception of `kind` with these attributes; `match` is a key word or number, for what no attribute tells."""
    with pytest.raises(kind, match=match) as caught:
        yield caught
    expected = {name: str(value) if isinstance(value, Path) else value for name, value in attributes.items()}
    assert {name: getattr(caught.value, name) for name in attributes} == expected


def mentions(texts: Any, *words: str) -> bool:
    """Return whether one of `texts` holds all `words`."""
    return any(all(word in text for word in words) for text in texts)
