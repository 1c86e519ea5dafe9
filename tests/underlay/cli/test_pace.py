"""What `hz` measures, and what `echo` keeps up with."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.underlay.cli.place import among, typed

pytestmark = pytest.mark.slow


@pytest.mark.parametrize(("node", "rate"), [("calm", 2.0), ("brisk", 500.0)])
def test_hz_is_within_a_hundredth(node: str, rate: float, workspace: Path) -> None:
    stop = {"when": r"(?s)(average.*window.*){10}"}
    (outcome,) = among([node], [typed("ros2", "topic", "hz", "/counted", stop=stop)], workspace)
    assert float(re.findall(r"average rate: ([\d.]+)", outcome.stdout)[-1]) == pytest.approx(rate, rel=0.01)


def test_echo_keeps_up_with_a_kilohertz(workspace: Path) -> None:
    count = 5000
    stop = {"when": rf"data: {count - 1}\n---\n"}
    (outcome,) = among(["fast"], [typed("ros2", "topic", "echo", "/counted", stop=stop)], workspace)
    assert outcome.stdout == "".join(f"data: {number}\n---\n" for number in range(count))
    assert outcome.code == 2
