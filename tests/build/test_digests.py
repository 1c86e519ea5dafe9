"""Causes read from logs as the tools wrote them, shortened; those of test_real_builds.py are not repeated."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from course.build import BuildFailure, Workspace
from course.build.digest import Case, explain, explain_success, readable
from course.build.digest.machine import raise_if_machine
from course.build.digest.setup_source import entry_points
from course.errors import MissingHere, StorageError
from tests.build.conftest import SRC, WORKSPACE
from tests.build.packages import edit

Digest = Callable[..., BuildFailure]


@pytest.fixture
def case(home: Path, tmp_path: Path) -> Callable[..., Case]:
    """The case of a package whose build printed `log`, and whose setup.py, run alone, prints `said`."""
    made_up_ros(tmp_path / "ros")

    def make(name: str, log: str, said: Sequence[str] = ()) -> Case:
        workspace = Workspace.scan(home / WORKSPACE)
        package = workspace.find(name)
        assert package is not None
        lines = tuple(log.splitlines())
        prefixes = (tmp_path / "ros",)
        return Case(
            package, workspace, package.folder, lines, tmp_path / "log", prefixes, lambda: tuple(said)
        )

    return make


def made_up_ros(prefix: Path) -> None:
    index = prefix / "share/ament_index/resource_index/packages"
    index.mkdir(parents=True)
    for package in ("geometry_msgs", "std_msgs"):
        (index / package).touch()
        (prefix / "share" / package / "msg").mkdir(parents=True)
    (prefix / "share/geometry_msgs/msg/Point.msg").touch()


# ------------------------------------------------------------------------------------------- interfaces


def refused(message: str) -> str:
    """What CMake prints when rosidl's adapter ends with an exception."""
    wrapped = "\n".join(f"  {line}" for line in message.splitlines())
    return (
        "-- Found geometry_msgs: 5.3.6 (/ros/share/geometry_msgs/cmake)\n"
        "CMake Error at /ros/share/rosidl_adapter/cmake/rosidl_adapt_interfaces.cmake:57 (message):\n"
        f"  returned error code 1:\n\n{wrapped}\n\n"
        "Call Stack (most recent call first):\n"
        "  /ros/share/rosidl_cmake/cmake/rosidl_generate_interfaces.cmake:132 (rosidl_adapt_interfaces)\n"
        "  CMakeLists.txt:8 (rosidl_generate_interfaces)\n\n\n"
        "-- Configuring incomplete, errors occurred!\n"
    )


def processing(line: str, problem: str) -> str:
    return refused(
        f"Error processing '{line}' of 'small_interfaces/Landmark': '{problem}'\n\nTraceback (most\nrecent"
    )


def no_file(word: str) -> str:
    return (
        "CMake Error at /ros/share/rosidl_cmake/cmake/rosidl_generate_interfaces.cmake:95 (message):\n"
        f"  rosidl_generate_interfaces() the passed file '{word}' doesn't\n"
        "  exist relative to the CMAKE_CURRENT_SOURCE_DIR\n\n"
        "Call Stack (most recent call first):\n  CMakeLists.txt:8 (rosidl_generate_interfaces)\n"
    )


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
     refused("rosidl_adapter.parser.InvalidValue: value '// it' can not be converted\nto type 'int32': must"),
     "field-value", "msg/Landmark.msg:1", "`// it` is not a value of type int32", "begins with `#`"),
    ("srv/Ask.srv", "int32 a\n", refused("InvalidServiceSpecification: Could not find separator\n'---' between"),
     "separator", "srv/Ask.srv", "srv/Ask.srv must have exactly one line `---`", "three hyphens"),
    ("srv/Ask.srv", ASK, refused("InvalidServiceSpecification: Could not find unique\nseparator '---' between"),
     "separator", "srv/Ask.srv:4", "srv/Ask.srv must have exactly one line `---`", "Remove"),
    ("msg/Other.txt", "", refused("AssertionError: Unsupported interface type '.txt'"),
     "interface-name", "CMakeLists.txt", "ends in `.txt`", "`.msg`"),
    ("msg/Landmark.msg", "", no_file("Landmark.msg"),
     "interface-missing", "CMakeLists.txt:8", "lists Landmark.msg, but there is no such file", "`msg/Landmark.msg`"),
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
    case: Callable[..., Case], src: Path, file: str, content: str, log: str, kind: str, place: str, summary: str, advice: str
) -> None:  # fmt: skip
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


# ------------------------------------------------------------------------------------------------ CMake

CMAKE: list[tuple[str, str, str, str, str, str]] = [
    ("CMake Error at /ros/a.cmake:53 (message):\n  ament_package_xml() package name 'small_interfaces' in\n"
     "  '/package.xml' does not match current PROJECT_NAME 'other'.  You must call\nCall Stack (most recent call first):\n"
     "  CMakeLists.txt:8 (rosidl_generate_interfaces)\n",
     "names-differ", "CMakeLists.txt:2", "calls the project `other`", "`project(small_interfaces)`", ""),
    (refused("InvalidResourceName: 'Project' is an invalid package\nname.  It should have"),
     "names-differ", "CMakeLists.txt:1", "does not call `project(small_interfaces)`", "below", ""),
    ("CMake Error at CMakeLists.txt:8 (rosidl_generate_interfaces):\n"
     '  Unknown CMake command "rosidl_generate_interfaces".\n\n',
     "cmake-command", "CMakeLists.txt:8", "the package that brings it", "rosidl_default_generators", ""),
    ("CMake Error at /ros/x.cmake:30 (if):\n  if given arguments:\n\n    \"NOT\"\n\nCall Stack (most recent call first):\n"
     "  CMakeLists.txt:4 (find_package)\n\n\n"
     "CMake Error in CMakeLists.txt:\n  No cmake_minimum_required command is present.  A line of code such as\n",
     "cmake-minimum", "CMakeLists.txt:1", "does not begin with `cmake_minimum_required`", "first line", ""),
    ("CMake Error at CMakeLists.txt:15:\n  Parse error.  Function missing ending \")\".  Instead found unterminated\n"
     "  string with text \"msg/Landmark.msg\n",
     "cmake-syntax", "CMakeLists.txt:15", "A closing quote is missing", "line 15", ""),
    ("CMake Error at CMakeLists.txt:8 (rosidl_generate_interfaces):\n  The target name \"$PROJECT_NAME\" is reserved\n",
     "cmake-variable", "CMakeLists.txt:8", "the variable PROJECT_NAME without braces", "`${PROJECT_NAME}`", ""),
    ("CMake Error at CMakeLists.txt:14 (add_executable):\n  Cannot find source file:\n\n    msg/Landmarc.msg\n\n  Tried\n",
     "source-missing", "CMakeLists.txt:14", "names the source file msg/Landmarc.msg", "`msg/Landmark.msg`", ""),
    (f"CMake Error at cmake_install.cmake:362 (file):\n  file INSTALL cannot find\n  \"{SRC}/small_interfaces/launch\": No\n",
     "install-missing", "CMakeLists.txt", "installs launch, but it does not exist", "`install(...)`", ""),
    ("CMake Error: The source directory \"x\" does not appear to contain CMakeLists.txt.\n",
     "cmake-missing", "CMakeLists.txt", "has no CMakeLists.txt", "ament_cmake", ""),
    ("CMake Error at CMakeLists.txt:3 (strange):\n  Something quite new.  It goes on for long.\n",
     "cmake", "CMakeLists.txt:3", "CMake cannot configure `small_interfaces`: Something quite new.", "None", "It goes"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("log", "kind", "place", "summary", "advice", "detail"),
    CMAKE,
    ids=[f"{row[1]}-{row[3]}" for row in CMAKE],
)
def test_faults_of_cmake_lists(
    case: Callable[..., Case], log: str, kind: str, place: str, summary: str, advice: str, detail: str
) -> None:
    failure = explain(case("small_interfaces", log))
    check(failure, kind, f"{SRC}/small_interfaces/{place}", summary, advice)
    assert detail in "\n".join(failure.feedback.details)


def test_a_python_package_that_says_cmake(case: Callable[..., Case], src: Path) -> None:
    edit(src / "small_node/package.xml", "ament_python", "ament_cmake")
    log = 'CMake Error: The source directory "x" does not appear to contain CMakeLists.txt.\n'
    place = f"{SRC}/small_node/package.xml:11"
    check(explain(case("small_node", log)), "build-type", place, "says ament_cmake", "ament_python")


# ----------------------------------------------------------------------------------------------- Python


def test_a_bad_setup_cfg(case: Callable[..., Case], src: Path) -> None:
    (src / "small_node/setup.cfg").write_text("[install\n")
    said = [
        "Traceback (most recent call last):",
        '  File "/python/configparser.py", line 1101, in _read',
        "configparser.MissingSectionHeaderError: File contains no section headers.",
        "file: 'setup.cfg', line: 1",
        "'[install\\n'",
    ]
    failure = explain(case("small_node", "", said))
    check(failure, "setup-cfg", f"{SRC}/small_node/setup.cfg:1", "setup.cfg of `small_node`", "`[install]`")


def test_a_folder_that_is_not_there(case: Callable[..., Case]) -> None:
    log = "running build_py\nerror: package directory 'other' does not exist\n"
    failure = explain(case("small_node", log))
    check(
        failure,
        "package-folder",
        f"{SRC}/small_node/setup.py:8",
        "lists the Python package other",
        "find_packages",
    )


def test_setup_py_missing_and_empty(case: Callable[..., Case], src: Path) -> None:
    (src / "small_node/setup.py").write_text("")
    place = f"{SRC}/small_node/setup.py"
    check(explain(case("small_node", "")), "setup-py", place, "setup.py of `small_node` is empty", "None")
    (src / "small_node/setup.py").unlink()
    place = f"{SRC}/small_node/package.xml:12"
    check(explain(case("small_node", "")), "setup-missing", place, "has no setup.py", "ros2 pkg create")
    (src / "small_node/CMakeLists.txt").write_text("project(x)")
    check(
        explain(case("small_node", "")),
        "build-type",
        place,
        "a CMakeLists.txt and no setup.py",
        "ament_cmake",
    )


def test_setup_that_is_never_called(case: Callable[..., Case]) -> None:
    log = "RuntimeError: 'distutils.core.setup()' was never called -- perhaps 'setup.py' is not a script?"
    failure = explain(case("small_node", log))
    check(failure, "setup-py", f"{SRC}/small_node/setup.py", "never calls `setup(...)`", "end of the file")


def test_what_setuptools_refuses_is_quoted(case: Callable[..., Case]) -> None:
    said = ["error in small_node setup command: 'install_requires' must be a string."]
    failure = explain(case("small_node", "", said))
    place = f"{SRC}/small_node/setup.py"
    check(failure, "setup-py", place, "refuses setup.py of `small_node`: 'install_requires' must be", "None")


@pytest.mark.parametrize(
    ("items", "sound", "joined"),
    [
        ("'a = m:f', 'b = m:g'", [True, True], [False, False]),
        ("'a = m:f'\n 'b = m:g'", [False], [True]),
        ("'a = '\n 'm:f', 'b = m:g'", [True, True], [False, False]),
        ("'ä = ü:f', 'a = m.n:C.f'", [True, True], [False, False]),
        ("'a = m/n.py:f'", [False], [False]),
        ("'a = m.f'", [False], [False]),
    ],
)
def test_entry_points_are_read_without_running(items: str, sound: list[bool], joined: list[bool]) -> None:
    points = entry_points(f"setup(entry_points={{'console_scripts': [\n {items},\n]}})\n")
    assert [point.is_sound for point in points] == sound
    assert [point.is_joined for point in points] == joined


def test_what_cannot_be_parsed_has_no_entry_points() -> None:
    assert entry_points("setup(") == []


# ----------------------------------------------------------------------------------------- all the rest


def test_an_unknown_failure_shows_its_last_errors(case: Callable[..., Case]) -> None:
    log = "running x\nfine\nerror: the moon is full\ngmake: *** [all] Error 2\n"
    failure = explain(case("small_interfaces", log))
    assert failure.kind == "build"
    assert failure.feedback.details == ("error: the moon is full",)


def test_paths_are_the_learners(tmp_path: Path) -> None:
    store = tmp_path / "store"
    copy = store / ("a" * 32) / "src"
    log = f"\x1b[31m{copy}/main.cpp:3: in {store}/{'b' * 32}/install/other/x.hpp\x1b[0m\r\ncd {copy}\n"
    found = readable(log, store, copy, "ws/src/mine")
    assert found == ("ws/src/mine/main.cpp:3: in install/other/x.hpp", "cd ws/src/mine")


@pytest.mark.parametrize(
    ("line", "error", "words"),
    [
        ("fatal error: error writing to x: No space left on device", StorageError, "disk is full"),
        ("OSError: [Errno 122] Disk quota exceeded: 'x'", StorageError, "disk is full"),
        ("c++: fatal error: Killed signal terminated program cc1plus", MissingHere, "out of memory"),
        ("  Could NOT find Python3 (missing: Development.Module)", MissingHere, "header files"),
        ("  No CMAKE_CXX_COMPILER could be found.", MissingHere, "C++ compiler"),
    ],
)
def test_the_machines_faults_are_not_the_learners(
    tmp_path: Path, line: str, error: type[Exception], words: str
) -> None:
    with pytest.raises(error) as caught:
        raise_if_machine(["fine", line], tmp_path, tmp_path / "python3")
    assert words in str(caught.value)


def check(failure: BuildFailure | None, kind: str, place: str, summary: str, advice: str) -> None:
    assert failure is not None
    assert failure.kind == kind, failure.feedback
    assert str(failure.feedback.where[0]) == place
    assert summary in failure.feedback.summary
    assert advice in str(failure.feedback.advice)
