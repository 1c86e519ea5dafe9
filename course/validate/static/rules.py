"""Applies all rules."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from course.content import Course, Exercise, layout, problems
from course.errors import ContentError, StorageError
from course.validate import Finding
from course.validate.static.commands import Complaint, own_findings, ros2_findings
from course.validate.static.coverage import proof_findings
from course.validate.static.english import early_terms, english_findings, spelling_findings
from course.validate.static.grader_code import code_findings
from course.validate.static.grader_rules import grader_findings
from course.validate.static.leaks import leak_findings
from course.validate.static.strays import link_findings, stray_findings
from course.validate.static.subject import Subject, choices, prose


def findings(
    course: Course, exercises: Sequence[Exercise], own_command: Complaint | None = None
) -> list[Finding]:
    """Everything that is wrong with the course's files, by file and line.

    exercises: with all that can be read, findings are about the whole course, including broken chapters;
    with some, only about these or their chapters. own_command: returns what is wrong with the words after
    `ros2course`, or None. If it is not given, only the exercises in our own commands are checked.
    Grader modules are loaded. Nothing is graded, and no program of the course is run. Raises StorageError
    for folders that cannot be read.
    """
    subject = Subject(course)
    try:
        found = sorted(set(_all(subject, own_command)), key=_place)
    except OSError as error:
        what = f"{error.filename or course.root} cannot be read: {error.strerror or error}"
        raise StorageError(what, "give yourself access to it, and try again") from error
    wanted = {exercise.id for exercise in exercises}
    if wanted >= set(subject.exercises):
        return found
    return [finding for finding in found if _is_about(finding, wanted, exercises)]


def _all(subject: Subject, own_command: Complaint | None) -> Iterator[Finding]:
    yield from map(_of_content, problems(subject.course))
    texts = tuple(prose(subject))
    yield from id_findings(subject)
    yield from grader_findings(subject)
    yield from code_findings(subject)
    yield from proof_findings(subject)
    yield from stray_findings(subject, texts)
    yield from link_findings(texts)
    everything = (*texts, *choices(subject))
    yield from english_findings(everything)
    yield from spelling_findings(subject.course.root)
    yield from early_terms(subject, everything)
    yield from own_findings(subject, texts, own_command)
    yield from ros2_findings(subject.course.root, texts)
    yield from leak_findings(subject, texts)


def _place(finding: Finding) -> tuple[str, int, str]:
    return str(finding.file), finding.line or 0, finding.what


def _of_content(problem: ContentError) -> Finding:
    what = f"{problem.what} ({problem.key})" if problem.key else problem.what
    return Finding(problem.file, problem.line, what, problem.next_step)


def _is_about(finding: Finding, wanted: set[str], exercises: Sequence[Exercise]) -> bool:
    """Whether it is about one of these exercises, or about their chapters' files in general."""
    if finding.exercise is not None:
        return finding.exercise in wanted
    return any(_is_of(finding.file, exercise.folder) for exercise in exercises)


def _is_of(file: Path, chapter: Path) -> bool:
    folders = (chapter, layout.solution_folder(chapter))
    return file == layout.grader_file(chapter) or any(file.is_relative_to(folder) for folder in folders)


def id_findings(subject: Subject) -> Iterator[Finding]:
    first: dict[str, tuple[Path, int]] = {}
    for chapter, reading in subject.lessons.items():
        if reading.value is None or reading.document is None:
            continue
        for index, exercise in enumerate(reading.value["exercises"]):
            name, line = exercise["id"], reading.document.line(("exercises", index, "id"))
            other, there = first.setdefault(name, (chapter, line))
            if other != chapter:
                what = f"`{name}` is an exercise of {other.name} too, on line {there} of its lesson.yaml"
                yield Finding(reading.document.file, line, what, "give each a different id", name)
