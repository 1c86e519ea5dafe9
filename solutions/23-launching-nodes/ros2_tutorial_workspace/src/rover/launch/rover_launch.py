"""Start the rover: its sensor and its controller."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """Describe what to start. `ros2 launch` calls this function."""
    return LaunchDescription([
        Node(
            package='rover',
            executable='range_sensor_node',
            output='screen',
            parameters=[{
                'distance': 2.0,
            }],
        ),
        Node(
            package='rover',
            executable='controller_node',
            output='screen',
            parameters=[{
                'stop_at': 0.8,
                'full_speed': 1.0,
            }],
        ),
    ])
