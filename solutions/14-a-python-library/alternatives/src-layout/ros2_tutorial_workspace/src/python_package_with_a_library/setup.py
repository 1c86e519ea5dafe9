from setuptools import find_packages, setup

setup(
    name='python_package_with_a_library',
    packages=find_packages('src'),
    package_dir={'': 'src'},
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/python_package_with_a_library']),
        ('share/python_package_with_a_library', ['package.xml']),
    ],
    zip_safe=False,
)
