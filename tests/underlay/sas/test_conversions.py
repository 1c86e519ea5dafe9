"""sas_conversions in C++, on our dqrobotics, says what it says in Python, on the real dqrobotics."""

from __future__ import annotations

import math

import pytest

from tests.underlay.sas.built import output_of, program
from tests.underlay.sas.place import python

pytestmark = pytest.mark.slow

ALGEBRA = ["parts", "products", "sums", "norms", "pose", "powers", "plus", "four", "vectors"]
MESSAGES = ["point", "pose_message", "quaternion", "wrench", "twist", "stamped", "number"]


def facts(*command: str) -> dict[str, str]:
    """What a program says, by the name that begins a line."""
    lines = (line.partition(" ") for line in output_of(*command).splitlines())
    return {name: text for name, _, text in lines}


def numbers(text: str) -> list[float]:
    return [float(word) for word in text.split()]


@pytest.fixture(scope="module")
def ours() -> dict[str, str]:
    return facts(program("conversions"))


@pytest.fixture(scope="module")
def real() -> dict[str, str]:
    return facts(*python("conversions.py"))


@pytest.mark.parametrize("name", [*ALGEBRA, *MESSAGES])
def test_numbers_are_those_of_the_real_dqrobotics(
    name: str, ours: dict[str, str], real: dict[str, str]
) -> None:
    assert numbers(ours[name]) == pytest.approx(numbers(real[name]), abs=1e-12)


@pytest.mark.parametrize("name", ["equal", "text"])
def test_words_are_those_of_the_real_dqrobotics(
    name: str, ours: dict[str, str], real: dict[str, str]
) -> None:
    assert ours[name] == real[name]


def test_a_number_less_a_dual_quaternion(ours: dict[str, str]) -> None:
    """The real one subtracts the number."""
    elements = numbers(ours["difference"])
    assert elements[:8] == pytest.approx([3 - elements[8], *(-element for element in elements[9:])])


def test_a_pose_is_its_place_and_its_rotation(ours: dict[str, str]) -> None:
    place, turn = numbers(ours["pose_message"])[1:4], numbers(ours["pose_message"])[8:12]
    sine = math.sin(0.4) / 7
    assert place == pytest.approx([0.5, -1.25, 4])
    assert turn == pytest.approx([math.cos(0.4), 2 * sine, -3 * sine, 6 * sine])


def test_what_cannot_be_done_is_explained(ours: dict[str, str]) -> None:
    assert ours["size"].endswith("not of 2.")
    assert ours["unit"] == "DQ::translation needs a unit dual quaternion; the norm of this one is 2."
    assert "without a real part" in ours["real"]


def test_stamps_and_what_only_one_language_has(ours: dict[str, str], real: dict[str, str]) -> None:
    assert numbers(ours["stamped_point"])[1:4] == [0.5, -1.25, 4]
    assert 0 <= numbers(ours["age"])[0] < 60
    assert ours["truth"] == "10"
    assert real["stamps"] == "7 7 0"
