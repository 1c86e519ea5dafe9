"""Reads package.xml: quickly and with line numbers here, strictly with catkin_pkg before a build.

colcon itself reads package.xml with catkin_pkg, so that verdict counts. But importing it takes longer than
everything else in a check with nothing to build, and it has no line numbers.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from xml.parsers import expat

from course.evidence.sources import Sources
from course.model import replace
from course.model.feedback import Location
from course.spelling import close_names

# The tags for packages needed to build or run this one.
_DEPEND_TAGS = frozenset(
    f"{kind}depend"
    for kind in ("", "build_", "buildtool_", "build_export_", "buildtool_export_", "exec_", "run_")
)
# The tags for packages needed to run it.
RUN_TAGS = ("depend", "exec_depend")

_MOST_DEPTH = 40
_MOST_TAGS = 2000
# Each pair of nested brackets doubles the time to evaluate them.
_LONGEST_CONDITION, _MOST_BRACKETS = 300, 4


@dataclass(frozen=True)
class Dependency:
    """One dependency tag: the name of the package, the tag's name and its line."""

    name: str
    tag: str
    line: int


@dataclass(frozen=True)
class ManifestFault:
    """What is wrong with a package.xml: one sentence, the line if known, and what to do."""

    what: str
    line: int | None
    advice: str


@dataclass(frozen=True)
class Manifest:
    """The content of a package.xml.

    name: empty if it has none. format: the number in `<package format="3">`.
    dependencies: the packages needed to build or run this one, unless a tag's condition is false.
    tags: all tags below <package> with their texts, in order. lines: where each tag first occurs.
    file: its path, as requested; text: the whole text of the file.
    """

    name: str
    build_type: str | None
    dependencies: tuple[Dependency, ...]
    groups: tuple[str, ...]
    lines: Mapping[str, int]
    format: str = "1"
    tags: tuple[tuple[str, str], ...] = ()
    file: str = "package.xml"
    text: str = ""

    @property
    def where(self) -> Location:
        return Location(self.file)

    def values(self, *tags: str) -> tuple[str, ...]:
        """Return the texts of all elements with one of these tags."""
        return tuple(value for tag, value in self.tags if tag in tags)

    def depends(self, name: str, *tags: str) -> bool:
        """Whether one of these tags names the package."""
        return name in self.values(*tags)

    def place_of(self, text: str) -> Location | None:
        """Return the first line with an element with this text, else with this text anywhere, else None."""
        lines = self.text.splitlines()
        for wanted in (f">{text}<", text):
            for number, line in enumerate(lines, start=1):
                if wanted in line:
                    return Location(self.file, number)
        return None


def manifest(sources: Sources, folder: str) -> Manifest | None:
    """The manifest of the package in this folder of the home; None if it is missing or not XML."""
    file = f"{folder}/package.xml"
    text = sources.files.get(file)
    data = None if text is None else text.encode("utf-8", errors="surrogatepass")
    found = _parsed(data, "utf-8") if data is not None else None
    return replace(found, file=file, text=text or "") if isinstance(found, Manifest) else None


def read_manifest(data: bytes) -> Manifest | ManifestFault:
    """The manifest in `data`, or what is wrong with it; it must have exactly one name."""
    found = _parsed(data)
    if isinstance(found, ManifestFault):
        return found
    names = [name for name in found.values("name") if name]
    return found if len(names) == 1 else _name_fault(found.lines, len(names))


def _parsed(data: bytes, encoding: str | None = None) -> Manifest | ManifestFault:
    """encoding: the one to use, whatever the file itself declares."""
    reader = _Reader()
    try:
        reader.read(data, encoding)
    except expat.ExpatError as error:
        return _not_well_formed(reader, error)
    except _Refused as refused:
        return refused.fault
    except (ValueError, LookupError):  # an encoding unknown to expat or Python
        advice = 'Save it as UTF-8, and begin it with `<?xml version="1.0"?>`.'
        return ManifestFault("its encoding cannot be read", 1, advice)
    return _manifest(reader)


def name_in(data: bytes) -> str | None:
    """The package's name, even if other tags are wrong; does not evaluate conditions, which takes time."""
    reader = _Reader()
    try:
        reader.read(data, None)
    except (expat.ExpatError, _Refused, ValueError, LookupError):
        return guessed_name(data)
    return next((text for path, text, *_ in reader.elements if path[1:] == ("name",)), None)


def guessed_name(data: bytes) -> str | None:
    """The package's name in an unreadable package.xml, if it can be guessed."""
    found = re.search(rb"<name>\s*([\w-]+)\s*</", data)
    return found.group(1).decode() if found else None


def strict_fault(file: Path) -> ManifestFault | None:
    """What catkin_pkg, and therefore colcon, rejects in this package.xml."""
    from catkin_pkg.package import InvalidPackage, parse_package  # slow to import: only before a build

    try:
        parse_package(str(file), warnings=[])
    except InvalidPackage as error:
        message = str(getattr(error, "msg", error))
    except (ValueError, AssertionError) as error:  # a format="..." that is not a known number
        message = str(error)
    else:
        return None
    read = read_manifest(file.read_bytes())
    return _in_words(message, read.lines if isinstance(read, Manifest) else {})


class _Refused(Exception):
    """Well-formed XML that no person would write."""

    def __init__(self, fault: ManifestFault) -> None:
        super().__init__(fault.what)
        self.fault = fault


@dataclass
class _Reader:
    """Collects each element: its path of tags, its text, line and attributes."""

    elements: list[tuple[tuple[str, ...], str, int, dict[str, str]]] = field(default_factory=list)
    lines: dict[str, int] = field(default_factory=dict)
    open_tags: list[tuple[str, int, dict[str, str], list[str]]] = field(default_factory=list)

    def read(self, data: bytes, encoding: str | None) -> None:
        self._tags = 0
        self._parser = expat.ParserCreate(encoding)
        self._parser.StartElementHandler = self._start
        self._parser.EndElementHandler = self._end
        self._parser.CharacterDataHandler = self._text
        self._parser.EntityDeclHandler = self._entity
        self._parser.Parse(data, True)

    def _entity(self, name: str, *_: object) -> None:
        """Refuse entities: a few of them can expand to gigabytes, or to files on this machine."""
        what = f"it defines its own entity, `{name[:40]}`"
        raise _Refused(
            ManifestFault(what, self._parser.CurrentLineNumber, "Write out the text that it stands for.")
        )

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        line = self._parser.CurrentLineNumber
        if len(self.open_tags) >= _MOST_DEPTH:
            advice = "Close each tag before the next one begins."
            raise _Refused(ManifestFault(f"its tags are nested {_MOST_DEPTH} deep", line, advice))
        self._tags += 1
        if self._tags > _MOST_TAGS:
            advice = "Keep only the tags that the package needs: usually about a dozen."
            raise _Refused(ManifestFault(f"it has more than {_MOST_TAGS} tags", line, advice))
        self.lines.setdefault(tag, line)
        self.open_tags.append((tag, line, attributes, []))

    def _text(self, text: str) -> None:
        if self.open_tags:
            self.open_tags[-1][3].append(text)

    def _end(self, tag: str) -> None:
        path = tuple(name for name, *_ in self.open_tags)
        _, line, attributes, text = self.open_tags.pop()
        self.elements.append((path, "".join(text).strip(), line, attributes))


def _manifest(reader: _Reader) -> Manifest:
    dependencies = []
    groups = []
    build_type = None
    for path, text, line, attributes in reader.elements:
        if path == ("package", "export", "build_type") and _holds(attributes):
            build_type = text
        elif len(path) == 2 and path[1] in _DEPEND_TAGS and _holds(attributes):
            dependencies.append(Dependency(text, path[1], line))
        elif path == ("package", "member_of_group") and _holds(attributes):
            groups.append(text)
    tags = tuple((path[1], text) for path, text, *_ in reader.elements if len(path) == 2)
    name = next((text for tag, text in tags if tag == "name" and text), "")
    outer = next((attributes for path, *_, attributes in reader.elements if len(path) == 1), {})
    return Manifest(
        name, build_type, tuple(dependencies), tuple(groups), reader.lines, outer.get("format", "1"), tags
    )


def _holds(attributes: dict[str, str]) -> bool:
    condition = attributes.get("condition")
    if condition is None or len(condition) > _LONGEST_CONDITION or condition.count("(") > _MOST_BRACKETS:
        return True
    from catkin_pkg.condition import evaluate_condition  # conditions are rare, and its import is slow

    context = {"ROS_VERSION": "2", "ROS_DISTRO": "jazzy", "ROS_PYTHON_VERSION": "3"}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # it uses pyparsing's old names
        try:
            return bool(evaluate_condition(condition, context))
        except ValueError:
            return True  # invalid: `strict_fault` reports it before a build


def _not_well_formed(reader: _Reader, error: expat.ExpatError) -> ManifestFault:
    reason = expat.errors.messages[error.code]
    advice = "Every `<tag>` needs a matching `</tag>`, in the right order."
    if reader.open_tags and reason in (
        expat.errors.XML_ERROR_TAG_MISMATCH,
        expat.errors.XML_ERROR_NO_ELEMENTS,
    ):
        tag, line, *_ = reader.open_tags[-1]
        return ManifestFault(f"the <{tag}> on line {line} is never closed", line, advice)
    if reason == expat.errors.XML_ERROR_NO_ELEMENTS:
        return ManifestFault("it is empty", None, "Copy one from another package and change the name.")
    return ManifestFault(f"line {error.lineno} is not valid XML ({reason})", error.lineno, advice)


def _name_fault(lines: Mapping[str, int], count: int) -> ManifestFault:
    if count > 1:
        return ManifestFault("it has more than one <name>", lines.get("name"), "Keep one.")
    what = "its <name> is empty" if "name" in lines else "it has no <name>"
    return ManifestFault(what, lines.get("name"), "Write the package's name: `<name>my_package</name>`.")


def _in_words(message: str, lines: Mapping[str, int]) -> ManifestFault:
    message = message.removeprefix("Error(s):\n- ")
    first = message.strip().splitlines()[0]
    if "package.xml format version" in first or "invalid literal for int()" in first:
        return ManifestFault(
            "its format does not exist", lines.get("package"), 'Write `<package format="3">`.'
        )
    if found := re.search(r'exactly one "(\w+)" tag', first):
        return _count_fault(found.group(1), lines)
    if "at least one maintainer" in first:
        return _count_fault("maintainer", lines)
    if 'at least one "license" tag' in first:
        return _count_fault("license", lines)
    if found := re.search(r"following tags: (.+)$", first):
        return _unknown_tag(found.group(1).split(", ")[0], lines)
    tag = next(
        (name for name in re.findall(r"\w+", first.lower()) if name in lines and name != "package"), None
    )
    return ManifestFault(first.rstrip("."), lines.get(tag or "package"), "Fix that line, then check again.")


_EXAMPLES = {
    "name": "<name>my_package</name>",
    "version": "<version>0.0.0</version>",
    "description": "<description>What the package is for</description>",
    "maintainer": '<maintainer email="you@example.com">Your Name</maintainer>',
    "license": "<license>MIT</license>",
}


def _count_fault(tag: str, lines: Mapping[str, int]) -> ManifestFault:
    if tag in lines:
        return ManifestFault(f"it must have exactly one <{tag}>", lines[tag], "Keep one of them.")
    advice = f"Add a line such as `{_EXAMPLES.get(tag, f'<{tag}>...</{tag}>')}` below `<package>`."
    return ManifestFault(f"it has no <{tag}>", lines.get("package"), advice)


def _unknown_tag(tag: str, lines: Mapping[str, int]) -> ManifestFault:
    known = [
        *_DEPEND_TAGS,
        "test_depend",
        "doc_depend",
        "group_depend",
        "member_of_group",
        "export",
        *_EXAMPLES,
    ]
    near = close_names(tag, known, 1)
    advice = f"Did you mean `<{near[0]}>`?" if near else "Remove it, or move it into `<export>`."
    return ManifestFault(f"there is no tag called <{tag}>", lines.get(tag), advice)
