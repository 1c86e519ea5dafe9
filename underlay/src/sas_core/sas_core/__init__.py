"""The clock of a loop at a fixed rate, and its figures, under the names that SAS has in Python."""

from sas_core.clock import Clock
from sas_core.robot_driver import RobotDriver
from sas_core.statistics import Statistics

__all__ = ["Clock", "RobotDriver", "Statistics"]
