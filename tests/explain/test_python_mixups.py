"""Errors of Python whose cause the code proves: variants that `test_known.py` has no room for."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from course.evidence.sources import Sources
from course.explain.engine import Evidence, Symptom, explain
from course.explain.python_errors import EXCEPTIONS
from course.model.feedback import Location

FILE = "src/talk/talk/talker.py"
MESSAGE = "from sensor_msgs.msg import JointState\nfrom std_srvs.srv import SetBool\n"
TAKES = "{}() takes {} positional argument{} but {} were given"


def told(error: str, code: str, line: int, file: str = FILE, others: Mapping[str, str] | None = None) -> str:
    files = {file: code, **{f"src/talk/talk/{name}": text for name, text in (others or {}).items()}}
    found = explain(EXCEPTIONS, [Symptom(error, Location(file, line))], Evidence(sources=Sources(files)))
    assert found
    return found.remedy


@pytest.mark.parametrize(
    ("of", "call", "words"),
    [
        ("JointState", "JointState(positions)", "`JointState(field=positions)`"),
        ("SetBool_Request", "SetBool.Request(True)", "`SetBool.Request(field=True)`"),
    ],
)
def test_fields_of_any_interface_go_by_name(of: str, call: str, words: str) -> None:
    error = f"TypeError: {TAKES.format(f'{of}.__init__', 1, '', 2)}"
    assert words in told(error, f"{MESSAGE}{call}\n", 3)


def test_a_class_of_the_learner_is_no_message() -> None:
    code = "class JointState:\n    def __init__(self):\n        pass\nJointState(1)\n"
    error = f"TypeError: {TAKES.format('JointState.__init__', 1, '', 2)}"
    assert "fields" not in told(error, code, 4)


@pytest.mark.parametrize(
    ("error", "code", "line", "words"),
    [
        (TAKES.format("say", 1, "", 2), "def say(a, *, b): pass\nsay(1, 2)\n", 2, "`say(1, b=2)`"),
        (
            TAKES.format("Talker.say", 1, "", 2),
            "class Talker:\n    def say(self, *, b): pass\nTalker().say(2)\n",
            3,
            "`say(b=2)`",
        ),
        (TAKES.format("say", 1, "", 2), "def say(a): pass\nsay(1, 2)\n", 2, "than it takes"),
        (
            TAKES.format("Talker.say", 1, "", 2),
            "class Talker:\n    def say(self): pass\nTalker().say(2)\n",
            3,
            "`self` counts as one",
        ),
        (TAKES.format("Event.wait", 2, "s", 3), "event.wait(1, 2)\n", 1, "than it takes"),
    ],
)
def test_arguments_that_go_by_name(error: str, code: str, line: int, words: str) -> None:
    assert words in told(f"TypeError: {error}", code, line)


@pytest.mark.parametrize(
    ("code", "passed"),
    [
        ("Thread(target=stop())\ndef stop(number): pass\n", True),
        ("node.create_timer(1, self.stop())\ndef stop(number): pass\n", True),
        ("print(stop())\ndef stop(number): pass\n", False),
        ("stop()\ndef stop(number): pass\n", False),
    ],
)
def test_a_function_that_is_called_too_early(code: str, passed: bool) -> None:
    error = "TypeError: stop() missing 1 required positional argument: 'number'"
    assert ("Pass the function itself" in told(error, code, 1)) is passed


@pytest.mark.parametrize(
    ("error", "code", "is_hint"),
    [
        (
            "AttributeError: 'A' object has no attribute 'b'",
            "class A:\n  def f(self):\n    self.b: int\n",
            True,
        ),
        ("NameError: name 'b' is not defined", "b: 5\nprint(b)\n", True),
        ("NameError: name 'b' is not defined", "b: int = 5\n", False),
        ("AttributeError: 'A' object has no attribute 'b'", "class A:\n  b: int\n", False),
        (
            "AttributeError: 'B' object has no attribute 'b'",
            "class A:\n  def f(self):\n    self.b: 1\n",
            False,
        ),
    ],
)
def test_a_hint_assigns_nothing(error: str, code: str, is_hint: bool) -> None:
    assert ("only a type hint" in told(error, code, 1)) is is_hint


def test_a_package_that_imports_from_itself() -> None:
    error = "ImportError: cannot import name 'Quote' from partially initialized module 'talk'"
    others = {"_quote.py": "class Quote: pass"}
    words = told(error, "from talk import Quote\n", 1, "src/talk/talk/__init__.py", others)
    assert words == "This file imports `Quote` from itself. Write `from talk._quote import Quote`."
    assert "Two files import each other" in told(error, "", 1, "src/talk/talk/_words.py", others)


def test_a_public_part_comes_before_a_private_one() -> None:
    error = "ImportError: cannot import name 'Quote' from 'talk'"
    others = {"words/_quote.py": "class Quote: pass", "words/__init__.py": "from x import Quote"}
    assert "from talk.words import Quote" in told(error, "", 1, others=others)


@pytest.mark.parametrize("code", ["def main(args, more): pass\n", "def main(args):\n    pass\nmain()\n"])
def test_main_gets_no_arguments(code: str) -> None:
    error = "TypeError: main() missing 1 required positional argument: 'args'"
    assert "without arguments" in told(error, code, 1)
    assert "without arguments" not in told(error, code.replace("args", "self", 1), 1)
    assert "without arguments" not in told(error, f"{code}main([])\n", 1)


def test_only_a_parameter_without_a_default_may_be_none() -> None:
    error = "TypeError: float() argument must be a string or a real number, not 'NoneType'"
    code = "declare_parameter('a'{})\na = get_parameter('a').value\ncreate_timer({}, tick)\n"
    assert "sets no default value" in told(error, code.format("", "a"), 3)
    assert "sets no default value" not in told(error, code.format(", 1", "a"), 3)
    assert "sets no default value" not in told(error, code.format("", "b"), 3)
