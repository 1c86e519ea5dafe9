"""The key of a build: the same for the same content, another for any other."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from pathlib import Path

from course.build.sources import source_files

# Goes up when what a build makes of the same sources changes: colcon's options, the layout of an entry.
_FORMAT = "1"


def content_key(folder: Path, home: Path, dependencies: Iterable[str], identity: str) -> str:
    """32 hexadecimal digits that stand for one build of the package in `folder`.

    dependencies: keys of the workspace packages it depends on; identity: that of the ROS in use.
    Goes into it: names, contents and executable bits of all source files. Raises TooMuch.
    """
    digest = hashlib.blake2b(digest_size=16)
    for part in (_FORMAT, identity, *sorted(dependencies)):
        digest.update(part.encode() + b"\0")
    for file in source_files(folder, home):
        content = (
            file.path.read_bytes() if file.link is None else file.link.encode("utf-8", "surrogateescape")
        )
        kind = "link" if file.link is not None else "executable" if file.executable else "file"
        digest.update(f"{file.name}\0{kind}\0{len(content)}\0".encode("utf-8", "surrogateescape") + content)
    return digest.hexdigest()
