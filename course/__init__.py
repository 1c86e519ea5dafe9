"""ros2course: an interactive ROS 2 course and its autograder."""

__version__ = "0.1.0"
