"""The time from a publisher being ready to its first message in the recording, for many new publishers.

Ours has the arena's environment; its peer has the same, but with Fast DDS's default settings. Each runs in
its own network namespace.
"""

from __future__ import annotations

import argparse
import json
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from table import percentile, show

from course.isolation.levels import isolated
from course.rosenv import find_ros, node_environment, prepare

ROOT = Path(__file__).parents[1]
PUBLISHER = """
import sys, time
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node("talker", start_parameter_services=False)
publisher = node.create_publisher(String, sys.argv[1], 10)
print("ready", time.monotonic(), flush=True)
try:
    while True:
        publisher.publish(String(data="here"))
        time.sleep(0.001)
except BaseException:
    pass
"""
BATCH = 5
OURS = ("FASTDDS_BUILTIN_TRANSPORTS", "FASTRTPS_DEFAULT_PROFILES_FILE")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tries", type=int, default=200, help="of ours; the peer gets a fifth")
    parser.add_argument("--inside", type=int, help=argparse.SUPPRESS)
    parser.add_argument("--domain", action="store_true", help="without namespaces")
    options = parser.parse_args()
    if options.inside:
        print(json.dumps(first_messages(options.inside)))
        return
    ours = measured(options.tries, default=False, namespaces=not options.domain)
    peer = measured(max(1, options.tries // 5), default=True, namespaces=not options.domain)
    rows = [row("the arena", ours), row("Fast DDS's defaults", peer)]
    head = ("setting", "tries", "median", "90 %", "slowest")
    show("First message after the publisher is ready (s)", head, rows)


def row(name: str, values: list[float]) -> list[str]:
    figures = (median(values), percentile(values, 0.9), max(values))
    return [name, str(len(values)), *(f"{figure:.3f}" for figure in figures)]


def measured(tries: int, *, default: bool, namespaces: bool) -> list[float]:
    """Measure in batches, each in its own namespaces, as in a check."""
    batches = [min(BATCH, tries - start) for start in range(0, tries, BATCH)]
    return [delay for size in batches for delay in batch(size, default=default, namespaces=namespaces)]


def batch(tries: int, *, default: bool, namespaces: bool) -> list[float]:
    ros = find_ros()
    prepare(ros)
    with isolated(namespaces=namespaces) as where:
        environment = {**node_environment(ros), **where.environment, "PYTHONPATH": str(ROOT)}
        for name in OURS if default else ():
            del environment[name]
        command = [*where.prefix, sys.executable, __file__, "--inside", str(tries)]
        done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, check=True, text=True)
    return json.loads(done.stdout.splitlines()[-1])


def first_messages(tries: int) -> list[float]:
    """Runs inside the namespaces: one recorder, and one new publisher process after the other."""
    from course.evidence.recorder import Recorder
    from course.evidence.timeline import Timeline

    timeline = Timeline()
    delays = []
    with tempfile.NamedTemporaryFile("w", suffix=".py") as program, Recorder(timeline) as recorder:
        program.write(PUBLISHER)
        program.flush()
        for number in range(tries):
            listener = recorder.subscribe(f"/first/t{number}", "std_msgs/msg/String")
            command = [sys.executable, program.name, listener.topic]
            process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
            ready = float(process.stdout.readline().split()[1])
            if not timeline.wait_until(lambda listener=listener: listener.count > 0, 10):
                raise SystemExit(f"no message came on {listener.topic} within 10 s")
            # By our own clock, because the time in the message is when it was sent.
            delays.append(time.monotonic() - ready)
            process.send_signal(signal.SIGINT)  # it says goodbye, so nobody announces itself to it any more
            process.wait()
    return delays


if __name__ == "__main__":
    main()
