import os
import subprocess
import sys
from pathlib import Path


def test_the_room_is_light_to_import() -> None:
    """Every command imports it; rclpy alone would take a tenth of a second, and numpy as much."""
    code = "import sys, course.rosenv; print(*sys.modules)"
    environ = {**os.environ, "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1"}
    command = [sys.executable, "-c", code]
    root = Path(__file__).parents[2]
    loaded = subprocess.run(command, env=environ, cwd=root, capture_output=True, check=True, text=True).stdout
    assert "course.rosenv.find" in loaded.split()
    assert {"rclpy", "numpy", "yaml", "rich", "typer", "pydantic", "importlib.metadata"}.isdisjoint(
        loaded.split()
    )
