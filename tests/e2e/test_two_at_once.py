"""Two checks at the same time hear only their own nodes."""

from __future__ import annotations

import json
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from .conftest import Run, lay

pytestmark = pytest.mark.slow
NODE = (
    "ros2_tutorial_workspace/src/python_package_that_uses_the_messages/"
    "python_package_that_uses_the_messages/amazing_quote_publisher_node.py"
)


def solved_home(run: Run, folder: Path) -> Path:
    run("init", str(folder))
    lay("17-a-package-for-interfaces", folder)
    lay("18-publishers-and-subscribers", folder)
    return folder


@pytest.mark.parametrize("mode", ["contained", "domain"])
def test_a_right_and_a_wrong_publisher(run: Run, guarded_home: Path, mode: str) -> None:
    option = "--namespaces" if mode == "contained" else "--no-namespaces"
    right, wrong = solved_home(run, guarded_home / "right"), solved_home(run, guarded_home / "wrong")
    file = wrong / NODE
    file.write_text(
        file.read_text(encoding="utf-8").replace("PERIOD = 0.5", "PERIOD = 0.3"), encoding="utf-8"
    )
    with ThreadPoolExecutor(3) as pool:
        checks = [
            pool.submit(run, "--home", str(home), "check", "18-publisher", "--json", option)
            for home in (right, wrong, right)
        ]
        verdicts = [verdict(check.result()) for check in checks]
    assert [found[0] for found in verdicts] == ["passed", "not passed", "passed"]
    assert verdicts[1][1] == ["rate"]
    assert {found[2] for found in verdicts} == {mode}


def verdict(done: subprocess.CompletedProcess[str]) -> tuple[str, list[str], str]:
    result = json.loads(done.stdout)
    failed = [check["id"] for check in result["checks"] if check["outcome"] == "failed"]
    return result["verdict"], failed, result["containment"]
