"""What survivors ask for, as findings on the grader's lines."""

from __future__ import annotations

from course.validate.model import Finding
from course.validate.mutation.model import Judged, Mutant, Mutation, Operator


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
        return f"no mistake makes {checks} fail by so little: add one that lies {between} here"
    return _MISSING[mutant.change.operator].format(checks)


_MISSING = {
    Operator.RETURN: "no mistake makes {} fail by what stands here: add one",
    Operator.RAISE: "no mistake makes {} fail in this place: add one",
    Operator.EXPECT: "no mistake makes {} fail by this expectation: add one that fails it and nothing else",
    Operator.BOUNDARY: "no mistake of {} lies just on this boundary: add one",
    Operator.COMPARISON: "no mistake of {} depends on this comparison: add one, or do without it",
    Operator.NOT: "no mistake of {} depends on this `not`: add one, or do without it",
    Operator.AND_OR: "in no mistake of {} one of these holds and the other does not: add one",
    Operator.BOUND: "no mistake makes {} fail by so little: add one that is only just wrong",
}
