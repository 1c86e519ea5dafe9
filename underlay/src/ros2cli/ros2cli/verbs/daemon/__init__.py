"""The verbs of `ros2 daemon`."""
