"""The programs of turtlesim: a simulator that draws in the terminal, and three programs that drive turtles."""

from rclpy.qos import QoSProfile

TOPIC_QOS = QoSProfile(depth=7)
"""For every topic of a turtle."""
