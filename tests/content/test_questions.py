"""Questions in lesson.yaml: what they become, and the errors about wrong ones."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from course.content import Course, open_course, problems
from course.content.entries import tolerance_of

FIXTURE = Path(__file__).parents[1] / "fixtures/quiz_course"
LESSON = "chapters/05-lighthouses/lesson.yaml"


@pytest.fixture
def quiz_course(tmp_path: Path) -> Path:
    return shutil.copytree(FIXTURE, tmp_path / "course")


@pytest.fixture
def change(quiz_course: Path) -> Callable[[str, str], Course]:
    def replace(old: str, new: str) -> Course:
        file = quiz_course / LESSON
        text = file.read_text()
        assert old in text
        file.write_text(text.replace(old, new, 1))
        return open_course(quiz_course)

    return replace


def test_the_fixture_is_right() -> None:
    assert problems(open_course(FIXTURE)) == ()


def test_questions_as_they_are_asked() -> None:
    why, seen, keeper, period, colors = open_course(FIXTURE).exercise("05-quiz").questions
    assert (why.form, [choice.name for choice in why.choices][:2]) == (
        "choice",
        ["tell-apart", "It saves oil"],
    )
    assert seen.form == "choices"
    assert (keeper.form, keeper.texts[1], keeper.wrong[0].answer) == ("text", "keeper", "captain")
    assert (period.form, period.value, period.tolerance, period.points) == ("number", 5.0, 0.25, 2.0)
    assert (colors.form, colors.texts) == ("all_of", ("red", "green", "white"))


def test_the_answers_are_one_of_the_learners_files() -> None:
    assert open_course(FIXTURE).exercise("05-quiz").files == ("answers/05-quiz.yaml",)


def test_a_mystery_knows_its_module() -> None:
    course = open_course(FIXTURE)
    play = course.exercise("05-keepers").play
    assert play is not None and play.name == "05-keepers.py"
    assert course.exercise("05-quiz").play is None


@pytest.mark.parametrize(("value", "written", "width"), [(5, 0.5, 0.5), (-8, "25%", 2), (0, "10%", 0)])
def test_tolerances(value: float, written: float | str, width: float) -> None:
    assert tolerance_of(value, written) == width


WRONG = [
    (
        "            right: true\n            why: No two",
        "            why: No two",
        "choices",
        "no choice is",
    ),
    (
        "text: It saves oil\n",
        "text: It saves oil\n            right: true\n",
        "choices",
        "exactly one choice",
    ),
    (
        "            why: A lamp that turns burns all the time.\n",
        "",
        "choices[1]",
        "a wrong choice needs `why`",
    ),
    ("text: It saves oil", "text: The keeper is asleep", "choices[3]", "already exists on line 19"),
    ("id: seen", "id: why", "id", "used twice; the first is on line 9"),
    ("id: seen", "id: Seen", "id", "must be lowercase letters"),
    ("        number: 5\n", "", "questions[3]", "exactly one of choices, text, all_of, number, computed"),
    (
        "        number: 5\n",
        "        number: 5\n        text: [five]\n",
        "number",
        "contains `text` and `number`",
    ),
    ("tolerance: 5%", "tolerance: 5 %%", "tolerance", "or a share like `10%`, not `5 %%`"),
    ("tolerance: 5%", "tolerance: -1", "tolerance", "must be a number of at least 0"),
    ("tolerance: 5%", "exact: true", "exact", "`exact` does not belong in a question with `number`"),
    ("points: 2", "points: -2", "points", "must be a number greater than 0"),
    ("points: 2", "points: 0", "points", "must be a number greater than 0"),
    ("number: 5", "number: five", "number", "must be a number, not a string"),
    (
        "        explain: The period is the time from one blink to the next.\n",
        "",
        "[3]",
        "`explain` is missing",
    ),
    ("answer: blue", "answer: [blue]", "answer", "must be a string or a number"),
    ("who looks after", "who looks after\n        asks: no", "asks", "did you mean `ask`?"),
    ("What would you call them?", "A Keeper!", "otherwise", "contains the right one (`a keeper`)"),
    ("is the time from one", "is 5 seconds from one", "explain", "contains the right one (`5`)"),
    ("computed: true", "computed: maybe", "computed", "must be `true` or `false`"),
    ("points: 2", "program: a.py", "program", "`program` does not belong in a question with `number`"),
    ("id: seen", "id: seen\n        program: ../a.py", "program", "must be the name of a script"),
]


@pytest.mark.parametrize(("old", "new", "key", "what"), WRONG)
def test_a_wrong_question(
    change: Callable[[str, str], Course], old: str, new: str, key: str, what: str
) -> None:
    found = problems(change(old, new))
    told = [problem for problem in found if what in problem.what]
    assert told, [str(problem) for problem in found]
    assert (told[0].key or "").endswith(key)
    assert told[0].line and told[0].next_step


def test_a_computed_question_needs_a_mystery(quiz_course: Path) -> None:
    (quiz_course / "chapters/05-lighthouses/play/05-keepers.py").rename(
        quiz_course / "chapters/05-lighthouses/play/05-keeper.py"
    )
    told = [problem.what for problem in problems(open_course(quiz_course))]
    assert "`05-keepers` has no mystery that could compute the answer" in told
    assert any(
        "no exercise of this chapter is called `05-keeper`; did you mean `05-k" in what for what in told
    )


def test_a_chapter_of_quizzes_needs_no_grader(quiz_course: Path) -> None:
    folder = quiz_course / "chapters/05-lighthouses"
    lesson = folder / "lesson.yaml"
    lesson.write_text(lesson.read_text().partition("  - id: 05-keepers")[0])
    for file in (quiz_course / "graders/ch05_lighthouses.py", folder / "05-keepers.md"):
        file.unlink()
    for name in ("mistakes.yaml", "play/05-keepers.py"):
        (folder / name).unlink()
    for tree in (quiz_course / "solutions/05-lighthouses/alternatives", folder / "starter"):
        shutil.rmtree(tree)
    assert problems(open_course(quiz_course)) == ()


def test_only_a_quiz_may_have_few_hints(change: Callable[[str, str], Course]) -> None:
    found = problems(change("    time_limit: 20\n", "    time_limit: 20\n    packages: [lights]\n"))
    assert [problem.what for problem in found] == [
        "`exercises[1].hints` must contain at least 3 hints, not 1"
    ]


def test_answers_go_with_answers_files_only(quiz_course: Path) -> None:
    file = quiz_course / "chapters/05-lighthouses/mistakes.yaml"
    file.write_text(file.read_text().replace("answers/05-quiz.yaml", "answer/05-quiz.yaml", 1))
    (problem,) = problems(open_course(quiz_course))
    assert "`answers` is for an answers file, not for `answer/05-quiz.yaml`" in problem.what


def test_a_question_about_a_program_shows_its_code(
    quiz_course: Path, change: Callable[[str, str], Course]
) -> None:
    course = change("      - id: why\n", "      - id: why\n        program: blink.py\n")
    file = quiz_course / "chapters/05-lighthouses/programs/blink.py"
    assert [problem.file for problem in problems(course)] == [file]
    file.parent.mkdir()
    file.write_text("print('on')\n")
    question = open_course(quiz_course).exercise("05-quiz").questions[0]
    assert question.program == file
    assert question.ask.endswith("side by side.\n\n```python\nprint('on')\n```")
