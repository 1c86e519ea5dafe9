"""What is wrong with a timer."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.grading.explain.timers import called_callback, long_period, timer_cause, timer_places

FILE = "src/talk/talk/talker.py"
TICK = "def tick(self):\n    self.count += 1\n"
MAKER = "def make(self):\n    return self.tick\ndef stop(self):\n    return\n"


def sources(text: str) -> Sources:
    return Sources({FILE: text})


def test_no_timer_at_all() -> None:
    cause = timer_cause(sources("rclpy.spin(node)"))
    assert cause is not None
    assert "No timer is made" in cause.text
    assert cause.where == ()


@pytest.mark.parametrize(
    "argument", ["self.tick", "tick", "callback=self.tick", "lambda: self.tick()", "partial(self.tick, 1)"]
)
def test_a_timer_that_is_right(argument: str) -> None:
    assert timer_cause(sources(f"self.create_timer(0.5, {argument})\n{TICK}")) is None


@pytest.mark.parametrize(
    ("argument", "is_called"),
    [
        ("self.tick()", True),
        ("callback=self.tick()", True),
        ("self.timer_callback()", True),  # not to be found, but its name says what it is
        ("on_timer()", True),
        ("self.stop()", True),  # returns, but nothing
        ("self.make()", False),  # returns a function
        ("functools.partial(self.timer_callback)", False),
        ("unknown()", False),
        ("self.tick", False),
    ],
)
@pytest.mark.parametrize("taker", ["create_timer(0.5, {})", "create_subscription(String, 'talk', {}, 10)"])
def test_a_callback_that_is_called(taker: str, argument: str, is_called: bool) -> None:
    if argument.startswith("callback=") and "String" in taker:
        taker = "create_subscription(String, 'talk', qos_profile=10, {})"
    cause = called_callback(sources(f"\nself.{taker.format(argument)}\n{TICK}{MAKER}"))
    assert (cause is not None) is is_called
    if cause:
        plain = argument.removeprefix("callback=").removesuffix("()")
        assert f"`{plain}()` calls the function at once" in cause.text
        assert f"`{plain}`, without brackets" in cause.text
        assert [str(place) for place in cause.where] == [f"{FILE}:2"]


def test_a_callback_that_returns_a_function_in_the_end_is_right() -> None:
    maker = "def callback_for(name):\n    def inner(): pass\n    return inner\n"
    text = f"x.create_timer(0.5, self.callback_for('a'))\n{maker}"
    assert called_callback(sources(text)) is None


@pytest.mark.parametrize(
    ("period", "written"),
    [
        ("500", "0.5"),
        ("500.0", "0.5"),
        ("timer_period_sec=1000", "1"),
        ("self.period", "0.25"),
        ("10", "0.01"),
    ],
)
def test_a_period_in_milliseconds(period: str, written: str) -> None:
    cause = long_period(sources(f"self.period = 250\nself.create_timer({period}, callback=self.tick)"))
    assert cause is not None
    assert f"Write `{written}`." in cause.text
    assert [str(place) for place in cause.where] == [f"{FILE}:2"]


@pytest.mark.parametrize("period", ["0.5", "9.99", "1 / 2", "f()", "0"])
def test_a_period_in_seconds(period: str) -> None:
    assert long_period(sources(f"self.create_timer({period}, self.tick)")) is None


def test_a_called_callback_is_the_first_cause() -> None:
    cause = timer_cause(sources(f"self.create_timer(500, self.tick())\n{TICK}"))
    assert cause is not None
    assert "calls the function at once" in cause.text


def test_where_timers_are() -> None:
    given = sources("create_timer(1, a)\n\nself.create_timer(1, b)")
    assert [place.line for place in timer_places(given)] == [1, 3]


def test_none_for_a_callback() -> None:
    cause = called_callback(sources("\nself.create_timer(0.5, None)\n"))
    assert cause is not None
    assert cause.text.startswith("`None` stands where the callback belongs")
    assert [str(place) for place in cause.where] == [f"{FILE}:2"]
