import sys

import rclpy
from rclpy.context import Context
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.signals import SignalHandlerOptions

from .chatter import Chatterbox


def main():
    context = Context()
    rclpy.init(args=sys.argv, context=context, signal_handler_options=SignalHandlerOptions.ALL)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(Chatterbox(context=context))
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        return 130
    return 0
