from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, LogInfo
from launch.launch_description_sources import AnyLaunchDescriptionSource, PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, ThisLaunchFileDir
from launch_ros.actions import PushRosNamespace
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    folder = PathJoinSubstitution([FindPackageShare("telling"), "launch"])
    return LaunchDescription(
        [
            DeclareLaunchArgument("robot", default_value="alpha"),
            GroupAction(
                actions=[
                    PushRosNamespace("fleet"),
                    IncludeLaunchDescription(
                        PythonLaunchDescriptionSource([folder, "/inner_launch.py"]),
                        launch_arguments={
                            "robot_name": LaunchConfiguration("robot"),
                            "speed": "2.0",
                        }.items(),
                    ),
                ]
            ),
            LogInfo(msg=["speed outside: ", LaunchConfiguration("speed", default="unset")]),
            IncludeLaunchDescription(
                PathJoinSubstitution([folder, "inner_launch.py"]), launch_arguments=[("robot_name", "beta")]
            ),
            LogInfo(msg=["robot_name outside: ", LaunchConfiguration("robot_name")]),
            IncludeLaunchDescription(
                AnyLaunchDescriptionSource([FindPackageShare("telling"), "/launch/inner_launch.xml"]),
                launch_arguments={"robot_name": "gamma"}.items(),
            ),
            LogInfo(msg=ThisLaunchFileDir()),
        ]
    )
