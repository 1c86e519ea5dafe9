"""`ros2 pkg` list, executables, prefix and xml, against what the real command prints."""

from __future__ import annotations

import pytest

from tests.underlay.runtime.captured import capture
from tests.underlay.runtime.command import Ros2
from tests.underlay.runtime.conftest import INTERFACES, NODES

CASES = [
    "pkg_executables",
    "pkg_executables_full_path",
    "pkg_executables_unknown",
    "pkg_noverb",
    "pkg_prefix",
    "pkg_prefix_share",
    "pkg_xml",
    "pkg_xml_tag",
]


@pytest.mark.parametrize("name", CASES)
def test_as_the_real_one(name: str, ros2: Ros2) -> None:
    case = capture(name)
    answer = ros2(*case.arguments)
    assert answer.stdout.replace(str(ros2.workspace), "<workspace>") == case.stdout
    assert (answer.code, answer.stderr) == (case.code, case.stderr)


def test_list_has_what_is_installed_in_the_real_order(ros2: Ros2) -> None:
    ours = ros2("pkg", "list").stdout.splitlines()
    real = capture("pkg_list").stdout.splitlines()
    assert {NODES, INTERFACES, "the_simplest_python_package", "rclpy", "std_msgs"} <= {*ours}
    assert [name for name in ours if name in real] == [name for name in real if name in ours]
    assert ours == sorted(ours)


def test_executables_of_all_packages(ros2: Ros2) -> None:
    ours = ros2("pkg", "executables").stdout.splitlines()
    packages = {NODES, *(line.split()[0] for line in ours if line.startswith("rosidl"))}
    real = capture("pkg_executables_all").stdout.splitlines()
    assert [line for line in ours if line.split()[0] in packages] == [
        line for line in real if line.split()[0] in packages
    ]
    assert len(packages) > 5


def test_no_executables_is_no_error(ros2: Ros2) -> None:
    answer = ros2("pkg", "executables", "the_simplest_python_package")
    assert (answer.code, answer.stdout, answer.stderr) == (0, "", "")


@pytest.mark.parametrize("verb", ["prefix", "xml"])
def test_unknown_package(verb: str, ros2: Ros2) -> None:
    answer = ros2("pkg", verb, "nosuch_package")
    assert (answer.code, answer.stdout, answer.stderr) == (1, "", "Package not found\n")


def test_odd_names_are_unknown_packages(ros2: Ros2) -> None:
    for name in ("", "..", "a/b", "/", "ä"):
        answer = ros2("pkg", "executables", "--", name) if name else ros2("pkg", "prefix", name)
        assert answer.code == 1
        assert "not found" in answer.stderr
        assert "Traceback" not in answer.stderr


def test_xml_with_a_tag_that_is_not_there(ros2: Ros2) -> None:
    answer = ros2("pkg", "xml", NODES, "-t", "nosuch")
    assert (answer.code, answer.stdout) == (1, "")
    assert "'nosuch'" in answer.stderr


def test_xml_of_a_package_without_manifest(ros2: Ros2) -> None:
    answer = ros2("pkg", "xml", "the_simplest_python_package")
    assert (answer.code, answer.stdout) == (1, "")
    assert "manifest" in answer.stderr


@pytest.mark.slow
def test_list_does_not_load_rclpy(ros2: Ros2) -> None:
    for arguments in (["pkg", "list"], ["interface", "list"], ["pkg", "create", "-h"], ["run", "-h"]):
        answer = ros2(*arguments, PYTHONPROFILEIMPORTTIME="1")
        imported = {line.rsplit("|", 1)[-1].strip() for line in answer.stderr.splitlines()}
        assert answer.code == 0
        assert not imported & {"rclpy", "numpy", "yaml", "rosidl_parser"}, arguments
