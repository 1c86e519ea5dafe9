"""Files that others may use at the same time: written completely or not at all, locked, and removed for good.

Also the cache folder, for files that the course can make again.
"""

from __future__ import annotations

import contextlib
import fcntl
import os
import re
import secrets
import subprocess
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from course.errors import StorageError

# `.NAME.PID-RANDOM` plus this names a file that is being written, or that a killed process left unfinished.
PART = ".ros2course-part"
_PART = re.compile(rf"\..+\.(?P<pid>\d+)-[0-9a-f]+{re.escape(PART)}")
_REMOVE, _OPEN = ("/bin/rm", "-rf"), ("/bin/chmod", "-R", "u+rwx")


@contextlib.contextmanager
def unfinished(target: Path) -> Iterator[Path]:
    """A path next to `target` for a file that is being written; removed afterwards, whatever happens."""
    part = _part_of(target)
    try:
        yield part
    finally:
        part.unlink(missing_ok=True)


@contextlib.contextmanager
def replacing(target: Path) -> Iterator[Path]:
    """A path for a file that replaces `target` at the end, in one step; after an error `target` is unchanged.

    Readers see all of the old or all of the new content. A link at `target` is replaced, not followed.
    """
    target.parent.mkdir(parents=True, exist_ok=True)
    with unfinished(target) as part:
        yield part
        part.replace(target)


@contextlib.contextmanager
def new_folder(target: Path) -> Iterator[Path]:
    """A folder that is renamed to `target` at the end, or removed if there was an error."""
    sweep(target.parent)
    part = _part_of(target)
    part.mkdir(parents=True)
    try:
        yield part
        part.rename(target)
    except BaseException:
        wipe(part)
        raise


def _part_of(target: Path) -> Path:
    return target.with_name(f".{target.name[:40]}.{os.getpid()}-{secrets.token_hex(4)}{PART}")


def sweep(folder: Path) -> None:
    """Remove the unfinished files that killed processes left in `folder`. Raises OSError."""
    for left in folder.glob(f".*{PART}"):
        found = _PART.fullmatch(left.name)
        if found and not Path("/proc", found["pid"]).exists():
            wipe(left)


def write_atomic(path: Path, text: str) -> bool:
    """Give `path` the content `text` in one step; True if that changed anything.

    A hard link elsewhere (pip's or uv's cache) keeps the old text. The mode is kept.
    """
    data = text.encode("utf-8", "surrogateescape")
    with contextlib.suppress(FileNotFoundError):
        if path.read_bytes() == data:
            return False
    with replacing(path) as part:
        part.write_bytes(data)
        with contextlib.suppress(FileNotFoundError):
            part.chmod(path.stat().st_mode & 0o7777)
    return True


def write_pieces(target: Path, pieces: Iterable[str | bytes]) -> None:
    """Write `target` from pieces that come one by one. Raises StorageError; then the old file remains."""
    try:
        with replacing(target) as part:
            with part.open("wb") as stream:
                stream.writelines(
                    piece.encode("utf-8") if isinstance(piece, str) else piece for piece in pieces
                )
            to_disk(part)
    except OSError as error:
        what = f"{target} cannot be written: {error.strerror or error}."
        raise StorageError(what, "Make sure that there is space and that you may write there.") from error


def to_disk(file: Path) -> None:
    """Flush the file to the disk, so that it is not empty after a power failure."""
    descriptor = os.open(file, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def link(place: Path, target: Path) -> None:
    """Make `place` a link to `target`; readers always see the old link or the new one."""
    with replacing(place) as part:
        part.symlink_to(target)


@contextlib.contextmanager
def locked(path: Path, *, shared: bool = False, wait: bool = True) -> Iterator[int]:
    """Hold a lock on the file `path`, exclusively or `shared`; if the process dies, the lock is released.

    Yields the descriptor: a child that inherits it holds the lock, too. On a disk without locks, such as some
    network disks, nothing is locked. Raises OSError; without `wait`, BlockingIOError if the lock is taken.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    descriptor = open_lock(path)
    try:
        if wait:
            with contextlib.suppress(OSError):
                fcntl.flock(descriptor, _kind(shared))
        elif not try_lock(descriptor, shared=shared):
            raise BlockingIOError(f"{path} is held by somebody else")
        yield descriptor
    finally:
        os.close(descriptor)


def open_lock(path: Path) -> int:
    """Open the lock file without taking the lock. Close the descriptor to release it. Raises OSError."""
    return os.open(path, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW | os.O_CLOEXEC, 0o666)


def try_lock(descriptor: int, *, shared: bool = False) -> bool:
    """Take the lock, unless somebody else has it. Return whether it was taken."""
    try:
        fcntl.flock(descriptor, _kind(shared) | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:  # no locks here
        pass
    return True


def _kind(shared: bool) -> int:
    return fcntl.LOCK_SH if shared else fcntl.LOCK_EX


def wipe(*paths: Path) -> None:
    """Remove files, links and trees, as far as possible. Paths that do not exist are ignored.

    Not shutil: it cannot remove a thousand nested folders, which a submission may leave. Folders without
    permissions keep out everyone but root, so they get permissions before the second try.
    """
    for command in (_REMOVE, _OPEN, _REMOVE):
        # chmod would follow a link and change its target.
        chosen = [path for path in paths if command is not _OPEN or not path.is_symlink()]
        done = subprocess.run([*command, "--", *map(str, chosen)], check=False, capture_output=True)
        if command == _REMOVE and done.returncode == 0:
            return


def cache_dir(environ: Mapping[str, str]) -> Path:
    """$ROS2COURSE_CACHE, else $XDG_CACHE_HOME/ros2course, else ~/.cache/ros2course; it may not exist yet."""
    if own := environ.get("ROS2COURSE_CACHE"):
        return Path(own).absolute()
    # The XDG specification says to ignore a relative path.
    xdg = Path(environ.get("XDG_CACHE_HOME", ""))
    if xdg.is_absolute():
        return xdg / "ros2course"
    home = environ.get("HOME")
    return (Path(home) if home else Path.home()) / ".cache" / "ros2course"
