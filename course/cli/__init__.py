"""The `ros2course` command: each file has a command (or a small family) that parses its words,
makes one call into the engine, renders the result, and ends with an exit code of `course.errors`.
"""
