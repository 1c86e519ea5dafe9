"""Quizzes and mysteries if nobody can be asked: in a pipe, for a program, in a batch."""

from __future__ import annotations

import shutil
from collections import Counter
from pathlib import Path
from random import Random
from typing import TYPE_CHECKING

import pytest

from course.cli.quiz import Asking, understood
from course.cli.review import drawn
from course.content import Choice, Question, open_course
from course.grading.quiz.questions import check_quiz
from course.home import CourseHome, create_home
from course.model.result import Verdict, from_json
from course.progress import Progress
from course.report.console import open_console

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.cli.conftest import Ros2course, Run


FIXTURE = Path(__file__).parents[1] / "fixtures/quiz_course"
RIGHT = FIXTURE / "solutions/05-lighthouses/answers/05-quiz.yaml"


@pytest.fixture
def run(ros2course: Ros2course, home: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Run]:
    """A command on the course of quizzes, with a home, at a quiz, and without any ROS."""
    ros2course("next", "05-quiz", course=FIXTURE)

    def no_ros() -> None:
        raise AssertionError("a quiz looked for ROS")

    monkeypatch.setattr("course.cli.check.find_ros", no_ros)
    return lambda *words: ros2course(*words, course=FIXTURE)


@pytest.fixture
def answers(home: Path) -> Path:
    (home / "answers").mkdir(parents=True)
    return home / "answers/05-quiz.yaml"


def test_it_never_asks(run: Callable[..., Run], home: Path) -> None:
    done = run("check")
    assert done.code == 1
    assert "There is no `answers/05-quiz.yaml`" in done.out
    assert "`ros2course check 05-quiz` asks" in done.out
    assert "Your answer" not in done.out
    assert not (home / "answers").exists()


def test_it_judges_the_file(run: Callable[..., Run], answers: Path, home: Path) -> None:
    shutil.copy(RIGHT, answers)
    done = run("check")
    assert (done.code, "Passed: 6 of 6 points." in done.out) == (0, True)
    assert "No two in sight of each other" in done.out, "right answers are explained"
    assert "Now you know your lights." in done.out
    with Progress.open(home / ".ros2course") as progress:
        assert progress.state("05-quiz") == "passed"


def test_json_is_the_same_result(run: Callable[..., Run], answers: Path) -> None:
    shutil.copy(RIGHT, answers)
    assert from_json(run("check", "--json").out).verdict is Verdict.PASSED


def test_a_wrong_answer_and_what_to_type_next(run: Callable[..., Run], answers: Path) -> None:
    answers.write_text("why: It saves oil\n")
    done = run("check")
    assert done.code == 1
    assert "A lamp that turns burns all the time." in done.out
    assert "answers/05-quiz.yaml:1" in done.out
    assert "tell" not in done.out, "the right answer stays untold"
    assert "check --again" in done.out.split("Type next:")[1]
    assert "hint" not in done.out.split("Type next:")[1]


def test_a_second_try_earns_half_here_and_in_a_class(
    run: Callable[..., Run], answers: Path, home: Path
) -> None:
    answers.write_text(RIGHT.read_text().replace("why: tell-apart", "why: It saves oil"))
    assert "for half the points" in run("check").out.split("Type next:")[1]
    assert run("check").code == 1, "the same answer once more is not another try"
    answers.write_text(answers.read_text().replace("why: It saves oil", "why: tell-apart"))
    done = run("check")
    assert (done.code, "Passed: 5.5 of 6 points" in done.out) == (0, True)
    assert "0.5 of 1" in done.out
    quiz = open_course(FIXTURE).exercise("05-quiz")
    assert check_quiz(quiz, home).points == 5.5, "what is handed in is judged in the same way"


def test_again_is_for_answers_only(run: Callable[..., Run], home: Path) -> None:
    from course.cli.check import _steps
    from course.content import open_course
    from course.model.result import CheckResult, Outcome, Result

    class Session:
        def __init__(self) -> None:
            self.home = CourseHome(home)

        progress = Progress.open(home / ".ros2course")

    keepers = open_course(FIXTURE).exercise("05-keepers")
    (home / "answers").mkdir(exist_ok=True)
    (home / "answers/05-keepers.yaml").write_text("rate: 1\n")
    for failed, command in (("greeted", "check 05-keepers"), ("rate", "check 05-keepers --again")):
        checks = (CheckResult(failed, "x", 1, Outcome.FAILED), CheckResult("type", "y", 1, Outcome.PASSED))
        steps = _steps(Session(), keepers, Result("05-keepers", Verdict.NOT_PASSED, checks))  # type: ignore[arg-type]
        assert steps[-1][0] == f"ros2course {command}"
    Session.progress.__exit__(None, None, None)


def test_what_was_left_open_is_worth_all_its_points(run: Callable[..., Run], answers: Path) -> None:
    for text in ("", "keeper: keeper\n"):
        answers.write_text(text)
        steps = run("check").out.split("Type next:")[1]
        assert "to answer what you left open" in steps and "--again" not in steps


def test_again_needs_a_terminal_and_questions(run: Callable[..., Run], ros2course: Ros2course) -> None:
    done = run("check", "--again")
    assert (done.code, "only be asked in a terminal" in done.err) == (2, True)
    done = ros2course("check", "--again", "04-light")
    assert (done.code, "has no questions" in done.err) == (2, True)


def test_next_says_what_to_type(run: Callable[..., Run]) -> None:
    quiz = run("next", "05-quiz").out.split("Type next:")[1]
    assert "ros2course check  to answer its 5 questions" in quiz
    assert "shell" not in quiz and "hint" not in quiz
    mystery = run("next", "05-keepers").out.split("Type next:")[1]
    assert [line.split()[1] for line in mystery.strip().splitlines()] == ["play", "shell", "check", "hint"]


def test_nothing_but_the_state_is_laid(run: Callable[..., Run], home: Path) -> None:
    texts = [file.read_text(errors="replace") for file in home.rglob("*") if file.is_file()]
    assert not any("rhythm" in text for text in texts)


def test_show_has_the_questions(run: Callable[..., Run]) -> None:
    shown = run("show").out
    assert "The questions:\n\nwhy\nWhy does a lighthouse blink?" in shown
    assert "  - Its rhythm tells which lighthouse it is" in shown
    assert "No two in sight" not in shown
    mystery = run("show", "05-keepers").out
    assert "What is the type of /" in mystery and "{topic}" not in mystery


def test_show_shuffles_by_the_learner(run: Callable[..., Run], home: Path) -> None:
    marker = home / ".ros2course/home.json"
    orders = set()
    for seed in range(12):
        marker.write_text(f'{{"schema": 1, "seed": {seed}}}')
        lines = run("show").out.partition("\nseen\n")[0].splitlines()
        orders.add(tuple(line for line in lines if line.startswith("  - ")))
    assert len(orders) > 4
    assert len({frozenset(order) for order in orders}) == 1


def test_hint_without_hints(run: Callable[..., Run]) -> None:
    done = run("hint")
    assert "There are no hints for 05-quiz." in done.out
    assert "check " in done.out and "to answer the questions" in done.out


def test_list_knows_both(run: Callable[..., Run], answers: Path) -> None:
    shutil.copy(RIGHT, answers)
    run("check")
    listed = run("list").out
    assert "ok  05-quiz" in listed and "6 of 6" in listed
    assert "05-keepers" in listed


def test_solution_shows_the_right_answers(run: Callable[..., Run], answers: Path) -> None:
    answers.write_text("why: It saves oil\n")
    assert run("solution").code == 2
    shown = run("solution", "--anyway").out
    assert "-why: It saves oil" in shown
    assert "+why: tell-apart" in shown


def test_reset_keeps_the_answers_in_a_backup(run: Callable[..., Run], answers: Path, home: Path) -> None:
    answers.write_text("why: It saves oil\n")
    run("reset", "05-quiz", "--yes")
    assert not answers.exists()
    assert len(list((home / ".ros2course/backups").glob("*/answers/05-quiz.yaml"))) == 1


def test_play_of_what_is_no_mystery(run: Callable[..., Run]) -> None:
    done = run("play")
    assert done.code == 2
    assert "05-quiz has nothing to play." in done.err
    assert "You can play: 05-keepers." in done.err


def test_the_seed_is_not_shown(run: Callable[..., Run], home: Path) -> None:
    seed = str(CourseHome(home).seed())
    for words in (("next", "05-keepers"), ("show",), ("check", "05-quiz"), ("list",)):
        done = run(*words)
        assert seed not in done.out + done.err


CHOICES = tuple(
    Choice(name, text, False) for name, text in (("keep", "It `keeps`"), ("b c", "b c"), (">>", ">>"))
)
ONE = Question("one", "?", "choice", CHOICES)
SOME = Question("some", "?", "choices", CHOICES)
NUMBER = Question("number", "?", "number", value=3)
TEXT = Question("text", "?", "text", texts=("x",))


@pytest.mark.parametrize(
    ("question", "typed", "texts"),
    [
        (ONE, "a", ("keep",)),
        (ONE, "A)", ("keep",)),
        (ONE, " c. ", (">>",)),
        (ONE, "it keeps", ("keep",)),
        (ONE, ">>", (">>",)),
        (ONE, "d", ()),
        (ONE, "a, b", ()),
        (ONE, "it keep", ()),
        (SOME, "a, c", ("keep", ">>")),
        (SOME, "ca", (">>", "keep")),
        (SOME, "C a", (">>", "keep")),
        (SOME, "b, b", ("b c",)),
        (SOME, "b c", ("b c",)),
        (SOME, "it keeps and >>", ("keep", ">>")),
        (SOME, "a, x", ()),
        (NUMBER, "2,5 Hz", ("2,5 Hz",)),
        (NUMBER, "many", ()),
        (TEXT, "a", ("a",)),
    ],
)
def test_what_is_meant(question: Question, typed: str, texts: tuple[str, ...]) -> None:
    assert understood(question, typed) == texts


@pytest.mark.slow
def test_a_program_runs_after_its_output_was_predicted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    program = tmp_path / "count.py"
    program.write_text("print(1)\nprint(1 / 0)\n")
    choices = (Choice("r", "`1` and a `ZeroDivisionError`", True), Choice("w", "`1` and `0`", False, "No."))
    question = Question("one", "What does it print?", "choice", choices, program=program)
    home = create_home(tmp_path / "home")
    shown_before = []

    def type_b(prompt: str) -> str:
        shown_before.append(capsys.readouterr().out)
        return "b"

    monkeypatch.setattr("builtins.input", type_b)
    exercise = open_course().exercises()[0]
    Asking(open_console(), home, exercise, (question,)).run(again=False)
    assert "It printed" not in shown_before[0]
    lines = [line.split() for line in capsys.readouterr().out.splitlines() if line.strip()]
    assert ["You", "said:", "`1`", "and", "`0`"] in lines
    assert lines[-2:] == [["It", "printed:", "1"], ["ZeroDivisionError:", "division", "by", "zero"]]


def test_a_review_draws_what_was_wrong_more_often() -> None:
    questions = [("01-quiz", str(number)) for number in range(40)]
    failures = {("01-quiz", "7"): 9}
    rounds = [drawn(questions, failures, Random(seed)) for seed in range(200)]
    assert {len(one) for one in rounds} == {len(set(one)) for one in rounds} == {8}
    often = Counter(question for one in rounds for _exercise, question in one)
    assert often["7"] > 2 * max(count for name, count in often.items() if name != "7")
