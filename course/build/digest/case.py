"""One failed build as the digests see it: what was printed, what was built, and who may be asked."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

from course.build.outcome import BuildFailure
from course.build.sources import within
from course.build.workspace import Package, Workspace
from course.feedback import Feedback, Location

_COLOUR = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]|\x1b\][^\x07\x1b\n]*\x07")
_ENTRY = r"/[0-9a-f]{32}/"
MOST_DETAILS = 6
# What is looked for a cause in, in bytes and characters: a build prints what it likes.
_MOST_TEXT = 256 * 1024
_LONGEST_LINE = 2000


@dataclass(frozen=True)
class Case:
    """A build that did not work.

    source: the copy that was built; lines: what was printed, with the learner's paths in it.
    prefixes: where the packages lie that the build could use.
    ask_setup_py: runs `setup.py --name` on the copy; what it prints, likewise.
    """

    package: Package
    workspace: Workspace
    source: Path
    lines: tuple[str, ...]
    log: Path
    prefixes: tuple[Path, ...]
    ask_setup_py: Callable[[], tuple[str, ...]]

    def known_packages(self) -> frozenset[str]:
        """Names of all packages that this one could depend on."""
        indices = [prefix / "share/ament_index/resource_index/packages" for prefix in self.prefixes]
        installed = {file.name for index in indices if index.is_dir() for file in index.iterdir()}
        return frozenset(installed | {package.name for package in self.workspace.packages}) - {
            self.package.name
        }

    def packages_with(self, message: str) -> list[str]:
        """Names of the packages that have a message of that name."""
        return sorted(
            {file.parts[-3] for top in self.prefixes for file in top.glob(f"share/*/msg/{message}.msg")}
        )

    def place(self, file: str, line: int | None = None) -> Location:
        """`file` is relative to the package."""
        return Location(f"{self.package.source}/{file}", line)

    def text(self, file: str) -> str:
        """The content of a file of the package, empty if there is none; of a huge one, how it begins."""
        path = self._own(file)
        return _beginning(path) if path else ""

    def _own(self, file: str) -> Path | None:
        """A log names what it likes, and a link leads anywhere: only what lies in the package counts."""
        path = within(self.source / file, self.source.resolve()) if "\0" not in file else None
        return path if path and path.is_file() else None

    def line_of(self, file: str, pattern: str) -> int | None:
        """The first line of `file` that matches the pattern anywhere."""
        return line_matching(self.text(file), pattern)

    def at(self, file: str, line: int | None) -> tuple[str, ...]:
        """That line of the file, to be shown; nothing without a line."""
        lines = self.text(file).splitlines()
        return (lines[line - 1].strip(),) if line and line <= len(lines) else ()

    def own_file(self, shown: str) -> str | None:
        """A path from the log, relative to the package; None for files of others."""
        relative = shown.removeprefix(f"{self.package.source}/")
        return relative if not relative.startswith("/") and self._own(relative) else None

    def failure(
        self,
        kind: str,
        summary: str,
        *,
        where: Iterable[Location] = (),
        advice: str | None = None,
        details: Iterable[str] = (),
        expected: str | None = None,
        seen: str | None = None,
    ) -> BuildFailure:
        lines = tuple(line.rstrip() for line in details if line.strip())[:MOST_DETAILS]
        feedback = Feedback(summary, expected, seen, tuple(dict.fromkeys(where)), advice, lines)
        return BuildFailure(self.package.name, kind, feedback, self.log)


def line_matching(text: str, pattern: str) -> int | None:
    lines = enumerate(text.splitlines(), 1)
    return next((number for number, line in lines if re.search(pattern, line)), None)


def _beginning(path: Path) -> str:
    with path.open("rb") as file:
        return file.read(_MOST_TEXT).decode("utf-8", errors="replace")


def log_text(file: Path) -> str:
    """What a build printed; of very much, the beginning and the end."""
    size = file.stat().st_size
    text = _beginning(file)
    if size > _MOST_TEXT:
        with file.open("rb") as opened:
            opened.seek(max(_MOST_TEXT, size - _MOST_TEXT))
            text = f"{text}\n{opened.read().decode('utf-8', errors='replace')}"
    return text


def readable(text: str, store: Path, copy: Path, source: str) -> tuple[str, ...]:
    """The lines of a log, with the learner's paths instead of the store's, and without colours."""
    text = _COLOUR.sub("", text).replace("\r\n", "\n")
    for top in {str(store), str(store.resolve())}:
        text = text.replace(f"{top}/{copy.parent.name}/src/", f"{source}/")
        text = text.replace(f"{top}/{copy.parent.name}/src", source)
        text = re.sub(re.escape(top) + _ENTRY, "", text)
    return tuple(line[:_LONGEST_LINE] for line in text.splitlines())
