"""What is wrong with a launch file."""

from __future__ import annotations

import pytest

from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.sources import Sources
from course.grading.explain.launch_files import launch_file_cause, not_installed
from course.grading.explain.timers import Cause

FOLDER = "src/talk"
NAME = "quote_launch.py"
FILE = f"{FOLDER}/launch/{NAME}"
PACKAGES = BuiltPackages((BuiltPackage("talk", FOLDER, "/store/talk", ("talker", "quote_publisher_node")),))
RIGHT = (
    "def generate_launch_description():\n    return LaunchDescription([Node(\n"
    "        package='talk', executable='talker', parameters=[{'a': 1}])])\n"
)


def sources(data_files: str = "", **files: str) -> Sources:
    named = {name.replace("__", "/"): text for name, text in (files or {FILE: RIGHT}).items()}
    return Sources({f"{FOLDER}/setup.py": f"setup(\n    data_files=[{data_files}],\n)\n", **named})


def cause(text: str) -> Cause | None:
    return launch_file_cause(Sources({FILE: text}), PACKAGES, NAME)


# installing


def test_a_launch_file_that_setup_py_does_not_name() -> None:
    found = not_installed(sources(), FOLDER, NAME)
    assert "`data_files` in setup.py does not name it" in found.summary
    assert "`" in str(found.advice) and "glob('launch/*launch.py')" in str(found.advice)
    assert [str(place) for place in found.where] == [f"{FOLDER}/setup.py:2"]


@pytest.mark.parametrize(
    "given",
    [
        "glob('launch/*.launch.py')",
        "glob(os.path.join('launch', '*.launch.py'))",
        "['launch/qoute_launch.py']",
    ],
)
def test_a_pattern_that_does_not_match(given: str) -> None:
    found = not_installed(sources(f"('share/' + package_name, {given})"), FOLDER, NAME)
    assert "does not match it" in found.summary
    assert "launch/*launch.py" in str(found.expected)
    assert [str(place) for place in found.where] == [f"{FOLDER}/setup.py:2"]


def test_a_pattern_that_matches_and_a_wrong_folder() -> None:
    found = not_installed(sources("('shared/talk', glob('launch/*launch.py'))"), FOLDER, NAME)
    assert "not installed where ROS looks for it" in found.summary
    assert "'share/' + package_name + '/launch'" in str(found.advice)


def test_a_launch_file_beside_setup_py() -> None:
    beside = sources("('share/talk', glob('launch/*launch.py'))", **{f"{FOLDER}/{NAME}": RIGHT})
    found = not_installed(beside, FOLDER, NAME)
    assert "does not match it" in found.summary
    assert "Move the file into the folder `launch`" in str(found.advice)
    assert [str(place) for place in found.where] == [f"{FOLDER}/{NAME}", f"{FOLDER}/setup.py:2"]


@pytest.mark.parametrize(
    ("there", "words"),
    [
        (f"{FOLDER}/launch/qoute_launch.py", "it has `qoute_launch.py`"),
        (f"{FOLDER}/launch/quote_lunch.py", "ends in `launch.py`"),
        (f"{FOLDER}/launch/start.py", "ends in `launch.py`"),
    ],
)
def test_a_launch_file_of_another_name(there: str, words: str) -> None:
    found = not_installed(sources(**{there: ""}), FOLDER, NAME)
    assert words in f"{found.summary} {found.advice}"
    assert [str(place) for place in found.where] == [there]


def test_no_launch_file() -> None:
    found = not_installed(sources(**{f"{FOLDER}/talk/talker.py": ""}), FOLDER, NAME)
    assert found.summary == f"The package has no launch file `{NAME}`."
    assert f"{FOLDER}/launch/{NAME}" in str(found.advice)


# inside


def test_a_launch_file_that_is_right() -> None:
    assert cause(RIGHT) is None


@pytest.mark.parametrize(
    ("old", "new", "words", "line"),
    [
        ("generate_launch", "generate_lanuch", "has `generate_lanuch_description` in its place", 1),
        ("generate_launch_description", "start", "has none of that name", None),
        ("return LaunchDescription", "LaunchDescription", "returns nothing", 1),
        ("[{'a': 1}]", "{'a': 1}", "`parameters` takes a list of dicts", 3),
        ("'talker'", "'tlaker'", "it has `talker`", 2),
        ("'talker'", "'x'", "it has `talker` and `quote_publisher_node`", 2),
    ],
)
def test_faults(old: str, new: str, words: str, line: int | None) -> None:
    found = cause(RIGHT.replace(old, new))
    assert found is not None
    assert words in found.text
    assert [(place.file, place.line) for place in found.where] == [(FILE, line)]


def test_a_misspelt_package() -> None:
    packages = BuiltPackages((BuiltPackage("quotes_by_talkers", FOLDER, "/store", ("talker",)),))
    text = RIGHT.replace("'talk'", "'quotes_by_tlakers'")
    found = launch_file_cause(Sources({FILE: text}), packages, NAME)
    assert found is not None
    assert "it is called `quotes_by_talkers`" in found.text


def test_packages_of_ros_itself_are_left_alone() -> None:
    assert cause(RIGHT.replace("'talk'", "'demo_nodes_py'")) is None


@pytest.mark.parametrize("text", ["def (", ""])
def test_what_cannot_be_read(text: str) -> None:
    found = cause(text)
    assert found is None or "has none of that name" in found.text


def test_a_package_that_cmake_builds_installs_the_folder() -> None:
    files = {f"{FOLDER}/launch/{NAME}": "", f"{FOLDER}/CMakeLists.txt": ""}
    found = not_installed(Sources(files), FOLDER, NAME)
    assert found.advice == "`install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})`"
    assert [str(place) for place in found.where] == [f"{FOLDER}/CMakeLists.txt"]
    beside = {f"{FOLDER}/{NAME}": "", f"{FOLDER}/CMakeLists.txt": ""}
    assert f"FILES {NAME}" in (not_installed(Sources(beside), FOLDER, NAME).advice or "")
