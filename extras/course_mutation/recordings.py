"""Recordings of an exercise's proofs: kept from earlier runs, or made now by running the proofs.

They are in the cache, one file each (MCAP), with their results next to them (JSON). Their names are digests
of everything that they depend on (see `Keys`), so an outdated recording is not found. Only recordings that
confirmed the course's claims are kept.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import course as package
from course.content import Course, Exercise
from course.errors import StorageError
from course.evidence.mcap_file import BadRecording, load
from course.grading.scenario_digest import scenario_digest
from course.grading.trial_answers import SEED
from course.home.storage import storing
from course.model.result import from_json, to_json
from course.rosenv import cache_dir, find_ros
from course.validate.claims import Claims, is_missing
from course.validate.proofs import Proof, ProofKind, ProofResult, proofs
from course.validate.schedule import run

_FOLDER = "proofs"


@dataclass(frozen=True)
class Recorded:
    """A proof with its recording, and its result (JSON) at that time."""

    proof: Proof
    file: Path

    @property
    def result(self) -> Path:
        return self.file.with_suffix(".json")


@dataclass(frozen=True)
class Found:
    """problems: why a proof has no recording; fix these first. made: how many were made now."""

    recorded: tuple[Recorded, ...]
    problems: tuple[str, ...]
    made: int


def recordings(
    course: Course, exercise: Exercise, jobs: int, on_progress: Callable[[int, int], None]
) -> Found:
    """One for each right way and each mistake of the exercise.

    on_progress: gets the number done and the total. Raises CourseError if this machine lacks something.
    """
    every = [proof for proof in proofs([exercise]) if proof.kind is not ProofKind.STARTER]
    keys = Keys(course, exercise, find_ros().identity)
    folder = _folder(course, exercise)
    wanted = {proof: folder / f"{keys.key(proof)}.mcap" for proof in every}
    missing = [proof for proof in every if not _is_kept(wanted[proof])]
    problems = _make(course, exercise, {proof: wanted[proof] for proof in missing}, jobs, on_progress)
    _forget_others(folder, wanted.values())
    there = tuple(Recorded(proof, wanted[proof]) for proof in every if proof not in problems)
    return Found(there, tuple(problems.values()), len(missing) - len(problems))


def _folder(course: Course, exercise: Exercise) -> Path:
    of_course = hashlib.sha256(str(course.root).encode()).hexdigest()[:12]
    return cache_dir(os.environ) / _FOLDER / of_course / exercise.id


def _is_kept(file: Path) -> bool:
    """Whether the recording and its result exist and are readable."""
    try:
        load(file)
        from_json(file.with_suffix(".json").read_text(encoding="utf-8"))
    except (StorageError, BadRecording, OSError, UnicodeDecodeError):
        return False
    return True


def _make(
    course: Course,
    exercise: Exercise,
    wanted: dict[Proof, Path],
    jobs: int,
    on_progress: Callable[[int, int], None],
) -> dict[Proof, str]:
    """Run these proofs. Return those that did not confirm the course's claims, and why."""
    problems: dict[Proof, str] = {}
    if not wanted:
        return problems
    on_progress(0, len(wanted))
    claims = Claims([exercise])
    with contextlib.closing(run(course.root, [exercise], list(wanted), jobs, evidence=wanted)) as proven:
        for done, one in enumerate(proven, start=1):
            problem = _problem(claims, one, wanted[one.proof])
            if problem:
                problems[one.proof] = f"{one.proof}: {problem}"
                wanted[one.proof].unlink(missing_ok=True)
            else:
                with storing("the result of a proof cannot be kept"):
                    wanted[one.proof].with_suffix(".json").write_text(to_json(one.result), encoding="utf-8")
            on_progress(done, len(wanted))
    return problems


def _problem(claims: Claims, proven: ProofResult, file: Path) -> str:
    fault = proven.result.fault
    if is_missing(proven) and fault:
        return fault.summary
    found = claims.faults(proven)
    return found[0] if found else "" if file.is_file() else "nothing was recorded"


def _forget_others(folder: Path, files: Iterable[Path]) -> None:
    """Remove recordings of proofs that have changed."""
    known = {file.stem for file in files}
    for file in folder.glob("*"):
        if file.stem not in known:
            file.unlink(missing_ok=True)


# What affects a recording, besides the scenario and the modules of `course.grading` that it uses.
_ENGINE = ("arena", "evidence", "build", "rosenv")
_LEFT_OUT = frozenset({"__pycache__"})


class Keys:
    """Keys of one exercise's recordings. ros: the identity of the ROS that made them."""

    def __init__(self, course: Course, exercise: Exercise, ros: str) -> None:
        self._mistakes = {mistake.id: mistake for mistake in exercise.mistakes()}
        self._alternatives = {other.name: other for other in exercise.alternatives()}
        self._common = _digest([ros, _engine(), *_of_exercise(exercise), *_homes(course, exercise)])

    def key(self, proof: Proof) -> str:
        return _digest([self._common, str(proof), *self._own(proof)])

    def _own(self, proof: Proof) -> Iterator[str]:
        if proof.kind is ProofKind.MISTAKE:
            yield repr(self._mistakes[proof.name].edits)
        elif proof.kind is ProofKind.ALTERNATIVE:
            other = self._alternatives[proof.name]
            yield f"{other.deletes} {other.answers}"
            yield _tree(other.tree)


def _of_exercise(exercise: Exercise) -> Iterator[str]:
    yield scenario_digest(exercise.grader, exercise.id, (*exercise.files, *exercise.looks_at))
    yield f"{exercise.id} {SEED} {exercise.time_limit} {exercise.packages} {exercise.grader_packages}"
    for name in exercise.grader_packages:
        for manifest in sorted(exercise.solution.parent.glob(f"*/*workspace/src/{name}/package.xml")):
            yield _tree(manifest.parent)
    if exercise.play is not None:  # its module also contains what a learner does in the right solution
        yield _tree(exercise.play)
        yield _tree(exercise.grader)


def _homes(course: Course, exercise: Exercise) -> Iterator[str]:
    """The files of which trial homes are made, except alternatives and mistakes."""
    for name in exercise.requires:
        yield from _homes(course, course.exercise(name))
    yield _tree(exercise.solution, without="alternatives")
    yield repr(exercise.questions)


@cache
def _engine() -> str:
    root = Path(package.__file__).parent
    return _digest(_tree(root / room) for room in _ENGINE)


def _tree(root: Path, without: str = "") -> str:
    """Digest of a file, or of all files below a folder with their names and modes."""
    return _digest(_files(root, {*_LEFT_OUT, without}))


def _files(root: Path, without: set[str]) -> Iterator[str]:
    if root.is_file():
        yield _file(root)
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(name for name in folders if name not in without)
        for name in sorted(names):
            file = Path(folder) / name
            yield f"{file.relative_to(root)} {_file(file)}"


def _file(file: Path) -> str:
    if file.is_symlink():
        return f"-> {file.readlink()}"
    return f"{file.stat().st_mode:o} {hashlib.sha256(file.read_bytes()).hexdigest()}"


def _digest(parts: Iterable[str]) -> str:
    return hashlib.sha256("\n\0".join(parts).encode()).hexdigest()[:32]
