"""Recordings of an exercise's proofs: those kept from before, and the others made now, by running them.

They lie in the cache, a file each (MCAP), with the result that they led to beside it (JSON). Both are named
by all that they depend on (see `keys`), so a recording that does not fit any more is not found. Only what
bore out the course's claims is kept.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

from course.content import Course, Exercise
from course.errors import StorageError
from course.evidence.mcap_file import BadRecording, load
from course.grading.result import from_json, to_json
from course.home.storage import storing
from course.rosenv import cache_dir, find_ros
from course.validate.claims import Claims, is_missing
from course.validate.mutation.keys import Keys
from course.validate.plan import Kind, Proof, proofs
from course.validate.run import run
from course.validate.tasks import Proven

_FOLDER = "proofs"


@dataclass(frozen=True)
class Recorded:
    """A proof with its recording, and the result that it led to (JSON) when it was made."""

    proof: Proof
    file: Path

    @property
    def result(self) -> Path:
        return self.file.with_suffix(".json")


@dataclass(frozen=True)
class Found:
    """problems: of each proof without a recording, why; it has to be mended first. made: how many now."""

    recorded: tuple[Recorded, ...]
    problems: tuple[str, ...]
    made: int


def recordings(
    course: Course, exercise: Exercise, jobs: int, on_progress: Callable[[int, int], None]
) -> Found:
    """One for each right way and each mistake of the exercise.

    on_progress: how many of how many are made. Raises CourseError for what is missing on this machine.
    """
    every = [proof for proof in proofs([exercise]) if proof.kind is not Kind.STARTER]
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
    """Whether both are there, and readable."""
    try:
        load(file)
        from_json(file.with_suffix(".json").read_text(encoding="utf-8"))
    except (StorageError, BadRecording, OSError, ValueError, KeyError):
        return False
    return True


def _make(
    course: Course,
    exercise: Exercise,
    wanted: dict[Proof, Path],
    jobs: int,
    on_progress: Callable[[int, int], None],
) -> dict[Proof, str]:
    """Run these proofs. Gives those that did not bear out what the course claims, and why."""
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


def _problem(claims: Claims, proven: Proven, file: Path) -> str:
    fault = proven.result.fault
    if is_missing(proven) and fault:
        return fault.summary
    found = claims.faults(proven)
    return found[0] if found else "" if file.is_file() else "nothing was recorded"


def _forget_others(folder: Path, files: Iterable[Path]) -> None:
    """What is kept of proofs that are other ones now."""
    known = {file.stem for file in files}
    for file in folder.glob("*"):
        if file.stem not in known:
            file.unlink(missing_ok=True)
