"""sas_datalogger: programs in C++ and Python log values, and the node writes them into a MAT-file."""

from __future__ import annotations

import json
from typing import Any

import pytest

from tests.underlay.sas.built import program
from tests.underlay.sas.place import alone, python

pytestmark = pytest.mark.slow

VALUES = {
    "matrix": [[1, 2], [3, 4], [5, 6]],
    "transposed": [[1, 3, 5], [2, 4, 6]],
    "vector": [[0.5], [1.5]],
    "list": [1, 2, 3],
    "number": [5],
    "text": "from Python",
    "cpp_matrix": [[1, 2, 3], [4, 5, 6]],
    "cpp_vector": [1, 2, 3],
    "cpp_list": [4, 5],
    "cpp_number": [7],
    "cpp_text": "from C++",
}


@pytest.fixture(scope="module")
def report() -> dict[str, Any]:
    return dict(json.loads(alone(*python("logged.py"), program("logger_node"))))


@pytest.mark.parametrize("name", VALUES)
def test_every_value_is_in_the_file(name: str, report: dict[str, Any]) -> None:
    found = report["values"][name]
    assert found == [VALUES[name]] * len(found)
    assert found


def test_nothing_else_is_in_the_file(report: dict[str, Any]) -> None:
    assert {*report["values"]} == {*VALUES}


def test_ctrl_c_saves_a_file_with_the_date_and_ends_well(report: dict[str, Any]) -> None:
    (name,) = report["files"]
    assert name.startswith("sas_log_20")
    assert report["said"] == f"Saving log to filename = '{name}'.\n"
    assert report["code"] == 0


def test_clients_know_whether_anybody_logs(report: dict[str, Any]) -> None:
    assert (report["before"], report["after"], report["other"]) == (False, [True, False], "logs 0\n")


def test_what_cannot_be_logged_is_refused(report: dict[str, Any]) -> None:
    assert len(report["errors"]) == 4
    assert report["errors"][0].endswith("a vector or a matrix can be logged, not None.")


def test_values_that_are_not_alike_are_cells(report: dict[str, Any]) -> None:
    assert report["cells"] == {
        "sizes": [[[1]], [[2, 3]]],
        "kinds": [["one"], [[1, 2], [3, 4]]],
        "texts": ["long", "x   ", "\N{GREEK SMALL LETTER PI}   "],
        "cubes": [[[0] * 3] * 2, [[1] * 3] * 2],
    }
