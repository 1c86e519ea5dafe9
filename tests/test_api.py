"""Graders import `course.api`, and nothing else from the engine."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

from course.content import open_course
from course.content.layout import STATE

REPO = Path(__file__).parents[1]
GRADERS = REPO / "graders"
MOST = 110

NAMES = """
AllOf Arena BASHRC BuiltPackage Call Cause Client Command ContentError CppError Crash Document Failure
Feedback Grader HomeFile Listener Location LogLine Message Mystery NotApplicable Number OneOf OurFault
Parameters ProbeAnswer Process ProcessView Recording Server ServiceCall Sources Spoilt Stream Text TooBusy
TopicView about answered ask_for calls cause_of_silence commands complaints cpp_files crash crash_feedback
entry_points expect_answer expect_answers expect_build_type expect_clean_end expect_clean_interrupt
expect_compiled expect_declared expect_dependency expect_endpoint expect_executable expect_file
expect_importable expect_launch_file expect_launch_interrupt expect_launch_parameter expect_launched
expect_launched_node expect_lines expect_logged expect_manifest expect_mode expect_no_warnings expect_node
expect_own_launch_parameter expect_parameter expect_period expect_qos expect_ran expect_running expect_service
expect_service_type expect_set expect_shell expect_sound expect_text expect_type first_error functions
launch_file learners_file listed misspelled_group named native_answer nearest never_called not_configured
not_made packages_place parse_document places_of read_once read_setup_cfg replace seconds slips text_places
timer_places trees without_effect words
""".split()


def imported(file: Path) -> list[tuple[str, ast.alias]]:
    """A module's imports from the engine: from where, and what."""
    nodes = [node for node in ast.walk(ast.parse(file.read_text())) if isinstance(node, ast.ImportFrom)]
    ours = [node for node in nodes if (node.module or "").split(".")[0] == "course"]
    return [(node.module or "", alias) for node in ours for alias in node.names]


def code_of_graders() -> list[Path]:
    files = sorted(GRADERS.rglob("*.py"))
    return [file for file in files if file.name != "conftest.py" and file.parent.name != "probes"]


def test_public_names() -> None:
    names = [alias.asname or alias.name for _, alias in imported(REPO / "course/api.py")]
    assert sorted(names) == NAMES
    assert len(NAMES) <= MOST


@pytest.mark.parametrize("file", code_of_graders(), ids=lambda file: file.stem)
def test_graders_import_of_the_engine_its_api_alone(file: Path) -> None:
    assert {module for module, _ in imported(file)} <= {"course.api"}


def test_every_public_name_is_used_by_a_grader() -> None:
    used = {alias.name for file in code_of_graders() for _, alias in imported(file)}
    assert set(NAMES) - used == set()


def test_needs_no_ros_and_no_pytest() -> None:
    """A recording is made without pytest, and judged without ROS."""
    code = (
        "import sys; sys.modules['rclpy'] = sys.modules['pytest'] = None; import course.api;"
        " assert 'course.evidence.recorder' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], cwd=REPO, check=True, timeout=60)


# Names of the course that the engine does not know, besides those of its packages and workspaces.
WORDS = ("joint", "joints", "sas", "smartarmstack", "print_forever", "amazing", "minimalist")
# What stays in a room of the engine, and why.
ALLOWED = {
    ("content", "ros2_tutorial_workspace"): "where packages are if nothing else is said",
    ("home", "ros2_tutorials_preamble"): "the folders of a home, before any course is known",
    ("home", "sas_tutorial_workspace"): "the same",
    ("home", "cmake_tutorial"): "the same",
    ("report", "joint"): "a field of ROS's own sensor_msgs/msg/JointState",
    ("report", "joints"): "the same",
    ("explain", "smartarmstack"): "a known error of a library, as those of rclpy are",
    ("explain", "sas_common"): "the same",
    ("explain", "sas_core"): "the same",
}


def of_the_course() -> set[str]:
    """Its packages, and the folders at the top of what solves it."""
    exercises = open_course().exercises()
    packages = {name for one in exercises for name in (*one.packages, *one.grader_packages)}
    tops = {folder.name for folder in (REPO / "solutions").glob("*/*") if folder.is_dir()}
    return packages | tops - {"a_folder", "alternatives", "answers", STATE}


def test_the_engine_knows_no_chapter_and_no_package_of_the_course() -> None:
    wanted = {*of_the_course(), *WORDS}
    files = [file for file in (REPO / "course").rglob("*") if file.suffix in (".py", ".in", ".xml")]
    found = {
        (file.relative_to(REPO / "course").parts[0], word)
        for file in files
        for word in set(re.findall(r"[a-z][a-z0-9]*(?:_[a-z0-9]+)*", file.read_text().lower()))
        if word in wanted or word.startswith(("sas_", "minimalist_", "amazing_"))
    }
    assert found == set(ALLOWED)
