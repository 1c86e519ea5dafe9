"""Names the programs; CMake builds the package itself."""

from setuptools import setup

setup(
    name="turtlesim",
    version="1.8.2",
    packages=["turtlesim_programs"],
    entry_points={
        "console_scripts": [
            "turtlesim_node = turtlesim_programs.simulator:main",
            "turtle_teleop_key = turtlesim_programs.teleop:main",
            "draw_square = turtlesim_programs.draw_square:main",
            "mimic = turtlesim_programs.mimic:main",
        ],
    },
)
