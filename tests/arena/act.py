"""Runs with ROS: programs of a small package are run and launched in an arena; prints what was recorded."""

import json
import os
import sys
from pathlib import Path

from course.arena.arena import open_arena
from course.arena.home_programs import Surroundings
from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.recording import Recording
from course.evidence.timeline import Timeline
from course.rosenv import find_ros, node_environment

WAIT = 30.0
TALKER = """\
import signal, sys
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

rclpy.init()
node = Node('talker', automatically_declare_parameters_from_overrides=True)
try:
    print('ready', node.get_name(), flush=True)
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    if 'faulty' in node.get_name():
        raise
"""
LAUNCH = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('quote'),
        Node(package='talk', executable='talker', name='first', output='screen',
             parameters=[{'quote': LaunchConfiguration('quote')}]),
        Node(package='talk', executable='talker', name='faulty', output='screen'),
    ])
"""
STRINGS = {"plain": "hello", "number": "0.5", "truth": "true", "empty": "", "hard": 'say "hi": {häufig} #1'}
OTHERS = {"speed": 0.25, "whole": 2.0, "count": 3, "on": True, "sizes": [1.0, 2.0], "names": ["a", "1"]}

folder = Path(sys.argv[1])
prefix = folder / "install"


def write(name: str, text: str, mode: int = 0o644) -> None:
    file = prefix / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    file.chmod(mode)


write("lib/talk/talker", f"#!{sys.executable}\n{TALKER}", 0o755)
write("share/talk/launch/talk_launch.py", LAUNCH)
write("share/talk/launch/broken_launch.py", "from launch import LaunchDescription\n")
write("share/ament_index/resource_index/packages/talk", "")
write("share/talk/package.xml", "<package format='3'><name>talk</name></package>")

ros = find_ros()
isolation = {name: os.environ[name] for name in ("ROS_DOMAIN_ID", "ROS_AUTOMATIC_DISCOVERY_RANGE")}
environment = {**node_environment(ros, [prefix]), **isolation}
packages = BuiltPackages((BuiltPackage("talk", "src/talk", str(prefix), ("talker",)),))
found: dict[str, object] = {}
timeline = Timeline()

with open_arena(timeline, packages, Surroundings(environment, str(ros.python), folder / "scratch")) as arena:
    asked = arena.ros.parameters("/other")
    node = arena.run("talk", "talker", params={**STRINGS, **OTHERS}, node_name="other")
    found["available"] = arena.until(lambda: asked.available, timeout=WAIT, while_running=node)
    calls = asked.get(*STRINGS, *OTHERS)
    found["answered"] = arena.until(
        lambda: all(call.done for call in calls), timeout=WAIT, while_running=node
    )
    arena.interrupt(node)

    launched = arena.launch("talk", "talk_launch.py", quote="7 up")
    of_first = arena.ros.parameters("/first")
    found["launched"] = arena.until(
        lambda: arena.printed("ready") == 3 and of_first.available, timeout=WAIT, while_running=launched
    )
    call = of_first.get("quote")[0]
    arena.until(lambda: call.done, timeout=WAIT, while_running=launched)
    arena.interrupt(launched, grace=WAIT)

    for file in ("broken_launch.py", "no_launch.py"):
        arena.launch("talk", file).wait(WAIT)
    recording = Recording("x", timeline.events(), arena.ros.definitions)

found["parameters"] = {p.name: [p.type, p.value] for p in recording.parameters("/other").at().values()}
quote = recording.parameters("/first").get("quote")
found["quote"] = quote and [quote.type, quote.value]
view = recording.launched("talk_launch.py")
found["main"] = [view.main.exited and view.main.exited.code, view.error, len(view.left)]
found["processes"] = {name: process.exited is not None for name, process in view.processes.items()}
found["tracebacks"] = {name: lines[-1] for name, one in view.processes.items() if (lines := one.traceback())}
found["signals"] = [sent.signal for sent in view.main.signals]
found["broken"] = recording.launched("broken_launch.py").main.text
found["missing"] = recording.launched("no_launch.py").main.text
found["all"] = view.main.text
print(json.dumps(found))
