"""Files that the course itself wrote into the home: nobody saved them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path


class OwnFiles:
    """Remembers how they were when they were written; once they look different, somebody saved them."""

    def __init__(self, home: Path) -> None:
        self._home = home
        self._known: dict[str, tuple[int, int]] = {}
        self._folders: set[str] = set()

    def wrote(self, files: Iterable[str]) -> None:
        """files: relative to the home, as are the others here. Those that are not there are left out."""
        for file in files:
            if (stamp := self._stamp(file)) is not None:
                self._known[file] = stamp
                self._folders.update(str(folder) for folder in Path(file).parents)

    def without(self, files: Iterable[str]) -> tuple[str, ...]:
        """Those that somebody else wrote."""
        return tuple(file for file in files if not self._is_own(file))

    def _is_own(self, file: str) -> bool:
        if file in self._folders:
            return (self._home / file).is_dir()
        return file in self._known and self._known[file] == self._stamp(file)

    def _stamp(self, file: str) -> tuple[int, int] | None:
        try:
            found = (self._home / file).lstat()
        except OSError:
            return None
        return found.st_mtime_ns, found.st_size
