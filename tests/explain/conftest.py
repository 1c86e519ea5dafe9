"""A package of faulty programs, and what they really printed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

from course.build import Workspace
from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.process_view import ProcessView
from course.evidence.sources import Sources
from course.explain.builds import Build, read_copy
from course.explain.python_errors import Crash, crash, crash_feedback
from course.model.events import OutputLine
from course.model.feedback import Feedback

# The course home with two small packages to break.
from tests.build.conftest import WORKSPACE, home, src  # noqa: F401

TEXTS = Path(__file__).with_name("crashes")
# A module that another one imports, programs that end properly, and one that does not need ROS.
CRASHES = sorted({file.stem for file in TEXTS.iterdir()} - {"circular_other", "ended", "interrupt", "group"})
TERMINAL = "===== on the terminal =====\n"
FOLDER = "ros2_tutorial_workspace/src/faulty"
PREFIX = "/store/faulty"
PACKAGES = BuiltPackages((BuiltPackage("faulty", FOLDER, PREFIX),))

# All others are `name = faulty.name:main`.
ENTRIES = {
    "module_only": "faulty.helper",
    "wrong_function": "faulty.ended:mian",
    "wrong_module": "faulty.endde:main",
    "lost_module": "faulty.lost:main",
}
SHARED = ("helper", "ended")
MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>faulty</name><version>0.1.0</version><description>Faults</description>
  <maintainer email="keeper@example.com">Keeper</maintainer><license>MIT</license>
  <depend>rclpy</depend>
  <depend>std_msgs</depend>
  <export><build_type>ament_python</build_type></export>
</package>
"""
SETUP_CFG = "[develop]\nscript_dir=$base/lib/faulty\n[install]\ninstall_scripts=$base/lib/faulty\n"


@dataclass(frozen=True)
class Case:
    """A program and what it wrote before it ended."""

    name: str
    program: str
    output: str

    @classmethod
    def named(cls, name: str) -> Case:
        program, _, output = (TEXTS / f"{name}.txt").read_text().partition(TERMINAL)
        return cls(name, program, output)


def package(*cases: Case) -> dict[str, str]:
    """Files of the package `faulty` with these programs, by their names in it."""
    entries = "".join(
        f"        '{case.name} = {ENTRIES.get(case.name, f'faulty.{case.name}:main')}',\n" for case in cases
    )
    files = {
        "package.xml": MANIFEST,
        "setup.cfg": SETUP_CFG,
        "setup.py": "from setuptools import setup\n\nsetup(\n    name='faulty',\n    version='0.1.0',\n"
        "    packages=['faulty'],\n    data_files=[\n"
        "        ('share/ament_index/resource_index/packages', ['resource/faulty']),\n"
        "        ('share/faulty', ['package.xml']),\n    ],\n"
        f"    entry_points={{'console_scripts': [\n{entries}    ]}},\n)\n",
        "resource/faulty": "",
        "lost.py": "def main():\n    pass\n",
        "faulty/__init__.py": "",
    }
    programs = {**{name: Case.named(name) for name in SHARED}, **{case.name: case for case in cases}}
    return {**files, **{f"faulty/{name}.py": case.program for name, case in programs.items() if case.program}}


def sources_of(case: Case) -> Sources:
    return Sources({f"{FOLDER}/{name}": text for name, text in sorted(package(case).items())})


def crash_of(case: Case, output: str | None = None) -> Crash | None:
    lines = (case.output if output is None else output).splitlines()
    view = ProcessView.of("it", tuple(OutputLine(1.0, "it", line) for line in lines))
    return crash(view.traceback(), PACKAGES, sources_of(case))


def explained(case: Case, output: str | None = None) -> Feedback | None:
    """What a learner is told about a program that printed this."""
    found = crash_of(case, output)
    return crash_feedback(found, PACKAGES, sources_of(case)) if found else None


@pytest.fixture
def case(home: Path, tmp_path: Path) -> Callable[..., Build]:  # noqa: F811
    """A build of a package that printed `log`, and whose setup.py, run alone, prints `said`."""
    made_up_ros(tmp_path / "ros")

    def make(name: str, log: str, said: Sequence[str] = ()) -> Build:
        workspace = Workspace.scan(home / WORKSPACE)
        package = workspace.find(name)
        assert package is not None
        return Build(
            sources=read_copy(package.folder, package.source),
            folder=package.source,
            name=name,
            build_type=package.build_type,
            manifest=package.manifest,
            copy=package.folder,
            lines=tuple(log.splitlines()),
            neighbors={one.name: one.source for one in workspace.packages if one.name != name},
            prefixes=(tmp_path / "ros",),
            ask_setup_py=lambda: tuple(said),
        )

    return make


def made_up_ros(prefix: Path) -> None:
    index = prefix / "share/ament_index/resource_index/packages"
    index.mkdir(parents=True)
    for package in ("geometry_msgs", "rclcpp", "std_msgs"):
        (index / package).touch()
        (prefix / "share" / package / "msg").mkdir(parents=True)
    (prefix / "share/geometry_msgs/msg/Point.msg").touch()
