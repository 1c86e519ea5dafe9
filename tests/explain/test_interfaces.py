"""Faults of interface files, and of how CMakeLists.txt lists them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.explain.build_errors import explain_build, explain_success
from course.explain.builds import Build
from tests.build.packages import edit
from tests.golden import golden

from .logs import no_file, processing, refused

MESSAGE = "is an invalid\nmessage name.  It should have the pattern '^[A-Z][A-Za-z0-9]*$'"
FIELD = "is an invalid field name.  It should have the\npattern '^(?!.*__)(?!.*_$)[a-z][a-z0-9_]*$'"
ASK = "int32 a\n---\nint32 b\n---\n"

# A file, its new content, and the log.
INTERFACES = [
    ("msg/Landmark.msg", "int id\n", processing("int id", f"'int' {MESSAGE}")),
    ("msg/Landmark.msg", "id int32\n", processing("id int32", f"'id' {MESSAGE}")),
    ("msg/Landmark.msg", "int32[ id\n", processing("int32[ id", f"'int32[' {MESSAGE}")),
    (
        "msg/Landmark.msg",
        "\ngeometry_msgs/msg/Point p\n",
        processing("geometry_msgs/msg/Point p", "geometry_msgs/msg/Point"),
    ),
    ("msg/Landmark.msg", "Point p\n", processing("Point p", f"'Point' {MESSAGE}")),
    ("msg/Landmark.msg", "string name;\n", processing("string name;", f"'name;' {FIELD}")),
    (
        "msg/Landmark.msg",
        "# a\nstringname\n",
        refused("rosidl_adapter.parser.InvalidFieldDefinition: stringname"),
    ),
    (
        "msg/Landmark.msg",
        "int32 a\nint32 a\n",
        refused("ValueError: the fields iterable contains duplicate names: a"),
    ),
    ("msg/Landmark.msg", "int32 id=3\n", refused("NameError: 'id' is an invalid constant name.  It should")),
    (
        "msg/Landmark.msg",
        "int32 id // it\n",
        refused("InvalidValue: value '// it' can not be converted\nto type 'int32': must"),
    ),
    ("srv/Ask.srv", "int32 a\n", refused("X: Could not find separator\n'---' between")),
    ("srv/Ask.srv", ASK, refused("X: Could not find unique\nseparator '---' between")),
    ("msg/Other.txt", "", refused("AssertionError: Unsupported interface type '.txt'")),
    ("msg/Landmark.msg", "", no_file("Landmark.msg")),
    ("msg/Landmark.msg", "", no_file(",")),
    ("msg/Landmark.msg", "", no_file("DEPENDS")),
]


@pytest.mark.parametrize(("file", "content", "log"), INTERFACES, ids=range(len(INTERFACES)))
def test_faults_of_interface_files(
    case: Callable[..., Build], src: Path, file: str, content: str, log: str
) -> None:
    path = src / "small_interfaces" / file
    path.parent.mkdir(exist_ok=True)
    path.write_text(content)
    golden(explain_build(case("small_interfaces", log)))


def test_a_message_without_its_package(case: Callable[..., Build], src: Path) -> None:
    edit(src / "small_interfaces/msg/Landmark.msg", "geometry_msgs/Point", "Point")
    log = (
        'File "/ros/lib/rosidl_generator_type_description/rosidl_generator_type_description", line 50\n'
        "FileNotFoundError: [Errno 2] No such file or directory: 'build/x/small_interfaces/msg/Point.json'\n"
    )
    failure = explain_build(case("small_interfaces", log))
    golden(failure)


def test_a_message_that_another_package_does_not_have(
    case: Callable[..., Build], src: Path, tmp_path: Path
) -> None:
    edit(src / "small_interfaces/msg/Landmark.msg", "geometry_msgs/Point", "geometry_msgs/Pont")
    missing = tmp_path / "ros/share/geometry_msgs/msg/Pont.json"
    log = (
        "rosidl_generator_type_description\n"
        f"FileNotFoundError: [Errno 2] No such file or directory: '{missing}'\n"
    )
    failure = explain_build(case("small_interfaces", log))
    golden(failure)


def test_a_message_that_is_there_but_not_listed(case: Callable[..., Build], src: Path) -> None:
    (src / "small_interfaces/msg/Path.msg").write_text("Landmark[] landmarks\nStep step\n")
    (src / "small_interfaces/msg/Step.msg").write_text("int32 length\n")
    log = (
        "rosidl_generator_type_description\n"
        "FileNotFoundError: [Errno 2] No such file or directory: 'build/x/small_interfaces/msg/Step.json'\n"
    )
    failure = explain_build(case("small_interfaces", log))
    golden(failure)


def test_a_word_of_python_is_no_field(case: Callable[..., Build], src: Path, tmp_path: Path) -> None:
    edit(src / "small_interfaces/msg/Landmark.msg", "name", "from")
    log = "Member name 'from' in the message 'Landmark' is a reserved keyword in Python and is not supported"
    failure = explain_success(case("small_interfaces", log), tmp_path)
    golden(failure)
