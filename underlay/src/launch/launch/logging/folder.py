"""The folder of one launch's log files."""

from __future__ import annotations

import datetime
import os
import socket
from pathlib import Path


def log_root() -> Path:
    """As rcl decides it: ROS_LOG_DIR, ROS_HOME/log, ~/.ros/log."""
    if os.environ.get("ROS_LOG_DIR"):
        return Path(os.environ["ROS_LOG_DIR"]).expanduser()
    home = os.environ.get("ROS_HOME") or str(Path.home() / ".ros")
    return Path(home).expanduser() / "log"


def fresh_folder() -> Path:
    """A new folder, named after the time, the machine and this process."""
    now = datetime.datetime.now().strftime("%Y-%m-%d-%H-%M-%S-%f")
    folder = log_root() / f"{now}-{socket.gethostname()}-{os.getpid()}"
    folder.mkdir(parents=True, exist_ok=True)
    return folder
