"""What `pack` puts into a zip, and the manifest in it, read again when the zip is graded."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from course.batch.intake.recognize import and_above
from course.batch.intake.submission import Claim, PackManifest, Part
from course.batch.intake.tree import PACKED, TreeEntry, content, read_into, read_tree
from course.build import Workspace
from course.content import Exercise
from course.content.layout import STATE
from course.errors import DamagedData
from course.evidence.home_files import read_entries
from course.home.course_home import MARKER
from course.home.opening import Remark, visible
from course.model import codec, replace
from course.model.result import Result, Verdict
from course.report.console import number
from course.report.gradebook.gradescope import Packed

MANIFEST = f"{STATE}/{PACKED}"
_SCHEMA = 1
_LARGEST = 1_000_000  # bytes
_JUDGED = (Verdict.PASSED, Verdict.NOT_PASSED)
_VERSIONS = ("ros2course", "python", "ros")  # as `pack` writes them
NOT_READ = "The manifest that `pack` wrote cannot be read."
CHANGED = "Files were changed after `pack` checked them."


def claim_of(result: Result) -> Claim:
    outcomes = {check.id: check.outcome.value for check in result.checks}
    return Claim(result.exercise, result.verdict.value, result.points, result.max_points, outcomes)


def needed_files(home: Path, exercises: Sequence[Exercise]) -> tuple[Packed, ...]:
    """The files that the exercises ask for, their packages, and what these need, by path in the course home.

    Raises Refused if it is more than `grade` accepts.
    """
    packages = {*_packages(home, exercises)}
    single = {*_looked_at(home, exercises), f"{STATE}/{MARKER}"}
    single |= {f"{STATE}/acts/{exercise.id}.json" for exercise in exercises}
    return tuple(
        Packed(f"{path}/", b"")
        if entry.folder
        else Packed(path, entry.path.read_bytes(), executable=entry.executable)
        for path, entry in sorted(read_tree((Part("home", home),)).entries.items())
        if path != MANIFEST and (path in single or not packages.isdisjoint(and_above(path)))
    )


def manifest_of(
    files: Iterable[Packed], results: Iterable[Result], versions: Mapping[str, str], at: str
) -> Packed:
    digests = {
        file.path: hashlib.sha256(file.content).hexdigest() for file in files if not file.path.endswith("/")
    }
    manifest = PackManifest(_SCHEMA, at, dict(versions), tuple(map(claim_of, results)), digests)
    return Packed(MANIFEST, codec.to_json(manifest))


def digest_of(entry: TreeEntry) -> str:
    """The SHA-256 of a file; empty if it cannot be read."""
    hashed = hashlib.sha256()
    return hashed.hexdigest() if read_into(entry, hashed.update) else ""


def packed_in(laid: Mapping[str, TreeEntry]) -> tuple[PackManifest | None, tuple[Remark, ...]]:
    """The manifest, if any, and remarks about files that changed since. laid: files by path in the home."""
    entry = laid.get(MANIFEST)
    if entry is None or entry.folder:
        return None, ()
    try:
        data = content(entry) if entry.size < _LARGEST else None
        found = codec.from_json(data or b"", PackManifest, MANIFEST)
    except DamagedData:
        return None, (Remark(NOT_READ, where=MANIFEST),)
    changed = [visible(path) for path, told in found.files.items() if _differs(laid.get(path), told)]
    told = (Remark(CHANGED, where=", ".join(changed[:3])),) if changed else ()
    return replace(found, files={}), told


def differences(packed: PackManifest, results: Iterable[Result]) -> Iterator[str]:
    """A sentence for each exercise with a different result for the learner. Our own errors do not count."""
    told = {claim.exercise: claim for claim in packed.claims if claim.verdict in _JUDGED}
    for result in results:
        claim = told.get(result.exercise)
        if claim is None or result.verdict not in _JUDGED or claim == claim_of(result):
            continue
        here = claim_of(result)
        others = (
            check.title for check in result.checks if claim.checks.get(check.id) != here.checks[check.id]
        )
        told_of = (f"{name} {packed.versions[name]}" for name in _VERSIONS if name in packed.versions)
        versions = ", ".join(visible(each, 40) for each in told_of)
        yield (
            f"{result.exercise} had {_points(claim)} points where it was packed ({versions}), and has "
            f"{_points(here)} here. Different: {(', '.join(others) or 'only the points').rstrip('.?!')}."
        )


def _points(claim: Claim) -> str:
    return f"{number(claim.points)} of {number(claim.max_points)}"


def _differs(entry: TreeEntry | None, told: str) -> bool:
    return entry is None or entry.folder or digest_of(entry) != told


def _looked_at(home: Path, exercises: Iterable[Exercise]) -> Iterator[str]:
    for exercise in exercises:
        yield from (entry.path for entry in read_entries(home, (*exercise.files, *exercise.looks_at)))


def _packages(home: Path, exercises: Iterable[Exercise]) -> Iterator[str]:
    """Folders of packages, including those in the workspace that they depend on."""
    for exercise in exercises:
        workspace = Workspace.scan(home / exercise.workspace, home)
        wanted = list(exercise.packages)
        for name in wanted:  # it grows meanwhile
            for package in workspace.named(name):
                yield package.source
                wanted += (one.name for one in package.dependencies if one.name not in wanted)
