"""Runs in namespaces of its own: starts a driver, listens to it, commands it, and tells what it did.

Reads {"driver": [command line], "steps": [[name, argument...], ...]} and writes a report; both are JSON.
"""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from typing import IO, Any

import rclpy
from rclpy.node import Node
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray, Int32MultiArray

_PATIENCE = 60.0
_DEPTH = 5000
_ROBOT = "myrobot_1"
_HEARD = {
    "get/joint_states": JointState,
    "get/joint_positions_min": Float64MultiArray,
    "get/joint_positions_max": Float64MultiArray,
    "get/home_states": Int32MultiArray,
}
_TOLD = {
    "set/target_joint_positions": Float64MultiArray,
    "set/target_joint_velocities": Float64MultiArray,
    "set/homing_signal": Int32MultiArray,
}


class Witness(Node):
    def __init__(self, driver: subprocess.Popen[str]) -> None:
        super().__init__("witness")
        self.driver = driver
        self.last: dict[str, Any] = {}
        self.times: list[float] = []
        self.report: dict[str, Any] = {}
        for name, kind in _HEARD.items():
            self.create_subscription(
                kind, f"{_ROBOT}/{name}", lambda m, name=name: self._hear(name, m), _DEPTH
            )
        self.told = {
            name: self.create_publisher(kind, f"{_ROBOT}/{name}", 10) for name, kind in _TOLD.items()
        }

    def run(self, steps: list[list[Any]]) -> dict[str, Any]:
        for name, *arguments in steps:
            getattr(self, f"do_{name}")(*arguments)
        return self.report

    def do_hear(self, number: int) -> None:
        """Until that many joint states have come, and something of everything else."""
        self._until(lambda: len(self.times) >= number and len(self.last) == len(_HEARD))
        self.report["heard"] = {"number": len(self.times), "seconds": self.times[-1] - self.times[0]}
        first = self.last
        self.report["joint_states"] = [list(first["get/joint_states"].position)]
        for name in ("get/joint_positions_min", "get/joint_positions_max", "get/home_states"):
            self.report[name] = list(first[name].data)

    def do_graph(self) -> None:
        """The robot's own topics, as others see them."""
        by_node = (self.get_publisher_names_and_types_by_node, self.get_subscriber_names_and_types_by_node)
        found = [dict(names(_ROBOT, "/")) for names in by_node]
        self.report["graph"] = [
            {name: types for name, types in one.items() if name.startswith(f"/{_ROBOT}/")} for one in found
        ]

    def do_command(self, name: str, data: list[float]) -> None:
        """Send it until the robot is there, or has ended."""

        def there() -> bool:
            self.told[name].publish(_TOLD[name](data=data))
            return list(self.last["get/joint_states"].position) == data or self.driver.poll() is not None

        self._until(there)
        self.report["joint_states"].append(list(self.last["get/joint_states"].position))

    def do_say(self, name: str, data: list[float]) -> None:
        """Send it once, when the robot listens."""
        self._until(lambda: self.told[name].get_subscription_count() > 0)
        self.told[name].publish(_TOLD[name](data=data))

    def do_interrupt(self) -> None:
        self.driver.send_signal(signal.SIGINT)

    def do_end(self) -> None:
        self.report["code"] = self.driver.wait(_PATIENCE)

    def _hear(self, name: str, message: Any) -> None:
        self.last[name] = message
        if name == "get/joint_states":
            self.times.append(time.monotonic())

    def _until(self, condition: Callable[[], bool]) -> None:
        end = time.monotonic() + _PATIENCE
        while not condition():
            if time.monotonic() > end or self.driver.poll() is not None:
                raise SystemExit(f"waited in vain; so far: {self.report}, {sorted(self.last)}")
            rclpy.spin_once(self, timeout_sec=0.02)


def _text(file: IO[str]) -> str:
    file.seek(0)
    return file.read()


def main() -> None:
    job = json.load(sys.stdin)
    rclpy.init()
    with tempfile.TemporaryFile("w+") as out, tempfile.TemporaryFile("w+") as err:
        with subprocess.Popen(job["driver"], stdout=out, stderr=err, text=True) as driver:
            try:
                report = Witness(driver).run(job["steps"])
            except SystemExit:
                print(_text(out), _text(err), file=sys.stderr)
                raise
            finally:
                driver.kill()
        report |= {"stdout": _text(out), "stderr": _text(err)}
    rclpy.shutdown()
    json.dump(report, sys.stdout)


if __name__ == "__main__":
    main()
