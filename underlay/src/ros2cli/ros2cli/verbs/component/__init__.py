"""The verbs of `ros2 component`."""
