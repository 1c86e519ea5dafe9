from setuptools import find_packages, setup

package_name = "demo_nodes_py"

setup(
    name=package_name,
    version="0.33.0",
    packages=find_packages(),
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/" + package_name]),
        ("share/" + package_name, ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="ros2course authors",
    maintainer_email="authors@ros2course.invalid",
    description="A publisher and a subscriber, a service's server and clients: nodes for trying things out.",
    license="MIT",
    entry_points={
        "console_scripts": [
            "talker = demo_nodes_py.topics.talker:main",
            "listener = demo_nodes_py.topics.listener:main",
            "add_two_ints_server = demo_nodes_py.services.add_two_ints_server:main",
            "add_two_ints_client = demo_nodes_py.services.add_two_ints_client:main",
            "add_two_ints_client_async = demo_nodes_py.services.add_two_ints_client_async:main",
        ],
    },
)
