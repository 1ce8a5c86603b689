"""Write the types of the viewer's messages from the classes of the pictures: ``python tools/page_contract.py``.

`page/src/contract.ts` is for our front end, `rendering/viewer/contract.json` (JSON Schema, draft 2020-12) for any other.
"""

from __future__ import annotations

import json
from dataclasses import fields, is_dataclass
from pathlib import Path
from types import NoneType, UnionType
from typing import Any, get_args, get_origin, get_type_hints

import numpy as np

from contourlab.rendering.message import CONTRACT, Drawn

ROOT = Path(__file__).parents[1]
FILES = {"ts": ROOT / "page/src/contract.ts", "json": ROOT / "src/contourlab/rendering/viewer/contract.json"}
NUMBERS = {
    "type": "object",
    "description": "An array: little-endian, row by row, from byte `at` of the numbers on.",
    "properties": {
        "dtype": {"enum": ["f4", "f8", "i4", "u1"]},
        "at": {"type": "integer", "minimum": 0},
        "shape": {"type": "array", "items": {"type": "integer", "minimum": 0}},
    },
    "required": ["dtype", "at", "shape"],
}
SIMPLE = {float: "number", int: "integer", bool: "boolean", str: "string", NoneType: "null"}
HEAD = """// Written by tools/page_contract.py from the classes in contourlab.rendering.charts. Do not edit.

/** An array, unpacked: its numbers row by row, and its shape. */
export interface Numbers {{ values: Float32Array | Float64Array | Int32Array | Uint8Array; shape: number[] }}

export const CONTRACT = "{contract}";
"""


def schema_of(hint: Any, known: dict[str, Any]) -> dict[str, Any]:
    """Return the schema of a type; add the classes that it contains to the known ones."""
    origin, parts = get_origin(hint) or hint, get_args(hint)
    if isinstance(origin, type) and issubclass(origin, np.ndarray):
        return {"$ref": "#/$defs/Numbers"}
    if origin is UnionType:
        return {"anyOf": [schema_of(part, known) for part in parts]}
    if origin is tuple and parts[1:] != (...,):
        count = len(parts)
        return {"type": "array", "prefixItems": [schema_of(part, known) for part in parts], "minItems": count, "maxItems": count}
    if origin is tuple:
        return {"type": "array", "items": schema_of(parts[0], known)}
    if is_dataclass(origin):
        name = origin.__name__
        if name not in known:
            known[name] = {}
            hints = get_type_hints(origin)
            properties = {field.name: schema_of(hints[field.name], known) for field in fields(origin)}
            about = " ".join((origin.__doc__ or "").split("\n\n")[0].split())
            kind = {"kind": {"const": name}}
            known[name] = {"type": "object", "description": about, "properties": kind | properties, "required": ["kind", *properties]}
        return {"$ref": f"#/$defs/{name}"}
    return {"type": SIMPLE[origin]}


def contract() -> dict[str, Any]:
    """Return the schema of a message's header."""
    known: dict[str, Any] = {"Numbers": NUMBERS}
    picture = schema_of(Drawn, known)
    properties = {"contract": {"const": CONTRACT}, "pictures": {"type": "array", "items": picture}}
    whole = {"title": CONTRACT, "type": "object", "properties": properties, "required": list(properties)}
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **whole, "$defs": known}


def type_of(schema: dict[str, Any]) -> str:
    """Return a schema as a type of TypeScript."""
    if "$ref" in schema:
        return str(schema["$ref"]).rpartition("/")[2]
    if "const" in schema:
        return json.dumps(schema["const"])
    if "anyOf" in schema:
        return " | ".join(map(type_of, schema["anyOf"]))
    if "prefixItems" in schema:
        return f"[{', '.join(map(type_of, schema['prefixItems']))}]"
    if schema["type"] == "array":
        item = type_of(schema["items"])
        return f"({item})[]" if " | " in item else f"{item}[]"
    return "number" if schema["type"] == "integer" else str(schema["type"])


def typescript(schema: dict[str, Any]) -> str:
    """Return the types of a header."""
    parts = [HEAD.format(contract=CONTRACT)]
    for name, form in schema["$defs"].items():
        if name != "Numbers":
            lines = "".join(f"\n  {key}: {type_of(part)};" for key, part in form["properties"].items())
            parts.append(f"/** {form['description']} */\nexport interface {name} {{{lines}\n}}\n")
    parts.append(f"export type Picture = {type_of(schema['properties']['pictures']['items'])};\n")
    return "\n".join(parts)


def texts() -> dict[Path, str]:
    """Return the text of each file."""
    schema = contract()
    return {FILES["ts"]: typescript(schema), FILES["json"]: json.dumps(schema, indent=1, ensure_ascii=False) + "\n"}


if __name__ == "__main__":
    for file, text in texts().items():
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
