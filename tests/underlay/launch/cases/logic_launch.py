from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, LogInfo, OpaqueFunction
from launch.conditions import IfCondition, LaunchConfigurationNotEquals, UnlessCondition
from launch.substitutions import (
    AndSubstitution,
    AnySubstitution,
    Command,
    EqualsSubstitution,
    IfElseSubstitution,
    LaunchConfiguration,
    NotEqualsSubstitution,
    NotSubstitution,
    OrSubstitution,
    PathJoinSubstitution,
    PythonExpression,
)


def launch_setup(context, *args, **kwargs):
    count = int(LaunchConfiguration("count").perform(context))
    return [LogInfo(msg=f"robot {number}") for number in range(count)]


def generate_launch_description():
    sim = LaunchConfiguration("sim")
    gui = LaunchConfiguration("gui")
    world = LaunchConfiguration("world")
    return LaunchDescription(
        [
            DeclareLaunchArgument("sim", default_value="true"),
            DeclareLaunchArgument("gui", default_value="false"),
            DeclareLaunchArgument("world", default_value="empty"),
            DeclareLaunchArgument("count", default_value="2"),
            LogInfo(msg="sim and gui", condition=IfCondition(AndSubstitution(sim, gui))),
            LogInfo(msg="sim or gui", condition=IfCondition(OrSubstitution(sim, gui))),
            LogInfo(msg="no gui", condition=IfCondition(NotSubstitution(gui))),
            LogInfo(msg="any", condition=IfCondition(AnySubstitution(gui, "false", sim))),
            LogInfo(msg="empty world", condition=IfCondition(EqualsSubstitution(world, "empty"))),
            LogInfo(msg="other world", condition=IfCondition(NotEqualsSubstitution(world, "empty"))),
            LogInfo(msg="not x", condition=LaunchConfigurationNotEquals("world", "x")),
            LogInfo(
                msg="more", condition=IfCondition(PythonExpression([LaunchConfiguration("count"), " > 1"]))
            ),
            GroupAction([LogInfo(msg="grouped")], condition=UnlessCondition(gui)),
            LogInfo(msg=["quality: ", IfElseSubstitution(gui, if_value="high", else_value="low")]),
            LogInfo(msg=PathJoinSubstitution(["/worlds", [world, ".sdf"]])),
            LogInfo(msg=Command(["printf ", "'%s' ", world])),
            OpaqueFunction(function=launch_setup),
        ]
    )
