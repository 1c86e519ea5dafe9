"""`pytest graders/`, as documented: every grader with each of its checks."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
GRADERS = sorted((ROOT / "graders").glob("ch*.py"))
WITHOUT_ROS = """
import sys
sys.modules["rclpy"] = None
from pathlib import Path
from course.grading.load import load_module
for name in sys.argv[1:]:
    load_module(Path(name))
"""


def collected(where: str) -> list[str]:
    command = [sys.executable, "-m", "pytest", where, "--collect-only", "-q"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return [line for line in done.stdout.splitlines() if "::" in line]


@pytest.mark.slow
def test_the_folder_holds_what_its_files_hold() -> None:
    folder = collected("graders/")
    # A module with only questions has a Mystery and no Grader.
    files = [file for file in GRADERS if " = Grader(" in file.read_text("utf-8")]
    assert {line.split("::")[0] for line in folder} == {f.relative_to(ROOT).as_posix() for f in files}
    name = "graders/ch18_publishers_and_subscribers.py"
    assert collected(name) == [line for line in folder if line.startswith(name)]
    assert f"{name}::18-publisher::rate" in folder


def test_grader_modules_need_no_ros() -> None:
    """Recordings can be judged without ROS."""
    command = [sys.executable, "-c", WITHOUT_ROS, *map(str, GRADERS)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
