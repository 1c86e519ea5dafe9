"""Words that reveal a translation, and long sentences, in every text of a course."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from course.errors import UsageError
from course.validate.static.english import LONGEST, RULES, long_sentences, odd_words, repetitions

from .conftest import Change, Tell

FIXTURES = Path(__file__).parents[2] / "fixtures"
LESSON = "chapters/04-lanterns/lesson.yaml"


@pytest.mark.parametrize(("pattern", "instead", "example"), RULES, ids=[rule[1] for rule in RULES])
def test_each_rule_finds_its_example(pattern: str, instead: str, example: str) -> None:
    assert re.search(pattern, example, re.IGNORECASE)
    assert not re.search(pattern, instead, re.IGNORECASE)


def test_the_line_is_told_and_what_to_write() -> None:
    assert [*odd_words("Run it.\n\nDo it anew.\n")] == [
        (3, "`anew` is not plain American English", "write: again")
    ]


@pytest.mark.parametrize(
    ("file", "old", "word"),
    [
        ("chapters/04-lanterns/04-dim.md", "Write", "colour"),  # codespell:ignore
        ("graders/ch04_lanterns.py", "The graders", "teh"),
    ],
)
def test_spelling(file: str, old: str, word: str, change: Change, tell: Tell) -> None:
    change(file, old, f"{word} {old}")
    assert [line.partition(": ")[2] for line in tell()] == [f"`{word}` is misspelled, or British"]


def test_spelling_is_allowed_in_a_line(change: Change, tell: Tell) -> None:
    change("chapters/04-lanterns/04-dim.md", "Write", "Cape Colour <!-- codespell:ignore colour -->: write")
    assert tell() == []


def test_settings_of_codespell_that_cannot_be_read(change: Change, tell: Tell, root: Path) -> None:
    (root / ".codespellrc").write_text("[codespell")
    with pytest.raises(UsageError, match=r"codespell: .*ill-formed"):
        tell()


def test_code_is_left_alone() -> None:
    assert [*odd_words("Run `anew`.\n\n```bash\nanew\n```\n")] == []


def test_a_false_alarm_is_allowed_with_a_reason() -> None:
    assert [*odd_words("In Shall Bay. <!-- plain: a town -->")] == []
    assert [*odd_words("In Shall Bay. <!-- plain: -->")] != []
    assert [*long_sentences("word " * 31 + "<!-- plain: a quotation -->.")] == []


def test_a_long_sentence_is_found_where_it_begins() -> None:
    text = "One.\n\nTwo is short.\n" + "word " * 31 + ". Three.\n"
    assert [*long_sentences(text)] == [
        (4, "`word word word word word ...` has 31 words", f"split it: at most {LONGEST} a sentence")
    ]


@pytest.mark.parametrize("line", ["- word word word\n", "| word word word |\n", "1. word word word\n"])
def test_a_list_and_a_table_are_not_one_sentence(line: str) -> None:
    assert [*long_sentences("Do this:\n\n" + line * 12)] == []


LEFT = "where you read a parameter, or where you call."


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        ("One.\n\nThis chapter uses two:\ntwo:\n\n- a\n- b\n", 3, "two:"),
        ("Write it in\nthe the file.", 2, "the"),
        ("> It is called:\n> called:\n", 1, "called:"),
        (f"Do it {LEFT} The edge,\n{LEFT}\n", 1, "where you read a parameter, or where you"),
    ],
)
def test_words_that_an_edit_left_behind(text: str, line: int, words: str) -> None:
    assert [*repetitions(text)] == [(line, f"`{words}` appears twice", "delete one of the two")]


@pytest.mark.parametrize(
    "text",
    [
        "Again and again and again.",
        "Send `0 0 0` or `a`, `a`.",
        "On Linux\n\nLinux is free.",
        "Write this:\n\n    x1 x1 + x2\n\nHere.",
        "Do:\n\n```\nls ls\n```\n",
        "| a | b b |\n",
        "He had had it. <!-- plain: it is right -->",
        f"- {LEFT}\n- {LEFT}\n",
    ],
)
def test_a_repetition_on_purpose(text: str) -> None:
    assert [*repetitions(text)] == []


@pytest.mark.parametrize("file", ["lesson.md", "04-light.md"])
def test_it_is_found_in_lessons_and_tasks(file: str, change: Change, tell: Tell) -> None:
    change(f"chapters/04-lanterns/{file}", "", "# Lanterns\n\nWrite it anew.\n")
    assert tell() == [f"chapters/04-lanterns/{file}:3: `anew` is not plain American English"]


def test_it_is_found_in_hints(change: Change, tell: Tell) -> None:
    change(LESSON, "Half of it is left.", "Half of it is left. Write it anew.")
    assert [line.split(": ", 1)[1] for line in tell()] == ["`anew` is not plain American English"]


def test_it_is_found_in_choices(tmp_path: Path, tell: Tell) -> None:
    quiz = shutil.copytree(FIXTURES / "quiz_course", tmp_path / "quiz")
    lesson = quiz / "chapters/05-lighthouses/lesson.yaml"
    lesson.write_text(lesson.read_text().replace("Its smell", "What it is no lamp for"))
    assert [line for line in tell(folder=quiz) if "plain" in line] == [
        "chapters/05-lighthouses/lesson.yaml:34: `is no ` is not plain American English"
    ]


TERMS = "terms: [wick]\nexercises:"


def test_a_term_is_found_before_the_chapter_that_explains_it(root: Path, change: Change, tell: Tell) -> None:
    change("chapters/04-lanterns/lesson.md", "", "# Wicks\n\nTrim the Wicks, not the `wick`.\n")
    shutil.copytree(root / "chapters/04-lanterns", root / "chapters/05-wicks")
    for name in ("04-light.md", "04-dim.md", "mistakes.yaml"):
        (root / "chapters/05-wicks" / name).unlink()
    change("chapters/05-wicks/lesson.md", "", "# Wicks\n\nThe **wick** burns.\n")
    change("chapters/05-wicks/lesson.yaml", "", f"chapter: 5\ntitle: Wicks\nsummary: Trim.\n{TERMS} []\n")
    assert [line for line in tell() if "wick`" in line] == [
        "chapters/04-lanterns/lesson.md:3: `wick` is used before 05-wicks explains it"
    ]
    change("chapters/04-lanterns/lesson.md", "`wick`.", "`wick`. <!-- plain: a song -->")
    assert [line for line in tell() if "wick`" in line] == []


def test_a_term_is_found_before_its_own_lesson_explains_it(change: Change, tell: Tell) -> None:
    change(LESSON, "exercises:", TERMS)
    change("chapters/04-lanterns/lesson.md", "", "# The wick\n\nA wick.\n\nThe **wick** burns.\n")
    assert tell() == ["chapters/04-lanterns/lesson.md:3: `wick` is used before 04-lanterns explains it"]


def test_a_term_must_be_explained(change: Change, tell: Tell) -> None:
    change(LESSON, "exercises:", TERMS)
    assert tell() == [f"{LESSON}:4: the lesson does not explain `wick`"]
