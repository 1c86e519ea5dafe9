"""On Ctrl+C, prints what rclpy prints when it fails in its own shutdown, and ends badly."""

import os
import signal

WORDS = """\
Traceback (most recent call last):
  File "/opt/ros/jazzy/lib/python3.12/site-packages/rclpy/executors.py", line 709, in _wait
    wait_set = _rclpy.WaitSet(
rclpy._rclpy_pybind11.RCLError: failed to initialize wait set: the given context is not valid
"""


def fail(number, frame):
    os.write(1, WORDS.encode())
    os._exit(1)


def listen():
    import rclpy

    begin = rclpy.init

    def begin_and_listen(*arguments, **named):
        begin(*arguments, **named)
        signal.signal(signal.SIGINT, fail)  # in place of rclpy's own

    rclpy.init = begin_and_listen


listen()
