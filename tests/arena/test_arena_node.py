"""An arena without ROS: nothing of the middleware is loaded, and asking for it is the grader's mistake."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from course.arena.arena_node import NoRos
from course.errors import OurFault
from course.evidence.timeline import Timeline

REPOSITORY = Path(__file__).parents[2]
PROGRAM = """
import sys
from pathlib import Path
from course.arena.arena import open_arena
from course.arena.home_programs import Surroundings
from course.evidence.packages import BuiltPackages
from course.evidence.timeline import Timeline

given = Surroundings({}, sys.executable, Path(sys.argv[1]))
with open_arena(Timeline(), BuiltPackages(), given, ros=False) as arena:
    assert arena.ros.graph.nodes == () and arena.ros.definitions == {}
print([name for name in sys.modules if name.startswith(("rclpy", "course.evidence.recorder"))])
"""


def test_nothing_of_ros_is_loaded(tmp_path: Path) -> None:
    command = [sys.executable, "-c", PROGRAM, str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=REPOSITORY)
    assert (done.stdout, done.stderr) == ("[]\n", "")


@pytest.mark.parametrize("name", ["subscribe", "publisher", "client"])
def test_a_scenario_that_asks_for_ros_is_our_fault(name: str) -> None:
    with pytest.raises(OurFault, match=name):
        getattr(NoRos(Timeline()), name)("/topic", "std_msgs/msg/String")
