"""Calls, numbers and texts in the learner's files."""

from __future__ import annotations

import ast
import warnings

import pytest

from course.evidence.sources import Sources
from course.explain.python_code import calls, functions, number, parsed, text_places

FILE = "src/talk/talk/talker.py"


def sources(text: str, file: str = FILE) -> Sources:
    return Sources({file: text})


def value(expression: str, before: str = "") -> float | None:
    given = sources(f"{before}\nmark({expression})")
    return number(given, calls(given, "mark")[0].args[0])


def test_calls_are_found_however_they_are_reached() -> None:
    text = "spin(a)\nrclpy.spin(b)\na.b.c.spin(c)\nx = [spin(d) for _ in y]\nspin\nspinner()\n(lambda: 1)()\n"
    assert [call.where.line for call in calls(sources(text), "spin")] == [1, 2, 3, 4]
    assert str(calls(sources(text), "spin")[0].where) == f"{FILE}:1"


def test_arguments_by_place_or_name() -> None:
    given = sources(
        "create_timer(0.5, self.tick)\ncreate_timer(callback=self.tick, timer_period_sec=0.5, **more)"
    )
    one, other = calls(given, "create_timer")
    for call in (one, other):
        period, callback = call.argument(0, "timer_period_sec"), call.argument(1, "callback")
        assert period is not None
        assert callback is not None
        assert (ast.unparse(period), ast.unparse(callback)) == ("0.5", "self.tick")
    assert one.argument(2, "clock") is None


@pytest.mark.parametrize("file", ["src/talk/setup.py", "src/talk/test/test_talk.py", "src/talk/notes.txt"])
def test_only_programs_count(file: str) -> None:
    assert calls(sources("spin()", file), "spin") == ()


@pytest.mark.parametrize("text", ["def (", "\x00", "x = '", "(" * 500])
def test_what_python_cannot_read_holds_nothing(text: str) -> None:
    assert parsed(text) is None
    assert calls(sources(text), "spin") == ()


@pytest.mark.parametrize("text", ["-" * 50_000 + "1", "a" + ".b" * 50_000, "1" + " * 1" * 50_000])
def test_what_is_too_deep_for_python_raises_nothing(text: str) -> None:
    assert calls(sources(text), "spin") == ()


def test_warnings_about_the_learners_code_are_not_ours() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert len(calls(sources(r"re.compile('\d'); 1 is 1"), "compile")) == 1


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ("0.5", 0.5),
        ("1", 1.0),
        ("1 / 2", 0.5),
        ("1.0 / 2.0 / 5", 0.1),
        ("500 * 0.001", 0.5),
        ("1 / 0", None),
        ("1 + 1", None),
        ("'0.5'", None),
        ("unknown", None),
        ("f()", None),
        ("1" + "0" * 400, None),
        ("1e999", None),
    ],
)
def test_numbers(expression: str, expected: float | None) -> None:
    assert value(expression) == (pytest.approx(expected) if expected else None)


@pytest.mark.parametrize(
    "before",
    [
        "period = 0.5",
        "period: float = 0.5",
        "class A:\n    def __init__(self):\n        self.period = 1 / 2",
        "period = f()\nperiod = 0.5",
        "other = period = 0.5",
    ],
)
@pytest.mark.parametrize("expression", ["period", "self.period", "period / 1"])
def test_numbers_by_name(before: str, expression: str) -> None:
    assert value(expression, before) == 0.5


def test_names_in_a_circle_end() -> None:
    assert value("a", "a = b\nb = a\na = a / 2") is None


def test_no_number_at_all() -> None:
    assert number(Sources(), None) is None


def test_functions_by_name() -> None:
    text = "def hear(): pass\nclass A:\n    async def hear(self): pass\ndef other(): pass"
    assert [function.lineno for function in functions(sources(text), "hear")] == [1, 3]


def test_places_of_a_text() -> None:
    given = Sources({"a.py": "x\nhello()\n\nhello()", "b.xml": "<hello/>"})
    assert [str(place) for place in text_places(given, "hello")] == ["a.py:2", "a.py:4", "b.xml:1"]
