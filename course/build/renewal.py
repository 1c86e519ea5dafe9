"""A build from an earlier one of a package that differs in what its modules say, and in nothing else.

Nearly every build is one after a line was changed in a module. colcon asks setup.py three times, and all that
comes of it is a copy of that module. So where a package's build is known to do no more than that (see
`plain`), the entry of a package like it is copied, and the changed modules are put in their places.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from course.build.job import Job
from course.build.key import content_key, is_module, likeness_key
from course.build.plain import is_plain
from course.build.sources import source_files
from course.build.store import Entry
from course.rosenv.files import wipe


def likeness(job: Job, entry: Entry) -> str | None:
    """What `entry.kept` has in common with packages like it; None if its build may do anything."""
    if job.package.build_type != "ament_python":
        return None
    files = source_files(entry.kept, entry.kept)
    if any(file.link is not None for file in files) or not is_plain(
        entry.kept, (file.name for file in files)
    ):
        return None
    return likeness_key(entry.kept, entry.kept, job.needed, job.ros.identity)


def renewed(job: Job, entry: Entry, like: str) -> bool:
    """Fills `entry.install` from a package like the one in `entry.kept`, if there is one; else all stays."""
    key = job.store.alike(like)
    earlier = job.store.entry(key) if key else None
    try:
        if key is None or earlier is None or not _is_sound(job, earlier, key):
            return False
        changes = _changes(earlier, entry)
        if changes is None:
            return False
        _copy(earlier.install, entry.install, _Move(key.encode(), job.key.encode()), changes)
        log = earlier.log.read_bytes().replace(key.encode(), job.key.encode())
        entry.log.write_bytes(log)
    except OSError:  # it is being removed, or the disk is full: the build itself will tell
        wipe(entry.install)
        entry.install.mkdir()
        return False
    return True


def _is_sound(job: Job, earlier: Entry, key: str) -> bool:
    """Its sources are what it was built from, and what it installed is what was built."""
    return (
        earlier.is_complete() and content_key(earlier.src, earlier.src, job.needed, job.ros.identity) == key
    )


@dataclass(frozen=True)
class _Move:
    """A build has the path of its entry written into some files; keys are equally long."""

    old: bytes
    new: bytes


def _changes(earlier: Entry, entry: Entry) -> dict[str, bytes] | None:
    """New contents of installed files, by their names; None when it cannot be told which they are."""
    before, after = _modules(earlier.src), _modules(entry.kept)
    changed = {name for name in before if before[name] != after[name]}
    suspects = {PurePosixPath(name).name for name in changed}
    changes: dict[str, bytes] = {}
    for file in _files(earlier.install):
        if file.is_symlink():  # whatever made that, it was none of what is known here
            return None
        if file.name not in suspects:
            continue
        name = file.relative_to(earlier.install).as_posix()
        sources = _sources(name, file.read_bytes(), before)
        contents = {after[source] for source in sources}
        if len(contents) != 1:
            return None
        changes[name] = contents.pop()
    return changes


def _modules(folder: Path) -> dict[str, bytes]:
    return {file.name: file.path.read_bytes() for file in source_files(folder, folder) if is_module(file)}


def _sources(installed: str, content: bytes, modules: dict[str, bytes]) -> list[str]:
    """Modules that the installed file may be a copy of: the one at the end of its path, if it is there."""
    base = PurePosixPath(installed).name
    possible = [name for name in modules if modules[name] == content and PurePosixPath(name).name == base]
    exact = [name for name in possible if installed.endswith(f"/{name}")]
    return exact or possible


def _copy(old: Path, new: Path, move: _Move, changes: dict[str, bytes]) -> None:
    compiled = {_compiled(name) for name in changes}
    for folder, _, _ in os.walk(old):
        (new / Path(folder).relative_to(old)).mkdir(exist_ok=True)
    for file in _files(old):
        name = file.relative_to(old).as_posix()
        if _without_tag(name) in compiled:
            continue  # Python compiles the module when it is imported
        target = new / name
        if name in changes:
            target.write_bytes(changes[name])
            shutil.copymode(file, target)
        else:
            target.write_bytes(file.read_bytes().replace(move.old, move.new))
            shutil.copystat(file, target)  # what is compiled counts by the age of its module


def _compiled(module: str) -> str:
    path = PurePosixPath(module)
    return str(path.parent / "__pycache__" / path.stem)


def _without_tag(name: str) -> str:
    """`.../__pycache__/node` of `.../__pycache__/node.cpython-312.pyc`."""
    path = PurePosixPath(name)
    return str(path.parent / path.name.split(".")[0]) if path.suffix == ".pyc" else name


def _files(top: Path) -> Iterable[Path]:
    for folder, _, files in os.walk(top):
        for name in files:
            yield Path(folder, name)
