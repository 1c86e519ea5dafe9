"""`ros2 multicast`: one end sends until the other has heard it."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from tests.underlay.cli.place import Outcome, among, ros2, typed

_WAITING = "Waiting for UDP multicast datagram...\n"
_SENDING = "Sending one UDP multicast datagram...\n"
_ROUTE = "ip route add 224.0.0.0/4 dev lo 2>/dev/null"  # a network that only has a loopback has none

needs_ip = pytest.mark.skipif(shutil.which("ip") is None, reason="iproute2 is not installed")


@needs_ip
@pytest.mark.slow
@pytest.mark.parametrize("options", ["", "--group 225.0.0.2 --port 49151"])
def test_what_is_sent_is_received(options: str, workspace: Path) -> None:
    shell = (
        f"{_ROUTE}; said=$(mktemp); ros2 multicast receive {options} > $said & "
        f"until grep -q Received $said; do ros2 multicast send --ttl 1 {options}; sleep 0.1; done; "
        "wait; cat $said; rm $said"
    )
    (outcome,) = among([], [typed("bash", "-c", shell)], workspace)
    assert outcome.code == 0
    assert _SENDING in outcome.stdout
    assert re.search(rf"{re.escape(_WAITING)}Received from [\d.]+:\d+: 'Hello World!'\n$", outcome.stdout)


@needs_ip
@pytest.mark.slow
def test_waiting_is_stopped_with_ctrl_c(workspace: Path) -> None:
    case = typed("bash", "-c", f"{_ROUTE}; exec ros2 multicast receive", stop={"when": "Waiting"})
    assert among([], [case], workspace) == [Outcome(0, _WAITING, "")]


@pytest.mark.parametrize(
    ("words", "code", "complaint"),
    [
        ("send --group nosuch..group", 1, "No multicast to nosuch..group:49150: "),
        ("receive --port 70000", 1, "No multicast to 225.0.0.1:70000: "),
        ("receive --port 0", 2, "value must be a positive integer"),
    ],
)
def test_what_cannot_be(words: str, code: int, complaint: str) -> None:
    outcome = ros2("multicast", *words.split())
    assert outcome.code == code
    assert complaint in outcome.stderr
    assert "Traceback" not in outcome.stderr
