"""Links in texts lead to files and headings that exist."""

from __future__ import annotations

import pytest

from .conftest import Change, Tell

TEXT = "chapters/04-lanterns/04-dim.md"


@pytest.mark.parametrize(
    ("link", "what"),
    [
        ("[x](04-ligth.md)", "the link to `04-ligth.md` leads nowhere; did you mean `04-light.md`?"),
        ("![x](lamp.png)", "the link to `lamp.png` leads nowhere"),
        ("[x](lesson.md#lantern)", "lesson.md has no heading `#lantern`; did you mean `lanterns`?"),
        ("[x](#dim-it)", "04-dim.md has no heading `#dim-it`"),
        ("[x][1]\n\n[1]: gone.md", "the link to `gone.md` leads nowhere; did you mean `lesson.md`?"),
    ],
)
def test_links_that_lead_nowhere(link: str, what: str, change: Change, tell: Tell) -> None:
    change(TEXT, "Write", f"First.\n\nSecond,\nsee {link}\n\nWrite")
    assert tell() == [f"{TEXT}:4: {what}"]


@pytest.mark.parametrize(
    "link",
    [
        "[x](lesson.md#lanterns)",
        "[x](./04-light.md)",
        "[x](https://example.com/nothing)",
        "[x](mailto:a@b.invalid)",
        "[x](http://[broken)",
        "`[x](gone.md)`",
        "    [x](gone.md)",
    ],
)
def test_links_that_are_right_or_none(link: str, change: Change, tell: Tell) -> None:
    change(TEXT, "Write", f"First.\n\n{link}\n\nWrite")
    assert tell() == []


def test_links_in_hints(change: Change, tell: Tell) -> None:
    lesson = "chapters/04-lanterns/lesson.yaml"
    change(
        lesson, "      - Half of it is left.", "      - |\n        Half of it.\n\n        See [x](gone.md)."
    )
    assert tell() == [f"{lesson}:32: the link to `gone.md` leads nowhere; did you mean `lesson.md`?"]
