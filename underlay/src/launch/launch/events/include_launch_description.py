"""A launch description is to be taken in."""

from __future__ import annotations

from launch.event import Event
from launch.launch_description import LaunchDescription


class IncludeLaunchDescription(Event):
    name = "launch.events.IncludeLaunchDescription"

    def __init__(self, launch_description: LaunchDescription) -> None:
        self.__launch_description = launch_description

    @property
    def launch_description(self) -> LaunchDescription:
        return self.__launch_description
