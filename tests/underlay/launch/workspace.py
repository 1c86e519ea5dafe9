"""A workspace as colcon leaves it, with packages that the captures name."""

from __future__ import annotations

import shutil
from pathlib import Path

WITH_A_NODE = "python_package_with_a_node"
WITH_LAUNCH = "python_package_that_uses_parameters_and_launch_files"
LAUNCH_FILE = "peanut_butter_falcon_quote_publisher_launch.py"

# What the package `telling` shares besides.
_SHARED = Path(__file__).with_name("cases") / "share"

# A node as far as launch can see: it says what the real one had said by then, and dies of SIGINT.
_FOREVER = """#!/bin/sh
for i in 0 1 2; do
  echo "[INFO] [1795276996.286076376] [print_forever]: Printed $i times." >&2
  sleep 0.1
done
exec sleep 100
"""
_ONCE = """#!/bin/sh
echo "Hi from python_package_with_a_node."
"""
# Dies of the launch's SIGINT; a terminal's Ctrl+C it answers by ending well.
_QUIET = """#!/bin/sh
if [ -t 0 ]; then trap 'exit 0' INT; fi
if [ -n "$ENDS_WELL" ]; then trap 'exit 0' INT; : >"$ENDS_WELL"; fi
while :; do sleep 0.05; done
"""
# Tells what it was started with.
_TELL = """#!/bin/sh
for word in "$@"; do printf 'arg %s\\n' "$word"; done
while [ $# -gt 0 ]; do
  if [ "$1" = --params-file ]; then echo "begin $2"; sed 's/^/file /' "$2"; fi
  shift
done
"""
_LAUNCH = f"""from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(
            package="{WITH_LAUNCH}",
            executable="amazing_quote_configurable_publisher_node",
            name="peanut_butter_falcon_quote_publisher_node",
            parameters=[{{"quote": "Yeah, I am", "topic_name": "quotes"}}],
        ),
    ])
"""


def make_workspace(root: Path) -> Path:
    _program(root, WITH_A_NODE, "print_forever_node", _FOREVER)
    _program(root, WITH_A_NODE, "sample_python_node", _ONCE)
    _program(root, WITH_LAUNCH, "amazing_quote_configurable_publisher_node", _QUIET)
    _program(root, "telling", "tell", _TELL)
    shutil.copytree(_SHARED, root / "install/telling/share/telling", dirs_exist_ok=True)
    folder = root / "install" / WITH_LAUNCH / "share" / WITH_LAUNCH / "launch"
    folder.mkdir(parents=True)
    (folder / LAUNCH_FILE).write_text(_LAUNCH, encoding="utf-8")
    return root


def prefixes(root: Path) -> list[Path]:
    return [root / "install" / name for name in (WITH_A_NODE, WITH_LAUNCH, "telling")]


def _program(root: Path, package: str, name: str, text: str) -> None:
    prefix = root / "install" / package
    for folder in ("share/ament_index/resource_index/packages", f"lib/{package}", f"share/{package}"):
        (prefix / folder).mkdir(parents=True, exist_ok=True)
    (prefix / "share/ament_index/resource_index/packages" / package).touch()
    program = prefix / "lib" / package / name
    program.write_text(text, encoding="utf-8")
    program.chmod(0o755)
