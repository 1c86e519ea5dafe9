"""What the learner sources, read by real shells."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from course.rosenv import Ros, find_ros, node_environment, on_this_machine, prepare, setup_script
from tests.rosenv.made_up import installed, no_wheels, pip_ros, underlay, wheels, workspace

PLAIN = {"PATH": "/usr/bin:/bin", "HOME": "/nowhere"}
SHELLS = ["bash", "dash", "zsh"]
_SET_BY_SHELLS = ("_", "PWD", "OLDPWD", "SHLVL", "LOGNAME")


@pytest.fixture
def ros(tmp_path: Path) -> Ros:
    """Wheels in a folder whose name a shell could trip over, ready to be sourced."""
    ros = pip_ros(wheels(tmp_path / "it's $HOME here"))
    prepare(ros, {"HOME": str(tmp_path)})
    return ros


def after(shell: str, script: str, *paths: Path, environ: dict[str, str] = PLAIN) -> dict[str, str]:
    """The environment after a shell has run a script, which has the paths as $1, $2 ..."""
    if (program := shutil.which(shell)) is None:
        pytest.skip(f"{shell} is not installed")
    quiet = {"bash": ["--norc", "--noprofile"], "zsh": ["-f"]}.get(shell, [])
    command = [program, *quiet, "-c", f"set -eu; {script}; env -0", shell, *map(str, paths)]
    output = subprocess.run(command, env=environ, capture_output=True, check=True).stdout
    pairs = (os.fsdecode(entry).partition("=") for entry in output.split(b"\0") if entry)
    return {name: value for name, _, value in pairs if name not in _SET_BY_SHELLS}


def script_for(shell: str, ros: Ros, name: str = "setup") -> Path:
    return ros.prefix / f"{name}.{shell.replace('dash', 'sh')}"


@pytest.mark.parametrize("shell", SHELLS)
@pytest.mark.parametrize("name", ["setup", "local_setup"])
def test_a_shell_gets_what_children_of_the_course_get(shell: str, name: str, ros: Ros) -> None:
    sourced = after(shell, '. "$1"', script_for(shell, ros, name))
    assert sourced == node_environment(ros, environ=PLAIN)


@pytest.mark.parametrize("shell", SHELLS)
def test_sourcing_twice_adds_nothing_twice(shell: str, ros: Ros) -> None:
    script = script_for(shell, ros)
    assert after(shell, '. "$1"; . "$1"', script) == after(shell, '. "$1"', script)


def test_no_function_or_variable_of_ours_stays_behind(ros: Ros) -> None:
    left = after(
        "bash", '. "$1"; export LEFT="$(set | grep ^_ros2course || true)"', ros.prefix / "setup.bash"
    )
    assert left["LEFT"] == ""


def test_what_was_sourced_on_top_stays_on_top(ros: Ros, tmp_path: Path) -> None:
    prefixes = f"/mine:{underlay(ros)}:{ros.prefix}"
    environ = {**PLAIN, "AMENT_PREFIX_PATH": prefixes}
    sourced = after("bash", '. "$1"', ros.prefix / "setup.bash", environ=environ)
    assert sourced["AMENT_PREFIX_PATH"] == prefixes
    environ = {**PLAIN, "LD_LIBRARY_PATH": "/mine"}
    libraries = after("bash", '. "$1"', ros.prefix / "setup.bash", environ=environ)["LD_LIBRARY_PATH"]
    assert libraries.startswith(f"{underlay(ros)}/lib:{ros.prefix}/lib:")
    assert libraries.endswith(":/mine")


def test_another_ros_in_the_same_shell_is_warned_of(ros: Ros) -> None:
    command = ["bash", "-c", '. "$1"', "bash", str(ros.prefix / "setup.bash")]
    for distro, warned in (("humble", True), ("jazzy", False)):
        done = subprocess.run(command, env={**PLAIN, "ROS_DISTRO": distro}, capture_output=True, check=True)
        assert (b"humble" in done.stderr) is warned


def test_an_installed_ros_has_its_own_setup_script(tmp_path: Path) -> None:
    host = no_wheels(tmp_path)
    installed(host.installed)
    assert setup_script(pip_ros(host), {}) == host.installed / "setup.bash"


def test_that_of_a_ros_built_from_source_lies_one_folder_higher(tmp_path: Path) -> None:
    (rclpy,) = workspace(tmp_path / "install", "rclpy")
    (tmp_path / "install/setup.bash").touch()
    assert setup_script(Ros("sourced", "jazzy", rclpy, rclpy, "x"), {}) == tmp_path / "install/setup.bash"


@pytest.mark.slow
@pytest.mark.parametrize("name", ["setup", "local_setup"])
@pytest.mark.parametrize(
    ("shell", "asked"), [("bash", "complete -p ros2"), ("zsh", 'echo "${_comps[ros2]}"')]
)
def test_the_tab_key_knows_ros2_where_somebody_types(name: str, shell: str, asked: str, ros: Ros) -> None:
    script = script_for(shell, ros, name)
    assert "_ros2_complete" in said(shell, f'. "$1"; {asked}', script, "-i")
    assert "_ros2_complete" not in said(shell, f'. "$1"; {asked} || true', script)


def test_without_our_own_packages_there_is_nothing_to_complete(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("course.rosenv.setup_files.source_root", lambda: None)
    ros = pip_ros(wheels(tmp_path / "wheels"))
    prepare(ros, {"HOME": str(tmp_path)})
    assert said("bash", '. "$1"; complete -p ros2 || echo none', script_for("bash", ros), "-i") == "none\n"


def said(shell: str, script: str, path: Path, *options: str) -> str:
    """What a shell prints that runs a script, which has the path as $1.

    Its errors are not looked at: an interactive one complains that it has no terminal.
    """
    if (program := shutil.which(shell)) is None:
        pytest.skip(f"{shell} is not installed")
    quiet = {"bash": ["--norc", "--noprofile"], "zsh": ["-f"]}[shell]
    command = [program, *quiet, *options, "-c", script, shell, str(path)]
    done = subprocess.run(
        command, env={**PLAIN, "HOME": str(path.parent)}, capture_output=True, text=True, check=True
    )
    return done.stdout


LINE = "source /opt/ros/jazzy/setup.bash\n"


def test_it_names_the_file_of_the_ros_in_use() -> None:
    assert on_this_machine(f"# first\n{LINE}") == f"# first\nsource {setup_script(find_ros())}\n"


def test_other_distributions_stay_as_they_are() -> None:
    other = LINE.replace("jazzy", "humble")
    assert on_this_machine(other) == other
