"""Why callbacks are never called."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.grading.explain.spinning import never_spun

FILE = "src/talk/talk/talker.py"
MADE = "class Talker(Node):\n    def __init__(self):\n        super().__init__('talker')\n"


def sources(text: str) -> Sources:
    return Sources({FILE: text})


def test_nothing_spins() -> None:
    cause = never_spun(sources(f"{MADE}Talker()\nwhile True:\n    time.sleep(1)\n"))
    assert cause is not None
    assert "rclpy.spin(node)" in cause.text


@pytest.mark.parametrize("spin", ["rclpy.spin(node)", "executor.spin()", "spin_once(node)"])
def test_something_does(spin: str) -> None:
    assert never_spun(sources(f"{MADE}\n{spin}\n")) is None


def test_a_constructor_that_spins() -> None:
    cause = never_spun(sources(f"{MADE}        rclpy.spin(self)\n        self.create_timer(1, self.tick)\n"))
    assert cause is not None
    assert "`__init__`" in cause.text
    assert [str(place) for place in cause.where] == [f"{FILE}:4"]
