from launch import LaunchDescription
from launch.actions import ExecuteProcess, Shutdown, TimerAction


def generate_launch_description():
    return LaunchDescription(
        [
            ExecuteProcess(cmd=["sleep", "100"]),
            TimerAction(
                period=0.2, actions=[ExecuteProcess(cmd=["sh", "-c", "exit 3"], on_exit=[Shutdown()])]
            ),
            ExecuteProcess(cmd=["false"], respawn=True, respawn_delay=0.02, respawn_max_retries=2),
        ]
    )
