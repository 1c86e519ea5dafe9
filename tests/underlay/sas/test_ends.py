"""Both ends of a robot's topics, in Python and in C++."""

from __future__ import annotations

import ast
import json
import math
from typing import Any

import pytest

from tests.underlay.sas.built import program
from tests.underlay.sas.place import alone, beside, driver, python

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def facts() -> dict[str, list[Any]]:
    """What `ends.py` says: by name, in the order of its lines."""
    found: dict[str, list[Any]] = {}
    for line in alone(*python("ends.py")).splitlines():
        name, fact = json.loads(line)
        found.setdefault(name, []).append(fact)
    return found


def test_prefixes(facts: dict[str, list[Any]]) -> None:
    assert facts["prefixes"] == [["myrobot_1", "myrobot_1"]]


def test_nothing_can_be_read_before_it_was_told(facts: dict[str, list[Any]]) -> None:
    assert facts["before"] == [[False] * 6]
    for error, topic in zip(facts["too early"][0], ("get/joint_states", "set/target_"), strict=True):
        assert error.startswith(f"RuntimeError: sas_robot_driver: nothing has come on myrobot_1/{topic}")
    assert facts["without limits"] == [False]


def test_what_is_told_is_read(facts: dict[str, list[Any]]) -> None:
    assert facts["read"] == [[[1, 2], [3, 4], [5, 6], [-1, -2], [1, 2], [0, 1]]]
    assert facts["types"] == [["float64", "int32"]]
    assert facts["own copy"] == [[1.0, 2.0]]


def test_what_is_sent_is_heard(facts: dict[str, list[Any]]) -> None:
    assert facts["heard"] == [[[1, 7], [2, 7], [3, 7], [4, 7], [5, 7]]]
    modes = ["PositionControl", "VelocityControl", "ForceControl", "Homing", "ClearPositions"]
    assert facts["active"] == ["Unavailable", *modes]


def test_what_is_no_vector_is_not_sent(facts: dict[str, list[Any]]) -> None:
    for error in facts["no vector"]:
        assert error.startswith("TypeError: A vector is needed, one number per joint")


def test_one_turn_does_all_that_is_there(facts: dict[str, list[Any]]) -> None:
    assert facts["one turn"] == [[1, 1, 1]]


def test_after_the_end_nothing_happens(facts: dict[str, list[Any]]) -> None:
    assert facts["ok"] == [False, False]


def test_a_shutdown_that_ctrl_c_was_quicker_with_is_quiet(facts: dict[str, list[Any]]) -> None:
    assert facts["shutdown"] == ["RCLError: no", "nothing"]


def test_a_program_in_python_commands_a_driver_in_cpp() -> None:
    waiting, positions, counted = beside(driver(), *python("program.py")).splitlines()
    assert waiting == "waiting"
    initial, final = ast.literal_eval(positions.replace("] [", "], ["))
    assert initial == [0.0] * 6
    assert final == pytest.approx([math.radians(10.0) * math.sin(99 / (50 * math.pi))] * 6)
    assert counted == "True"


def test_ctrl_c_ends_a_program_in_python_as_any_other() -> None:
    assert alone(*python("interrupt.py"), *python("program.py")) == "interrupted\n"


def test_a_program_in_cpp_commands_a_driver_in_cpp() -> None:
    before, error, *vectors, limits = beside(driver(), program("client_node"), "myrobot_1").splitlines()
    assert before == "myrobot_1 0"
    assert error.startswith("sas_robot_driver: no joint positions have come on myrobot_1 yet.")
    assert [line.split() for line in vectors] == [["0"] * 6, ["0.25"] * 6]
    assert limits == "6 6"
