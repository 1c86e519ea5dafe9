from setuptools import find_packages, setup

package_name = 'python_package_that_uses_the_services'

setup(
    name=package_name,
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='learner',
    maintainer_email='learner@todo.todo',
    description='Another right way',
    license='MIT',
)
