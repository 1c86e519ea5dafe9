"""Arguments for nodes, and what rcl makes of them."""

from __future__ import annotations

import pytest

from course.arena.ros_args import ParameterValue, parameter_text, ros_args


def test_nothing_is_given() -> None:
    assert ros_args() == ()
    assert ros_args({}, {}, "") == ()


def test_all_of_them() -> None:
    assert ros_args({"period": 0.25}, {"/a": "/b"}, "talker") == (
        "--ros-args", "-p", "period:=0.25", "-r", "/a:=/b", "-r", "__node:=talker",
    )  # fmt: skip


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ("0.5", '"0.5"'),
        ("true", '"true"'),
        ("", '""'),
        ('say "hi"\n', '"say \\"hi\\"\\n"'),
        ("häufig, 日本", '"häufig, 日本"'),
        (True, "true"),
        (False, "false"),
        (1, "1"),
        (2.0, "2.0"),
        (1e-7, "1e-07"),
        (float("inf"), ".inf"),
        (float("-inf"), "-.inf"),
        ([1.0, 2.5], "[1.0, 2.5]"),
        (["a", "1"], '["a", "1"]'),
    ],
)
def test_values(value: ParameterValue, text: str) -> None:
    assert parameter_text(value) == text
