"""Swing all six joints of myrobot_1 by ten degrees."""


def main():
    """Wait for the robot, then send it 100 targets per second."""
    # TODO: the node, the client, q0, and the loop


if __name__ == '__main__':
    main()
