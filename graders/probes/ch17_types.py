"""Runs alongside the learner's programs: offers one endpoint of each type on the command line.

For the n-th type (from 0), that is a publisher on `/probe/tN` for a message, or a server `/probe/tN` for a
service. Its own findings are not trusted; the recorder reads the types' hashes from the graph.
"""

import contextlib
import importlib
import sys

import rclpy
from rclpy.node import Node


def offer(node: Node, index: int, name: str) -> None:
    package, kind, short = name.split("/")
    try:
        made = getattr(importlib.import_module(f"{package}.{kind}"), short)
    except (ImportError, AttributeError):
        print(f"missing {name}", flush=True)
        return
    if kind == "msg":
        node.create_publisher(made, f"/probe/t{index}", 10)
    else:
        node.create_service(made, f"/probe/t{index}", lambda request, response: response)


def main() -> None:
    rclpy.init()
    node = Node("type_probe", start_parameter_services=False, enable_rosout=False)
    for index, name in enumerate(sys.argv[1:]):
        offer(node, index, name)
    print("ready", flush=True)
    with contextlib.suppress(KeyboardInterrupt):
        rclpy.spin(node)


if __name__ == "__main__":
    main()
