"""Builds kept by content: one entry for each key, made at its final place and complete or absent.

    ROOT/<key>/src      the copy that was built
    ROOT/<key>/kept     a copy of src during the build, which the build cannot change
    ROOT/<key>/install  colcon's install base; it contains the package's prefix, isolated
    ROOT/<key>/log      what the build printed
    ROOT/<key>/build    while it is built; kept if other builds may resume it, see `cmake_reuse`
    ROOT/<key>/complete written last, by rename: without it, the entry is unfinished and is ignored.
                        It has a digest of what was installed: an entry that differs is built again
    ROOT/<key>.lock     held while the entry is made or removed
    ROOT/<key>.used     held, shared, by everyone who uses the entry: it is not removed meanwhile
    ROOT/<key>.like     the key of an entry whose package differs in its sources alone, see `reuse`
    ROOT/pruned         when the store was last pruned: the age of the file

An entry that is complete is never written to again. Its paths are baked into what was built, so it
cannot move. The age of `complete` says when it was last used.
"""

from __future__ import annotations

import errno
import hashlib
import json
import os
import re
import shutil
import stat
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from course.build.runner import Interrupt
from course.errors import CourseError, MissingHere, StorageError
from course.files import open_lock, try_lock, wipe, write_atomic
from course.rosenv import cache_dir

KEEP_BYTES = 2 * 1024**3
# The log of a failed build is kept this long, for anyone who wants to read it.
_KEEP_FAILURES = 3600.0
# Builds of a class come many at once; what they add meanwhile is bounded by their claims.
_PRUNE_EVERY = 10.0
# flock cannot be waited for together with an Interrupt, so it is asked for again.
_ASK_AGAIN_SECONDS = 0.05

_KEY = re.compile(r"[0-9a-f]{32}")


@dataclass(frozen=True)
class StoreEntry:
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
        if not self._is_intact("installed", self.install):
            return False
        with suppress(OSError):  # a store on a read-only disk is still of use
            os.utime(self.marker)
        return True

    def is_resumable(self) -> bool:
        """Whether its build folder was kept, and is as it was left."""
        return self._is_intact("build", self.build)

    def _is_intact(self, name: str, folder: Path) -> bool:
        try:
            noted = json.loads(self.marker.read_text(encoding="utf-8"))
            return bool(noted[name] == digest_of(folder))
        except (OSError, ValueError, KeyError, TypeError):
            return False

    def begin(self) -> None:
        """Wipe what an earlier try left."""
        wipe(self.path)
        for folder in (self.build, self.install, self.log.parent):
            folder.mkdir(parents=True)

    @property
    def size(self) -> int:
        """Bytes that it takes on the disk, as noted when it was complete; 0 before that."""
        return _noted_size(self.marker)

    def finish(self, package: str, *, keeps_build: bool = False) -> None:
        """Mark as complete, when everything is in place."""
        wipe(self.src, *(() if keeps_build else (self.build,)))
        if self.kept.exists():
            self.kept.rename(self.src)
        noted = {"package": package, "bytes": _size(self.path), "installed": digest_of(self.install)}
        if keeps_build:
            noted["build"] = digest_of(self.build)
        write_atomic(self.marker, json.dumps(noted))

    def discard(self) -> None:
        """Remove everything of a build that did not finish."""
        wipe(self.path)

    def give_up(self) -> None:
        """Keep the log of a failed build, and nothing else."""
        wipe(self.src, self.kept, self.build, self.install)

    def begin_again(self) -> None:
        """Prepare another run of a build that did not finish, with no trace of the first one."""
        wipe(self.src, self.build, self.install)
        for folder in (self.build, self.install):
            folder.mkdir()


class Store:
    """All kept builds of this user. Several processes and threads may use one store at once."""

    def __init__(self, root: Path | None = None, keep_bytes: float = KEEP_BYTES) -> None:
        """keep_bytes: `prune` removes what exceeds this and is not in use."""
        self.root = root or cache_dir(os.environ) / "builds"
        self._keep_bytes = keep_bytes

    def entry(self, key: str) -> StoreEntry:
        return StoreEntry(self.root / key)

    def alike(self, like: str) -> str | None:
        """The key of the entry that was noted last for that likeness; the entry may be gone."""
        with suppress(OSError, ValueError):
            key = self._like_file(like).read_text(encoding="ascii")
            return key if _KEY.fullmatch(key) else None
        return None

    def note_alike(self, like: str, key: str) -> None:
        """Note a key for `alike`. If that fails, nothing is wrong: `alike` does not find it."""
        with suppress(OSError):
            write_atomic(self._like_file(like), key)

    @contextmanager
    def locked(self, key: str, interrupt: Interrupt, on_wait: Callable[[], None]) -> Iterator[StoreEntry]:
        """Lock the entry against everyone else; `on_wait` is called once if that takes a while."""
        lock = self._acquire(self._lock_file(key), interrupt, on_wait)
        try:
            yield self.entry(key)
        finally:
            os.close(lock)

    @contextmanager
    def in_use(self, key: str, interrupt: Interrupt) -> Iterator[None]:
        """Inside this context, nobody removes the entry, whether or not it exists already."""
        try:
            lock = self._acquire(self._use_file(key), interrupt, shared=True)
        except StorageError:  # what cannot be written to cannot be pruned; a build says what is wrong
            yield
            return
        try:
            yield
        finally:
            os.close(lock)

    def _acquire(
        self,
        file: Path,
        interrupt: Interrupt,
        on_wait: Callable[[], None] = lambda: None,
        *,
        shared: bool = False,
    ) -> int:
        told = False
        while True:
            with storage(self.root):
                self.root.mkdir(parents=True, exist_ok=True)
                lock = open_lock(file)  # opened again each time: pruning an entry removes its lock files
            if try_lock(lock, shared=shared) and _is_current(file, lock):
                return lock
            os.close(lock)
            if not told:
                on_wait()
                told = True
            interrupt.wait(_ASK_AGAIN_SECONDS)

    def free(self) -> int:
        """Bytes that can still be written here."""
        return shutil.disk_usage(self.root).free

    def prune_now_and_then(self) -> None:
        """`prune`, unless that was done a moment ago: it looks at every entry, and there may be thousands."""
        done = self.root / "pruned"
        with suppress(FileNotFoundError):
            if abs(time.time() - done.stat().st_mtime) < _PRUNE_EVERY:
                return
        done.touch()
        self.prune()

    def prune(self) -> None:
        """Remove old failures, and the least recently used entries until the rest fits."""
        now = time.time()
        kept = 0
        removed = False
        for used, size, key in sorted(self._entries(), reverse=True):
            # A clock that was set back leaves times in the future.
            spare = kept + size > self._keep_bytes or (not size and abs(now - used) > _KEEP_FAILURES)
            if spare and self._remove(key):
                removed = True
            else:
                kept += size
        if removed:
            self._forget_likes()

    def make_room(self, wanted: int) -> None:
        """Remove entries until `wanted` bytes are free: failures, then the least recently used ones."""
        if self.free() >= wanted:  # nearly always; reading all entries takes a while
            return
        for _, _, key in sorted(self._entries(), key=lambda entry: (entry[1] > 0, entry[0])):
            if self.free() >= wanted:
                break
            with suppress(OSError):  # not even a lock file fits anymore
                self._remove(key)
        self._forget_likes()

    def _forget_likes(self) -> None:
        for file in self.root.glob("*.like"):
            key = self.alike(file.stem)
            if key is None or not self.entry(key).marker.exists():
                file.unlink(missing_ok=True)

    def _entries(self) -> Iterator[tuple[float, int, str]]:
        """Last use, size and key of each entry; the size of an incomplete one is 0."""
        with os.scandir(self.root) as entries:
            folders = [entry for entry in entries if _KEY.fullmatch(entry.name) and entry.is_dir()]
        for folder in folders:
            with suppress(OSError):  # another process may be pruning too
                yield *_noted(folder.path), folder.name

    def _remove(self, key: str) -> bool:
        """Remove an entry; False if somebody is making or using it."""
        files = (self._lock_file(key), self._use_file(key))
        with ExitStack() as stack:
            for file in files:
                lock = open_lock(file)
                stack.callback(os.close, lock)
                if not try_lock(lock):
                    return False
            # The marker goes first: others who look meanwhile see a half-made entry.
            self.entry(key).marker.unlink(missing_ok=True)
            wipe(self.entry(key).path)
            for file in files:
                file.unlink(missing_ok=True)
        return True

    def _like_file(self, like: str) -> Path:
        return self.root / f"{like}.like"

    def _lock_file(self, key: str) -> Path:
        return self.root / f"{key}.lock"

    def _use_file(self, key: str) -> Path:
        return self.root / f"{key}.used"


class DiskFull(StorageError):
    """There was no space left to build."""


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
        what, "Builds are kept in ROS2COURSE_CACHE: set it to a folder that you may write to."
    )


def disk_full(place: Path) -> DiskFull:
    what = f"The disk is full: there is no space left to build in {place}."
    return DiskFull(what, "Free some space, then check again. None of your work was lost.")


def _is_current(file: Path, lock: int) -> bool:
    """Whether others will open this same lock file."""
    with suppress(FileNotFoundError):
        return os.path.samestat(os.fstat(lock), file.stat())
    return False


def _size(folder: Path) -> int:
    return sum(file.lstat().st_blocks * 512 for file in folder.rglob("*"))


def _noted_size(marker: Path) -> int:
    try:
        return int(json.loads(marker.read_text(encoding="utf-8"))["bytes"])
    except (OSError, ValueError, KeyError, TypeError):
        return 0


def _noted(folder: str) -> tuple[float, int]:
    """When the entry in `folder` was last used, and its size. Called for every entry after each build."""
    marker = f"{folder}/complete"
    try:
        return os.stat(marker).st_mtime, _noted_size(Path(marker))  # noqa: PTH116 - see above
    except FileNotFoundError:
        return os.stat(folder).st_mtime, 0  # noqa: PTH116


def digest_of(top: Path) -> str:
    """32 hexadecimal digits of the names, modes and contents of everything below `top`; links by target.

    Raises OSError if something cannot be read.
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
