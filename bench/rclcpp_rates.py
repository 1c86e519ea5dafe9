"""How many messages a second go through rclcpp, rclpy and rcl itself; what a node costs to compile and start.

Messages come in bursts of a hundred. The next burst begins after the receiver has confirmed the last message
of the previous one, so nothing is lost and all do the same work. C++ programs are compiled like a learner's,
without optimization. Everything runs in separate namespaces, in turns.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from statistics import median

from table import show

from course.build.builder import build
from course.build.store import Store
from course.build.underlay_build import build_underlay
from course.build.workspace import Workspace
from course.isolation.levels import isolated
from course.rosenv import find_ros, node_environment, prepare, underlay_builds

ROOT = Path(__file__).parents[1]
PACKAGES = (ROOT / "underlay/src/rclcpp", ROOT / "bench/rclcpp_programs")
TIMEOUT = 120.0
HELLO = {
    "package.xml": """\
<package format="3">
  <name>hello</name><version>0.0.0</version><description>A node</description>
  <maintainer email="nobody@example.com">nobody</maintainer><license>none</license>
  <buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend>
  <export><build_type>ament_cmake</build_type></export>
</package>
""",
    "CMakeLists.txt": """\
cmake_minimum_required(VERSION 3.8)
project(hello)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
add_executable(hello src/hello.cpp)
target_link_libraries(hello rclcpp::rclcpp)
install(TARGETS hello DESTINATION lib/hello)
ament_package()
""",
    "src/hello.cpp": """\
#include "rclcpp/rclcpp.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("hello");
  RCLCPP_INFO(node->get_logger(), "Hello!");
  rclcpp::spin(node);
  rclcpp::shutdown();
}
""",
}
RCLPY = """
import sys, time
import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from std_msgs.msg import Int64
BURST = 100
role, seconds = sys.argv[1], float(sys.argv[2])
rclpy.init()
executor = SingleThreadedExecutor()
state = {"sent": 0, "began": 0.0}
if role != "hear":
    sayer = rclpy.create_node("sayer")
    numbers = sayer.create_publisher(Int64, "numbers", 1000)
    def say():
        for _ in range(BURST):
            numbers.publish(Int64(data=state["sent"]))
            state["sent"] += 1
    def thanked(message):
        passed = time.monotonic() - state["began"]
        if passed < seconds:
            say()
        else:
            print(round(state["sent"] / passed), flush=True)
            rclpy.shutdown()
    thanks = sayer.create_subscription(Int64, "thanks", thanked, 10)
    def begin():
        if numbers.get_subscription_count() and sayer.count_publishers("thanks"):
            timer.cancel()
            state["began"] = time.monotonic()
            say()
    timer = sayer.create_timer(0.01, begin)
    executor.add_node(sayer)
if role != "say":
    hearer = rclpy.create_node("hearer")
    thanking = hearer.create_publisher(Int64, "thanks", 10)
    def heard(message):
        if (message.data + 1) % BURST == 0:
            thanking.publish(message)
    hearing = hearer.create_subscription(Int64, "numbers", heard, 1000)
    executor.add_node(hearer)
try:
    executor.spin()
except ExternalShutdownException:
    pass
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=3.0, help="for how long each one publishes")
    parser.add_argument("--rounds", type=int, default=5, help="how often each one is measured")
    parser.add_argument("--inside", metavar="FOLDER", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.inside:
        print(json.dumps(measured(Path(options.inside), options.seconds, options.rounds)))
        return
    found = in_namespaces(options.seconds, options.rounds)
    floor = {place: median(rates) for place, rates in found["floor"].items()}
    peer = {place: median(rates) for place, rates in found["rclpy"].items()}
    rows = [
        [place, who, f"{median(rates):.0f}", f"{median(rates) / peer[place]:.1f}",
         f"{median(rates) / floor[place]:.2f}"]
        for place in ("one process", "two processes")
        for who, rates in ((who, found[who][place]) for who in ("rclpy", "rclcpp", "floor"))
    ]  # fmt: skip
    show("messages a second", ("where", "with", "rate", "times rclpy", "of the floor"), rows)
    costs = [[name, f"{seconds:.2f}"] for name, seconds in (found["costs"] | hello_builds()).items()]
    show("what a node costs", ("step", "seconds (CPU for the compiler)"), costs)


def hello_builds() -> dict[str, float]:
    """Seconds until a package with one small node is built."""
    ros = find_ros()
    build_underlay(["rclcpp"], ros)
    with tempfile.TemporaryDirectory() as scratch:
        folder, store = Path(scratch, "hello"), Store(Path(scratch, "store"))
        for name, text in HELLO.items():
            (folder / "src/hello" / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / "src/hello" / name).write_text(text)
        source = folder / "src/hello/src/hello.cpp"
        found = {}
        for step in ("cold", "one file changed", "unchanged"):
            if step == "one file changed":
                source.write_text(source.read_text().replace("Hello!", "Hello again!"))
            began = time.monotonic()
            outcome = build(Workspace.scan(folder, trusted=True), ["hello"], ros, store)
            found[f"build a small node, {step}"] = time.monotonic() - began
            if outcome.failure is not None:
                raise SystemExit(outcome.failure.feedback.summary)
        return found


def in_namespaces(seconds: float, rounds: int) -> dict[str, dict]:
    ros = find_ros()
    prepare(ros)
    with tempfile.TemporaryDirectory() as folder, isolated() as where:
        (Path(folder) / "src").mkdir()
        for package in PACKAGES:
            (Path(folder) / "src" / package.name).symlink_to(package)
        workspace = Workspace.scan(Path(folder), trusted=True)
        outcome = build(workspace, ["rclcpp_programs"], ros, Store(underlay_builds(ros)), time_limit=1800.0)
        if outcome.failure is not None:
            raise SystemExit(outcome.failure.feedback.summary)
        prefixes = [package.prefix for package in reversed(outcome.packages)]
        environment = {**node_environment(ros, prefixes), **where.environment}
        environment["PYTHONPATH"] += f":{ROOT}"
        command = [*where.prefix, sys.executable, __file__, "--inside", prefixes[0] / "lib/rclcpp_programs"]
        command += ["--seconds", str(seconds), "--rounds", str(rounds)]
        done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, check=True, text=True)
    return json.loads(done.stdout.splitlines()[-1])


def measured(programs: Path, seconds: float, rounds: int) -> dict[str, dict]:
    commands = {
        "rclpy": [sys.executable, "-c", RCLPY],
        "rclcpp": [str(programs / "node")],
        "floor": [str(programs / "floor")],
    }
    rates: dict[str, dict] = {who: {"one process": [], "two processes": []} for who in commands}
    for _ in range(rounds):
        for who, command in commands.items():
            rates[who]["one process"].append(rate([*command, "both", str(seconds)]))
            with running([*command, "hear", "0"]):
                rates[who]["two processes"].append(rate([*command, "say", str(seconds)]))
    rates["costs"] = {
        "compile a node, -O0": compiled("-O0"),
        "compile a node, -O2": compiled("-O2"),
        "start, until its first message is back": median(started(commands["rclcpp"]) for _ in range(9)),
        "the same with rcl's functions alone": median(started(commands["floor"]) for _ in range(9)),
    }
    return rates


def rate(command: list[str]) -> float:
    done = subprocess.run(command, stdout=subprocess.PIPE, check=True, text=True, timeout=TIMEOUT)
    return float(done.stdout)


@contextmanager
def running(command: list[str]) -> Iterator[None]:
    with subprocess.Popen(command) as process:
        try:
            yield
        finally:
            process.kill()


def compiled(optimization: str) -> float:
    """Seconds of CPU that the compiler takes for node.cpp."""
    folders = [f"-I{folder}" for prefix in os.environ["CMAKE_PREFIX_PATH"].split(":")
               for folder in Path(prefix, "include").glob("*") if folder.is_dir()]  # fmt: skip
    source = PACKAGES[1] / "src/node.cpp"
    before = os.times()
    subprocess.run(["g++", "-std=c++17", optimization, "-c", "-o", os.devnull, *folders, source], check=True)
    after = os.times()
    return (after.children_user + after.children_system) - (before.children_user + before.children_system)


def started(command: list[str]) -> float:
    """Seconds until a publishing node has reported, minus the time for which it had to publish."""
    began = time.monotonic()
    rate([*command, "both", "0"])
    return time.monotonic() - began


if __name__ == "__main__":
    main()
