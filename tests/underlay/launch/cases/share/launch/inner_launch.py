import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, ThisLaunchFileDir
from launch_ros.actions import Node


def generate_launch_description():
    config = os.path.join(get_package_share_directory("telling"), "config", "params.yaml")  # noqa: PTH118

    return LaunchDescription(
        [
            DeclareLaunchArgument("robot_name", description="Name of the robot"),
            DeclareLaunchArgument("speed", default_value="1.5"),
            LogInfo(msg=["inner: ", LaunchConfiguration("robot_name"), " ", LaunchConfiguration("speed")]),
            LogInfo(msg=PathJoinSubstitution([ThisLaunchFileDir(), "..", "config"])),
            Node(
                package="telling",
                executable="tell",
                name=LaunchConfiguration("robot_name"),
                output="screen",
                parameters=[config, {"speed": LaunchConfiguration("speed")}],
            ),
        ]
    )
