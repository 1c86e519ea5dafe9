"""Logs as fast as it can, to /rosout and the terminal."""


def flood(node):
    while True:
        node.get_logger().info("flood " * SIZE)


beside(flood)
