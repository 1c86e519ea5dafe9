"""The figures of a class."""

from __future__ import annotations

from course.report.page import views
from course.report.page.data import ClassPage
from tests.report.page.classes import large, small


def test_totals() -> None:
    found = views.totals(small())
    assert (found.people, found.gradings, found.passed, found.not_passed, found.not_judged) == (5, 4, 1, 2, 1)
    assert found.states == {"complete": 3, "incomplete": 1, "not handed in": 1}
    assert found.median_percent == 40  # 5, 3, 1 and 0 of 5


def test_a_class_of_nobody() -> None:
    nobody = ClassPage("Course", small().exercises, (), small().began, small().ended)
    assert views.totals(nobody).median_percent is None
    assert sum(bar.count for bar in views.distribution(nobody)) == 0
    assert views.mistakes(nobody) == []
    (exercise,) = views.exercises(nobody)
    assert (exercise.percent, exercise.points, exercise.checks) == (None, None, ())


def test_the_distribution_counts_all_who_have_a_total() -> None:
    counts = {bar.label: bar.count for bar in views.distribution(small()) if bar.count}
    assert counts == {"100% or more": 1, "60–69%": 1, "20–29%": 1, "0–9%": 1}


def test_how_hard_an_exercise_and_its_checks_were() -> None:
    (exercise,) = views.exercises(small())
    assert (exercise.handed_in, exercise.passed, exercise.not_passed, exercise.not_judged) == (4, 1, 2, 1)
    assert exercise.percent == 33
    assert exercise.points == 3
    starts = next(check for check in exercise.checks if check.title == "the node starts and keeps running")
    assert (starts.judged, starts.passed, starts.failed, starts.not_reached) == (3, 2, 1, 0)
    assert starts.percent == 67
    topic = next(check for check in exercise.checks if check.title.startswith("it has a publisher"))
    assert (topic.judged, topic.passed, topic.failed, topic.not_reached) == (3, 1, 1, 1)


def test_mistakes_have_the_same_words_and_the_commonest_is_first() -> None:
    found = views.mistakes(large(13))  # the second and the third of five, over and over
    assert [len(mistake.people) for mistake in found] == [3, 3]
    assert found[0].words == "The node publishes on `/amazing_quotes`, not `/amazing_quote`."
    assert found[0].people == (1, 6, 11)


def test_our_errors_are_listed_apart() -> None:
    (trouble,) = views.troubles(small())
    assert (trouble.exercise, trouble.verdict, trouble.people) == ("18-publisher", "our error", (3,))
