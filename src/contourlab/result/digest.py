"""SHA-256 digest at the end of a file: damage is found before a reader sees the file."""

from __future__ import annotations

import hashlib
import io
from typing import BinaryIO

DIGEST_SIZE = hashlib.sha256().digest_size


def stream_digest(stream: BinaryIO, size: int, identity: bytes = b"") -> bytes:
    """Return the digest of an identity and of the first `size` bytes of a stream; leave the stream there."""
    stream.seek(0)
    digest, left = hashlib.sha256(identity), size
    while left > 0 and (part := stream.read(min(left, 1 << 20))):
        digest.update(part)
        left -= len(part)
    return digest.digest()


def append_digest(stream: BinaryIO, identity: bytes = b"") -> None:
    """Append the digest of an identity and of the stream to the stream."""
    stream.write(stream_digest(stream, stream.seek(0, io.SEEK_END), identity))


def is_intact(stream: BinaryIO, identity: bytes = b"") -> bool:
    """Return whether a stream ends in the digest of this identity and of all its other bytes."""
    return stream_digest(stream, stream.seek(0, io.SEEK_END) - DIGEST_SIZE, identity) == stream.read()
