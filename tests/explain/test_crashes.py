"""The cause and the next step, from what programs really wrote."""

from __future__ import annotations

import pytest

from course.evidence.packages import BuiltPackages
from course.evidence.sources import Sources
from course.explain.python_errors import Crash, crash_feedback
from course.model.feedback import Feedback
from tests.golden import golden

from .conftest import CRASHES, FOLDER, PACKAGES, Case, explained, package, sources_of


@pytest.mark.parametrize("name", CRASHES)
def test_a_crash_is_explained(name: str) -> None:
    golden(explained(Case.named(name)))


def test_no_crash_no_words() -> None:
    assert explained(Case.named("ended")) is None


def test_of_a_group_of_exceptions_one_is_named() -> None:
    golden(explained(Case.named("group")))


def said(error: str, sources: Sources | None = None) -> Feedback:
    return crash_feedback(Crash(error, None, ()), PACKAGES, sources or sources_of(Case.named("ended")))


def test_a_program_is_free_to_print_what_it_likes() -> None:
    """Whatever an error's text claims about unreadable files, explaining it raises nothing."""
    broken = Sources({f"{FOLDER}/faulty/bad.py": "def (", f"{FOLDER}/setup.py": "setup(("})
    for error in (
        "AttributeError: module 'faulty.bad' has no attribute 'main'",
        "ImportError: cannot import name 'main' from 'faulty.bad'",
        "ModuleNotFoundError: No module named 'faulty.bad'",
        "ModuleNotFoundError: No module named '...'",
        "TypeError: 'module' object is not callable",
        "TypeError: 'NoneType' object is not callable",
        "",
    ):
        assert said(error, broken).advice
        assert said(error, Sources()).advice


def test_a_broken_module_that_an_entry_point_names_raises_nothing() -> None:
    files = dict(sources_of(Case.named("helper")).files)
    files[f"{FOLDER}/faulty/helper.py"] = "def ("
    golden(said("AttributeError: module 'faulty.helper' has no attribute 'main'", Sources(files)))


def test_a_module_of_another_package_with_a_similar_name_is_not_taken() -> None:
    files = dict(sources_of(Case.named("wrong_module")).files)
    files["ros2_tutorial_workspace/src/other/notfaulty/endde.py"] = ""
    files["ros2_tutorial_workspace/src/other/test/faulty/ende.py"] = ""
    golden(said("ModuleNotFoundError: No module named 'faulty.endde'", Sources(files)))


def test_a_module_that_is_where_it_belongs_is_not_moved() -> None:
    """The build may have left it out."""
    golden(said("ModuleNotFoundError: No module named 'faulty.ended'"))


def test_the_entry_point_without_a_function_is_found_among_others() -> None:
    one, other = Case.named("ended"), Case.named("module_only")
    files = {f"{FOLDER}/{name}": text for name, text in package(one, other).items()}
    golden(said("TypeError: 'module' object is not callable", Sources(files)))


def test_without_packages_there_is_still_advice() -> None:
    error = "ModuleNotFoundError: No module named 'faulty.x'"
    assert crash_feedback(Crash(error, None, ()), BuiltPackages(), Sources()).advice


@pytest.mark.parametrize(
    "error",
    [
        "RuntimeError: rclpy.init() has not been called",
        "rclpy.exceptions.NotInitializedException: cannot create node",
        "AttributeError: 'Talker' object has no attribute '_Node__handle'",
        "AttributeError: 'Talker' object has no attribute '_clock'",
        "AttributeError: 'Talker' object has no attribute 'declare_parameter'",
        "AttributeError: 'method' object has no attribute 'info'",
        "rclpy.exceptions.ParameterAlreadyDeclaredException: Parameter(s)",
        "rclpy.exceptions.InvalidParameterTypeException: Trying to set",
        "TypeError: First element 1 at index 0 in parameters list is not a str.",
        "AttributeError: 'Talker' object has no attribute '_own'",
        "AttributeError: 'Talker' object has no attribute 'created'",
    ],
)
def test_texts_of_other_versions(error: str) -> None:
    golden(said(error))


def test_a_client_of_the_smartarmstack_starts_ros_by_its_own_name() -> None:
    error = "rclpy.exceptions.NotInitializedException: rclpy.init() has not been called."
    client = Sources({f"{FOLDER}/scripts/client.py": "node = rclcpp_Node('client')"})
    driver = Sources({f"{FOLDER}/src/driver.cpp": "rclcpp_Node"})
    assert "`rclcpp_init()`" in str(said(error, client).advice)
    assert "`rclpy.init()`" in str(said(error, driver).advice)


def test_a_folder_of_modules_is_named_with_its_package() -> None:
    folder = Sources({f"{FOLDER}/faulty/tools/__init__.py": ""})
    golden(said("ModuleNotFoundError: No module named 'tools'", folder))


TALKER = """\
import rclpy

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.timer = self.create_timer(0.5, self.tick)
        self.tick()
        self.count = 0
        self.other = 0

    def tick(self):
        timer = time.monotonic()
        self.steps += 1
        print(self.count, size, string)

def main():
    size, strings = 1, 2
"""


@pytest.mark.parametrize(
    ("error", "advice"),
    [
        ("NameError: name 'time' is not defined", "Add `import time` at"),
        (
            "NameError: name 'time' is not defined. Did you mean: 'timer'? "
            "Or did you forget to import 'time'?",
            "Add `import time` at",
        ),
        ("NameError: name 'string' is not defined", "You probably mean `strings`"),
        ("NameError: name 'size' is not defined", "`size` gets its value elsewhere, or only later"),
        ("NameError: name 'nothing' is not defined", "Check the spelling of `nothing`"),
        ("AttributeError: 'Talker' object has no attribute 'count'", "`count` gets its value only after"),
        (
            "AttributeError: 'Other' object has no attribute 'count'",
            "The object before `.count` is of type",
        ),
        ("AttributeError: 'Talker' object has no attribute 'steps'", "Nothing in `Talker` sets `self.steps`"),
        ("AttributeError: 'Talker' object has no attribute 'othr'", "You probably mean `other`"),
        ('TypeError: can only concatenate str (not "float") to str', "This line adds a number"),
        ('TypeError: can only concatenate str (not "NoneType") to str', "This line adds `None` to a string"),
        ('TypeError: can only concatenate str (not "list") to str', "This line adds a `list` to a string"),
    ],
)
def test_what_is_missing_is_told_from_what_is_misspelled(error: str, advice: str) -> None:
    assert str(said(error, Sources({f"{FOLDER}/faulty/talker.py": TALKER})).advice).startswith(advice)
