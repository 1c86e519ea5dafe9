"""Functions that ROS calls back."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.grading.explain.callbacks import callbacks, in_callbacks

FILE = "src/talk/talk/talker.py"


def sources(text: str) -> Sources:
    return Sources({FILE: text, "src/talk/setup.py": "def tick(): pass"})


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
