"""The line that makes ROS 2 ready, in the course's texts: the tutorial's, made true on this machine."""

from __future__ import annotations

import shlex
from collections.abc import Mapping

from course.errors import MissingHere
from course.rosenv.find import find_ros
from course.rosenv.setup_files import setup_script

INSTALLED = "/opt/ros/jazzy/setup.bash"


def on_this_machine(text: str, environ: Mapping[str, str] | None = None) -> str:
    """`text` with the setup.bash of the ROS 2 in use in the place of the one below /opt/ros.

    Unchanged where there is no ROS 2 at all.
    """
    if INSTALLED not in text:
        return text
    try:
        script = setup_script(find_ros(environ), environ)
    except MissingHere:
        return text
    return text.replace(INSTALLED, shlex.quote(str(script)))
