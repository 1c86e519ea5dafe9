"""How weakened graders are shown."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from course.report.console import open_console
from course_mutation.model import Change, Fate, Judged, Mutant, Mutation, OfExercise, Operator
from course_mutation.report import render_mutation

BOUND = Change(Operator.BOUND, 0, 1, b"", (1.0, 2.0))
MUTANT = Mutant("18-publisher", Path("graders/x.py"), 12, "rate", ("rate",), BOUND, "a < 1", "a < \x1b[31m2")


def row(survived: int = 0) -> OfExercise:
    fates = [Fate.KILLED] * 3 + [Fate.BROKEN] * 2 + [Fate.ENDLESS] + [Fate.SURVIVED] * survived
    judged = tuple(Judged(MUTANT, fate) for fate in fates)
    return OfExercise("18-publisher", judged, recorded=4, kept=5, recording=12.3, judging=4.56)


def shown(*exercises: OfExercise) -> list[str]:
    stream = io.StringIO()
    render_mutation(open_console(stream, width=100), Mutation(exercises))
    return stream.getvalue().splitlines()


def test_all_noticed() -> None:
    head, line, *_, end = shown(row())
    assert head.split() == "exercise mutants killed broken endless survived recorded seconds".split()
    assert line.split() == ["18-publisher", "6", "3", "2", "1", "0", "4/9", "12+4.6"]
    assert end == "All 6 mutants were noticed."


def test_survivors_by_line() -> None:
    lines = shown(row(survived=1), row())
    assert lines[lines.index("graders/x.py") :] == [
        "graders/x.py",
        "    12  18-publisher, `rate`: a bound made wider",
        "        - a < 1",
        "        + a < 2",
        "        try  no mistake makes `rate` fail by so little: add one that is between 1 and 2 here",
        "",
        "1 of 13 mutants survived: a mistake is missing for each.",
    ]
    assert any(line.split()[:5] == ["in", "all", "13", "6", "4"] for line in lines)


@pytest.mark.parametrize(
    ("exercises", "end"),
    [
        ([OfExercise("x", problems=("it does not build",))], "Not everything could be judged."),
        ([], "There was nothing to mutate."),
    ],
)
def test_endings(exercises: list[OfExercise], end: str) -> None:
    lines = shown(*exercises)
    assert lines[-1] == end
    assert any("it does not build" in line for line in lines) is bool(exercises)
