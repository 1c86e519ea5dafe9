from launch import LaunchDescription
from launch.actions import (
    EmitEvent,
    ExecuteProcess,
    LogInfo,
    OpaqueFunction,
    RegisterEventHandler,
    TimerAction,
    UnregisterEventHandler,
)
from launch.event_handlers import (
    OnExecutionComplete,
    OnProcessExit,
    OnProcessIO,
    OnProcessStart,
    OnShutdown,
)
from launch.events import Shutdown
from launch.substitutions import FindExecutable, LocalSubstitution


def told(context):
    return [LogInfo(msg="from a function")]


def generate_launch_description():
    server = ExecuteProcess(
        name="server",
        cmd=["sh", "-c", "echo ready; trap 'echo bye; exit 0' INT; while :; do sleep 0.05; done"],
        output="screen",
    )
    client = ExecuteProcess(
        name="client", cmd=[[FindExecutable(name="echo"), " called | tr a-z A-Z"]], shell=True, output="both"
    )
    never = OnProcessStart(on_start=LogInfo(msg="never said"))

    def on_line(event):
        if b"ready" in event.text:
            return LogInfo(msg=f"{event.process_name} said {event.text.decode().strip()}")

    return LaunchDescription(
        [
            RegisterEventHandler(never),
            UnregisterEventHandler(never),
            RegisterEventHandler(
                OnProcessStart(target_action=server, on_start=[LogInfo(msg="server is up"), client])
            ),
            RegisterEventHandler(OnProcessIO(target_action=server, on_stdout=on_line)),
            RegisterEventHandler(
                OnExecutionComplete(
                    target_action=client,
                    on_completion=[LogInfo(msg="client is done"), OpaqueFunction(function=told)],
                )
            ),
            RegisterEventHandler(
                OnProcessExit(
                    target_action=client,
                    on_exit=TimerAction(
                        period=0.1, actions=[EmitEvent(event=Shutdown(reason="client has exited"))]
                    ),
                )
            ),
            RegisterEventHandler(
                OnShutdown(on_shutdown=LogInfo(msg=["asked to end: ", LocalSubstitution("event.reason")]))
            ),
            server,
        ]
    )
