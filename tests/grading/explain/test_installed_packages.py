"""Why a Python package was not installed."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.feedback import Feedback
from course.grading.explain.installed_packages import not_installed, packages_place

FOLDER = "src/garden"
SETUP = "from setuptools import find_packages, setup\n\nsetup(\n    packages=['garden'],\n)\n"
RIGHT = ("garden/__init__.py", "garden/tools/__init__.py", "garden/tools/_can.py")


def sources(*files: str) -> Sources:
    return Sources({f"{FOLDER}/setup.py": SETUP, **{f"{FOLDER}/{file}": "" for file in files}})


def told(*files: str) -> Feedback:
    return not_installed(sources(*files), FOLDER, "garden.tools", "No module named 'garden.tools'")


def test_a_folder_that_setup_py_leaves_out() -> None:
    found = told(*RIGHT)
    assert "tools is not installed" in found.summary
    assert [str(place) for place in found.where] == [f"{FOLDER}/setup.py:4"]
    assert found.seen == "No module named 'garden.tools'"


@pytest.mark.parametrize(
    ("files", "missing"),
    [
        (("garden/__init__.py", "garden/tools/_can.py"), "garden/tools/__init__.py"),
        (("garden/tools/__init__.py",), "garden/__init__.py"),
    ],
)
def test_a_folder_without_init(files: tuple[str, ...], missing: str) -> None:
    found = told(*files)
    assert found.summary.startswith(f"{missing} is missing")
    assert f"`touch {missing}`" in (found.advice or "")


@pytest.mark.parametrize(
    ("file", "summary", "where"),
    [
        ("tools/__init__.py", "The folder tools lies in the wrong place.", [f"{FOLDER}/tools"]),
        (
            "garden/toools/_can.py",
            "There is no folder tools; there is `toools`.",
            [f"{FOLDER}/garden/toools"],
        ),
        ("garden/shed.py", "The package has no folder garden/tools with an `__init__.py` in it.", []),
    ],
)
def test_a_folder_that_is_elsewhere(file: str, summary: str, where: list[str]) -> None:
    found = told("garden/__init__.py", file)
    assert found.summary == summary
    assert [str(place) for place in found.where] == where


def test_the_outer_folder_is_not_taken_for_the_inner_one() -> None:
    found = not_installed(sources("shed.py"), FOLDER, "garden", "No module named 'garden'")
    assert found.summary == "The package has no folder garden with an `__init__.py` in it."


def test_a_setup_py_that_says_nothing() -> None:
    bare = Sources({f"{FOLDER}/setup.py": "from setuptools import find_packages, setup\nsetup()\n"})
    assert [str(place) for place in packages_place(bare, FOLDER)] == [f"{FOLDER}/setup.py"]
