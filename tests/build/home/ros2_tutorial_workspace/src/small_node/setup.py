from setuptools import find_packages, setup

package_name = "small_node"

setup(
    name=package_name,
    version="0.1.0",
    packages=find_packages(exclude=["test"]),
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/" + package_name]),
        ("share/" + package_name, ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="Someone",
    maintainer_email="someone@example.com",
    description="One executable for the tests of the build",
    license="MIT",
    entry_points={
        "console_scripts": [
            "small_talker = small_node.talker:main",
            "small_listener = small_node.listener:main",
        ],
    },
)
