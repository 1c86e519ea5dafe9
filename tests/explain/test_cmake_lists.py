"""Reading CMakeLists.txt, and why `ros2 run` finds no executable of such a package."""

from __future__ import annotations

import pytest

from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.sources import Sources
from course.explain.cmake import commands
from course.explain.executables import no_executable
from course.model.events import ExecutableMissing

FOLDER = "src/talk"
PACKAGES = BuiltPackages((BuiltPackage("talk", FOLDER, "/store/talk"),))


def read(text: str) -> list[tuple[str, tuple[str, ...], int | None]]:
    found = commands(Sources({f"{FOLDER}/CMakeLists.txt": text}), FOLDER)
    return [(one.name, one.words, one.where.line) for one in found]


def test_commands_with_their_words_and_lines() -> None:
    text = (
        '# project(no)\nPROJECT(talk)\nadd_executable (a # b\n  "c d.cpp"\n  e.cpp)\nif(A AND (B))\nendif()\n'
    )
    assert read(text) == [
        ("project", ("talk",), 2),
        ("add_executable", ("a", "c d.cpp", "e.cpp"), 3),
        ("if", ("A", "AND", "B"), 6),
        ("endif", (), 7),
    ]


def test_variables_as_far_as_they_are_known() -> None:
    text = 'project(talk)\nset(there lib/${PROJECT_NAME})\ninstall(TARGETS x DESTINATION "${there}" ${else})'
    assert read(text)[-1][1] == ("TARGETS", "x", "DESTINATION", "lib/talk", "${else}")


@pytest.mark.parametrize("text", ["", "project(talk", "((((", 'set("', "a(" * 5000])
def test_what_cmake_could_not_read_either(text: str) -> None:
    read(text)


def told(text: str, *available: str) -> tuple[str, str, list[str]]:
    missing = ExecutableMissing(1.0, "talker", "talk", "talker", available)
    files = {f"{FOLDER}/CMakeLists.txt": f"project(talk)\n{text}"}
    found = no_executable(missing, PACKAGES, Sources(files))
    said = f"{found.summary} {found.expected} {found.seen} {found.advice}"
    return found.summary, said, [str(place.line) for place in found.where]


@pytest.mark.parametrize(
    ("text", "words", "line"),
    [
        ("add_executable(talker a.cpp)", "is built, but not installed", "2"),
        ("add_executable(talker a.cpp)\ninstall(TARGETS other DESTINATION lib/talk)", "not installed.", "2"),
        ("add_executable(talker a.cpp)\ninstall(FILES talker DESTINATION share)", "not installed.", "2"),
        ("add_executable(talker a.cpp)\ninstall(TARGETS talker DESTINATION bin)", "in the folder bin", "3"),
        ("add_executable(talker a.cpp)\ninstall(TARGETS talker)", "no DESTINATION", "3"),
        ("add_executable(tolker a.cpp)", "has `tolker`, but not `talker`", "2"),
        ("add_executable(listener a.cpp)", "built: `listener`", "2"),
        ("find_package(rclcpp)", "built: none", "None"),
    ],
)
def test_why_there_is_no_executable(text: str, words: str, line: str) -> None:
    summary, said, lines = told(text)
    assert summary.startswith("No executable found")
    assert words in said
    assert lines == [line]


def test_an_installed_name_that_is_nearly_right() -> None:
    assert "has `talkre`" in told("include(more.cmake)", "talkre")[0]
