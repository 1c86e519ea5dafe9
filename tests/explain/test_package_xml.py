"""What a package.xml declares."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.explain.package_xml import RUN_TAGS, Manifest, manifest
from course.model.feedback import Location

TEXT = """\
<?xml version="1.0"?>
<package format="3">
  <name>rclpy_talk</name>
  <description>Uses rclpy and more</description>
  <!-- <depend>rcl</depend> -->
  <depend>rclpy</depend>
  <exec_depend> std_msgs </exec_depend>
  <build_depend condition="$ROS_VERSION == 2">geometry_msgs</build_depend>
  <test_depend/>
  <export>
    <build_type>ament_python</build_type>
  </export>
</package>
"""


def read(text: str) -> Manifest | None:
    return manifest(Sources({"src/talk/package.xml": text}), "src/talk")


@pytest.fixture
def found() -> Manifest:
    found = read(TEXT)
    assert found is not None
    return found


def test_tags_and_values(found: Manifest) -> None:
    assert found.values(*RUN_TAGS) == ("rclpy", "std_msgs")
    assert found.values("test_depend") == ("",)
    assert found.depends("std_msgs", *RUN_TAGS)
    assert not found.depends("geometry_msgs", *RUN_TAGS)
    assert found.depends("geometry_msgs", "build_depend")
    assert not found.depends("rcl", *RUN_TAGS)


@pytest.mark.parametrize(
    ("text", "line"), [("rclpy", 6), ("std_msgs", 7), ("<depend>", 5), ("geometry_msgs", 8), ("lost", None)]
)
def test_places(found: Manifest, text: str, line: int | None) -> None:
    assert found.place_of(text) == (Location("src/talk/package.xml", line) if line else None)


def test_no_file() -> None:
    assert manifest(Sources(), "src/talk") is None


ENTITIES = "".join(f'<!ENTITY e{n} "{f"&e{n - 1};" * 10 if n else "x" * 100}">' for n in range(9))


@pytest.mark.parametrize(
    "text",
    [
        "",
        "<package>",
        "<package></pakage>",
        "text",
        "<a>\x00</a>",
        f"<!DOCTYPE p [{ENTITIES}]><p>&e8;</p>",
        "<a>\udc80</a>",
    ],
    ids=["empty", "open", "crossed", "no tag", "null", "billion laughs", "surrogate"],
)
def test_what_is_no_xml(text: str) -> None:
    assert read(text) is None


@pytest.mark.parametrize("encoding", ["utf-8", "latin-1", "utf-16", "big5", "nonsense"])
def test_the_declared_encoding_does_not_matter(encoding: str) -> None:
    """The file was read as UTF-8, as all are."""
    found = read(f'<?xml version="1.0" encoding="{encoding}"?><package><name>häufig</name></package>')
    assert found is not None
    assert found.values("name") == ("häufig",)


def test_format_and_build_type(found: Manifest) -> None:
    assert (found.format, found.build_type) == ("3", "ament_python")


def test_without_format_and_build_type() -> None:
    found = read("<package><name>old</name><build_type>not here</build_type></package>")
    assert found is not None
    assert (found.format, found.build_type) == ("1", None)
