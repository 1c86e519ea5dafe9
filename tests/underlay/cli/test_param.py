"""`ros2 param load` with files that no node can be given."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.underlay.cli.place import among, typed

_NODE = "/amazing_quote_configurable_publisher_node"


@pytest.mark.slow
def test_files_that_cannot_be_loaded(tmp_path: Path, workspace: Path) -> None:
    texts = {"list": "- 1\n", "number": "5\n", "empty": "", "parameters": f"{_NODE}:\n  ros__parameters: 3\n"}
    for name, text in texts.items():
        (tmp_path / f"{name}.yaml").write_text(text)
    reasons = {
        "missing": "No such file",
        "list": "not a valid ROS",
        "number": "not a valid ROS",
        "empty": "not a valid ROS",
        "parameters": "not a valid ROS",
    }
    cases = [typed("ros2", "param", "load", _NODE, str(tmp_path / f"{name}.yaml")) for name in reasons]
    for outcome, (name, reason) in zip(among(["parameters"], cases, workspace), reasons.items(), strict=True):
        assert (outcome.code, outcome.stdout, outcome.stderr.count("\n")) == (1, "", 1), name
        assert reason in outcome.stderr, name
