"""Right and wrong answers of every form, and what is said about them."""

from __future__ import annotations

import pytest

from course.content import Choice, KnownAnswer, Question
from course.grading.quiz.answers import Answers, Given
from course.grading.quiz.judge import is_a_try, judge, title
from course.model.feedback import Feedback
from course.model.result import CheckResult, Outcome

FILE = "answers/05-quiz.yaml"
LIGHTS = (
    Choice("rhythm", "Its `rhythm`", True, "Charts give it."),
    Choice("Its color", "Its color", True),
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
    wrong=(KnownAnswer("catkin_make", "That is of ROS 1."),),
    explain="It builds a workspace.",
)
EXACT = Question("exact", "Which?", "text", texts=("ROS_DISTRO",), exact=True, explain="It is a variable.")
ALL = Question(
    "all",
    "What does it make?",
    "all_of",
    texts=("build", "install", "log"),
    wrong=(KnownAnswer("src", "That is yours."),),
    explain="Three folders.",
)
NUMBER = Question(
    "number",
    "How often?",
    "number",
    value=10.0,
    tolerance=1.0,
    wrong=(KnownAnswer("0.1", "The period."),),
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
        (SOME, ["its color", "rhythm"]),
        (SOME, ["rhythm, its color"]),
        (SOME, ["Its rhythm and its color"]),
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
        (ONE, ["its smel"], "`its smel` is not one of the choices; did you mean `Its smell`?"),
        (SOME, ["rhythm"], "something is missing"),
        (SOME, ["rhythm", "Its color", "Its smell"], "Nobody smells it."),
        (SOME, ["rhythm", "noise"], "`noise` is not one of the choices"),
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
    assert "a different order" in (said(ONE, "b").advice or "")


@pytest.mark.parametrize(
    ("question", "texts", "why"),
    [
        (ONE, ["rhythm"], "Charts give it."),
        (SOME, ["Its color", "rhythm"], "Charts give it."),
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


def test_a_wrong_choice_is_shown_in_its_words() -> None:
    choices = (Choice("tick", "Its rhythm", right=True), Choice("nose", "Its smell", right=False, why="No."))
    feedback = said(Question("one", "Which?", "choice", choices), "nose")
    assert feedback.seen == "Its smell"
    assert said(Question("some", "Which?", "choices", choices), "nose").seen == "Its smell"
    assert ". A letter" in (said(Question("one", "Which?", "choice", choices), "b").advice or "")


def test_the_title_is_the_first_paragraph() -> None:
    assert title(Question("a", "# What is **this**?\n\n```\ncode\n```", "text")) == "What is this?"
    assert title(Question("a", "The build works.\nWhat is missing?\n\nThink first.", "text")) == (
        "The build works. What is missing?"
    )
    assert len(title(Question("a", "long " * 100, "text"))) < 190


@pytest.mark.parametrize(
    ("question", "texts", "counts"),
    [
        (ONE, ("Its smell",), True),
        (ONE, ("rhythm",), False),
        (ONE, ("b",), False),
        (ONE, ("-r", "-R"), False),
        (SOME, ("rhythm",), True),
        (SOME, ("Its smell, Its color",), True),
        (SOME, ("Its smell, Its nothing",), False),
        (TEXT, ("catkin_make",), True),
        (TEXT, ("colcon buidl",), False),
        (ALL, ("build", "install", "src"), True),
        (NUMBER, ("0.1",), True),
        (NUMBER, ("many",), False),
    ],
)
def test_only_a_wrong_answer_that_makes_sense_is_a_try(
    question: Question, texts: tuple[str, ...], counts: bool
) -> None:
    assert is_a_try(question, Given(texts)) is counts


def test_after_a_wrong_answer_the_right_one_earns_half() -> None:
    given = {"one": Given(("rhythm",), 7), "one.first": Given(("Its smell",), 8)}
    result = judge(ONE, Answers(FILE, given), frozenset({"one"}))
    assert (result.outcome, result.points, result.earned) == (Outcome.PASSED, 1, 0.5)
    assert Answers(FILE, given).unknown(frozenset({"one"})) == ()
