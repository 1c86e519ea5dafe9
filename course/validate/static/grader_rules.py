"""Errors in the declarations of grader modules."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path

from course.content import Exercise
from course.content.audit import way_between
from course.grading.author import BUILDS
from course.spelling import did_you_mean
from course.validate import Finding
from course.validate.static.graders import Declaration, DeclaredCheck, GraderModule
from course.validate.static.subject import Subject

Needs = Mapping[str, tuple[str, ...]]


def grader_findings(subject: Subject) -> Iterator[Finding]:
    for chapter, graders in subject.graders.items():
        declared = [one for each in graders.declared for one in _declaration_findings(graders.file, each)]
        yield from declared
        if graders.fault and not (graders.by_declaration and declared):
            yield graders.fault
        if graders.fault is None and subject.is_read(chapter):
            yield from _strangers(subject, chapter, graders)
            yield from _lacking(subject, chapter, graders)


def _declaration_findings(file: Path, declared: Declaration) -> Iterator[Finding]:
    first = {BUILDS: declared.line} if declared.builds else {}
    for check in declared.checks:
        if check.id in first:
            what = f"{declared.exercise} has two checks `{check.id}`; the first is on line {first[check.id]}"
            step = "give each a different id (`builds` is added automatically unless `builds=None`)"
            yield Finding(file, check.line, what, step, declared.exercise)
        first.setdefault(check.id, check.line)
    if declared.whole:
        yield from _need_findings(file, declared, first)


def _need_findings(file: Path, declared: Declaration, lines: Mapping[str, int]) -> Iterator[Finding]:
    needs = {check.id: check.needs or () for check in declared.checks}
    for check in declared.checks:
        for need in check.needs or ():
            found = _need_problem(check, need, needs, lines)
            if found:
                yield Finding(file, check.line, *found, declared.exercise)


def _need_problem(
    check: DeclaredCheck, need: str, needs: Needs, lines: Mapping[str, int]
) -> tuple[str, str] | None:
    if need not in lines:
        what = f"check `{check.id}` needs `{need}`, which is not a check{did_you_mean(need, lines)}"
        return what, f"checks of this grader: {', '.join(lines)}"
    circle = way_between(needs, need, check.id)
    if circle:
        if check.id != min(circle):  # reported once, not for each member of the circle
            return None
        what = f"check `{check.id}` needs itself: {' -> '.join((check.id, *circle))}"
        return what, "remove one of them from `needs`"
    if lines[need] > check.line:
        what = f"check `{check.id}` needs `{need}`, which is only on line {lines[need]}"
        return what, f"move `{need}` before it: checks run in this order"
    return None


def _strangers(subject: Subject, chapter: Path, graders: GraderModule) -> Iterator[Finding]:
    """Graders and mysteries of unknown exercises, or two of them for one exercise."""
    known = [exercise.id for exercise in subject.exercises_of(chapter)]
    for kind in (graders.graders, graders.mysteries):
        for exercise, count in Counter(one.exercise for one in kind).items():
            word = type(kind[0]).__name__
            line = _line(graders, word, exercise)
            if exercise not in known:
                what = f"`{word}` of `{exercise}`, which its chapter does not have"
                step = f"exercises of the chapter: {', '.join(known)}"
                yield Finding(graders.file, line, what + did_you_mean(exercise, known), step)
            elif count > 1:
                what = f"{exercise} has {count} of `{word}`, and only the first is used"
                yield Finding(graders.file, line, what, "keep one of them", exercise)


def _line(graders: GraderModule, word: str, exercise: str) -> int | None:
    texts = graders.file.read_text(encoding="utf-8", errors="replace").splitlines()
    named = (f'{word}("{exercise}"', f"{word}('{exercise}'")
    return next((i for i, text in enumerate(texts, 1) if any(name in text for name in named)), None)


def _lacking(subject: Subject, chapter: Path, graders: GraderModule) -> Iterator[Finding]:
    mysteries = {one.exercise for one in graders.mysteries}
    for index, exercise in enumerate(subject.exercises_of(chapter)):
        word = _lack(exercise, graders, mysteries)
        if word:
            line = subject.lessons[chapter].line(("exercises", index, "id"))
            what = f"{graders.file.name} has no `{word}` of {exercise.id}"
            step = f'add `{word}("{exercise.id}"...)` with its checks to {graders.file.name}'
            yield Finding(chapter / "lesson.yaml", line, what, step, exercise.id)


def _lack(exercise: Exercise, graders: GraderModule, mysteries: set[str]) -> str | None:
    if any(question.computed for question in exercise.questions) and exercise.id not in mysteries:
        return "Mystery"
    if (exercise.packages or not exercise.questions) and graders.of(exercise.id) is None:
        return "Grader"
    return None
