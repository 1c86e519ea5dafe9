"""Simulated time for all nodes that follow."""

from __future__ import annotations

from typing import Any

from launch_ros.actions.set_parameter import SetParameter


class SetUseSimTime(SetParameter):
    def __init__(self, value: Any, **kwargs: Any) -> None:
        super().__init__("use_sim_time", value, **kwargs)
