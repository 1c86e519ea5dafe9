"""The verbs of `ros2 interface`."""
