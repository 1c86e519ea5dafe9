"""Start the configurable publisher with the words of a falcon."""

from launch import LaunchDescription

# TODO 1: import Node from launch_ros.actions.


def generate_launch_description():
    """Describe what to start. `ros2 launch` calls this function."""
    return LaunchDescription([
        # TODO 2: add the Node from the exercise 22-launch.
    ])
