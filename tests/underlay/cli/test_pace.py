"""What `hz` measures, and what `echo` keeps up with."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.underlay.cli.place import among, typed

pytestmark = pytest.mark.slow


@pytest.mark.parametrize(
    ("node", "rate", "reported"), [("calm", 2.0, r"1\.9[89]|2\.0[01]"), ("brisk", 500.0, r"49[5-9]|50[0-4]")]
)
def test_hz_is_within_a_hundredth(node: str, rate: float, reported: str, workspace: Path) -> None:
    """From the tenth report on: the longer it looks, the less it counts who was late when."""
    stop = {"when": rf"(average .*\n\tmin.*\n){{9,}}average rate: ({reported}).*\n\tmin"}
    (outcome,) = among([node], [typed("ros2", "topic", "hz", "/counted", stop=stop)], workspace)
    rates = [float(number) for number in re.findall(r"average rate: ([\d.]+)", outcome.stdout)]
    assert pytest.approx(rate, rel=0.01) in rates[9:]


def test_echo_keeps_up_with_a_kilohertz(workspace: Path) -> None:
    count = 5000
    stop = {"when": rf"data: {count - 1}\n---\n"}
    (outcome,) = among(["fast"], [typed("ros2", "topic", "echo", "/counted", stop=stop)], workspace)
    assert outcome.stdout == "".join(f"data: {number}\n---\n" for number in range(count))
    assert outcome.code == 2
