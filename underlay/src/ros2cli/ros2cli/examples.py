"""Lines that the help of a command shows, to be typed as they are."""

from __future__ import annotations

EXAMPLES: dict[str, tuple[str, ...]] = {
    "action send_goal": (
        'ros2 action send_goal -f /fibonacci example_interfaces/action/Fibonacci "order: 5"',
    ),
    "interface show": ("ros2 interface show geometry_msgs/msg/PointStamped",),
    "launch": (
        "ros2 launch my_package my_launch.py period:=0.5",
        "ros2 launch my_package my_launch.py --show-args",
    ),
    "node info": ("ros2 node info /talker",),
    "param get": ("ros2 param get /talker use_sim_time",),
    "param load": ("ros2 param load /talker talker.yaml",),
    "param set": ("ros2 param set /talker use_sim_time true",),
    "pkg create": (
        "ros2 pkg create my_package --build-type ament_python --node-name my_node",
        "ros2 pkg create my_interfaces --dependencies geometry_msgs",
    ),
    "run": (
        "ros2 run demo_nodes_py talker",
        "ros2 run demo_nodes_py talker --ros-args -r chatter:=news -p use_sim_time:=true",
    ),
    "service call": ('ros2 service call /add_two_ints example_interfaces/srv/AddTwoInts "{a: 1, b: 2}"',),
    "service echo": ("ros2 service echo --flow-style /add_two_ints",),
    "topic echo": (
        "ros2 topic echo /chatter",
        "ros2 topic echo --once --field data /chatter",
        'ros2 topic echo --filter "len(m.data) > 5" /chatter',
    ),
    "topic hz": ("ros2 topic hz -w 100 /chatter",),
    "topic pub": (
        'ros2 topic pub --once /chatter std_msgs/msg/String "data: Hello"',
        'ros2 topic pub -r 10 /chatter std_msgs/msg/String "{data: Hello}"',
    ),
}


def epilog(command: str) -> str | None:
    """The end of the help of a command, if there is an example of it."""
    lines = EXAMPLES.get(command)
    return "\n".join(["examples:", *(f"  {line}" for line in lines)]) + "\n" if lines else None
