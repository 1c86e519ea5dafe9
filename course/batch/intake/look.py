"""What one submission holds: its archives opened, its files walked, its packages named."""

from __future__ import annotations

import shutil
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from course.batch.intake.model import Found, Kind, Part, Place, Source
from course.batch.intake.plan import Plan, made_of, plan
from course.batch.intake.tree import Tree, read_tree
from course.content import Exercise
from course.home.opening import (
    USUAL,
    Finding,
    Limits,
    Refused,
    archive_stem,
    is_archive,
    open_archive,
    visible,
)

_MOST_ARCHIVES = 20
_DEEPEST_ARCHIVE = 3

NOTHING = Finding(
    "No course home, workspace or package was found in it.",
    "A submission is a course home, a workspace with packages in src/, or packages with a package.xml.",
)
NOT_OPENED = "Archives in archives, deep in folders or beyond the first twenty are not opened."


def look(source: Source, opened: Path, exercises: Iterable[Exercise], limits: Limits = USUAL) -> Found:
    """What `source` holds. Its archives are opened into folders of `opened`, which the caller removes
    when the submission is laid out; what an earlier look left there is replaced.

    What is wrong with the submission is in `Found.findings`. Raises StorageError when the disk does
    not take it.
    """
    exercises = tuple(exercises)
    looking = _Looking(source, opened, exercises, limits)
    try:
        return looking.found()
    except Refused as error:
        return looking.nothing(error.finding)


class _Looking:
    def __init__(self, source: Source, opened: Path, exercises: tuple[Exercise, ...], limits: Limits) -> None:
        self.findings: list[Finding] = []
        self._source = source
        self._opened = opened
        self._exercises = exercises
        self._known = tuple(dict.fromkeys(file for exercise in exercises for file in exercise.files))
        self._limits = limits
        self._taken: list[Path] = []  # archives

    def found(self) -> Found:
        archives = [part for part in self._source.parts if _is_archive(part)]
        plain = [part for part in self._source.parts if part not in archives]
        parts = [*plain, *self._open(archives)]
        tree, planned = self._read(parts)
        if planned.kind in (Kind.NOTHING, Kind.FILES) and plain:
            parts = [*parts, *self._open(self._within(plain))]
            tree, planned = self._read(parts)
        return self._made(parts, tree, planned)

    def nothing(self, because: Finding) -> Found:
        """No part of it is taken."""
        source = self._source
        findings = tuple(dict.fromkeys((because, *source.findings, *self.findings)))
        return Found(source.person, source.shown, Kind.NOTHING, "", (), (), findings, (), ())

    def _within(self, parts: Sequence[Part]) -> tuple[Part, ...]:
        """Archives in folders as they were handed in: a Moodle folder holds the uploaded zip."""
        tree = read_tree(parts, self._limits)
        near = [path for path in _archives(tree) if path.count("/") < _DEEPEST_ARCHIVE][:_MOST_ARCHIVES]
        return tuple(Part(path.rpartition("/")[2], tree.entries[path].path) for path in near)

    def _read(self, parts: Sequence[Part]) -> tuple[Tree, Plan]:
        tree = read_tree(parts, self._limits)
        return tree, plan(tree, self._known)

    def _open(self, archives: Iterable[Part]) -> Iterator[Part]:
        for archive in archives:
            folder = self._opened / str(len(self._taken))
            self._taken.append(archive.path)
            shutil.rmtree(folder, ignore_errors=True)
            try:
                found = open_archive(archive.path, folder, self._limits)
            except Refused as error:
                self.findings.append(_in(archive, error.finding))
            else:
                self.findings.extend(_in(archive, finding) for finding in found)
                yield Part(archive_stem(archive.name), folder)

    def _made(self, parts: Sequence[Part], tree: Tree, planned: Plan) -> Found:
        findings = [*self._source.findings, *self.findings, *planned.findings, *tree.findings]
        if planned.kind is Kind.NOTHING:
            findings = [*self._empty(tree), *findings]
        findings = list(dict.fromkeys(findings))
        return Found(
            self._source.person,
            self._source.shown,
            planned.kind,
            visible(planned.root),
            planned.packages,
            self._present(tree, planned.places),
            tuple(findings),
            tuple(parts) if planned.places else (),  # with nothing to lay out, they need not be kept
            planned.places,
        )

    def _empty(self, tree: Tree) -> Iterator[Finding]:
        if not self._source.findings and not self.findings:
            yield NOTHING if tree.files() else Finding("It is empty.", NOTHING.advice)
        closed = [path for path in _archives(tree) if tree.entries[path].path not in self._taken]
        if closed:
            where = ", ".join(visible(path) for path in closed[:3])
            yield Finding(NOT_OPENED, "Ask for one archive, with the files themselves in it.", where)

    def _present(self, tree: Tree, places: Iterable[Place]) -> tuple[str, ...]:
        """Exercises with a file that only they have, or, where others have all of theirs too, with all."""
        laid = {target for target, entry in made_of(tree, places) if not entry.folder}
        owners = Counter(file for exercise in self._exercises for file in exercise.files)
        present = []
        for exercise in self._exercises:
            own = [file for file in exercise.files if owners[file] == 1]
            there = any(file in laid for file in own) if own else laid.issuperset(exercise.files)
            if there and exercise.files:
                present.append(exercise.id)
        return tuple(present)


def _is_archive(part: Part) -> bool:
    return is_archive(part.name) and not part.path.is_dir()


def _archives(tree: Tree) -> list[str]:
    return [path for path in sorted(tree.files()) if is_archive(path)]


def _in(archive: Part, finding: Finding) -> Finding:
    name = visible(archive.name)
    return replace(finding, where=f"{name}: {visible(finding.where, 400)}" if finding.where else name)
