"""What tells that a kept build is still what was built: a digest of all that it installed."""

from __future__ import annotations

import hashlib
import os
import stat
from collections.abc import Iterator
from pathlib import Path


def digest_of(top: Path) -> str:
    """32 hexadecimal digits of the names, modes and contents of everything below `top`; links by target.

    Raises OSError when something cannot be read.
    """
    hashed, start = hashlib.blake2b(digest_size=16), len(str(top)) + 1
    for entry in sorted(_below(str(top)), key=lambda entry: entry.path):
        status = entry.stat(follow_symlinks=False)
        mode = stat.S_IFMT(status.st_mode) | (status.st_mode & 0o111)
        name, content = os.fsencode(entry.path[start:]), _content(entry.path, status.st_mode)
        hashed.update(b"%d\0%d\0%s\0%d\0" % (len(name), mode, name, len(content)) + content)
    return hashed.hexdigest()


def _below(top: str) -> Iterator[os.DirEntry[str]]:
    waiting = [top]
    while waiting:
        with os.scandir(waiting.pop()) as entries:
            for entry in entries:
                yield entry
                if entry.is_dir(follow_symlinks=False):
                    waiting.append(entry.path)


def _content(path: str, mode: int) -> bytes:
    if stat.S_ISLNK(mode):
        return os.fsencode(Path(path).readlink())
    if not stat.S_ISREG(mode):
        return b""
    with open(path, "rb", buffering=0) as file:  # noqa: PTH123 - hundreds of them, before each check
        return file.read()
