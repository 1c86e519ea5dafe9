"""The tutorial's line becomes the one for the ROS 2 in use."""

from __future__ import annotations

from course.rosenv import find_ros, on_this_machine, setup_script

LINE = "source /opt/ros/jazzy/setup.bash\n"


def test_it_names_the_file_of_the_ros_in_use() -> None:
    assert on_this_machine(f"# first\n{LINE}") == f"# first\nsource {setup_script(find_ros())}\n"


def test_other_distributions_stay_as_they_are() -> None:
    other = LINE.replace("jazzy", "humble")
    assert on_this_machine(other) == other
