"""The verbs of `ros2 service`."""
