"""Why there is nothing to run."""

from __future__ import annotations

from course.evidence.events import ExecutableMissing
from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.sources import Sources
from course.feedback import Feedback
from course.grading.explain.executables import no_executable

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
    found = said("'old = talk.old:main'\n'talker_node = talk.talker_node:main',", "old")
    assert "comma" in found.summary
    assert found.seen == "old = talk.old:maintalker_node = talk.talker_node:main"
    assert [str(place) for place in found.where] == [f"{FOLDER}/setup.py:3"]


def test_a_misspelt_name() -> None:
    found = said("'old = talk.old:main',\n'taker_node = talk.talker_node:main',", "old", "taker_node")
    assert (found.expected, found.seen) == ("talker_node", "taker_node")
    assert [str(place) for place in found.where] == [f"{FOLDER}/setup.py:4"]


def test_a_name_that_is_not_declared() -> None:
    found = said("'old = talk.old:main',", "old")
    assert found.summary == "No executable found: `talk` installs no `talker_node`."
    assert found.seen == "installed: `old`"
    assert "`'talker_node = talk.<module>:main',`" in str(found.advice)
    assert [str(place) for place in found.where] == [f"{FOLDER}/setup.py:3"]


def test_nothing_declared_at_all() -> None:
    found = said("")
    assert found.seen == "installed: none"
    assert [str(place) for place in found.where] == [f"{FOLDER}/setup.py"]


def test_declared_but_installed_elsewhere() -> None:
    """Without setup.cfg it lands in bin/, where `ros2 run` does not look."""
    found = said("'old = talk.old:main',\n'talker_node = talk.talker_node:main',")
    assert "setup.cfg" in str(found.advice)
    assert "install_scripts=$base/lib/talk" in str(found.advice)
    assert [str(place) for place in found.where] == [f"{FOLDER}/setup.py:4"]
