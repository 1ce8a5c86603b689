"""The part of CSS that determines visibility and size of an element."""

from __future__ import annotations

import re
from collections.abc import Mapping

_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_AT_RULE = re.compile(r"@[^{};]*(?:;|\{(?:[^{}]|\{[^{}]*\})*\})")
_RULE = re.compile(r"([^{}]+)\{([^{}]*)\}")
_SELECTOR = re.compile(r"(\*|[\w-]+)?((?:[#.][\w-]+)*)\Z")
_SEEN = ("display", "visibility")


class StyleSheet:
    """Rules whose selectors are names, ids and classes, alone or together: ``path``, ``#a``, ``g.cut``.

    Attributes
    ----------
    notes : list of str
        Ignored rules on visibility, with other selectors.
    """

    def __init__(self, text: str = "") -> None:
        self.notes: list[str] = []
        self._rules: list[tuple[tuple[int, int, int], str, tuple[str, ...], dict[str, str]]] = []
        text = _COMMENT.sub("", text).replace("<!--", "").replace("-->", "")
        for rule in _AT_RULE.finditer(text):
            if any(word in rule[0] for word in _SEEN):
                self.notes.append(f"style sheet: {rule[0].split('{')[0].strip()!r} is passed over")
        for rule in _RULE.finditer(_AT_RULE.sub("", text)):
            self._add(rule[1], _declarations(rule[2]))

    def _add(self, selectors: str, declared: dict[str, str]) -> None:
        for selector in (word.strip() for word in selectors.split(",")):
            match = _SELECTOR.match(selector)
            if not match or not selector:
                self.notes += [f"style sheet: {name} of {selector!r} is passed over" for name in _SEEN if name in declared]
                continue
            parts = tuple(re.findall(r"[#.][\w-]+", match[2]))
            ids = sum(part.startswith("#") for part in parts)
            name = match[1] or "*"
            self._rules.append(((ids, len(parts) - ids, int(name != "*")), name, parts, declared))

    def of(self, tag: str, attributes: Mapping[str, str]) -> dict[str, str]:
        """Return the declarations for an element: its attributes, overridden by rules in order of specificity, then by its style."""
        declarations = {name: attributes[name].strip() for name in _SEEN if name in attributes}
        selectors = {f".{word}" for word in attributes.get("class", "").split()} | {f"#{attributes.get('id', '')}"}
        matching = [rule for rule in self._rules if rule[1] in ("*", tag) and selectors.issuperset(rule[2])]
        layers = [rule[3] for rule in sorted(matching, key=lambda rule: rule[0])] + [_declarations(attributes.get("style", ""))]
        for wanted in (False, True):  # !important last
            for declared in layers:
                declarations.update({k: v.partition("!")[0].strip() for k, v in declared.items() if ("!" in v) is wanted})
        return declarations


def _declarations(text: str) -> dict[str, str]:
    pairs = (part.partition(":") for part in _COMMENT.sub("", text).split(";"))
    return {name.strip().lower(): value.strip() for name, mark, value in pairs if mark}
