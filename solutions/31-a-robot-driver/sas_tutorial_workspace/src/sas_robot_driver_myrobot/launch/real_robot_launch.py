"""Start the driver as the robot myrobot_1."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """Return what to start. `ros2 launch` calls this function."""
    return LaunchDescription([
        Node(
            package='sas_robot_driver_myrobot',
            executable='sas_robot_driver_myrobot_node',
            name='myrobot_1',
            output='screen',
            parameters=[{
                'ip': '127.0.0.1',
                'joint_limits_min': [-360.0, -360.0, -360.0, -360.0, -360.0, -720.0],
                'joint_limits_max': [360.0, 360.0, 360.0, 360.0, 360.0, 720.0],
                'thread_sampling_time_sec': 0.002,
            }],
        ),
    ])
