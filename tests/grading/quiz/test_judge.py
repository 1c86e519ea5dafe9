"""Right and wrong answers of every form, and what is said of them."""

from __future__ import annotations

import pytest

from course.content import Choice, Known, Question
from course.feedback import Feedback
from course.grading.quiz.answers import Answers, Given
from course.grading.quiz.judge import judge, title
from course.grading.result import CheckResult, Outcome

FILE = "answers/05-quiz.yaml"
LIGHTS = (
    Choice("rhythm", "Its `rhythm`", True, "Charts give it."),
    Choice("Its colour", "Its colour", True),
    Choice("Its smell", "Its smell", False, "Nobody smells it."),
    Choice("-r", "-r", False, "That is the small one."),
    Choice("-R", "-R", False, "That is the large one."),
)
ONE = Question("one", "Which?", "choice", (LIGHTS[0], *LIGHTS[2:]), explain="Remember it.")
SOME = Question("some", "Which ones?", "choices", LIGHTS[:3])
TEXT = Question(
    "text",
    "What builds?",
    "text",
    texts=("colcon build", "colcon"),
    wrong=(Known("catkin_make", "That is of ROS 1."),),
    explain="It builds a workspace.",
)
EXACT = Question("exact", "Which?", "text", texts=("ROS_DISTRO",), exact=True, explain="It is a variable.")
ALL = Question(
    "all",
    "What does it make?",
    "all_of",
    texts=("build", "install", "log"),
    wrong=(Known("src", "That is yours."),),
    explain="Three folders.",
)
NUMBER = Question(
    "number",
    "How often?",
    "number",
    value=10.0,
    tolerance=1.0,
    wrong=(Known("0.1", "The period."),),
    explain="Hz.",
)


def check(question: Question, *texts: str) -> CheckResult:
    answers = Answers(FILE, {question.id: Given(texts, 7)})
    return judge(question, answers, frozenset({question.id}))


def said(question: Question, *texts: str) -> Feedback:
    result = check(question, *texts)
    assert result.outcome is Outcome.FAILED
    assert result.feedback is not None
    return result.feedback


@pytest.mark.parametrize(
    ("question", "texts"),
    [
        (ONE, ["rhythm"]),
        (ONE, ["its Rhythm."]),
        (ONE, ["  its   `rhythm` "]),
        (SOME, ["its colour", "rhythm"]),
        (SOME, ["rhythm, its colour"]),
        (SOME, ["Its rhythm and its colour"]),
        (TEXT, ["Colcon  Build"]),
        (TEXT, ["`colcon`"]),
        (EXACT, ["ROS_DISTRO "]),
        (ALL, ["log", "build", "install"]),
        (ALL, ["build, install and log"]),
        (ALL, ["build install log"]),
        (ALL, ["BUILD; LOG, and install"]),
        (NUMBER, ["10"]),
        (NUMBER, ["9,1 Hz"]),
        (NUMBER, ["~ 1.1e1"]),
        (NUMBER, ["+11.0Hz"]),
    ],
)
def test_right_answers(question: Question, texts: list[str]) -> None:
    assert check(question, *texts).outcome is Outcome.PASSED


@pytest.mark.parametrize(
    ("question", "texts", "words"),
    [
        (ONE, ["Its smell"], "Nobody smells it."),
        (ONE, ["-R"], "That is the large one."),
        (ONE, ["-r"], "That is the small one."),
        (ONE, ["rhythm", "Its smell"], "Only one answer"),
        (ONE, ["its smel"], "`its smel` is none of the choices; did you mean `Its smell`?"),
        (SOME, ["rhythm"], "not all"),
        (SOME, ["rhythm", "Its colour", "Its smell"], "Nobody smells it."),
        (SOME, ["rhythm", "noise"], "`noise` is none of the choices"),
        (TEXT, ["catkin_make"], "That is of ROS 1."),
        (TEXT, ["make"], "It builds a workspace."),
        (EXACT, ["ros_distro"], "It is a variable."),
        (ALL, ["build and log"], "something is missing"),
        (ALL, ["build, log, src"], "That is yours."),
        (ALL, ["build, log, install, test"], "Three folders."),
        (NUMBER, ["0.1"], "The period."),
        (NUMBER, ["0,102 s"], "The period."),
        (NUMBER, ["12"], "Hz."),
        (NUMBER, ["0.5"], "Hz."),
        (NUMBER, ["ten"], "`ten` is not a number"),
        (NUMBER, ["1e999"], "not a number"),
        (NUMBER, ["nan"], "not a number"),
        (NUMBER, ["9" * 5000], "not a number"),
    ],
)
def test_wrong_answers_get_their_own_explanation(question: Question, texts: list[str], words: str) -> None:
    feedback = said(question, *texts)
    assert words in feedback.summary
    assert str(feedback.where[0]) == f"{FILE}:7"


def test_wrong_answers_do_not_tell_the_right_one() -> None:
    for question, wrong in ((ONE, "Its smell"), (TEXT, "make"), (ALL, "build"), (NUMBER, "3")):
        feedback = said(question, wrong)
        told = " ".join(filter(None, (feedback.summary, feedback.advice, *feedback.details)))
        assert not any(right in told for right in ("rhythm", "colcon", "install", "10"))


def test_a_slip_of_the_keyboard_is_told() -> None:
    assert "spelling" in (said(TEXT, "colcon biuld").advice or "")
    assert said(TEXT, "something else").advice is None


def test_a_letter_is_no_choice() -> None:
    assert "another order" in (said(ONE, "b").advice or "")


@pytest.mark.parametrize(
    ("question", "texts", "why"),
    [
        (ONE, ["rhythm"], "Charts give it."),
        (SOME, ["Its colour", "rhythm"], "Charts give it."),
        (TEXT, ["colcon"], "It builds a workspace."),
    ],
)
def test_right_answers_are_explained(question: Question, texts: list[str], why: str) -> None:
    assert check(question, *texts).feedback == Feedback(summary=why)


def test_nothing_answered() -> None:
    result = judge(ONE, Answers(FILE, {"one": Given(())}), frozenset({"one"}))
    assert result.feedback == Feedback(summary="It is not answered yet.")


def test_a_misspelt_question_is_named() -> None:
    result = judge(NUMBER, Answers(FILE, {"nubmer": Given(("10",), 3)}), frozenset({"number"}))
    assert result.feedback is not None
    assert "`nubmer`" in result.feedback.summary
    assert str(result.feedback.where[0]) == f"{FILE}:3"
    assert "`number`" in (result.feedback.advice or "")


def test_the_title_is_the_first_line() -> None:
    assert title(Question("a", "# What is **this**?\n\n```\ncode\n```", "text")) == "What is this?"
    assert len(title(Question("a", "long " * 100, "text"))) < 130
