"""Starts the rover: its sensor and its controller."""

from launch import LaunchDescription

# TODO 1: import Node from launch_ros.actions.


def generate_launch_description():
    """Describe what is started. `ros2 launch` calls this function."""
    return LaunchDescription([
        # TODO 2: two Nodes, with the parameters of the task.
    ])
