"""Packages are found as colcon finds them."""

from __future__ import annotations

from pathlib import Path

from course.build import Workspace
from tests.build.conftest import WORKSPACE
from tests.build.packages import make_package


def names(home: Path) -> list[str]:
    return [package.name for package in Workspace.scan(home / WORKSPACE).packages]


def test_packages_carry_the_learners_path(home: Path) -> None:
    package = Workspace.scan(home / WORKSPACE).find("small_node")
    assert package is not None
    assert package.source == "ros2_tutorial_workspace/src/small_node"
    assert package.build_type == "ament_python"
    assert package.depends_on("rclpy")
    assert not package.depends_on("rclcpp")


def test_a_workspace_that_is_not_there_is_empty(tmp_path: Path) -> None:
    assert names(tmp_path) == []


def test_folders_of_packages_may_be_grouped(src: Path, home: Path) -> None:
    make_package(src / "group", "grouped")
    assert names(home) == ["grouped", "small_interfaces", "small_node"]


def test_packages_beside_src_are_found(home: Path) -> None:
    make_package(home / WORKSPACE, "beside")
    assert names(home) == ["beside", "small_interfaces", "small_node"]


def test_a_package_within_a_package_is_not_found(src: Path, home: Path) -> None:
    make_package(src / "small_node", "inner")
    assert "inner" not in names(home)


def test_ignored_hidden_and_built_folders_are_not_searched(src: Path, home: Path) -> None:
    for folder in ("ignored", ".hidden", "build", "install", "log"):
        make_package(src / folder, f"in_{folder.strip('.')}")
    (src / "ignored/COLCON_IGNORE").touch()
    assert names(home) == ["small_interfaces", "small_node"]


def test_links_are_followed_but_not_in_circles(src: Path, home: Path) -> None:
    make_package(home / "elsewhere", "linked")
    (src / "far").symlink_to(home / "elsewhere")
    (src / "circle").symlink_to(src)
    assert names(home) == ["linked", "small_interfaces", "small_node"]


def test_a_faulty_manifest_keeps_its_package(src: Path, home: Path) -> None:
    (src / "small_node/package.xml").write_text("<package><name>small_node</name>")
    package = Workspace.scan(home / WORKSPACE).find("small_node")
    assert package is not None
    assert package.fault is not None
    assert package.dependencies == ()


def test_the_same_name_twice_is_no_find(src: Path, home: Path) -> None:
    make_package(src / "copy", "small_node")
    workspace = Workspace.scan(home / WORKSPACE)
    assert workspace.find("small_node") is None
    assert len(workspace.named("small_node")) == 2
