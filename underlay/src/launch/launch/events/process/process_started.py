"""A process runs."""

from launch.events.process.running_process_event import RunningProcessEvent


class ProcessStarted(RunningProcessEvent):
    name = "launch.events.process.ProcessStarted"
