"""Start the driver as the robot myrobot_1."""

from launch import LaunchDescription


def generate_launch_description():
    """Return what to start. `ros2 launch` calls this function."""
    return LaunchDescription([
        # TODO: the node
    ])
