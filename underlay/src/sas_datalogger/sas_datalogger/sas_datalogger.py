"""The node that logs: it keeps all values, and writes them into a file when it is interrupted."""

from __future__ import annotations

from datetime import datetime
from types import TracebackType

import numpy as np
import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions
from sas_msgs.msg import LogDatum

from sas_datalogger.matfile import Value, write_mat

# How many values may wait, for a client that logs many at once.
_WAITING = 100


class SASDatalogger(Node):
    """Values by their names, in the order in which they came. At the end of `with`, they are saved."""

    def __init__(self, node_name: str) -> None:
        super().__init__(node_name)
        self.data: dict[str, list[Value]] = {}
        self.create_subscription(LogDatum, "/sas_datalogger/log", self.log_callback, _WAITING)

    def __enter__(self) -> SASDatalogger:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        filename = f"sas_log_{datetime.now():%Y_%m_%d_%H_%M_%S}.mat"
        print(f"Saving log to filename = '{filename}'.", flush=True)
        self.save(filename)

    def save(self, filename: str) -> None:
        """Write all values so far, and forget them."""
        write_mat(filename, self.data)
        self.data = {}

    def log_callback(self, msg: LogDatum) -> None:
        self.data.setdefault(msg.name, []).append(_value(msg))


def _value(msg: LogDatum) -> Value:
    if not msg.value:
        return str(msg.strvalue)
    values = np.array(msg.value)
    return values.reshape(msg.layout) if len(msg.layout) == 2 else values


def main() -> None:
    # A wait has an end: Python handles Ctrl+C only between two of them.
    rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    executor = SingleThreadedExecutor()
    try:
        with SASDatalogger("sas_datalogger_node") as node:
            executor.add_node(node)
            while rclpy.ok():
                executor.spin_once(timeout_sec=0.1)
    except KeyboardInterrupt:
        pass
    rclpy.try_shutdown()
