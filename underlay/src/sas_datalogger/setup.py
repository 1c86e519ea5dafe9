"""Names the program; CMake builds the package itself."""

from setuptools import setup

setup(
    name="sas_datalogger",
    version="0.1.0",
    packages=["sas_datalogger"],
    entry_points={
        "console_scripts": [
            "sas_datalogger_node.py = sas_datalogger.sas_datalogger:main",
        ],
    },
)
