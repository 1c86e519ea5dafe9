from setuptools import setup

setup(
    name='the_simplest_python_package',
    version='1.2.3',
    packages=['the_simplest_python_package'],
    data_files=[
        ('share/ament_index/resource_index/packages',
            ['resource/the_simplest_python_package']),
        ('share/the_simplest_python_package', ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
)
