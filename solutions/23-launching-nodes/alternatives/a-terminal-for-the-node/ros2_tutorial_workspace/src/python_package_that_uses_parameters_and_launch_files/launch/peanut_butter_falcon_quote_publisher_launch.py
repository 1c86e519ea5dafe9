from launch import LaunchDescription
from launch.actions import GroupAction, TimerAction
from launch_ros.actions import Node

NAME = 'peanut_butter_falcon_quote_publisher_node'


def generate_launch_description():
    falcon = Node(
        output='screen',
        emulate_tty=True,
        package='python_package_that_uses_parameters_and_launch_files',
        executable='amazing_quote_configurable_publisher_node',
        name=NAME,
        parameters=[
            {'topic_name': 'truly_inspirational_quote', 'period': 0.25},
            {'quote': 'Friends are the family that one launches.', 'philosopher_name': 'Eleanor'},
        ],
    )
    return LaunchDescription([GroupAction([TimerAction(period=0.2, actions=[falcon])])])
