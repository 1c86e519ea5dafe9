"""The only module that a grader imports from the engine.

    from course.api import Arena, Failure, Feedback, Grader, Recording, expect_running

Everything that a grader uses from the engine is here. A `Grader` has a scenario, which acts in an `Arena`,
and checks, which judge a `Recording`. Many checks share the `expect_*` functions; other functions find the
cause of a symptom. Code that several graders of one course share, and no other course needs, is in a folder
next to them: `from lib.counts import expect_counting` for `graders/lib/counts.py`.

This module does not need ROS. It is imported before a recording begins, so it must stay quick to import.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from course.arena.arena import Arena
from course.arena.process import Process
from course.content.document import Document, parse_document
from course.errors import ContentError, OurFault
from course.evidence.home_files import HomeFile
from course.evidence.packages import BuiltPackage
from course.evidence.process_view import ProbeAnswer, ProcessView
from course.evidence.recording import Recording
from course.evidence.ros_services import Call, Client, Parameters, Server
from course.evidence.service_view import ServiceCall
from course.evidence.sources import Sources
from course.evidence.stream import Stream
from course.evidence.topic_view import LogLine, Message, TopicView, ask_for, seconds
from course.explain import python_slips as slips
from course.explain.cmake import Command, commands
from course.explain.cmake_errors import not_configured
from course.explain.compiler import CppError, first_error
from course.explain.cpp_code import cpp_files, never_called, places_of, without_effect
from course.explain.cpp_errors import not_made
from course.explain.engine import Cause
from course.explain.languages import timer_places
from course.explain.parameter_causes import named, read_once
from course.explain.python_code import calls, functions, text_places, trees
from course.explain.python_errors import Crash, crash, crash_feedback, learners_file
from course.explain.setup_py import entry_points, misspelled_group, packages_place, read_setup_cfg
from course.grading.author import Grader
from course.grading.expect.endpoints import (
    expect_endpoint,
    expect_node,
    expect_qos,
    expect_type,
)
from course.grading.expect.launches import (
    expect_launch_file,
    expect_launch_interrupt,
    expect_launch_parameter,
    expect_launched,
    expect_launched_node,
    expect_own_launch_parameter,
    launch_file,
)
from course.grading.expect.logs import expect_logged
from course.grading.expect.manifests import expect_build_type, expect_dependency, expect_manifest
from course.grading.expect.native import (
    expect_compiled,
    expect_no_warnings,
    expect_sound,
    native_answer,
)
from course.grading.expect.one_program import about
from course.grading.expect.parameters import expect_declared, expect_parameter, expect_set
from course.grading.expect.periods import expect_period
from course.grading.expect.probes import answered, expect_answer, expect_importable
from course.grading.expect.programs import (
    cause_of_silence,
    expect_clean_end,
    expect_clean_interrupt,
    expect_executable,
    expect_running,
)
from course.grading.expect.services import (
    expect_answers,
    expect_service,
    expect_service_type,
)
from course.grading.expect.shell import BASHRC, complaints, expect_ran, expect_shell
from course.grading.expect.text_files import expect_file, expect_lines, expect_mode, expect_text
from course.grading.mystery import AllOf, Mystery, Number, OneOf, Text
from course.grading.stimulus import words
from course.model import replace
from course.model.feedback import Failure, Feedback, Location, NotApplicable, Spoilt, TooBusy
from course.spelling import listed, nearest

if TYPE_CHECKING:  # it needs ROS
    from course.evidence.recorder import Listener
