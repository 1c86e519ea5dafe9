"""Expectations about YAML files in the course home: that they are readable and not too large."""

from __future__ import annotations

import re
from pathlib import Path

import yaml

from course.api import (
    ContentError,
    Document,
    Failure,
    Feedback,
    HomeFile,
    Location,
    Recording,
    expect_text,
    parse_document,
)

# Counted with every alias expanded: a few lines of aliases can expand to more than any memory holds.
MOST_NODES = 10_000
# What PyYAML raises for text that it cannot read.
_NOT_YAML = (
    ContentError,
    yaml.YAMLError,
    ValueError,
    ArithmeticError,
    LookupError,
    AttributeError,
    RecursionError,
)
_NO_SPACE = re.compile(r"\s*(?:- )?[\w.-]+:[^\s/]")
_INDENT = (
    "Count the spaces at the beginning of this line and the line before. Entries of the same "
    "level must have the same indentation."
)


def expect_yaml(recording: Recording, path: str, *, advice: str) -> Document:
    """Check that `path` is a YAML file whose mapping keys are unique texts; aliases and merge keys are fine.

    advice: what to do if the file is missing or empty.
    """
    found = expect_text(recording, path, advice=advice)
    if not (found.text or "").strip():
        raise Failure(Feedback(f"`~/{path}` is empty.", where=(Location(path),), advice=advice))
    _expect_no_tab(found)
    try:
        _expect_bounds(yaml.compose(found.text or "", yaml.SafeLoader), path)
        document = parse_document(Path(path), found.text or "")
    except yaml.MarkedYAMLError as error:
        raise Failure(_unreadable(found, error)) from None
    except _NOT_YAML as error:
        line = getattr(error, "line", None)
        raise Failure(
            Feedback(
                summary="This file is not YAML.",
                where=(Location(path, line),),
                advice="Compare this line with the lesson's example.",
                details=(str(error),),
            )
        ) from None
    if document.repeated:
        raise Failure(_repeated(path, document.repeated[0]))
    return document


def _expect_no_tab(file: HomeFile) -> None:
    for number, line in enumerate(file.lines, 1):
        if "\t" in line[: len(line) - len(line.lstrip())]:
            raise Failure(
                Feedback(
                    summary=f"Line {number} begins with a tab, which YAML does not allow.",
                    where=(Location(file.path, number),),
                    advice="Replace it with spaces, two for each level.",
                )
            )


def _unreadable(file: HomeFile, error: yaml.MarkedYAMLError) -> Feedback:
    mark = error.problem_mark or error.context_mark
    number = mark.line + 1 if mark else None
    # `name:value` is one word, so the parser complains about the next line.
    near = [n for n in (number or 0, (number or 0) - 1) if 0 < n <= len(file.lines)]
    joined = next((n for n in near if _NO_SPACE.match(file.lines[n - 1])), None)
    number = joined or number
    seen = file.lines[number - 1].strip()[:100] if number and number <= len(file.lines) else None
    return Feedback(
        summary="This file cannot be read as YAML.",
        seen=seen or None,
        where=(Location(file.path, number),),
        advice="Put a space after the `:`." if joined else _INDENT,
        details=(str(error.problem or error.context),),
    )


def _repeated(path: str, error: ContentError) -> Feedback:
    return Feedback(
        summary=f"`{error.key}` appears twice in the same place.",
        where=(Location(path, error.line),),
        advice="Keep only one of the two.",
        details=(error.what,),
    )


def _expect_bounds(root: yaml.Node | None, path: str) -> None:
    """Check, before using the data, that it is finite and small enough, and that every key is a text."""
    sizes: dict[int, int] = {}
    open_nodes: set[int] = set()
    waiting = [(root, False)] if root is not None else []
    while waiting:
        node, done = waiting.pop()
        if done:
            open_nodes.discard(id(node))
            sizes[id(node)] = 1 + sum(sizes[id(child)] for child in _children(node))
            if sizes[id(node)] > MOST_NODES:
                raise Failure(_too_much(node, path, "expands to far more than any file of this kind needs"))
        elif id(node) in open_nodes:
            raise Failure(_too_much(node, path, "contains itself"))
        elif id(node) not in sizes:
            _expect_text_keys(node, path)
            open_nodes.add(id(node))
            waiting.append((node, True))
            waiting.extend((child, False) for child in _children(node))


def _children(node: yaml.Node) -> list[yaml.Node]:
    if isinstance(node, yaml.MappingNode):
        return [part for pair in node.value for part in pair]
    return list(node.value) if isinstance(node, yaml.SequenceNode) else []


def _expect_text_keys(node: yaml.Node, path: str) -> None:
    keys = [key for key, _ in node.value] if isinstance(node, yaml.MappingNode) else []
    for key in keys:
        if key.tag not in ("tag:yaml.org,2002:str", "tag:yaml.org,2002:merge"):
            shown = f"`{key.value}`" if isinstance(key, yaml.ScalarNode) else "The name before a `:` here"
            raise Failure(
                Feedback(
                    summary=f"{shown} is not a name; YAML reads it as something else.",
                    expected="a name before the `:`",
                    where=(Location(path, key.start_mark.line + 1),),
                    advice="Choose a different name, or put quotation marks around it.",
                )
            )


def _too_much(node: yaml.Node, path: str, what: str) -> Feedback:
    return Feedback(
        summary=f"The part that begins at line {node.start_mark.line + 1} {what}.",
        where=(Location(path, node.start_mark.line + 1),),
        advice="Write it out in full, without `*`.",
    )
