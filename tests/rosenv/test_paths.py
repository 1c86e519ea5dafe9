""""""

from __future__ import annotations

from pathlib import Path

import pytest

from course.rosenv import cache_dir
from course.rosenv.paths import every_prefix, sourced_prefixes, split, without
from tests.rosenv.made_up import installed, register, workspace


@pytest.mark.parametrize(
    ("environ", "expected"),
    [
        ({"ROS2COURSE_CACHE": "/own", "XDG_CACHE_HOME": "/xdg", "HOME": "/h"}, "/own"),
        ({"ROS2COURSE_CACHE": "", "XDG_CACHE_HOME": "/xdg", "HOME": "/h"}, "/xdg/ros2course"),
        ({"XDG_CACHE_HOME": "relative", "HOME": "/h"}, "/h/.cache/ros2course"),
        ({"HOME": "/h"}, "/h/.cache/ros2course"),
    ],
)
def test_the_first_that_is_set_is_the_cache(environ: dict[str, str], expected: str) -> None:
    assert cache_dir(environ) == Path(expected)


def test_a_relative_cache_means_the_current_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert cache_dir({"ROS2COURSE_CACHE": "here"}) == tmp_path / "here"


def joined(*paths: Path) -> dict[str, str]:
    return {"AMENT_PREFIX_PATH": ":".join(map(str, paths))}


def test_without_rclpy_nothing_is_sourced(tmp_path: Path) -> None:
    assert sourced_prefixes({}) is None
    assert sourced_prefixes(joined(*workspace(tmp_path / "ws/install", "mine"))) is None


def test_a_workspace_on_top_is_dropped_and_what_lies_beneath_is_kept(tmp_path: Path) -> None:
    ros, below = tmp_path / "ros", tmp_path / "below"
    installed(ros)
    top = workspace(tmp_path / "ws/install", "one", "two")
    sourced = sourced_prefixes(joined(*top, ros, below))
    assert (sourced.rclpy, sourced.kept, sourced.dropped) == (ros, (ros, below), tuple(top))


def test_a_ros_built_from_source_is_kept_whole(tmp_path: Path) -> None:
    std, rclpy, rcl = workspace(tmp_path / "ros/install", "std_msgs", "rclpy", "rcl")
    (mine,) = workspace(tmp_path / "ws/install", "mine")
    sourced = sourced_prefixes(joined(mine, std, rclpy, rcl))
    assert (sourced.rclpy, sourced.kept, sourced.dropped) == (rclpy, (std, rclpy, rcl), (mine,))


def test_paths_in_and_around_dropped_prefixes_are_taken_out(tmp_path: Path) -> None:
    (mine,) = workspace(tmp_path / "install", "mine")
    paths = [str(mine), f"{mine}/bin", str(mine.parent), f"{mine}_other/bin", "/usr/bin"]
    assert without(paths, (mine,)) == [f"{mine}_other/bin", "/usr/bin"]


def test_the_folder_around_a_merged_install_stays(tmp_path: Path) -> None:
    register(tmp_path / "merged", "mine")
    assert without([str(tmp_path)], (tmp_path / "merged",)) == [str(tmp_path)]


def test_empty_entries_are_left_out() -> None:
    assert split(":/a::/b:") == ["/a", "/b"]
    assert split(None) == []
    assert every_prefix({"AMENT_PREFIX_PATH": "/a:", "COLCON_PREFIX_PATH": "/b"}) == (Path("/a"), Path("/b"))
