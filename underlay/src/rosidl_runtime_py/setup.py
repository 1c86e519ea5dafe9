from setuptools import find_packages, setup

package_name = "rosidl_runtime_py"

setup(
    name=package_name,
    version="0.13.0",
    packages=find_packages(),
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/" + package_name]),
        ("share/" + package_name, ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="ros2course authors",
    maintainer_email="authors@ros2course.invalid",
    description="Messages to YAML, CSV and dictionaries and back; finding interfaces by name.",
    license="MIT",
)
