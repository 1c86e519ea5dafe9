"""`python -m course` is the same as `ros2course`."""

from course.cli.main import run

if __name__ == "__main__":
    run()
