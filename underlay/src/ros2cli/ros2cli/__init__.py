"""The `ros2` command. What a call does not need is not imported: see README.md."""
