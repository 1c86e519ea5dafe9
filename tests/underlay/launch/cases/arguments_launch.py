from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, LogInfo
from launch.conditions import IfCondition, LaunchConfigurationEquals, UnlessCondition
from launch.substitutions import LaunchConfiguration, PythonExpression, TextSubstitution
from launch_ros.actions import Node


def generate_launch_description():
    ns = LaunchConfiguration("ns")
    use_extra = LaunchConfiguration("use_extra")
    mode = LaunchConfiguration("mode")

    ns_arg = DeclareLaunchArgument("ns", default_value="turtle", description="Namespace")
    use_arg = DeclareLaunchArgument("use_extra", default_value="False", choices=["True", "False"])
    mode_arg = DeclareLaunchArgument("mode", default_value=TextSubstitution(text="slow"))
    late_arg = DeclareLaunchArgument("both", default_value=[ns, "/", mode])

    main = Node(
        package="telling",
        namespace=ns,
        executable="tell",
        name="sim",
        output="screen",
        arguments=["--mode", mode, ["joined-", ns]],
    )
    extra = ExecuteProcess(
        cmd=["echo", "extra", LaunchConfiguration("both")],
        output="screen",
        condition=IfCondition(PythonExpression(["'", ns, "' == 'robot' and ", use_extra])),
    )

    ld = LaunchDescription([ns_arg, use_arg, mode_arg, late_arg, main])
    ld.add_action(extra)
    ld.add_action(LogInfo(msg="plain", condition=UnlessCondition(use_extra)))
    ld.add_action(LogInfo(msg="fast", condition=LaunchConfigurationEquals("mode", "fast")))
    return ld
