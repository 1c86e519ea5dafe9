"""A process is to end: SIGINT, and more if that is not enough."""

from launch.events.process.process_targeted_event import ProcessTargetedEvent


class ShutdownProcess(ProcessTargetedEvent):
    name = "launch.events.process.ShutdownProcess"
