"""Writes to the learner's disk: completely or not at all, and never through a link that leads elsewhere."""

from __future__ import annotations

import contextlib
import errno
import os
import shutil
import stat
from collections.abc import Callable, Iterator
from pathlib import Path

from course.errors import StorageError, UsageError
from course.files import replacing, to_disk, unfinished

_ADVICE = {
    errno.ENOSPC: "free some space on this disk, then try again; nothing was lost",
    errno.EDQUOT: "free some space (your quota is used up), then try again; nothing was lost",
    errno.EROFS: "this disk is read-only: choose another folder, or mount it writable",
    errno.EACCES: "you may not write there: choose another folder, or ask its owner",
    errno.EPERM: "you may not write there: choose another folder, or ask its owner",
}


@contextlib.contextmanager
def storing(what: str) -> Iterator[None]:
    """Turns an OSError into a StorageError that says what could not be done, and what to do."""
    try:
        yield
    except OSError as error:
        place = f": {error.filename}" if error.filename else ""
        advice = _ADVICE.get(error.errno or 0, "check that folder, then try again; nothing was lost")
        raise StorageError(f"{what} ({error.strerror or error}{place})", advice) from error


def write_new(target: Path, content: bytes) -> bool:
    """Make a file that does not exist yet. If something is there, do nothing and return False."""
    return _new(target, lambda part: _fill(part, content))


def copy_new(source: Path, target: Path) -> bool:
    """Copy a file with its mode. If something is there, do nothing and return False."""
    return _new(target, lambda part: copy_into(source, part))


def copy_over(source: Path, target: Path) -> None:
    """Copy a file with its mode, and replace what is there. A link there is replaced, not followed."""
    with replacing(target) as part:
        copy_into(source, part)


def copy_into(source: Path, target: Path) -> None:
    """Copy a file with its mode, or a link as a link. Only for places where half a file does no harm."""
    shutil.copy(source, target, follow_symlinks=False)
    if not target.is_symlink():
        # The course may be installed read-only; the learner's copy must not be.
        target.chmod(target.stat().st_mode | stat.S_IRUSR | stat.S_IWUSR)
        to_disk(target)


def inside(home: Path, relative: str) -> Path:
    """`home/relative`. Raises UsageError if a folder on the way is a link that leads out of the home."""
    target = home / relative
    for folder in reversed(target.parents):  # from the top, so that the error names the link itself
        if folder.is_relative_to(home) and not _real(folder).is_relative_to(_real(home)):
            raise UsageError(
                f"{folder} is a link that leads outside the course home, so nothing was written there",
                "put a real folder in its place, then try again",
            )
    return target


def _real(path: Path) -> Path:
    return Path(os.path.realpath(path))  # unlike resolve(), accepts circular links


def _new(target: Path, fill: Callable[[Path], None]) -> bool:
    if os.path.lexists(target):
        return False
    with unfinished(target) as part:
        fill(part)
        return _name_it(part, target)


def _name_it(part: Path, target: Path) -> bool:
    """Rename the finished file, unless the name was taken in the meantime."""
    try:
        os.link(part, target, follow_symlinks=False)
    except FileExistsError:
        return False
    except OSError as error:
        if error.errno not in (errno.EPERM, errno.EOPNOTSUPP, errno.ENOSYS, errno.EMLINK):
            raise
        if os.path.lexists(target):  # on a disk without hard links, a check is the best we can do
            return False
        part.replace(target)
    return True


def _fill(target: Path, content: bytes) -> None:
    target.write_bytes(content)
    to_disk(target)
