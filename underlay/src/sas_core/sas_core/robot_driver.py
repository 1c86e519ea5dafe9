"""What a robot can be told to do. Drivers themselves are written in C++."""

from __future__ import annotations

from enum import Enum


class RobotDriver:
    """Contains the names that sas::RobotDriver has in C++ and that its clients use."""

    class Functionality(Enum):
        Unavailable = 0  # None in C++, which is a word of Python's own
        PositionControl = 1
        VelocityControl = 2
        ForceControl = 3
        Homing = 4
        ClearPositions = 5
