from pathlib import Path

import pytest

from course.rosenv import cache_dir


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
