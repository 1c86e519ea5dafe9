import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

PACKAGE = 'python_package_that_uses_parameters_and_launch_files'


def generate_launch_description():
    falcon = os.path.join(get_package_share_directory(PACKAGE), 'falcon.yaml')
    return LaunchDescription([
        Node(
            executable='amazing_quote_configurable_publisher_node',
            package=PACKAGE,
            name='peanut_butter_falcon_quote_publisher_node',
            parameters=[falcon, {'philosopher_name': 'The other one'}],
            arguments=['--ros-args', '--log-level', 'info'],
        ),
    ])
