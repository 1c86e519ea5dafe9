"""Adding to an author's files: either every letter stays, or nothing is done."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from course.authoring.append import with_code, with_item
from course.errors import ContentError

FILE = Path("/course/lesson.yaml")
ITEM = "- id: new\n  says: |\n    two\n    lines\n"
NEW = {"id": "new", "says": "two\nlines\n"}


@pytest.mark.parametrize(
    "text",
    [
        "a: 1\nlist: []\n",
        "list: []\nz: 1\n",
        "list:\n  - id: old\n",
        "list:\n- id: old\n",
        "list:\n      - id: old\n        says: häufig ✓\nz: 1\n",
        "# first\nlist:\n  - id: old  # a remark\n\n# last\n",
        "list:\n  - |\n    text\n  - x\n\n\nz: 1",
    ],
)
def test_an_item_more(text: str) -> None:
    old = yaml.safe_load(text)
    new = with_item(FILE, text, "list", ITEM)
    assert yaml.safe_load(new) == {**old, "list": [*old["list"], NEW]}
    assert [line for line in text.splitlines() if line and line not in new.splitlines()] in ([], ["list: []"])


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("list: [{id: old}]\n", 1),
        ("a: 1\nlist: old\n", 2),
        ("other: []\n", None),
        ("- id: old\n", None),
        ("", None),
    ],
)
def test_where_it_cannot_be_done_nothing_is(text: str, line: int | None) -> None:
    with pytest.raises(ContentError, match="a list with a dash before each entry") as caught:
        with_item(FILE, text, "list", ITEM)
    assert (caught.value.file, caught.value.line) == (FILE, line)


def test_no_yaml() -> None:
    with pytest.raises(ContentError, match="not valid YAML") as caught:
        with_item(FILE, "a: 1\nlist: [", "list", ITEM)
    assert caught.value.line and caught.value.next_step


IMPORTS = "from a import one\nfrom b import two, three\n"


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("from a import one\n\nx = 1\n", ["from a import one", "from b import two, three", "", "x = 1"]),
        ("from b import three, two\nfrom a import one\n", ["from b import three, two", "from a import one"]),
        ('"""Doc."""\nx = 1\n', ['"""Doc."""', *IMPORTS.splitlines(), "x = 1"]),
        ("", IMPORTS.splitlines()),
    ],
)
def test_code_with_the_imports_that_it_lacks(text: str, wanted: list[str]) -> None:
    new = with_code(FILE, text, IMPORTS, "y = 2\n")
    assert new == "\n".join(wanted) + "\n\n\ny = 2\n"


def test_no_python() -> None:
    with pytest.raises(ContentError, match="not valid Python") as caught:
        with_code(FILE, "x = 1\ndef (:\n", IMPORTS, "y = 2\n")
    assert caught.value.line == 2
