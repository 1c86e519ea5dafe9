"""The cause and the next step, from what programs really wrote."""

from __future__ import annotations

import pytest

from course.evidence.packages import BuiltPackages
from course.evidence.sources import Sources
from course.feedback import Feedback
from course.grading.explain.crashes import crash_feedback
from course.grading.explain.tracebacks import Crash

from .cases import EXPECTED
from .conftest import CRASHES, FOLDER, PACKAGES, Case, explained, package, places, sources_of


@pytest.mark.parametrize("name", EXPECTED)
def test_a_crash_is_explained(name: str) -> None:
    where, words = EXPECTED[name]
    found = explained(Case.named(name))
    assert found is not None
    assert found.summary.startswith("The program stopped with an error: ")
    assert places(found)[0] == where
    assert words in str(found.advice)
    assert len(set(found.where)) == len(found.where)


def test_every_text_is_used() -> None:
    others = {"ended", "interrupt", "circular_other", "group"}
    assert {file.stem for file in CRASHES.iterdir()} == {*EXPECTED, *others}


def test_the_error_and_the_line_are_shown() -> None:
    found = explained(Case.named("no_init"))
    assert found is not None
    assert found.details == (
        f"{FOLDER}/faulty/no_init.py, line 7:",
        "    super().__init__('talker')",
        "rclpy.exceptions.NotInitializedException: rclpy.init() has not been called. msg:cannot create node",
    )


def test_no_crash_no_words() -> None:
    assert explained(Case.named("ended")) is None


def test_of_a_group_of_exceptions_one_is_named() -> None:
    found = explained(Case.named("group"))
    assert found is not None
    assert "TypeError: 2" in found.summary


def said(error: str, sources: Sources | None = None) -> Feedback:
    return crash_feedback(Crash(error, None, ()), PACKAGES, sources or sources_of(Case.named("ended")))


def test_a_program_is_free_to_print_what_it_likes() -> None:
    """Whatever an error's text claims of files that cannot be read, it is explained and raises nothing."""
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
    found = said("AttributeError: module 'faulty.helper' has no attribute 'main'", Sources(files))
    assert found.advice == "The entry point names the function `main`; `faulty.helper` has none."


def test_a_module_of_another_package_with_a_similar_name_is_not_taken() -> None:
    files = dict(sources_of(Case.named("wrong_module")).files)
    files["ros2_tutorial_workspace/src/other/notfaulty/endde.py"] = ""
    files["ros2_tutorial_workspace/src/other/test/faulty/ende.py"] = ""
    found = said("ModuleNotFoundError: No module named 'faulty.endde'", Sources(files))
    assert "The package has `ended` and `helper`" in str(found.advice)


def test_a_module_that_is_where_it_belongs_is_not_moved() -> None:
    """It may be the build that left it out."""
    found = said("ModuleNotFoundError: No module named 'faulty.ended'")
    assert "belongs" not in str(found.advice)


def test_the_entry_point_without_a_function_is_found_among_others() -> None:
    one, other = Case.named("ended"), Case.named("module_only")
    files = {f"{FOLDER}/{name}": text for name, text in package(one, other).items()}
    found = said("TypeError: 'module' object is not callable", Sources(files))
    assert "`module_only = faulty.helper:main`" in str(found.advice)


def test_without_packages_there_is_still_advice() -> None:
    error = "ModuleNotFoundError: No module named 'faulty.x'"
    assert crash_feedback(Crash(error, None, ()), BuiltPackages(), Sources()).advice


@pytest.mark.parametrize(
    ("error", "words"),
    [
        ("RuntimeError: rclpy.init() has not been called", "Call `rclpy.init()`"),
        ("rclpy.exceptions.NotInitializedException: cannot create node", "Call `rclpy.init()`"),
        ("AttributeError: 'Talker' object has no attribute '_Node__handle'", "super().__init__"),
        ("AttributeError: 'Talker' object has no attribute '_clock'", "super().__init__"),
        ("AttributeError: 'Talker' object has no attribute 'declare_parameter'", "derive from Node"),
        ("AttributeError: 'method' object has no attribute 'info'", "brackets"),
        ("rclpy.exceptions.ParameterAlreadyDeclaredException: Parameter(s)", "Declare each parameter once"),
        ("rclpy.exceptions.InvalidParameterTypeException: Trying to set", "its default value"),
        ("TypeError: First element 1 at index 0 in parameters list is not a str.", "a name and a value"),
        ("AttributeError: 'Talker' object has no attribute '_own'", "the line named here"),
        ("AttributeError: 'Talker' object has no attribute 'created'", "the line named here"),
    ],
)
def test_texts_of_other_versions(error: str, words: str) -> None:
    assert words in str(said(error).advice)


def test_a_client_of_the_smartarmstack_starts_ros_by_its_own_name() -> None:
    error = "rclpy.exceptions.NotInitializedException: rclpy.init() has not been called."
    client = Sources({f"{FOLDER}/scripts/client.py": "node = rclcpp_Node('client')"})
    driver = Sources({f"{FOLDER}/src/driver.cpp": "rclcpp_Node"})
    assert "`rclcpp_init()`" in str(said(error, client).advice)
    assert "`rclpy.init()`" in str(said(error, driver).advice)


def test_a_folder_of_modules_is_named_with_its_package() -> None:
    folder = Sources({f"{FOLDER}/faulty/tools/__init__.py": ""})
    found = said("ModuleNotFoundError: No module named 'tools'", folder)
    assert found.advice == "Name its package too: `faulty.tools` in place of `tools`."
