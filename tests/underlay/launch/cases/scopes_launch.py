from launch import LaunchDescription
from launch.actions import (
    AppendEnvironmentVariable,
    DeclareLaunchArgument,
    ExecuteProcess,
    GroupAction,
    LogInfo,
    PopLaunchConfigurations,
    PushLaunchConfigurations,
    SetEnvironmentVariable,
    SetLaunchConfiguration,
    UnsetEnvironmentVariable,
    UnsetLaunchConfiguration,
)
from launch.substitutions import EnvironmentVariable, LaunchConfiguration


def shown(name):
    return ExecuteProcess(
        cmd=["sh", "-c", "echo $COLOR $GREETING"], name=name, output="screen", additional_env={"X": "1"}
    )


def generate_launch_description():
    value = LaunchConfiguration("value", default="none")
    return LaunchDescription(
        [
            DeclareLaunchArgument("value", default_value="outer"),
            SetEnvironmentVariable(name="COLOR", value=["bl", "ue"]),
            SetEnvironmentVariable("GREETING", "hello"),
            GroupAction(
                [
                    SetEnvironmentVariable("COLOR", "red"),
                    UnsetEnvironmentVariable("GREETING"),
                    SetLaunchConfiguration("value", "inner"),
                    LogInfo(msg=["scoped: ", value]),
                    shown("scoped"),
                ]
            ),
            LogInfo(msg=["after: ", value]),
            GroupAction([SetLaunchConfiguration("value", "leaked")], scoped=False),
            LogInfo(msg=["unscoped: ", value]),
            GroupAction(
                [LogInfo(msg=["fresh: ", value, " ", LaunchConfiguration("given")]), shown("fresh")],
                scoped=True,
                forwarding=False,
                launch_configurations={"given": value},
            ),
            PushLaunchConfigurations(),
            UnsetLaunchConfiguration("value"),
            LogInfo(msg=["pushed: ", value]),
            PopLaunchConfigurations(),
            LogInfo(msg=["popped: ", value]),
            AppendEnvironmentVariable("GREETING", "world", separator="-"),
            AppendEnvironmentVariable(name="LISTED", value="first", prepend=True),
            LogInfo(msg=[EnvironmentVariable("GREETING"), " ", EnvironmentVariable("LISTED")]),
            LogInfo(msg=EnvironmentVariable("NOT_SET", default_value=["d", "efault"])),
            shown("last"),
        ]
    )
