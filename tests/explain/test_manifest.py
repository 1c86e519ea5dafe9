"""package.xml: what is read from it, and the errors about a wrong one."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.explain.package_xml import (
    Dependency,
    Manifest,
    ManifestFault,
    guessed_name,
    read_manifest,
    strict_fault,
)
from tests.build.conftest import HOME, SRC
from tests.golden import golden

GOOD = (HOME / SRC / "small_interfaces/package.xml").read_text()


def read(text: str) -> Manifest:
    found = read_manifest(text.encode())
    assert isinstance(found, Manifest), found
    return found


def fault(text: str) -> ManifestFault:
    found = read_manifest(text.encode())
    assert isinstance(found, ManifestFault), found
    return found


def test_it_reads_what_the_build_needs_to_know() -> None:
    manifest = read(GOOD)
    assert (manifest.name, manifest.build_type) == ("small_interfaces", "ament_cmake")
    assert manifest.dependencies[2] == Dependency("geometry_msgs", "depend", 11)
    assert manifest.groups == ("rosidl_interface_packages",)
    assert manifest.lines["license"] == 7


def test_test_dependencies_are_no_dependencies() -> None:
    text = GOOD.replace("</package>", "<test_depend>ament_copyright</test_depend></package>")
    assert "ament_copyright" not in {dependency.name for dependency in read(text).dependencies}


@pytest.mark.parametrize(("condition", "holds"), [("$ROS_VERSION == 2", True), ("$ROS_VERSION == 1", False)])
def test_conditions_count(condition: str, holds: bool) -> None:
    text = GOOD.replace("<depend>", f'<depend condition="{condition}">')
    assert ("geometry_msgs" in {dependency.name for dependency in read(text).dependencies}) is holds


@pytest.mark.parametrize(
    ("old", "new", "what", "line"),
    [
        ("</license>", "</lisence>", "the <license> on line 7 is never closed", 7),
        ("</package>", "", "the <package> on line 2 is never closed", 2),
        ("<name>small_interfaces</name>", "", "it has no <name>", None),
        ("<name>small_interfaces</name>", "<name></name>", "its <name> is empty", 3),
        ("<version>", "<name>other</name><version>", "it has more than one <name>", 3),
        ('version="1.0"', 'version=1.0"', "line 1 is not valid XML", 1),
    ],
)
def test_what_cannot_be_read_is_explained(old: str, new: str, what: str, line: int | None) -> None:
    found = fault(GOOD.replace(old, new, 1))
    assert found.what.startswith(what)
    assert found.line == line


def test_an_empty_file_is_called_empty() -> None:
    assert fault("").what == "it is empty"


def test_a_name_is_guessed_from_what_cannot_be_parsed() -> None:
    assert guessed_name(GOOD.replace("</license>", "").encode()) == "small_interfaces"
    assert guessed_name(b"nothing") is None


@pytest.mark.parametrize(
    ("old", "new", "what", "line"),
    [
        ("<license>MIT</license>", "", "it has no <license>", 2),
        ('<maintainer email="someone@example.com">Someone</maintainer>', "", "it has no <maintainer>", 2),
        ("<description>", "<description>x</description><description>", "exactly one <description>", 5),
        ("<depend>geometry_msgs</depend>", "<depends>geometry_msgs</depends>", "no tag called <depends>", 11),
        ("0.1.0", "1", "version", 4),
        ("<depend>geometry_msgs", "<depend>small_interfaces", "must not", 3),
        ('format="3"', 'format="9"', "its format does not exist", 2),
        ('format="3"', 'format="x"', "its format does not exist", 2),
    ],
)
def test_what_colcon_objects_to_is_put_in_words(
    tmp_path: Path, old: str, new: str, what: str, line: int
) -> None:
    file = tmp_path / "package.xml"
    assert old in GOOD
    file.write_text(GOOD.replace(old, new))
    found = strict_fault(file)
    assert found is not None
    assert what in found.what
    assert found.line == line


def test_a_misspelt_tag_is_recognised(tmp_path: Path) -> None:
    file = tmp_path / "package.xml"
    file.write_text(GOOD.replace("exec_depend", "exec_depends"))
    golden(strict_fault(file))


def test_a_right_file_has_no_fault(tmp_path: Path) -> None:
    file = tmp_path / "package.xml"
    file.write_text(GOOD)
    assert strict_fault(file) is None
