"""Writes reports: beside and renamed, so that a reader never sees half of one."""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Iterable
from pathlib import Path

import psutil

from course.errors import StorageError

_PART = re.compile(r"\..+\.(?P<pid>\d{1,9})\.part")
_PLAIN_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,79}")
_MADE_NAME = re.compile(r".*-[0-9a-f]{12}")


def write(target: Path, pieces: Iterable[str | bytes]) -> None:
    """Give `target` a content that comes piece by piece. Raises StorageError; then the old file stays."""
    part = target.with_name(f".{target.name[:80]}.{os.getpid()}.part")
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        try:
            with part.open("wb") as stream:
                for piece in pieces:
                    stream.write(piece.encode("utf-8") if isinstance(piece, str) else piece)
                stream.flush()
                os.fsync(stream.fileno())
            part.replace(target)
        finally:
            part.unlink(missing_ok=True)
    except OSError as error:
        what = f"{target} cannot be written: {error.strerror or error}."
        raise StorageError(what, "See that there is room and that you may write there.") from error


def sweep(folder: Path) -> None:
    """Remove what `write` left half written in `folder` when it was killed. Raises OSError."""
    for left in folder.glob(".*.part"):
        found = _PART.fullmatch(left.name)
        if found and not psutil.pid_exists(int(found["pid"])):
            left.unlink(missing_ok=True)


def file_stem(person_id: str) -> str:
    """A file's name for a person: the id itself where that is harmless, else its harmless part and a hash.

    Different ids get different names.
    """
    if _PLAIN_NAME.fullmatch(person_id) and not _MADE_NAME.fullmatch(person_id):
        return person_id
    harmless = re.sub(r"[^A-Za-z0-9]+", "-", person_id).strip("-")[:40] or "person"
    return f"{harmless}-{hashlib.sha256(person_id.encode('utf-8', 'surrogatepass')).hexdigest()[:12]}"
