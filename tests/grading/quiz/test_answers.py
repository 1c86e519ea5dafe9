"""Answers files: what is read from right ones, and how wrong, huge, and hostile ones are refused."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from course.grading.quiz.answers import MAX_BYTES, Answers, missing, read_answers
from course.model.feedback import Failure


def read(home: Path, content: str | bytes) -> Answers:
    file = home / "answers/05-quiz.yaml"
    file.parent.mkdir(exist_ok=True)
    file.write_bytes(content.encode() if isinstance(content, str) else content)
    answers = read_answers(home, "05-quiz")
    assert answers is not None
    return answers


def texts(home: Path, content: str) -> dict[str, tuple[str, ...]]:
    return {name: given.texts for name, given in read(home, content).given.items()}


@pytest.mark.parametrize(
    ("written", "answer"),
    [
        ("two words", ("two words",)),
        ("yes", ("yes",)),
        ("~", ("~",)),
        ("007", ("007",)),
        ("1e3", ("1e3",)),
        ("2026-01-01", ("2026-01-01",)),
        ("  '>>'  ", (">>",)),
        (">", (">",)),
        ("|", ("|",)),
        ("", ()),
        ("''", ()),
        ("# a comment", ()),
        ("[b, ' d ', '']", ("b", "d")),
        ("\n  - one\n  - two", ("one", "two")),
        ("häufig ✓", ("häufig ✓",)),
    ],
)
def test_every_answer_stays_the_text_it_is(tmp_path: Path, written: str, answer: tuple[str, ...]) -> None:
    assert texts(tmp_path, f"first: x\nq: {written}\nlast: y\n") == {
        "first": ("x",),
        "q": answer,
        "last": ("y",),
    }


def test_lines_are_known(tmp_path: Path) -> None:
    answers = read(tmp_path, "# hello\n\na: 1\n\nb:\n  - 2\n")
    assert [given.line for given in answers.given.values()] == [3, 5]


@pytest.mark.parametrize("content", ["", "\n", "# nothing yet\n", "---\n", "\ufeff"])
def test_an_empty_file_answers_nothing(tmp_path: Path, content: str) -> None:
    assert texts(tmp_path, content) == {}


def test_no_file(tmp_path: Path) -> None:
    assert read_answers(tmp_path, "05-quiz") is None
    said = missing(tmp_path, "05-quiz")
    assert "answers/05-quiz.yaml" in said.summary
    assert "ros2course check 05-quiz" in (said.advice or "")
    assert said.seen is None


def test_a_file_that_is_misnamed(tmp_path: Path) -> None:
    read(tmp_path, "a: b")
    assert "answers/05-quiz.yaml" in (missing(tmp_path, "05-quizz").seen or "")


BOMB = "a: &a [x, x]\n" + "".join(f"b{n}: &b{n} [*a, *a]\n" for n in range(50))
REFUSED = [
    ("a: *b\n", 1, "not valid YAML|`&`, `*`, or `!`"),
    (BOMB, 1, "`&`, `*`, or `!`"),
    ("a: 1\nb: !!python/object/apply:os.system [ls]\n", 2, "`&`, `*`, or `!`"),
    ("a: 1\nb: {c: d}\n", 2, "must be a string or a list of strings"),
    ("a: [[1]]\n", 1, "must be a string or a list of strings"),
    # PyYAML from 6.0.4 on refuses so many itself.
    ("a: " + "[" * 3000, 1, "must be a string or a list of strings|maximum nesting depth"),
    ("? [a]\n: b\n", 1, "must be a string or a list of strings"),
    ("- a\n- b\n", 1, "one line `question: answer`"),
    ("just words\n", 1, "one line `question: answer`"),
    ("a: 1\nb: 2\na: 3\n", 3, "`a` is answered twice"),
    ("a: 1\nb: >>\n", 2, "not valid YAML"),
    ("a: 1\nb: 'open\n", None, "not valid YAML"),
    ("a: 1\n\tb: 2\n", 2, "not valid YAML"),
    ("a: b: c\n", 1, "not valid YAML"),
    (b"a: 1\nb: caf\xe9\n", 2, "not UTF-8"),
    (b"a: \0\n", None, "not text"),
    ("".join(f"q{n}: x\n" for n in range(200)), 101, "more than 100"),
    ("a: [" + "x, " * 200 + "]\n", 1, "more than 100"),
    ("a: " + "x" * MAX_BYTES, None, "larger than 64 KiB"),
]


@pytest.mark.parametrize(("content", "line", "what"), REFUSED, ids=range(len(REFUSED)))
def test_what_is_no_file_of_answers_is_refused(
    tmp_path: Path, content: str | bytes, line: int | None, what: str
) -> None:
    with pytest.raises(Failure) as caught:
        read(tmp_path, content)
    feedback = caught.value.feedback
    assert any(part in feedback.summary for part in what.split("|")), feedback
    assert feedback.where[0].file == "answers/05-quiz.yaml"
    assert feedback.advice
    if line is not None:
        assert feedback.where[0].line == line


def test_a_link_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("password: letmein\n")
    (tmp_path / "answers").mkdir()
    (tmp_path / "answers/05-quiz.yaml").symlink_to(tmp_path / "secret")
    with pytest.raises(Failure, match="it is a link"):
        read_answers(tmp_path, "05-quiz")


def test_a_folder_that_leads_elsewhere_is_not_followed(tmp_path: Path) -> None:
    home, other = tmp_path / "home", tmp_path / "other"
    home.mkdir()
    other.mkdir()
    (other / "05-quiz.yaml").write_text("a: b\n")
    (home / "answers").symlink_to(other)
    with pytest.raises(Failure, match="to a place outside the course home"):
        read_answers(home, "05-quiz")


def test_a_pipe_is_not_waited_for(tmp_path: Path) -> None:
    (tmp_path / "answers").mkdir()
    os.mkfifo(tmp_path / "answers/05-quiz.yaml")
    with pytest.raises(Failure, match="not a regular file"):
        read_answers(tmp_path, "05-quiz")


def test_a_folder_in_its_place(tmp_path: Path) -> None:
    (tmp_path / "answers/05-quiz.yaml").mkdir(parents=True)
    with pytest.raises(Failure, match="not a regular file"):
        read_answers(tmp_path, "05-quiz")


def test_a_file_where_the_folder_should_be(tmp_path: Path) -> None:
    (tmp_path / "answers").write_text("a: b\n")
    with pytest.raises(Failure, match="cannot be read"):
        read_answers(tmp_path, "05-quiz")
