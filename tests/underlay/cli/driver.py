"""Runs in namespaces of its own: starts nodes, then one command after the other, and tells what each did.

Reads {"nodes": [command line, ...], "cases": [...], "alone": bool}; a case is what `captured.Case.job` makes.
"""

from __future__ import annotations

import json
import os
import pty
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import Any

_PATIENCE = 60.0
_LOOK_EVERY = 0.01


def main() -> None:
    job = json.load(sys.stdin)
    with tempfile.TemporaryDirectory() as folder:
        _make_command(Path(folder))
        nodes = [subprocess.Popen(line, stderr=subprocess.DEVNULL) for line in job["nodes"]]
        try:
            _wait_for(nodes)
            results = [_run_case(case) for case in job["cases"]]
        finally:
            for node in nodes:
                node.kill()
            _run(["ros2", "daemon", "stop"])
    json.dump(results, sys.stdout)


def _make_command(folder: Path) -> None:
    """`ros2`, as an installation has it."""
    command = folder / "ros2"
    command.write_text(f'#!/bin/sh\nexec {sys.executable} -m ros2cli "$@"\n')
    command.chmod(0o755)
    os.environ["PATH"] = f"{folder}:{os.environ['PATH']}"


def _wait_for(nodes: list[subprocess.Popen[bytes]]) -> None:
    """The nodes take their time to start; what counts from then on is that a listing sees all of them."""
    end = time.monotonic() + _PATIENCE
    while _run(["ros2", "node", "list", "-c", "--no-daemon"])["stdout"].strip() != str(len(nodes)):
        if time.monotonic() > end or any(node.poll() is not None for node in nodes):
            raise SystemExit("the nodes did not start")


def _run_case(case: dict[str, Any]) -> dict[str, Any]:
    """A daemon that has just been started first learns who else is there: wait until it hears no more."""
    result = _run(**case)
    if case["words"][1:] == ["daemon", "start"]:
        before = None
        while (now := _run(["ros2", "topic", "list", "-v"])["stdout"]) != before:
            before = now
    return result


def _run(words: list[str], stop: dict[str, Any] | None = None, on_terminal: bool = False) -> dict[str, Any]:
    """Its exit code and what it printed."""
    heard: dict[str, list[str]] = {"stdout": [], "stderr": []}
    process, ends = (_on_terminal if on_terminal else _on_pipes)(words)
    readers = [
        threading.Thread(target=_read, args=[end, heard[name]])
        for name, end in zip(heard, ends, strict=False)
    ]
    for reader in readers:
        reader.start()
    _end(process, stop, heard)
    for reader in readers:
        reader.join(_PATIENCE)
    return {"code": process.returncode, **{name: "".join(parts) for name, parts in heard.items()}}


def _on_pipes(words: list[str]) -> tuple[subprocess.Popen[bytes], list[int]]:
    process = subprocess.Popen(
        words,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )
    assert process.stdout
    assert process.stderr
    return process, [process.stdout.fileno(), process.stderr.fileno()]


def _on_terminal(words: list[str]) -> tuple[subprocess.Popen[bytes], list[int]]:
    ours, its = pty.openpty()
    process = subprocess.Popen(words, stdin=its, stdout=its, stderr=its, start_new_session=True)
    os.close(its)
    return process, [ours]


def _read(end: int, parts: list[str]) -> None:
    while True:
        try:
            data = os.read(end, 1 << 16)
        except OSError:  # how a terminal tells that nobody writes any more
            return
        if not data:
            return
        parts.append(data.decode(errors="replace").replace("\r\n", "\n"))


def _end(process: subprocess.Popen[bytes], stop: dict[str, Any] | None, heard: dict[str, list[str]]) -> None:
    began = time.monotonic()
    while stop and process.poll() is None and time.monotonic() < began + _PATIENCE:
        if _is_time(stop, time.monotonic() - began, heard):
            number = getattr(signal, stop["signal"])
            os.killpg(process.pid, number) if stop["to_group"] else process.send_signal(number)
            break
        time.sleep(_LOOK_EVERY)
    try:
        process.wait(_PATIENCE)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def _is_time(stop: dict[str, Any], passed: float, heard: dict[str, list[str]]) -> bool:
    said = "".join(heard["stdout"])
    if stop["when"]:
        return bool(re.search(stop["when"], said + "".join(heard["stderr"])))
    late = 4 * stop["after"]
    return passed >= stop["after"] and (said.count("\n") >= stop["lines"] or passed >= late)


if __name__ == "__main__":
    main()
