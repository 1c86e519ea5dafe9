"""What a solution adds to a file that is the learner's own."""

from __future__ import annotations

import pytest

from course.content.additions import with_addition


@pytest.mark.parametrize(
    ("text", "after"),
    [
        ("", "new\n"),
        ("\n \n", "new\n"),
        ("old\n", "old\n\nnew\n"),
        ("old", "old\n\nnew\n"),
        ("old\nnew\nmore\n", "old\nnew\nmore\n"),
    ],
)
def test_it_comes_last_and_once(text: str, after: str) -> None:
    assert with_addition(text, "new\n") == after
    assert with_addition(after, "new\n") == after
