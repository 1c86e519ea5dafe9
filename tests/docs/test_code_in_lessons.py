"""No Python that a lesson, a task, or a hint shows was wrapped as if it were prose."""

from __future__ import annotations

import contextlib
import io
import keyword
import re
import tokenize
from pathlib import Path

import pytest

CHAPTERS = Path(__file__).parents[2] / "chapters"
FENCE = re.compile(r"^ *```python\n(.*?)^ *```", re.MULTILINE | re.DOTALL)
WORDS = (tokenize.NAME, tokenize.NUMBER)


def _files() -> list[Path]:
    return sorted(file for file in CHAPTERS.glob("*/*") if file.name.endswith((".md", "lesson.yaml")))


def _prose(code: str) -> list[str]:
    """Lines in which one word follows another as it never does in Python; the code may have gaps."""
    flush = "\n".join(line.strip() for line in code.splitlines())
    found, before = [], ""
    with contextlib.suppress(tokenize.TokenError):  # a bracket that is closed in another part
        for token in tokenize.generate_tokens(io.StringIO(flush).readline):
            word = token.type in WORDS and not keyword.iskeyword(token.string)
            if word and before:
                found.append(token.line)
            before = token.string if word or token.string in (")", "]") else ""
    return found


@pytest.mark.parametrize("file", _files(), ids=lambda file: str(file.relative_to(CHAPTERS)))
def test_no_code_was_wrapped_as_prose(file: Path) -> None:
    for code in FENCE.findall(file.read_text(encoding="utf-8")):
        assert not _prose(code), code


@pytest.mark.parametrize(
    "code",
    [
        "def go(self): self.call() # the last\nhint self.count += 1\n",
        "random.choice('abc') # one of\nthe three letters\n",
        "a = 1 b = 2\n",
        "first() second()\n",
    ],
)
def test_wrapped_code_is_found(code: str) -> None:
    assert _prose(code)


def test_parts_of_a_program_are_left_alone() -> None:
    assert not _prose("    if self.count:\n        ...\n'scripts': [\n    'drive = rover.drive:main',\n")
