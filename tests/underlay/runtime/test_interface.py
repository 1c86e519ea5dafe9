"""`ros2 interface`, against what the real command prints."""

from __future__ import annotations

import pytest

from tests.underlay.runtime.captured import capture
from tests.underlay.runtime.command import Ros2
from tests.underlay.runtime.conftest import INTERFACES

CASES = [
    "interface_noverb",
    "interface_package_unknown",
    "interface_show_malformed",
    "interface_show_msg_nocomments",
    "interface_show_nested",
    "interface_show_srv",
    "interface_show_unknown_type",
]


@pytest.mark.parametrize("name", CASES)
def test_as_the_real_one(name: str, ros2: Ros2) -> None:
    case = capture(name)
    answer = ros2(*case.arguments)
    assert answer.stdout == case.stdout
    assert answer.stderr.replace(str(ros2.workspace), "<workspace>") == case.stderr
    assert answer.code == case.code


def test_as_the_real_one_but_for_the_comments(ros2: Ros2) -> None:
    """The definitions of example_interfaces are explained in words of our own."""
    case = capture("interface_show_std_string")
    answer = ros2(*case.arguments)
    assert (answer.code, answer.stderr) == (case.code, case.stderr)
    assert _fields(answer.stdout) == _fields(case.stdout) == ["string data"]


@pytest.mark.parametrize(
    "name", ["interface_list", "interface_list_s", "interface_packages", "interface_packages_m"]
)
def test_lists_have_what_is_installed_in_the_real_order(name: str, ros2: Ros2) -> None:
    case = capture(name)
    both = {*ros2("interface", "packages").stdout.splitlines()} & {
        *capture("interface_packages").stdout.splitlines()
    }
    real, ours = (
        [line for line in text.splitlines() if line.endswith(":") or _package(line) in both]
        for text in (case.stdout, ros2(*case.arguments).stdout)
    )
    assert ours == real
    assert len(real) > 5


@pytest.mark.parametrize("name", ["interface_proto_unknown", "interface_proto_unknown_pkg"])
def test_a_prototype_of_something_unknown_is_one_line(name: str, ros2: Ros2) -> None:
    """The real one prints a traceback."""
    case = capture(name)
    answer = ros2(*case.arguments)
    assert (answer.code, answer.stdout) == (case.code, "")
    assert answer.stderr == ros2("interface", "show", case.arguments[-1]).stderr
    assert answer.stderr.count("\n") == 1


def test_prototypes(ros2: Ros2) -> None:
    stamp = "  stamp:\n    sec: 0\n    nanosec: 0\n"
    answer = ros2("interface", "proto", "geometry_msgs/msg/PointStamped")
    assert answer.stdout == f"\"header:\n{stamp}  frame_id: ''\npoint:\n  x: 0.0\n  y: 0.0\n  z: 0.0\n\"\n"
    assert ros2("interface", "proto", "--no-quotes", "std_srvs/srv/SetBool").stdout == "data: false\n\n"


def test_package(ros2: Ros2) -> None:
    answer = ros2("interface", "package", INTERFACES)
    assert answer.stdout.splitlines() == [
        f"{INTERFACES}/msg/AmazingQuote",
        f"{INTERFACES}/srv/WhatIsThePoint",
    ]
    assert ros2("interface", "package", "-m", INTERFACES).stdout.count("\n") == 1
    assert ros2("interface", "package", "rclpy").stdout == ""


def test_show_reads_the_type_from_a_pipe(ros2: Ros2) -> None:
    answer = ros2("interface", "show", "-", text="std_srvs/srv/SetBool\n")
    assert answer.stdout == ros2("interface", "show", "std_srvs/srv/SetBool").stdout
    assert "bool success" in answer.stdout


def test_comments(ros2: Ros2) -> None:
    name = f"{INTERFACES}/msg/AmazingQuote"
    assert ros2("interface", "show", name).stdout.startswith("# A quote\nint32 id # which\nstring quote\n\n")
    assert "#" not in ros2("interface", "show", "--no-comments", name).stdout
    nested = ros2("interface", "show", "--all-comments", f"{INTERFACES}/srv/WhatIsThePoint").stdout
    assert "\t# A quote\n\tint32 id # which\n" in nested


def test_show_of_an_unknown_package(ros2: Ros2) -> None:
    answer = ros2("interface", "show", "nosuch_package/msg/Nosuch")
    assert (answer.code, answer.stdout, answer.stderr) == (1, "", "Unknown package 'nosuch_package'\n")


def _package(line: str) -> str:
    return line.strip().split("/")[0]


def _fields(definition: str) -> list[str]:
    return [line for line in definition.splitlines() if not line.startswith("#")]
