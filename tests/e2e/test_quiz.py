"""A quiz asked on a pseudo-terminal: answers by letter and word, later, Ctrl+C, Ctrl+D, again."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pexpect
import pytest

from course.grading.quiz.answers import read_answers
from tests.e2e.conftest import COMMAND

pytestmark = pytest.mark.slow

FIXTURE = Path(__file__).parents[1] / "fixtures/quiz_course"
PROMPT = r"Your answer[^\r\n]*: "
STYLING = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]")
INTERRUPT, END = "\x03", "\x04"
Ask = Callable[..., tuple[str, int | None]]


@pytest.fixture
def answer(environment: dict[str, str], guarded_home: Path) -> Iterator[Ask]:
    """Run a command, typing one of `typed` at each question; returns what it showed, and its exit code.

    One with `=` is typed as what follows it, if what precedes it was shown last; else nothing is.
    """

    def run(*words: str, typed: tuple[str, ...] = ()) -> tuple[str, int | None]:
        child = pexpect.spawn(
            COMMAND[0],
            [*COMMAND[1:], "--course", str(FIXTURE), *words],
            env={**environment, "TERM": "xterm", "NO_COLOR": "1"},
            cwd=str(guarded_home),
            dimensions=(24, 80),
            encoding="utf-8",
            timeout=60,
        )
        shown = ""
        for line in typed:
            child.expect(PROMPT)
            shown += child.before + child.after
            only, _, text = line.rpartition("=")
            line = text if child.before.endswith(only) else ""
            if line in (INTERRUPT, END):
                child.send(line)
            else:
                child.sendline(line)
        shown += child.read()
        child.close()
        return STYLING.sub("", shown).replace("\r\n", "\n"), child.exitstatus

    run("next", "05-quiz")
    yield run


def kept(home: Path) -> dict[str, tuple[str, ...]]:
    answers = read_answers(home, "05-quiz")
    assert answers is not None
    return {name: given.texts for name, given in answers.given.items() if given.texts}


RIGHT = {"why": "its rhythm tells which lighthouse it is", "seen": "its color, its rhythm"}


def test_all_questions_one_after_the_other(answer: Ask, course_home: Path) -> None:
    shown, code = answer("check", typed=(*RIGHT.values(), "keeper", "5 s", "red, green and white"))
    assert code == 0, shown
    for number in range(1, 6):
        assert f"Question {number} of 5" in shown
    assert "Passed: 6 of 6 points." in shown
    assert kept(course_home)["why"] == ("tell-apart",)
    shown, code = answer("check")
    assert (code, "Question" in shown) == (0, False), "what is complete is judged as it stands"


def test_a_letter_means_what_is_shown_beside_it(answer: Ask, course_home: Path) -> None:
    shown, _ = answer("check", typed=("b", INTERRUPT))
    line = next(line for line in shown.splitlines() if line.startswith("  b  "))
    chosen = kept(course_home)["why"][0]
    assert chosen == line.removeprefix("  b  ") or (chosen == "tell-apart" and "rhythm tells" in line)


def test_what_makes_no_sense_is_asked_again(answer: Ask) -> None:
    shown, code = answer("check", typed=("x", "1", "\x1b[A", INTERRUPT))
    assert code == 130
    assert shown.count("That is not one of the choices. Type a letter from a to d.") == 2
    assert shown.count("Question 1 of 5") == 1


def test_ctrl_c_keeps_what_was_answered(answer: Ask, course_home: Path) -> None:
    shown, code = answer("check", typed=(*RIGHT.values(), INTERRUPT))
    assert code == 130
    assert "Your answers so far are kept in ~/answers/05-quiz.yaml." in shown
    assert "Traceback" not in shown and "Not passed" not in shown
    assert set(kept(course_home)) == {"why", "seen"}
    shown, code = answer("check", typed=("keeper", "5", "red green white"))
    assert (code, "Question 1 of 3" in shown) == (0, True)


def test_empty_and_ctrl_d_leave_it_for_later(answer: Ask, course_home: Path) -> None:
    shown, code = answer("check", typed=("", END, "keeper", "", END))
    assert code == 1
    assert shown.count("It is not answered yet.") == 4
    assert kept(course_home) == {"keeper": ("keeper",)}


def test_again_asks_what_is_wrong(answer: Ask, course_home: Path) -> None:
    answer("check", typed=("It saves oil", "its smell", "keeper", "5", "red green white"))
    shown, code = answer("check")
    assert (code, "Question" in shown) == (1, False)
    assert "check --again" in shown
    shown, code = answer("check", "--again", typed=tuple(RIGHT.values()))
    assert (code, "Question 2 of 2" in shown) == (0, True)
    assert shown.count("The right one now earns 0.5 of 1 points.") == 2
    assert shown.index("0.5 of 1 points") < shown.index("Your answer"), "it is told before the second try"
    assert "Passed: 5 of 6 points" in shown
    shown, code = answer("check", "--again", typed=(INTERRUPT,))
    assert "Question 1 of 5" in shown, "when all is right, all is asked"


def test_a_broken_file_is_left_as_it_is(answer: Ask, course_home: Path) -> None:
    file = course_home / "answers/05-quiz.yaml"
    file.parent.mkdir()
    file.write_text("why: [\n")
    shown, code = answer("check")
    assert (code, file.read_text()) == (1, "why: [\n")
    assert "answers/05-quiz.yaml:2" in shown


def test_what_an_editor_wrote_meanwhile_stays(answer: Ask, course_home: Path) -> None:
    file = course_home / "answers/05-quiz.yaml"
    file.parent.mkdir()
    file.write_text("colors: red, green, white  # mine\nwhether: no\n")
    answer("check", typed=("", "", "keeper", "5"))
    assert kept(course_home) == {
        "colors": ("red, green, white",),
        "keeper": ("keeper",),
        "period": ("5",),
        "whether": ("no",),
    }


def test_a_review_asks_again_and_changes_nothing(answer: Ask, course_home: Path) -> None:
    shown, code = answer("review")
    assert (code, "There is nothing to review yet." in shown) == (2, True)
    answer("check", typed=("It saves oil", "", "keeper", "5", "red green white"))
    before = (course_home / "answers/05-quiz.yaml").read_text()
    in_any_order = ("looks after a light?\r\n\r\n=keeper",) * 5
    shown, code = answer("review", typed=in_any_order)
    assert (code, "Question 5 of 5" in shown, "You answered 1 of 5 correctly." in shown) == (0, True, True)
    assert (course_home / "answers/05-quiz.yaml").read_text() == before
