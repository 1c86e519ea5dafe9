"""Entry points as the learner declared them in setup.py or setup.cfg, and their usual faults."""

from __future__ import annotations

import ast
import configparser
from dataclasses import dataclass

from course.evidence.sources import Sources
from course.feedback import Location


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
    try:
        tree = ast.parse(sources.files.get(file, ""))
    except (SyntaxError, ValueError):
        return ()
    strings = [
        item
        for node in ast.walk(tree)
        if isinstance(node, ast.Dict)
        for key, value in zip(node.keys, node.values, strict=True)
        if isinstance(key, ast.Constant)
        and key.value == "console_scripts"
        and isinstance(value, ast.List | ast.Tuple)
        for item in value.elts
    ]
    return tuple(
        _entry(item.value, Location(file, item.lineno))
        for item in strings
        if isinstance(item, ast.Constant) and isinstance(item.value, str)
    )


def _from_setup_cfg(sources: Sources, file: str) -> tuple[EntryPoint, ...]:
    parser = configparser.ConfigParser(interpolation=None)
    try:
        parser.read_string(sources.files.get(file, ""))
        text = parser.get("options.entry_points", "console_scripts", fallback="")
    except configparser.Error:
        return ()
    return tuple(_entry(line.strip(), Location(file)) for line in text.splitlines() if line.strip())


def _entry(text: str, where: Location) -> EntryPoint:
    name, _, target = text.partition("=")
    return EntryPoint(name.strip(), target.strip(), text, where)
