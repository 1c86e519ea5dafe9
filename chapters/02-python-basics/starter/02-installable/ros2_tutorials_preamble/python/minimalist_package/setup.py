"""Tells pip how to install this project."""
from setuptools import setup

setup(
    name="minimalist_package",
    version="0.1.0",
    description="A small package to learn with",
    # TODO 1: all packages: the package and its subpackage, but not the tests.
    packages=[],
    entry_points={
        "console_scripts": [
            # TODO 2: three commands, each "command = package.module:function".
        ],
    },
)
