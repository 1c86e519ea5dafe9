from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node, SetParameter, SetParametersFromFile, SetRemap, SetUseSimTime
from launch_ros.parameter_descriptions import ParameterFile, ParameterValue
from launch_ros.substitutions import FindPackageShare, Parameter


def told(**more):
    return Node(package="telling", executable="tell", output="screen", **more)


def generate_launch_description():
    config = PathJoinSubstitution([FindPackageShare("telling"), "config", "params.yaml"])
    template = PathJoinSubstitution([FindPackageShare("telling"), "config", "template.yaml"])
    return LaunchDescription(
        [
            DeclareLaunchArgument("robot", default_value="r2"),
            DeclareLaunchArgument("which", default_value="robot"),
            DeclareLaunchArgument("rate", default_value="5"),
            SetParameter(name="color", value="green"),
            SetUseSimTime(True),
            GroupAction(
                [
                    SetParametersFromFile(config, node_name="first"),
                    SetRemap(src="scan", dst="base/scan"),
                    told(
                        name="first",
                        parameters=[{"from_scope": Parameter("color")}],
                        remappings=[("a", "b"), ("cmd_vel", ["/", LaunchConfiguration("robot"), "/cmd"])],
                    ),
                    told(name="second"),
                ]
            ),
            told(
                parameters=[
                    config,
                    ParameterFile(template, allow_substs=True),
                    {
                        "rate": LaunchConfiguration("rate"),
                        "rate_text": ParameterValue(LaunchConfiguration("rate"), value_type=str),
                        "pid": {"p": 1.0, "limits": [0, 10], "deep": {"er": ["a", "b"]}},
                        "list_of_substitutions": [LaunchConfiguration("robot"), "x"],
                        LaunchConfiguration("robot"): True,
                    },
                ],
            ),
        ]
    )
