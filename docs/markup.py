"""Markdown of the generated pages."""

from __future__ import annotations


def plain(text: str) -> str:
    """Escape characters that Markdown takes for markup."""
    return " ".join(text.replace("|", "\\|").replace("``", "`").replace("<", "&lt;").replace("_", "\\_").replace("*", "\\*").split())
