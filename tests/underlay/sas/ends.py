"""A client and a server of sas_robot_driver in Python, on one node each; prints one line per fact (JSON)."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable
from functools import partial
from typing import Any
from unittest.mock import patch

import numpy as np
import rclpy
from rclpy.impl.implementation_singleton import rclpy_implementation
from sas_common import rclcpp_init, rclcpp_Node, rclcpp_ok, rclcpp_shutdown, rclcpp_spin_some
from sas_core import RobotDriver
from sas_robot_driver import RobotDriverClient, RobotDriverServer

_PATIENCE = 60.0
Functionality = RobotDriver.Functionality


def tell(name: str, fact: Any) -> None:
    json.dump([name, fact], sys.stdout)
    print()


def error_of(action: Callable[[], object]) -> str:
    try:
        action()
    except (RuntimeError, TypeError) as error:
        return f"{type(error).__name__}: {error}"
    return "nothing"


def count(calls: list[int], number: int) -> None:
    calls[number] += 1


def main() -> None:
    tell("ok", rclcpp_ok())
    rclcpp_init()
    robot, program = rclcpp_Node("myrobot_1"), rclcpp_Node("program")
    server, client = RobotDriverServer(robot), RobotDriverClient(program, "myrobot_1")

    def until(condition: Callable[[], bool], action: Callable[[], None]) -> None:
        end = time.monotonic() + _PATIENCE
        while not condition():
            assert time.monotonic() < end
            action()
            rclcpp_spin_some(robot)
            rclcpp_spin_some(program)

    tell("prefixes", [server.get_topic_prefix(), client.get_topic_prefix()])
    tell("before", [client.is_enabled(mode) for mode in Functionality])
    tell("too early", [error_of(client.get_joint_positions), error_of(server.get_target_joint_positions)])
    tell("active", server.get_currently_active_functionality().name)

    def states() -> None:
        server.send_joint_states([1.0, 2.0], np.array([[3.0], [4.0]]), (5, 6))

    until(lambda: client.is_enabled(Functionality.ForceControl), states)
    tell("without limits", client.is_enabled())
    until(client.is_enabled, lambda: server.send_joint_limits(([-1, -2], [1, 2])))
    until(lambda: client.is_enabled(Functionality.Homing), lambda: server.send_home_state([0, 1]))
    read = (client.get_joint_positions(), client.get_joint_velocities(), client.get_joint_forces())
    tell(
        "read", [vector.tolist() for vector in (*read, *client.get_joint_limits(), client.get_home_states())]
    )
    tell("types", [str(read[0].dtype), str(client.get_home_states().dtype)])
    read[0][0] = 9.0
    tell("own copy", client.get_joint_positions().tolist())
    for no_vector in (1.0, [[1.0, 2.0]]):
        tell("no vector", error_of(partial(client.send_target_joint_positions, no_vector)))

    for mode, send in (
        (Functionality.PositionControl, client.send_target_joint_positions),
        (Functionality.VelocityControl, client.send_target_joint_velocities),
        (Functionality.ForceControl, client.send_target_joint_forces),
        (Functionality.Homing, client.send_homing_signal),
        (Functionality.ClearPositions, client.send_clear_positions_signal),
    ):
        until(lambda mode=mode: server.is_enabled(mode), lambda mode=mode, send=send: send([mode.value, 7]))
        tell("active", server.get_currently_active_functionality().name)
    heard = (
        server.get_target_joint_positions(), server.get_target_joint_velocities(),
        server.get_target_joint_forces(), server.get_homing_signal(), server.get_clear_positions_signal(),
    )  # fmt: skip
    tell("heard", [vector.tolist() for vector in heard])

    calls = [0, 0, 0]
    for number in range(len(calls)):
        program.create_timer(1e-6, partial(count, calls, number))
    rclcpp_spin_some(program)
    tell("one turn", calls)

    rclcpp_shutdown()
    rclcpp_shutdown()
    rclcpp_spin_some(program)
    client.send_target_joint_positions([1.0, 2.0])
    tell("ok", rclcpp_ok())
    rclcpp_init()
    for shutdown in (failing, beaten_by_ctrl_c):
        with patch.object(rclpy, "try_shutdown", shutdown):
            tell("shutdown", error_of(rclcpp_shutdown))


def beaten_by_ctrl_c() -> None:
    """rclpy's own, when the handler of a signal comes between its look and its deed."""
    context = rclpy.get_default_context().handle
    context.shutdown()
    context.shutdown()


def failing() -> None:
    raise rclpy_implementation.RCLError("no")


if __name__ == "__main__":
    main()
