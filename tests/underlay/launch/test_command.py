"""The command line of `ros2 launch`."""

from __future__ import annotations

import subprocess

import pytest

from tests.underlay.launch.machine import Launcher
from tests.underlay.launch.workspace import LAUNCH_FILE, WITH_LAUNCH


def test_an_unknown_package(launcher: Launcher) -> None:
    answer = launcher("nosuch_package", "nosuch_launch.py")
    assert answer.stderr.startswith(
        "Package 'nosuch_package' not found: \"package 'nosuch_package' not found, searching: ["
    )
    assert (answer.code, answer.stdout) == (1, "")


def test_a_path_that_is_not_there(launcher: Launcher) -> None:
    answer = launcher("/nosuch/dir/x_launch.py")
    assert "Traceback" not in answer.stderr and "'/nosuch/dir/x_launch.py'" in answer.stderr
    assert (answer.code, answer.stdout) == (1, "")


def test_a_path_from_here(launcher: Launcher) -> None:
    launcher.description("LogInfo(msg=ThisLaunchFileDir()), LogInfo(msg=ThisLaunchFile())")
    answer = launcher("test_launch.py")
    assert answer.logged == [str(launcher.cwd), str(launcher.cwd / "test_launch.py")]


def test_the_same_file_twice(launcher: Launcher) -> None:
    share = launcher.workspace / "install/telling/share/telling"
    for folder in ("a", "b"):
        (share / folder).mkdir(exist_ok=True)
        (share / folder / "twice_launch.py").touch()
    answer = launcher("telling", "twice_launch.py")
    assert answer.stderr.startswith(
        "file 'twice_launch.py' was found more than once in the share directory of package 'telling': ['"
    )
    assert answer.code == 1


def test_wrong_usage(launcher: Launcher) -> None:
    assert launcher().code == 2
    assert launcher("-s", "-p", WITH_LAUNCH).code == 2


def test_the_last_of_two_values_wins(launcher: Launcher) -> None:
    answer = launcher.run("LogInfo(msg=LaunchConfiguration('a'))", "a:=1", "a:=x:=y")
    assert answer.logged == ["x:=y"]


def test_arguments_of_included_files_are_shown(launcher: Launcher) -> None:
    inner = launcher.description("DeclareLaunchArgument('below', default_value='')", name="inner_launch.py")
    path = launcher.description(
        "DeclareLaunchArgument("
        "    'top', default_value=[LaunchConfiguration('x'), '!'], description='Two\\nlines'),"
        f"GroupAction([IncludeLaunchDescription(PythonLaunchDescriptionSource('{inner}'))])"
    )
    assert launcher("-s", path).stdout == (
        "Arguments (pass arguments as '<name>:=<value>'):\n\n"
        "    'top':\n        Two\n        lines\n        (default: LaunchConfig('x') + '!')\n\n"
        "    'below':\n        no description given\n        (default: '')"
    )


def test_a_broken_file_is_told_by_show_args(launcher: Launcher) -> None:
    answer = launcher("-s", launcher.file("raise ValueError('oh')\n"))
    assert " - ValueError: oh" in answer.stderr
    assert (answer.code, answer.stdout) == (1, "")


def test_a_folder_that_cannot_be_written(launcher: Launcher) -> None:
    (launcher.cwd / "file").touch()
    path = launcher.description("LogInfo(msg='x')")
    answer = launcher(path, ROS_LOG_DIR=str(launcher.cwd / "file" / "logs"))
    assert answer.stderr.startswith("cannot write log files: ")
    assert answer.code == 1


def _completions(launcher: Launcher, line: str) -> set[str]:
    """What argcomplete would offer, as a shell asks for it."""
    done = subprocess.run(
        ["/bin/sh", "-c", f"exec {launcher.python} -m ros2cli 8>&1 9>/dev/null >/dev/null"],
        env={
            **launcher.environment,
            "_ARGCOMPLETE": "1",
            "_ARGCOMPLETE_IFS": "\n",
            "COMP_LINE": line,
            "COMP_POINT": str(len(line)),
        },
        cwd=launcher.cwd,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    return {word.strip() for word in done.stdout.splitlines()}


@pytest.mark.slow
def test_completion(launcher: Launcher) -> None:
    assert WITH_LAUNCH in _completions(launcher, "ros2 launch python_package")
    assert LAUNCH_FILE in _completions(launcher, f"ros2 launch {WITH_LAUNCH} ")
    path = launcher.description("DeclareLaunchArgument('topic', default_value='x')")
    assert "topic:=" in _completions(launcher, f"ros2 launch {path} ")
