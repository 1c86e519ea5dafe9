"""No text of a course can be read, however it was installed: as a wheel, by Gradescope, on a cluster.

The environment is a fresh one, made by the script that Gradescope runs, so these tests install from the
package index. Each submission is a right one that walks through all it sees, in its builds and its programs.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import sysconfig
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest

from course.content import open_course
from course.evidence.mcap_file import load
from course.grading import trial
from course.isolation import Level
from course.isolation.levels import obstacle_to
from course.model.events import OutputLine
from tests.batch.command import Command
from tests.hostile.secrets import REPO, secrets
from tests.hostile.world import PACKAGE, SRC, walking

pytestmark = pytest.mark.slow
EXERCISE = "18-publisher"
_OF_THE_TESTS = ("VIRTUAL_ENV", "PYTHONPATH")  # with the latter, the engine would be the clone's
LIMIT = 1200.0  # seconds for one command, downloads included
NO_APT = "#!/bin/sh\nexit 0\n"  # what it would install is here, and a test changes no system
A_PACKAGE = """
[build-system]
requires = ["hatchling>=1.24,<2"]
build-backend = "hatchling.build"

[project]
name = "another-course"
version = "1.0"

[tool.hatch.build.targets.wheel]
packages = ["another_course"]
"""
NEIGHBOR = "What the neighbor wrote down: a beaver needs no ruler to build a dam that holds the river back.\n"


@dataclass(frozen=True)
class Autograder:
    """Gradescope's situation: the unpacked bundle in `source`, and an environment made by its script."""

    root: Path

    @property
    def packages(self) -> Path:
        place = Path(sysconfig.get_path("purelib")).relative_to(sys.prefix)
        return self.root / "ros2course" / place

    @property
    def environment(self) -> Mapping[str, str]:
        """As for somebody without the environment of the tests."""
        own = str(Path(sys.prefix) / "bin")
        path = (part for part in os.environ["PATH"].split(":") if part != own)
        return {
            **{name: value for name, value in os.environ.items() if name not in _OF_THE_TESTS},
            "AUTOGRADER_ROOT": str(self.root),
            "PATH": ":".join((str(self.root / "bin"), *path)),
        }

    def run(self, *command: str | Path) -> None:
        done = subprocess.run(
            command, cwd=self.root, env=self.environment, capture_output=True, text=True, timeout=LIMIT
        )
        assert done.returncode == 0, (done.stdout + done.stderr)[-4000:]

    def known(self) -> dict[str, object]:
        """All that must not be read: of installed courses also what pip has compiled, and the archives."""
        installed = (self.packages / "course/_course", self.packages / "another_course")
        archives = (*self.root.glob("*.zip"), *(self.root / "source").glob("*.whl"))
        return secrets(*installed, more=archives)


@pytest.fixture(scope="session")
def autograder(open_place: Path) -> Autograder:
    if obstacle := obstacle_to(Level.CONTAINED):
        pytest.skip(f"not exercised here: installed courses cannot be read ({obstacle})")
    made = Autograder(open_place / "autograder")
    (made.root / "bin").mkdir(parents=True)
    (made.root / "bin/apt-get").write_text(NO_APT)
    (made.root / "bin/apt-get").chmod(0o755)
    zipped = made.root / "bundle.zip"
    bundle = [sys.executable, "-m", "course", "bundle", "--exercises", EXERCISE, "--out", zipped]
    subprocess.run(bundle, cwd=REPO, check=True, timeout=LIMIT)
    with zipfile.ZipFile(zipped) as archive:
        for entry in archive.infolist():
            Path(archive.extract(entry, made.root / "source")).chmod(entry.external_attr >> 16)
    made.run(made.root / "source/setup.sh")
    (made.root / "a course").mkdir()
    (made.root / "a course/pyproject.toml").write_text(A_PACKAGE)
    for part in ("chapters", "graders", "solutions"):
        shutil.copytree(REPO / part, made.root / "a course/another_course" / part)
    made.run(made.root / "ros2course/bin/python", "-m", "pip", "install", "--no-deps", made.root / "a course")
    return made


def hand_in(folder: Path, secret: Mapping[str, object]) -> None:
    folder.mkdir(parents=True)
    trial.lay_solution(open_course(), open_course().exercise(EXERCISE), folder)
    for name, text in walking(secret).items():
        (folder / name).write_text(text, encoding="utf-8")


def printed(out: Path, person: str) -> list[str]:
    recording = load(out / f"evidence/{person}/{EXERCISE}.mcap")
    return [event.text for event in recording.events if isinstance(event, OutputLine)]


def assert_nothing_was_found(out: Path, person: str) -> None:
    """If something was found, the build failed, or the node ended before it published."""
    graded = json.loads((out / "results.json").read_text(encoding="utf-8"))
    assert any(line.startswith("HELD walk") for line in printed(out, person)), graded
    assert '"not passed"' not in json.dumps(graded), graded


def test_gradescope(autograder: Autograder) -> None:
    hand_in(autograder.root / "submission", autograder.known())
    autograder.run(autograder.root / "source/run_autograder")
    results = json.loads((autograder.root / "results/results.json").read_text(encoding="utf-8"))
    assert results["score"] == results["extra_data"]["max_points"] > 0, results
    assert_nothing_was_found(autograder.root / "grades", "submission")


@pytest.mark.parametrize("options", [(), ("--course", "another_course")], ids=["wheel", "package"])
def test_an_installed_course(autograder: Autograder, tmp_path: Path, options: tuple[str, ...]) -> None:
    hand_in(tmp_path / "class/ada", autograder.known())
    program = autograder.root / "ros2course/bin/ros2course"
    words = (tmp_path / "class", "--exercises", EXERCISE, "--out", tmp_path / "grades")
    autograder.run(program, *options, "grade", *words)
    assert_nothing_was_found(tmp_path / "grades", "ada")


def test_a_worker_of_a_cluster(open_place: Path, tmp_path: Path) -> None:
    """Beside a neighbor, whose files are where the worker's are."""
    pytest.importorskip("distributed")
    if obstacle := obstacle_to(Level.CONTAINED):
        pytest.skip(f"not exercised here: a worker's files cannot be read ({obstacle})")
    notes = tmp_path / f"class/bao/{SRC}/{PACKAGE}/{PACKAGE}/notes.txt"
    hand_in(tmp_path / "class/bao", secrets())
    notes.write_text(NEIGHBOR, encoding="utf-8")
    hand_in(tmp_path / "class/ada", secrets(more=(notes,)))
    words = ("--cluster", "local", "--exercises", EXERCISE)
    command = Command(tmp_path / "class", tmp_path / "grades", open_place / "tmp", words)
    command.until_judged()
    for person in ("ada", "bao"):
        assert_nothing_was_found(tmp_path / "grades", person)
