"""A workspace with interfaces, built by colcon."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

from course.rosenv import find_ros, node_environment, prepare
from tests.underlay.runtime.command import PACKAGES, SOLUTIONS

EXAMPLES = PACKAGES / "example_interfaces"
# Of example_interfaces only these are compiled for the tests, for all of them take minutes.
COMPILED = ("msg/String.msg", "srv/AddTwoInts.srv", "action/Fibonacci.action")
_TIMEOUT = 600.0


def definitions() -> list[Path]:
    """Return all messages, services and actions of example_interfaces."""
    return sorted(file for kind in ("msg", "srv", "action") for file in (EXAMPLES / kind).iterdir())


def copy_interfaces(source: Path) -> None:
    """Lay package_with_interfaces of the tutorial and some of example_interfaces into a `src` folder."""
    interfaces = max(SOLUTIONS.glob("*/ros2_tutorial_workspace/src/package_with_interfaces"))
    shutil.copytree(interfaces, source / interfaces.name)
    _copy_some_examples(source / EXAMPLES.name)


def colcon_build(workspace: Path) -> None:
    """Build what is in `src`."""
    ros = find_ros()
    prepare(ros)
    command = [ros.python, "-m", "colcon", "build", "--cmake-args", f"-DPython3_EXECUTABLE={ros.python}"]
    environment = {**node_environment(ros), "COLCON_LOG_LEVEL": "error"}
    done = subprocess.run(
        command, cwd=workspace, env=environment, capture_output=True, text=True, timeout=_TIMEOUT, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr


def _copy_some_examples(folder: Path) -> None:
    for name in ("package.xml", *COMPILED):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(EXAMPLES / name, folder / name)
    others = {f'  "{file.parent.name}/{file.name}"' for file in definitions()} - {
        f'  "{name}"' for name in COMPILED
    }
    lines = (EXAMPLES / "CMakeLists.txt").read_text().splitlines()
    (folder / "CMakeLists.txt").write_text("\n".join(line for line in lines if line not in others))
