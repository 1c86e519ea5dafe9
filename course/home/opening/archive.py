"""Any archive that is opened here, told by its first bytes, into a folder."""

from __future__ import annotations

import re
from pathlib import Path

from course.home.opening.broken import ADVICE
from course.home.opening.finding import Finding, Refused
from course.home.opening.limits import USUAL, Limits, Meter
from course.home.opening.tars import OPENERS, tar_members
from course.home.opening.unpack import unpack
from course.home.opening.zips import zip_members
from course.home.storage import storing

_ENDINGS = re.compile(r"\.(zip|tar|tgz|tbz2?|txz|tar\.(gz|bz2|xz))$", re.IGNORECASE)
_NOT_OPENED = re.compile(r"\.(rar|7z|tar\.zst|tar\.lzma|cab|iso|dmg|gz|xz|bz2)$", re.IGNORECASE)


def is_archive(name: str) -> bool:
    """Whether a file of this name is an archive, of a kind that is opened here or not."""
    return bool(_ENDINGS.search(name) or _NOT_OPENED.search(name))


def archive_stem(name: str) -> str:
    """`work` for `work.tar.gz`; other names as they are."""
    return _ENDINGS.sub("", name) or name


def open_archive(archive: Path, folder: Path, limits: Limits = USUAL) -> tuple[Finding, ...]:
    """Open `archive` into `folder`, which is made; returns what was left out or changed.

    Raises Refused for an archive that is too much, broken, encrypted or of another kind, and
    StorageError when the disk does not take it (or `folder` is there already); then nothing is left.
    """
    with storing(f"{archive.name} cannot be opened"):
        kind = _kind(archive)
        meter = Meter(limits, archive.stat().st_size)
        if kind == "zip":
            with zip_members(archive, limits) as members:
                return unpack(members, folder, meter)
        with tar_members(archive, meter) as stream:
            return unpack(stream, folder, meter)


def _kind(archive: Path) -> str:
    if not archive.is_file():
        raise Refused("This is no ordinary file.")
    with archive.open("rb") as file:
        start = file.read(262)
    if any(start.startswith(magic) for magic in OPENERS) or start[257:] == b"ustar":
        return "tar"
    if start.startswith(b"PK"):
        return "zip"
    if not start:
        raise Refused("The archive is empty.", ADVICE)
    raise Refused("This is no zip and no tar.", "Ask for a zip, tar.gz, tar.bz2 or tar.xz.")
