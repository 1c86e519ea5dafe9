"""Commands and their effects."""

from __future__ import annotations

import random

import pytest

from course.evidence.stream import Stream
from lib.following import alike, answers, same

from .streams import following, steps, target, ticks

SENT = [0.5 + 0.1 * number for number in range(10)]
COMMANDS = Stream("/arm/targets", tuple(SENT), tuple(target(number + 1) for number in range(10)))


@pytest.mark.parametrize("seed", range(20))
def test_each_answer_has_its_latency(seed: int) -> None:
    late = random.Random(seed).uniform(0, 0.05)
    found = answers(COMMANDS, following(ticks(seed, 0.002, 2.0, jitter=0.3), steps(SENT, late)))
    assert len(found) == 10
    for one in found:
        assert one.latency is not None
        assert late <= one.latency < late + 0.003
        assert one.last == one.target


def test_a_command_that_nothing_comes_of() -> None:
    found = answers(COMMANDS, following(ticks(1, 0.002, 2.0), steps(SENT[:-1])))
    assert [one.latency is None for one in found] == [False] * 9 + [True]
    assert found[-1].last == target(9)


def test_an_answer_after_the_next_command_is_none() -> None:
    found = answers(COMMANDS, following(ticks(1, 0.002, 2.0), steps(SENT, 0.15)))
    assert all(one.latency is None for one in found[:-1])
    assert found[-1].latency == pytest.approx(0.15, abs=0.003)


def test_nothing_at_all() -> None:
    found = answers(COMMANDS, Stream("/arm/states", (), ()))
    assert all(one.latency is None and one.last is None for one in found)


def test_the_same_row() -> None:
    assert same((1.0, 0.0), (1.0 + 1e-9, 1e-9))
    assert not same((1.0, 0.0), (1.0, 1e-3))
    assert not same((1.0,), (1.0, 0.0))
    assert not same((1.0, 2.0), (2.0, 1.0))


def test_joints_that_move_alike() -> None:
    begin = (0.3, -0.2, 0.5)
    moved = tuple(tuple(joint + 0.01 * step for joint in begin) for step in range(20))
    times = tuple(0.01 * step for step in range(20))
    assert alike(Stream("/arm", times, moved))
    assert not alike(Stream("/arm", times, (*moved[:-1], (0.49, -0.01, 0.5))))
    assert not alike(Stream("/arm", times, (*moved[:-1], moved[-1][:2])))
