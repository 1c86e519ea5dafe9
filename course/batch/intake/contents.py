"""What one submission contains, with its archives opened; and how its files become a course home."""

from __future__ import annotations

import shutil
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Sequence
from pathlib import Path

from course.batch.intake.packed import packed_in
from course.batch.intake.recognize import LARGEST_MANIFEST, SRC, Recognized, made_of, number_of_try, recognize
from course.batch.intake.submission import Found, Part, Placement, SubmissionKind, Upload
from course.batch.intake.tree import Tree, TreeEntry, content, read_into, read_tree
from course.content import Exercise
from course.explain.package_xml import ManifestFault, read_manifest
from course.files import new_folder, wipe
from course.home.opening import (
    USUAL,
    Limits,
    Notes,
    Refused,
    Remark,
    archive_stem,
    is_archive,
    open_archive,
    visible,
)
from course.home.opening.unpack import BOTH
from course.home.storage import storing
from course.model import replace

_MOST_ARCHIVES = 20
_DEEPEST_ARCHIVE = 3

NOTHING = Remark(
    "No course home, workspace, or package was found in it.",
    "A submission is a course home, a workspace with packages in src/, or packages with a package.xml.",
)
LACKING = "It needs the package `{}`, which was not handed in."
NO_PACKAGE = "Single files of a package were handed in, without the package that they belong to."
NOT_OPENED = "Archives inside archives, deep in folders, or after the first twenty are not opened."
NOT_USED = "Other files were not used."


def look(source: Upload, opened: Path, exercises: Iterable[Exercise], limits: Limits = USUAL) -> Found:
    """What `source` contains. Anything wrong with it is in `Found.findings`.

    Its archives are opened into folders of `opened`, and replace what an earlier call left there. The
    caller removes these folders after the submission is laid out. Raises StorageError for the disk.
    """
    exercises = tuple(exercises)
    looking = _Looking(source, opened, exercises, limits)
    try:
        return looking.found()
    except Refused as error:
        return looking.nothing(error.finding)


class _Looking:
    def __init__(self, source: Upload, opened: Path, exercises: tuple[Exercise, ...], limits: Limits) -> None:
        self.findings: list[Remark] = []
        self._source = source
        self._opened = opened
        self._exercises = exercises
        self._known = tuple(dict.fromkeys(file for exercise in exercises for file in exercise.files))
        self._limits = limits
        self._taken: list[Path] = []  # archives that were opened
        self._refused = False

    def found(self) -> Found:
        archives = [part for part in self._source.parts if _is_archive(part)]
        plain = [part for part in self._source.parts if part not in archives]
        parts = [*plain, *self._open(archives)]
        tree, planned = self._read(parts)
        if planned.kind in (SubmissionKind.NOTHING, SubmissionKind.FILES) and plain:
            parts = [*parts, *self._open(self._within(plain))]
            tree, planned = self._read(parts)
        return self._made(parts, tree, planned)

    def nothing(self, because: Remark) -> Found:
        """A submission from which nothing is taken, for this reason."""
        source = self._source
        findings = tuple(dict.fromkeys((because, *source.findings, *self.findings)))
        return Found(source.person, source.shown, SubmissionKind.NOTHING, "", (), (), findings, (), ())

    def _within(self, parts: Sequence[Part]) -> tuple[Part, ...]:
        """Archives in the folders of submissions: a Moodle folder contains the uploaded zip."""
        tree = read_tree(parts, self._limits)
        near = [path for path in _archives(tree) if path.count("/") < _DEEPEST_ARCHIVE]
        newest = sorted(near, key=number_of_try, reverse=True)[:_MOST_ARCHIVES]
        return tuple(Part(path.rpartition("/")[2], tree.entries[path].path) for path in newest)

    def _read(self, parts: Sequence[Part]) -> tuple[Tree, Recognized]:
        tree = read_tree(parts, self._limits)
        return tree, recognize(tree, self._known)

    def _open(self, archives: Iterable[Part]) -> Iterator[Part]:
        for archive in archives:
            folder = self._opened / str(len(self._taken))
            self._taken.append(archive.path)
            wipe(folder)
            try:
                found = open_archive(archive.path, folder, self._limits)
            except Refused as error:
                self._refused = True
                self.findings.append(_in(archive, error.finding))
            else:
                self.findings.extend(_in(archive, finding) for finding in found)
                yield Part(archive_stem(archive.name), folder)

    def _made(self, parts: Sequence[Part], tree: Tree, planned: Recognized) -> Found:
        findings = [*self._source.findings, *self.findings, *planned.findings, *tree.findings]
        if planned.kind is SubmissionKind.NOTHING:
            findings = [*self._empty(tree), *findings]
        laid = dict(made_of(tree, planned.places))
        packed, told = packed_in(laid)
        told += _not_used(tree, laid.values())
        findings = list(dict.fromkeys([*findings, *told, *self._lacking(tree, planned)]))
        return Found(
            self._source.person,
            self._source.shown,
            SubmissionKind.UNREADABLE
            if self._refused and planned.kind is SubmissionKind.NOTHING
            else planned.kind,
            visible(planned.root),
            planned.packages,
            self._present(tree, planned.places),
            tuple(findings),
            tuple(parts) if planned.places else (),  # with nothing to lay out, they need not be kept
            planned.places,
            packed,
            written=planned.written,
        )

    def _lacking(self, tree: Tree, planned: Recognized) -> Iterator[Remark]:
        """Remarks about packages of the course that the submission needs, but does not contain."""
        course = {package for exercise in self._exercises for package in exercise.packages}
        for target, entry in made_of(tree, planned.places):
            if target.endswith("/package.xml") and target.startswith(SRC) and entry.size < LARGEST_MANIFEST:
                manifest = read_manifest(content(entry) or b"")
                needed = () if isinstance(manifest, ManifestFault) else manifest.dependencies
                missing = course.intersection(one.name for one in needed) - {*planned.packages}
                for name in sorted(missing):
                    yield Remark(LACKING.format(name), "Ask for the whole workspace.", visible(target))
        if planned.kind is SubmissionKind.FILES and any(
            f"{place.target}".startswith(SRC) for place in planned.places
        ):
            yield Remark(NO_PACKAGE, "Ask for the whole workspace.")

    def _empty(self, tree: Tree) -> Iterator[Remark]:
        if not self._source.findings and not self.findings:
            notes = Notes()
            for path in sorted(tree.files()):
                notes.add(NOTHING.what, path, NOTHING.advice)
            yield from notes.findings() or (Remark("It is empty.", NOTHING.advice),)
        closed = [path for path in _archives(tree) if tree.entries[path].path not in self._taken]
        if closed:
            where = ", ".join(visible(path) for path in closed[:3])
            yield Remark(NOT_OPENED, "Ask for one archive, with the files themselves in it.", where)

    def _present(self, tree: Tree, places: Iterable[Placement]) -> tuple[str, ...]:
        """Exercises with a file that no other exercise has, or with all of their files if all are shared."""
        laid = {target for target, entry in made_of(tree, places) if not entry.folder}
        owners = Counter(file for exercise in self._exercises for file in exercise.files)
        present = []
        for exercise in self._exercises:
            own = [file for file in exercise.files if owners[file] == 1]
            there = any(file in laid for file in own) if own else laid.issuperset(exercise.files)
            if there and exercise.files:
                present.append(exercise.id)
        return tuple(present)


def _not_used(tree: Tree, laid: Collection[TreeEntry]) -> tuple[Remark, ...]:
    """Names the files that were uploaded by themselves next to what counts."""
    files = {name: tree.entries[name] for name in tree.parts if name in tree.files()}
    names = [visible(name) for name, entry in files.items() if entry not in laid]
    return (Remark(NOT_USED, where=", ".join(names)),) if laid and names else ()


def _is_archive(part: Part) -> bool:
    return is_archive(part.name) and not part.path.is_dir()


def _archives(tree: Tree) -> list[str]:
    return [path for path in sorted(tree.files()) if is_archive(path)]


def _in(archive: Part, finding: Remark) -> Remark:
    name = visible(archive.name)
    return replace(finding, where=f"{name}: {visible(finding.where, 400)}" if finding.where else name)


UNREADABLE = "Files without read permission were left out."


def lay_out(found: Found, home: Path, limits: Limits = USUAL) -> tuple[Remark, ...]:
    """Make the folder `home`, whole or not at all; returns what else was left out, after `look`.

    It always has the workspace's `src`. Modes are 644, or 755 for programs and folders.
    Raises StorageError if the disk cannot take it, or if `home` exists already, and Refused if the
    submission has grown meanwhile.
    """
    notes = Notes()
    with storing(f"the submission of {found.person.id} cannot be put in place"), new_folder(home) as part:
        (part / SRC).mkdir(parents=True)
        for target, entry in made_of(read_tree(found.parts, limits), found.places):
            _lay(entry, part / target, target, notes)
        for folder, place in found.beneath:
            _lay_beneath(folder, part, place, notes)
        for name, data in found.written:
            (part / name).parent.mkdir(parents=True, exist_ok=True)
            (part / name).write_bytes(data)
        part.chmod(0o755)
    return notes.findings()


def _lay_beneath(folder: Path, home: Path, place: str, notes: Notes) -> None:
    """Add the files of a course folder that are missing."""
    for file in sorted(folder.rglob("*")):
        target = home / place / file.relative_to(folder)
        if file.is_file() and "__pycache__" not in file.parts and not target.exists():
            try:
                target.parent.mkdir(parents=True, exist_ok=True)
            except (NotADirectoryError, FileExistsError):
                notes.add(BOTH, f"{target.relative_to(home)}")
            else:
                shutil.copy(file, target)


def _lay(entry: TreeEntry, target: Path, name: str, notes: Notes) -> None:
    try:
        if entry.folder:
            target.mkdir(parents=True, exist_ok=True)
            return
        target.parent.mkdir(parents=True, exist_ok=True)
        out = target.open("xb")
    except (NotADirectoryError, FileExistsError):
        notes.add(BOTH, name)
        return
    with out:
        if not read_into(entry, out.write):
            target.unlink()
            notes.add(UNREADABLE, name)
            return
    target.chmod(0o755 if entry.executable else 0o644)
