"""Builds kept by content: one entry for each key, made at its final place and complete or absent.

    ROOT/<key>/src      the copy that was built
    ROOT/<key>/kept     the same while it is built, out of reach of what the build does to its own
    ROOT/<key>/install  colcon's install base; the package's prefix lies in it, isolated
    ROOT/<key>/log      what the build printed
    ROOT/<key>/build    while it is built
    ROOT/<key>/complete written last, by rename: without it the entry is half-made and counts for nothing.
                        It has a digest of what was installed: an entry that is not that is made anew
    ROOT/<key>.lock     held by whoever makes or removes the entry
    ROOT/<key>.like     the key of an entry whose package differs in its modules alone, see `renewal`

An entry that is complete is never written to again. Its paths are baked into what was built, so it
cannot move. When it was last used is the age of `complete`.
"""

from __future__ import annotations

import errno
import fcntl
import json
import os
import re
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from course.build.intact import digest_of
from course.build.interrupt import Interrupt
from course.errors import CourseError, MissingHere, StorageError
from course.rosenv import cache_dir
from course.rosenv.files import wipe

KEEP_BYTES = 2 * 1024**3
# A check that has just found its entries is still using them.
_IN_USE_SECONDS = 3600.0
# flock cannot be waited for together with an Interrupt, so it is asked for again.
_ASK_AGAIN_SECONDS = 0.05

_KEY = re.compile(r"[0-9a-f]{32}")


@dataclass(frozen=True)
class Entry:
    """The place of one build, whether it exists or not."""

    path: Path

    @property
    def src(self) -> Path:
        return self.path / "src"

    @property
    def kept(self) -> Path:
        return self.path / "kept"

    @property
    def build(self) -> Path:
        return self.path / "build"

    @property
    def install(self) -> Path:
        return self.path / "install"

    @property
    def log(self) -> Path:
        return self.path / "log" / "build.log"

    @property
    def marker(self) -> Path:
        return self.path / "complete"

    def prefix(self, package: str) -> Path:
        return self.install / package

    def is_complete(self) -> bool:
        """Whether it can be used, and is what was built; notes the use, so that it is kept."""
        if not self._is_intact():
            return False
        with suppress(OSError):  # a store on a read-only disk serves all the same
            os.utime(self.marker)
        return True

    def _is_intact(self) -> bool:
        try:
            noted = json.loads(self.marker.read_text(encoding="utf-8"))
            return bool(noted["installed"] == digest_of(self.install))
        except (OSError, ValueError, KeyError, TypeError):
            return False

    def begin(self) -> None:
        """Wipe what an earlier try left."""
        wipe(self.path)
        for folder in (self.build, self.install, self.log.parent):
            folder.mkdir(parents=True)

    def finish(self, package: str) -> None:
        """Mark as complete, when everything is in place."""
        wipe(self.src, self.build)
        if self.kept.exists():
            self.kept.rename(self.src)
        beside = self.marker.with_suffix(".new")
        noted = {"package": package, "bytes": _size(self.path), "installed": digest_of(self.install)}
        beside.write_text(json.dumps(noted), encoding="utf-8")
        beside.replace(self.marker)

    def discard(self) -> None:
        """Leave nothing of a build that did not come to an end."""
        wipe(self.path)

    def give_up(self) -> None:
        """Keep the log of a failed build, and nothing else."""
        wipe(self.src, self.kept, self.build, self.install)

    def begin_again(self) -> None:
        """Room for another run of a build that did not come to an end: no trace of the first one."""
        wipe(self.src, self.build, self.install)
        for folder in (self.build, self.install):
            folder.mkdir()


class Store:
    """All kept builds of this user. Several processes and threads may use one store at once."""

    def __init__(self, root: Path | None = None) -> None:
        self.root = root or cache_dir(os.environ) / "builds"

    def entry(self, key: str) -> Entry:
        return Entry(self.root / key)

    def alike(self, like: str) -> str | None:
        """The key of the entry that was noted last for that likeness; it may be gone."""
        with suppress(OSError, ValueError):
            key = self._like_file(like).read_text(encoding="ascii")
            return key if _KEY.fullmatch(key) else None
        return None

    def note_alike(self, like: str, key: str) -> None:
        """To be found by `alike`. Nothing is wrong when that fails: then it is not found."""
        file = self._like_file(like)
        beside = file.with_name(f"{key}.like.new")
        with suppress(OSError):
            beside.write_text(key, encoding="ascii")
            beside.replace(file)

    @contextmanager
    def locked(self, key: str, interrupt: Interrupt, on_wait: Callable[[], None]) -> Iterator[Entry]:
        """Hold the entry against everyone else; `on_wait` is called once if that takes a while."""
        lock = self._acquire(key, interrupt, on_wait)
        try:
            yield self.entry(key)
        finally:
            os.close(lock)

    def _acquire(self, key: str, interrupt: Interrupt, on_wait: Callable[[], None]) -> int:
        told = False
        while True:
            with storage(self.root):
                self.root.mkdir(parents=True, exist_ok=True)
                lock = self._lock(key)  # opened anew each time: pruning an entry removes its lock file
            if _try(lock) and self._is_current(key, lock):
                return lock
            os.close(lock)
            if not told:
                on_wait()
                told = True
            interrupt.wait(_ASK_AGAIN_SECONDS)

    def prune(self, keep_bytes: int = KEEP_BYTES, in_use_seconds: float = _IN_USE_SECONDS) -> None:
        """Remove what failed or was left half-made, and the longest unused until the rest fits."""
        now = time.time()
        kept = 0
        for used, size, key in sorted(self._entries(), reverse=True):
            kept += size
            spare = not size or kept > keep_bytes
            if spare and now - used > in_use_seconds:
                self._remove(key)
                kept -= size
        self._forget_likes()

    def _forget_likes(self) -> None:
        for file in self.root.glob("*.like"):
            key = self.alike(file.stem)
            if key is None or not self.entry(key).marker.exists():
                file.unlink(missing_ok=True)

    def _entries(self) -> Iterator[tuple[float, int, str]]:
        """Last use, size and key of each entry; the size of an incomplete one is 0."""
        for path in self.root.iterdir():
            if path.is_dir() and _KEY.fullmatch(path.name):
                with suppress(OSError):  # another process may be pruning too
                    marker = Entry(path).marker
                    found = marker if marker.exists() else path
                    yield found.stat().st_mtime, _noted_size(marker), path.name

    def _remove(self, key: str) -> None:
        lock = self._lock(key)
        try:
            if _try(lock):
                # The marker goes first: whoever looks meanwhile sees a half-made entry.
                self.entry(key).marker.unlink(missing_ok=True)
                wipe(self.entry(key).path)
                self._lock_file(key).unlink(missing_ok=True)
        finally:
            os.close(lock)

    def _like_file(self, like: str) -> Path:
        return self.root / f"{like}.like"

    def _lock_file(self, key: str) -> Path:
        return self.root / f"{key}.lock"

    def _lock(self, key: str) -> int:
        return os.open(self._lock_file(key), os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)

    def _is_current(self, key: str, lock: int) -> bool:
        """Whether this is still the lock file that others will open."""
        with suppress(FileNotFoundError):
            return os.path.samestat(os.fstat(lock), self._lock_file(key).stat())
        return False


@contextmanager
def storage(place: Path) -> Iterator[None]:
    """Say in a learner's words what the disk refused."""
    try:
        yield
    except OSError as error:
        raise storage_error(place, error) from error


def storage_error(place: Path, error: OSError) -> CourseError:
    if error.errno in (errno.ENOSPC, errno.EDQUOT):
        return disk_full(place)
    if error.errno in (errno.EMFILE, errno.ENFILE):
        return MissingHere("Too many files are open on this machine.", "Close some programs, then try again.")
    what = f"{error.filename or place}: {error.strerror or error}."
    return StorageError(
        what, "Builds are kept below ROS2COURSE_CACHE: set it to a folder that you may write to."
    )


def disk_full(place: Path) -> StorageError:
    what = f"The disk is full: there is no space left to build in {place}."
    return StorageError(what, "Make some space, then check again. Nothing of yours was lost.")


def _try(lock: int) -> bool:
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    return True


def _size(folder: Path) -> int:
    return sum(file.lstat().st_blocks * 512 for file in folder.rglob("*"))


def _noted_size(marker: Path) -> int:
    try:
        return int(json.loads(marker.read_text(encoding="utf-8"))["bytes"])
    except (OSError, ValueError, KeyError, TypeError):
        return 0
