"""Packages whose builds are hostile: each is built in a separate world, which must not change."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest

from course.build import BuildFailure, BuildOutcome, Store, Workspace, build
from course.isolation.bubblewrap import build_obstacle
from course.rosenv import Ros, find_ros, prepare
from tests.hostile import world
from tests.hostile.world import SRC, World, lay_world

NAME = "strange"
PACKAGE = f"{SRC}/{NAME}"
_MANIFEST = """<package format="3"><name>strange</name><version>0.0.0</version><description>d</description>
<maintainer email="a@example.com">a</maintainer><license>MIT</license>
<export><build_type>{}</build_type></export></package>
"""
_SETUP = """
from setuptools import setup
setup(name='strange', version='0.0.0', packages=['strange'], data_files=[
    ('share/ament_index/resource_index/packages', ['resource/strange']),
    ('share/strange', ['package.xml', *globals().get('MORE', [])]),
])
"""
# colcon reads what a setup.py prints, and lines of attempts are not a valid answer.
_ASIDE = "import sys\n_out, sys.stdout = sys.stdout, sys.stderr\n{}\nsys.stdout = _out\n"
_CMAKE = """cmake_minimum_required(VERSION 3.8)
project(strange NONE)
find_package(ament_cmake REQUIRED)
execute_process(COMMAND python3 "${CMAKE_CURRENT_SOURCE_DIR}/attack.py" RESULT_VARIABLE code)
if(code)
  message(FATAL_ERROR "the attack ended with ${code}")
endif()
ament_package()
"""


@dataclass(frozen=True)
class Built:
    """The result of one build. log: its output. install: where it should install."""

    outcome: BuildOutcome
    log: str
    entry: Path
    world: World

    @property
    def install(self) -> Path:
        return self.entry / "install" / NAME

    @property
    def failure(self) -> BuildFailure:
        assert self.outcome.failure is not None, self.log[-2000:]
        return self.outcome.failure

    @property
    def words(self) -> str:
        """Everything that the learner reads."""
        told = self.failure.feedback
        return "\n".join(
            (told.summary, told.seen or "", told.advice or "", *map(str, told.where), *told.details)
        )

    @property
    def breaches(self) -> list[str]:
        return re.findall("^BREACH.*", self.log, re.MULTILINE)

    @property
    def held(self) -> set[str]:
        return set(re.findall("^HELD (.*?):", self.log, re.MULTILINE))


BuildIt = Callable[..., Built]
Package = Callable[[str], dict[str, str]]


def attack(name: str, **values: object) -> str:
    """The attack programs/NAME.py; values: its constants."""
    program = world.PROGRAMS / f"{name}.py"
    settings = "".join(f"{key} = {value!r}\n" for key, value in values.items())
    attempts = (world.PROGRAMS / "attempts.py").read_text(encoding="utf-8")
    return f"{attempts}\n{settings}\n{program.read_text(encoding='utf-8')}\n"


def python_package(program: str) -> dict[str, str]:
    """Files of a package whose setup.py runs the program, and then works correctly."""
    texts = {
        "package.xml": _MANIFEST.format("ament_python"),
        "setup.py": _ASIDE.format(program) + _SETUP,
        "setup.cfg": "[install]\ninstall_scripts=$base/lib/strange\n",
        "resource/strange": "",
        "strange/__init__.py": "",
    }
    return {f"{PACKAGE}/{file}": text for file, text in texts.items()}


def cmake_package(program: str) -> dict[str, str]:
    """Files of a package whose CMakeLists.txt runs the program, and then works correctly."""
    texts = {"package.xml": _MANIFEST.format("ament_cmake"), "CMakeLists.txt": _CMAKE, "attack.py": program}
    return {f"{PACKAGE}/{file}": text for file, text in texts.items()}


@pytest.fixture(scope="session")
def ros() -> Ros:
    found = find_ros()
    prepare(found)
    return found


@pytest.fixture
def own_store(tmp_path: Path) -> Path:
    """For one test, with somebody else's finished build in it."""
    other = tmp_path / "builds" / ("f" * 32)
    (other / "install").mkdir(parents=True)
    for name in ("complete", "install/program"):
        (other / name).write_text(world.SECRET, encoding="utf-8")
    (tmp_path / "builds" / f"{other.name}.lock").touch()
    world.open_to_all(tmp_path / "builds")
    return tmp_path / "builds"


@pytest.fixture
def build_it(
    open_place: Path, course_copy: Path, own_store: Path, ros: Ros, worlds: list[World], untouched: None
) -> BuildIt:
    """`build_it(files, guarantee="...")` builds the package `strange` of these files; see `Built`."""

    def in_new_world(
        files: Mapping[str, str | bytes],
        *,
        guarantee: str,
        time_limit: float = 60.0,
        prepare: Callable[[World], None] = lambda world: None,
    ) -> Built:
        if obstacle := build_obstacle():
            pytest.skip(f"not exercised here: {guarantee} ({obstacle})")
        folder = Path(tempfile.mkdtemp(dir=open_place))
        here = lay_world(folder, course_copy, own_store, "01-files", files)
        worlds.append(here)
        prepare(here)
        here.look()
        before = set(own_store.iterdir())
        workspace = Workspace.scan(here.home / "ros2_tutorial_workspace", here.home)
        outcome = build(workspace, [NAME], ros, Store(own_store), time_limit=time_limit)
        here.prove()
        made = next((path for path in set(own_store.iterdir()) - before if path.is_dir()), own_store / "none")
        log = made / "log/build.log"
        text = log.read_text(encoding="utf-8", errors="replace") if log.exists() else ""
        return Built(outcome, text, made, here)

    return in_new_world
