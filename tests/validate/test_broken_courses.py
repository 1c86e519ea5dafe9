"""The command finds every way in which a course can break its claims, with the line."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.validate.conftest import Validate, edit

CHAPTER = Path("chapters/05-lighthouses")
MISTAKES, LESSON = CHAPTER / "mistakes.yaml", CHAPTER / "lesson.yaml"
ALTERNATIVE = Path("solutions/05-lighthouses/alternatives/other-words/alternative.yaml")
ANSWERS = Path("solutions/05-lighthouses/answers/05-quiz.yaml")
STARTER = CHAPTER / "starter/05-quiz"


def line_of(file: Path, text: str) -> int:
    return next(n for n, line in enumerate(file.read_text().splitlines(), 1) if text in line)


@pytest.mark.slow
def test_a_sound_exercise(validate: Validate) -> None:
    ended = validate()
    assert (ended.code, ended.out.splitlines()[-1]) == (0, "All proofs hold.")
    row = next(line for line in ended.out.splitlines() if line.startswith("05-quiz"))
    assert row.split()[1:7] == ["ok", "ok", "ok", "3/3", "5/5", "6"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("file", "old", "new", "where", "words"),
    [
        (
            MISTAKES,
            "answers: {why: It saves oil}",
            "answers: {why: tell-apart}",
            (MISTAKES, "id: saves-oil"),
            "mistake `saves-oil`: `why` does not catch it: the check passed",
        ),
        (
            MISTAKES,
            "answers: {why: It saves oil}",
            "answers: {seen: [Its smell]}",
            (MISTAKES, "id: saves-oil"),
            "it fails `seen`, too: Nobody smells it",
        ),
        (
            MISTAKES,
            "says: [burns all the time, 05-quiz.yaml]",
            "says: [burns no oil]",
            (MISTAKES, "id: saves-oil"),
            '`why` does not say "burns no oil", but: ',
        ),
        (
            MISTAKES,
            "also_fails: [why, seen, keeper, colors]",
            "also_fails: [why, seen, keeper]",
            (MISTAKES, "id: whole-file-wrong"),
            "it fails `colors`, too",
        ),
        (
            ANSWERS,
            "period: 5 s",
            "period: 7 s",
            (LESSON, "id: 05-quiz"),
            "the solution of 05-quiz: `period` failed",
        ),
        (
            ALTERNATIVE,
            'period: "4.9"',
            'period: "49"',
            (ALTERNATIVE, "exercises:"),
            "the alternative `other-words` of 05-quiz: `period` failed",
        ),
    ],
    ids=["not-caught", "caught-by-another", "other-words", "fails-more", "solution", "alternative"],
)
def test_a_claim_that_is_not_so(
    validate: Validate, file: Path, old: str, new: str, where: tuple[Path, str], words: str
) -> None:
    edit(file, old, new)
    ended = validate()
    assert ended.code == 1
    assert words in ended.words
    shown = ended.out[ended.out.index(str(where[0])) :].splitlines()[1:]
    assert str(line_of(*where)) in {line.split()[0] for line in shown if line.strip()}
    assert "try" in ended.words


@pytest.mark.slow
def test_a_program_that_prints_what_no_choice_says(validate: Validate) -> None:
    edit(LESSON, "      - id: why\n", "      - id: why\n        program: blink.py\n")
    edit(LESSON, "Its rhythm tells which lighthouse it is", "'`on`, then `off`'")
    edit(ALTERNATIVE, "why: its rhythm tells which lighthouse it is", 'why: "on, then off"')
    (CHAPTER / "programs").mkdir()
    program = CHAPTER / "programs/blink.py"
    program.write_text("print('on')\nprint('off')\n")
    ended = validate()
    assert ended.code == 0, ended.out
    program.write_text("print('on')\n")
    ended = validate()
    assert ended.code == 1
    assert "`why` failed: The program prints on, but the right choice says: `on`, then `off`" in ended.words


@pytest.mark.slow
def test_a_starter_that_passes(validate: Validate) -> None:
    (STARTER / "answers").mkdir(parents=True)
    (STARTER / "answers/05-quiz.yaml").write_text(ANSWERS.read_text())
    ended = validate()
    assert ended.code == 1
    assert "the starter of 05-quiz: it passes: there is nothing left to do for a learner" in ended.words


@pytest.mark.slow
def test_an_edit_that_no_longer_applies(validate: Validate) -> None:
    edit(
        MISTAKES,
        "content: |\n          period: 0.2",
        "replace: 'period: 50 s'\n        with: 'period: 0.2 s'",
    )
    ended = validate()
    assert ended.code == 1
    assert "whole-file-wrong no longer applies" in ended.words
    assert ended.words.count("Make its `replace` match") == 1


def test_a_chapter_that_cannot_be_read_stops_it_with_all_its_problems(validate: Validate) -> None:
    edit(LESSON, "title: Lighthouses\n", "title: 5\n")
    edit(LESSON, "summary: Answer five questions about lights.\n", "sumary: Five.\n")
    ended = validate()
    assert ended.code == 1
    assert "(title)" in ended.words and "sumary" in ended.words
    assert "solution" not in ended.out


def test_a_grader_with_a_syntax_error(validate: Validate) -> None:
    edit(Path("graders/ch05_lighthouses.py"), "@grader.check(", "@grader.check((")
    ended = validate(exercise="05-keepers")
    assert ended.code == 1
    assert "graders/ch05_lighthouses.py" in ended.out and "the grader is not valid Python" in ended.words


def test_a_folder_that_is_no_course(validate: Validate, tmp_path: Path, quiz_course: Path) -> None:
    (quiz_course / "chapters").rename(quiz_course / "chapter")
    ended = validate()
    assert ended.code == 2
    assert "is not a course" in " ".join(ended.err.split())


def test_an_exercise_that_does_not_exist(validate: Validate) -> None:
    ended = validate(exercise="05-quizz")
    assert ended.code == 2
    assert "There is no exercise `05-quizz`" in ended.err


FLAKY = """
from pathlib import Path

from course.api import Failure, Feedback, Grader

coin = Grader("06-coin", builds=None, ros=False)


@coin.scenario
def thrown(arena):
    pass


@coin.check("heads", "it shows heads")
def heads(recording):
    tosses = Path({tosses!r})
    with tosses.open("a") as counter:
        counter.write("x")
    if "edge" in recording.home.file("coin.txt").text or len(tosses.read_text()) % 4 == 0:
        raise Failure(Feedback("It shows tails."))
"""


@pytest.mark.slow
def test_a_verdict_that_changes_is_found_by_repeating(
    validate: Validate, quiz_course: Path, tmp_path: Path
) -> None:
    chapter = quiz_course / "chapters/06-coins"
    chapter.mkdir()
    (chapter / "lesson.yaml").write_text(
        "chapter: 6\ntitle: Coins\nsummary: Coins that fall.\nexercises:\n  - id: 06-coin\n"
        "    title: A coin\n    summary: Throw it.\n    files: [coin.txt]\n    hints: [One, Two, Three]\n"
    )
    (chapter / "lesson.md").write_text("# Coins\n\nThey fall.\n")
    (chapter / "06-coin.md").write_text("Throw a coin.\n")
    (chapter / "mistakes.yaml").write_text(
        "mistakes:\n  - id: edge\n    exercise: 06-coin\n    summary: It stands on its edge\n    edits:\n"
        "      - file: coin.txt\n        content: edge\n    caught_by: heads\n    says: [tails]\n"
    )
    (quiz_course / "solutions/06-coins").mkdir()
    (quiz_course / "solutions/06-coins/coin.txt").write_text("heads")
    (chapter / "starter/06-coin").mkdir(parents=True)
    (chapter / "starter/06-coin/coin.txt").write_text("edge")
    tosses = str(tmp_path / "tosses")
    (quiz_course / "graders/ch06_coins.py").write_text(FLAKY.format(tosses=tosses))
    ended = validate("--repeat", "3", exercise="06-coin")
    assert ended.code == 1, ended.out + ended.err
    assert "the solution of 06-coin was judged differently: round 1: passed; round " in ended.words
    assert "not passed, failed: `heads`" in ended.words
