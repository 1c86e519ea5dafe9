"""The tutorial's packages as colcon leaves them: the interfaces built, the nodes as scripts."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.shared import made_once
from tests.underlay.runtime.colcon import colcon_build, copy_interfaces
from tests.underlay.runtime.conftest import install, script

NODES = Path(__file__).with_name("nodes.py")
_EXECUTABLES = {
    "python_package_with_a_node": {"print_forever_node": "print_forever"},
    "python_package_that_uses_the_messages": {"amazing_quote_subscriber_node": "subscriber"},
    "python_package_that_uses_parameters_and_launch_files": {
        "amazing_quote_configurable_publisher_node": "parameters"
    },
}


def built_workspace(factory: pytest.TempPathFactory) -> Path:
    return made_once(factory, "workspace_of_the_tutorial", _build)


def _build(workspace: Path) -> None:
    (workspace / "src").mkdir(parents=True)
    copy_interfaces(workspace / "src")
    colcon_build(workspace)
    for package, executables in _EXECUTABLES.items():
        prefix = install(workspace, package)
        for name, kind in executables.items():
            script(prefix, name, f'#!/bin/sh\nexec python3 "{NODES}" {kind} "$@"\n')
