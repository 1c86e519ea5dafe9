"""Starts the configurable publisher with the words of a falcon."""

from launch import LaunchDescription

# TODO 1: import Node from launch_ros.actions.


def generate_launch_description():
    """Describe what is started; `ros2 launch` calls this."""
    return LaunchDescription([
        # TODO 2: the Node of the exercise 22-launch.
    ])
