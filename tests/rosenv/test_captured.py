from dataclasses import replace
from pathlib import Path

import pytest

from course.errors import MissingHere
from course.rosenv import Ros, find_ros
from course.rosenv.captured import captured_variables
from tests.rosenv.made_up import installed, no_wheels


@pytest.fixture
def ros(tmp_path: Path) -> Ros:
    host = no_wheels(tmp_path)
    installed(host.installed)
    return find_ros({}, host)


@pytest.fixture
def environ(tmp_path: Path) -> dict[str, str]:
    return {
        "ROS2COURSE_CACHE": str(tmp_path / "cache"),
        "FORBIDDEN": "1",
        "PATH": "/mine",
        "HOME": "/home/me",
    }


def test_setup_bash_is_sourced_in_a_plain_shell(ros: Ros, environ: dict[str, str]) -> None:
    variables = captured_variables(ros, environ)
    assert variables["AMENT_PREFIX_PATH"] == str(ros.prefix)
    assert variables["PATH"] == f"{ros.prefix}/bin", "the PATH of the shell got in"
    assert set(variables) == {"AMENT_PREFIX_PATH", "LD_LIBRARY_PATH", "PATH", "PYTHONPATH"}


def test_it_is_sourced_once_and_again_when_the_ros_changes(ros: Ros, environ: dict[str, str]) -> None:
    first = captured_variables(ros, environ)
    assert captured_variables(ros, environ) == first
    assert (ros.prefix / "sourced").read_text() == "once\n"
    captured_variables(replace(ros, identity="another"), environ)
    assert (ros.prefix / "sourced").read_text() == "once\nonce\n"


@pytest.mark.parametrize("text", ["", "{", "[]", '{"identity": 1}', '{"identity": "ID", "variables": []}'])
def test_a_damaged_memory_is_made_anew(ros: Ros, environ: dict[str, str], tmp_path: Path, text: str) -> None:
    first = captured_variables(ros, environ)
    (memory,) = (tmp_path / "cache").rglob("*.json")
    memory.write_text(text.replace("ID", ros.identity))
    assert captured_variables(ros, environ) == first


def test_a_cache_that_cannot_be_written_costs_only_time(ros: Ros, tmp_path: Path) -> None:
    (tmp_path / "cache").write_text("a file, not a folder")
    assert (
        captured_variables(ros, {"ROS2COURSE_CACHE": str(tmp_path / "cache")})["PATH"] == f"{ros.prefix}/bin"
    )


@pytest.mark.parametrize(
    ("script", "reason"), [("echo broken >&2; exit 1", "broken"), ("true", "sets no AMENT_PREFIX_PATH")]
)
def test_a_broken_setup_bash_is_named(ros: Ros, environ: dict[str, str], script: str, reason: str) -> None:
    (ros.prefix / "setup.bash").write_text(script)
    with pytest.raises(MissingHere, match=reason) as caught:
        captured_variables(ros, environ)
    assert f"bash -c 'source {ros.prefix}/setup.bash'" in (caught.value.next_step or "")
