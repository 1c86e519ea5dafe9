"""Logs as fast as it can, to /rosout and the terminal. SIZE: words of each message."""


def flood(node):
    from itertools import count
    from time import sleep

    for turn in count():
        node.get_logger().info("flood " * SIZE)
        # While a call waits for a slow terminal, the node's timer waits, too.
        if turn % (1 + 100 // SIZE) == 0:
            sleep(0.001)


beside(flood)
