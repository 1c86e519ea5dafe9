"""Start the rover: its sensor and its controller."""

from launch import LaunchDescription

# TODO 1: import Node from launch_ros.actions.


def generate_launch_description():
    """Describe what to start. `ros2 launch` calls this function."""
    return LaunchDescription([
        # TODO 2: add two Nodes, with the parameters in the task.
    ])
