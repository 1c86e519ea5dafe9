"""What the tools print when they fail, shortened."""

from __future__ import annotations


def refused(message: str) -> str:
    """What CMake prints if rosidl's adapter raises an exception."""
    wrapped = "\n".join(f"  {line}" for line in message.splitlines())
    return (
        "-- Found geometry_msgs: 5.3.6 (/ros/share/geometry_msgs/cmake)\n"
        "CMake Error at /ros/share/rosidl_adapter/cmake/rosidl_adapt_interfaces.cmake:57 (message):\n"
        f"  returned error code 1:\n\n{wrapped}\n\n"
        "Call Stack (most recent call first):\n"
        "  /ros/share/rosidl_cmake/cmake/rosidl_generate_interfaces.cmake:132 (rosidl_adapt_interfaces)\n"
        "  CMakeLists.txt:8 (rosidl_generate_interfaces)\n\n\n"
        "-- Configuring incomplete, errors occurred!\n"
    )


def processing(line: str, problem: str) -> str:
    return refused(
        f"Error processing '{line}' of 'small_interfaces/Landmark': '{problem}'\n\nTraceback (most\nrecent"
    )


def no_file(word: str) -> str:
    return (
        "CMake Error at /ros/share/rosidl_cmake/cmake/rosidl_generate_interfaces.cmake:95 (message):\n"
        f"  rosidl_generate_interfaces() the passed file '{word}' doesn't\n"
        "  exist relative to the CMAKE_CURRENT_SOURCE_DIR\n\n"
        "Call Stack (most recent call first):\n  CMakeLists.txt:8 (rosidl_generate_interfaces)\n"
    )
