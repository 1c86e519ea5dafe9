"""What a grader's author writes, and the mistakes that are noticed at once."""

from __future__ import annotations

import pytest

from course.errors import OurFault
from course.evidence.packages import BuiltPackages
from course.evidence.recording import Recording
from course.grading.author import BUILDS, CheckSpec, Grader
from course.model.feedback import Failure, Feedback


def judge(recording: Recording) -> None:
    """Any check."""


def test_that_the_packages_build_comes_first() -> None:
    grader = Grader("01-toy")
    assert list(grader.checks.values()) == [CheckSpec(BUILDS, "the packages build", 1, False, (), "01-toy")]
    assert Grader("01-toy", builds=3).checks[BUILDS].points == 3
    assert Grader("01-toy", builds=None).checks == {}


def test_a_check_needs_the_build_unless_it_says_otherwise() -> None:
    grader = Grader("01-toy")
    grader.check("one", "first")(judge)
    grader.check("two", "second", points=2, bonus=True, needs="one")(judge)
    grader.check("three", "third", needs=["one", "two"])(judge)
    grader.check("four", "fourth", needs=())(judge)
    assert [check.needs for check in grader.checks.values()] == [(), (BUILDS,), ("one",), ("one", "two"), ()]
    two = grader.checks["two"]
    assert (two.title, two.points, two.bonus, two.exercise) == ("second", 2, True, "01-toy")


def test_without_a_build_nothing_is_needed() -> None:
    grader = Grader("01-toy", builds=None)
    grader.check("one", "first")(judge)
    assert grader.checks["one"].needs == ()


def test_functions_stay_plain_functions() -> None:
    grader = Grader("01-toy")
    assert grader.check("one", "first")(judge) is judge
    assert grader.functions["one"] is judge
    assert grader.scenario(judge) is judge  # type: ignore[arg-type, comparison-overlap]
    assert grader.scenario_function is judge  # type: ignore[comparison-overlap]


def test_two_scenarios_are_our_fault() -> None:
    grader = Grader("01-toy")
    grader.scenario(lambda arena: None)
    with pytest.raises(OurFault, match="01-toy has two scenarios"):
        grader.scenario(lambda arena: None)


@pytest.mark.parametrize("name", ["one", BUILDS])
def test_two_checks_of_one_name_are_our_fault(name: str) -> None:
    grader = Grader("01-toy")
    grader.check("one", "first")(judge)
    with pytest.raises(OurFault, match=f"two checks named {name}"):
        grader.check(name, "again")(judge)


@pytest.mark.parametrize("needs", ["lost", ["one", "lost"], "self"])
def test_a_need_that_does_not_stand_before_is_our_fault(needs: str | list[str]) -> None:
    grader = Grader("01-toy")
    grader.check("one", "first")(judge)
    with pytest.raises(OurFault, match="is not defined before it"):
        grader.check("self", "second", needs=needs)(judge)
    assert "self" not in grader.checks


def test_the_build_is_judged() -> None:
    builds = Grader("01-toy").functions[BUILDS]
    builds(Recording("01-toy"))
    feedback = Feedback("it does not build")
    with pytest.raises(Failure) as caught:
        builds(Recording("01-toy", packages=BuiltPackages(failure=feedback)))
    assert caught.value.feedback is feedback
