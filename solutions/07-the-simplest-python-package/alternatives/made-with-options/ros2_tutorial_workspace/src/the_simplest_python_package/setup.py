from setuptools import find_packages, setup

package_name = 'the_simplest_python_package'

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
    maintainer='Ada Lovelace',
    maintainer_email='ada@example.com',
    description='Nothing yet',
    license='MIT-0',
    extras_require={'test': ['pytest']},
    entry_points={
        'console_scripts': [
            'a_node_too = the_simplest_python_package.a_node_too:main',
        ],
    },
)
