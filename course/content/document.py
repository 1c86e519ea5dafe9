"""Parsed YAML files with their line numbers, so that an error can point at a line."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from course.errors import ContentError

try:
    from yaml import CSafeLoader as Loader
except ImportError:  # PyYAML built without libyaml: the same result, but slower
    from yaml import SafeLoader as Loader  # type: ignore[assignment]

Place = tuple[int | str, ...]

# What PyYAML raises for text that it cannot convert: a date like 2026-13-40, `!!int ""`, `!!bool x`,
# a number of four hundred digits in base 60, deeply nested brackets.
NOT_YAML = (yaml.YAMLError, ValueError, ArithmeticError, LookupError, AttributeError, RecursionError)


@dataclass(frozen=True)
class Document:
    """A parsed file. data: plain YAML data. repeated: errors about keys that occur twice in a mapping."""

    file: Path
    data: Any
    repeated: tuple[ContentError, ...]
    root: yaml.Node | None

    def line(self, place: Place) -> int:
        """Return the line (from 1) of a key or list item; if it does not exist, of its closest parent."""
        node, line = self.root, 1
        for part in place:
            found = _step(node, part)
            if found is None:
                break
            line, node = found
        return line

    def error(self, what: str, next_step: str | None = None, *, place: Place = ()) -> ContentError:
        """Return an error about this place in the file, for you to raise: what is wrong, and what to do."""
        key = key_text(place) or None
        return ContentError(what, next_step, file=self.file, line=self.line(place), key=key)

    def used_twice(self, kind: str, ids: Iterable[str], place: Place) -> Iterator[ContentError]:
        """Errors about ids that occur twice in the list at `place`. kind: what its entries are called."""
        first: dict[str, int] = {}
        for index, name in enumerate(ids):
            here = (*place, index, "id")
            if name in first:
                what = f"`{name}` is used twice; the first is on line {first[name]}"
                yield self.error(what, f"give each {kind} its own id", place=here)
            first.setdefault(name, self.line(here))


def key_text(place: Place) -> str:
    """`exercises[0].hints` for ("exercises", 0, "hints")."""
    parts = (f"[{part}]" if isinstance(part, int) else f".{part}" for part in place)
    return "".join(parts).removeprefix(".")


def read_document(file: Path) -> Document:
    """Parse a file. Raises ContentError when it cannot be read or is not YAML."""
    try:
        text = file.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise ContentError("the file is missing", f"create {file.name}", file=file) from None
    except UnicodeDecodeError as error:
        line = error.object[: error.start].count(b"\n") + 1
        raise ContentError("this is not UTF-8 text", "save it as UTF-8", file=file, line=line) from None
    except OSError as error:
        raise ContentError(f"cannot be read: {error.strerror}", file=file) from error
    return parse_document(file, text)


def parse_document(file: Path, text: str) -> Document:
    """Parse the text of this file. Raises ContentError when it is not YAML."""
    try:
        return _parse(file, text)
    except yaml.MarkedYAMLError as error:
        raise _syntax_error(file, error) from None
    except NOT_YAML as error:
        raise ContentError(f"this is not YAML: {error}".replace("\n", " "), file=file) from None


def _parse(file: Path, text: str) -> Document:
    loader = Loader(text)
    try:
        root = loader.get_single_node()
        repeated = tuple(_repeated_keys(file, root, set()))
        data = loader.construct_document(root) if root is not None else None
        return Document(file, data, repeated, root)
    finally:
        loader.dispose()


def _syntax_error(file: Path, error: yaml.MarkedYAMLError) -> ContentError:
    mark = error.problem_mark or error.context_mark
    what = " ".join(part for part in (error.context, error.problem) if part)
    advice = "check indentation, and quote strings that contain `: `, ` #` or begin with one of `*&!%@{}[]`"
    return ContentError(
        f"this is not valid YAML: {what}", advice, file=file, line=mark.line + 1 if mark else None
    )


def _step(node: yaml.Node | None, part: int | str) -> tuple[int, yaml.Node] | None:
    if isinstance(node, yaml.SequenceNode) and isinstance(part, int) and part < len(node.value):
        item = node.value[part]
        return item.start_mark.line + 1, item
    if isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            if key.value == str(part):
                return key.start_mark.line + 1, value
    return None


def _repeated_keys(file: Path, node: yaml.Node | None, visited: set[int]) -> Iterator[ContentError]:
    """PyYAML silently uses the last of two equal keys, but an author wants to know."""
    if node is None or id(node) in visited:  # an alias may lead back to its own container
        return
    visited.add(id(node))
    if isinstance(node, yaml.MappingNode):
        yield from _repeated_here(file, node)
        for _key, value in node.value:
            yield from _repeated_keys(file, value, visited)
    elif isinstance(node, yaml.SequenceNode):
        for item in node.value:
            yield from _repeated_keys(file, item, visited)


def _repeated_here(file: Path, node: yaml.MappingNode) -> Iterator[ContentError]:
    first: dict[str, int] = {}
    for key, _value in node.value:
        if not isinstance(key, yaml.ScalarNode):
            continue
        line = key.start_mark.line + 1
        if key.value in first:
            what = f"`{key.value}` appears twice here; the first is on line {first[key.value]}"
            yield ContentError(what, "keep one of them", file=file, line=line, key=key.value)
        first.setdefault(key.value, line)
