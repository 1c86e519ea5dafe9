"""The `ros2course` command: each file has a command (or a small family) that parses its arguments,
makes one call into the engine, renders the result, and ends with an exit code from `course.errors`.
"""
