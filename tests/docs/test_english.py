"""Docs, comments, and docstrings are in plain American English, as `validate` requires for lessons."""

from __future__ import annotations

import ast
import io
import itertools
import re
import subprocess
import tokenize
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.validate.static.english import long_sentences, odd_words, plain_findings

ROOT = Path(__file__).parents[2]
DOCS = [*sorted(ROOT.glob("*.md")), *sorted((ROOT / "docs").glob("*.md"))]
DOCUMENTED = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
TABLE = re.compile(r"^.*\S {2,}\S.*$|^ {4,}\S.*$", re.MULTILINE)  # in columns, or indented: not sentences
ROOMS = "bench course docs extras graders ros2course run-tests solutions tests underlay".split()
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
    found = [
        f"{name}:{line}: {what}"
        for name in listed(room)
        for line, text in comments(ROOT / name)
        for _line, what, _step in (*odd_words(text), *long_sentences(text))
    ]
    assert found == []


@pytest.mark.parametrize("room", ["course", "extras", "graders"])
def test_what_a_program_says_is_in_plain_english(room: str) -> None:
    found = [
        f"{name}:{line}: {what}"
        for name in listed(f"{room}/*.py")
        if name != "course/validate/static/english.py"  # the rules, with their examples
        for line, text in literals((ROOT / name).read_text(encoding="utf-8"))
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


def test_a_long_comment_is_looked_at(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("x = 1\n" + "# one two three four five six seven eight\n" * 4)
    ((line, text),) = comments(tmp_path / "a.py")
    assert (line, len([*long_sentences(text)])) == (2, 1)


def test_a_text_in_code_is_looked_at() -> None:
    assert [*literals('"""Write it all anew."""\nx = "write it all anew", "anew"\n')] == [
        (2, "write it all anew")
    ]


def test_a_name_in_code_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text('anew = "made anew"\n')
    assert [*comments(tmp_path / "a.py")] == []


def listed(pattern: str) -> list[str]:
    done = subprocess.run(["git", "ls-files", pattern], cwd=ROOT, capture_output=True, text=True, check=True)
    return done.stdout.splitlines()


def comments(file: Path) -> Iterator[tuple[int, str]]:
    """The comments and docstrings of a file, each with its line: in Python whole ones, else line by line."""
    if not file.is_file() or (file.suffix != ".py" and file.suffix not in COMMENTS):
        return
    text = file.read_text(encoding="utf-8", errors="replace")
    if file.suffix == ".py":
        yield from ((line, TABLE.sub("", prose)) for line, prose in python_comments(text))
        return
    for number, line in enumerate(text.splitlines(), 1):
        if found := re.search(COMMENTS[file.suffix], line):
            yield number, found[0]


def python_comments(text: str) -> Iterator[tuple[int, str]]:
    if (tree := parsed(text)) is None:
        return
    for node in ast.walk(tree):
        if isinstance(node, DOCUMENTED) and (said := ast.get_docstring(node)):
            yield getattr(node, "lineno", 0) + 1, said
    tokens = [
        token
        for token in tokenize.generate_tokens(io.StringIO(text).readline)
        if token.type == tokenize.COMMENT
    ]
    whole = {
        token.start[0]: token.string.lstrip("# ") for token in tokens if token.line.lstrip().startswith("#")
    }
    for token in tokens:
        line = token.start[0]
        if line not in whole:
            yield line, token.string
        elif line - 1 not in whole:  # the first line of several
            lines = itertools.takewhile(lambda number: number in whole, itertools.count(line))
            yield line, "\n".join(whole[number] for number in lines)


def literals(text: str) -> Iterator[tuple[int, str]]:
    """Strings of at least four words that are not docstrings."""
    if (tree := parsed(text)) is None:
        return
    documented = (node.body[0] for node in ast.walk(tree) if isinstance(node, DOCUMENTED) and node.body)
    docstrings = {first.value for first in documented if isinstance(first, ast.Expr)}
    for node in ast.walk(tree):
        is_text = isinstance(node, ast.Constant) and isinstance(node.value, str) and node not in docstrings
        if is_text and len(node.value.split()) >= 4:
            yield node.lineno, node.value


def parsed(text: str) -> ast.Module | None:
    """None for an example of a wrong program."""
    try:
        return ast.parse(text)
    except SyntaxError:
        return None
