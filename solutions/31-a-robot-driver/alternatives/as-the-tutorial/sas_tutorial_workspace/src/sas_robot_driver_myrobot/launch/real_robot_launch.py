"""Start the driver of myrobot_1."""
from launch import LaunchDescription
from launch_ros.actions import Node

LIMITS = [360.0] * 5 + [720.0]


def generate_launch_description():
    """Return what to start: one driver, as if it wrote to a terminal."""
    driver = Node(
        package='sas_robot_driver_myrobot',
        executable='sas_robot_driver_myrobot_node',
        name='myrobot_1',
        output='screen',
        emulate_tty=True,
        parameters=[{
            'ip': '127.0.0.1',
            'joint_limits_min': [-limit for limit in LIMITS],
            'joint_limits_max': LIMITS,
            'thread_sampling_time_sec': 0.002,
        }],
    )
    return LaunchDescription([driver])
