"""Why there is nothing to run."""

from __future__ import annotations

from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.sources import Sources
from course.explain.executables import no_executable
from course.model.events import ExecutableMissing
from course.model.feedback import Feedback
from tests.golden import golden

FOLDER = "src/talk"
PACKAGES = BuiltPackages((BuiltPackage("talk", FOLDER, "/store/talk"),))


def said(entries: str, *available: str, wanted: str = "talker_node") -> Feedback:
    text = f"setup(\n    entry_points={{'console_scripts': [\n{entries}\n    ]}},\n)\n"
    missing = ExecutableMissing(1.0, wanted, "talk", wanted, available)
    return no_executable(missing, PACKAGES, Sources({f"{FOLDER}/setup.py": text}))


def test_a_package_that_was_not_built() -> None:
    missing = ExecutableMissing(1.0, "it", "walk", "walker", ())
    assert "`walk` was not built" in no_executable(missing, PACKAGES, Sources()).summary


def test_a_missing_comma() -> None:
    golden(said("'old = talk.old:main'\n'talker_node = talk.talker_node:main',", "old"))


def test_a_misspelt_name() -> None:
    golden(said("'old = talk.old:main',\n'taker_node = talk.talker_node:main',", "old", "taker_node"))


def test_a_name_that_is_not_declared() -> None:
    golden(said("'old = talk.old:main',", "old"))


def test_nothing_declared_at_all() -> None:
    golden(said(""))


def test_declared_but_installed_elsewhere() -> None:
    """Without setup.cfg it goes to bin/, where `ros2 run` does not look."""
    golden(said("'old = talk.old:main',\n'talker_node = talk.talker_node:main',"))
