"""Writes what was planned: everything or nothing, and never over an existing file."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from importlib.resources import files
from pathlib import Path
from string import Template

from course.content.schema import Kind, schema_text
from course.errors import UsageError
from course.files import write_atomic
from course.home.storage import storing, write_new


@dataclass(frozen=True)
class Plan:
    """new: files to make. changed: the whole new texts of existing files. folders: empty folders to make."""

    new: Mapping[Path, str]
    changed: Mapping[Path, str] = field(default_factory=dict)
    folders: tuple[Path, ...] = ()


@dataclass(frozen=True)
class Made:
    """What was made: its name, and paths below `root`."""

    name: str
    root: Path
    new: tuple[Path, ...]
    changed: tuple[Path, ...] = ()


def carry_out(plan: Plan, root: Path, name: str) -> Made:
    """Write the files. Raises UsageError if a new one exists already, StorageError if the disk refuses."""
    for file in plan.new:
        if os.path.lexists(file):
            raise UsageError(f"{file} already exists, and is left as it is", "choose another name")
    with storing("the files cannot be created"), _undone_on_error() as made:
        for folder in plan.folders:
            _make(folder, made)
        for file, text in plan.new.items():
            _make(file.parent, made)
            if write_new(file, text.encode()):
                made.append(file)
        for file, text in plan.changed.items():
            write_atomic(file, text)
    return Made(name, root, tuple(plan.new), tuple(plan.changed))


def _make(folder: Path, made: list[Path]) -> None:
    missing = [each for each in (folder, *folder.parents) if not each.is_dir()]
    for each in reversed(missing):
        each.mkdir()
        made.append(each)


@contextlib.contextmanager
def _undone_on_error() -> Iterator[list[Path]]:
    """After an error, remove everything that was made, in reverse order."""
    made: list[Path] = []
    try:
        yield made
    except BaseException:
        for path in reversed(made):
            with contextlib.suppress(OSError):  # keeps a folder into which somebody put something
                if path.is_dir():
                    path.rmdir()
                else:
                    path.unlink()
        raise


Words = Mapping[str, str]


def filled(name: str, words: Words) -> str:
    """The template `templates/NAME.in` with its words filled in; `$$` in it stands for a plain `$`.

    A missing word is our fault and raises KeyError.
    """
    return Template(template_text(name)).substitute(words)


def template_text(name: str) -> str:
    return (files("course.authoring") / "templates" / f"{name}.in").read_text(encoding="utf-8")


# The first is for a course that keeps its documents in docs/, as the one in this repository does.
_PLACES = ("docs/schema", ".schema")


def schema_folder(root: Path) -> str:
    """The folder of schemas, relative to the course: the first place that has them, or else a new one."""
    held = (place for place in _PLACES if (root / place / _schema_name(Kind.LESSON)).is_file())
    return next(held, _PLACES[-1])


def missing_schemas(root: Path) -> dict[Path, str]:
    """The schemas that the course lacks, with their texts."""
    folder = root / schema_folder(root)
    wanted = {folder / _schema_name(kind): kind for kind in Kind}
    return {file: schema_text(kind) for file, kind in wanted.items() if not file.exists()}


def _schema_name(kind: Kind) -> str:
    return f"{kind.value}.schema.json"
