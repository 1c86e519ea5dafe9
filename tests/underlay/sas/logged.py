"""Runs in a network of its own: has programs log values, and prints what is in the files, as JSON.

The command line is that of a C++ program that logs until it is killed.
"""

from __future__ import annotations

import json
import os
import signal
import struct
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from ament_index_python.packages import get_package_prefix
from sas_common import rclcpp_init, rclcpp_Node, rclcpp_shutdown
from sas_datalogger import DataloggerClient
from sas_datalogger.matfile import write_mat

_PATIENCE = 60.0
_MATRIX = np.array([[1, 2], [3, 4], [5, 6]])
_ROUNDS = 10


def log(client: DataloggerClient) -> None:
    client.log("matrix", _MATRIX)
    client.log("transposed", _MATRIX.T)
    client.log("vector", np.array([0.5, 1.5]))
    client.log("list", [1, 2, 3])
    client.log("number", 5)
    client.log("text", "from Python")


def errors(client: DataloggerClient) -> list[str]:
    found = []
    for value in (None, ["a"], np.zeros((1, 1, 1)), {"a": 1}):
        try:
            client.log("error", value)
        except TypeError as error:
            found.append(str(error))
    return found


def elements(data: bytes) -> Iterator[tuple[int, bytes]]:
    """Kind and content of each data element of a MAT-file of level 5."""
    while data:
        kind, size = struct.unpack_from("<II", data)
        yield kind, data[8 : 8 + size]
        data = data[8 + size + -size % 8 :]


def variable(matrix: bytes) -> tuple[str, Any]:
    (_, flags), (_, dimensions), (_, name), *contents = elements(matrix)
    shape = np.frombuffer(dimensions, "<i4")
    value: Any
    if flags[0] == 1:
        value = [variable(content)[1] for _, content in contents]
    elif flags[0] == 4:
        value = [
            "".join(map(chr, row)) for row in np.frombuffer(contents[0][1], "<u2").reshape(shape, order="F")
        ]
    else:
        value = np.frombuffer(contents[0][1], "<f8").reshape(shape, order="F").tolist()
    return name.decode(), value


def content(file: Path) -> dict[str, Any]:
    data = file.read_bytes()
    assert data[:6] == b"MATLAB"
    assert data[124:128] == b"\0\1IM"
    return dict(variable(matrix) for kind, matrix in elements(data[128:]) if kind == 14)


def logged(writer: list[str]) -> dict[str, Any]:
    """What the node wrote that two programs had log, and what the client in Python said."""
    client = DataloggerClient(rclcpp_Node("logger_in_python"))
    report: dict[str, Any] = {"before": client.is_enabled(), "errors": errors(client)}
    program = Path(get_package_prefix("sas_datalogger"), "lib/sas_datalogger/sas_datalogger_node.py")
    with (
        subprocess.Popen([program], stdout=subprocess.PIPE, text=True) as node,
        subprocess.Popen(writer, stdout=subprocess.PIPE, text=True) as other,
    ):
        assert other.stdout is not None
        report["other"] = other.stdout.readline()
        end = time.monotonic() + _PATIENCE
        while not client.is_enabled() and time.monotonic() < end:
            time.sleep(0.02)
        for _ in range(_ROUNDS):
            log(client)
            time.sleep(0.1)
        report["after"] = [client.is_enabled(), client.is_enabled(2)]
        node.send_signal(signal.SIGINT)
        report["said"], _ = node.communicate(timeout=_PATIENCE)
        other.kill()
    report |= {"code": node.returncode, "files": [file.name for file in Path().glob("*.mat")]}
    return {**report, "values": content(Path(report["files"][0]))}


def cells() -> dict[str, Any]:
    """What is in a file of values that are not alike."""
    file = Path("cells.mat")
    write_mat(
        str(file),
        {
            "sizes": [np.array([1.0]), np.array([2.0, 3.0])],
            "kinds": ["one", np.array([[1.0, 2.0], [3.0, 4.0]])],
            "texts": ["long", "x", "\N{GREEK SMALL LETTER PI}"],
            "cubes": [np.zeros((2, 3)), np.ones((2, 3))],
        },
    )
    return content(file)


def main() -> None:
    writer = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        rclcpp_init()
        report = {**logged(writer), "cells": cells()}
        rclcpp_shutdown()
        os.chdir("/")
    json.dump(report, sys.stdout)


if __name__ == "__main__":
    main()
