"""Submissions of many packages: each is fine by itself, but together they take what others need."""

from __future__ import annotations

import subprocess
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from course.build import BuildFailure, BuildOutcome, Store, Workspace, budget, build, outputs, package_build
from course.build.budget import SUBMISSION, Bounds
from course.isolation.bubblewrap import build_obstacle
from course.model import replace
from course.rosenv import Ros
from tests.hostile.builds.conftest import PACKAGE, python_package
from tests.processes import none_stays

pytestmark = pytest.mark.slow
MB = 1024 * 1024

SLEEP = "import time; time.sleep(100)"
# It continues in the background while CMake says that it is done.
BACKGROUND = """cmake_minimum_required(VERSION 3.8)
project(strange0 NONE)
find_package(ament_cmake REQUIRED)
foreach(number RANGE 5)
  execute_process(COMMAND sh -c "setsid sh -c 'while :; do :; done' >/dev/null 2>&1 </dev/null &")
endforeach()
execute_process(COMMAND sleep 60)
ament_package()
"""
FILLER = """
import os
os.makedirs('../install/NAME', exist_ok=True)
with open('../install/NAME/filler', 'wb') as file:
    file.write(bytes(25_000_000))
"""
# As fast as it can, ignoring errors of the disk.
FLOOD = """
while True:
    try:
        with open('flood', 'ab') as file:
            file.write(bytes(5_000_000))
    except OSError:
        pass
"""

Lay = Callable[..., Workspace]
Build = Callable[..., BuildOutcome]


@pytest.fixture
def lay(tmp_path_factory: pytest.TempPathFactory) -> Lay:
    """`lay(program, length)`: a workspace with a chain of packages strange0, strange1, ..."""

    def in_new_home(program: str, length: int = 1) -> Workspace:
        root = tmp_path_factory.mktemp("home") / "workspace"
        for number in range(length):
            name = f"strange{number}"
            needed = f"<depend>strange{number - 1}</depend>" if number else ""
            for file, text in python_package(program.replace("NAME", name)).items():
                place = (
                    root / "src" / file.replace(PACKAGE, name).replace("strange/__init__", f"{name}/__init__")
                )
                place = Path(str(place).replace("resource/strange", f"resource/{name}"))
                place.parent.mkdir(parents=True, exist_ok=True)
                text = text.replace("<export>", f"{needed}<export>").replace(">strange<", f">{name}<")
                place.write_text(text.replace("'strange'", f"'{name}'").replace("/strange", f"/{name}"))
        return Workspace.scan(root)

    return in_new_home


@pytest.fixture
def building(ros: Ros, tmp_path: Path) -> Build:
    """`building(workspace, package, bounds=..., store=...)`, contained."""
    if obstacle := build_obstacle():
        pytest.skip(f"not exercised here: one submission's builds leave others what they need ({obstacle})")

    def run(
        workspace: Workspace, package: str, bounds: Bounds, store: Path = tmp_path / "builds"
    ) -> BuildOutcome:
        return build(workspace, [package], ros, Store(store), bounds=bounds)

    return run


def failure(outcome: BuildOutcome) -> BuildFailure:
    assert outcome.failure is not None
    return outcome.failure


def test_a_chain_that_sleeps(lay: Lay, building: Build) -> None:
    """No package goes beyond 300 s."""
    outcome = building(lay(SLEEP, 30), "strange29", replace(SUBMISSION, seconds=6.0))
    assert failure(outcome).kind == "all-time-limit"
    assert outcome.seconds < 60


def test_a_chain_of_a_hundred(lay: Lay, building: Build) -> None:
    outcome = building(lay(SLEEP, 100), "strange99", SUBMISSION)
    assert failure(outcome).kind == "packages-limit"
    assert outcome.seconds < 10


def test_programs_in_the_background_count_and_end(lay: Lay, building: Build) -> None:
    workspace = lay("")
    folder = workspace.root / "src/strange0"
    (folder / "CMakeLists.txt").write_text(BACKGROUND)
    manifest = folder / "package.xml"
    manifest.write_text(manifest.read_text().replace("ament_python", "ament_cmake"))
    with none_stays():
        outcome = building(Workspace.scan(workspace.root), "strange0", replace(SUBMISSION, cpu=5.0))
        assert failure(outcome).kind == "all-cpu-limit"


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A disk of 300 MB that can really become full."""
    place = tmp_path / "disk"
    place.mkdir()
    mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=300m", "tmpfs", place], check=False)
    if mounted.returncode:
        pytest.skip(
            "not exercised here: a full disk is one submission's only (no file system can be mounted)"
        )
    try:
        (place / "builds").mkdir()
        place.chmod(0o755)
        yield place / "builds"
    finally:
        subprocess.run(["umount", place], check=True)


@pytest.mark.parametrize("program", [FILLER, FLOOD], ids=["keeps", "floods"])
def test_a_full_disk_is_nobody_elses(
    lay: Lay, building: Build, small_disk: Path, monkeypatch: pytest.MonkeyPatch, program: str
) -> None:
    """Submissions that fill the disk, and honest ones among them."""
    monkeypatch.setattr(budget, "RESERVE", 100 * MB)
    monkeypatch.setattr(budget, "ENOUGH", 20 * MB)
    monkeypatch.setattr(outputs, "LOW", 60 * MB)
    bounds = replace(SUBMISSION, disk=60 * MB)
    # One file may take what all may, as with the bounds of a submission: a flood must not outrun the watch.
    monkeypatch.setattr(package_build, "BUILD", replace(package_build.BUILD, file=60 * MB))

    def grade(number: int) -> BuildOutcome:
        honest = number % 3 == 2
        text = f"# {number}\n" if honest else f"# {number}\n{program}"
        return building(
            lay(text, 1 if honest else 4), "strange0" if honest else "strange3", bounds, small_disk
        )

    with ThreadPoolExecutor(3) as pool:
        outcomes = list(pool.map(grade, range(12)))
    for number, outcome in enumerate(outcomes):
        if number % 3 == 2:
            assert outcome.failure is None, outcome.failure
        else:
            assert failure(outcome).kind == "all-disk-limit", outcome.failure
            assert "together wrote more than 60 MB" in failure(outcome).feedback.summary
