"""The node node_that_uses_the_library: it tries out the library, twice per second."""

# TODO 1: import what you need: rclpy and Node, random and string, and from the
#   library SampleClass and sample_function_for_square_of_sum.


# TODO 2: write a class that derives from Node, gives the node its name,
#   node_that_uses_the_library, and has a timer of 0.5 seconds. Each time, it
#   - draws A from 0 to 1 and B from 1 to 2, hands both to the function, and logs
#     A, B and what came back,
#   - draws a name of ten letters, makes a SampleClass of it, and logs what its
#     get_name() returns.


def main(args=None):
    """Run the node until Ctrl+C."""
    # TODO 3: start ROS, make the node, and spin it. End quietly on Ctrl+C.
    print('node_that_uses_the_library does nothing yet.')


if __name__ == '__main__':
    main()
