"""An environment that knows nothing of ROS, wherever the caller stands."""

from __future__ import annotations

from pathlib import Path

from course.rosenv import node_environment, plain_environment
from tests.rosenv.made_up import pip_ros, wheels


def test_of_a_sourced_shell_nothing_of_ros_is_left(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    outer = {"PATH": "/usr/bin:/bin", "HOME": "/home/me", "ROS2COURSE_CACHE": str(tmp_path / "cache")}
    sourced = node_environment(ros, environ=outer)
    assert str(ros.prefix) in sourced["PATH"]
    plain = plain_environment(ros, {**sourced, "ROS_DOMAIN_ID": "7", "SECRET": "x", "LANG": "de"})
    assert plain == {"PATH": "/usr/bin:/bin", "HOME": "/home/me", "LANG": "de"}


def test_an_active_environment_of_the_wheels_is_left_out_too(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    plain = plain_environment(ros, {"PATH": f"{ros.prefix}/bin:/usr/bin"})
    assert plain == {"PATH": "/usr/bin"}


def test_without_a_path_there_is_the_usual_one(tmp_path: Path) -> None:
    ros = pip_ros(wheels(tmp_path / "venv"))
    assert plain_environment(ros, {})["PATH"] == "/usr/local/bin:/usr/bin:/bin"
