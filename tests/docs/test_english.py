"""Docs, comments, and docstrings are in plain American English, as `validate` requires for lessons."""

from __future__ import annotations

import ast
import io
import re
import subprocess
import tokenize
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.validate.static.english import odd_words, plain_findings

ROOT = Path(__file__).parents[2]
DOCS = [*sorted(ROOT.glob("*.md")), *sorted((ROOT / "docs").glob("*.md"))]
ROOMS = ("bench", "course", "docs", "extras", "graders", "ros2course", "run-tests", "solutions", "underlay")
# How a comment begins, by the file's ending; `summary:` of a known mistake is prose, too.
COMMENTS = {
    **dict.fromkeys((".cpp", ".hpp"), r"//.*"),
    **dict.fromkeys((".cmake", ".sh", ".toml", ".txt", ""), r"(?:^|\s)#.*"),
    ".yaml": r"^ +summary: .*",
    ".md": r".*",
}


@pytest.mark.parametrize("file", DOCS, ids=lambda file: str(file.name))
def test_docs_are_in_plain_english(file: Path) -> None:
    text = file.read_text(encoding="utf-8")
    assert [*plain_findings(text)] == []


@pytest.mark.parametrize("room", [*ROOMS, "chapters/*/mistakes.yaml"])
def test_comments_and_docstrings_are_in_plain_english(room: str) -> None:
    listed = subprocess.run(["git", "ls-files", room], cwd=ROOT, capture_output=True, text=True, check=True)
    found = [
        f"{name}:{line}: {what}"
        for name in listed.stdout.split()
        for line, text in comments(ROOT / name)
        for _line, what, _step in odd_words(text)
    ]
    assert found == []


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.py", "x = 1  # made anew"),
        ("a.py", 'def f():\n    """Made anew."""'),
        ("a.cpp", "int x;  // made anew"),
        ("CMakeLists.txt", "find_package(x)  # made anew"),
        ("mistakes.yaml", "  - id: x\n    summary: Made anew"),
    ],
)
def test_a_comment_is_looked_at(tmp_path: Path, name: str, text: str) -> None:
    (tmp_path / name).write_text(text + "\n")
    assert [*odd_words("\n".join(prose for _line, prose in comments(tmp_path / name)))] != []


def test_a_name_in_code_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text('anew = "made anew"\n')
    assert [*comments(tmp_path / "a.py")] == []


def comments(file: Path) -> Iterator[tuple[int, str]]:
    """The comments and docstrings of a file, line by line from 1."""
    if not file.is_file() or (file.suffix != ".py" and file.suffix not in COMMENTS):
        return
    lines = file.read_text(encoding="utf-8", errors="replace").splitlines()
    if file.suffix == ".py":
        yield from python_comments("\n".join(lines))
        return
    for number, line in enumerate(lines, 1):
        if found := re.search(COMMENTS[file.suffix], line):
            yield number, found[0]


def python_comments(text: str) -> Iterator[tuple[int, str]]:
    try:
        tree = ast.parse(text)
    except SyntaxError:  # an example of a wrong program
        return
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            yield token.start[0], token.string
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            yield from enumerate((ast.get_docstring(node) or "").splitlines(), getattr(node, "lineno", 0) + 1)
