"""Start the configurable publisher with the words of a falcon."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """Describe what to start. `ros2 launch` calls this function."""
    return LaunchDescription([
        Node(
            package='python_package_that_uses_parameters_and_launch_files',
            executable='amazing_quote_configurable_publisher_node',
            name='peanut_butter_falcon_quote_publisher_node',
            output='screen',
            parameters=[{
                'topic_name': 'truly_inspirational_quote',
                'period': 0.25,
                'quote': 'Whoever shares a raft shares a story.',
                'philosopher_name': 'The Peanut Butter Falcon',
            }],
        ),
    ])
