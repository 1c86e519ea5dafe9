"""What a package.xml declares, read from the learner's file."""

from __future__ import annotations

from dataclasses import dataclass
from xml.etree import ElementTree

from course.evidence.sources import Sources
from course.feedback import Location


@dataclass(frozen=True)
class Manifest:
    """The tags of a package.xml with their texts, in order. where: the file.

    format: the number in `<package format="3">`. build_type: what its export names.
    """

    where: Location
    tags: tuple[tuple[str, str], ...]
    text: str
    format: str = "1"
    build_type: str | None = None

    def values(self, *tags: str) -> tuple[str, ...]:
        """Texts of all elements with one of these tags."""
        return tuple(value for tag, value in self.tags if tag in tags)

    def depends(self, name: str, *tags: str) -> bool:
        """Whether one of these tags names the package."""
        return name in self.values(*tags)

    def place_of(self, text: str) -> Location | None:
        """The first line of the file that holds an element with this text, or else the text at all."""
        lines = self.text.splitlines()
        for wanted in (f">{text}<", text):
            for number, line in enumerate(lines, start=1):
                if wanted in line:
                    return Location(self.where.file, number)
        return None


def manifest(sources: Sources, package_folder: str) -> Manifest | None:
    """The manifest of the package in this folder; None when it is missing or not XML."""
    file = f"{package_folder}/package.xml"
    text = sources.files.get(file)
    if text is None:
        return None
    try:
        root = ElementTree.fromstring(text)
    except (ElementTree.ParseError, ValueError):
        return None
    tags = tuple((child.tag, (child.text or "").strip()) for child in root)
    build_type = (root.findtext("export/build_type") or "").strip() or None
    return Manifest(Location(file), tags, text, root.get("format", "1"), build_type)


RUN_TAGS = ("depend", "exec_depend")
