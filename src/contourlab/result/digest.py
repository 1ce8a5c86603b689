"""SHA-256 digest at the end of a file: damage is found before a reader sees the file."""

from __future__ import annotations

import hashlib
import io
from typing import BinaryIO

DIGEST_SIZE = hashlib.sha256().digest_size


def stream_digest(stream: BinaryIO, size: int) -> bytes:
    """Return the digest of the first `size` bytes of a stream; leave the stream there."""
    stream.seek(0)
    digest, left = hashlib.sha256(), size
    while left > 0 and (part := stream.read(min(left, 1 << 20))):
        digest.update(part)
        left -= len(part)
    return digest.digest()


def append_digest(stream: BinaryIO) -> None:
    """Append the digest of a stream to it."""
    stream.write(stream_digest(stream, stream.seek(0, io.SEEK_END)))


def is_intact(stream: BinaryIO) -> bool:
    """Return whether a stream ends in the digest of all its other bytes."""
    return stream_digest(stream, stream.seek(0, io.SEEK_END) - DIGEST_SIZE) == stream.read()
