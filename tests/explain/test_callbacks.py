"""Functions that ROS calls back: why they are not called, and what is in them."""

from __future__ import annotations

from collections.abc import Callable
from itertools import accumulate

import pytest

from course.evidence.sources import Sources
from course.explain.callbacks import (
    callbacks,
    called_callback,
    in_callbacks,
    long_period,
    never_spun,
)
from course.explain.engine import Cause
from course.explain.languages import timer_places
from course.explain.paces import pace_cause
from course.explain.python_slips import (
    class_spun,
    inverted_wait,
    loop_without_sleep,
    never_counts,
    python_timer_cause,
    taken_away,
    uncalled,
)
from tests.golden import golden

FILE = "src/talk/talk/talker.py"
TICK = "def tick(self):\n    self.count += 1\n"
MAKER = "def make(self):\n    return self.tick\ndef stop(self):\n    return\n"


def sources(text: str) -> Sources:
    return Sources({FILE: text})


def test_no_timer_at_all() -> None:
    golden(python_timer_cause(sources("rclpy.spin(node)")))


@pytest.mark.parametrize(
    "argument", ["self.tick", "tick", "callback=self.tick", "lambda: self.tick()", "partial(self.tick, 1)"]
)
def test_a_timer_that_is_right(argument: str) -> None:
    assert python_timer_cause(sources(f"self.create_timer(0.5, {argument})\n{TICK}")) is None


@pytest.mark.parametrize(
    ("argument", "is_called"),
    [
        ("self.tick()", True),
        ("callback=self.tick()", True),
        ("self.timer_callback()", True),  # cannot be found, but its name says what it is
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
        assert f"`{plain}()` calls the function immediately" in cause.text
        assert f"without parentheses: `{plain}`" in cause.text
        assert [str(place) for place in cause.where] == [f"{FILE}:2"]


def test_a_callback_that_returns_a_function_in_the_end_is_right() -> None:
    maker = "def callback_for(name):\n    def inner(): pass\n    return inner\n"
    text = f"x.create_timer(0.5, self.callback_for('a'))\n{maker}"
    assert called_callback(sources(text)) is None


@pytest.mark.parametrize("period", ["500", "500.0", "timer_period_sec=1000", "self.period", "10"])
def test_a_period_in_milliseconds(period: str) -> None:
    golden(long_period(sources(f"self.period = 250\nself.create_timer({period}, callback=self.tick)")))


@pytest.mark.parametrize("period", ["0.5", "9.99", "1 / 2", "f()", "0"])
def test_a_period_in_seconds(period: str) -> None:
    assert long_period(sources(f"self.create_timer({period}, self.tick)")) is None


def test_a_called_callback_is_the_first_cause() -> None:
    golden(python_timer_cause(sources(f"self.create_timer(500, self.tick())\n{TICK}")))


def test_where_timers_are() -> None:
    given = sources("create_timer(1, a)\n\nself.create_timer(1, b)")
    assert [place.line for place in timer_places(given)] == [1, 3]


def test_none_for_a_callback() -> None:
    golden(called_callback(sources("\nself.create_timer(0.5, None)\n")))


MADE = "class Talker(Node):\n    def __init__(self):\n        super().__init__('talker')\n"


def test_nothing_spins() -> None:
    golden(never_spun(sources(f"{MADE}Talker()\nwhile True:\n    time.sleep(1)\n")))


EXECUTOR = "executor = SingleThreadedExecutor()\n"


@pytest.mark.parametrize(
    "spin",
    [
        "rclpy.spin(node)",
        "executor.spin()",
        "spin_once(node)",
        f"{EXECUTOR}executor.add_node(node)\nexecutor.spin()",
        f"{EXECUTOR}rclpy.spin(node, executor)",
    ],
)
def test_something_does(spin: str) -> None:
    assert never_spun(sources(f"{MADE}\n{spin}\n")) is None


def test_an_executor_without_a_node() -> None:
    found = never_spun(sources(f"{MADE}{EXECUTOR}executor.spin()\n"))
    assert found is not None
    assert "add_node" in found.text
    assert found.where[0].line == 4


LOOP = "def tick(self):\n    while {}:\n        self.get_logger().info('x'){}\n"


@pytest.mark.parametrize(
    ("gaps", "code", "is_told"),
    [
        (0.001, LOOP.format("True", ""), True),
        (0.5, LOOP.format("True", ""), False),
        (0.001, LOOP.format("True", "; time.sleep(1)"), False),
        (0.001, TICK, False),
    ],
)
def test_a_loop_in_a_callback(gaps: float, code: str, is_told: bool) -> None:
    times = [gaps * number for number in range(20)]
    found = pace_cause(times, 0.5, sources(f"self.create_timer(0.5, self.tick)\n{code}"), written=False)
    assert (found is not None and "This loop" in found.text) is is_told


PRINTS = "def main():\n    while True:\n        print('x')\n        {}\n        time.sleep(0.5)\n"


@pytest.mark.parametrize(
    ("pauses", "line", "is_told"),
    [
        ((0.001, 0.499), "print('y')", True),
        ((0.5, 0.5), "print('y')", False),
        ((0.001, 0.499), "pass", False),
    ],
)
def test_a_loop_that_prints_twice(pauses: tuple[float, float], line: str, is_told: bool) -> None:
    times = list(accumulate(pauses * 8))
    found = pace_cause(times, 0.5, sources(PRINTS.format(line)), written=False)
    assert (found is not None and "Print only once per pass through the loop" in found.text) is is_told


@pytest.mark.parametrize(
    ("code", "lines"),
    [
        ("PERIOD = 1.0\nself.create_timer(PERIOD, self.tick)\n", [1, 2]),
        ("self.create_timer(PERIOD, self.tick)\nx = PERIOD = 1.0\n", [2, 1]),
        ("PERIOD = 'x'\nself.create_timer(1.0, self.tick)\n", [2]),
    ],
)
def test_where_a_wrong_period_is_written(code: str, lines: list[int]) -> None:
    found = pace_cause([1.0, 2.0, 3.0], 0.5, sources(code), written=True)
    assert found is not None and [place.line for place in found.where] == lines


@pytest.mark.parametrize("line", ["input()", "pass"])
def test_a_loop_that_waits_for_input(line: str) -> None:
    found = pace_cause([0.1], 0.5, sources(PRINTS.format(line)), written=False)
    assert ([place.line for place in found.where] if found else None) == ([4] if "input" in line else None)


@pytest.mark.parametrize(
    ("code", "advice"),
    [
        ("rclpy.spin", "write `rclpy.spin(node)`"),
        ("executor.spin", "write `executor.spin()`"),
        ("while not robot.is_enabled:\n    pass", "write `robot.is_enabled()`"),
        ("node.create_timer(1, lambda: node.destroy_node)", "write `node.destroy_node()`"),
        ("node.create_timer(1, lambda: node.destroy_node())", None),
        ("rclpy.spin(node)", None),
    ],
)
def test_a_method_that_is_only_named(code: str, advice: str | None) -> None:
    found = uncalled(sources(code))
    assert advice in found.text if found and advice else found is None and advice is None


KEPT = f"self.timer = self.create_timer(1, self.tick)\n{TICK}"
WAITING = "while client.{}():\n    log('waiting')\n"
SPUN = "class Talker(Node):\n    pass\nrclpy.spin(Talker{})\n"
COUNTING = "create_timer(1, tick)\ndef tick(self):\n    {}\n    {} += 1\n"
ENDLESS = "while True:\n    print('x')\n    {}\n{}time.sleep(1)\n"


@pytest.mark.parametrize(
    ("cause", "wrong", "right", "line"),
    [
        (
            taken_away,
            f"{KEPT}    self.timer.cancel()\n",
            f"{KEPT}    if x:\n        self.timer.cancel()\n",
            4,
        ),
        (taken_away, f"{KEPT}    self.destroy_timer(x)\n", f"{KEPT}\nself.destroy_timer(x)\n", 4),
        (
            inverted_wait,
            WAITING.format("wait_for_service"),
            "while not client.wait_for_service():\n    x\n",
            1,
        ),
        (inverted_wait, "if c.service_is_ready():\n    return\n", "if c.service_is_ready():\n    x()\n", 1),
        (inverted_wait, WAITING.format("service_is_ready"), WAITING.format("is_busy"), 1),
        (loop_without_sleep, ENDLESS.format("", ""), ENDLESS.format("", "    "), 4),
        (loop_without_sleep, ENDLESS.format("", ""), ENDLESS.format("time.sleep(2)", ""), 4),
        (class_spun, SPUN.format(""), SPUN.format("()"), 3),
        (never_counts, COUNTING.format("self.n = 0", "self.n"), COUNTING.format("n = 0", "self.n"), 3),
        (never_counts, COUNTING.format("n = self.n", "n"), COUNTING.format("n = self.n", "self.n"), 3),
        (never_counts, COUNTING.format("n = self.n", "n"), COUNTING.format("n = len(x)", "n"), 3),
        (
            never_counts,
            COUNTING.format("n = self.n", "n"),
            f"{COUNTING.format('n = self.n', 'n')}    self.n = n\n",
            3,
        ),
    ],
)
def test_a_slip_and_right_code_like_it(
    cause: Callable[[Sources], Cause | None], wrong: str, right: str, line: int
) -> None:
    found = cause(sources(wrong))
    assert found is not None
    assert [place.line for place in found.where] == [line]
    assert cause(sources(right)) is None


def test_what_a_future_gives_itself_is_not_bound() -> None:
    code = "task.add_done_callback(told(tag, task))\ndef told(tag, task):\n    print(tag)\n"
    found = called_callback(sources(code))
    assert found is not None
    assert "`partial(told, tag)`" in found.text


def test_a_constructor_that_spins() -> None:
    golden(never_spun(sources(f"{MADE}        rclpy.spin(self)\n        self.create_timer(1, self.tick)\n")))


@pytest.mark.parametrize(
    "maker",
    [
        "create_timer(0.5, self.tick)",
        "create_timer(0.5, callback=self.tick)",
        "create_timer(0.5, lambda: self.tick(1))",
        "create_timer(0.5, partial(self.tick, 1))",
        "create_subscription(T, 'x', tick, 10)",
        "create_service(T, 'x', self.tick)",
        "future.add_done_callback(self.tick)",
    ],
)
def test_a_function_that_is_handed_over(maker: str) -> None:
    (found,) = callbacks(sources(f"{maker}\ndef tick(self, message):\n    pass\ndef other(): pass\n"))
    assert (found.node.name, str(found.where), found.parameters) == ("tick", f"{FILE}:2", ("message",))


def test_of_one_maker_only() -> None:
    code = "create_timer(1, a)\ncreate_service(T, 'x', b)\ndef a(): pass\ndef b(request, response): pass\n"
    assert [found.node.name for found in callbacks(sources(code), "create_service")] == ["b"]


def test_what_a_callback_calls_counts_too() -> None:
    code = (
        "create_timer(1, tick)\n"
        "def tick():\n    self.work()\n"
        "def work(self):\n    time.sleep(1)\n    self.work()\n"
        "def main():\n    time.sleep(1)\n"
    )
    assert [str(place) for place in in_callbacks(sources(code), "sleep")] == [f"{FILE}:5"]


def test_nothing_is_called_back() -> None:
    assert callbacks(sources("def tick(): pass")) == ()
    assert in_callbacks(sources("def tick(): sleep(1)"), "sleep") == ()
