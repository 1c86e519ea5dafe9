"""A failed build as evidence: what it printed, what was built, and what it could have used."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from course.evidence.sources import Sources, read_sources
from course.explain.engine import Evidence, Place, Symptom, Words
from course.explain.package_xml import Manifest
from course.model.feedback import Location

_COLOR = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]|\x1b\][^\x07\x1b\n]*\x07")
_ENTRY = r"/[0-9a-f]{32}/"
# How much of a log is searched, in bytes and characters, because a build can print endlessly.
_MOST_TEXT = 256 * 1024
_LONGEST_LINE = 2000


@dataclass(frozen=True, kw_only=True)
class Build(Evidence):
    """A failed build of the package `name`.

    copy: the folder that was built, a copy of the learner's own `folder`. lines: the output, with the
    learner's paths. neighbors: the other packages in the workspace, with their folders in the home.
    prefixes: the folders of the installed packages that the build could use. ask_setup_py: runs `setup.py
    --name` on the copy and returns its output, also with the learner's paths.
    """

    name: str
    build_type: str
    manifest: Manifest | None
    copy: Path
    lines: tuple[str, ...]
    neighbors: Mapping[str, str]
    prefixes: tuple[Path, ...]
    ask_setup_py: Callable[[], tuple[str, ...]]

    @property
    def words(self) -> Words:
        return {"package": self.name, "type": self.build_type}

    @cached_property
    def known_packages(self) -> frozenset[str]:
        """Names of all packages that this one could depend on."""
        indices = [prefix / "share/ament_index/resource_index/packages" for prefix in self.prefixes]
        installed = {file.name for index in indices if index.is_dir() for file in index.iterdir()}
        return frozenset(installed | set(self.neighbors)) - {self.name}

    def packages_with(self, message: str) -> list[str]:
        """Names of the packages that have a message type of that name."""
        return sorted(
            {file.parts[-3] for top in self.prefixes for file in top.glob(f"share/*/msg/{message}.msg")}
        )

    def depends_on(self, name: str) -> bool:
        """Whether package.xml declares `name` as a dependency for building or running."""
        return any(one.name == name for one in self.manifest.dependencies) if self.manifest else False


def read_copy(copy: Path, folder: str) -> Sources:
    """The files of a copy, with the paths that the learner knows."""
    found = read_sources(copy, ("",))
    return Sources(
        {f"{folder}/{name}": text for name, text in found.files.items()},
        tuple(f"{folder}/{name}" for name in found.others),
    )


def tag(name: str) -> Place[Build]:
    """The line of a tag in package.xml; the whole file if it has none."""

    def place(build: Build, symptom: Symptom, words: Words) -> Location:
        return build.place("package.xml", build.manifest.lines.get(name) if build.manifest else None)

    return place


def last_dependency(build: Build, symptom: Symptom, words: Words) -> Location | None:
    """Where a new dependency belongs in package.xml: at the last existing one."""
    lines = [one.line for one in build.manifest.dependencies] if build.manifest else []
    return build.place("package.xml", lines[-1]) if lines else tag("export")(build, symptom, words)


def log_text(file: Path) -> str:
    """The output of a build; if it is very long, only the beginning and the end."""
    size = file.stat().st_size
    with file.open("rb") as opened:
        text = opened.read(_MOST_TEXT).decode("utf-8", errors="replace")
        if size > _MOST_TEXT:
            opened.seek(max(_MOST_TEXT, size - _MOST_TEXT))
            text = f"{text}\n{opened.read().decode('utf-8', errors='replace')}"
    return text


def readable(text: str, store: Path, copy: Path, source: str) -> tuple[str, ...]:
    """The lines of a log without colors, and with the learner's paths instead of the store's."""
    text = _COLOR.sub("", text).replace("\r\n", "\n")
    for top in {str(store), str(store.resolve())}:
        text = text.replace(f"{top}/{copy.parent.name}/src/", f"{source}/")
        text = text.replace(f"{top}/{copy.parent.name}/src", source)
        text = re.sub(re.escape(top) + _ENTRY, "", text)
    return tuple(line[:_LONGEST_LINE] for line in text.splitlines())
