from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, RegisterEventHandler, Shutdown
from launch.event_handlers import OnProcessIO
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, PushRosNamespace


def generate_launch_description():
    listener = Node(
        package="demo_nodes_py",
        executable="listener",
        name="ear",
        remappings=[("chatter", "words")],
        output="screen",
    )

    def on_stderr(event):
        if b"I heard" in event.text:
            return Shutdown(reason="heard")

    return LaunchDescription(
        [
            DeclareLaunchArgument("space"),
            GroupAction(
                [
                    PushRosNamespace(LaunchConfiguration("space")),
                    listener,
                    Node(
                        package="demo_nodes_py",
                        executable="talker",
                        remappings=[("chatter", "words")],
                        output="screen",
                    ),
                ]
            ),
            RegisterEventHandler(
                OnProcessIO(target_action=listener, on_stdout=on_stderr, on_stderr=on_stderr)
            ),
        ]
    )
