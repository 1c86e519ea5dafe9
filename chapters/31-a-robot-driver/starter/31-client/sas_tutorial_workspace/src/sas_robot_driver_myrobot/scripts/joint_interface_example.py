"""Swing all six joints of myrobot_1 by ten degrees."""


def main():
    """Wait for the robot, then send it 100 targets per second."""
    # TODO: create the node and the client, read q0, and write the loop


if __name__ == '__main__':
    main()
