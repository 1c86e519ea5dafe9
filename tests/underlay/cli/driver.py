"""Runs inside of the enclosure: starts nodes, then one command after the other, and tells what each did.

Reads {"nodes": [...], "script": path of nodes.py, "cases": [[arguments, seconds or null], ...]}.
"""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from typing import Any

_PATIENCE = 60.0


def main() -> None:
    job = json.load(sys.stdin)
    nodes = [
        subprocess.Popen([sys.executable, job["script"], kind], stderr=subprocess.DEVNULL)
        for kind in job["nodes"]
    ]
    try:
        _wait_for(len(nodes))
        results = [_run(arguments, interrupt_after) for arguments, interrupt_after in job["cases"]]
    finally:
        for node in nodes:
            node.kill()
        _run(["daemon", "stop"], None)
    json.dump(results, sys.stdout)


def _wait_for(count: int) -> None:
    """The nodes take their time to start; what counts from then on is that a listing sees all of them."""
    end = time.monotonic() + _PATIENCE
    while _run(["node", "list", "-c", "--no-daemon"], None)["stdout"].strip() != str(count):
        if time.monotonic() > end:
            raise SystemExit("the nodes did not start")


def _run(arguments: list[str], interrupt_after: float | None) -> dict[str, Any]:
    command = [sys.executable, "-m", "ros2cli", *arguments]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        out, err = process.communicate(timeout=interrupt_after or _PATIENCE)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=_PATIENCE)
    return {"code": process.returncode, "stdout": out, "stderr": err}


if __name__ == "__main__":
    main()
