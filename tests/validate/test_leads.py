"""Feedback on a known mistake points at what the mistake changed, or at what its `leads_to` names."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import Mistake
from course.model import replace
from course.model.feedback import Feedback, Location
from course.model.result import CheckResult, Outcome, Result, Verdict
from course.validate.leads import misled

BEFORE = "".join(f"line {number}\n" for number in range(1, 21))
MISTAKE = Mistake("twelfth", "18-x", "Line 12 is wrong", (), "rate", ("once",))
CALM = "def tick():\n"


def result(*where: Location, outcome: Outcome = Outcome.FAILED) -> Result:
    check = CheckResult("rate", "twice a second", 1, outcome, feedback=Feedback("Once.", where=where))
    return Result("18-x", Verdict.NOT_PASSED, (check,))


@pytest.fixture
def home(tmp_path: Path) -> Path:
    (tmp_path / "node.py").write_text(BEFORE.replace("line 12", "line twelve"))
    (tmp_path / "other.py").write_text(CALM)
    return tmp_path


@pytest.mark.parametrize(
    ("where", "leads_to", "says"),
    [
        ([Location("node.py", 12)], None, None),
        ([Location("node.py", 9)], None, None),
        ([Location("node.py")], None, None),
        ([Location("other.py", 1), Location("node.py", 15)], None, None),
        ([Location("node.py", 8)], None, "`rate` points at `node.py:8`, not at what the mistake changes"),
        ([Location("other.py", 1)], None, "not at what the mistake changes"),
        ([], None, None),
        ([Location("other.py", 1)], "def tick", None),
        ([Location("other.py")], "other.py", None),
        ([Location("node.py", 12)], "def tick", 'points at `node.py:12`, not at "def tick"'),
        ([Location("other.py", 99)], "def tick", 'not at "def tick"'),
        ([], "def tick", 'points at no line, not at "def tick"'),
    ],
)
def test_where_it_points(home: Path, where: list[Location], leads_to: str | None, says: str | None) -> None:
    told = misled(result(*where), replace(MISTAKE, leads_to=leads_to), {"node.py": BEFORE}, home)
    assert told == says or (says is not None and told is not None and says in told)


def test_next_to_a_line_that_was_removed(home: Path) -> None:
    (home / "node.py").write_text(BEFORE.replace("line 12\n", ""))
    assert misled(result(Location("node.py", 12)), MISTAKE, {"node.py": BEFORE}, home) is None
    assert misled(result(Location("node.py", 18)), MISTAKE, {"node.py": BEFORE}, home)


def test_nothing_to_point_at(home: Path) -> None:
    """No line changed: a file was deleted or renamed, or an answer is wrong."""
    assert misled(result(), MISTAKE, {}, home) is None


def test_it_was_not_caught(home: Path) -> None:
    assert misled(result(outcome=Outcome.PASSED), MISTAKE, {"node.py": BEFORE}, home) is None
