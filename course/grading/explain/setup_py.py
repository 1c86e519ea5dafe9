"""Entry points as the learner declared them in setup.py or setup.cfg, and their usual faults."""

from __future__ import annotations

import ast
import configparser
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from course.evidence.sources import Sources
from course.feedback import Location
from course.grading.explain.python_code import parsed

_GROUP = "console_scripts"


@dataclass(frozen=True)
class EntryPoint:
    """`name = module:function` and where it stands. `text` is the string as written."""

    name: str
    target: str
    text: str
    where: Location


def entry_points(sources: Sources, package_folder: str) -> tuple[EntryPoint, ...]:
    """All console scripts that the package in this folder declares."""
    return (
        *_from_setup_py(sources, f"{package_folder}/setup.py"),
        *_from_setup_cfg(sources, f"{package_folder}/setup.cfg"),
    )


def joined_entry_points(sources: Sources, package_folder: str) -> EntryPoint | None:
    """An entry that holds two: Python joins neighbouring strings when the comma is missing."""
    return next(
        (e for e in entry_points(sources, package_folder) if e.target.count("=") or e.target.count(":") > 1),
        None,
    )


def _from_setup_py(sources: Sources, file: str) -> tuple[EntryPoint, ...]:
    tree = parsed(sources.files.get(file, ""))
    if tree is None:
        return ()
    names = _constants(tree)
    lines = (line for value in _console_scripts(tree) for line in _lines(value, names))
    return tuple(_entry(text, Location(file, number)) for text, number in lines)


def _console_scripts(tree: ast.Module) -> Iterator[ast.expr]:
    """What `'console_scripts': ...` or `dict(console_scripts=...)` stands for."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Dict):
            pairs = zip(node.keys, node.values, strict=True)
            yield from (v for k, v in pairs if isinstance(k, ast.Constant) and k.value == _GROUP)
        elif isinstance(node, ast.keyword) and node.arg == _GROUP:
            yield node.value


def _lines(value: ast.expr, names: Mapping[str, ast.expr]) -> Iterator[tuple[str, int]]:
    """The entries of a list, or of a string with one a line, each with its line in the file."""
    value = names.get(value.id, value) if isinstance(value, ast.Name) else value
    if isinstance(value, ast.List | ast.Tuple):
        texts = ((_text(item, names), item.lineno) for item in value.elts)
        yield from ((text, number) for text, number in texts if text is not None)
    else:
        every = enumerate((_text(value, names) or "").splitlines(), start=value.lineno)
        yield from ((text.strip(), number) for number, text in every if text.strip())


def _text(node: ast.expr, names: Mapping[str, ast.expr]) -> str | None:
    """A string's value, as far as it can be told without running the file."""
    if isinstance(node, ast.Constant):
        return node.value if isinstance(node.value, str) else None
    if isinstance(node, ast.Name):
        return _text(names[node.id], {}) if node.id in names else None
    if isinstance(node, ast.FormattedValue):
        return _text(node.value, names)
    if isinstance(node, ast.BinOp):
        return _joined((node.left, node.right), names) if isinstance(node.op, ast.Add) else None
    return _joined(node.values, names) if isinstance(node, ast.JoinedStr) else None


def _joined(parts: Sequence[ast.expr], names: Mapping[str, ast.expr]) -> str | None:
    texts = [_text(part, names) for part in parts]
    return None if None in texts else "".join(text or "" for text in texts)


def _constants(tree: ast.Module) -> dict[str, ast.expr]:
    """What plain names are given at the top of the file, such as `package_name`."""
    given = (node for node in tree.body if isinstance(node, ast.Assign))
    return {
        target.id: node.value for node in given for target in node.targets if isinstance(target, ast.Name)
    }


def _from_setup_cfg(sources: Sources, file: str) -> tuple[EntryPoint, ...]:
    whole = sources.files.get(file, "")
    parser = configparser.ConfigParser(interpolation=None)
    try:
        parser.read_string(whole)
        text = parser.get("options.entry_points", _GROUP, fallback="")
    except configparser.Error:
        return ()
    entries = [line.strip() for line in text.splitlines() if line.strip()]
    return tuple(_entry(entry, Location(file, _line_of(entry, whole))) for entry in entries)


def _line_of(text: str, whole: str) -> int | None:
    return next((number for number, line in enumerate(whole.splitlines(), start=1) if text in line), None)


def _entry(text: str, where: Location) -> EntryPoint:
    name, _, target = text.partition("=")
    return EntryPoint(name.strip(), target.strip(), text, where)
