"""Faults of interface files, and of how CMakeLists.txt lists them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.build.digest import Case, explain, explain_success
from tests.build.conftest import SRC
from tests.build.digest.logs import check, no_file, processing, refused
from tests.build.packages import edit

MESSAGE = "is an invalid\nmessage name.  It should have the pattern '^[A-Z][A-Za-z0-9]*$'"
FIELD = "is an invalid field name.  It should have the\npattern '^(?!.*__)(?!.*_$)[a-z][a-z0-9_]*$'"
ASK = "int32 a\n---\nint32 b\n---\n"

# file, its new content, the log; the kind, the first place, words of the summary, words of the advice
INTERFACES: list[tuple[str, str, str, str, str, str, str]] = [
    ("msg/Landmark.msg", "int id\n", processing("int id", f"'int' {MESSAGE}"),
     "field-type", "msg/Landmark.msg:1", "There is no type `int`", "`int32`"),
    ("msg/Landmark.msg", "id int32\n", processing("id int32", f"'id' {MESSAGE}"),
     "field-type", "msg/Landmark.msg:1", "There is no type `id`", "`int32 id`"),
    ("msg/Landmark.msg", "int32[ id\n", processing("int32[ id", f"'int32[' {MESSAGE}"),
     "field-type", "msg/Landmark.msg:1", "There is no type `int32[`", "bracket"),
    ("msg/Landmark.msg", "\ngeometry_msgs/msg/Point p\n",
     processing("geometry_msgs/msg/Point p", "geometry_msgs/msg/Point"),
     "field-type", "msg/Landmark.msg:2", "`geometry_msgs/msg/Point`", "`geometry_msgs/Point`"),
    ("msg/Landmark.msg", "Point p\n", processing("Point p", f"'Point' {MESSAGE}"),
     "field-type", "msg/Landmark.msg:1", "There is no type `Point`", "`geometry_msgs/Point`"),
    ("msg/Landmark.msg", "string name;\n", processing("string name;", f"'name;' {FIELD}"),
     "field-name", "msg/Landmark.msg:1", "cannot be called `name;`", "no semicolon"),
    ("msg/Landmark.msg", "# a\nstringname\n",
     refused("rosidl_adapter.parser.InvalidFieldDefinition: stringname"),
     "field", "msg/Landmark.msg:2", "`stringname` in line 2 of Landmark.msg", "a space and a name"),
    ("msg/Landmark.msg", "int32 a\nint32 a\n",
     refused("ValueError: the fields iterable contains duplicate names: a"),
     "field-name", "msg/Landmark.msg:1", "two fields called `a`", "of its own"),
    ("msg/Landmark.msg", "int32 id=3\n", refused("NameError: 'id' is an invalid constant name.  It should"),
     "field-name", "msg/Landmark.msg:1", "`id` cannot be the name of a constant", "`ID`"),
    ("msg/Landmark.msg", "int32 id // it\n",
     refused("InvalidValue: value '// it' can not be converted\nto type 'int32': must"),
     "field-value", "msg/Landmark.msg:1", "`// it` is not a value of type int32", "begins with `#`"),
    ("srv/Ask.srv", "int32 a\n", refused("X: Could not find separator\n'---' between"),
     "separator", "srv/Ask.srv", "srv/Ask.srv must have exactly one line `---`", "three hyphens"),
    ("srv/Ask.srv", ASK, refused("X: Could not find unique\nseparator '---' between"),
     "separator", "srv/Ask.srv:4", "srv/Ask.srv must have exactly one line `---`", "Remove"),
    ("msg/Other.txt", "", refused("AssertionError: Unsupported interface type '.txt'"),
     "interface-name", "CMakeLists.txt", "ends in `.txt`", "`.msg`"),
    ("msg/Landmark.msg", "", no_file("Landmark.msg"),
     "interface-missing", "CMakeLists.txt:8", "lists Landmark.msg, but there is no", "`msg/Landmark.msg`"),
    ("msg/Landmark.msg", "", no_file(","), "interface-missing", "CMakeLists.txt:8", "lists `,`", "commas"),
    ("msg/Landmark.msg", "", no_file("DEPENDS"),
     "interface-missing", "CMakeLists.txt:8", "lists `DEPENDS`", "`DEPENDENCIES`"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("file", "content", "log", "kind", "place", "summary", "advice"),
    INTERFACES,
    ids=[f"{row[3]}-{row[5]}" for row in INTERFACES],
)
def test_faults_of_interface_files(
    case: Callable[..., Case],
    src: Path,
    file: str,
    content: str,
    log: str,
    kind: str,
    place: str,
    summary: str,
    advice: str,
) -> None:
    path = src / "small_interfaces" / file
    path.parent.mkdir(exist_ok=True)
    path.write_text(content)
    check(explain(case("small_interfaces", log)), kind, f"{SRC}/small_interfaces/{place}", summary, advice)


def test_a_message_without_its_package(case: Callable[..., Case], src: Path) -> None:
    edit(src / "small_interfaces/msg/Landmark.msg", "geometry_msgs/Point", "Point")
    log = (
        'File "/ros/lib/rosidl_generator_type_description/rosidl_generator_type_description", line 50\n'
        "FileNotFoundError: [Errno 2] No such file or directory: 'build/x/small_interfaces/msg/Point.json'\n"
    )
    failure = explain(case("small_interfaces", log))
    place = f"{SRC}/small_interfaces/msg/Landmark.msg:3"
    check(failure, "field-type", place, "no message `Point` in `small_interfaces`", "`geometry_msgs/Point`")


def test_a_message_that_another_package_does_not_have(
    case: Callable[..., Case], src: Path, tmp_path: Path
) -> None:
    edit(src / "small_interfaces/msg/Landmark.msg", "geometry_msgs/Point", "geometry_msgs/Pont")
    missing = tmp_path / "ros/share/geometry_msgs/msg/Pont.json"
    log = (
        "rosidl_generator_type_description\n"
        f"FileNotFoundError: [Errno 2] No such file or directory: '{missing}'\n"
    )
    failure = explain(case("small_interfaces", log))
    place = f"{SRC}/small_interfaces/msg/Landmark.msg:3"
    check(failure, "field-type", place, "no message `Pont` in `geometry_msgs`", "Did you mean `Point`?")


def test_a_message_that_is_there_but_not_listed(case: Callable[..., Case], src: Path) -> None:
    (src / "small_interfaces/msg/Path.msg").write_text("Landmark[] landmarks\nStep step\n")
    (src / "small_interfaces/msg/Step.msg").write_text("int32 length\n")
    log = (
        "rosidl_generator_type_description\n"
        "FileNotFoundError: [Errno 2] No such file or directory: 'build/x/small_interfaces/msg/Step.json'\n"
    )
    failure = explain(case("small_interfaces", log))
    place = f"{SRC}/small_interfaces/msg/Path.msg:2"
    check(failure, "field-type", place, "no message `Step`", "List `msg/Step.msg` in CMakeLists.txt, too.")


def test_a_word_of_python_is_no_field(case: Callable[..., Case], src: Path, tmp_path: Path) -> None:
    edit(src / "small_interfaces/msg/Landmark.msg", "name", "from")
    log = "Member name 'from' in the message 'Landmark' is a reserved keyword in Python and is not supported"
    failure = explain_success(case("small_interfaces", log), tmp_path)
    place = f"{SRC}/small_interfaces/msg/Landmark.msg:2"
    check(failure, "field-name", place, "cannot be called `from`", "another name")
