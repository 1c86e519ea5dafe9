"""What `ros2 topic hz` shows compared with the true rate, and what `ros2 topic echo` misses at 1 kHz.

The publisher follows a schedule by its own clock and reports afterwards what it really did. The output and
the truth are from the same run.
"""

from __future__ import annotations

import argparse
import json
import re
import signal
import subprocess
import sys
from pathlib import Path

from table import show

from course.isolation.levels import isolated
from course.rosenv import find_ros, node_environment, prepare

ROOT = Path(__file__).parents[1]
RATES = {2.0: 30.0, 50.0: 10.0, 500.0: 10.0, 1000.0: 10.0}  # Hz, and for how many seconds
PUBLISHER = """
import sys, time
import rclpy
from rclpy.qos import QoSProfile
from std_msgs.msg import Int64
rate, seconds = float(sys.argv[1]), float(sys.argv[2])
rclpy.init()
node = rclpy.create_node("source", start_parameter_services=False)
publisher = node.create_publisher(Int64, "/numbers", QoSProfile(depth=1000))
while publisher.get_subscription_count() == 0:
    time.sleep(0.01)
time.sleep(0.5)
sent, began = 0, time.monotonic()
while (due := began + sent / rate) < began + seconds:
    time.sleep(max(0.0, due - time.monotonic()))
    publisher.publish(Int64(data=sent))
    sent += 1
    last = time.monotonic()
time.sleep(0.5)  # until the last one has been shown
print(sent, (sent - 1) / (last - began), flush=True)
time.sleep(0.5)
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--inside", action="store_true", help=argparse.SUPPRESS)
    if parser.parse_args().inside:
        print(
            json.dumps({"hz": [hz(rate, seconds) for rate, seconds in RATES.items()], "echo": echo(1000.0)})
        )
        return
    found = in_namespaces()
    rows = [[f"{true:.2f}", f"{read:.3f}", f"{100 * (read / true - 1):+.2f} %"] for true, read in found["hz"]]
    show("ros2 topic hz", ("true rate (Hz)", "read", "off by"), rows)
    sent, rate, seen = found["echo"]
    show("ros2 topic echo", ("rate (Hz)", "sent", "shown"), [[f"{rate:.0f}", str(sent), str(seen)]])


def in_namespaces() -> dict[str, list]:
    ros = find_ros()
    prepare(ros)
    with isolated() as where:
        environment = {**node_environment(ros), **where.environment}
        environment["PYTHONPATH"] += f":{ROOT}"
        command = [*where.prefix, sys.executable, __file__, "--inside"]
        done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, check=True, text=True)
    return json.loads(done.stdout.splitlines()[-1])


def hz(rate: float, seconds: float) -> tuple[float, float]:
    """The true rate, and the last one that was shown."""
    (_, true), text = beside(rate, seconds, "hz", "/numbers")
    return true, float(re.findall(r"average rate: ([\d.]+)", text)[-1])


def echo(rate: float) -> tuple[int, float, int]:
    """How many messages were sent, how fast, and how many of them were shown in order."""
    (sent, true), text = beside(rate, RATES[rate], "echo", "--csv", "--qos-depth", "1000", "/numbers")
    numbers = [int(line) for line in text.split()]
    return sent, true, len(numbers) if numbers == sorted(set(numbers)) else -1


def beside(rate: float, seconds: float, *verb: str) -> tuple[tuple[int, float], str]:
    """What the publisher reports about itself, and what `ros2 topic <verb>` printed meanwhile."""
    source = [sys.executable, "-c", PUBLISHER, str(rate), str(seconds)]
    with subprocess.Popen(source, stdout=subprocess.PIPE, text=True) as publisher:
        watcher = subprocess.Popen(["ros2", "topic", *verb], stdout=subprocess.PIPE, text=True)
        sent, true = publisher.stdout.readline().split()
        watcher.send_signal(signal.SIGINT)
        text, _ = watcher.communicate(timeout=20)
    return (int(sent), float(true)), text


if __name__ == "__main__":
    main()
