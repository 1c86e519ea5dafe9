"""`ros2 action send_goal`."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from typing import Any

from ros2cli.arguments import add_completed
from ros2cli.complete import action_names, action_types
from ros2cli.errors import CommandError

_LOOK_EVERY = 0.05


def add_arguments(parser: ArgumentParser) -> None:
    text = "Name of the ROS action (e.g. '/fibonacci')"
    add_completed(parser, "action_name", action_names, help=text)
    text = "Type of the ROS action (e.g. 'example_interfaces/action/Fibonacci')"
    add_completed(parser, "action_type", action_types, help=text)
    source = parser.add_mutually_exclusive_group()
    text = "Goal request values in YAML format (e.g. '{order: 10}')"
    source.add_argument("goal", nargs="?", default="{}", help=text)
    source.add_argument("--stdin", action="store_true", help="Read the goal from standard input")
    parser.add_argument("-f", "--feedback", action="store_true", help="Echo feedback messages for the goal")


def main(args: Namespace) -> int | str | None:
    from rclpy.action import ActionClient

    from ros2cli.node import own_node, wait_until
    from ros2cli.topic_type import full_topic_name
    from ros2cli.values import fill, from_yaml

    kind = _action_class(args.action_type)
    goal = kind.Goal()
    fill(goal, from_yaml(sys.stdin.read() if args.stdin else args.goal))
    with own_node(survives=True) as node:
        client = ActionClient(node, kind, full_topic_name(node, args.action_name))
        try:
            print("Waiting for an action server to become available...")
            wait_until(client.server_is_ready)
            return _send(args, node, client, goal)
        finally:
            client.destroy()


def _send(args: Namespace, node: Any, client: Any, goal: Any) -> str | None:
    print(f"Sending goal:\n     {_yaml(goal)}")
    handle = _result_of(node, client.send_goal_async(goal, _show_feedback if args.feedback else None))
    if not handle.accepted:
        print("Goal was rejected.")
        return None
    print(f"Goal accepted with ID: {bytes(handle.goal_id.uuid).hex()}\n")
    try:
        result = _result_of(node, handle.get_result_async())
    except KeyboardInterrupt:
        _cancel(node, handle)
        raise
    print(f"Result:\n    {_yaml(result.result)}\nGoal finished with status: {_status(result.status)}")
    return None


def _show_feedback(message: Any) -> None:
    print(f"Feedback:\n    {_yaml(message.feedback)}")


def _cancel(node: Any, handle: Any) -> None:
    """Nothing that nobody waits for anymore should be worked on."""
    print("Canceling goal...")
    response = _result_of(node, handle.cancel_goal_async())
    print("Goal canceled." if response.goals_canceling else "Failed to cancel goal")


def _result_of(node: Any, future: Any) -> Any:
    import rclpy

    while not future.done():
        # Nothing wakes a sleeping executor here when Ctrl+C is pressed.
        rclpy.spin_once(node, timeout_sec=_LOOK_EVERY)
    if future.result() is None:
        raise RuntimeError(f"Exception while sending goal: {future.exception()!r}")
    return future.result()


def _status(number: int) -> str:
    from action_msgs.msg import GoalStatus

    names = {getattr(GoalStatus, name): name for name in dir(GoalStatus) if name.startswith("STATUS_")}
    return names.get(number, "STATUS_UNKNOWN").removeprefix("STATUS_")


def _yaml(message: Any) -> str:
    from rosidl_runtime_py import message_to_yaml

    return str(message_to_yaml(message))


def _action_class(name: str) -> Any:
    from rosidl_runtime_py.utilities import get_action

    try:
        return get_action(name)
    except (AttributeError, ModuleNotFoundError, ValueError) as error:
        raise CommandError("The passed action type is invalid") from error
