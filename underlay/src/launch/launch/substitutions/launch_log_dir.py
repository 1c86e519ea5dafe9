"""The folder into which this launch writes its logs."""

from __future__ import annotations

from launch.launch_context import LaunchContext
from launch.substitution import Substitution


class LaunchLogDir(Substitution):
    def describe(self) -> str:
        return "LaunchLogDir()"

    def perform(self, context: LaunchContext) -> str:
        from launch.logging import launch_config

        return launch_config.log_dir
