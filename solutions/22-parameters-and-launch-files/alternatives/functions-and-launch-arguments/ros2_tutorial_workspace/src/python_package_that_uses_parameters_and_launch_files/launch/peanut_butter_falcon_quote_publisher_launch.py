from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

PACKAGE = 'python_package_that_uses_parameters_and_launch_files'


def generate_launch_description():
    ld = LaunchDescription()
    ld.add_action(DeclareLaunchArgument('period', default_value='0.25', description='in seconds'))
    ld.add_action(DeclareLaunchArgument(
        'topic_name', default_value='truly_inspirational_quote'))
    ld.add_action(DeclareLaunchArgument('philosopher_name', default_value='Zak'))
    falcon = Node(
        package=PACKAGE,
        executable='amazing_quote_configurable_publisher_node',
        name=['peanut_butter_falcon', '_quote_publisher_node'],
        parameters=[
            {'topic_name': LaunchConfiguration('topic_name')},
            {'period': ParameterValue(LaunchConfiguration('period'), value_type=float)},
            {
                'quote': 'Rule number one: party.',
                'philosopher_name': LaunchConfiguration('philosopher_name'),
            },
        ],
    )
    ld.add_action(LogInfo(msg='Taking off'))
    ld.add_action(falcon)
    return ld
