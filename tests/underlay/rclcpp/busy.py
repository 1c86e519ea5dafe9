"""The busy node and rclcpp, compiled together for one of the compiler's sanitizers."""

from __future__ import annotations

import shutil
from pathlib import Path

from course.build.builder import build
from course.build.store import Store
from course.build.workspace import Workspace
from course.rosenv import find_ros
from tests.underlay.rclcpp.room import SOURCES, TIME_LIMIT

SANITIZERS = {"address": "address,undefined", "thread": "thread"}
_PROJECT = Path(__file__).with_name("sanitized")
_MANIFEST = """<package format="3">
  <name>{package}</name>
  <version>0.0.0</version>
  <description>rclcpp and a busy node, compiled for a sanitizer.</description>
  <maintainer email="authors@ros2course.invalid">ros2course authors</maintainer>
  <license>MIT</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <export><build_type>cmake</build_type></export>
</package>
"""


def busy(sanitizer: str, folder: Path, store: Store) -> Path:
    """The program. What was compiled of the same sources before is not compiled again."""
    package = f"rclcpp_{sanitizer}"
    sources = folder / "src" / package
    shutil.copytree(_PROJECT, sources)
    for underlay in (SOURCES, SOURCES.with_name("rclcpp_action")):
        shutil.copytree(underlay, sources / underlay.name)
    (sources / "package.xml").write_text(_MANIFEST.format(package=package))
    chosen = f"set(PACKAGE {package})\nset(SANITIZE {SANITIZERS[sanitizer]})\n"
    (sources / "sanitizer.cmake").write_text(chosen)
    ros = find_ros()
    outcome = build(Workspace.scan(folder), [package], ros, store, time_limit=TIME_LIMIT)
    assert outcome.failure is None, outcome.failure
    return outcome.packages[-1].prefix / "lib" / package / "busy"
