"""What a `.bashrc` sources, according to a real bash."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from course.evidence.recording import Recording
from course.model.events import ShellRan, ShellReady
from course.model.feedback import Location
from lib.sourcing import TRACE, environments, sourced, workspaces

WORKSPACE = "~/ros2_tutorial_workspace/install/setup.bash"


def traced(home: Path, bashrc: str) -> Recording:
    (home / ".bashrc").write_text(bashrc)
    environment = {"HOME": str(home), "PATH": "/usr/local/bin:/usr/bin:/bin", "TERM": "dumb"}
    done = subprocess.run(["bash", "-c", TRACE], env=environment, capture_output=True, text=True, check=True)
    ran = ShellRan(2.0, "bash", TRACE, tuple(done.stdout.splitlines()), 0, 1.0)
    return Recording("05-workspace", events=(ShellReady(0.5, "bash", ()), ran))


@pytest.mark.parametrize(
    "line",
    [
        "source /opt/ros/other/setup.bash",
        "  . /opt/ros/other/setup.bash",
        "if true; then . '/opt/ros/other/setup.bash'; fi",
        'D=other; source "/opt/ros/$D/setup.bash"',
    ],
)
def test_a_line_in_any_form_is_found_with_its_place(tmp_path: Path, line: str) -> None:
    (one,) = environments(traced(tmp_path, f"# a remark\n{line}\n"))
    assert (one.target, one.where) == ("/opt/ros/other/setup.bash", Location(".bashrc", 2))


def test_what_bash_does_not_reach_is_not_there(tmp_path: Path) -> None:
    text = "# source /a/setup.bash\nif false; then . /b/setup.bash; fi\nreturn\n. /c/setup.bash\n"
    assert sourced(traced(tmp_path, text)) == ()


def test_a_file_that_is_read_counts_with_its_own_lines(tmp_path: Path) -> None:
    (tmp_path / "more").write_text("\n. /opt/ros/other/setup.bash\n")
    (one,) = environments(traced(tmp_path, ". ~/more\n"))
    assert one.where == Location("more", 2)


def test_a_workspace_is_told_from_ros_and_what_it_sources_is_not_counted(tmp_path: Path) -> None:
    install = tmp_path / "ros2_tutorial_workspace/install"
    install.mkdir(parents=True)
    (install / "setup.bash").write_text(". /opt/ros/other/setup.bash\n")
    recording = traced(tmp_path, f". /opt/ros/other/setup.bash\nsource {WORKSPACE}\n")
    assert [one.where.line for one in environments(recording)] == [1]
    assert [one.target for one in workspaces(recording)] == [WORKSPACE]
