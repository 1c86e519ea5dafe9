"""The small course's quiz and mystery are proved as a real course is."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.arena.mystery_module import log_file, read_log
from course.build import Store
from course.content import Alternative, Exercise, Mistake, open_course
from course.errors import ContentError
from course.evidence.acts import Act
from course.grading import trial
from course.grading.check import Request, check_exercise
from course.grading.quiz.answers import read_answers
from course.grading.trial_answers import SEED, change_answers, lay_answers
from course.model.result import Outcome, Result, Verdict
from course.rosenv import find_ros

COURSE = open_course(Path(__file__).parents[1] / "fixtures/quiz_course")
QUIZ, KEEPERS = COURSE.exercises()
MISTAKES = [(one, mistake) for one in (QUIZ, KEEPERS) for mistake in one.mistakes()]
OTHER_WAYS = [(one, other) for one in (QUIZ, KEEPERS) for other in one.alternatives()]


def grade(exercise: Exercise, home: Path, tmp_path: Path, seed: int = SEED) -> Result:
    return check_exercise(Request(exercise, home, ros=find_ros(), store=Store(tmp_path / "store"), seed=seed))


@pytest.fixture
def home(tmp_path: Path) -> Path:
    (tmp_path / "home").mkdir()
    return tmp_path / "home"


@pytest.mark.slow
@pytest.mark.parametrize("exercise", [QUIZ, KEEPERS], ids=lambda one: one.id)
def test_the_reference_earns_all_points(exercise: Exercise, home: Path, tmp_path: Path) -> None:
    trial.lay_solution(COURSE, exercise, home)
    result = grade(exercise, home, tmp_path)
    assert (result.verdict, result.points) == (Verdict.PASSED, 6.0), result


@pytest.mark.slow
@pytest.mark.parametrize(("exercise", "other"), OTHER_WAYS, ids=[one.id for one, _ in OTHER_WAYS])
def test_other_words_earn_all_points(
    exercise: Exercise, other: Alternative, home: Path, tmp_path: Path
) -> None:
    trial.lay_alternative(COURSE, exercise, other, home)
    answers = read_answers(home, exercise.id)
    assert answers is not None
    name, texts = ("period", ("4.9",)) if exercise is QUIZ else ("type", ("std_msgs/Int32",))
    assert answers.given[name].texts == texts, "it is laid"
    assert grade(exercise, home, tmp_path).verdict is Verdict.PASSED


@pytest.mark.slow
@pytest.mark.parametrize(("exercise", "mistake"), MISTAKES, ids=[mistake.id for _, mistake in MISTAKES])
def test_each_mistake_is_caught(exercise: Exercise, mistake: Mistake, home: Path, tmp_path: Path) -> None:
    trial.lay_mistake(COURSE, exercise, mistake, home)
    result = grade(exercise, home, tmp_path)
    failed = {check.id: check for check in result.checks if check.outcome is Outcome.FAILED}
    assert set(failed) == {mistake.caught_by, *mistake.also_fails}
    said = repr(failed[mistake.caught_by].feedback)
    assert [word for word in mistake.says if word not in said] == []
    assert result.verdict is Verdict.NOT_PASSED


@pytest.mark.slow
@pytest.mark.parametrize("exercise", [QUIZ, KEEPERS], ids=lambda one: one.id)
def test_who_begins_has_not_passed(exercise: Exercise, home: Path, tmp_path: Path) -> None:
    trial.lay_starter(COURSE, exercise, home)
    assert grade(exercise, home, tmp_path).verdict is Verdict.NOT_PASSED


@pytest.mark.slow
def test_a_copied_answer_is_a_wrong_one(home: Path, tmp_path: Path) -> None:
    lay_answers(KEEPERS, home)
    result = grade(KEEPERS, home, tmp_path, seed=SEED + 1)
    right = {check.id for check in result.checks if check.outcome is Outcome.PASSED}
    assert right <= {"greeted", "type", "tool", "rate"}
    assert result.verdict is Verdict.NOT_PASSED


@pytest.mark.slow
def test_without_a_seed_a_mystery_is_our_error(home: Path, tmp_path: Path) -> None:
    lay_answers(KEEPERS, home)
    result = check_exercise(Request(KEEPERS, home, ros=find_ros(), store=Store(tmp_path / "store")))
    assert result.verdict is Verdict.OUR_ERROR


def test_a_stored_answers_file_is_kept(home: Path) -> None:
    trial.lay_solution(COURSE, QUIZ, home)
    assert "colors: red, white and green" in (home / "answers/05-quiz.yaml").read_text()


def test_acts_of_the_reference_are_laid(home: Path) -> None:
    lay_answers(KEEPERS, home)
    assert read_log(log_file(home / ".ros2course", "05-keepers")) == (Act("greeted"),)


def test_a_change_of_no_question(home: Path) -> None:
    lay_answers(QUIZ, home)
    with pytest.raises(ContentError, match="no question `wy`; did you mean `why`") as caught:
        change_answers(QUIZ, home, {"wy": "x"}, Path("mistakes.yaml"))
    assert caught.value.file == Path("mistakes.yaml")
