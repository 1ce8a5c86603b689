"""References: each once, well formed, and found from what an answer uses."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import yaml

import contourlab as cl
from contourlab.app.cite import references
from contourlab.components.registry import components
from contourlab.errors import ParameterError, ResultError

NEEDED = {
    "article": {"author", "title", "journal", "year"},
    "book": {"author", "title", "publisher"},
    "inproceedings": {"author", "title", "booktitle", "year"},
    "phdthesis": {"author", "title", "school", "year"},
    "misc": {"author", "title"},
}


def parsed(text: str) -> dict[str, tuple[str, dict[str, str]]]:
    """Parse BibTeX strictly: kind and fields of each entry by key; braces must balance, and names stand once."""
    found: dict[str, tuple[str, dict[str, str]]] = {}
    at = 0
    while (match := re.compile(r"\s*@(\w+)\{([\w-]+),").match(text, at)) is not None:
        kind, key = match.groups()
        assert key not in found
        at, values = match.end(), dict[str, str]()
        while (name := re.compile(r"\s*(\w+)\s*=\s*\{").match(text, at)) is not None:
            depth, start, at = 1, name.end(), name.end()
            while depth:
                depth += {"{": 1, "}": -1}.get(text[at], 0)
                at += 1
            assert name[1] not in values
            values[name[1]] = text[start : at - 1]
            at += text[at] == ","
        closing = re.compile(r"\s*\}").match(text, at)
        assert closing is not None, (key, text[at : at + 40])
        at, found[key] = closing.end(), (kind, values)
    assert not text[at:].strip(), text[at : at + 40]
    return found


def keys(what: object) -> set[str]:
    return set(parsed(cl.cite(what)))  # type: ignore[arg-type]


def test_each_reference_is_well_formed_and_is_used() -> None:
    entries = parsed("\n\n".join(text for text, _ in references().values()))
    assert entries.keys() == references().keys() and len(entries) > 50
    squashed = [re.sub(r"\W", "", kind.reference) for kind in components()]
    for key, (kind, values) in entries.items():
        assert NEEDED[kind] <= values.keys(), key
        assert all(value.strip() and value.isascii() for value in values.values()), key
        assert re.fullmatch(r"\d{4}", values.get("year", "1990")) and key.endswith(values.get("year", key[-4:])), key
        assert all(re.fullmatch(r"\{.+\}|[^,]+, .+|others", one) for one in values["author"].split(" and ")), key
        assert not re.search(r"(?<!\\)[&%$#]", " ".join(values.values())), key
        assert key == "contourlab" or references()[key][1] or any(key in text for text in squashed), key


def test_each_name_with_a_year_in_a_component_is_a_reference() -> None:
    for kind in components():
        named = re.findall(r"(?:^|[;:] |of )((?:[A-Zv][\w.' -]*(?:, | & )?)+ (?:19|20)\d\d)", kind.reference)
        assert all(re.sub(r"\W", "", name) in references() for name in named), (kind.kind, kind.reference)
        assert bool(named) == bool(re.search(r"(19|20)\d\d", kind.reference)), (kind.kind, kind.reference)


def test_contourlab_is_cited_as_its_citation_file_says() -> None:
    file = yaml.safe_load((Path(__file__).parents[3] / "CITATION.cff").read_text(encoding="utf-8"))
    values = parsed(references()["contourlab"][0])["contourlab"][1]
    assert (values["title"], values["author"]) == (file["title"], f"{{{file['authors'][0]['name']}}}")
    assert file["version"] in values["howpublished"]


def test_an_answer_cites_what_it_uses() -> None:
    scenario = cl.load_scenario("builtin:ghaffari/demo-stage")
    own = {"contourlab", "ArmstrongHelouvryDupontCanudasdeWit1994", "GhaffariUlsoy2017"}
    assert keys(scenario.machine) == own
    assert keys(scenario) == own | {"GhaffariUlsoy2016", "Koren1980"}
    assert keys(cl.analyse(scenario)) == keys(scenario)
    assert keys(cl.load_scenario("builtin:gecer-ulu/contour")) >= {"GecerUluUluCakmakci2016", "YehHsu2002"}
    assert "PhamPham2018" in keys(cl.load_scenario("builtin:demo-part")) and "PhamPham2018" not in keys(scenario)


def test_what_says_nothing_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("made by somebody")
    with pytest.raises(ResultError):
        cl.cite(tmp_path / "a.txt")
    with pytest.raises(ParameterError):
        cl.cite(3)  # type: ignore[arg-type]
