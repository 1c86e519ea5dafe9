"""The order of a build, and the errors of a workspace that prevent any order."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from course.build import BuildFailure, Workspace
from course.build.builder import Unbuildable, build_order
from tests.build.conftest import WORKSPACE
from tests.build.packages import edit, make_package


def order(home: Path, *names: str) -> dict[str, tuple[str, ...]]:
    steps = build_order(Workspace.scan(home / WORKSPACE), names)
    return {step.package.name: step.after for step in steps}


def refusal(home: Path, name: str) -> BuildFailure:
    with pytest.raises(Unbuildable) as caught:
        build_order(Workspace.scan(home / WORKSPACE), [name])
    return caught.value.failure


def where(failure: BuildFailure) -> list[str]:
    return [str(place) for place in failure.feedback.where]


def test_dependencies_come_first_and_once(home: Path, src: Path) -> None:
    make_package(src, "top", "left", "right", "rclpy")
    make_package(src, "left", "bottom")
    make_package(src, "right", "bottom")
    make_package(src, "bottom")
    found = order(home, "top", "left")
    assert list(found) == ["bottom", "left", "right", "top"]
    assert set(found["top"]) == {"bottom", "left", "right"}
    assert found["left"] == ("bottom",)


def test_what_is_not_needed_is_not_built(home: Path) -> None:
    assert list(order(home, "small_node")) == ["small_node"]


def test_a_missing_package_names_its_look_alike(home: Path) -> None:
    failure = refusal(home, "small_nodes")
    assert failure.kind == "package-missing"
    assert failure.feedback.summary == "There is no package `small_nodes` in ros2_tutorial_workspace/src."
    assert "`small_node`" in str(failure.feedback.advice)
    assert where(failure) == ["ros2_tutorial_workspace/src/small_node/package.xml:3"]
    assert "ros2_tutorial_workspace/src/small_node: small_node" in failure.feedback.details


def test_nothing_alike_means_make_one(home: Path) -> None:
    advice = refusal(home, "quite_another").feedback.advice
    assert advice == "Create it with `ros2 pkg create`, in the folder ros2_tutorial_workspace/src."


@pytest.mark.parametrize("place", ["", "Documents"])
def test_a_package_outside_the_workspace_is_found(home: Path, src: Path, place: str) -> None:
    (home / place).mkdir(exist_ok=True)
    shutil.move(src / "small_node", home / place / "small_node")
    failure = refusal(home, "small_node")
    shown = f"{place}/small_node" if place else "small_node"
    assert failure.feedback.advice == f"It is in {shown}: move it to ros2_tutorial_workspace/src/small_node."
    assert where(failure) == [shown]


@pytest.mark.parametrize("marker", ["AMENT_IGNORE", "small_node/COLCON_IGNORE"])
def test_a_package_that_colcon_ignores_is_told_by_its_marker(home: Path, src: Path, marker: str) -> None:
    (src / marker).touch()
    failure = refusal(home, "small_node")
    shown = f"ros2_tutorial_workspace/src/{marker}"
    place = "ros2_tutorial_workspace/src/small_node"
    assert failure.feedback.advice == f"`colcon build` ignores {place} because of {shown}: delete that file."
    assert where(failure) == [shown]


def test_a_package_inside_another_is_found(home: Path, src: Path) -> None:
    shutil.move(src / "small_node", src / "small_interfaces/small_node")
    advice = str(refusal(home, "small_node").feedback.advice)
    assert "inside the package `small_interfaces`" in advice


def test_a_folder_without_package_xml_is_named(home: Path, src: Path) -> None:
    (src / "small_node/package.xml").unlink()
    failure = refusal(home, "small_node")
    assert "ros2_tutorial_workspace/src/small_node has no package.xml" in str(failure.feedback.advice)


def test_a_folder_that_calls_itself_otherwise_is_named(home: Path, src: Path) -> None:
    edit(src / "small_node/package.xml", "small_node</name>", "my_first</name>")
    failure = refusal(home, "small_node")
    assert "calls itself `my_first`" in str(failure.feedback.advice)
    assert where(failure) == ["ros2_tutorial_workspace/src/small_node/package.xml:3"]


def test_a_copy_kept_in_src_is_named(home: Path, src: Path) -> None:
    shutil.copytree(src / "small_node", src / "small_node_old")
    failure = refusal(home, "small_node")
    assert failure.kind == "package-twice"
    assert where(failure) == [
        "ros2_tutorial_workspace/src/small_node/package.xml:3",
        "ros2_tutorial_workspace/src/small_node_old/package.xml:3",
    ]


def test_a_circle_is_shown(home: Path, src: Path) -> None:
    make_package(src, "a", "b")
    make_package(src, "b", "c")
    make_package(src, "c", "b")
    failure = refusal(home, "a")
    assert failure.kind == "package-circle"
    assert failure.feedback.summary == "`b` needs `c` needs `b`."


def test_a_malformed_package_xml_is_refused(home: Path, src: Path) -> None:
    edit(src / "small_node/package.xml", "</license>", "</lisence>")
    failure = refusal(home, "small_node")
    assert failure.kind == "package-xml"
    assert failure.feedback.summary == (
        "package.xml of `small_node` is not right: the <license> on line 7 is never closed."
    )
    assert where(failure) == ["ros2_tutorial_workspace/src/small_node/package.xml:7"]
    assert failure.feedback.details == ("<license>MIT</lisence>",)


def test_a_faulty_dependency_is_blamed_itself(home: Path, src: Path) -> None:
    edit(src / "small_interfaces/package.xml", "</name>", "")
    make_package(src, "user", "small_interfaces")
    assert refusal(home, "user").package == "small_interfaces"
