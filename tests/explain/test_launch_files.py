"""What is wrong with a launch file."""

from __future__ import annotations

import pytest

from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.sources import Sources
from course.explain.engine import Cause
from course.explain.launch_files import launch_file_cause, not_installed, started_twice
from tests.golden import golden

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
    golden(not_installed(sources(), FOLDER, NAME))


@pytest.mark.parametrize(
    "given",
    [
        "glob('launch/*.launch.py')",
        "glob(os.path.join('launch', '*.launch.py'))",
        "['launch/qoute_launch.py']",
    ],
)
def test_a_pattern_that_does_not_match(given: str) -> None:
    golden(not_installed(sources(f"('share/' + package_name, {given})"), FOLDER, NAME))


def test_a_pattern_that_matches_and_a_wrong_folder() -> None:
    golden(not_installed(sources("('shared/talk', glob('launch/*launch.py'))"), FOLDER, NAME))


def test_a_launch_file_beside_setup_py() -> None:
    beside = sources("('share/talk', glob('launch/*launch.py'))", **{f"{FOLDER}/{NAME}": RIGHT})
    golden(not_installed(beside, FOLDER, NAME))


@pytest.mark.parametrize(
    "there",
    [f"{FOLDER}/launch/qoute_launch.py", f"{FOLDER}/launch/quote_lunch.py", f"{FOLDER}/launch/start.py"],
)
def test_a_launch_file_of_another_name(there: str) -> None:
    golden(not_installed(sources(**{there: ""}), FOLDER, NAME))


def test_no_launch_file() -> None:
    golden(not_installed(sources(**{f"{FOLDER}/talk/talker.py": ""}), FOLDER, NAME))


# inside


def test_a_launch_file_that_is_right() -> None:
    assert cause(RIGHT) is None


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("generate_launch", "generate_lanuch"),
        ("generate_launch_description", "start"),
        ("return LaunchDescription", "LaunchDescription"),
        ("[{'a': 1}]", "{'a': 1}"),
        ("'talker'", "'tlaker'"),
        ("'talker'", "'x'"),
    ],
)
def test_faults(old: str, new: str) -> None:
    golden(cause(RIGHT.replace(old, new)))


def test_a_misspelt_package() -> None:
    packages = BuiltPackages((BuiltPackage("quotes_by_talkers", FOLDER, "/store", ("talker",)),))
    text = RIGHT.replace("'talk'", "'quotes_by_tlakers'")
    golden(launch_file_cause(Sources({FILE: text}), packages, NAME))


def test_packages_of_ros_itself_are_left_alone() -> None:
    assert cause(RIGHT.replace("'talk'", "'demo_nodes_py'")) is None


@pytest.mark.parametrize("text", ["def (", ""])
def test_what_cannot_be_read(text: str) -> None:
    golden(cause(text))


def test_a_package_that_cmake_builds_installs_the_folder() -> None:
    files = {f"{FOLDER}/launch/{NAME}": "", f"{FOLDER}/CMakeLists.txt": ""}
    golden(not_installed(Sources(files), FOLDER, NAME))
    beside = {f"{FOLDER}/{NAME}": "", f"{FOLDER}/CMakeLists.txt": ""}
    golden(not_installed(Sources(beside), FOLDER, NAME))


def test_two_nodes_of_one_program() -> None:
    text = "a = Node(executable='talker')\nb = Node(executable='{}')\n"
    twice = started_twice(Sources({FILE: text.format("talker")}))
    assert twice is not None
    assert [place.line for place in twice.where] == [2, 1]
    assert started_twice(Sources({FILE: text.format("listener")})) is None
    assert started_twice(Sources({FILE: "a = Node(executable=name)\nb = Node(executable=other)\n"})) is None
