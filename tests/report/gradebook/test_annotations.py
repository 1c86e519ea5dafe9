"""Workflow commands: ten at most, the useful ones, and none that a submission wrote."""

from __future__ import annotations

import re

import pytest

from course.model import replace
from course.model.feedback import Feedback, Location
from course.model.gradebook import GradedSubmission
from course.model.result import CheckResult, Outcome, Result, Verdict
from course.report.gradebook import github
from course.report.gradebook.sheets import Mark, Sheet
from tests.report.gradebook import hostile, samples

COMMAND = re.compile(r"::error (title=[^,:]*)(,file=[^,:]*)?(,line=\d+)?::(.*)")


def sheet(*checks: CheckResult, exercises: tuple[str, ...] = ("x",)) -> Sheet:
    marks = tuple(
        Mark(replace(samples.EXERCISE, id=name), Result(name, Verdict.NOT_PASSED, checks))
        for name in exercises
    )
    return Sheet(samples.ADA.person, "", (), marks)


def failed(name: str, *where: Location) -> CheckResult:
    return CheckResult(name, name, 1, Outcome.FAILED, feedback=Feedback(f"{name} is wrong", where=where))


def titles(made: Sheet) -> list[str]:
    return [re.sub(r".*title=([^,:]*).*", r"\1", line) for line in github.commands(made)]


def test_a_failure_stands_at_its_line() -> None:
    (line,) = github.commands(samples.sheet_of(samples.BAO))
    match = COMMAND.fullmatch(line)
    assert match is not None
    assert match[1] == "title=18-publisher%3A it has a publisher on /amazing_quote"
    assert match[2].endswith("_node.py") and match[3] == ",line=21"
    assert match[4].endswith("exactly like this: `amazing_quote`.")


def test_the_most_useful_ten() -> None:
    vague = [failed(f"vague{n}") for n in range(9)]
    placed = [failed(f"placed{n}", Location("a.py", n + 1)) for n in range(4)]
    found = titles(sheet(*vague, *placed, failed("file", Location("b.py"))))
    assert len(found) == github.MOST == 10
    assert found[:5] == [f"x%3A placed{n}" for n in range(4)] + ["x%3A file"]


def test_each_exercise_gets_its_first_before_any_second() -> None:
    checks = (failed("one", Location("a.py", 1)), failed("two", Location("a.py", 2)))
    other = sheet(failed("one", Location("b.py", 1)), exercises=("y",))
    both = replace(other, marks=(*sheet(*checks).marks, *other.marks))
    assert titles(both) == ["x%3A one", "y%3A one", "x%3A two"]


def test_one_line_is_named_once() -> None:
    assert titles(sheet(failed("one", Location("a.py", 1)), failed("two", Location("a.py", 1)))) == [
        "x%3A one"
    ]


def test_places_can_be_moved_into_the_repository() -> None:
    made = sheet(failed("one", Location("home/a.py", 1)))
    (line,) = github.commands(made, lambda file: file.removeprefix("home/"))
    assert ",file=a.py,line=1::" in line


def test_who_passed_has_none_and_our_error_has_no_place() -> None:
    assert github.commands(samples.sheet_of(samples.ADA)) == []
    (line,) = github.commands(samples.sheet_of(samples.DILARA))
    assert "file=" not in line and "The course itself has an error here." in line


def test_what_means_something_to_the_runner_is_escaped() -> None:
    check = replace(failed("a,b:c%", Location("a,b:c.py", 1)), feedback=Feedback("50% a:b,c\nd\re"))
    (line,) = github.commands(sheet(check))
    assert line == "::error title=x%3A a%2Cb%3Ac%25::50%25 a:b,c%0Ad%0De"


@pytest.mark.parametrize("text", hostile.TEXTS, ids=lambda text: ascii(text[:20]))
def test_hostile_texts_make_no_command_of_their_own(text: str) -> None:
    graded: GradedSubmission = hostile.graded(text)
    for line in github.commands(samples.sheet_of(graded, hostile.CLEANER)):
        match = COMMAND.fullmatch(line)
        assert match, line
        assert not re.search(r"%(?!25|0D|0A|3A|2C)", line)
