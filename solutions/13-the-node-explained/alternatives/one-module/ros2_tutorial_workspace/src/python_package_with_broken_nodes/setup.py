from setuptools import find_packages, setup

package_name = 'python_package_with_broken_nodes'

setup(
    name=package_name,
    version='0.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages',
            ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='learner',
    maintainer_email='learner@todo.todo',
    description='TODO: Package description',
    license='TODO: License declaration',
    extras_require={'test': ['pytest']},
    entry_points={
        'console_scripts': [
            'heartbeat_node = python_package_with_broken_nodes.nodes:heartbeat',
            'countdown_node = python_package_with_broken_nodes.nodes:countdown',
            'scanner_node = python_package_with_broken_nodes.nodes:scanner',
        ],
    },
)
