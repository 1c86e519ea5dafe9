"""Arguments for nodes, as rcl reads them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from course.arena.command_lines import (
    ParameterValue,
    command_for,
    installed_executables,
    parameter_text,
    ros_args,
)


def test_nothing_is_given() -> None:
    assert ros_args() == ()
    assert ros_args({}, {}, "") == ()


def test_all_of_them() -> None:
    assert ros_args({"period": 0.25}, {"/a": "/b"}, "talker") == (
        "--ros-args", "-p", "period:=0.25", "-r", "/a:=/b", "-r", "__node:=talker",
    )  # fmt: skip


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ("0.5", '"0.5"'),
        ("true", '"true"'),
        ("", '""'),
        ('say "hi"\n', '"say \\"hi\\"\\n"'),
        ("häufig, 日本", '"häufig, 日本"'),
        (True, "true"),
        (False, "false"),
        (1, "1"),
        (2.0, "2.0"),
        (1e-7, "1e-07"),
        (float("inf"), ".inf"),
        (float("-inf"), "-.inf"),
        ([1.0, 2.5], "[1.0, 2.5]"),
        (["a", "1"], '["a", "1"]'),
    ],
)
def test_values(value: ParameterValue, text: str) -> None:
    assert parameter_text(value) == text


ELF = b"\x7fELF\x02\x01\x01"
ROS_PYTHON = "/ros/bin/python3"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    folder = tmp_path / "lib" / "talk"
    folder.mkdir(parents=True)
    return folder


def put(folder: Path, name: str, content: bytes = b"", mode: int = 0o755) -> Path:
    file = folder / name
    file.write_bytes(content)
    file.chmod(mode)
    return file


def test_a_package_without_programs(tmp_path: Path) -> None:
    assert installed_executables(tmp_path, "talk") == ()


def test_a_file_in_place_of_the_folder(tmp_path: Path) -> None:
    (tmp_path / "lib").mkdir()
    (tmp_path / "lib" / "talk").write_text("")
    assert installed_executables(tmp_path, "talk") == ()


def test_only_files_that_can_be_executed_count(tmp_path: Path, folder: Path) -> None:
    for name in ("talker", "listener"):
        put(folder, name)
    put(folder, "notes.txt", mode=0o644)
    (folder / "folder").mkdir()
    (folder / "broken").symlink_to("nowhere")
    (folder / "linked").symlink_to("talker")
    assert installed_executables(tmp_path, "talk") == ("linked", "listener", "talker")


@pytest.mark.parametrize(
    ("first_lines", "is_python"),
    [
        (b"#!/usr/bin/python3\n", True),
        (b"#!/usr/bin/python3.12\n", True),
        (b"#!/home/me/venv/bin/python\n", True),
        (b"#! /usr/bin/python3 -E\n", True),
        (b"#!/usr/bin/env python3\n", True),
        (b"#!/usr/bin/env -S python3 -u\n", True),
        (b"#!/usr/bin/python3\r\n", True),
        (b'#!"/a folder/bin/python3"\n', True),
        (b"#!/bin/sh\n'''exec' \"/a folder/bin/python3.11\" \"$0\" \"$@\"\n' '''\n", True),
        (b"#!/bin/sh\n'''exec' /" + b"long/" * 60 + b"bin/python3 \"$0\" \"$@\"\n' '''\n", True),
        (b"#!/bin/sh\nexec python3 -m talk\n", False),
        (b"#!/bin/bash\n# python3\n", False),
        (b"#!/usr/bin/env bash\n", False),
        (b"#!/usr/bin/perl /opt/python3\n", True),  # never seen, but harmless
        (b"#!/usr/bin/pythonesque\n", False),
        (b"#!\n", False),
        (b"#!\xff\xfe\n", False),
        (b"import rclpy\n", False),
        (ELF, False),
        (b"", False),
    ],
)
def test_a_python_script_is_started_by_the_python_of_this_ros(
    tmp_path: Path, folder: Path, first_lines: bytes, is_python: bool
) -> None:
    file = put(folder, "talker", first_lines + b"pass\n")
    expected = (ROS_PYTHON, str(file)) if is_python else (str(file),)
    assert command_for(tmp_path, "talk", "talker", ROS_PYTHON) == expected


def test_such_commands_run(tmp_path: Path, folder: Path) -> None:
    long = "#!/bin/sh\n'''exec' /no/such/python3 \"$0\" \"$@\"\n' '''\nprint('hello')\n"
    put(folder, "python", long.encode())
    put(folder, "shell", b"#!/bin/sh\necho hello\n")
    for name in ("python", "shell"):
        command = command_for(tmp_path, "talk", name, sys.executable)
        assert subprocess.run(command, capture_output=True, check=True).stdout == b"hello\n"
