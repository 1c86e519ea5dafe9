"""sas_core in C++: the clock, figures, vectors, and what a driver is."""

from __future__ import annotations

import math

import pytest

from tests.underlay.sas.built import output_of, program

pytestmark = pytest.mark.slow

PERIOD = 0.05


@pytest.fixture(scope="module")
def facts() -> dict[str, list[str]]:
    """What `core` says: by name, one text for each line of that name."""
    found: dict[str, list[str]] = {}
    for line in output_of(program("core")).splitlines():
        name, _, text = line.partition(" ")
        found.setdefault(name, []).append(text)
    return found


def numbers(text: str) -> list[float]:
    return [float(word) for word in text.split()]


def test_a_round_that_takes_time_does_not_shift_those_after_it(facts: dict[str, list[str]]) -> None:
    (elapsed,), (moments,) = numbers(facts["elapsed"][0]), numbers(facts["moments"][0])
    assert moments * PERIOD <= elapsed
    # Each round works for 20 ms: sleeping for the period after that would add 400 ms in all.
    assert elapsed < moments * PERIOD + 0.3


def test_a_round_is_work_and_sleep(facts: dict[str, list[str]]) -> None:
    means, minima, maxima = (numbers(text) for text in facts["statistics"])
    for computing, idle, sampling in (means, numbers(facts["last"][0])):
        assert computing >= 0.02
        assert computing + idle == pytest.approx(sampling, abs=1e-9)
    for least, mean, greatest in zip(minima, means, maxima, strict=True):
        assert 0.0 < least <= mean <= greatest
    assert facts["desired"] == ["0.050000000000000003"]


def test_missed_moments_are_counted(facts: dict[str, list[str]]) -> None:
    assert numbers(facts["missed"][0])[0] >= 3


def test_a_clock_needs_a_sampling_time(facts: dict[str, list[str]]) -> None:
    assert "sampling time must be positive" in facts["invalid"][0]


def test_figures(facts: dict[str, list[str]]) -> None:
    assert facts["empty"] == ["nan"]
    assert numbers(facts["figures"][0]) == pytest.approx([5, 4, 2, 2, 9])


def test_the_last_round_by_the_kind_of_time(facts: dict[str, list[str]]) -> None:
    assert numbers(facts["unasked"][0]) == [0]
    assert numbers(facts["time"][0]) == pytest.approx([0], abs=1e-9)
    assert facts["order"] == ["012"]
    assert "enable_statistics = false" in facts["unkept"][0]


def test_when_a_clock_began_and_woke_up(facts: dict[str, list[str]]) -> None:
    began, woke_up = numbers(facts["wall"][0])
    assert 0 <= began < 60
    assert PERIOD * 0.99 <= woke_up < 60
    assert numbers(facts["blocked"][0])[0] >= 0.1


def test_matrices(facts: dict[str, list[str]]) -> None:
    assert facts["concatenated"] == ["1 2 3 4 5", "3 4 5 1 2"]
    assert facts["stacked"] == ["1 1 / 1 1 / 3 3", "3 3"]
    assert facts["diagonal"] == ["3 3 0 0 / 0 0 1 1 / 0 0 1 1"]
    assert facts["part"] == ["1", "", "2 3 4"]
    assert "they have 2 and 1" in facts["columns"][0]
    assert "no part of 2 elements from element 1 on" in facts["parts"][0]
    assert "must not be negative" in facts["samples"][0]


def test_names_and_ends(facts: dict[str, list[str]]) -> None:
    assert facts["named"] == ["Named"]
    assert facts["ends"] == ["0011"]


def test_vectors(facts: dict[str, list[str]]) -> None:
    assert numbers(facts["radians"][0]) == pytest.approx([math.pi, -math.pi / 2, math.radians(0.5)])
    assert numbers(facts["degrees"][0]) == pytest.approx([180, -90, 0.5, 30])
    assert facts["sizes"] == ["3 2 0"]


def test_a_driver_need_not_do_everything(facts: dict[str, list[str]]) -> None:
    assert facts["unmeasured"] == ["0 0"]
    assert "takes no target velocities" in facts["velocities"][0]
    assert "takes no target torques" in facts["torques"][0]


def test_joint_limits_come_in_pairs(facts: dict[str, list[str]]) -> None:
    assert "there are 2 and 3" in facts["limits"][0]
    assert numbers(facts["greatest"][0]) == [1, 1]
