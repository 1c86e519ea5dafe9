"""The answers file that `check` writes is the one that it reads back."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import Choice, Question
from course.grading.quiz.answers import answers_text, read_answers

QUESTIONS = (
    Question("why", "Why?\n\nThink: `a` # b.", "choice", (Choice("dark", "It is dark", True),)),
    Question("how-many", "How many?", "number"),
)


def back(home: Path, given: dict[str, tuple[str, ...]]) -> dict[str, tuple[str, ...]]:
    (home / "answers").mkdir(exist_ok=True)
    (home / "answers/05-quiz.yaml").write_text(answers_text("05-quiz", QUESTIONS, given), encoding="utf-8")
    answers = read_answers(home, "05-quiz")
    assert answers is not None
    return {name: answer.texts for name, answer in answers.given.items() if answer.texts}


@pytest.mark.parametrize(
    "texts",
    [
        ("plain words",),
        (">>",),
        ("*.py",),
        ("a: b",),
        ("a #b",),
        ("- a",),
        ("'quoted' \"twice\"",),
        ("null",),
        ("true",),
        ("\\n",),
        ("häufig – 日本語 ✓ 🐢 \u2028 \x85 \x7f \ufeff.",),
        ("a", "b, c", "[d]"),
        ("{x: 1}",),
        ("?",),
        ("x" * 500,),
    ],
)
def test_what_is_written_is_read_back(tmp_path: Path, texts: tuple[str, ...]) -> None:
    assert back(tmp_path, {"why": texts, "how-many": ("3",)}) == {"why": texts, "how-many": ("3",)}


def test_a_first_answer_is_kept_beside_the_later_one(tmp_path: Path) -> None:
    given = {"why": ("dark",), "why.first": ("a: b", "c"), "how-many.first": ("3",)}
    assert back(tmp_path, given) == given
    assert "no such questions" not in answers_text("05-quiz", QUESTIONS, given)


def test_a_blank_answer_and_one_to_no_question(tmp_path: Path) -> None:
    assert back(tmp_path, {"stranger": ("kept",)}) == {"stranger": ("kept",)}


def test_a_person_can_read_it() -> None:
    text = answers_text("05-quiz", QUESTIONS, {"why": ("dark",)})
    assert text == (
        "# Your answers to 05-quiz. `ros2course check 05-quiz` asks and judges them.\n"
        "\n"
        "# Why?\n"
        "#\n"
        "# Think: `a` # b.\n"
        "#   - dark: It is dark\n"
        "why: dark\n"
        "\n"
        "# How many?\n"
        "how-many:\n"
    )
