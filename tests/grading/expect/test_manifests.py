"""What a package.xml should declare."""

from __future__ import annotations

import pytest

from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.recording import Recording
from course.grading.expect.manifests import expect_build_type, expect_dependency, expect_manifest
from course.model import replace
from tests.golden import golden

from .conftest import PACKAGES, record, said, told, with_manifest


def test_a_manifest_that_can_be_read() -> None:
    assert expect_manifest(with_manifest("<depend>rclpy</depend>"), "talk").values("depend") == ("rclpy",)


@pytest.mark.parametrize(
    ("recording", "package"),
    [(record(), "talk"), (record(files={"package.xml": "<package>"}), "talk"), (with_manifest(), "walk")],
)
def test_a_manifest_that_cannot_be_read(recording: Recording, package: str) -> None:
    golden(told(expect_manifest, recording, package))


@pytest.mark.parametrize("tag", ["depend", "exec_depend"])
def test_declared_dependencies(tag: str) -> None:
    recording = with_manifest(f"<{tag}>rclpy</{tag}>", "<depend>words</depend>")
    assert said(expect_dependency, recording, "talk", "rclpy", "words") is None


def test_a_dependency_that_is_not_declared() -> None:
    golden(told(expect_dependency, with_manifest("<depend>rclpy</depend>"), "talk", "rclpy", "words"))


def test_a_misspelt_dependency() -> None:
    recording = with_manifest("<depend>words</depend>", "<depend>rcl_py</depend>")
    golden(told(expect_dependency, recording, "talk", "rclpy"))


def test_a_name_that_another_wanted_one_is_like_is_no_slip() -> None:
    recording = with_manifest("<depend>rclpy_a</depend>")
    assert told(expect_dependency, recording, "talk", "rclpy_a", "rclpy_b").seen is None


@pytest.mark.parametrize("tag", ["build_depend", "test_depend", "build_export_depend"])
def test_a_dependency_that_is_not_for_running(tag: str) -> None:
    golden(told(expect_dependency, with_manifest("<!-- rclpy -->", f"<{tag}>rclpy</{tag}>"), "talk", "rclpy"))


def test_an_own_package_that_is_not_declared() -> None:
    """The order of the builds is at stake."""
    built = (*PACKAGES.built, BuiltPackage("words", "src/words", "/store/words"))
    recording = replace(with_manifest(), packages=BuiltPackages(built))
    assert "luck" in (told(expect_dependency, recording, "talk", "words").advice or "")
    assert "luck" not in (told(expect_dependency, recording, "talk", "rclpy").advice or "")


def with_build_type(name: str) -> Recording:
    return with_manifest("<export>", f"  <build_type>{name}</build_type>", "</export>")


def test_a_build_type_that_is_right() -> None:
    assert said(expect_build_type, with_build_type("ament_python"), "talk", "ament_python") is None


def test_a_build_type_that_is_not() -> None:
    golden(told(expect_build_type, with_build_type("ament_cmake"), "talk", "ament_python"))


def test_no_build_type() -> None:
    golden(told(expect_build_type, with_manifest(), "talk", "ament_python"))
