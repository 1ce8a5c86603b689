"""Read the message of a page as another front end would: from its documentation."""

from __future__ import annotations

import base64
import gzip
import json
import re
from typing import Any

import numpy as np


def header_and_numbers(message: bytes) -> tuple[dict[str, Any], bytes]:
    """Return the header of a message, and the numbers of its arrays."""
    data = gzip.decompress(message)
    length = int.from_bytes(data[:4], "little")
    return json.loads(data[4 : 4 + length]), data[4 + length :]


def pictures(message: bytes) -> dict[str, Any]:
    """Return the pictures of a message by key, with their arrays."""
    header, numbers = header_and_numbers(message)

    def filled(value: Any) -> Any:
        if isinstance(value, list):
            return [filled(item) for item in value]
        if not isinstance(value, dict):
            return value
        if "dtype" in value:
            array = np.frombuffer(numbers, "<" + value["dtype"], int(np.prod(value["shape"])), value["at"])
            return array.reshape(value["shape"]).astype(float)
        return {key: filled(item) for key, item in value.items()}

    return {picture["key"]: filled(picture) for picture in header["pictures"]}


def message_in(page: str) -> bytes:
    """Return the message in the text of a page."""
    return base64.b64decode(re.search(r'id="message">([^<]*)<', page)[1])  # type: ignore[index]
