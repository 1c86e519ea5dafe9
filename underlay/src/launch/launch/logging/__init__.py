"""Where a launch writes: the screen, and a folder of log files of its own."""

from __future__ import annotations

from launch.logging.config import LaunchConfig, launch_config, reset
from launch.logging.loggers import get_logger, get_output_loggers, log_launch_config

__all__ = [
    "LaunchConfig",
    "get_logger",
    "get_output_loggers",
    "launch_config",
    "log_launch_config",
    "reset",
]
