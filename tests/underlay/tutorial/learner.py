"""What the tutorial has its readers do up to chapter 22: make the packages, type in the sources, build."""

from __future__ import annotations

import shutil
from pathlib import Path

from tests.underlay.tutorial.room import REPOSITORY
from tests.underlay.tutorial.terminal import Terminal

WORKSPACE = "ros2_tutorial_workspace"
_PYTHON = "--build-type ament_python"

# What follows `ros2 pkg create`, by chapter.
CREATE = {
    7: f"the_simplest_python_package {_PYTHON}",
    8: f"python_package_with_a_node {_PYTHON} --node-name sample_python_node",
    14: f"python_package_with_a_library {_PYTHON} --library-name sample_python_library",
    15: f"python_package_that_uses_the_library {_PYTHON} --node-name node_that_uses_the_library "
    "--dependencies rclpy python_package_with_a_library",
    17: "package_with_interfaces --build-type ament_cmake --dependencies geometry_msgs",
    18: f"python_package_that_uses_the_messages {_PYTHON} --node-name amazing_quote_publisher_node "
    "--dependencies rclpy package_with_interfaces",
    20: f"python_package_that_uses_the_services {_PYTHON} --node-name what_is_the_point_service_server_node "
    "--dependencies rclpy package_with_interfaces",
    22: f"python_package_that_uses_parameters_and_launch_files {_PYTHON} "
    "--node-name amazing_quote_configurable_publisher_node --dependencies rclpy package_with_interfaces",
}
# A small one with a node, for what is not in the tutorial.
LAMPS = f"lamps {_PYTHON} --node-name lamp"
_BUILDING = 300.0  # s; interfaces take a quarter of a minute on a machine that does nothing else
_TYPED = (12, 14, 15, 17, 18, 20, 22)


def work_up_to_chapter_22(terminal: Terminal, home: Path) -> None:
    create(terminal, *CREATE.values())
    for chapter in _TYPED:
        type_in(home, chapter)
    assert f"Summary: {len(CREATE)} packages finished" in terminal.run("colcon build", patience=_BUILDING)
    terminal.run(f"echo 'source ~/{WORKSPACE}/install/setup.bash' >> ~/.bashrc")


def create(terminal: Terminal, *packages: str) -> None:
    """Make packages, each with the words after `ros2 pkg create`; leaves the terminal in the workspace."""
    terminal.run(f"cd ~/{WORKSPACE}/src")
    for words in packages:
        assert f"package name: {words.split()[0]}" in terminal.run(f"ros2 pkg create {words}")
    terminal.run("cd ..")


def type_in(home: Path, chapter: int) -> None:
    """Put the sources of a chapter's reference solution in place; what the tutorial lacks is left out."""
    (source,) = (REPOSITORY / "solutions").glob(f"{chapter:02}-*/{WORKSPACE}/src")
    names = {words.split()[0] for words in CREATE.values()}
    for package in (one for one in source.iterdir() if one.name in names):
        shutil.copytree(package, home / WORKSPACE / "src" / package.name, dirs_exist_ok=True)
