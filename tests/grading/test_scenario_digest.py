"""The digest of a scenario depends on what affects its recording, and on nothing else."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.grading.scenario_digest import scenario_digest

GRADER = '''
"""A grader."""
from __future__ import annotations
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING
import machine
from course.api import Grader, words
from shared import greet

if TYPE_CHECKING:
    LONG = 5

PROBE = Path(__file__).with_name("probes") / "look.py"
TOLERANCE = 0.2

toy = Grader("04-toy", builds=2, ros=False)
other = Grader("04-other")


@toy.scenario
def act(arena: Arena) -> None:
    """It acts."""
    arena.probe(PROBE)
    for text in (words(2), "hello"):
        helper(arena, text)  # twice
    arena.until(partial(machine.ready, greet), timeout=LONG)


def helper(arena, text):
    arena.say(text)
    if text:
        helper(arena, "")


@toy.check("a", "does a", points=3)
def a(recording):
    assert recording.duration < TOLERANCE


@other.scenario
def act_otherwise(arena):
    arena.run("other", TOLERANCE)
'''
SHARED = '''
"""What graders share."""
NAME = "Ann"
UNUSED = 1
def greet(): return NAME
'''


@pytest.fixture
def toy(tmp_path: Path) -> Path:
    folder = tmp_path / "graders"
    (folder / "probes").mkdir(parents=True)
    (folder / "probes/look.py").write_text("ask(1)\n")
    (folder / "probes/unused.py").write_text("ask(1)\n")
    (folder / "shared.py").write_text(SHARED)
    (folder / "machine.py").write_text("def ready(greet): return True\n")
    play = tmp_path / "chapters/04-toys/play/04-toy.py"
    play.parent.mkdir(parents=True)
    play.write_text('"""A play."""\ndef draw(seed): return seed\n')
    (folder / "ch04_toys.py").write_text(GRADER)
    return folder / "ch04_toys.py"


def digest(toy: Path, exercise: str = "04-toy") -> str:
    found = scenario_digest(toy, exercise, ("notes.txt", "src/*.py"))
    assert len(found) == 64
    return found


def change(file: Path, old: str, new: str) -> None:
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new))


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("ch04_toys.py", "points=3", "points=4"),
        ("ch04_toys.py", "builds=2", "builds=7"),
        ("ch04_toys.py", "does a", "does b"),
        ("ch04_toys.py", "TOLERANCE = 0.2", "TOLERANCE = 0.3"),
        ("ch04_toys.py", "duration <", "duration >"),
        ("ch04_toys.py", "@other", "@toy.check('new', 'is new')\ndef new(recording): pass\n\n@other"),
        ("ch04_toys.py", "It acts.", "It does act."),
        ("ch04_toys.py", "  # twice", ""),
        ("ch04_toys.py", "(PROBE)", "(\n        PROBE\n    )"),
        ("shared.py", "UNUSED = 1", "UNUSED = 2"),
        ("shared.py", "What", "Things that"),
        ("probes/unused.py", "1", "2"),
        ("../chapters/04-toys/play/04-toy.py", "A play", "The play"),
    ],
)
def test_what_does_not_change_the_evidence(toy: Path, file: str, old: str, new: str) -> None:
    before = digest(toy)
    change(toy.parent / file, old, new)
    assert digest(toy) == before


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("ch04_toys.py", "(2)", "(3)"),
        ("ch04_toys.py", "hello", "hullo"),
        ("ch04_toys.py", "LONG = 5", "LONG = 6"),
        ("ch04_toys.py", "if text", "if not text"),
        ("ch04_toys.py", "ros=False", "ros=True"),
        ("ch04_toys.py", "import Grader, words", "import Grader, spellings as words"),
        ("ch04_toys.py", "@toy.scenario\n", ""),
        ("shared.py", "Ann", "Bob"),
        ("machine.py", "True", "False"),
        ("probes/look.py", "1", "2"),
        ("../chapters/04-toys/play/04-toy.py", "return seed", "return seed + 1"),
    ],
)
def test_what_changes_the_evidence(toy: Path, file: str, old: str, new: str) -> None:
    before, other = digest(toy), digest(toy, "04-other")
    change(toy.parent / file, old, new)
    assert digest(toy) != before
    assert digest(toy, "04-other") == other


def test_what_is_kept_of_the_home_counts(toy: Path) -> None:
    one, two = ("a", "b"), ("a",)
    assert scenario_digest(toy, "04-toy", one) != scenario_digest(toy, "04-toy", two)
    assert scenario_digest(toy, "04-toy", one) == scenario_digest(toy, "04-toy", one[::-1])


def test_a_scenario_that_is_given_without_a_decorator(toy: Path) -> None:
    change(toy, "@toy.scenario\n", "")
    change(toy, "@other.scenario", "toy.scenario(act)\n\n@other.scenario")
    before = digest(toy)
    change(toy, "hello", "hullo")
    assert digest(toy) != before


def test_of_a_grader_that_is_made_in_another_way_everything_counts(toy: Path) -> None:
    change(toy, 'toy = Grader("04-toy", builds=2, ros=False)', "toy = made()")
    before = digest(toy)
    change(toy, "TOLERANCE = 0.2", "TOLERANCE = 0.3")
    assert digest(toy) != before


def test_a_module_that_cannot_be_read_has_none(toy: Path) -> None:
    toy.write_text("def broken(:\n")
    assert scenario_digest(toy, "04-toy", ()) == ""
    toy.write_bytes(b"\xff\xfe")
    assert scenario_digest(toy, "04-toy", ()) == ""
    assert scenario_digest(toy.with_name("gone.py"), "04-toy", ()) == ""
