"""Beginners read what graders say: it names the next step, is short, and uses words that they know.

These look at the texts as they stand in the code. That a message says what its mistake is about,
`says` in mistakes.yaml holds.
"""

from __future__ import annotations

import ast
import functools
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).parents[2]
GRADERS = sorted((ROOT / "graders").glob("ch*.py"))
EXPECT = sorted((ROOT / "course" / "grading" / "expect").glob("*.py"))
EXPLAIN = sorted((ROOT / "course" / "explain").glob("*.py"))
BUILD = sorted((ROOT / "course" / "build").rglob("*.py"))
LESSONS = sorted((ROOT / "chapters").glob("*/lesson.yaml"))

LONGEST_SUMMARY = 130
LONGEST = 200
MOST_SENTENCES = 3
CODE = re.compile(r"\n|\\|\[\^|^env -i |^name version |is an invalid ")
PLACEHOLDER = "(value)"  # about as long as what a learner sees there

# Words that are in no lesson: internal words, tool makers' words, and words that blame.
STRANGE = (
    *("DDS", "RIHS", "RIHS01", "digest", "regex", "stdout", "stderr", "EOF", "TTY", "payload", "linter"),
    *("arena", "probe", "scenario", "recording", "grader", "testbed", "stack trace"),
    *("invalid", "incorrect", "illegal", "obviously", "of course", "simply", "trivial", "stupid", "silly"),
    *("anew", "exchanged", "abort", "aborted"),
)
# Words that have to wait for their chapter.
INTRODUCED = (
    *("SIGINT", "QoS", "namespace", "/rosout", "exit code", "traceback", "callback", "entry point"),
    *("coroutine", "docstring", "YAML", "deadlock", "durability", "future", "service", "parameter"),
    *("underlay", "overlay", "level INFO", "derives", "type hint", "subpackage", "ASCII", "launch file"),
    "constructor",
)


def named(files: list[Path]) -> pytest.MarkDecorator:
    return pytest.mark.parametrize("file", files, ids=lambda file: f"{file.parent.name}/{file.stem}")


def holds(text: str, word: str) -> bool:
    return re.search(rf"(?<![\w.]){re.escape(word)}(?![\w(])", text, re.IGNORECASE) is not None


def written(node: ast.AST) -> str:
    """A text with placeholders for what is inserted later."""
    if isinstance(node, ast.Constant):
        return node.value if isinstance(node.value, str) else ""
    if isinstance(node, ast.JoinedStr):
        return "".join(written(part) or PLACEHOLDER for part in node.values)
    return ""


def texts(node: ast.AST) -> Iterator[tuple[int, str]]:
    """The prose in it, with its line: no docstrings, patterns, or code, and nothing about our own errors."""
    if isinstance(node, ast.Compare):  # patterns for other programs' output
        return
    if isinstance(node, ast.Call) and ast.unparse(node.func) in ("OurFault", "Spoilt", "re.compile"):
        return
    if isinstance(node, ast.Call) and ast.unparse(node.func).partition("[")[0] == "Known":
        for part in (*node.args[1:2], *(argument(node, name) for name in ("cause", "remedy"))):
            yield from texts(part or ast.Pass())
        return
    if text := written(node):
        if re.search(r"\w \w", text) and not CODE.search(text):
            yield getattr(node, "lineno", 0), text
        return
    for inner in ast.iter_child_nodes(node):
        if not (isinstance(inner, ast.Expr) and isinstance(inner.value, ast.Constant)):
            yield from texts(inner)


@functools.cache
def prose(file: Path) -> list[tuple[int, str]]:
    return list(texts(ast.parse(file.read_text("utf-8"))))


def feedbacks(file: Path) -> list[ast.Call]:
    every = (node for node in ast.walk(ast.parse(file.read_text("utf-8"))) if isinstance(node, ast.Call))
    return [call for call in every if ast.unparse(call.func) == "Feedback"]


def argument(call: ast.Call, name: str) -> ast.expr | None:
    return next((keyword.value for keyword in call.keywords if keyword.arg == name), None)


def chapter(grader: Path) -> int:
    return int(grader.stem[2:4])


def first_use(helper: Path) -> int:
    """The chapter of the first grader that imports this module of `expect` itself."""
    line = f"from course.grading.expect.{helper.stem} import"
    return min((chapter(file) for file in GRADERS if line in file.read_text("utf-8")), default=99)


@functools.cache
def lessons() -> tuple[tuple[int, str], ...]:
    """Every text of a chapter, with the chapter's number."""
    files = sorted((ROOT / "chapters").glob("*/*.md"))
    return tuple((int(file.parent.name[:2]), file.read_text("utf-8")) for file in files)


@functools.cache
def introduction(word: str) -> int:
    """The first chapter with the word in its lesson or in an exercise."""
    return min((number for number, text in lessons() if holds(text, word)), default=99)


@named([*GRADERS, *EXPECT, *EXPLAIN])
def test_every_feedback_says_what_to_do_next(file: Path) -> None:
    for call in feedbacks(file):
        advice = argument(call, "advice")
        assert advice is not None, f"{file.name}:{call.lineno} has no `advice`"
        assert ast.unparse(advice) != "None", f"{file.name}:{call.lineno}"


@named([*GRADERS, *EXPECT, *EXPLAIN])
def test_summaries_are_one_short_line(file: Path) -> None:
    for call in feedbacks(file):
        for line, text in texts(argument(call, "summary") or ast.Pass()):
            assert len(text) <= LONGEST_SUMMARY, f"{file.name}:{line}: {len(text)} letters: {text}"


@named([*GRADERS, *EXPECT, *EXPLAIN, *BUILD])
def test_messages_are_short(file: Path) -> None:
    for line, text in prose(file):
        sentences = len(re.findall(r"[.?!](?= [A-Z`]|$)", text))
        assert len(text) <= LONGEST, f"{file.name}:{line}: {len(text)} letters: {text}"
        assert sentences <= MOST_SENTENCES, f"{file.name}:{line}: {sentences} sentences: {text}"


@named([*GRADERS, *EXPECT, *EXPLAIN, *BUILD])
def test_no_word_is_strange_or_unkind(file: Path) -> None:
    for line, text in prose(file):
        found = [word for word in STRANGE if holds(text, word)]
        assert not found, f"{file.name}:{line}: {found}: {text}"


@named(LESSONS)
def test_neither_is_one_in_what_quizzes_answer(file: Path) -> None:
    for exercise in yaml.safe_load(file.read_text("utf-8"))["exercises"]:
        for question in exercise.get("questions", ()):
            told = [*question.get("choices", ()), *question.get("wrong", ())]
            said = [one.get("why", "") for one in told] + [question.get("explain"), question.get("otherwise")]
            for text in filter(None, said):
                found = [word for word in STRANGE if holds(text, word)]
                assert not found, f"{exercise['id']}, {question['id']}: {found}: {text}"


@named([*GRADERS, *EXPECT])
def test_a_word_waits_for_the_lesson_that_has_it(file: Path) -> None:
    read = chapter(file) if file in GRADERS else first_use(file)
    for line, text in prose(file):
        early = [word for word in INTRODUCED if holds(text, word) and introduction(word) > read]
        assert not early, f"{file.name}:{line}: {early}: {text}"


def test_the_words_that_wait_are_introduced_at_all() -> None:
    assert not [word for word in INTRODUCED if introduction(word) == 99]
