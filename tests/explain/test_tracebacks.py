"""From a line of an installed file to the learner's own."""

from __future__ import annotations

import pytest

from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.sources import Sources
from course.explain.python_errors import Crash, crash, learners_file
from course.model.feedback import Location

from .conftest import FOLDER, PACKAGES, Case, crash_of

TALK = "ws/src/talk"
BUILT = BuiltPackages(
    (BuiltPackage("talk", TALK, "/store/talk"), BuiltPackage("talker", "ws/src/talker", "/store/talker/"))
)


def sources(*names: str) -> Sources:
    return Sources({name: f"# 1 of {name}\n    line_2()\n" for name in names})


SITE = "/store/talk/lib/python3.12/site-packages"


@pytest.mark.parametrize(
    ("path", "file"),
    [
        (f"{SITE}/talk/node.py", f"{TALK}/talk/node.py"),
        (f"{SITE}/talk/parts/arm.py", f"{TALK}/talk/parts/arm.py"),
        ("/store/talk/local/lib/python3.12/dist-packages/talk/node.py", f"{TALK}/talk/node.py"),
        (f"{SITE}/speech/words.py", f"{TALK}/src/speech/words.py"),  # `package_dir` is src
        ("/store/talk/lib/talk/script", f"{TALK}/scripts/script"),  # installed by CMake
        ("/store/talker/lib/python3.12/site-packages/talk/node.py", "ws/src/talker/talk/node.py"),
        (f"{SITE}/talk/lost.py", None),
        (f"{SITE}/twice/node.py", None),  # not to be told apart
        ("/store/talk/lib/talk/generated", None),
        ("/store/talking/lib/python3.12/site-packages/talk/node.py", None),
        ("/usr/lib/python3.12/site-packages/talk/node.py", None),
        ("<frozen importlib._bootstrap>", None),
        ("", None),
    ],
)
def test_an_installed_file_is_found_in_the_sources(path: str, file: str | None) -> None:
    known = sources(
        f"{TALK}/talk/node.py",
        f"{TALK}/talk/parts/arm.py",
        f"{TALK}/src/speech/words.py",
        f"{TALK}/scripts/script",
        f"{TALK}/a/twice/node.py",
        f"{TALK}/b/twice/node.py",
        "ws/src/talker/talk/node.py",
    )
    assert learners_file(path, BUILT, known) == file


TRACEBACK = (
    "Traceback (most recent call last):",
    '  File "/store/talk/lib/talk/talker", line 33, in <module>',
    "    sys.exit(main())",
    f'  File "{SITE}/talk/node.py", line 1, in main',
    "    first()",
    f'  File "{SITE}/talk/node.py", line 2, in first',
    "    line_2()",
    '  File "/ros/rclpy/node.py", line 100, in create_timer',
    "    raise ValueError('x')",
    "ValueError: x",
)


def test_the_deepest_line_of_the_learners_is_the_place() -> None:
    found = crash(TRACEBACK, BUILT, sources(f"{TALK}/talk/node.py"))
    assert found == Crash(
        "ValueError: x",
        Location(f"{TALK}/talk/node.py", 2),
        (f"{TALK}/talk/node.py, line 2:", "    line_2()", "ValueError: x"),
    )


def test_without_a_line_of_the_learners_the_error_remains() -> None:
    assert crash(TRACEBACK, BUILT, Sources()) == Crash("ValueError: x", None, ("ValueError: x",))


@pytest.mark.parametrize("line", ["3", "0", "999999999999"])
def test_a_line_that_the_file_does_not_have(line: str) -> None:
    """The file may have been saved since, or the program printed whatever it liked."""
    text = ("Traceback", f'  File "{SITE}/talk/node.py", line {line}, in main', "ValueError: x")
    found = crash(text, BUILT, sources(f"{TALK}/talk/node.py"))
    assert found is not None
    assert found.error == "ValueError: x"
    assert crash(text, BUILT, Sources({f"{TALK}/talk/node.py": ""})) is not None


def test_no_traceback_no_crash() -> None:
    assert crash((), BUILT, Sources()) is None


def test_a_traceback_without_an_error() -> None:
    found = crash(TRACEBACK[:3], BUILT, Sources())
    assert found is not None
    assert found.error


def test_a_message_of_several_lines_is_told_in_one() -> None:
    found = crash_of(Case.named("bad_name"))
    assert found is not None
    assert found.error.endswith("alphanumerics or '_': 'the talker'")
    assert len(found.shown) == 5


@pytest.mark.parametrize("name", ["chained", "during"])
def test_of_two_errors_the_last_one_counts(name: str) -> None:
    found = crash_of(Case.named(name))
    assert found is not None
    assert found.error.split(":")[0] in ("ValueError", "NameError")
    assert found.where == Location(f"{FOLDER}/faulty/{name}.py", 11)


def test_interrupted_in_the_middle_of_rclpy() -> None:
    found = crash_of(Case.named("interrupt"))
    assert found is not None
    assert (found.error, found.where) == ("KeyboardInterrupt", Location(f"{FOLDER}/faulty/interrupt.py", 13))
    assert PACKAGES.get("faulty") is not None


@pytest.mark.parametrize("path", ["~/python/talk.py", "/dev/shm/x/home/python/./talk.py"])
def test_a_script_that_ran_in_a_copy_of_the_home(path: str) -> None:
    sources = Sources({"talk.py": "", "python/talk.py": "one\ntwo\n"})
    found = crash((f'  File "{path}", line 2', "    two", "NameError: two"), BuiltPackages(), sources)
    assert found is not None
    assert str(found.where) == "python/talk.py:2"
