"""Grader modules: what they declare is read, and they are loaded."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from course.validate.texts.graders.declared import declarations

from .conftest import GRADER, Change, Tell

NAME = "graders/ch04_lanterns.py"


def test_a_syntax_error(change: Change, tell: Tell) -> None:
    change(NAME, "def there(recording: Recording) -> None:", "def there(recording: Recording) -> None")
    assert tell() == [f"{NAME}:16: the grader is no Python: expected ':'"]


def test_a_module_that_is_not_there(change: Change, tell: Tell) -> None:
    change(NAME, "from course.grading.author", "import lanterns_for_all\nfrom course.grading.author")
    what = "the grader cannot be loaded: ModuleNotFoundError: No module named 'lanterns_for_all'"
    assert tell() == [f"{NAME}:4: {what}"]


@pytest.mark.parametrize("line", ["raise SystemExit(3)", "1 / 0", "raise KeyError"])
def test_a_module_that_stops(line: str, change: Change, tell: Tell) -> None:
    change(NAME, "light = ", f"{line}\nlight = ")
    (told,) = tell()
    assert told.startswith(f"{NAME}:6: the grader cannot be loaded: ")


def test_bytes_that_are_no_module(root: Path, tell: Tell) -> None:
    (root / NAME).write_bytes(b"\xff\xfe\x00grader")
    (told,) = tell()
    assert told.startswith(f"{NAME}:") and "the grader " in told


def test_all_wrong_declarations_of_a_module(change: Change, tell: Tell) -> None:
    change(NAME, 'needs="there"', 'needs=("ther", "there")')
    change(
        NAME, 'light.check("is_bright", "it is bright")', 'light.check("is_bright", "b", needs="is_bright")'
    )
    change(
        NAME, "@dim.check", '@dim.check("there", "first")\ndef first(recording):\n    pass\n\n\n@dim.check'
    )
    assert tell() == [
        f"{NAME}:10: check `is_bright` needs itself: is_bright -> is_bright",
        f"{NAME}:20: 04-dim has two checks `there`; the first is in line 15",
        f"{NAME}:25: check `dims` needs `ther`, which is no check; did you mean `there`?",
    ]


def test_a_circle_of_checks_is_told_once(change: Change, tell: Tell) -> None:
    change(NAME, '"the file is there")', '"the file is there", needs=["dims"])')
    assert tell() == [f"{NAME}:20: check `dims` needs itself: dims -> there -> dims"]


def test_a_check_that_stands_too_late(change: Change, tell: Tell) -> None:
    late = '\n\n@dim.check("late", "late")\ndef late(recording: Recording) -> None:\n    pass\n'
    change(NAME, "", GRADER.replace('needs="there"', 'needs="late"') + late)
    assert tell() == [f"{NAME}:20: check `dims` needs `late`, which stands only in line 25"]


def test_two_scenarios_are_a_fault_of_loading(change: Change, tell: Tell) -> None:
    change(NAME, "", GRADER + "\n\nlight.scenario(is_bright)\nlight.scenario(there)\n")
    assert tell() == [f"{NAME}:26: the grader cannot be loaded: 04-light has two scenarios"]


def test_an_exercise_without_a_grader(change: Change, tell: Tell) -> None:
    change(NAME, 'light = Grader("04-light"', 'light = Grader("04-ligth"')
    assert tell() == [
        "chapters/04-lanterns/lesson.yaml:5: ch04_lanterns.py has no `Grader` of 04-light",
        f"{NAME}:6: `Grader` of `04-ligth`, which is no exercise of its chapter; did you mean `04-light`?",
    ]


def test_two_graders_of_one_exercise(change: Change, tell: Tell) -> None:
    change(NAME, "dim = ", 'again = Grader("04-light", builds=None)\ndim = ')
    assert tell() == [f"{NAME}:6: 04-light has 2 of `Grader`, and only the first is used"]


def test_what_is_declared_is_read() -> None:
    source = (
        'ID = "far"\n'
        'g = Grader("04-x")\n'
        "for name in NAMES:\n    g.check(name, name)(partial(look, name))\n"
        'g.check(ID, "t", needs=BUILDS)(look)\n'
        "@g.check('kind', 'k', needs=())\ndef kind(r):\n    raise NotApplicable('no')\n"
        "@g.check('strict', 's', needs=other)\ndef strict(r):\n    helper(r)\n"
        "    raise NotApplicable('no')\n"
    )
    (found,) = declarations(ast.parse(source))
    assert (found.exercise, found.line, found.builds, found.whole) == ("04-x", 2, True, False)
    assert [(c.id, c.line, c.needs, c.can_fail) for c in found.checks] == [
        ("far", 5, ("builds",), True),
        ("kind", 6, (), False),
        ("strict", 9, None, True),
    ]
