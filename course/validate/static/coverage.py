"""Whether mistakes name checks and questions that exist, and whether a mistake names each check."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

from course.content import Exercise, Mistake, answers_file, layout
from course.content.document import Document, Place
from course.spelling import did_you_mean
from course.validate import Finding
from course.validate.static.subject import Subject


def proof_findings(subject: Subject) -> Iterator[Finding]:
    for chapter, reading in subject.mistakes.items():
        for index, mistake in enumerate(reading.value or ()):
            exercise = subject.exercises.get(mistake.exercise)
            if exercise is not None and reading.document is not None and exercise.folder == chapter:
                yield from _unknown_checks(subject, reading.document, index, mistake)
                yield from _unknown_questions(reading.document, index, mistake, exercise)
    yield from _unknown_in_alternatives(subject)
    for exercise in subject.exercises.values():
        yield from _unproved(subject, exercise)


def checks_of(subject: Subject, exercise: Exercise) -> Mapping[str, tuple[Path, int | None]] | None:
    """Every check of the exercise, with its place; None if the checks are not known."""
    graders = subject.graders.get(exercise.folder)
    if graders is not None and graders.fault:
        return None
    grader = graders.of(exercise.id) if graders else None
    if grader is None and not exercise.questions:
        return None  # the missing grader is reported elsewhere
    found: dict[str, tuple[Path, int | None]] = {}
    for check in grader.checks if grader else ():
        assert graders is not None
        found[check] = (graders.file, graders.line_of(exercise.id, check))
    lesson = subject.lessons[exercise.folder]
    index = subject.exercises_of(exercise.folder).index(exercise)
    for number, question in enumerate(exercise.questions):
        line = lesson.line(("exercises", index, "questions", number, "id"))
        found.setdefault(question.id, (exercise.folder / "lesson.yaml", line))
    return found


def _unknown_checks(subject: Subject, document: Document, index: int, mistake: Mistake) -> Iterator[Finding]:
    checks = checks_of(subject, subject.exercises[mistake.exercise])
    if checks is None:
        return
    named: list[tuple[str, Place]] = [(mistake.caught_by, ("mistakes", index, "caught_by"))]
    named += [(name, ("mistakes", index, "also_fails", n)) for n, name in enumerate(mistake.also_fails)]
    for name, place in named:
        if name not in checks:
            what = f"`{mistake.id}`: {mistake.exercise} has no check `{name}`{did_you_mean(name, checks)}"
            step = f"checks of the exercise: {', '.join(checks)}"
            yield Finding(document.file, document.line(place), what, step, mistake.exercise)


def _unknown_questions(
    document: Document, index: int, mistake: Mistake, exercise: Exercise
) -> Iterator[Finding]:
    known = [question.id for question in exercise.questions]
    for number, edit in enumerate(mistake.edits):
        place: Place = ("mistakes", index, "edits", number)
        for name in edit.answers or ():
            if name not in known:
                what = f"`{mistake.id}`: {exercise.id} has no question `{name}`{did_you_mean(name, known)}"
                line = document.line((*place, "answers", name))
                step = f"questions of the exercise: {', '.join(known) or 'none'}"
                yield Finding(document.file, line, what, step, exercise.id)
        if edit.answers and edit.file != answers_file(exercise.id):
            what = f"`{mistake.id}`: the answers of {exercise.id} are not in `{edit.file}`"
            line = document.line((*place, "file"))
            yield Finding(document.file, line, what, f"write `{answers_file(exercise.id)}`", exercise.id)


def _unknown_in_alternatives(subject: Subject) -> Iterator[Finding]:
    for reading in subject.alternatives:
        other = reading.value
        if other is None:
            continue
        solved = [subject.exercises.get(one) for one in other.exercises]
        known = [question.id for exercise in solved if exercise for question in exercise.questions]
        for name in other.answers:
            if name not in known and None not in solved:
                what = f"`{other.name}` answers `{name}`, which none of its exercises asks"
                step = f"their questions: {', '.join(known) or 'none'}"
                line = reading.line(("answers", name))
                yield Finding(other.tree / layout.ALTERNATIVE, line, what + did_you_mean(name, known), step)


def _unproved(subject: Subject, exercise: Exercise) -> Iterator[Finding]:
    """Checks that no mistake fails: they might pass everything."""
    reading = subject.mistakes[exercise.folder]
    if reading.problems:
        return  # the mistakes are not all known
    own = [mistake for mistake in reading.value or () if mistake.exercise == exercise.id]
    named = {name for mistake in own for name in (mistake.caught_by, *mistake.also_fails)}
    for check, (file, line) in (checks_of(subject, exercise) or {}).items():
        if check not in named and _can_fail(subject, exercise, check):
            what = f"no mistake fails check `{check}` of {exercise.id}"
            step = f"add one to {exercise.folder.name}/mistakes.yaml, with `caught_by: {check}`"
            yield Finding(file, line, what, step, exercise.id)


def _can_fail(subject: Subject, exercise: Exercise, check: str) -> bool:
    graders = subject.graders.get(exercise.folder)
    declared = graders.declaration(exercise.id) if graders else None
    return all(one.can_fail for one in (declared.checks if declared else ()) if one.id == check)
