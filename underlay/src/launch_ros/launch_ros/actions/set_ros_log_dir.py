"""Where nodes that follow write their logs."""

from __future__ import annotations

from typing import Any

from launch.actions.set_environment_variable import SetEnvironmentVariable


class SetROSLogDir(SetEnvironmentVariable):
    def __init__(self, new_log_dir: object, **kwargs: Any) -> None:
        super().__init__("ROS_LOG_DIR", new_log_dir, **kwargs)
