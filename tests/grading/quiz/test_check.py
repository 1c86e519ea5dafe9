"""An exercise with only questions, from the file of answers to the result."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from course.content import Exercise, open_course
from course.grading.check import Request, check_exercise
from course.grading.load import runs_programs
from course.grading.quiz.questions import check_quiz, with_questions
from course.model import replace
from course.model.result import CheckResult, Outcome, Result, Verdict, from_json, to_json

FIXTURE = Path(__file__).parents[2] / "fixtures/quiz_course"
RIGHT = FIXTURE / "solutions/05-lighthouses"


@pytest.fixture
def quiz() -> Exercise:
    return open_course(FIXTURE).exercise("05-quiz")


def answer(home: Path, text: str) -> Path:
    (home / "answers").mkdir()
    (home / "answers/05-quiz.yaml").write_text(text)
    return home


def outcomes(result: Result) -> list[str]:
    return [check.outcome.value for check in result.checks]


def test_all_right(quiz: Exercise) -> None:
    result = check_quiz(quiz, RIGHT)
    assert (result.verdict, result.points, result.max_points) == (Verdict.PASSED, 6, 6)
    assert [check.id for check in result.checks] == ["why", "seen", "keeper", "period", "colors"]
    assert from_json(to_json(result)) == result


def test_no_ros_is_needed(quiz: Exercise) -> None:
    assert not runs_programs(quiz)
    assert check_exercise(Request(quiz, RIGHT, ros=None)) == check_quiz(quiz, RIGHT)


def test_without_a_file_the_first_question_says_so(quiz: Exercise, tmp_path: Path) -> None:
    result = check_quiz(quiz, tmp_path)
    assert outcomes(result) == ["failed"] + ["skipped"] * 4
    assert result.verdict is Verdict.NOT_PASSED


def test_a_broken_file_is_the_learners_failure(quiz: Exercise, tmp_path: Path) -> None:
    result = check_quiz(quiz, answer(tmp_path, "why: [\n"))
    assert outcomes(result) == ["failed"] + ["skipped"] * 4
    assert result.verdict is Verdict.NOT_PASSED


def test_answers_to_no_question_are_told(quiz: Exercise, tmp_path: Path) -> None:
    text = (RIGHT / "answers/05-quiz.yaml").read_text()
    result = check_quiz(quiz, answer(tmp_path, text + "whether: no\n"))
    assert result.verdict is Verdict.PASSED
    assert result.notes == ("answers/05-quiz.yaml:6: there is no question `whether`.",)


def test_questions_come_after_a_graders_checks(quiz: Exercise) -> None:
    own = Result("05-quiz", Verdict.PASSED, (CheckResult("own", "Own", 1, Outcome.PASSED),))
    assert [check.id for check in with_questions(own, quiz, RIGHT, None).checks][:2] == ["own", "why"]


def test_one_of_the_two_failing_is_not_passing(quiz: Exercise, tmp_path: Path) -> None:
    failed = Result("05-quiz", Verdict.NOT_PASSED, (CheckResult("own", "Own", 1, Outcome.FAILED),))
    passed = replace(failed, verdict=Verdict.PASSED, checks=(CheckResult("own", "Own", 1, Outcome.PASSED),))
    assert with_questions(failed, quiz, RIGHT, None).verdict is Verdict.NOT_PASSED
    assert with_questions(passed, quiz, tmp_path, None).verdict is Verdict.NOT_PASSED


def test_a_question_named_like_a_check_is_our_error(quiz: Exercise) -> None:
    own = Result("05-quiz", Verdict.PASSED, (CheckResult("why", "Own", 1, Outcome.PASSED),))
    result = with_questions(own, quiz, RIGHT, None)
    assert result.verdict is Verdict.OUR_ERROR
    assert result.fault and "a check and a question named why" in result.fault.summary


def test_it_imports_no_ros() -> None:
    code = (
        "import sys; from pathlib import Path; from course.content import open_course;"
        "from course.grading.quiz.questions import check_quiz;"
        f"quiz = open_course(Path({str(FIXTURE)!r})).exercise('05-quiz');"
        f"print(check_quiz(quiz, Path({str(RIGHT)!r})).verdict.value);"
        "assert not {'rclpy', 'pytest'} & set(sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "passed\n"
