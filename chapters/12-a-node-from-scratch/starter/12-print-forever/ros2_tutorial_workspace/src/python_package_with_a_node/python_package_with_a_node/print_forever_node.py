"""The node print_forever logs twice per second how many messages it has logged so far."""

# TODO 1: import rclpy, and the class Node from rclpy.node.


# TODO 2: write a class PrintForever that inherits from Node. Its __init__
#   - gives the node its name, print_forever,
#   - sets a count to zero,
#   - creates a timer of 0.5 seconds that calls a method of the class.
#   That method logs "Printed N times." at level INFO, and adds one to the count.


def main(args=None):
    """Run the node until Ctrl+C."""
    # TODO 3: start ROS, make the node, and spin it. End without a traceback on Ctrl+C.
    print('print_forever_node does nothing yet.')


if __name__ == '__main__':
    main()
