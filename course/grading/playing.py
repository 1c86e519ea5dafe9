"""What a mystery needs to be played on the learner's own ROS."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping

from course.arena.play import TALK
from course.build import Store
from course.content import Exercise
from course.grading.reference import reference_packages
from course.grading.workers import workers
from course.rosenv import Ros, node_environment, prepare

# In a classroom, nobody is to find the neighbour's mystery.
_OWN_MACHINE = {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}


def play_environment(
    exercise: Exercise,
    ros: Ros,
    *,
    store: Store | None = None,
    on_progress: Callable[[str], None] = lambda text: None,
    environ: Mapping[str, str] | None = None,
) -> dict[str, str]:
    """The environment of the mystery's nodes: the exercise's `grader_packages`, in the caller's ROS domain.

    Only this machine sees them, unless the caller's `ROS_AUTOMATIC_DISCOVERY_RANGE` says otherwise.
    Builds those packages the first time. Raises as `check_exercise` does.
    """
    environ = os.environ if environ is None else environ
    prepare(ros)
    with workers() as (pool, stop):
        made = pool.submit(reference_packages, exercise, ros, store or Store(), on_progress, stop)
        prefixes = made.result()
    talk = {name: environ[name] for name in TALK if name in environ}
    return {**node_environment(ros, prefixes, environ), **_OWN_MACHINE, **talk}
