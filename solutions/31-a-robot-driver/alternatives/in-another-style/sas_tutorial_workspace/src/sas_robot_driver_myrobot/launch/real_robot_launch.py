from launch import LaunchDescription
from launch_ros.actions import Node

LIMITS = [360.0] * 5 + [720.0]


def generate_launch_description():
    description = LaunchDescription()
    description.add_action(Node(
        package='sas_robot_driver_myrobot',
        executable='sas_robot_driver_myrobot_node',
        name='myrobot_1',
        output='screen',
        parameters=[
            {'ip': '127.0.0.1', 'thread_sampling_time_sec': 0.002},
            {'joint_limits_min': [-limit for limit in LIMITS], 'joint_limits_max': LIMITS},
        ],
    ))
    return description
