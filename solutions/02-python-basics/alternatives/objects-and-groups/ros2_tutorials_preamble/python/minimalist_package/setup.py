from setuptools import setup

NAME = "minimalist_package"
setup(
    name=NAME,
    version="0.0.1",
    packages=[NAME, f"{NAME}.minimalist_async"],
    entry_points={
        "console_scripts": [
            f"minimalist_script={NAME}.minimalist_script:main",
            f"async_await_example={NAME}.minimalist_async.async_await_example:main",
            f"async_callback_example={NAME}.minimalist_async.async_callback_example:main",
        ]
    },
)
