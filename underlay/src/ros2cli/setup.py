"""Builds the package for colcon; it is used from its source folder without a build, too."""

from setuptools import find_packages, setup

NAME = "ros2cli"

setup(
    name=NAME,
    version="0.1.0",
    packages=find_packages(),
    package_data={"ros2cli.verbs.pkg": ["license_texts/*.txt"]},
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
        (f"share/{NAME}", ["package.xml", "README.md"]),
        (
            f"share/{NAME}/environment",
            ["completion/ros2-argcomplete.bash", "completion/ros2-argcomplete.zsh"],
        ),
    ],
    install_requires=["setuptools"],
    zip_safe=False,
    maintainer="ros2course authors",
    maintainer_email="authors@ros2course.invalid",
    description="The ros2 command for machines whose ROS 2 comes from pip.",
    license="MIT",
    entry_points={"console_scripts": ["ros2 = ros2cli.main:main"]},
)
