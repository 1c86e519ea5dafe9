"""Which course home a command is about: the first that is named, or stood in, or the usual one."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.errors import UsageError
from course.home import create_home, find_home


@pytest.fixture
def user(tmp_path: Path) -> Path:
    """A user's own home, with the usual course home in it."""
    create_home(tmp_path / "user/ros2course")
    return tmp_path / "user"


def test_an_option_goes_before_all(tmp_path: Path, user: Path) -> None:
    wanted = create_home(tmp_path / "wanted")
    environ = {"HOME": str(user), "ROS2COURSE_HOME": str(user / "ros2course")}
    assert find_home(wanted.path, environ, user / "ros2course") == wanted


def test_an_option_may_be_relative_or_begin_with_a_tilde(tmp_path: Path, user: Path) -> None:
    wanted = create_home(tmp_path / "wanted")
    assert find_home(Path("../wanted"), {}, user) == wanted
    assert find_home(Path("~/ros2course"), {"HOME": str(user)}, tmp_path).path == user / "ros2course"


def test_the_variable_goes_before_the_folder(tmp_path: Path, user: Path) -> None:
    wanted, other = create_home(tmp_path / "wanted"), create_home(tmp_path / "other")
    environ = {"HOME": str(user), "ROS2COURSE_HOME": str(wanted.path)}
    assert find_home(None, environ, other.path) == wanted


def test_the_folder_or_one_above_goes_before_the_usual_one(tmp_path: Path, user: Path) -> None:
    wanted = create_home(tmp_path / "wanted")
    assert find_home(None, {"HOME": str(user)}, wanted.path) == wanted
    assert find_home(None, {"HOME": str(user), "ROS2COURSE_HOME": ""}, wanted.workspace / "src") == wanted


def test_the_usual_one_comes_last(tmp_path: Path, user: Path) -> None:
    assert find_home(None, {"HOME": str(user)}, tmp_path).path == user / "ros2course"


def test_without_any_the_way_to_one_is_told(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="no course home") as caught:
        find_home(None, {"HOME": str(tmp_path)}, tmp_path)
    assert "ros2course init" in (caught.value.next_step or "")


@pytest.mark.parametrize("by", ["--home", "ROS2COURSE_HOME"])
def test_one_that_is_named_is_not_replaced_by_another(tmp_path: Path, user: Path, by: str) -> None:
    option = tmp_path if by == "--home" else None
    environ = {"HOME": str(user), **({} if option else {"ROS2COURSE_HOME": str(tmp_path)})}
    with pytest.raises(UsageError, match=f"from {by}.* is not a course home") as caught:
        find_home(option, environ, user / "ros2course")
    assert caught.value.next_step == f"make one there: ros2course init {tmp_path}"


def test_environment_and_folder_are_the_process_s_own_unless_given(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    wanted = create_home(tmp_path / "wanted")
    monkeypatch.setenv("ROS2COURSE_HOME", str(wanted.path))
    assert find_home() == wanted
    monkeypatch.delenv("ROS2COURSE_HOME")
    monkeypatch.chdir(wanted.workspace)
    assert find_home() == wanted


def test_a_deleted_folder_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    gone = tmp_path / "gone"
    gone.mkdir()
    monkeypatch.chdir(gone)
    gone.rmdir()
    with pytest.raises(UsageError, match="was deleted"):
        find_home(None, {"HOME": str(tmp_path)})
