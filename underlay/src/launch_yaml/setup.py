"""Builds the package for colcon; it is used from its source folder without a build, too."""

from setuptools import find_packages, setup

NAME = "launch_yaml"

setup(
    name=NAME,
    version="0.1.0",
    packages=find_packages(),
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
        (f"share/{NAME}", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="ros2course authors",
    maintainer_email="authors@ros2course.invalid",
    description="Launch files in YAML, under the names that the real package has.",
    license="MIT",
)
