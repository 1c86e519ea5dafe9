from setuptools import setup

NAME = 'python_package_that_uses_parameters_and_launch_files'

setup(
    name=NAME,
    version='0.1.0',
    packages=[NAME],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + NAME]),
        ('share/' + NAME, [
            'package.xml',
            'config/falcon.yaml',
            'launch/peanut_butter_falcon_quote_publisher_launch.py',
        ]),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='learner',
    maintainer_email='learner@todo.todo',
    description='Another right way',
    license='MIT',
    entry_points={'console_scripts': [
        'amazing_quote_configurable_publisher_node = '
        'python_package_that_uses_parameters_and_launch_files.amazing_quote_configurable_publisher_node:main',
    ]},
)
