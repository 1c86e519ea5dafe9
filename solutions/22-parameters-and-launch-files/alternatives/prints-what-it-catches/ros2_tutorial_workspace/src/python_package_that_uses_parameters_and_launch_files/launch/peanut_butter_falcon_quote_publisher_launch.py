from launch import LaunchDescription
from launch.actions import ExecuteProcess

PARAMETERS = {
    'topic_name': 'truly_inspirational_quote',
    'period': 0.25,
    'quote': 'There is no rule against two rafts.',
    'philosopher_name': 'Tyler',
}


def generate_launch_description():
    command = [
        'ros2', 'run', 'python_package_that_uses_parameters_and_launch_files',
        'amazing_quote_configurable_publisher_node',
        '--ros-args', '-r', '__node:=peanut_butter_falcon_quote_publisher_node',
    ]
    for name, value in PARAMETERS.items():
        command += ['-p', f'{name}:={value}']
    return LaunchDescription([ExecuteProcess(cmd=command, output='screen')])
