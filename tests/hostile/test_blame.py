"""Programs that do something wrong, and want it to look like an error of the grader or the machine.

Each is graded with a wrong node, which must not pass, and with a right one, which may fail for what it does
besides. Neither is ever our error.
"""

from __future__ import annotations

import pytest

from course.arena.lateness import Lateness
from course.model.result import Verdict
from tests.hostile.world import NODE, Grade, judged, with_attack

pytestmark = pytest.mark.slow
GUARANTEE = "a wrong program cannot choose to be the grader's fault"
ATTACKS = [
    ("raw_packets", {"THREADS": 1}),
    ("raw_packets", {"THREADS": 8}),
    ("bursts", {"MESSAGES": 1, "SIZE": 60_000_000}),
    ("bursts", {"MESSAGES": 10_000, "SIZE": 10}),
    ("busy", {"PROCESSES": 8}),
    ("pressure", {}),
    ("many_publishers", {"PUBLISHERS": 2000}),
]
NAMES = ["-".join([attack, *map(str, settings.values())]) for attack, settings in ATTACKS]


def wrong(text: str) -> str:
    assert "message.id = self.next_id" in text
    return text.replace("message.id = self.next_id", "message.id = 7")


def test_words_of_the_library(grade: Grade, machine: Lateness) -> None:
    graded = grade({NODE: with_attack("fake_shutdown")}, guarantee=GUARANTEE)
    assert judged(graded, machine, GUARANTEE) is Verdict.NOT_PASSED, graded.result
    assert graded.failed == ("interrupt",)
    assert "rclpy failed while it shut down" in graded.words("interrupt")


@pytest.mark.parametrize(("attack", "settings"), ATTACKS, ids=NAMES)
def test_a_wrong_node(grade: Grade, machine: Lateness, attack: str, settings: dict[str, int]) -> None:
    graded = grade({NODE: wrong(with_attack(attack, **settings))}, guarantee=GUARANTEE)
    assert judged(graded, machine, GUARANTEE) is Verdict.NOT_PASSED, graded.result


@pytest.mark.parametrize(("attack", "settings"), ATTACKS, ids=NAMES)
def test_a_right_node(grade: Grade, machine: Lateness, attack: str, settings: dict[str, int]) -> None:
    graded = grade({NODE: with_attack(attack, **settings)}, guarantee=GUARANTEE)
    assert judged(graded, machine, GUARANTEE) in (Verdict.PASSED, Verdict.NOT_PASSED), graded.result
