"""Which exercises of which submissions are to be graded."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from course.batch.arrivals import Arrivals
from course.batch.gradings import Unit
from course.batch.intake import Found, SubmissionKind, find_sources, look, one_source
from course.batch.intake.class_list import in_groups, merged, read_class_list
from course.batch.intake.commits import dated
from course.batch.intake.contents import LACKING, NO_PACKAGE
from course.batch.intake.other_names import asked_programs, named_right, own_packages
from course.batch.intake.recognize import made_of
from course.batch.intake.tree import TreeEntry, read_into, read_tree
from course.batch.results import Submission
from course.content import Course, Exercise
from course.errors import UsageError
from course.home.opening import Remark
from course.model import replace
from course.model.gradebook import Person

LAID = "For packages that were not handed in, the course's own are used."
BEGUN = "For files of the package that were not handed in, the starter's are used."


@dataclass(frozen=True)
class BatchPlan:
    """A class as it was found. findings: about what belongs to nobody. chosen: whether exercises were named.

    held: people whose submission is still being written, and so was not looked at.
    """

    found: tuple[Found, ...]
    exercises: tuple[Exercise, ...]
    findings: tuple[Remark, ...]
    chosen: bool
    held: tuple[Person, ...] = ()

    @property
    def people(self) -> tuple[Person, ...]:
        return (*(found.person for found in self.found), *self.held)

    def units(self) -> Iterator[Unit]:
        for found in self.found:
            yield from (Unit(found.person.id, exercise.id) for exercise in self.graded(found))

    def graded(self, found: Found) -> list[Exercise]:
        return [exercise for exercise in self.exercises if self.grades(found, exercise)]

    def grades(self, found: Found, exercise: Exercise) -> bool:
        """Whether to grade it: one that was named, if anything was handed in; else one whose files are there.

        The feedback of an exercise that was named says what is missing.
        """
        if found.kind in (SubmissionKind.NOTHING, SubmissionKind.UNREADABLE):
            return False
        return self.chosen or exercise.id in found.exercises


def plan_batch(
    submissions: Path,
    opened: Path,
    course: Course,
    wanted: Sequence[str],
    *,
    single: bool,
    roster: Path | None = None,
    complete: bool = False,
    lenient: bool = False,
    arrivals: Arrivals | None = None,
) -> BatchPlan:
    """What is found in `submissions`. opened: a folder for opened archives. wanted: exercises; all if empty.

    single: `submissions` is one submission, not a class. roster: a list of the whole class.
    complete: add the course's own files to a submission that lacks some; its programs can read them.
    lenient: grade programs and packages with other names as if they had the right ones.
    arrivals: knows which submissions are still being written; these are held back.
    Raises UsageError and StorageError.
    """
    exercises = _exercises(course, wanted)
    sources = one_source(submissions) if single else find_sources(submissions, opened / "class")
    sources = replace(sources, each=tuple(map(dated, sources.each)))
    sources = in_groups(merged(sources, read_class_list(roster)) if roster else sources)
    # All exercises, so that a file of another one is not mistaken for one of those that were asked for.
    known = course.exercises()
    held = [source for source in sources.each if arrivals and arrivals.holds_back(source)]
    whole = (source for source in sources.each if source not in held)
    found = tuple(look(source, opened / source.person.id, known) for source in whole)
    plan = BatchPlan(found, exercises, sources.findings, bool(wanted), tuple(one.person for one in held))
    if complete:
        plan = replace(plan, found=tuple(_completed(one, plan, known) for one in plan.found))
    if lenient:
        asked = [program for exercise in known for program in asked_programs(exercise)]
        plan = replace(plan, found=tuple(named_right(one, plan.graded(one), asked) for one in plan.found))
    return plan


def _completed(found: Found, plan: BatchPlan, known: Sequence[Exercise]) -> Found:
    """Add what the submission needs but lacks: packages that are not graded, from the course's solutions.

    If it is single files, add the rest of their package as it is when the exercise begins.
    """
    graded = plan.graded(found)
    laid = {package: place for package in lacking(found, graded) if (place := _solved(package, known))}
    begun = tuple(dict.fromkeys(_begun(found, graded, known))) if found.kind is SubmissionKind.FILES else ()
    solved = {LACKING.format(package) for package in laid} | ({NO_PACKAGE} if begun else set())
    told = [Remark(LAID, where=", ".join(laid))] if laid else []
    told += [Remark(BEGUN, where=_not_handed_in(found, graded, dict(begun).values()))] if begun else []
    findings = (*told, *(one for one in found.findings if one.what not in solved))
    return replace(found, beneath=(*laid.values(), *begun), findings=findings)


def lacking(found: Found, graded: Iterable[Exercise]) -> list[str]:
    """The packages that these exercises need and the submission lacks, except those that learners write."""
    graded = tuple(graded)
    judged = {package for exercise in graded for package in own_packages(exercise)}
    needed = dict.fromkeys(package for exercise in graded for package in exercise.packages)
    return [package for package in needed if package not in judged and package not in found.packages]


def _solved(package: str, known: Iterable[Exercise]) -> tuple[Path, str] | None:
    for exercise in known:
        place = f"{exercise.workspace}/src/{package}"
        if package in own_packages(exercise) and (exercise.solution / place).is_dir():
            return exercise.solution / place, place
    return None


def _begun(found: Found, graded: Iterable[Exercise], known: Sequence[Exercise]) -> Iterator[tuple[Path, str]]:
    """Folders that complete the packages of single files, and their places; the first one with a file counts.

    They are starters of these exercises and those that they require; solutions in chapters not graded.
    """
    judged = {exercise.solution for exercise in graded}
    for exercise in graded:
        for package in own_packages(exercise):
            place = f"{exercise.workspace}/src/{package}"
            if any(f"{each.target}".startswith(f"{place}/") for each in found.places):
                for one in reversed(known):
                    tree = one.starter if one.solution in judged else one.solution
                    if one.id in (exercise.id, *exercise.requires) and (tree / place).is_dir():
                        yield tree / place, place


def _not_handed_in(found: Found, graded: Iterable[Exercise], places: Iterable[str]) -> str:
    asked = dict.fromkeys(file for exercise in graded for file in exercise.files)
    missing = asked.keys() - {place.target for place in found.places}
    inside = tuple(f"{place}/" for place in places)
    return ", ".join(file.rpartition("/")[2] for file in asked if file in missing and file.startswith(inside))


def exercises_named(course: Course, wanted: Iterable[str]) -> tuple[Exercise, ...]:
    """The named exercises; a chapter's number means all of its exercises. Raises UsageError for others."""
    chosen = [exercise for name in wanted for exercise in _named(course, name)]
    return tuple({exercise.id: exercise for exercise in chosen}.values())


def _named(course: Course, name: str) -> list[Exercise]:
    if name.isdecimal():
        found = [exercise for exercise in course.exercises() if exercise.chapter.number == int(name)]
        if found:
            return found
    return [course.exercise(name)]


def _exercises(course: Course, wanted: Iterable[str]) -> tuple[Exercise, ...]:
    chosen = exercises_named(course, wanted)
    found = chosen or tuple(exercise for exercise in course.exercises() if not exercise.local_only)
    if not found:
        raise UsageError("The course has no exercise that can be graded in a class.")
    return found


def submission_of(found: Found) -> Submission:
    """What is stored of a submission; reads all of its files."""
    return Submission(found.person.id, found.person.name, found.source, digest(found), remarks_on(found))


def remarks_on(found: Found) -> tuple[str, ...]:
    return tuple(sentence(finding) for finding in found.findings)


def sentence(finding: Remark) -> str:
    where = f" ({finding.where})" if finding.where else ""
    return f"{finding.what}{where}"


def digest(found: Found) -> str:
    """A digest that is the same for the same files in the same places."""
    hashed = hashlib.blake2b(digest_size=16)
    hashed.update("".join(f"{place}\0" for _, place in found.beneath).encode())
    hashed.update(repr(found.written).encode() if found.written else b"")
    for name, entry in sorted(made_of(read_tree(found.parts), found.places)):
        hashed.update(os.fsencode(f"{name}\0{entry.folder}\0{entry.size}\0{entry.executable}\0"))
        if not entry.folder:
            hashed.update(_digest_of_file(entry))
    return hashed.hexdigest()


def _digest_of_file(entry: TreeEntry) -> bytes:
    hashed = hashlib.blake2b(digest_size=16)
    read_into(entry, hashed.update)  # what cannot be read is left out later
    return hashed.digest()
