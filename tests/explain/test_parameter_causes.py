"""What is wrong with a node's parameters."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.explain.parameter_causes import declared, named, read_once, undeclared, value_forgotten
from tests.golden import golden

FILE = "src/talk/talk/talker.py"
ERROR = "rclpy.exceptions.ParameterNotDeclaredException: Invalid access to undeclared parameter(s): {}"


def sources(text: str) -> Sources:
    return Sources({FILE: text})


@pytest.mark.parametrize("shown", ["qoute", "['qoute']"])
def test_an_undeclared_parameter_that_is_a_slip(shown: str) -> None:
    code = "self.declare_parameter('quote', 'a')\nself.get_parameter('qoute')\n"
    golden(undeclared(ERROR.format(shown), sources(code)))


def test_a_parameter_that_is_not_declared_at_all() -> None:
    golden(undeclared(ERROR.format("quote"), sources("self.get_parameter('quote')")))


@pytest.mark.parametrize("given", ["[('quote', 'a')]", "ROWS"])
@pytest.mark.parametrize(("prefix", "is_told"), [("texts", True), ("", False)])
def test_a_parameter_that_is_declared_below_a_namespace(given: str, prefix: str, is_told: bool) -> None:
    code = f"ROWS = [('quote', P())]\nself.declare_parameters('{prefix}', {given})\n"
    cause = undeclared(ERROR.format("quote"), sources(code))
    assert cause is not None
    assert ("`texts.quote`" in cause.text) is is_told


@pytest.mark.parametrize(
    ("declared_one", "line", "is_told"),
    [
        ("topic_name", "get_parameter('topic')", True),
        ("topic_name", "topic_name = get_parameter('place').value", True),
        ("speed", "topic = get_parameter('topic').value", False),
        ("topic_name", "get_parameter('topic')\nget_parameter('topic_name')", False),
    ],
)
def test_a_parameter_that_is_read_by_the_name_of_another(declared_one: str, line: str, is_told: bool) -> None:
    name = "place" if "place" in line else "topic"
    code = f"declare_parameter('{declared_one}', 'a')\n{line}\n"
    cause = undeclared(ERROR.format(name), sources(code))
    assert cause is not None
    assert ("Use the same name in both lines" in cause.text) is is_told


def test_another_error() -> None:
    assert undeclared("ValueError: no", sources("")) is None


def test_names_that_are_declared() -> None:
    code = "self.declare_parameter('a', 1)\nself.declare_parameters('', [('b', 'c'), ('d', 2)])\n"
    assert declared(sources(code)) >= {"a", "b", "d"}
    assert [place.line for place in named(sources(code), "d")] == [2]


def test_a_parameter_that_is_read_once() -> None:
    code = "self.quote = self.get_parameter('quote').value\ncreate_timer(1, self.tick)\ndef tick(self):\n    "
    cause = read_once(sources(code + "pass\n"), "quote")
    assert cause is not None
    assert [place.line for place in cause.where] == [1]
    assert read_once(sources(code + "self.get_parameter('quote')\n"), "quote") is None


@pytest.mark.parametrize(
    "error",
    [
        "TypeError: float() argument must be a string or a real number, not 'Parameter'",
        "AssertionError: The 'quote' field must be of type 'str'",
        "TypeError: rclpy_resolve_name(): incompatible function arguments. The following",
    ],
)
def test_a_value_that_is_forgotten(error: str) -> None:
    for given in (
        "period = {}\nself.create_timer(period, self.tick)\n",
        "self.create_timer({}, self.tick)\n",
    ):
        cause = value_forgotten(error, sources(given.format("self.get_parameter('period')")))
        assert cause is not None
        assert "`self.get_parameter('period').value`" in cause.text
        assert [place.line for place in cause.where] == [1]


@pytest.mark.parametrize(
    "code",
    [
        "period = self.get_parameter('period').value\n",
        "a, b = self.get_parameters(['a', 'b'])\nprint(a.value, b.value)\n",
        "period = self.get_parameter('period').get_parameter_value().double_value\n",
        "period = self.get_parameter('period')\nself.create_timer(period.value, self.tick)\n",
        "self.period = self.get_parameter('period')\nself.create_timer(self.period.value, self.tick)\n",
    ],
)
def test_a_value_that_is_taken(code: str) -> None:
    assert value_forgotten("TypeError: incompatible function arguments", sources(code)) is None


def test_one_of_several_values_is_forgotten() -> None:
    code = "a, b = self.get_parameters(['a', 'b'])\nprint(a.value, b)\n"
    cause = value_forgotten("TypeError: incompatible function arguments", sources(code))
    assert cause is not None
    assert "`b.value`" in cause.text


def test_an_error_that_is_not_about_a_type() -> None:
    assert value_forgotten("KeyError: 1", sources("x = self.get_parameter('period')")) is None


@pytest.mark.parametrize(
    ("getter", "error", "says"),
    [
        (
            "get_parameter",
            "TypeError: '<' not supported between instances of 'float' and 'Parameter'",
            "not its value",
        ),
        ("get_parameter_value", "AssertionError: The 'quote' field must be of type 'str'", ".string_value"),
    ],
)
def test_only_what_is_used_whole(getter: str, error: str, says: str) -> None:
    cause = value_forgotten(error, sources(f"x = node.{getter}('period')\nprint(x)"))
    assert cause is not None and says in cause.text
    assert value_forgotten(error, sources(f"x = node.{getter}('period')\nprint(x.string_value)")) is None
