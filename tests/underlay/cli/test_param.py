"""`ros2 param` with a node that has the tutorial's parameters."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.underlay.cli.place import CAPTURES, captured, ros2_among

pytestmark = pytest.mark.slow

_READING = (
    "param_list param_list_nodaemon param_list_node param_list_type param_list_unknown "
    "param_get param_get_bool param_get_double param_get_unknown_node param_describe "
    "param_describe_two param_describe_unknown_node param_describe_use_sim_time param_dump "
    "param_dump_unknown_node"
).split()
_WRITING = (
    "param_set param_set_int_for_double param_set_int_for_string param_set_quoted_yaml "
    "param_set_readonly_like param_set_undeclared param_set_unknown_node param_set_wrong_type "
    "param_delete_static param_load_other_node param_get_after"
).split()


def _compare(names: list[str]) -> None:
    cases = [captured(name) for name in names]
    typed = [[word.replace("<cwd>", str(CAPTURES)) for word in arguments] for arguments, _ in cases]
    outcomes = ros2_among(["parameters"], [(arguments, None) for arguments in typed])
    assert dict(zip(names, outcomes, strict=True)) == {n: o for n, (_, o) in zip(names, cases, strict=True)}


def test_reading() -> None:
    _compare(_READING)


def test_writing() -> None:
    _compare(_WRITING)


def test_files_that_cannot_be_loaded(tmp_path: Path) -> None:
    node = "/amazing_quote_configurable_publisher_node"
    (tmp_path / "list.yaml").write_text("- 1\n")
    files = [CAPTURES / "files/broken.yaml", tmp_path / "missing.yaml", tmp_path / "list.yaml"]
    outcomes = ros2_among(["parameters"], [(["param", "load", node, str(file)], None) for file in files])
    for outcome, reason in zip(outcomes, ("not valid YAML", "No such file", "not a valid ROS"), strict=True):
        assert (outcome.code, outcome.stdout, outcome.stderr.count("\n")) == (1, "", 1)
        assert reason in outcome.stderr
