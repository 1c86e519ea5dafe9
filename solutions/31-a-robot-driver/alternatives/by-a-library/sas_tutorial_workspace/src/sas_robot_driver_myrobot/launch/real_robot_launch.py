from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    limits = {
        'joint_limits_max': [360.0, 360.0, 360.0, 360.0, 360.0, 720.0],
        'joint_limits_min': [-360.0, -360.0, -360.0, -360.0, -360.0, -720.0],
    }
    others = {'ip': '127.0.0.1', 'thread_sampling_time_sec': 0.002}
    return LaunchDescription([
        Node(
            name='myrobot_1',
            package='sas_robot_driver_myrobot',
            executable='sas_robot_driver_myrobot_node',
            parameters=[limits, others],
            output='screen',
            emulate_tty=True,
        ),
    ])
