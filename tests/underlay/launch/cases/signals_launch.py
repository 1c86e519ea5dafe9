import signal

from launch import LaunchDescription
from launch.actions import EmitEvent, ExecuteProcess, LogInfo, RegisterEventHandler, Shutdown
from launch.event_handlers import OnProcessExit, OnProcessIO
from launch.events import matches_action
from launch.events.process import ShutdownProcess, SignalProcess, matches_name

SCRIPT = "trap 'echo told' USR1; echo ready; while :; do sleep 0.05; done"


def generate_launch_description():
    one = ExecuteProcess(cmd=["sh", "-c", SCRIPT], name="one", output="screen")
    two = ExecuteProcess(cmd=["sleep", "100"], name="two", output="screen")

    def on_stdout(event):
        if event.text == b"ready\n":
            return EmitEvent(
                event=SignalProcess(signal_number=signal.SIGUSR1, process_matcher=matches_action(one))
            )
        if b"told" in event.text:
            return EmitEvent(event=ShutdownProcess(process_matcher=matches_name("two-1")))

    return LaunchDescription(
        [
            two,
            one,
            RegisterEventHandler(OnProcessIO(target_action=one, on_stdout=on_stdout)),
            RegisterEventHandler(
                OnProcessExit(
                    target_action=two,
                    on_exit=lambda event, context: [
                        LogInfo(msg=f"{event.process_name} ended with {event.returncode}"),
                        Shutdown(reason="two has ended"),
                    ],
                )
            ),
        ]
    )
