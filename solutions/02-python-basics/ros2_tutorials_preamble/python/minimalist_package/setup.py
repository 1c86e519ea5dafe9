"""What pip needs to know in order to install this project."""
from setuptools import find_packages, setup

setup(
    name="minimalist_package",
    version="0.1.0",
    description="A small package to learn with",
    packages=find_packages(exclude=["test"]),
    entry_points={
        "console_scripts": [
            "minimalist_script = minimalist_package.minimalist_script:main",
            "async_await_example = minimalist_package.minimalist_async.async_await_example:main",
            "async_callback_example = minimalist_package.minimalist_async.async_callback_example:main",
        ],
    },
)
