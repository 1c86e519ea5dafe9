"""All mutants of the grader of one exercise."""

from __future__ import annotations

import re

from course.content import Exercise
from course.errors import OurFault
from course.validate import Finding
from course_mutation.model import Change, Judged, Mutant, Mutation, Operator
from course_mutation.operators import changes
from course_mutation.source import Judging, Source, words

_BLANKS = re.compile(r"\s+")
_LONGEST = 110
_BESIDE = 30


def mutants(exercise: Exercise) -> tuple[Mutant, ...]:
    """In the order of the file. Raises OurFault if the grader cannot be read."""
    source = _read(exercise)
    judging = source.judging(exercise.id)
    left_alone = words([one.node for one in judging])
    found = {
        change: _mutant(exercise, source, one, change)
        for one in judging
        for change in changes(source, one, left_alone)
    }
    return tuple(sorted(found.values(), key=lambda mutant: (mutant.line, mutant.change.start)))


def _read(exercise: Exercise) -> Source:
    try:
        return Source(exercise.grader)
    except (OSError, SyntaxError, ValueError) as error:
        raise OurFault(f"the grader of {exercise.id} cannot be read: {error}") from error


def _mutant(exercise: Exercise, source: Source, judging: Judging, change: Change) -> Mutant:
    return Mutant(
        exercise=exercise.id,
        file=source.file,
        line=source.line_of(change.start),
        function=judging.node.name,
        checks=judging.checks,
        change=change,
        before=_shown(source.text, change.start, change.end),
        after=_shown(change.applied(source.text), change.start, change.start + len(change.new)),
        text=source.text,
    )


def _shown(text: bytes, start: int, end: int) -> str:
    """This part of the text, with the rest of its lines."""
    begin, after = text.rfind(b"\n", 0, start) + 1, text.find(b"\n", end)
    before, changed = _tidy(text[begin:start]), _tidy(text[start:end])
    rest = _tidy(text[end : after if after >= 0 else len(text)])
    if len(before) + len(changed) + len(rest) > _LONGEST:
        before = before if len(before) <= _BESIDE else f"…{before[-_BESIDE:]}"
        rest = rest if len(rest) <= _BESIDE else f"{rest[:_BESIDE]}…"
        room = _LONGEST - len(before) - len(rest)
        changed = changed if len(changed) <= room else f"{changed[:room]}…"
    return f"{before}{changed}{rest}".strip()


def _tidy(part: bytes) -> str:
    return _BLANKS.sub(" ", part.decode(errors="replace"))


def findings(mutation: Mutation) -> list[Finding]:
    """One for each survivor, in the order of the files."""
    every = [_finding(one) for exercise in mutation.exercises for one in exercise.survivors]
    return sorted(every, key=lambda one: (str(one.file), one.line or 0))


def _finding(one: Judged) -> Finding:
    mutant = one.mutant
    what = f"no mistake notices {mutant.change.operator.value}: `{mutant.before}` → `{mutant.after}`"
    return Finding(mutant.file, mutant.line, what, suggestion(mutant), mutant.exercise)


def suggestion(mutant: Mutant) -> str:
    """The mistake that is missing."""
    checks = " or ".join(f"`{check}`" for check in mutant.checks)
    if mutant.change.bounds:
        low, high = sorted(mutant.change.bounds)
        between = f"between {low:g} and {high:g}"
        return f"no mistake makes {checks} fail by so little: add one that is {between} here"
    return _MISSING[mutant.change.operator].format(checks)


_MISSING = {
    Operator.RETURN: "no mistake makes {} fail because of this line: add one",
    Operator.RAISE: "no mistake makes {} fail in this place: add one",
    Operator.EXPECT: "no mistake makes {} fail by this expectation: add one that fails it and nothing else",
    Operator.BOUNDARY: "no mistake of {} is exactly on this boundary: add one",
    Operator.COMPARISON: "no mistake of {} depends on this comparison: add one, or remove it",
    Operator.NOT: "no mistake of {} depends on this `not`: add one, or remove it",
    Operator.AND_OR: "in no mistake of {} is one of these true and the other false: add one",
    Operator.BOUND: "no mistake makes {} fail by so little: add one that is only just wrong",
}
