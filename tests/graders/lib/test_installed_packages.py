"""Why a Python package was not installed."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.explain.setup_py import packages_place
from course.model.feedback import Feedback
from lib.installed_packages import not_installed
from tests.golden import golden

FOLDER = "src/garden"
SETUP = "from setuptools import find_packages, setup\n\nsetup(\n    packages=['garden'],\n)\n"
RIGHT = ("garden/__init__.py", "garden/tools/__init__.py", "garden/tools/_can.py")


def sources(*files: str) -> Sources:
    return Sources({f"{FOLDER}/setup.py": SETUP, **{f"{FOLDER}/{file}": "" for file in files}})


def told(*files: str) -> Feedback:
    return not_installed(sources(*files), FOLDER, "garden.tools", "No module named 'garden.tools'")


def test_a_folder_that_setup_py_leaves_out() -> None:
    golden(told(*RIGHT))


@pytest.mark.parametrize(
    "files", [("garden/__init__.py", "garden/tools/_can.py"), ("garden/tools/__init__.py",)]
)
def test_a_folder_without_init(files: tuple[str, ...]) -> None:
    golden(told(*files))


@pytest.mark.parametrize("file", ["tools/__init__.py", "garden/toools/_can.py", "garden/shed.py"])
def test_a_folder_that_is_elsewhere(file: str) -> None:
    golden(told("garden/__init__.py", file))


def test_the_outer_folder_is_not_taken_for_the_inner_one() -> None:
    golden(not_installed(sources("shed.py"), FOLDER, "garden", "No module named 'garden'"))


def test_a_setup_py_that_says_nothing() -> None:
    bare = Sources({f"{FOLDER}/setup.py": "from setuptools import find_packages, setup\nsetup()\n"})
    assert [str(place) for place in packages_place(bare, FOLDER)] == [f"{FOLDER}/setup.py"]
