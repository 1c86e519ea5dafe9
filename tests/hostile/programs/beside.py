"""Something that goes on beside the node, once it is there: `beside(act)` calls `act(node)` in a thread."""

import time


def beside(act):
    from rclpy.node import Node

    made, begin = [], Node.__init__

    def remember(node, *arguments, **named):
        begin(node, *arguments, **named)
        made.append(node)

    def wait():
        while not made:
            time.sleep(0.01)
        time.sleep(0.3)
        act(made[0])

    Node.__init__ = remember
    aside(wait)
