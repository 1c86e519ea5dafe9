"""The keys of a build: the same for the same content, another for any other."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable
from pathlib import Path

from course.build.sources import SourceFile, source_files

# Goes up when what a build makes of the same sources changes: colcon's options, the layout of an entry.
_FORMAT = "1"


def content_key(folder: Path, home: Path, dependencies: Iterable[str], identity: str) -> str:
    """32 hexadecimal digits that stand for one build of the package in `folder`.

    dependencies: keys of the workspace packages it depends on; identity: that of the ROS in use.
    Goes into it: names, contents and executable bits of all source files. Raises TooMuch.
    """
    return _key((_FORMAT, identity, *sorted(dependencies)), source_files(folder, home), _content)


def likeness_key(folder: Path, home: Path, dependencies: Iterable[str], identity: str) -> str:
    """The same for packages that differ in nothing but what their Python modules say, setup.py excepted."""

    def content(file: SourceFile) -> bytes:
        return b"" if is_module(file) else _content(file)

    return _key(("like", _FORMAT, identity, *sorted(dependencies)), source_files(folder, home), content)


def is_module(file: SourceFile) -> bool:
    """Whether the file is Python that a build copies, and does not run."""
    return file.link is None and file.name.endswith(".py") and file.name != "setup.py"


def _key(parts: Iterable[str], files: Iterable[SourceFile], content: Callable[[SourceFile], bytes]) -> str:
    digest = hashlib.blake2b(digest_size=16)
    for part in parts:
        digest.update(part.encode() + b"\0")
    for file in files:
        data = content(file)
        kind = "link" if file.link is not None else "executable" if file.executable else "file"
        digest.update(f"{file.name}\0{kind}\0{len(data)}\0".encode("utf-8", "surrogateescape") + data)
    return digest.hexdigest()


def _content(file: SourceFile) -> bytes:
    return file.path.read_bytes() if file.link is None else file.link.encode("utf-8", "surrogateescape")
