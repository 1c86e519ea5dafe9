"""Starts the driver as the robot myrobot_1."""

from launch import LaunchDescription


def generate_launch_description():
    """Describe what is started; `ros2 launch` calls this."""
    return LaunchDescription([
        # TODO: the node
    ])
