"""One entry of an archive, the same for all kinds of archives."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import IO, Literal

Kind = Literal["file", "folder", "link", "hard link", "other"]


@dataclass(frozen=True)
class Member:
    """name, target: as the archive has them, so not to be trusted.

    open: reads a file's content; to be called before the next member is asked for.
    target: where a link leads. packed: bytes in the archive, where it is known.
    """

    name: str
    kind: Kind
    open: Callable[[], AbstractContextManager[IO[bytes]]]
    executable: bool = False
    target: str = ""
    packed: int = 0
