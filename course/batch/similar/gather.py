"""The programs of each submission of a class, wherever they lie in it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from course.batch.intake import Found, Source, find_sources, look
from course.batch.intake.plan import made_of
from course.batch.intake.tree import Tree, read_tree
from course.batch.similar.work import File
from course.content import Exercise
from course.home.opening import Finding, Refused


@dataclass(frozen=True)
class HandedIn:
    """The files of one submission. name: whose it is, different for each, safe to show."""

    name: str
    files: tuple[File, ...]
    findings: tuple[Finding, ...] = ()


def gather(submissions: Path, opened: Path, exercises: Iterable[Exercise]) -> Iterator[HandedIn]:
    """submissions: as for `find_sources`. opened: a folder for archives, needed as long as the files are.

    Raises UsageError and StorageError.
    """
    exercises = tuple(exercises)
    sources = find_sources(submissions, opened / "class")
    names = Counter(source.person.name for source in sources.each)
    for source in sources.each:
        person = source.person
        name = person.name if names[person.name] == 1 and person.name else f"{person.name} ({person.id})"
        yield _handed_in(name.strip(), source, look(source, opened / person.id, exercises))


def _handed_in(name: str, source: Source, found: Found) -> HandedIn:
    try:
        files = _laid_out(read_tree(found.parts), found) if found.places else _as_it_is(source)
    except Refused as refused:
        return HandedIn(name, (), (refused.finding,))
    return HandedIn(name, tuple(files), found.findings)


def _laid_out(tree: Tree, found: Found) -> list[File]:
    return [File(path, entry.path) for path, entry in made_of(tree, found.places) if not entry.folder]


def _as_it_is(source: Source) -> list[File]:
    """Nothing of the course was recognised in it; its programs can be compared all the same."""
    entries = read_tree(source.parts).entries
    return [File(path, entry.path) for path, entry in entries.items() if not entry.folder]
