"""What docs/submissions.md says is true."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from course.batch.intake.people import assignment, labels
from course.home.opening import USUAL
from course.home.opening.findings import DEEPEST, LONGEST_NAME, LONGEST_PATH

TEXT = (Path(__file__).parents[3] / "docs/submissions.md").read_text(encoding="utf-8")
NAMES = re.findall(r"^\| `(.+_.+)`.* \| (?:Moodle|Canvas).* \| `(\w+)` \| (.+) \|$", TEXT, re.MULTILINE)


def test_there_are_names() -> None:
    assert len(NAMES) == 5


@pytest.mark.parametrize(("name", "identity", "person"), NAMES)
def test_names_are_read_as_it_says(name: str, identity: str, person: str) -> None:
    label = labels([name])[name]
    assert label.is_lms
    assert (label.person.id, label.person.name) == (identity, person)


def test_clones_are_read_as_it_says() -> None:
    assert assignment(["lab1-janedoe"], "lab1-submissions") == "lab1-"


@pytest.mark.parametrize(
    "limit",
    [
        f"{USUAL.bytes // 10**6} MB, {USUAL.files:,} files",
        f"one file of an archive {USUAL.file // 10**6} MB",
        f"files larger than {USUAL.file // 10**6} MB",
        f"{USUAL.ratio} times the archive's size, once it is more than {USUAL.free // 10**6} MB",
        f"{USUAL.seconds:.0f} s of computing",
        f"more than {LONGEST_NAME} bytes",
        f"more than {LONGEST_PATH:,}",
        f"more than {DEEPEST} deep",
    ],
)
def test_limits_are_those_that_hold(limit: str) -> None:
    assert limit in " ".join(TEXT.split())
